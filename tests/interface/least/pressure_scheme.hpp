/// @file
/// The least scheme that pressurises a crack; docs/concepts/pressure_scheme.md explains it.
#pragma once

#include <tuple>

#include <hfdem/state/concepts.hpp>

namespace models {

using namespace hfdem;

/// The same pressure in the whole crack, raised a little in every fluid step.
struct PressureSteps {
  struct Params {
    double rise = 1e6, fluid_dt = 1;
    static constexpr auto fields() {
      return std::tuple{
          Field{"rise", &Params::rise, "Pa", non_negative, "rise of pressure in a fluid step"},
          Field{"fluid_dt", &Params::fluid_dt, "s", positive, "fluid time step"}};
    }
  };
  static constexpr bool holds_fluid = true;

  explicit PressureSteps(const Params& params) : p(params) {}

  double fluid_dt(double /*mechanical_dt*/) const { return p.fluid_dt; }

  template <class Relax>
  FluidStep advance(Network& network, const Injected&, Relax&& relax) {
    FluidStep step;
    pressure += p.rise;
    for (; step.mechanical_steps < 100; ++step.mechanical_steps) {
      for (const Index domain : network.wet_domains()) network.set_pressure(domain, pressure);
      step.unbalanced_ratio = relax().unbalanced_ratio;
    }
    return step;
  }

  void exchange(auto& archive) { archive(pressure); }

  Params p;
  double pressure = 0;
};

}  // namespace models
