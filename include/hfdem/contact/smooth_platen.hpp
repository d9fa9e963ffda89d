/// @file
/// A disc against a rigid, smooth platen: a spring without tension, shear or moment.
#pragma once

#include <hfdem/base/pack.hpp>
#include <hfdem/state/contact.hpp>

namespace hfdem {

/// A `RespondingLaw` without parameters.
class SmoothPlaten {
 public:
  /// What is fixed per contact.
  template <class T>
  struct Stiffness {
    T normal;  ///< N/m per m of thickness
  };
  /// Nothing evolves.
  template <class T>
  struct Memory {};
  /// The force on the disc.
  template <class T>
  struct Response {
    T normal;          ///< N per m, compression positive
    Memory<T> memory;  ///< empty
    /// The normal force alone.
    Reaction<T> reaction() const { return {normal, T{}, T{}}; }
  };

  /// The platen stands for the other half of a bonded cell, so that its strain is the rock's.
  static Stiffness<double> stiffness(const Springs& contact_with_its_like) noexcept {
    return {2 * contact_with_its_like.normal};
  }

  /// The spring itself.
  Springs springs(const Stiffness<double>& k) const noexcept { return {k.normal, 0, 0}; }

  /// Pushes where the disc has come nearer since bonding, never pulls.
  template <class T>
  Response<T> respond(const Stiffness<T>& k, const Memory<T>&,
                      const Motion<T>& motion) const noexcept {
    return {max(T{}, -(k.normal * motion.opening)), {}};
  }

  /// What the spring stores, J per m.
  template <class T>
  T energy(const Stiffness<T>& k, const Memory<T>&, const Motion<T>& motion) const noexcept {
    const T closing = max(T{}, -motion.opening);
    return 0.5 * (k.normal * (closing * closing));
  }
};

}  // namespace hfdem
