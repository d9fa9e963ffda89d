// Every scheme with every boundary: finite numbers, and a crack with two equal wings.
#include <array>
#include <cmath>

#include <doctest/doctest.h>

#include "schemes/small_array.hpp"

namespace {

using hfdem::BoundaryKind;

constexpr std::array boundaries{BoundaryKind::servo, BoundaryKind::frozen,
                                BoundaryKind::dead_loads};

bool all_finite(const hfdem::Discs& discs) {
  for (const auto* rows : {&discs.displacement, &discs.velocity})
    for (const hfdem::Pack& row : *rows)
      for (std::size_t lane = 0; lane < 4; ++lane)
        if (!std::isfinite(row[lane])) return false;
  return true;
}

/// Five fluid steps under each boundary.
template <class Pressure>
void check_five_steps(typename Pressure::Params scheme) {
  for (const BoundaryKind kind : boundaries) {
    CAPTURE(static_cast<int>(kind));
    test::SquareRock<Pressure> sim(
        test::square(20),
        {.boundary = {.kind = kind}, .injection = {.rate = 1e-3}, .scheme = scheme});
    for (int n = 0; n < 5; ++n) sim.step();
    CHECK(sim.fluid_steps() == 5);
    CHECK(all_finite(sim.discs()));
    CHECK(test::asymmetric_discs(sim.discs()) == 0);
  }
}

}  // namespace

TEST_CASE("a dry specimen") { check_five_steps<hfdem::Dry>({}); }

TEST_CASE("a held pressure") { check_five_steps<hfdem::HeldPressure>({.pressure = 12e6}); }

TEST_CASE("uniform pressure by the paper's rule") { check_five_steps<hfdem::UniformPressure>({}); }

TEST_CASE("uniform pressure at equilibrium") {
  check_five_steps<hfdem::UniformPressure>({.equilibrium = true});
}

TEST_CASE("a crack grows with two wings that mirror each other to the last bit") {
  for (const BoundaryKind kind : boundaries)
    for (const bool lying : {false, true}) {
      CAPTURE(static_cast<int>(kind));
      CAPTURE(lying);
      test::Injected sim(test::square(20),
                         {.boundary = {.kind = kind},
                          .in_situ = lying ? hfdem::Stress{12e6, 10e6} : hfdem::Stress{10e6, 12e6},
                          .injection = {.rate = 2e-4}});
      for (int n = 0; n < 1000 && sim.breaks().size() < 8; ++n) {
        sim.step();
        REQUIRE(test::asymmetric_discs(sim.discs()) == 0);
      }
      CHECK(sim.breaks().size() >= 8);
      CHECK(sim.breaks().size() % 2 == 0);
    }
}
