// Modulus and toughness from slits, and the runs that they predict. Nothing is fitted to a run.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <hfdem/analytic/stepwise_growth.hpp>
#include <hfdem/measure/slit.hpp>
#include <hfdem/measure/toughness.hpp>

#include <doctest/doctest.h>

#include "near.hpp"
#include "physics/verification_run.hpp"
#include "truth/static_lattice.hpp"

using namespace hfdem;
using namespace test;

namespace {

/// A square array, its load and its injection.
struct Case {
  std::string name;
  int size;
  double rate, strength;
  Stress in_situ;
  measure::SlitSeries slits;
  BoundaryKind boundary = BoundaryKind::servo;

  LinearParallelBond::Params contact() const {
    return {.tensile_strength = strength, .cohesion = 15.0 / 8.0 * strength};
  }
  SquareArray array() const { return {.columns = size, .rows = size}; }
};

const Case verification{"the verification model", 100, 0.5e-4, 8e6, {10e6, 12e6}, {},
                        BoundaryKind::servo};

/// nu = 0 and G = E / 5, closed forms of the square array with k_n / k_s = 2.5.
const analytic::LatticeFracture lattice{.E = 34e9, .poisson_ratio = 0, .shear_modulus = 6.8e9};

analytic::CrackedPlate plate_of(const Case& c) {
  const bool frozen = c.boundary == BoundaryKind::frozen;
  const auto sides = frozen ? analytic::PlateSides::fixed : analytic::PlateSides::rigid;
  return {2 * 5e-3 * c.size, {34e9, 0, 6.8e9}, sides};
}

measure::ToughnessTest measured(const Case& c) {
  using Slit = measure::Slit<LinearParallelBond, HyperbolicAperture, FixedPairs>;
  std::vector<measure::SlitTest> slits;
  double start = 1e6;
  for (const int contacts : c.slits.contacts()) {
    const Slit slit(square_array(c.array()),
                    {.contact = c.contact(),
                     .boundary = {.kind = c.boundary},
                     .in_situ = c.in_situ,
                     .scheme = {.unbalanced_tolerance = 3e-7, .max_mechanical_steps = 100000}},
                    contacts);
    slits.push_back(slit.test(start, c.slits.accuracy));
    start = 0.5 * slits.back().net_pressure_at_break;
  }
  return measure::toughness_test(slits, plate_of(c), lattice);
}

const measure::ToughnessTest& of_verification() {
  static const measure::ToughnessTest test = measured(verification);
  return test;
}

using test::near;

/// Largest relative deviation of the break times while the crack grows from a sixth to three
/// quarters of the specimen.
Worst break_times(const std::vector<Advance>& advances, const Case& c,
                  const analytic::StepwiseGrowth& growth) {
  Worst worst;
  int compared = 0;
  for (const auto& predicted : growth.breaks()) {
    if (6 * predicted.contacts < c.size || 4 * predicted.contacts > 3 * c.size) continue;
    for (const Advance& ours : advances)
      if (ours.contacts == predicted.contacts) {
        worst.see(ours.time, predicted.volume / c.rate, predicted.full_length);
        ++compared;
      }
  }
  CHECK(compared >= c.size / 4);
  MESSAGE(c.name << ": break times " << worst.deviation << " (at " << worst.at << " m), "
                 << compared << " compared");
  return worst;
}

}  // namespace

TEST_SUITE("measured_toughness") {
  TEST_CASE("slits give the modulus, the offset and the toughness of the array") {
    const auto& test = of_verification();
    CHECK(test.rock.E_prime == near(0.7559289 * 34e9, 0.01));
    CHECK(test.E_prime_from_volume == near(0.7559289 * 34e9, 0.01));
    for (const auto& reading : test.readings) {
      const measure::SlitTest& slit = reading.slit;
      CAPTURE(slit.contacts);
      CHECK(reading.E_prime == near(25.70e9, 0.01));
      CHECK(-slit.opening.intercept == near(slit.contacts == 10 ? 4.75e-6 : 5.00e-6, 0.03));
      truth::StaticSlit exact({}, slit.contacts);
      const double high = slit.net_pressure_at_break, low = 0.8 * high;
      const auto at = [&](double net) { return exact.at_pressure(10e6 + net); };
      const double slope = (at(high).volume - at(low).volume) / (high - low);
      CHECK(slit.volume.slope == near(slope, 0.005));
      CHECK(-slit.volume.intercept == near(slope * high - at(high).volume, 0.01));
      CHECK(reading.K_IC == near(1.564e6 + 0.0588 * slit.net_pressure_at_break, 0.01));
    }
    CHECK(test.rock.K_IC == near(1.564e6, 0.03));
    CHECK(test.rock.K_IC_per_pressure == near(0.0588, 0.03));
    MESSAGE("E' = " << test.rock.E_prime / 1e9 << " GPa (from volumes "
                    << test.E_prime_from_volume / 1e9 << "), K = " << test.rock.K_IC / 1e6 << " + "
                    << test.rock.K_IC_per_pressure << " p, offsets "
                    << test.rock.opening_offset * 1e6 << ", " << test.rock.volume_offset * 1e6
                    << " um, overhang " << test.rock.overhang * 1e3 << " mm");
  }

  TEST_CASE("they predict the verification run") {
    const auto& run = equilibrium();
    const analytic::StepwiseGrowth growth(plate_of(verification), of_verification().rock, 0.01, 4);
    CHECK(break_times(run.advances, verification, growth).deviation < 0.02);
    Worst length, opening, pressure;
    for (int k = 1; k <= 8; ++k) {
      const double time = 0.1 * k;
      analytic::LatticeCrack mean{};
      constexpr int points = 41;
      for (int i = 0; i < points; ++i) {
        const auto state = growth.at(verification.rate * (time - 0.02 + 0.04 * i / (points - 1)));
        REQUIRE(state);
        mean.full_length += state->full_length / points;
        mean.opening += state->opening / points;
        mean.net_pressure += state->net_pressure / points;
      }
      length.see(run.mean(&Sample::length, time), mean.full_length, time);
      opening.see(run.mean(&Sample::opening, time), mean.opening, time);
      pressure.see(run.mean(&Sample::net_pressure, time), mean.net_pressure, time);
    }
    MESSAGE("window means: length " << length.deviation << ", opening " << opening.deviation
                                    << ", net pressure " << pressure.deviation << " (at "
                                    << pressure.at << " s)");
    CHECK(length.deviation < 0.015);
    CHECK(opening.deviation < 0.015);
    CHECK(pressure.deviation < 0.04);
  }

  TEST_CASE("they predict runs of other rates, stresses, strengths and boundaries") {
    const measure::SlitSeries slits{.shortest = 8, .longest = 24, .count = 3};
    const measure::SlitSeries short_slits{.shortest = 6, .longest = 16, .count = 3};
    for (const Case& c :
         {Case{"weaker, faster", 60, 1e-4, 6e6, {10e6, 12e6}, slits},
          Case{"deeper, slower", 60, 0.25e-4, 8e6, {15e6, 20e6}, slits},
          Case{"stronger, shallower", 60, 1e-4, 10e6, {8e6, 10e6}, slits},
          Case{"frozen platens", 40, 1e-4, 8e6, {10e6, 12e6}, short_slits, BoundaryKind::frozen}}) {
      CAPTURE(c.name);
      const auto test = measured(c);
      const analytic::StepwiseGrowth growth(plate_of(c), test.rock, 0.01, 4);
      const auto last = std::find_if(growth.breaks().begin(), growth.breaks().end(),
                                     [&](const auto& b) { return 4 * b.contacts > 3 * c.size; });
      REQUIRE(last != growth.breaks().end());
      const auto run = inject({.contact = c.contact(),
                               .boundary = {.kind = c.boundary},
                               .in_situ = c.in_situ,
                               .injection = {.rate = c.rate},
                               .scheme = {.equilibrium = true}},
                              c.array(), last->volume / c.rate);
      CHECK(break_times(run.advances, c, growth).deviation < 0.04);
    }
  }
}
