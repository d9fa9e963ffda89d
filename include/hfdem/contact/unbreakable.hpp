/// @file
/// A contact law without strength: what its bonds would carry, were they not to break.
#pragma once

#include <limits>

#include <hfdem/state/concepts.hpp>

namespace hfdem {

/// The same law, except that no bond fails. Slit tests measure stiffness with it at any pressure.
/// @tparam Law a contact law, e.g. `LinearParallelBond`
template <ContactLaw Law>
class Unbreakable : public Law {
 public:
  using Law::Law;

  /// None, under any force.
  template <class T>
  Failure<T> failure(const typename Law::template Stiffness<T>&,
                     const ResponseOf<Law, T>&) const noexcept {
    return Failure<T>{.tension = {}, .shear = {}};
  }

  /// No motion makes one fail (see `ForeseesFailure`).
  template <class T>
  T margin(const typename Law::template Stiffness<T>&, const ResponseOf<Law, T>&) const noexcept {
    return T{} + std::numeric_limits<double>::max();
  }
};

}  // namespace hfdem
