// Sizes, stresses, rates and positions other than the default ones.
#include <hfdem/hfdem.hpp>

#include <doctest/doctest.h>

#include "near.hpp"
#include "physics/verification_run.hpp"
#include "truth/static_lattice.hpp"

using namespace hfdem;
using test::Kgd;

namespace {

Kgd run(const Specimen& specimen, const Kgd::Params& params, double end_time) {
  Kgd sim{specimen, params};
  sim.run_until(end_time);
  return sim;
}

}  // namespace

TEST_SUITE("other_inputs") {
  TEST_CASE("with S_min vertical the crack runs along x, the same crack turned by a quarter") {
    const auto upright = run(square_array(40, 40, 5_mm), {}, 0.05);
    const auto lying =
        run(square_array(40, 40, 5_mm), {.in_situ = {.xx = 12_MPa, .yy = 10_MPa}}, 0.05);
    const auto a = measure::crack_shape(upright), b = measure::crack_shape(lying);
    CHECK(lying.crack_direction() == Vec2{1, 0});
    CHECK(lying.breaks().size() == upright.breaks().size());
    CHECK(upright.breaks().size() >= 6);
    CHECK(b.tip_up == test::near(a.tip_up, 1e-9));
    CHECK(b.aperture == test::near(a.aperture, 1e-6));
    CHECK(lying.injection_pressure() == test::near(upright.injection_pressure(), 1e-6));
    CHECK(measure::broken_off_plane(lying) == 0);
  }

  TEST_CASE("a set of other stresses, rate and strength climbs its own predicted staircase") {
    const truth::Lattice lattice{.columns = 60,
                                 .rows = 60,
                                 .radius = 4e-3,
                                 .E = 25e9,
                                 .bond_E = 15e9,
                                 .tensile_strength = 10e6,
                                 .S_xx = 15e6,
                                 .S_yy = 18e6};
    constexpr double rate = 1e-4;
    const auto events = truth::staircase(lattice, 4, 40, rate);
    Kgd sim{
        square_array(60, 60, 4_mm),
        {.contact = {.E = 25_GPa, .bond_E = 15_GPa, .tensile_strength = 10_MPa, .cohesion = 20_MPa},
         .in_situ = {.xx = 15_MPa, .yy = 18_MPa},
         .injection = {.rate = rate},
         .scheme = {.fluid_dt = 2e-5, .equilibrium = true}}};
    sim.run_until(events.back().time);
    int compared = 0;
    for (const auto& event : events) {
      const auto first = static_cast<std::size_t>(event.broken_contacts - 4);
      if (event.broken_contacts < 16 || first >= sim.breaks().size()) continue;
      CAPTURE(event.broken_contacts);
      CHECK(sim.breaks()[first].time == test::near(event.time, 0.03));
      ++compared;
    }
    CHECK(compared >= 11);
    CHECK(measure::broken_off_plane(sim) == 0);
  }

  TEST_CASE("an injection away from the middle drives the crack from there") {
    Kgd sim{square_array(60, 60, 5_mm), {.injection = {.position = Vec2{0.25, 0.20}}}};
    sim.run_until(0.05);
    const Vec2 at = measure::injection_point(sim);
    CHECK(at.x == test::near(0.25, 1e-9));
    CHECK(at.y == test::near(0.20, 1e-9));
    for (const BondBreak& b : sim.breaks())
      CHECK(sim.contact_point(b.contact).x == test::near(0.25, 1e-9));
    const auto shape = measure::crack_shape(sim);
    CHECK(shape.full_length() > 0.09);
    CHECK(sim.network().crack_volume() == test::near(sim.injected_volume(), 0.05));
  }

  TEST_CASE("a crack that reaches the rim stops the run with a sentence and loses nothing") {
    Kgd sim{square_array(20, 20, 5_mm), {}};
    bool stopped = false;
    try {
      sim.run_until(1);
    } catch (const RunStopped& reason) {
      stopped = true;
      CHECK(std::string(reason.what()).find("rim") != std::string::npos);
    }
    CHECK(stopped);
    CHECK(sim.breaks().size() == 16);
    CHECK(measure::crack_shape(sim).full_length() == test::near(0.20, 1e-9));
  }
}
