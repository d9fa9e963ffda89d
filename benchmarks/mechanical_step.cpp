/// @file
/// The whole mechanical step: contact loop, gather, motion and platens, without fluid. One thread
/// and two take turns, so that their ratio means something on a machine with other work.
///
/// You should see the cost per contact stay nearly the same while the data fit into the caches, and
/// two threads 1.5 to 1.9 times as fast as one where both have a core to themselves. With fewer
/// idle cores than threads the threads wait for one another: try OMP_WAIT_POLICY=passive.
#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/base/units.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/pressure/dry.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

#include <benchmark/benchmark.h>

#include "side_by_side.hpp"

namespace {

using namespace hfdem;
using namespace hfdem::literals;
using Specimens = Simulator<LinearParallelBond, HyperbolicAperture, Dry, FixedPairs>;

/// @param state argument: discs per side of a square array
void mechanical_step(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  Specimens simulator(square_array(side, side, 5_mm), {});
  constexpr int steps = 10;
  const auto run = [&](int threads) {
    simulator.use_threads(threads);
    for (int k = 0; k < steps; ++k) simulator.step();
  };
  SideBySide times;
  for (auto _ : state) {
    times.pair([&] { run(1); }, [&] { run(2); });
    state.SetIterationTime(times.last_a());
  }
  const auto discs = static_cast<double>(simulator.discs().size());
  const auto contacts = static_cast<double>(simulator.contacts().size());
  const double to_ns_per_contact = 1e9 / (steps * contacts);
  state.counters["discs"] = discs;
  state.counters["contacts"] = contacts;
  state.counters["particle_steps_per_s"] = discs * steps / times.a();
  state.counters["particle_steps_per_s_2_threads"] = discs * steps / times.b();
  state.counters["ns_per_contact_step"] = times.a() * to_ns_per_contact;
  state.counters["ns_per_contact_step_2_threads"] = times.b() * to_ns_per_contact;
  state.counters["ns_per_contact_step_at_best"] = times.best_a() * to_ns_per_contact;
  state.counters["ns_per_contact_step_at_best_2_threads"] = times.best_b() * to_ns_per_contact;
  state.counters["speedup_by_2_threads"] = times.a_over_b();
}

}  // namespace

BENCHMARK(mechanical_step)
    ->ArgName("side")
    ->Arg(50)
    ->Arg(100)
    ->Arg(200)
    ->UseManualTime()
    ->Iterations(40)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
