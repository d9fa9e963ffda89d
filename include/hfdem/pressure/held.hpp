/// @file
/// A given pressure in the whole crack: slit tests, and hosts that know the pressure themselves.
#pragma once

#include <tuple>

#include <hfdem/base/fields.hpp>
#include <hfdem/state/network.hpp>
#include <hfdem/state/step.hpp>

namespace hfdem {

/// A `PressureScheme`: a fluid step sets the pressure in all wet domains and relaxes until
/// equilibrium, or until a bond breaks. Injection is ignored.
class HeldPressure {
 public:
  /// The pressure, and what counts as equilibrium.
  struct Params {
    double pressure = 0;
    double fluid_dt = 1;
    double unbalanced_tolerance = 1e-6;
    int max_mechanical_steps = 20000;

    static constexpr auto fields() {
      using P = Params;
      return std::tuple{
          Field{"pressure", &P::pressure, "Pa", non_negative, "pressure in the crack"},
          Field{"fluid_dt", &P::fluid_dt, "s", positive, "time that a step counts"},
          Field{"unbalanced_tolerance", &P::unbalanced_tolerance, "", positive,
                "largest resultant on a disc over the mean contact force at equilibrium"},
          Field{"max_mechanical_steps", &P::max_mechanical_steps, "", Range{1},
                "mechanical steps after which a step gives up"}};
    }
  };
  static constexpr bool holds_fluid = true;  ///< needs a crack to press on

  /// @param params validated
  explicit HeldPressure(const Params& params) : params_(params) {}

  /// The time that a step counts, s; it means nothing to the mechanics.
  double fluid_dt(double) const { return params_.fluid_dt; }

  /// Sets the pressure of the steps to come, Pa.
  void hold(double pressure) { params_.pressure = pressure; }

  /// Relaxes at the held pressure; `converged` says that equilibrium was reached.
  template <class Relax>
  FluidStep advance(Network& network, const Injected&, Relax&& relax) {
    FluidStep step{.converged = false};
    while (step.mechanical_steps < params_.max_mechanical_steps) {
      for (const Index d : network.wet_domains()) network.set_pressure(d, params_.pressure);
      const Relaxed relaxed = relax();
      ++step.mechanical_steps;
      step.unbalanced_ratio = relaxed.unbalanced_ratio;
      // At least two, so that the discs have moved with the pressure.
      step.converged =
          step.mechanical_steps > 1 && relaxed.unbalanced_ratio < params_.unbalanced_tolerance;
      if (step.converged || relaxed.breaks > 0) break;
    }
    return step;
  }

  /// The pressure that is held at present.
  void exchange(auto& archive) { archive(params_.pressure); }

 private:
  Params params_;
};

}  // namespace hfdem
