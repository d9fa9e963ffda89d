/// @file
/// What joints cost in the mechanical step of a random specimen: the law without joints, the same
/// specimen with the law that could have some, and with 18 natural fractures, in turns.
///
/// You should see that a wholly bonded specimen pays nothing for the law's joints (a ratio of 1 to
/// a per cent or two), and that 18 fractures cost less than 5 %.
#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/contact/jointed.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/neighbours/cell_grid.hpp>
#include <hfdem/pressure/dry.hpp>
#include <hfdem/setup/joints.hpp>
#include <hfdem/setup/random_fractures.hpp>
#include <hfdem/setup/random_packing.hpp>
#include <hfdem/simulator.hpp>

#include <benchmark/benchmark.h>

#include "side_by_side.hpp"

namespace {

using namespace hfdem;
template <class Contact>
using Rock = Simulator<Contact, HyperbolicAperture, Dry, CellGrid>;
using Bonded = Rock<LinearParallelBond>;
using Fractured = Rock<Jointed<LinearParallelBond, SmoothJoint>>;

constexpr int steps = 10;

template <class Sim>
auto mechanical_steps(Sim& sim) {
  return [&sim] {
    for (int k = 0; k < steps; ++k) sim.step();
  };
}

/// @param state arguments: discs, and whether the second specimen has fractures
void joints(benchmark::State& state) {
  const RandomPacking packing{.grains = static_cast<int>(state.range(0))};
  const Specimen rock = random_packing(packing, 1);
  Specimen with_joints = rock;
  if (state.range(1) != 0)
    insert_joints(with_joints, random_fractures({}, packing.width, packing.height));
  const Mechanics mechanics{.settle_tolerance = 1e-2};
  Bonded bonded(rock, {.crack = {.contacts = 0}, .mechanics = mechanics});
  Fractured fractured(with_joints, {.crack = {.contacts = 0}, .mechanics = mechanics});
  SideBySide times;
  for (auto _ : state) {
    times.pair(mechanical_steps(fractured), mechanical_steps(bonded));
    state.SetIterationTime(times.last_a());
  }
  state.counters["discs"] = static_cast<double>(rock.size());
  state.counters["contacts"] = static_cast<double>(bonded.contacts().size());
  state.counters["joints"] = static_cast<double>(fractured.joints().size());
  state.counters["bonded_joints"] = static_cast<double>(fractured.joints().bonded());
  state.counters["ns_per_contact_step"] =
      1e9 * times.b() / (steps * static_cast<double>(bonded.contacts().size()));
  state.counters["time_over_that_without"] = times.a_over_b();
}

}  // namespace

BENCHMARK(joints)
    ->ArgNames({"discs", "fractured"})
    ->Args({17511, 0})
    ->Args({17511, 1})
    ->UseManualTime()
    ->Iterations(200)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_MAIN();
