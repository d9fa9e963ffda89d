// Microcracks as a simulator tells them, and their numbers.
#include <vector>

#include <hfdem/measure/crack_path.hpp>
#include <hfdem/measure/path_profile.hpp>

#include <doctest/doctest.h>

#include "measures/made_up_crack.hpp"
#include "near.hpp"
#include "observe/two_sizes.hpp"
#include "schemes/small_array.hpp"

using hfdem::Mode;
using hfdem::measure::CrackPath;
using hfdem::measure::Microcrack;
using test::near;

namespace {

/// Pressed beyond its strength, a crack runs through a specimen of two sizes of discs.
test::SquareRock<hfdem::HeldPressure> burst() {
  test::SquareRock<hfdem::HeldPressure> sim(test::two_sizes(24, 24),
                                            {.contact = {.tensile_strength = 4e6},
                                             .in_situ = {.xx = 10e6, .yy = 12e6},
                                             .scheme = {.pressure = 40e6}});
  for (int step = 0; step < 40 && sim.breaks().size() < 60; ++step) sim.step();
  return sim;
}

}  // namespace

TEST_CASE("microcracks are counted by mode and by whether the fluid reaches them") {
  test::MadeUpCrack made;
  made.grow({{0, 0.01}, {0, 0.01}, {0, 0.01}, {0, 0.01}});
  made.grow({{0, -0.02}, {0, -0.02}, {0, -0.02}});
  auto& m = made.microcracks;
  m[0].mode.reset();
  m[1].mode = m[5].mode = m[6].mode = Mode::shear;
  m[4].connected = m[5].connected = m[6].connected = false;
  const auto counts = hfdem::measure::count(m);
  CHECK(counts.connected.preset == 1);
  CHECK(counts.connected.shear == 1);
  CHECK(counts.connected.tension == 2);
  CHECK(counts.connected.total() == 4);
  CHECK(counts.connected.length == near(0.04));
  CHECK(counts.unconnected.preset == 0);
  CHECK(counts.unconnected.shear == 2);
  CHECK(counts.unconnected.tension == 1);
  CHECK(counts.unconnected.length == near(0.06));
}

TEST_CASE("a slit in a square array is a straight crack of its contacts") {
  test::SquareRock<hfdem::HeldPressure> sim(test::square(40),
                                            {.contact = {.tensile_strength = 1e9, .cohesion = 1e9},
                                             .in_situ = {.xx = 10e6, .yy = 12e6},
                                             .crack = {.contacts = 12},
                                             .scheme = {.pressure = 14e6}});
  REQUIRE(sim.step().converged);
  const auto cracks = hfdem::measure::microcracks(sim);
  const CrackPath crack = hfdem::measure::crack_path(cracks, hfdem::measure::crack_origin(sim));
  CHECK(crack.tip_distance() == near(0.12));
  CHECK(crack.path_length == near(0.12));
  CHECK(crack.mean_tortuosity() == near(1));
  CHECK(crack.asymmetry() < 1e-12);
  CHECK(crack.branches.empty());
  const auto counts = hfdem::measure::count(cracks);
  CHECK(counts.connected.preset == 12);
  CHECK(counts.connected.total() == 12);
  CHECK(counts.unconnected.total() == 0);

  const auto profile = hfdem::measure::path_profile(cracks, crack, 10e6);
  REQUIRE(profile.size() == 12);
  for (std::size_t k = 0; k < 12; ++k) {
    CHECK(profile[k].along == near((static_cast<double>(k) - 5.5) * 0.01));
    CHECK(profile[k].net_pressure == near(4e6));
    CHECK(profile[k].aperture == near(profile[11 - k].aperture));
  }
  for (std::size_t k = 6; k + 1 < 12; ++k) CHECK(profile[k].aperture > profile[k + 1].aperture);
}

TEST_CASE("a crack that breaks its way is told break by break") {
  const auto sim = burst();
  const auto cracks = hfdem::measure::microcracks(sim);
  const std::size_t preset = sim.preset_contacts().size();
  REQUIRE(cracks.size() == preset + sim.breaks().size());
  REQUIRE(sim.breaks().size() >= 20);
  for (std::size_t k = 0; k < sim.breaks().size(); ++k) {
    CHECK(cracks[preset + k].contact == sim.breaks()[k].contact);
    CHECK(cracks[preset + k].mode == sim.breaks()[k].mode);
  }
  int connected = 0, unconnected = 0;
  for (const Microcrack& m : cracks) {
    const auto& bodies = sim.contact_geometry(m.contact).bodies;
    const double narrower =
        std::min(sim.discs().radius[bodies.first], sim.discs().radius[bodies.second]);
    CHECK(m.length() == near(2 * narrower));
    CHECK(m.connected == sim.network().is_wet(m.contact));
    ++(m.connected ? connected : unconnected);
    if (m.connected) {
      CHECK(m.aperture == sim.network().width(m.contact));
      CHECK(m.opening == near(m.aperture - 6e-6));
      const double first = sim.network().pressure(m.domain[0]);
      CHECK(m.pressure == near((first + sim.network().pressure(m.domain[1])) / 2));
    } else {
      CHECK(m.aperture == 0);
      CHECK(m.pressure == 0);
    }
  }
  CHECK(connected > 10);
  CHECK(unconnected > 0);
  CHECK(hfdem::measure::count(cracks).connected.total() == connected);

  const auto shape = hfdem::measure::crack_shape(sim);
  const CrackPath crack = hfdem::measure::crack_path(cracks, hfdem::measure::crack_origin(sim));
  CHECK(crack.up.reach == shape.tip_up);
  CHECK(crack.down.reach == shape.tip_down);
  CHECK(crack.tortuosity() > 1);
  std::size_t counted = crack.points.size();
  for (const auto& b : crack.branches) counted += b.microcracks.size();
  CHECK(counted == static_cast<std::size_t>(connected));
}
