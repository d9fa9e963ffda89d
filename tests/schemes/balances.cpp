// The books of a run: volumes, widths, steps and breaks.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "near.hpp"
#include "schemes/small_array.hpp"

namespace {

using hfdem::FluidStep;
using hfdem::Index;
using hfdem::Pack;
using test::Injected;
using test::near;

constexpr double rate = 2e-4;

/// The volume that the crack has opened, from the motion of the discs alone: on a square array a
/// channel is 2 R long, and a broken contact is a spring E without tension.
double opened_volume(const Injected& sim) {
  const auto& params = sim.params();
  double volume = 0;
  for (const Index c : sim.network().wet_channels()) {
    const auto [first, second] = sim.contacts().bodies(c);
    const std::size_t lane = second == first + 1 ? 0 : 1;  // side by side, or one above the other
    const double opening =
        sim.discs().displacement[second][lane] - sim.discs().displacement[first][lane];
    const double force = -params.contact.E * opening;
    const double w0 = params.aperture.w0, F0 = params.aperture.F0;
    const double width = force > 0 ? w0 * F0 / (force + F0) : w0 + opening;
    volume += 2 * test::radius * (width - w0);
  }
  return volume;
}

Injected breaking_array(bool equilibrium) {
  return {test::square(20), {.injection = {.rate = rate}, .scheme = {.equilibrium = equilibrium}}};
}

}  // namespace

TEST_CASE("the injected volume is the rate times the time, however the rate changes") {
  Injected sim(test::square(10), {.injection = {.rate = rate}});
  for (int n = 0; n < 8; ++n) sim.step();
  CHECK(sim.fluid_steps() == 8);
  CHECK(sim.time() == near(8e-4));
  CHECK(sim.injected_volume() == near(8e-4 * rate));
  sim.inject(3 * rate);
  for (int n = 0; n < 4; ++n) sim.step();
  CHECK(sim.injected_volume() == near(8e-4 * rate + 4e-4 * 3 * rate));
}

TEST_CASE("the crack's volume is that of its displacements") {
  for (const bool equilibrium : {false, true}) {
    Injected sim = breaking_array(equilibrium);
    for (int n = 0; n < 100; ++n) {  // pressed shut at first, open and longer at the end
      sim.step();
      CHECK(sim.network().crack_volume() ==
            near(opened_volume(sim), 1e-10).scale(sim.network().rest_volume()));
    }
    CHECK(sim.breaks().size() > 0);
  }
}

TEST_CASE("after a converged step the crack holds what was injected, within the tolerance") {
  for (const bool equilibrium : {false, true}) {
    CAPTURE(equilibrium);
    Injected sim = breaking_array(equilibrium);
    int converged = 0;
    for (int n = 0; n < 100; ++n) {
      const FluidStep step = sim.step();
      const double missing = std::abs(sim.injected_volume() - sim.network().crack_volume());
      CHECK(step.volume_error == near(missing / sim.injected_volume(), 1e-9));
      if (!step.converged) continue;
      ++converged;
      CHECK(missing <= (equilibrium ? 1e-3 : 1e-2) * sim.injected_volume());
      if (equilibrium) CHECK(step.unbalanced_ratio < 1e-3);
    }
    CHECK(converged > 4);
  }
}

TEST_CASE("the mechanical steps that the fluid steps tell add up, and none is without") {
  Injected sim = breaking_array(false);
  long told = sim.mechanical_steps();
  CHECK(told == 0);
  CHECK(sim.settling_steps() > 0);
  for (int n = 0; n < 60; ++n) {
    const FluidStep step = sim.step();
    CHECK(step.mechanical_steps >= 1);
    CHECK(step.mechanical_steps <= 10);
    told += step.mechanical_steps;
    CHECK(sim.mechanical_steps() == told);
  }
}

TEST_CASE("each break is booked once, with its time, pressure and channel") {
  Injected sim = breaking_array(false);
  std::vector<bool> seen(sim.contacts().size(), false);
  std::size_t booked = 0;
  while (booked < 6) {
    const double before = sim.injection_pressure();
    sim.step();
    for (; booked < sim.breaks().size(); ++booked) {
      const hfdem::BondBreak& b = sim.breaks()[booked];
      CHECK_FALSE(seen[b.contact]);
      seen[b.contact] = true;
      CHECK(b.time == sim.time());
      CHECK(b.mode == hfdem::Mode::tension);
      CHECK(std::abs(b.pressure - before) <= 10 * 0.2e6);  // ten steps of at most the cap
      CHECK(b.pressure > 10e6);                            // what holds the crack shut
      CHECK(sim.contacts().stiffness(b.contact).bond == 0);
      CHECK(sim.network().is_open(b.contact));
      CHECK(std::count(sim.preset_contacts().begin(), sim.preset_contacts().end(), b.contact) == 0);
    }
  }
}

TEST_CASE("the discs beside the crack feel its pressure") {
  Injected sim = breaking_array(false);
  for (int n = 0; n < 10; ++n) sim.step();
  // The middle of the slit, between (9, 10) and (10, 10): two chords' worth of pressure.
  for (const auto& [disc, side] : {std::pair{10 * 20 + 9, -1.0}, std::pair{10 * 20 + 10, 1.0}}) {
    const hfdem::Vec2 load = sim.discs().load[static_cast<std::size_t>(disc)];
    CHECK(load.x == near(side * 2 * test::radius * sim.injection_pressure()));
    CHECK(load.y == 0);
  }
}
