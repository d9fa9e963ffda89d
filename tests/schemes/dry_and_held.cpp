// The schemes without an injected volume: no fluid at all, and a given pressure.
#include <hfdem/pressure/dry.hpp>
#include <hfdem/pressure/held.hpp>

#include <doctest/doctest.h>

#include "near.hpp"
#include "schemes/mock_crack.hpp"
#include "schemes/small_array.hpp"

namespace {

using hfdem::FluidStep;
using hfdem::HeldPressure;
using test::MockCrack;
using test::near;

}  // namespace

TEST_CASE("a dry step is one mechanical step, and leaves the network alone") {
  hfdem::Dry scheme({});
  MockCrack crack{.unbalanced_ratio = 0.25};
  const FluidStep step = scheme.advance(crack.network, {}, [&] { return crack.relax(); });
  CHECK(step.mechanical_steps == 1);
  CHECK(step.unbalanced_ratio == 0.25);
  CHECK(crack.pressures == std::vector<double>{0});
  CHECK(scheme.fluid_dt(2.5e-6) == 2.5e-6);
}

TEST_CASE("dry time is mechanical time") {
  test::SquareRock<hfdem::Dry> sim(test::square(4), {.crack = {.contacts = 0}});
  const long settled = sim.mechanical_steps();
  for (int n = 0; n < 7; ++n) sim.step();
  CHECK(sim.mechanical_steps() == settled + 7);
  CHECK(sim.time() == near(7 * sim.mechanical_dt()));
}

TEST_CASE("a held pressure acts in every wet domain until the forces balance") {
  HeldPressure scheme({.pressure = 3e6, .fluid_dt = 0.5, .unbalanced_tolerance = 1e-2});
  CHECK(scheme.fluid_dt(1e-6) == 0.5);
  MockCrack crack{.unbalanced_ratio = 1};
  crack.on_relax = [&] {
    for (const hfdem::Index d : crack.network.wet_domains())
      CHECK(crack.network.pressure(d) == 3e6);
    if (crack.steps() == 12) crack.unbalanced_ratio = 0.9e-2;
  };
  const FluidStep step = scheme.advance(crack.network, {}, [&] { return crack.relax(); });
  CHECK(step.converged);
  CHECK(step.mechanical_steps == 12);
  CHECK(step.unbalanced_ratio == 0.9e-2);

  scheme.hold(4e6);
  crack.on_relax = [] {};
  scheme.advance(crack.network, {}, [&] { return crack.relax(); });
  CHECK(crack.pressures.back() == 4e6);
}

TEST_CASE("a balance at the first mechanical step is not believed") {
  HeldPressure scheme({.pressure = 3e6});
  MockCrack crack{.unbalanced_ratio = 0};
  CHECK(scheme.advance(crack.network, {}, [&] { return crack.relax(); }).mechanical_steps == 2);
}

TEST_CASE("a held pressure stops at a break, and gives up after the last step allowed") {
  HeldPressure scheme({.pressure = 3e6, .max_mechanical_steps = 30});
  MockCrack crack{.unbalanced_ratio = 1};
  const FluidStep broke = scheme.advance(crack.network, {}, [&] {
    crack.relax();
    return hfdem::Relaxed{.unbalanced_ratio = 1, .breaks = crack.steps() == 5 ? 2 : 0};
  });
  CHECK(broke.mechanical_steps == 5);
  CHECK_FALSE(broke.converged);
  const FluidStep tired = scheme.advance(crack.network, {}, [&] { return crack.relax(); });
  CHECK(tired.mechanical_steps == 30);
  CHECK_FALSE(tired.converged);
}

TEST_CASE("a settled slit carries the pressure that it is told to hold") {
  test::SquareRock<HeldPressure> sim(test::square(10), {.scheme = {.pressure = 11e6}});
  CHECK(sim.step().converged);
  CHECK(sim.injection_pressure() == 11e6);
  sim.pressure_scheme().hold(12e6);
  CHECK(sim.step().converged);
  CHECK(sim.injection_pressure() == 12e6);
  CHECK(sim.time() == near(2));
}
