// Slits held open by a given pressure: absolute values, nothing fitted.
#include <hfdem/hfdem.hpp>

#include <doctest/doctest.h>

#include "near.hpp"
#include "truth/static_lattice.hpp"

using namespace hfdem;

namespace {

using Slit = Simulator<LinearParallelBond, HyperbolicAperture, HeldPressure, FixedPairs>;

using test::near;

constexpr double closing = 10e6;

/// @param tolerance of equilibrium: 5e-5 leaves 0.1 % in the pressure of a break
Slit slit(int contacts, double tolerance) {
  return Slit{square_array({}),
              {.crack = {.contacts = contacts}, .scheme = {.unbalanced_tolerance = tolerance}}};
}

double opening_at(Slit& sim, double net_pressure) {
  sim.pressure_scheme().hold(closing + net_pressure);
  sim.step();
  return measure::crack_shape(sim).opening;
}

/// Net pressure at first break: up to `start` in one go, then in steps of half a per cent.
double first_break(Slit& sim, double start) {
  double net = start;
  opening_at(sim, net);
  REQUIRE_MESSAGE(sim.breaks().empty(), "the slit broke before the ramp");
  while (sim.breaks().empty()) opening_at(sim, net *= 1.005);
  return net;
}

struct Target {
  int contacts;
  double net_pressure, tolerance;
};
constexpr Target targets[] = {{10, 4.649e6, 0.01}, {20, 3.163e6, 0.01}, {30, 2.521e6, 0.01},
                              {40, 2.109e6, 0.01}, {60, 1.487e6, 0.02}, {80, 0.928e6, 0.02}};

}  // namespace

TEST_SUITE("slits") {
  TEST_CASE("the independent static solution gives the pressures of first break") {
    for (const Target& t : targets) {
      CAPTURE(t.contacts);
      CHECK(truth::StaticSlit({}, t.contacts).at_first_break().net_pressure ==
            near(t.net_pressure, 2e-3));
    }
  }

  TEST_CASE("the explicit code gives the pressures of first break") {
    for (const Target& t : targets) {
      CAPTURE(t.contacts);
      Slit sim = slit(t.contacts, 5e-5);
      const double net = first_break(sim, (1 - 2 * t.tolerance) * t.net_pressure);
      MESSAGE(t.contacts << " contacts: " << net / 1e6 << " MPa, target " << t.net_pressure / 1e6);
      CHECK(net == near(t.net_pressure, t.tolerance));
      CHECK(sim.breaks().size() == 2);
      for (const BondBreak& b : sim.breaks()) CHECK(b.mode == Mode::tension);
    }
  }

  TEST_CASE("opening against pressure has the slope and intercept of the static solution") {
    for (const int contacts : {20, 40}) {
      CAPTURE(contacts);
      Slit sim = slit(contacts, 1e-6);
      truth::StaticSlit exact({}, contacts);
      const double broken = exact.at_first_break().net_pressure;
      const double low = 0.7 * broken, high = 0.95 * broken;
      const double ours_low = opening_at(sim, low), ours_high = opening_at(sim, high);
      const double exact_low = exact.at_pressure(closing + low).opening;
      const double exact_high = exact.at_pressure(closing + high).opening;
      const double slope = (ours_high - ours_low) / (high - low);
      const double exact_slope = (exact_high - exact_low) / (high - low);
      CHECK(slope == near(exact_slope, 1e-3));
      CHECK(ours_low - slope * low == near(exact_low - exact_slope * low, 0.005));
      CHECK(ours_low == near(exact_low, 1e-3));
      CHECK(ours_high == near(exact_high, 1e-3));
      CHECK(sim.network().crack_volume() == near(exact.at_pressure(closing + high).volume, 1e-3));
    }
  }
}
