/// @file
/// What one fluid step of the uniform-pressure scheme costs, by the paper's rule and at
/// equilibrium, for small and large specimens and short and long cracks; and what the fluid alone
/// costs: pressure update, loads on the discs, widths and volumes.
///
/// You should see a fluid step cost as much as its mechanical steps, at the same price per contact
/// as without fluid: the fluid alone takes some 30 ns per channel, which for 60 channels among
/// 10 000 discs is 1 % of a mechanical step.
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/base/units.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

#include <benchmark/benchmark.h>

namespace {

using namespace hfdem;
using namespace hfdem::literals;
using Kgd = Simulator<LinearParallelBond, HyperbolicAperture, UniformPressure, FixedPairs>;

/// A crack that has just begun to run: filled by the paper's rule, slowly enough for the pressure
/// not to overshoot, until the first bond breaks.
Kgd running_crack(int side, int contacts) {
  Kgd simulator(square_array(side, side, 5_mm), {.crack = {.contacts = contacts}});
  // The volume of a crack that is about to run, in an infinite plane.
  constexpr double toughness = 1.7e6, modulus = 25.7_GPa;
  const double half_length = contacts * 5_mm;
  const double net_pressure = toughness / std::sqrt(std::numbers::pi * half_length);
  const double volume = 2 * std::numbers::pi * half_length * half_length * net_pressure / modulus;
  constexpr double filling_steps = 50;
  const double rate = simulator.params().injection.rate;
  simulator.inject(volume / (filling_steps * simulator.params().scheme.fluid_dt));
  while (simulator.breaks().empty()) simulator.step();
  simulator.inject(rate);
  return simulator;
}

/// The same, made once for all benchmarks that start from it.
const Kgd& prepared(int side, int contacts) {
  static std::map<std::pair<int, int>, Kgd> made;
  const auto key = std::pair{side, contacts};
  if (!made.contains(key)) made.emplace(key, running_crack(side, contacts));
  return made.at(key);
}

/// Seconds per one of `count`, over the whole benchmark.
benchmark::Counter seconds_per(double count) {
  return {count, benchmark::Counter::kIsRate | benchmark::Counter::kInvert};
}

/// Arguments: discs per side, broken contacts of the preset crack, rule (0: the paper's, 1:
/// equilibrium).
void fluid_step(benchmark::State& state) {
  Kgd simulator = prepared(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  simulator.pressure_scheme() = UniformPressure({.equilibrium = state.range(2) == 1});
  for (int k = 0; k < 10; ++k) simulator.step();

  const long before = simulator.mechanical_steps();
  for (auto _ : state) simulator.step();
  const auto mechanical = static_cast<double>(simulator.mechanical_steps() - before);
  const auto fluid = static_cast<double>(state.iterations());
  const auto discs = static_cast<double>(simulator.discs().size());
  const auto contacts = static_cast<double>(simulator.contacts().size());
  const auto channels = static_cast<double>(simulator.network().wet_channels().size());
  state.counters["discs"] = discs;
  state.counters["channels"] = channels;
  state.counters["pressure_MPa"] = simulator.injection_pressure() / 1_MPa;
  state.counters["mechanical_steps"] = mechanical / fluid;
  state.counters["s_per_disc"] = seconds_per(fluid * discs);
  state.counters["s_per_contact"] = seconds_per(fluid * contacts);
  state.counters["s_per_channel"] = seconds_per(fluid * channels);
  state.counters["s_per_contact_and_mechanical_step"] = seconds_per(mechanical * contacts);
}

/// The fluid's share of the mechanical steps: the discs do not move, only what the simulator does
/// for the fluid is done. Arguments: discs per side, broken contacts of the preset crack.
void fluid_alone(benchmark::State& state) {
  const Kgd& simulator =
      prepared(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  const auto& rock = simulator.contacts();
  const auto& displacement = simulator.discs().displacement;
  const HyperbolicAperture aperture(simulator.params().aperture);
  UniformPressure scheme(simulator.params().scheme);
  Network network = simulator.network();
  std::vector<Vec2> load(simulator.discs().size());
  double steps = 0;
  const auto relax = [&]() -> Relaxed {
    for (const Index i : network.pushed_discs()) load[i] = network.force_on(i);
    for (const Index c : network.wet_channels()) {
      const double compression = rock.response(c, displacement).reaction().normal;
      const double opening = rock.motion(c, displacement).opening;
      network.set_width(c, aperture.width(network.rest_width(c), max(0.0, compression), opening));
    }
    ++steps;
    return {.unbalanced_ratio = 1, .breaks = 0};
  };
  // Twice the volume never fits into a crack that does not move: every step is of full length.
  const Injected injected{.total = 2 * simulator.injected_volume(), .step = 0, .dt = 0};
  for (auto _ : state) {
    benchmark::DoNotOptimize(scheme.advance(network, injected, relax));
    benchmark::ClobberMemory();
  }
  const auto channels = static_cast<double>(network.wet_channels().size());
  state.counters["channels"] = channels;
  state.counters["mechanical_steps"] = steps / static_cast<double>(state.iterations());
  state.counters["s_per_mechanical_step"] = seconds_per(steps);
  state.counters["s_per_channel_and_mechanical_step"] = seconds_per(steps * channels);
}

/// Small, default and large specimens, with cracks that leave room to run.
void step_arguments(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"side", "crack", "equilibrium"});
  for (const std::int64_t side : {40, 100, 160})
    for (const std::int64_t crack : {4, 20, 60})
      for (const std::int64_t equilibrium : {0, 1})
        if (3 * crack < 2 * side) benchmark->Args({side, crack, equilibrium});
}

void fluid_arguments(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"side", "crack"})->Args({40, 4});
  for (const std::int64_t crack : {4, 20, 60}) benchmark->Args({100, crack});
}

}  // namespace

BENCHMARK(fluid_step)->Apply(step_arguments)->Iterations(60)->Unit(benchmark::kMicrosecond);
BENCHMARK(fluid_alone)->Apply(fluid_arguments)->MinTime(0.1)->Unit(benchmark::kMicrosecond);
BENCHMARK_MAIN();
