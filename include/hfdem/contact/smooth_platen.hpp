/// @file
/// A disc against a rigid, smooth platen: a spring without tension, shear or moment.
#pragma once

#include <hfdem/base/pack.hpp>
#include <hfdem/state/contact.hpp>

namespace hfdem {

class SmoothPlaten {
 public:
  template <class T>
  struct Stiffness {
    T normal;  ///< N/m per m of thickness
  };
  template <class T>
  struct Memory {};
  template <class T>
  struct Response {
    T normal;  ///< N per m, compression positive
    Memory<T> memory;
    Reaction<T> reaction() const { return {normal, T{}, T{}}; }
  };

  /// The platen stands for the other half of a bonded cell, so that its strain is the rock's.
  static Stiffness<double> stiffness(const Springs& contact_with_its_like) noexcept {
    return {2 * contact_with_its_like.normal};
  }

  Springs springs(const Stiffness<double>& k) const noexcept { return {k.normal, 0, 0}; }

  template <class T>
  Response<T> respond(const Stiffness<T>& k, const Memory<T>&,
                      const Motion<T>& motion) const noexcept {
    return {max(T{}, -(k.normal * motion.opening)), {}};
  }
};

}  // namespace hfdem
