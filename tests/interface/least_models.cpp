/// @file
/// The least models of the concept pages do what their pages say, and make a simulator together.
#include <hfdem/measure/crack.hpp>
#include <hfdem/measure/elastic_moduli.hpp>
#include <hfdem/measure/energy_ledger.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/pressure/conventional.hpp>
#include <hfdem/pressure/implicit.hpp>
#include <hfdem/pressure/leaky_uniform.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

#include <doctest/doctest.h>

#include "loops/jointed_rock.hpp"
#include "models.hpp"
#include "near.hpp"

using namespace models;
using test::near;

namespace {

using Sim = Simulator<GluedSprings, RoughWalls, PressureSteps, AllPairs>;

TEST_CASE("glued springs pull until their strength, and push on when broken") {
  const GluedSprings law({.E = 20e9, .tensile_strength = 5e6});
  const auto k = law.stiffness({2e-3}, {6e-3});  // area 4 mm, length 8 mm
  const double at_strength = 5e6 * 4e-3 / 10e9;
  const auto force = [&](const auto& stiffness, double opening) {
    return law.respond(stiffness, {}, Motion<double>{.opening = opening}).reaction().normal;
  };
  CHECK(force(k, at_strength) == near(-5e6 * 4e-3, 1e-12));
  CHECK(force(law.broken(k), at_strength) == 0);
  CHECK(force(law.broken(k), -1e-6) == near(10e9 * 1e-6, 1e-12));
  const auto breaks = [&](double opening) {
    return law.failure(k, law.respond(k, {}, Motion<double>{.opening = opening})).tension;
  };
  CHECK(!breaks(0.999 * at_strength));
  CHECK(breaks(1.001 * at_strength));
}

TEST_CASE("a square array of glued springs has the stiffness of its springs") {
  const auto moduli = measure::elastic_moduli<GluedSprings, AllPairs>(square_array(6, 6, 5e-3),
                                                                      {.E = 20e9}, {5e6, 5e6});
  CHECK(moduli.young == near(20e9, 1e-3));
  CHECK(std::abs(moduli.poisson) < 1e-3);
}

TEST_CASE("the search through all pairs finds the neighbours of a square array") {
  const Specimen specimen = square_array(7, 5, 5e-3);
  const auto found = bonded_contacts<AllPairs>(specimen);
  const auto known = bonded_contacts<FixedPairs>(specimen);
  REQUIRE(found.size() == 6 * 5 + 7 * 4);
  REQUIRE(known.size() == found.size());
  for (std::size_t c = 0; c < found.size(); ++c) CHECK(found[c].bodies == known[c].bodies);
}

TEST_CASE("the least models make a simulator: pressure opens its crack") {
  Sim sim{square_array(12, 12, 5e-3), {.aperture = {.w0 = 3e-6}, .in_situ = {5e6, 6e6}}};
  for (int step = 0; step < 2; ++step) sim.step();
  CHECK(sim.injection_pressure() == 2e6);
  CHECK(measure::crack_shape(sim).aperture == 3e-6);  // still pressed shut
  while (sim.injection_pressure() < 9e6) sim.step();
  const auto [left, right] = sim.contacts().bodies(sim.preset_contacts().front());
  const double gap = sim.discs().displacement[right][0] - sim.discs().displacement[left][0];
  CHECK(gap > 1e-6);
  CHECK(sim.network().width(sim.preset_contacts().front()) == near(3e-6 + gap, 1e-9));
  CHECK(sim.breaks().empty());
}

TEST_CASE("a filter cake takes its part of the fluid, with every scheme") {
  const auto check = [](auto sim, double rate) {
    for (int step = 0; step < 40; ++step) sim.step();
    const VolumeBalance b = sim.volume_balance();
    CHECK(b.relative_error() < 1e-12);
    CHECK(b.leaked > 0);
    // At most what all domains would have lost at the highest pressure all the time.
    CHECK(b.leaked < rate * 1e9 * sim.time());
  };
  const Specimen specimen = square_array(12, 12, 5e-3);
  using Implicit =
      Simulator<GluedSprings, RoughWalls, ImplicitFlow<DenserFluid, FilterCake>, AllPairs>;
  using Explicit =
      Simulator<GluedSprings, RoughWalls, ConventionalFlow<DenserFluid, FilterCake>, AllPairs>;
  using Uniform = Simulator<GluedSprings, RoughWalls, LeakyUniformPressure<FilterCake>, AllPairs>;
  check(Implicit{specimen, {.in_situ = {5e6, 6e6}, .leakoff = {.rate = 1e-13}}}, 1e-13);
  check(Explicit{specimen, {.in_situ = {5e6, 6e6}, .leakoff = {.rate = 1e-13}}}, 1e-13);
  check(Uniform{specimen, {.in_situ = {5e6, 6e6}, .leakoff = {.rate = 1e-13}}}, 1e-13);
}

TEST_CASE("glued walls make joints: the stress presses them, the fluid tears and fills them") {
  Specimen specimen = square_array(12, 12, 5e-3);
  test::add_fracture(specimen, {0.02, 0.09}, {0.1, 0.09}, 1e-8);
  Simulator<Jointed<GluedSprings, GluedWalls>, RoughWalls, PressureSteps, AllPairs> sim{
      specimen,
      {.joints = {.stiffness = 3.4e12, .tensile_strength = 1, .w0 = 2e-5},
       .aperture = {.w0 = 3e-6},
       .in_situ = {0.5e6, 0.6e6}}};
  REQUIRE(sim.joints().bonded() == 8);
  const auto channel = [&](std::size_t k) { return static_cast<Index>(sim.contacts().size() + k); };
  double force = 0;  // per metre of thickness; the joints are as stiff as the rock
  for (std::size_t k = 0; k < 8; ++k) {
    const auto motion = sim.joints().contacts().motion(k, sim.discs().displacement);
    CHECK(sim.reaction(channel(k)).normal == near(-3.4e12 * motion.opening * 0.01, 1e-9));
    force += sim.reaction(channel(k)).normal;
  }
  CHECK(force == near(0.6e6 * 0.08, 1e-3));
  try {
    while (true) sim.step();
  } catch (const ReachedRim&) {  // the end of a crack under rising pressure
  }
  int wet = 0;
  for (const Index c : sim.network().wet_channels()) {
    if (!sim.is_joint(c)) continue;
    CHECK(sim.joints().contacts().stiffness(c - sim.contacts().size()).glue == 0);
    CHECK(sim.network().width(c) >= 2e-5);
    ++wet;
  }
  CHECK(wet > 0);
}

TEST_CASE("books of energy close for a law of one's own that says what it stores") {
  Simulator<LawWithEnergy, RoughWalls, PressureSteps, AllPairs> sim{
      square_array(12, 12, 5e-3), {.in_situ = {5e6, 6e6}, .scheme = {.rise = 5e6}}};
  measure::EnergyLedger<LawWithEnergy> ledger;
  try {
    while (true) sim.step(ledger);
  } catch (const ReachedRim&) {  // the end of a crack under rising pressure
  }
  CHECK(ledger.worst_relative_error() < 1e-9);
  CHECK(ledger.entries().breaks > 1e-4 * ledger.work_done());
  CHECK(ledger.entries().switching != 0);
  CHECK(ledger.entries().friction == 0);
}

TEST_CASE("parameters of one's own policies are checked like any others") {
  CHECK_THROWS_WITH_AS(
      (Sim{square_array(6, 6, 5e-3), {.contact = {.tensile_strength = -1}}}),
      "contact.tensile_strength = -1 Pa is not allowed: it must be greater than 0 Pa",
      InvalidParameter);
}

}  // namespace
