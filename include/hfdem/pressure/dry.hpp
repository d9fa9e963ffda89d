/// @file
/// No fluid: a fluid step is one mechanical step, and time is mechanical time.
#pragma once

#include <tuple>

#include <hfdem/state/network.hpp>
#include <hfdem/state/step.hpp>

namespace hfdem {

/// A `PressureScheme` without fluid.
class Dry {
 public:
  /// None.
  struct Params {
    static constexpr auto fields() { return std::tuple{}; }
  };
  /// A dry specimen needs no crack to inject into.
  static constexpr bool holds_fluid = false;

  /// Nothing to set.
  explicit Dry(const Params&) {}

  /// That of the mechanical step, s.
  double fluid_dt(double mechanical_dt) const { return mechanical_dt; }

  /// One mechanical step.
  template <class Relax>
  FluidStep advance(Network&, const Injected&, Relax&& relax) {
    return {.mechanical_steps = 1, .unbalanced_ratio = relax().unbalanced_ratio};
  }
};

}  // namespace hfdem
