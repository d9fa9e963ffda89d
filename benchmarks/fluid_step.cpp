/// @file
/// What one fluid step costs: of each pressure scheme on its own, in cracks of 1e2 to 1e5 domains
/// whose walls do not move, for three viscosities; of the uniform scheme with the mechanics that it
/// asks for; and how long each scheme takes to carry the square array to the same injected volume.
///
///   build/release/benchmarks/fluid_step                          all but the race
///   build/release/benchmarks/fluid_step --race                   all three schemes, to 0.9 s
///
/// You should see the fluid alone cost some 10 to 100 ns per domain, little beside the mechanical
/// steps; and in the race uniform pressure ahead, implicit flow not far behind at any
/// viscosity, and explicit flow far behind where the viscosity is low.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/base/units.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/pressure/conventional.hpp>
#include <hfdem/pressure/implicit.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

#include <benchmark/benchmark.h>

#include "flow_network.hpp"
#include "scheme_race.hpp"

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

/// A scheme, ready to flow where the walls do not move.
template <class Scheme>
Scheme made(double viscosity) {
  const RockResponse rigid{.modulus = std::numeric_limits<double>::infinity(), .wave_step = 1};
  if constexpr (std::is_same_v<Scheme, UniformPressure>)
    return Scheme({.max_mechanical_steps = 1});
  else if constexpr (std::is_same_v<Scheme, ImplicitFlow<>>)
    return Scheme({.max_mechanical_steps = 1}, NewtonianFluid({.viscosity = viscosity}), rigid);
  else
    return Scheme({.sub_cycling = false}, NewtonianFluid({.viscosity = viscosity}), rigid);
}

/// One fluid step with one call for mechanics, which does nothing. Arguments: domains, viscosity in
/// micropascal seconds.
template <class Scheme>
void fluid_alone(benchmark::State& state) {
  Network network = benchmark_support::flow_network(static_cast<int>(state.range(0)), 5_mm, 50e-6);
  const auto domains = static_cast<double>(network.wet_domains().size());
  auto scheme = made<Scheme>(1e-6 * static_cast<double>(state.range(1)));
  const auto relax = []() -> Relaxed { return {.unbalanced_ratio = 0, .breaks = 0}; };
  double time = 0, injected = 0;
  const auto step = [&] {
    const double dt = scheme.fluid_dt(1e-6), volume = 0.5e-4 * dt;
    time += dt;
    injected += volume;
    benchmark::DoNotOptimize(scheme.advance(network, Injected{injected, volume, dt}, relax));
    benchmark::ClobberMemory();
  };
  step();  // only then a scheme knows its limit
  time = 0;
  for (auto _ : state) step();
  state.counters["domains"] = domains;
  state.counters["fluid_dt_us"] = 1e6 * time / static_cast<double>(state.iterations());
  state.counters["s_per_step"] = seconds_per(static_cast<double>(state.iterations()));
  state.counters["s_per_domain"] = seconds_per(domains * static_cast<double>(state.iterations()));
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
  benchmark->ArgNames({"domains", "viscosity_uPas"});
  for (const std::int64_t domains : {100, 1000, 9999, 100000})
    for (const std::int64_t viscosity : {60, 1000, 100000}) benchmark->Args({domains, viscosity});
}

}  // namespace

BENCHMARK(fluid_alone<UniformPressure>)->Apply(fluid_arguments)->MinTime(0.05);
BENCHMARK(fluid_alone<ImplicitFlow<>>)->Apply(fluid_arguments)->MinTime(0.05);
BENCHMARK(fluid_alone<ConventionalFlow<>>)->Apply(fluid_arguments)->MinTime(0.05);
BENCHMARK(fluid_step)->Apply(step_arguments)->Iterations(60)->Unit(benchmark::kMicrosecond);

int main(int argc, char** argv) {
  double race = 0;
  // `--race` or `--race=0.1`: to that injection time, s.
  const auto is_race = [&](const std::string& argument) {
    if (argument.rfind("--race", 0) != 0) return false;
    race = argument.size() > 7 ? std::stod(argument.substr(7)) : 0.9;
    return true;
  };
  argc = static_cast<int>(std::remove_if(argv + 1, argv + argc, is_race) - argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  if (race > 0) benchmark_support::SchemeRace(race).run();
}
