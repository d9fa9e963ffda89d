/// @file
/// Two translation units include everything: that this program links is half of the test.
#include <doctest/doctest.h>

#include "other_unit.hpp"

namespace {

TEST_CASE("a simulator made in one translation unit steps in another") {
  Kgd simulator = other_unit::bonded({});
  simulator.step();
  CHECK(simulator.time() == simulator.params().scheme.fluid_dt);
  CHECK(other_unit::pressure(simulator) > 0);
  CHECK(other_unit::pressure(simulator) == simulator.injection_pressure());
}

TEST_CASE("translation units share types and constants") {
  CHECK(other_unit::type() == typeid(Kgd));
  CHECK(other_unit::version() == &hfdem::version);
}

TEST_CASE("a simulator refuses parameters out of range, through translation units") {
  CHECK_THROWS_WITH_AS(
      other_unit::bonded({.mechanics = {.damping = 1}}),
      "mechanics.damping = 1 is not allowed: it must be at least 0 and less than 1",
      hfdem::InvalidParameter);
}

}  // namespace
