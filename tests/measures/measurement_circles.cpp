// Stress in measurement circles against what is known of it.
#include <cmath>
#include <complex>
#include <vector>

#include <hfdem/measure/measurement_circle.hpp>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "near.hpp"
#include "observe/two_sizes.hpp"
#include "schemes/small_array.hpp"

using hfdem::Index;
using hfdem::Vec2;
using hfdem::measure::circle_stress;
using hfdem::measure::CircleGrid;
using hfdem::measure::MeasurementCircle;
using hfdem::measure::stress_field;
using hfdem::measure::StressTensor;
using test::near;

namespace {

void check_equal(const StressTensor& s, const StressTensor& truth, double tolerance = 1e-12) {
  CHECK(s.xx == near(truth.xx, tolerance));
  CHECK(s.yy == near(truth.yy, tolerance));
  CHECK(s.xy == near(truth.xy, tolerance));
}

}  // namespace

TEST_CASE("a uniform stress is reproduced exactly, wherever the circles lie") {
  const auto specimen = test::two_sizes(20, 14);
  const StressTensor uniform{10e6, 12e6, -3e6};
  const std::vector<StressTensor> stress(specimen.size(), uniform);
  const auto field = stress_field(specimen, stress, {.spacing = 7e-3, .radius = 16e-3});
  CHECK(field.columns == 29);
  CHECK(field.rows == 20);
  REQUIRE(field.stress.size() == 580);
  for (const StressTensor& s : field.stress) check_equal(s, uniform);
}

TEST_CASE("a circle weighs its discs by their area and leaves out the others") {
  const hfdem::Specimen specimen{.width = 0.1,
                                 .height = 0.1,
                                 .centre = {{0.03, 0.05}, {0.06, 0.05}, {0.05, 0.09}},
                                 .radius = {10e-3, 20e-3, 10e-3}};
  const std::vector<StressTensor> stress{{1e6, 2e6, 5e5}, {6e6, 7e6, -5e5}, {1e9, 1e9, 1e9}};
  check_equal(circle_stress(specimen, stress, {{0.05, 0.05}, 0.03}), {5e6, 6e6, -3e5});
  check_equal(circle_stress(specimen, stress, {{0.03, 0.03}, 0.021}), stress[0]);
}

TEST_CASE("the field is what single circles at its points measure") {
  const auto specimen = test::two_sizes(16, 11);
  test::Random random(3);
  std::vector<StressTensor> stress(specimen.size());
  for (StressTensor& s : stress) s = {random(0, 2e7), random(0, 2e7), random(-5e6, 5e6)};
  for (const CircleGrid grid :
       {CircleGrid{10e-3, 15e-3}, CircleGrid{9e-3, 6e-3}, CircleGrid{1, 1}}) {
    const auto field = stress_field(specimen, stress, grid);
    CHECK(field.spacing.x * field.columns == near(specimen.width));
    CHECK(field.spacing.y * field.rows == near(specimen.height));
    CHECK(field.centre(0, 0).x == near(field.spacing.x / 2));
    for (Index row = 0; row < field.rows; ++row)
      for (Index column = 0; column < field.columns; ++column)
        check_equal(field.at(column, row),
                    circle_stress(specimen, stress, {field.centre(column, row), grid.radius}));
  }
}

TEST_CASE("circles that hold no disc, or make no grid, are refused") {
  const auto specimen = test::square(10);
  const std::vector<StressTensor> stress(specimen.size());
  CHECK_THROWS_WITH_AS(
      circle_stress(specimen, stress, {{0.05, 0.05}, 4e-3}),
      "circle.radius = 0.004 m is not allowed: it must be large enough to hold the "
      "centre of a disc around [0.05, 0.05] m",
      hfdem::InvalidParameter);
  CHECK_THROWS_AS(stress_field(specimen, stress, {.spacing = 9e-3, .radius = 1e-4}),
                  hfdem::InvalidParameter);
  CHECK_THROWS_WITH_AS(stress_field(specimen, stress, {.spacing = 0}),
                       "circles.spacing = 0 m is not allowed: it must be greater than 0 m",
                       hfdem::InvalidParameter);
}

TEST_CASE("circles in a settled specimen find the in-situ stress") {
  for (const auto& specimen : {test::square(30), test::two_sizes(24, 24)}) {
    const test::SquareRock<hfdem::Dry> sim(
        specimen, {.in_situ = {.xx = 10e6, .yy = 12e6}, .crack = {.contacts = 0}});
    const auto stress = hfdem::measure::particle_stress(sim);
    const Vec2 middle{specimen.width / 2, specimen.height / 2};
    for (const double radius : {30e-3, 50e-3, 90e-3}) {
      const StressTensor s = circle_stress(specimen, stress, {middle, radius});
      CHECK(s.xx == near(10e6, 0.01));
      CHECK(s.yy == near(12e6, 0.01));
      CHECK(std::abs(s.xy) < 0.1e6);
      CHECK(s.minor() == near(10e6, 0.01));
    }
  }
}

namespace {

/// What a pressurised crack adds to the stress in an infinite orthotropic plane, compression
/// positive; the crack lies on y = 0, |x| < a. S. G. Lekhnitskii's complex potentials, as G. C.
/// Sih, P. C. Paris, G. R. Irwin use them, Int. J. Fract. Mech. 1 (1965) 189-203.
class OrthotropicCrack {
 public:
  /// The array has nu = 0 and G = E / 5: mu^4 + 5 mu^2 + 1 = 0.
  OrthotropicCrack(double half_length, double pressure) : a_(half_length), p_(pressure) {}

  StressTensor at(double x, double y) const {
    using Complex = std::complex<double>;
    const Complex mu1{0, std::sqrt((5 - std::sqrt(21.0)) / 2)};
    const Complex mu2{0, std::sqrt((5 + std::sqrt(21.0)) / 2)};
    const auto phi = [&](Complex mu) {
      const Complex z = x + mu * y;
      return z / (std::sqrt(z - a_) * std::sqrt(z + a_)) - 1.0;
    };
    const Complex phi1 = phi(mu1), phi2 = phi(mu2), share = p_ / (mu1 - mu2);
    const double tension_x = std::real(mu1 * mu2 * share * (mu2 * phi2 - mu1 * phi1));
    const double tension_y = std::real(share * (mu1 * phi2 - mu2 * phi1));
    const double shear = std::real(mu1 * mu2 * share * (phi1 - phi2));
    return {-tension_x, -tension_y, -shear};
  }

 private:
  double a_, p_;
};

}  // namespace

TEST_CASE("a pressurised slit presses its flanks and relieves what lies ahead as a crack does") {
  constexpr double half_length = 0.1, lower = 11e6, rise = 2e6;
  test::SquareRock<hfdem::HeldPressure> sim(test::square(140),
                                            {.contact = {.tensile_strength = 1e9, .cohesion = 1e9},
                                             .in_situ = {.xx = 10e6, .yy = 12e6},
                                             .crack = {.contacts = 20},
                                             .scheme = {.unbalanced_tolerance = 1e-5}});
  const auto held_at = [&](double pressure) {
    sim.pressure_scheme().hold(pressure);
    REQUIRE(sim.step().converged);
    return hfdem::measure::particle_stress(sim);
  };
  // What a rise of the pressure adds: the fluid's mere presence adds to the stress at the tips.
  const auto before = held_at(lower);
  auto added = held_at(lower + rise);
  std::vector<StressTensor> truth;
  const auto& specimen = sim.specimen();
  const Vec2 middle{specimen.width / 2, specimen.height / 2};
  const OrthotropicCrack crack(half_length, rise);
  for (std::size_t i = 0; i < added.size(); ++i) {
    added[i] = {added[i].xx - before[i].xx, added[i].yy - before[i].yy, added[i].xy - before[i].xy};
    const Vec2 from_middle = specimen.centre[i] - middle;
    const StressTensor turned = crack.at(from_middle.y, from_middle.x);
    truth.push_back({turned.yy, turned.xx, turned.xy});
  }

  // At a half-length and more from the crack; the plate, seven times as wide as the crack is long,
  // adds a few per cent of the pressure.
  for (const Vec2 at : {Vec2{1, 0}, Vec2{1.5, 0}, Vec2{2, 0}, Vec2{0, 1.5}, Vec2{0, 2}, Vec2{1, -2},
                        Vec2{-1, 1.5}, Vec2{-2, -1}, Vec2{1.5, -0.5}}) {
    CAPTURE(at.x);
    CAPTURE(at.y);
    const MeasurementCircle circle{middle + half_length * at, 25e-3};
    const StressTensor measured = circle_stress(specimen, added, circle);
    const StressTensor expected = circle_stress(specimen, truth, circle);
    CHECK(std::abs(measured.xx - expected.xx) < 0.03 * rise);
    CHECK(std::abs(measured.yy - expected.yy) < 0.03 * rise);
    CHECK(std::abs(measured.xy - expected.xy) < 0.03 * rise);
    if (at.y == 0) CHECK(measured.xx == near(expected.xx, at.x < 1.2 ? 0.015 : 0.04));
  }
}
