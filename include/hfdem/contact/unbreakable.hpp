/// @file
/// A contact law without strength: what its bonds would carry, were they not to break.
#pragma once

#include <hfdem/state/concepts.hpp>

namespace hfdem {

/// The same law, except that no bond fails. Slit tests measure stiffness with it at any pressure.
/// @tparam Law a contact law, e.g. `LinearParallelBond`
template <ContactLaw Law>
class Unbreakable : public Law {
 public:
  using Law::Law;

  /// None, under any force.
  template <class T, class Response>
  Failure<T> failure(const typename Law::template Stiffness<T>&, const Response&) const noexcept {
    return Failure<T>{.tension = {}, .shear = {}};
  }
};

}  // namespace hfdem
