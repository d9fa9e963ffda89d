// Flow into intact lattice from a wall of constant pressure, against the closed forms.
#include "leakoff/half_plane.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <doctest/doctest.h>

#include "near.hpp"

namespace {

using hfdem::Euler;
using test::HalfPlane;
using test::near;

/// When pressure has reached so many domains.
double time_of(const HalfPlane& strip, double domains) {
  return std::pow(domains * HalfPlane::spacing, 2) / strip.exact().diffusivity;
}

/// Largest difference from the closed form of full pores, over the wall's pressure.
double worst(const HalfPlane& strip, double time) {
  double worst = 0;
  const auto row = strip.pressures();
  for (std::size_t k = 1; k < row.size(); ++k)
    worst =
        std::fmax(worst, std::abs(row[k] - strip.exact().saturated(
                                               HalfPlane::spacing * static_cast<double>(k), time)));
  return worst / HalfPlane::pressure;
}

double last_of(int steps) {
  HalfPlane strip(60, 1);
  strip.run(time_of(strip, 5), steps, Euler::backward);
  return strip.pressures()[5];
}

}  // namespace

TEST_SUITE_BEGIN("half_plane");

TEST_CASE("pressure enters full pores by the closed form of diffusion") {
  for (const Euler euler : {Euler::forward, Euler::backward}) {
    CAPTURE(static_cast<int>(euler));
    HalfPlane strip(120, 1);
    const double time = time_of(strip, 10);
    const double lost = strip.run(time, 2000, euler);
    const auto row = strip.pressures();
    for (std::size_t k = 1; k < row.size(); ++k) {
      const double exact =
          strip.exact().saturated(HalfPlane::spacing * static_cast<double>(k), time);
      if (exact < 0.05 * HalfPlane::pressure) break;
      CHECK(row[k] == near(exact, 0.02));
    }
    // What the wall's own domains would have gained, half a spacing, they do not.
    const double pores =
        strip.exact().gained(time) / HalfPlane::spacing - HalfPlane::pressure / 2e9 / 2;
    CHECK(lost == near(pores * HalfPlane::pore() * HalfPlane::rows, 0.02));
    CHECK(strip.rock.leaked() == near(lost, 1e-12));
  }
}

TEST_CASE("flow into full pores is of first order in time and of second in space") {
  // Against the next: differences of successive halvings.
  const double a = last_of(50), b = last_of(100), c = last_of(200);
  const double order = std::log2(std::abs((a - b) / (b - c)));
  CHECK(order > 0.9);
  CHECK(order < 1.1);
  HalfPlane coarse(60, 1), fine(120, 1);
  const double time = time_of(coarse, 5), same = time_of(fine, 10);
  // Steps so short that only the lattice counts; both explicit, whose limit falls with its square.
  coarse.run(time, 20000, Euler::forward);
  fine.run(same, 20000, Euler::forward);
  const double in_space = std::log2(worst(coarse, time) / worst(fine, same));
  CHECK(in_space > 1.8);
  CHECK(in_space < 2.2);
}

TEST_CASE("a front fills dry pores by its similarity solution") {
  for (const double domains : {15.0, 30.0}) {
    CAPTURE(domains);
    HalfPlane strip(80, 0);
    const auto exact = strip.exact();
    const double time = time_of(strip, domains / (2 * exact.front_constant()));
    const double lost = strip.run(time, 4000, Euler::backward);
    // Of the wall's own domains the half belongs to the half-plane.
    CHECK((strip.filled() + 0.5) * HalfPlane::spacing == near(exact.front(time), 0.02));
    const auto row = strip.pressures();
    for (std::size_t k = 1; k < row.size() / 2; ++k) {
      const double x = HalfPlane::spacing * static_cast<double>(k);
      if (x > 0.8 * exact.front(time)) break;
      CHECK(row[k] == near(exact.dry(x, time), 0.02));
    }
    CHECK(strip.rock.leaked() == near(lost, 1e-12));
  }
}

TEST_CASE("pores fill before they have a pressure") {
  HalfPlane strip(40, 0.5);
  HalfPlane dry(40, 0);
  const double time = time_of(strip, 40);
  strip.run(time, 500, Euler::backward);
  dry.run(time, 500, Euler::backward);
  const auto row = strip.pressures();
  const auto& g = strip.network.geometry();
  int full = 0, empty = 0;
  for (hfdem::Index d = 0; d < g.centre.size(); ++d) {
    if (g.centre[d].x < 1.5 * HalfPlane::spacing) continue;
    const double filling = strip.rock.filling(strip.network, d);
    CHECK(filling >= 0.5);
    CHECK(filling <= 1);
    if (strip.network.pressure(d) > 0) {
      CHECK(filling == 1);
      ++full;
    }
    if (filling < 1) CHECK(strip.network.pressure(d) == 0);
    empty += filling == 0.5;
  }
  CHECK(full > 10);
  CHECK(empty > 10);
  // Half as much to fill: the front is farther by the square root of two.
  const auto advanced = [](const HalfPlane& s, double saturation) {
    const double pores = 39;
    return (s.filled() - saturation * pores) / (1 - saturation) + 0.5;
  };
  CHECK(advanced(strip, 0.5) / advanced(dry, 0) == near(std::sqrt(2), 0.03));
}

TEST_SUITE_END();
