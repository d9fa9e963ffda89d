/// @file
/// How long each pressure scheme takes to carry the square array to the same injected volume, in
/// one run, one thread.
#pragma once

#include <cstdio>
#include <string>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/base/units.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/measure/crack.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/pressure/conventional.hpp>
#include <hfdem/pressure/implicit.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

#include "side_by_side.hpp"

namespace hfdem::benchmark_support {

/// Prints one line per scheme and viscosity.
class SchemeRace {
 public:
  /// @param end injection time of every run, s
  explicit SchemeRace(double end) : end_(end) {}

  void run() {
    std::printf(
        "\n100 x 100 discs to %.3g s of injection, one thread. Explicit one-to-one, a mechanical "
        "step for each step of the flow, is extrapolated: the sub-cycled run's number of steps of "
        "the flow, times the mean cost of its own first %ld steps. The net injection pressure "
        "before breaks is a mean over the second half of the run.\n\n",
        end_, tried_steps);
    std::printf(
        "| viscosity | scheme | wall s | over uniform, paper's rule | over uniform, equilibrium | "
        "mechanical steps | length m | aperture um | net MPa before breaks |\n"
        "|---|---|---|---|---|---|---|---|---|\n");
    paper_ = line<UniformPressure>("none", "uniform, paper's rule", {});
    equilibrium_ = line<UniformPressure>("none", "uniform, equilibrium", {.equilibrium = true});
    for (const double viscosity : {6e-5, 1e-3, 0.1}) {
      char said[32];
      std::snprintf(said, sizeof said, "%.3g cp", viscosity * 1e3);
      const NewtonianFluid::Params fluid{.viscosity = viscosity};
      line<ImplicitFlow<>>(said, "implicit, steps of 0.1 ms", {}, fluid);
      line<ImplicitFlow<>>(said, "implicit, steps of 1 ms", {.fluid_dt = 1e-3}, fluid);
      line<ConventionalFlow<>>(said, "explicit, sub-cycled", {}, fluid);
      one_to_one(said, fluid);
    }
  }

 private:
  template <class Pressure>
  using Sim = Simulator<LinearParallelBond, HyperbolicAperture, Pressure, FixedPairs>;

  /// @returns wall time, s
  template <class Pressure>
  double line(const std::string& fluid, const std::string& scheme,
              const typename Pressure::Params& params, const NewtonianFluid::Params& law = {}) {
    Sim<Pressure> sim(square_array(100, 100, 5_mm), {.fluid = law, .scheme = params});
    struct Counter {
      long flow_steps = 0;
      void fluid_step(const Sim<Pressure>&, const FluidStep& step) {
        flow_steps += step.flow_steps;
      }
    } counter;
    const double wall = seconds([&] { sim.run_until(end_, counter); });
    flow_steps_ = counter.flow_steps;
    const auto shape = measure::crack_shape(sim);
    row(fluid, scheme, wall);
    std::printf(" %ld | %.3f | %.1f | %.3f |\n", sim.mechanical_steps(), shape.full_length(),
                shape.aperture * 1e6, net_pressure_before_breaks(sim) / 1e6);
    std::fflush(stdout);
    return wall;
  }

  /// Mean over the second half of the run, Pa.
  template <class Pressure>
  static double net_pressure_before_breaks(const Sim<Pressure>& sim) {
    double sum = 0;
    int count = 0;
    for (const auto& b : sim.breaks())
      if (b.time > 0.5 * sim.time()) sum += b.pressure - sim.params().in_situ.xx, ++count;
    return count > 0 ? sum / count : 0;
  }

  /// After the sub-cycled line.
  void one_to_one(const std::string& fluid, const NewtonianFluid::Params& law) {
    Sim<ConventionalFlow<>> sim(square_array(100, 100, 5_mm),
                                {.fluid = law, .scheme = {.sub_cycling = false}});
    const double wall = seconds([&] {
      while (sim.mechanical_steps() < tried_steps) sim.step();
    });
    const double steps = static_cast<double>(flow_steps_);
    row(fluid, "explicit, one-to-one (extrapolated)",
        wall * steps / static_cast<double>(tried_steps));
    std::printf(" %.3g | | | |\n", steps);
    std::fflush(stdout);
  }

  void row(const std::string& fluid, const std::string& scheme, double wall) const {
    std::printf("| %s | %s | %.4g | %s | %s |", fluid.c_str(), scheme.c_str(), wall,
                ratio(wall, paper_).c_str(), ratio(wall, equilibrium_).c_str());
  }
  /// Nothing where the reference has yet to be run.
  static std::string ratio(double wall, double reference) {
    if (reference == 0) return "";
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", wall / reference);
    return text;
  }

  static constexpr long tried_steps = 5000;
  double end_;
  double paper_ = 0, equilibrium_ = 0;  // wall times, s
  long flow_steps_ = 0;                 // of the last line
};

}  // namespace hfdem::benchmark_support
