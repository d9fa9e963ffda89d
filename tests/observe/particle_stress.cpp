// The stress of discs against what holds the specimen, and against sums over single contacts.
#include <algorithm>
#include <cmath>
#include <vector>

#include <hfdem/measure/particle_stress.hpp>

#include <doctest/doctest.h>

#include "near.hpp"
#include "observe/two_sizes.hpp"
#include "schemes/small_array.hpp"

namespace {

using hfdem::Index;
using hfdem::Vec2;
using hfdem::measure::StressTensor;
using test::near;

using Dry = test::SquareRock<hfdem::Dry>;
using Held = test::SquareRock<hfdem::HeldPressure>;

template <class Sim>
StressTensor mean_stress(const Sim& sim) {
  const auto stress = hfdem::measure::particle_stress(sim);
  const hfdem::measure::CellArea area(sim.specimen());
  StressTensor sum;
  double whole = 0;
  for (std::size_t i = 0; i < stress.size(); ++i) {
    const double a = area(sim.discs().radius[i]);
    whole += a;
    sum.xx += a * stress[i].xx;
    sum.yy += a * stress[i].yy;
    sum.xy += a * stress[i].xy;
  }
  CHECK(whole == near(sim.specimen().width * sim.specimen().height));
  return {sum.xx / whole, sum.yy / whole, sum.xy / whole};
}

}  // namespace

TEST_CASE("every disc of an intact square array carries the in-situ stress") {
  for (const auto kind : {hfdem::BoundaryKind::servo, hfdem::BoundaryKind::dead_loads}) {
    const Dry sim(test::square(12), {.boundary = {.kind = kind},
                                     .in_situ = {.xx = 10e6, .yy = 12e6},
                                     .crack = {.contacts = 0},
                                     .mechanics = {.settle_tolerance = 1e-6}});
    for (const StressTensor& s : hfdem::measure::particle_stress(sim)) {
      CHECK(s.xx == near(10e6, 1e-5));
      CHECK(s.yy == near(12e6, 1e-5));
      CHECK(std::abs(s.xy) < 100);
      CHECK(s.major() == near(s.yy));
      CHECK(s.minor() == near(s.xx));
    }
  }
}

TEST_CASE("the mean over all cells is the stress on the sides, whatever the pressure in a crack") {
  for (const auto& specimen : {test::square(16), test::two_sizes(16, 12)})
    for (const auto kind : {hfdem::BoundaryKind::servo, hfdem::BoundaryKind::dead_loads})
      for (const double pressure : {0.0, 8e6, 16e6}) {
        Held sim(specimen, {.contact = {.tensile_strength = 1e9, .cohesion = 1e9},
                            .boundary = {.kind = kind},
                            .in_situ = {.xx = 10e6, .yy = 12e6},
                            .mechanics = {.settle_tolerance = 1e-6},
                            .scheme = {.pressure = pressure}});
        REQUIRE(sim.step().converged);
        const StressTensor mean = mean_stress(sim);
        CHECK(mean.xx == near(10e6, 1e-5));
        CHECK(mean.yy == near(12e6, 1e-5));
        // Platens may press skewly on a specimen that is not its own mirror image.
        if (kind == hfdem::BoundaryKind::dead_loads) CHECK(std::abs(mean.xy) < 1e3);
      }
}

TEST_CASE("the fluid's pressure is the stress across the wall of a long slit") {
  Held sim(test::square(40), {.contact = {.tensile_strength = 1e9, .cohesion = 1e9},
                              .in_situ = {.xx = 10e6, .yy = 12e6},
                              .crack = {.contacts = 24},
                              .scheme = {.pressure = 14e6}});
  REQUIRE(sim.step().converged);
  const auto stress = hfdem::measure::particle_stress(sim);
  for (const std::size_t column : {19U, 20U})
    for (std::size_t row = 16; row < 24; ++row)
      CHECK(stress[row * 40 + column].xx == near(14e6, 2e-3));
}

TEST_CASE("a dry disc's tensor is the sum over its contacts of arm times force") {
  Held sim(test::two_sizes(12, 12), {.contact = {.tensile_strength = 1e9, .cohesion = 1e9},
                                     .scheme = {.pressure = 20e6, .unbalanced_tolerance = 1e-8}});
  REQUIRE(sim.step().converged);
  const auto& discs = sim.discs();
  const auto stress = hfdem::measure::particle_stress(sim);
  const double width = sim.specimen().width;
  const auto wet = sim.network().pushed_discs();
  double largest_shear = 0;
  int compared = 0;
  for (Index i = 0; i < discs.size(); ++i) {
    const auto [x, y] = discs.centre[i];
    const bool rim = std::min({x, y, width - x, width - y}) < 1.1 * discs.radius[i];
    if (rim || std::find(wet.begin(), wet.end(), i) != wet.end()) continue;
    StressTensor sum;
    for (Index c = 0; c < sim.contacts().size(); ++c) {
      const auto [first, second] = sim.contacts().bodies(c);
      if (first != i && second != i) continue;
      const Vec2 between = discs.centre[second] - discs.centre[first];
      const Vec2 normal = (1 / norm(between)) * between;
      const auto reaction = sim.contacts().response(c, discs.displacement).reaction();
      const Vec2 on_second = reaction.normal * normal + reaction.shear * left_of(normal);
      const Vec2 force = first == i ? -on_second : on_second;
      const Vec2 arm = (first == i ? discs.radius[i] : -discs.radius[i]) * normal;
      sum.xx -= arm.x * force.x;
      sum.yy -= arm.y * force.y;
      sum.xy -= (arm.x * force.y + arm.y * force.x) / 2;
    }
    double squares = 0;
    for (const double r : discs.radius) squares += r * r;
    const double area = width * width * discs.radius[i] * discs.radius[i] / squares;
    CHECK(std::abs(stress[i].xx - sum.xx / area) < 1e3);
    CHECK(std::abs(stress[i].yy - sum.yy / area) < 1e3);
    CHECK(std::abs(stress[i].xy - sum.xy / area) < 1e3);
    largest_shear = std::fmax(largest_shear, std::abs(sum.xy / area));
    ++compared;
  }
  CHECK(compared > 100);
  CHECK(largest_shear > 1e6);  // else the check of xy would say nothing
}

TEST_CASE("principal stresses are those of Mohr's circle") {
  // Stresses of 5 and 1 along axes that are turned by 30 degrees.
  const double c = std::sqrt(3.0) / 2, s = 0.5;
  const StressTensor turned{5 * c * c + s * s, 5 * s * s + c * c, (5 - 1) * s * c};
  CHECK(turned.major() == near(5));
  CHECK(turned.minor() == near(1));
}
