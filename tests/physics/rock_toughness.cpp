// The measures of random rock, on a square array found by a k-d tree, whose modulus and toughness
// are known.
#include <cmath>
#include <vector>

#include <hfdem/analytic/stepwise_growth.hpp>
#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/measure/running_crack.hpp>
#include <hfdem/measure/slit.hpp>
#include <hfdem/measure/slit_modulus.hpp>
#include <hfdem/neighbours/kd_tree.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/setup/square_array.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

using namespace hfdem;

namespace {

constexpr int size = 60;
constexpr double radius = 5e-3, width = 2 * radius * size;
constexpr double E_prime = 25.70e9;  // 2 E / sqrt(2 + 2 rho), E = 34 GPa, rho = 2.5
// What static solutions of the lattice say (tests/physics/slits.cpp, tests/truth).
const analytic::LatticeFracture lattice{.E = 34e9,
                                        .poisson_ratio = 0,
                                        .shear_modulus = 6.8e9,
                                        .E_prime = E_prime,
                                        .K_IC = 1.564e6,
                                        .K_IC_per_pressure = 0.0588,
                                        .opening_offset = 4.9e-6,
                                        .volume_offset = 4.7e-6,
                                        .overhang = 0.17 * radius};
const analytic::CrackedPlate plate{width, {34e9, 0, 6.8e9}, analytic::PlateSides::rigid};

using test::near;

/// The array as a specimen whose neighbours are to be found.
Specimen specimen() {
  Specimen s = square_array({.columns = size, .rows = size, .radius = radius});
  s.pairs.clear();
  s.bonding_gap = 0.02 * radius;
  return s;
}

}  // namespace

TEST_SUITE("rock_toughness") {
  TEST_CASE("slits of given lengths in the array have its modulus") {
    using Slit = measure::Slit<LinearParallelBond, HyperbolicAperture, KdTree>;
    constexpr double reach = 30e-3;
    std::vector<measure::SlitTest> slits;
    for (const double length : {0.2, 0.3}) {
      const Slit slit(specimen(),
                      {.scheme = {.unbalanced_tolerance = 3e-5, .max_mechanical_steps = 100000}},
                      {.length = length}, reach);
      CHECK(slit.half_length() == near(length / 2, 1e-9));
      slits.push_back(slit.held_at(std::vector{2e6, 2.5e6}));
    }
    const auto modulus = measure::slit_modulus(slits, plate, reach);
    MESSAGE("E' = " << modulus.E_prime_from_opening / 1e9 << " GPa from the openings, "
                    << modulus.E_prime / 1e9 << " GPa from the volumes");
    CHECK(modulus.E_prime_from_opening == near(E_prime, 0.015));
    for (const auto& reading : modulus.readings) {
      const double a = reading.slit.half_length;
      CHECK(reading.E_prime == near(E_prime * std::pow(a / (a + lattice.overhang), 2), 0.015));
      // The offset of a mean opening, as a pressure.
      const double volume = std::numbers::pi * a * plate.factors(2 * a).volume / E_prime;
      CHECK(reading.closing_excess == near(lattice.volume_offset / volume, 0.1));
    }
  }

  TEST_CASE("a crack that runs through the array has the toughness of its staircase") {
    constexpr double rate = 1e-4;
    const measure::RunningRange range{.from = 0.25, .to = 0.65};
    Simulator<LinearParallelBond, HyperbolicAperture, UniformPressure, KdTree> sim(
        specimen(), {.crack = {.length = 0.08},
                     .injection = {.rate = rate},
                     .scheme = {.fluid_dt = 1e-4,
                                .equilibrium = true,
                                .max_mechanical_steps = 500,
                                .unbalanced_tolerance = 4e-3}});
    measure::RunningCrack crack(10e6);
    sim.run_until(1, crack, [&](const auto&) {
      return crack.instants().back().full_length() < range.to * width + 1e-9;
    });
    const analytic::StepwiseGrowth growth(plate, lattice, 2 * radius, 8);
    std::vector<measure::CrackInstant> predicted;
    for (const auto& now : crack.instants()) {
      const auto c = growth.at(rate * now.time);
      REQUIRE(c);
      predicted.push_back({now.time, c->full_length / 2, c->full_length / 2, c->net_pressure, 0});
    }
    const auto run = measure::running_toughness(crack.instants(), plate, range);
    const auto truth = measure::running_toughness(predicted, plate, range);
    MESSAGE("K = " << run.K / 1e6 << " MPa sqrt(m), " << truth.K / 1e6 << " of the staircase");
    REQUIRE(truth.steps > 300);
    CHECK(static_cast<double>(run.steps) == near(static_cast<double>(truth.steps), 0.03));
    CHECK(run.K == near(truth.K, 0.025));
  }
}
