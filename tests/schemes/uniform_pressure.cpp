// The uniform-pressure algorithm on a crack without mechanics.
#include <hfdem/pressure/uniform.hpp>

#include <doctest/doctest.h>

#include "near.hpp"
#include "schemes/mock_crack.hpp"

namespace {

using hfdem::FluidStep;
using hfdem::UniformPressure;
using test::MockCrack;
using test::near;

FluidStep advance(UniformPressure& scheme, MockCrack& crack, double volume) {
  return scheme.advance(crack.network, {volume, volume, 1e-4}, [&] { return crack.relax(); });
}

/// A step with a volume tolerance that is never met and no cap.
FluidStep advance_steps(MockCrack& crack, double volume, int steps, double alpha) {
  UniformPressure scheme({.alpha = alpha,
                          .max_pressure_step = 1e12,
                          .max_mechanical_steps = steps,
                          .volume_tolerance = 1e-15});
  return advance(scheme, crack, volume);
}

}  // namespace

TEST_CASE("each mechanical step raises the pressure by alpha times the relative volume missing") {
  constexpr double alpha = 3e5, volume = 5e-6;
  MockCrack crack;
  const FluidStep step = advance_steps(crack, volume, 6, alpha);
  REQUIRE(crack.steps() == 6);
  double pressure = 0, crack_volume = 0;
  for (const double told : crack.pressures) {
    pressure += alpha * (volume - crack_volume) / (MockCrack::rest_volume + crack_volume);
    CHECK(told == near(pressure));
    crack_volume = crack.volume(pressure);
  }
  CHECK(step.mechanical_steps == 6);
  CHECK_FALSE(step.converged);
  CHECK(step.volume_error == near((volume - crack_volume) / volume));
}

TEST_CASE("a crack that is pressed shut counts with the volume it would have at rest") {
  constexpr double alpha = 1e5, volume = 5e-6;
  MockCrack crack{.width_at_rest = MockCrack::w0 / 4, .compliance = 0};
  crack.relax();  // shuts it
  advance_steps(crack, volume, 1, alpha);
  const double missing = volume + 0.75 * MockCrack::rest_volume;
  CHECK(crack.pressures.back() == near(alpha * missing / MockCrack::rest_volume));
}

TEST_CASE("the pressure changes by no more than the cap, up or down, and never falls below zero") {
  UniformPressure scheme({.alpha = 1e12,
                          .max_pressure_step = 2e5,
                          .max_mechanical_steps = 3,
                          .volume_tolerance = 1e-15});
  MockCrack crack{.compliance = 0};  // takes no volume
  advance(scheme, crack, 1e-5);
  CHECK(crack.pressures == std::vector<double>{2e5, 4e5, 6e5});

  crack.width_at_rest = 2 * MockCrack::w0;  // holds more than was injected
  crack.relax();
  crack.pressures.clear();
  advance(scheme, crack, 1e-9);
  advance(scheme, crack, 1e-9);
  CHECK(crack.pressures == std::vector<double>{4e5, 2e5, 0, 0, 0, 0});
}

TEST_CASE("the paper's rule stops at one per cent of the volume, or after ten steps") {
  UniformPressure scheme({.alpha = 4e6, .max_pressure_step = 1e12});
  SUBCASE("ten steps") {
    MockCrack crack{.compliance = 0};
    const FluidStep step = advance(scheme, crack, 1e-5);
    CHECK(step.mechanical_steps == 10);
    CHECK(crack.steps() == 10);
    CHECK_FALSE(step.converged);
    CHECK(step.volume_error == near(1));
  }
  SUBCASE("one per cent, of however unbalanced forces") {
    constexpr double volume = 1e-5;
    MockCrack crack{.unbalanced_ratio = 9};
    const FluidStep step = advance(scheme, crack, volume);
    CHECK(step.converged);
    CHECK(step.mechanical_steps < 10);
    CHECK(step.volume_error <= 0.01);
    CHECK(step.unbalanced_ratio == 9);
    REQUIRE(crack.steps() > 1);  // and not one step earlier
    const double before = crack.volume(crack.pressures[crack.steps() - 2]);
    CHECK(volume - before > 0.01 * volume);
  }
  SUBCASE("one step at least") {
    constexpr double volume = 1e-5;
    MockCrack crack;
    crack.network.set_pressure(crack.network.injection_domain(),
                               volume / (2 * MockCrack::length * crack.compliance));
    crack.relax();
    crack.pressures.clear();
    CHECK(advance(scheme, crack, volume).converged);
    CHECK(crack.steps() == 1);
  }
}

TEST_CASE("at equilibrium both volume and forces must be balanced") {
  UniformPressure scheme({.alpha = 1e6, .max_pressure_step = 1e12, .equilibrium = true});
  constexpr double volume = 1e-5;
  SUBCASE("forces last") {
    MockCrack crack{.unbalanced_ratio = 1};
    crack.on_relax = [&] {
      if (crack.steps() == 200) crack.unbalanced_ratio = 0.9e-3;
    };
    const FluidStep step = advance(scheme, crack, volume);
    CHECK(step.converged);
    CHECK(step.mechanical_steps == 200);
    CHECK(step.unbalanced_ratio == 0.9e-3);
  }
  SUBCASE("volume last") {
    MockCrack crack;
    const FluidStep step = advance(scheme, crack, volume);
    CHECK(step.converged);
    CHECK(step.volume_error <= 1e-3);
    const double before = crack.volume(crack.pressures[crack.steps() - 2]);
    CHECK(volume - before > 1e-3 * volume);
  }
  SUBCASE("neither: a thousand steps") {
    MockCrack crack{.unbalanced_ratio = 1.1e-3};
    const FluidStep step = advance(scheme, crack, volume);
    CHECK_FALSE(step.converged);
    CHECK(step.mechanical_steps == 1000);
    CHECK(step.volume_error <= 1e-3);
  }
}

TEST_CASE(
    "a half empty crack is at equilibrium once its forces are, by the rule of equilibrium alone") {
  constexpr double volume = 1e-6;
  for (const bool equilibrium : {true, false}) {
    CAPTURE(equilibrium);
    // It holds more than was injected even without pressure.
    MockCrack crack{.width_at_rest = 1.5 * MockCrack::w0, .unbalanced_ratio = 1};
    UniformPressure scheme({.equilibrium = equilibrium});
    crack.on_relax = [&] {
      if (crack.steps() == 5) crack.unbalanced_ratio = 0.9e-3;
    };
    const FluidStep step = advance(scheme, crack, volume);
    CHECK(step.converged == equilibrium);
    CHECK(step.mechanical_steps == (equilibrium ? 5 : 10));
    CHECK(crack.network.pressure(crack.network.injection_domain()) == 0);
    CHECK(step.volume_error > 1);

    // What a pressure of more than nothing could still even out is no equilibrium.
    MockCrack pressed{.width_at_rest = 1.5 * MockCrack::w0, .compliance = 0};
    pressed.network.set_pressure(pressed.network.injection_domain(), 1e7);
    UniformPressure slow({.alpha = 1e3, .equilibrium = equilibrium, .max_mechanical_steps = 3});
    CHECK_FALSE(advance(slow, pressed, volume).converged);
  }
}

TEST_CASE("what one step leaves unmet, the next one makes up for") {
  UniformPressure scheme({.alpha = 2e5, .max_pressure_step = 1e12});
  constexpr double volume = 1e-5;
  MockCrack crack;
  const FluidStep first = advance(scheme, crack, volume);
  REQUIRE_FALSE(first.converged);
  const FluidStep second = advance(scheme, crack, volume);
  CHECK(second.volume_error < first.volume_error);
  CHECK(crack.pressures[10] > crack.pressures[9]);
  const double left = volume - crack.volume(crack.pressures[9]);
  CHECK(crack.pressures[10] - crack.pressures[9] ==
        near(2e5 * left / (MockCrack::rest_volume + crack.volume(crack.pressures[9])), 1e-9));
}

TEST_CASE("a crack that opens far more than was injected stops the run, at once or in time") {
  constexpr double volume = 1e-5;
  // Fluid steps until the run stops; 0 if it does not.
  const auto steps_to_stop = [&](double opened) {
    UniformPressure scheme({});
    MockCrack crack{.compliance = 0};
    crack.width_at_rest = MockCrack::w0 * (1 + opened / MockCrack::rest_volume);
    for (int step = 1; step <= 30; ++step) {
      try {
        advance(scheme, crack, volume);
      } catch (const hfdem::RunStopped&) {
        return step;
      }
    }
    return 0;
  };
  // Twice the injected volume, and the volume at rest on top: the pressure has ten steps for it.
  constexpr double much = 2 * volume + MockCrack::rest_volume;
  CHECK(steps_to_stop(0.999 * much) == 0);
  CHECK(steps_to_stop(1.001 * much) == 11);
  // Ten times the volume: no pressure catches that.
  constexpr double far_too_much = 10 * volume + MockCrack::rest_volume;
  CHECK(steps_to_stop(0.999 * far_too_much) == 11);
  CHECK(steps_to_stop(1.001 * far_too_much) == 1);
}

TEST_CASE("one pressure fills all wet domains at every mechanical step, new ones included") {
  UniformPressure scheme({.alpha = 1e5});
  MockCrack crack;
  std::vector<std::size_t> wet;
  crack.on_relax = [&] {
    const double pressure = crack.network.pressure(crack.network.injection_domain());
    for (const hfdem::Index d : crack.network.wet_domains())
      CHECK(crack.network.pressure(d) == pressure);
    wet.push_back(crack.network.wet_domains().size());
    if (crack.steps() == 4) crack.grow();
  };
  advance(scheme, crack, 1e-4);
  CHECK(wet == std::vector<std::size_t>{3, 3, 3, 3, 4, 4, 4, 4, 4, 4});
}

TEST_CASE("each rule has its own limits, and keeps those that are given") {
  const UniformPressure::Params paper = UniformPressure::Params{}.resolved();
  CHECK(paper.max_mechanical_steps == 10);
  CHECK(paper.volume_tolerance == 1e-2);
  const UniformPressure::Params equilibrium =
      UniformPressure::Params{.equilibrium = true}.resolved();
  CHECK(equilibrium.max_mechanical_steps == 1000);
  CHECK(equilibrium.volume_tolerance == 1e-3);
  const auto own = UniformPressure::Params{.max_mechanical_steps = 7, .volume_tolerance = 0.05};
  CHECK(own.resolved().max_mechanical_steps == 7);
  CHECK(own.resolved().volume_tolerance == 0.05);
  CHECK(UniformPressure({.fluid_dt = 3e-4}).fluid_dt(1e-6) == 3e-4);
}
