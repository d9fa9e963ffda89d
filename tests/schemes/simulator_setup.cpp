// What the simulator is made of: its mechanical step, injection, preset crack and contact points.
#include <cmath>
#include <set>
#include <utility>

#include <doctest/doctest.h>

#include "near.hpp"
#include "schemes/small_array.hpp"

namespace {

using hfdem::Index;
using hfdem::Vec2;
using test::Injected;
using test::near;
using test::radius;

/// The discs on both sides of the preset contacts.
std::set<std::pair<Index, Index>> preset(const Injected& sim) {
  std::set<std::pair<Index, Index>> discs;
  for (const Index c : sim.preset_contacts()) {
    const auto [first, second] = sim.contacts().bodies(c);
    discs.emplace(first, second);
    CHECK(sim.contacts().stiffness(c).bond == 0);
    CHECK(sim.network().is_wet(c));
  }
  return discs;
}

}  // namespace

TEST_CASE("the mechanical step is the asked-for part of the longest stable one") {
  const auto dt = [](hfdem::Mechanics mechanics) {
    return Injected(test::square(20), {.mechanics = mechanics}).mechanical_dt();
  };
  // With damping 0.7 the square array of discs of 5 mm is stable up to 1.64 us.
  const double longest = dt({.damping = 0.7, .step_fraction = 1});
  CHECK(longest < 1.64e-6);
  CHECK(longest > 1.64e-6 / 1.25);
  CHECK(dt({.damping = 0.7, .step_fraction = 0.4}) == near(0.4 * longest));
  CHECK(dt({.damping = 0.5, .step_fraction = 1}) == near(longest * std::sqrt(1.7 / 1.5)));
}

TEST_CASE(
    "without a position fluid enters the middle, and the crack lies across the least stress") {
  const Injected sim(test::square(10), {.in_situ = {10e6, 12e6}});
  const Vec2 entry = sim.network().geometry().centre[sim.network().injection_domain()];
  CHECK(entry.x == near(10 * radius));
  CHECK(entry.y == near(10 * radius));
  CHECK(sim.crack_direction() == Vec2{0, 1});
  CHECK(preset(sim) == std::set<std::pair<Index, Index>>{{34, 35}, {44, 45}, {54, 55}, {64, 65}});

  const Injected lying(test::square(10), {.in_situ = {12e6, 10e6}});
  CHECK(lying.crack_direction() == Vec2{1, 0});
  CHECK(preset(lying) == std::set<std::pair<Index, Index>>{{43, 53}, {44, 54}, {45, 55}, {46, 56}});
}

TEST_CASE("fluid enters the domain nearest to the position that is given") {
  const Injected sim(
      test::square(10),
      {.crack = {.contacts = 2}, .injection = {.position = Vec2{6.3 * radius, 7.8 * radius}}});
  const Vec2 entry = sim.network().geometry().centre[sim.network().injection_domain()];
  CHECK(entry.x == near(6 * radius));
  CHECK(entry.y == near(8 * radius));
  CHECK(preset(sim) == std::set<std::pair<Index, Index>>{{32, 33}, {42, 43}});
}

TEST_CASE("a contact point lies between its discs, by their radii") {
  hfdem::Specimen s{.width = 10e-3,
                    .height = 8e-3,
                    .density = 3000,
                    .centre = {{2e-3, 2e-3}, {7e-3, 2e-3}, {2e-3, 6e-3}, {7e-3, 6e-3}},
                    .radius = {2e-3, 3e-3, 2e-3, 3e-3},
                    .bonding_gap = 1e-9,
                    .pairs = {{0, 1}, {0, 2}, {1, 3}, {2, 3}}};
  const test::SquareRock<hfdem::Dry> sim(
      s,
      {.in_situ = {0, 0}, .crack = {.contacts = 0}, .injection = {.position = Vec2{4e-3, 4e-3}}});
  CHECK(sim.contact_point(0).x == near(4e-3));
  CHECK(sim.contact_point(0).y == near(2e-3));
  CHECK(sim.contact_point(1).x == near(2e-3));
  CHECK(sim.contact_point(1).y == near(4e-3));
}
