// The predicted injection into a plate of isotropic rock, and the means over seeds beside it.
#include "support/growth_prediction.hpp"

#include <cmath>
#include <string>

#include <hfdem/analytic/kgd.hpp>
#include <hfdem/analytic/pressurised_crack.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

using namespace hfdem;
using support::GrowthPrediction;
using support::PlateInjection;

namespace {

const analytic::RockFracture rock{
    .E_prime = 31.7e9, .poisson_ratio = 0.2, .K_IC = 2.16e6, .closing_excess = 0.8e6};

using test::near;

}  // namespace

TEST_CASE("in a plate much larger than the crack it is the storage-toughness vertex") {
  const GrowthPrediction growth(rock, {.width = 200, .height = 200, .rate = 0.5e-4});
  const auto vertex = analytic::toughness_vertex(rock.E_prime, rock.K_IC, 0.5e-4, 0.6);
  const auto crack = growth.at(0.6);
  REQUIRE(crack);
  CHECK(crack->full_length == near(vertex.full_length(), 1e-3));
  CHECK(crack->opening == near(vertex.width, 1e-3));
  CHECK(crack->pressure == near(10.8e6 + vertex.net_pressure, 1e-3));
}

TEST_CASE("in the finite plate it is what an independent study of the same rock predicted") {
  // 1 m of rock with E' = 31.7 GPa, K = 2.16 MPa sqrt(m), 0.5e-4 m2/s.
  const GrowthPrediction growth(rock, {});
  CHECK(growth.at(0.3)->full_length == near(0.315, 0.01));
  CHECK(growth.at(0.6)->full_length == near(0.503, 0.01));
  CHECK(growth.at(0.9)->full_length == near(0.668, 0.01));
  CHECK(growth.splitting_time() == near(1.3, 0.05));
  CHECK(growth.at(0.999 * growth.splitting_time()));
  CHECK(!growth.at(1.001 * growth.splitting_time()));
  CHECK(!growth.at(0));
}

TEST_CASE("twice the plate with the same volume for its size grows alike") {
  // Lengths by 2 and K by sqrt(2) keep the pressure, so that volumes go by 4.
  analytic::RockFracture tougher = rock;
  tougher.K_IC *= std::sqrt(2.0);
  const GrowthPrediction small(rock, {.height = 0.7}),
      large(tougher, {.width = 2, .height = 1.4, .rate = 2e-4});
  CHECK(large.at(0.3)->full_length == near(2 * small.at(0.3)->full_length, 1e-9));
  CHECK(large.at(0.3)->pressure == near(small.at(0.3)->pressure, 1e-9));
  CHECK(large.splitting_time() == near(small.splitting_time(), 1e-6));
}

TEST_CASE("the preset crack opens before it grows") {
  const GrowthPrediction growth(rock, {.width = 50, .height = 50, .preset_length = 0.2}),
      without(rock, {.width = 50, .height = 50});
  const auto early = growth.at(0.05);
  REQUIRE(early);
  CHECK(early->full_length == 0.2);
  // V = 2 pi a^2 p / E'
  const double net = 0.5e-4 * 0.05 * rock.E_prime / (2 * std::numbers::pi * 0.01);
  CHECK(early->pressure == near(10.8e6 + net, 1e-3));
  CHECK(early->opening == near(4 * 0.1 * net / rock.E_prime, 1e-3));
  CHECK(growth.at(0.4)->full_length == without.at(0.4)->full_length);
}

TEST_CASE("the crack runs along the greater stress") {
  const PlateInjection along_x{.width = 1.5, .height = 1, .in_situ = {12e6, 10e6}};
  const PlateInjection along_y{.width = 1, .height = 1.5, .in_situ = {10e6, 12e6}};
  CHECK(GrowthPrediction(rock, along_x).at(0.5)->full_length ==
        GrowthPrediction(rock, along_y).at(0.5)->full_length);
}

TEST_CASE("what cannot be predicted is refused") {
  CHECK_THROWS_WITH_AS(GrowthPrediction(rock, {.height = 3}),
                       doctest::Contains("specimen.height = 3 m"), InvalidParameter);
  CHECK_THROWS_WITH_AS(GrowthPrediction(rock, {.rate = 0}),
                       doctest::Contains("injection.rate = 0 m2/s"), InvalidParameter);
  CHECK_THROWS_WITH_AS(GrowthPrediction(rock, {.preset_length = 0.95}),
                       doctest::Contains("crack.length = 0.95 m"), InvalidParameter);
  CHECK_THROWS_WITH_AS(GrowthPrediction({.E_prime = 30e9}, {}), doctest::Contains("K_IC = 0"),
                       InvalidParameter);
}
