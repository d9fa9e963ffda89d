// Modulus and toughness of random rock, on readings made up from a known one.
#include <cmath>
#include <numbers>
#include <vector>

#include <hfdem/analytic/plate.hpp>
#include <hfdem/measure/running_crack.hpp>
#include <hfdem/measure/slit_modulus.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

using namespace hfdem;
using std::numbers::pi;

namespace {

constexpr double E_prime = 31e9, closing = 0.7e6, K = 2.2e6;
// Another modulus: only the factors of the plate count.
const analytic::CrackedPlate plate{1, analytic::isotropic_plane(20e9, 0.2),
                                   analytic::PlateSides::rigid};

using test::near;

/// Mean opening of an ellipse of half-length a within `reach`, by the midpoint rule.
double ellipse_mean(double a, double reach) {
  constexpr int parts = 20000;
  double sum = 0;
  for (int k = 0; k < parts; ++k) {
    const double x = reach * (k + 0.5) / parts;
    sum += std::sqrt(1 - x * x / (a * a)) / parts;
  }
  return sum;
}

/// A slit that obeys the plate with the known modulus and closing pressure.
measure::SlitTest made_up(double a, double reach) {
  const auto f = plate.factors(2 * a);
  std::vector<Vec2> openings, volumes;
  for (const double p : {2e6, 3e6, 5e6}) {
    volumes.push_back({p, 2 * pi * a * a * (p - closing) * f.volume / E_prime});
    openings.push_back({p, 4 * a * (p - closing) * f.width / E_prime * ellipse_mean(a, reach)});
  }
  measure::SlitTest slit{.half_length = a};
  slit.volume = measure::Line::through(volumes);
  slit.opening = measure::Line::through(openings);
  return slit;
}

}  // namespace

TEST_CASE("slits made up from a rock give its modulus and closing pressure back") {
  const double reach = 0.03;
  const auto modulus =
      slit_modulus(std::vector{made_up(0.05, reach), made_up(0.2, reach)}, plate, reach);
  CHECK(modulus.E_prime == near(E_prime));
  CHECK(modulus.E_prime_from_opening == near(E_prime, 1e-6));
  CHECK(modulus.closing_excess == near(closing));
  CHECK(modulus.E_prime_spread < 1e-9);
  for (const auto& reading : modulus.readings) CHECK(reading.E_prime == near(E_prime));
}

TEST_CASE("a stiffer slit shows in the spread, and in the mean") {
  auto stiff = made_up(0.2, 0);
  stiff.volume.slope /= 1.2, stiff.volume.intercept /= 1.2;
  const auto modulus = slit_modulus(std::vector{made_up(0.1, 0), stiff}, plate);
  CHECK(modulus.E_prime == near(1.1 * E_prime));
  CHECK(modulus.E_prime_spread == near(0.2 / 1.1));
  CHECK(modulus.closing_excess == near(closing));
}

TEST_CASE("a crack that runs at one stress intensity has that toughness, whatever its length") {
  std::vector<measure::CrackInstant> crack;
  const auto at = [&](double length, double k) {
    const double net = k / (plate.factors(length).toughness * std::sqrt(pi * length / 2));
    crack.push_back({0, 0.6 * length, 0.4 * length, net + closing, 0});
  };
  for (const double length : {0.25, 0.3, 0.45, 0.55}) at(length, 0.9 * K), at(length, 1.1 * K);
  at(0.1, 9 * K), at(0.7, 9 * K);  // out of range
  const auto toughness = running_toughness(crack, plate, {.from = 0.2, .to = 0.6}, closing);
  CHECK(toughness.steps == 8);
  CHECK(toughness.K == near(K));
  CHECK(toughness.deviation == near(0.1 * K * std::sqrt(8.0 / 7)));
  CHECK(running_toughness(crack, plate, {}).K > 1.1 * K);  // above the in-situ stress
  CHECK(running_toughness(crack, plate, {.from = 0.65, .to = 0.75}, closing).K == near(9 * K));
}

TEST_CASE("no crack in the range is no toughness") {
  CHECK(measure::running_toughness({{0, 0.05, 0.05, 1e6, 0}}, plate, {}).steps == 0);
}

TEST_CASE("slits and lengths that are no range are refused") {
  CHECK(measure::HeldSlits{}.lengths() == std::vector{0.2, 0.30000000000000004, 0.4});
  CHECK(measure::HeldSlits{}.net_pressures() == std::vector{2e6, 3e6, 4e6});
  CHECK_THROWS_WITH_AS((measure::HeldSlits{.shortest = 0.4}.check()),
                       doctest::Contains("slits.longest = 0.4 m"), InvalidParameter);
  CHECK_THROWS_WITH_AS((measure::HeldSlits{.lowest_pressure = 5e6}.check()),
                       doctest::Contains("slits.highest_pressure = 4e+06 Pa"), InvalidParameter);
  CHECK_THROWS_WITH_AS((measure::RunningRange{.from = 0.6}.check()),
                       doctest::Contains("running.to = 0.6"), InvalidParameter);
}
