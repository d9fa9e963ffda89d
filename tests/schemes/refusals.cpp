// What a simulator refuses, and how a run that cannot go on stops.
#include <cmath>
#include <string>

#include <hfdem/base/errors.hpp>

#include <doctest/doctest.h>

#include "near.hpp"
#include "schemes/small_array.hpp"

namespace {

using hfdem::InvalidParameter;
using hfdem::RunStopped;
using hfdem::Vec2;
using test::Injected;

/// What is said against a simulator with these parameters.
std::string refusal(const Injected::Params& params) {
  try {
    const Injected sim(test::square(6), params);
  } catch (const InvalidParameter& refused) {
    return refused.what();
  }
  return "accepted";
}

/// What stops the run, which must happen within some steps.
std::string why_it_stops(Injected& sim, int steps = 2000) {
  try {
    for (int n = 0; n < steps; ++n) sim.step();
  } catch (const RunStopped& stopped) {
    return stopped.what();
  }
  return "goes on";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("parameters outside their range are refused by section and name") {
  CHECK(refusal({}) == "accepted");
  CHECK(contains(refusal({.contact = {.E = -1}}), "contact.E = -1 Pa"));
  CHECK(contains(refusal({.contact = {.friction_angle = 90}}), "contact.friction_angle = 90 deg"));
  CHECK(contains(refusal({.aperture = {.w0 = 0}}), "aperture.w0 = 0 m"));
  CHECK(contains(refusal({.boundary = {.servo_gain = 1.5}}), "boundary.servo_gain = 1.5"));
  CHECK(contains(refusal({.in_situ = {.xx = -1}}), "in_situ.xx = -1 Pa"));
  CHECK(contains(refusal({.crack = {.contacts = -1}}), "crack.contacts = -1"));
  CHECK(contains(refusal({.injection = {.rate = 0}}), "injection.rate = 0 m2/s"));
  CHECK(contains(refusal({.fluid = {.viscosity = 0}}), "fluid.viscosity = 0 Pa s"));
  CHECK(contains(refusal({.mechanics = {.step_fraction = 1.1}}), "mechanics.step_fraction = 1.1"));
  CHECK(contains(refusal({.mechanics = {.damping = 1}}), "mechanics.damping = 1"));
  CHECK(contains(refusal({.scheme = {.fluid_dt = 0}}), "scheme.fluid_dt = 0 s"));
  CHECK(contains(refusal({.injection = {.rate = std::nan("")}}), "injection.rate = nan"));
}

TEST_CASE("a fluid without a crack to enter is refused; a dry specimen needs none") {
  CHECK(contains(refusal({.crack = {.contacts = 0}}), "crack.contacts = 0"));
  CHECK_NOTHROW(test::SquareRock<hfdem::Dry>(test::square(6), {.crack = {.contacts = 0}}));
}

TEST_CASE("a preset crack too short to cut a contact is refused by its length") {
  CHECK(contains(refusal({.crack = {.length = 1e-3}}), "crack.length = 0.001 m"));
}

TEST_CASE("a rate that is no rate is refused, and changes nothing; zero shuts the well in") {
  Injected sim(test::square(20), {});
  sim.step();
  const double injected = sim.injected_volume();
  CHECK_THROWS_AS(sim.inject(std::nan("")), InvalidParameter);
  CHECK_THROWS_AS(sim.inject(-1e-5), InvalidParameter);
  sim.step();
  CHECK(sim.injected_volume() == test::near(2 * injected));
  sim.inject(0);
  sim.step();
  CHECK(sim.injected_volume() == test::near(2 * injected));
}

TEST_CASE("a dry specimen may be cut through") {
  const test::SquareRock<hfdem::Dry> sim(test::square(6), {.crack = {.contacts = 6}});
  CHECK(sim.network().reached_rim());
}

TEST_CASE("an injection outside the specimen is refused") {
  for (const Vec2 outside : {Vec2{-0.01, 0.03}, Vec2{0.03, 0.07}, Vec2{0, 0.03}})
    CHECK(contains(refusal({.injection = {.position = outside}}), "injection.position"));
  CHECK(refusal({.crack = {.contacts = 2}, .injection = {.position = Vec2{0.02, 0.03}}}) ==
        "accepted");
}

TEST_CASE("a preset crack through the rim is stopped at once") {
  CHECK_THROWS_AS(Injected(test::square(6), {.crack = {.contacts = 6}}), RunStopped);
}

TEST_CASE("a crack that reaches the rim stops the run, and all can still be read") {
  Injected sim(test::square(12), {.injection = {.rate = 2e-4}});
  const std::string why = why_it_stops(sim);
  CHECK(contains(why, "rim"));
  REQUIRE(contains(why, "t = "));
  CHECK(std::stod(why.substr(why.find("t = ") + 4)) == test::near(sim.time(), 1e-4));
  CHECK(sim.network().reached_rim());
  CHECK(sim.time() > 0);
  CHECK(sim.breaks().size() == 12 - 4);
  CHECK(std::isfinite(sim.injection_pressure()));
  CHECK(std::isfinite(sim.network().crack_volume()));
  CHECK(test::asymmetric_discs(sim.discs()) == 0);
}

TEST_CASE("a force that is not a finite number stops the run") {
  // Rock too strong to break under a pressure without limits.
  Injected sim(test::square(6), {.contact = {.tensile_strength = 1e300, .cohesion = 1e300},
                                 .injection = {.rate = 1e10},
                                 .scheme = {.alpha = 1e300, .max_pressure_step = 1e300}});
  CHECK(contains(why_it_stops(sim), "not a finite number"));
}

TEST_CASE("a specimen that does not settle in the steps allowed is stopped") {
  const Injected::Params params{.mechanics = {.settle_tolerance = 1e-300, .max_settle_steps = 40}};
  try {
    const Injected sim(test::square(6), params);
    FAIL("settled");
  } catch (const RunStopped& stopped) {
    CHECK(contains(stopped.what(), "no equilibrium"));
    CHECK(contains(stopped.what(), "40 mechanical steps"));
    CHECK(contains(stopped.what(), "mechanics.max_settle_steps"));
  }
}
