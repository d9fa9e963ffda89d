// How a specimen is set up: the square array, its pairs, the bonded contacts, the preset crack.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/mechanics/uniform_strain.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/setup/preset_crack.hpp>
#include <hfdem/setup/square_array.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

namespace {

using hfdem::Index;
using hfdem::Pair;
using hfdem::Side;
using hfdem::Vec2;
using test::near;

constexpr double R = 5e-3;

std::vector<Pair> all_pairs(const hfdem::Specimen& s) {
  std::vector<Pair> pairs;
  hfdem::FixedPairs(s, 0).for_each_pair([&](Pair p) { pairs.push_back(p); });
  return pairs;
}

/// The discs on both sides of the contacts that a preset crack cuts in a square array.
std::vector<Pair> cut(const hfdem::PresetCrack& crack, Vec2 centre, Vec2 direction,
                      int columns = 10, int rows = 8) {
  const auto specimen = hfdem::square_array(columns, rows, R);
  const auto contacts = hfdem::bonded_contacts<hfdem::FixedPairs>(specimen);
  std::vector<Pair> discs;
  for (const Index c : hfdem::preset_crack(crack, specimen, contacts, centre, direction))
    discs.push_back(contacts[c].bodies);
  return discs;
}

/// Side by side in row `row` of ten columns.
Pair across(Index column, Index row) { return {row * 10 + column, row * 10 + column + 1}; }
/// One above the other.
Pair above(Index column, Index row) { return {row * 10 + column, (row + 1) * 10 + column}; }

std::set<Pair> as_set(const std::vector<Pair>& pairs) { return {pairs.begin(), pairs.end()}; }

}  // namespace

TEST_CASE("a square array fills its box with equal discs") {
  const auto s = hfdem::square_array({.columns = 7, .rows = 5, .radius = R, .density = 2700});
  CHECK(s.size() == 7 * 5);
  CHECK(s.radius == std::vector<double>(35, R));
  CHECK(s.density == 2700);
  CHECK(s.width == near(7 * 2 * R));
  CHECK(s.height == near(5 * 2 * R));
  CHECK(s.centre[0].x == near(R));
  CHECK(s.centre[0].y == near(R));
  CHECK(s.centre[6].x == near(s.width - R));
  CHECK(s.centre[34].x == near(s.width - R));
  CHECK(s.centre[34].y == near(s.height - R));

  for (const Side side : hfdem::all_sides) {
    int touching = 0;
    for (Index i = 0; i < s.size(); ++i) {
      if (!s.touches(i, side)) continue;
      CHECK(std::abs(s.gap(i, side)) < 1e-9 * R);
      ++touching;
    }
    CHECK(touching == (hfdem::is_vertical(side) ? 5 : 7));
  }
}

TEST_CASE("a square array knows each pair of neighbours once") {
  const auto s = hfdem::square_array(7, 5, R);
  const auto pairs = all_pairs(s);
  CHECK(pairs.size() == 6 * 5 + 7 * 4);
  CHECK(as_set(pairs).size() == pairs.size());
  for (const Pair p : pairs) {
    CHECK(p.first < p.second);
    CHECK(std::abs(s.gap(p)) < 1e-9 * R);
  }
}

TEST_CASE("the bonded contacts are the sorted pairs within the bonding gap") {
  hfdem::Specimen s{.width = 9,
                    .height = 9,
                    .density = 1,
                    .centre = {{0, 0}, {3, 0}, {6.5, 0}, {0, 3.2}},
                    .radius = {1, 2, 1, 2},
                    .bonding_gap = 0.3,
                    .pairs = {{1, 2}, {0, 3}, {0, 1}}};
  const auto contacts = hfdem::bonded_contacts<hfdem::FixedPairs>(s);
  REQUIRE(contacts.size() == 2);  // 1-2 is 0.5 apart
  CHECK(contacts[0].bodies == Pair{0, 1});
  CHECK(contacts[1].bodies == Pair{0, 3});

  // The contact point halves the gap of 0.2: the arms are 1.1 and 2.1.
  const auto& f = contacts[1].frame;
  CHECK(f.normal_x == 0);
  CHECK(f.normal_y == 1);
  CHECK(f.arm_mean - f.arm_half_difference == near(1.1));
  CHECK(f.arm_mean + f.arm_half_difference == near(2.1));

  s.centre[3] = s.centre[0];
  CHECK_THROWS_AS(hfdem::bonded_contacts<hfdem::FixedPairs>(s), hfdem::InvalidParameter);
}

TEST_CASE("rounding of the coordinates leaves touching discs their exact arms") {
  for (const auto& c : hfdem::bonded_contacts<hfdem::FixedPairs>(hfdem::square_array(30, 20, R))) {
    CHECK(c.frame.arm_mean == R);
    CHECK(c.frame.arm_half_difference == 0);
    CHECK(c.frame.normal_x + c.frame.normal_y == 1);
  }
}

TEST_CASE("each disc on a side touches that side's platen, whose normal points out") {
  const auto s = hfdem::square_array(7, 5, R);
  const hfdem::Discs discs(s);
  const auto contacts = hfdem::platen_contacts(s, discs);
  CHECK(contacts.size() == 2 * 7 + 2 * 5);
  for (const auto& c : contacts) {
    const auto side = static_cast<Side>(c.bodies.second - discs.size());
    CHECK(discs.platen(side) == c.bodies.second);
    CHECK(s.touches(c.bodies.first, side));
    CHECK(Vec2{c.frame.normal_x, c.frame.normal_y} == hfdem::outward(side));
    CHECK(c.frame.arm_mean == 0);
    CHECK(c.frame.arm_half_difference == 0);
  }
}

TEST_CASE("a preset crack of an even number of contacts is centred on its domain") {
  const Vec2 middle{10 * R, 8 * R};
  const auto four = cut({.contacts = 4}, middle, {0, 1});
  CHECK(four.size() == 4);
  CHECK(as_set(four) == std::set<Pair>{across(4, 2), across(4, 3), across(4, 4), across(4, 5)});
  // The nearest first.
  CHECK(std::set<Pair>{four[0], four[1]} == std::set<Pair>{across(4, 3), across(4, 4)});
  CHECK(cut({.contacts = 0}, middle, {0, 1}).empty());
}

TEST_CASE("a preset crack runs through the injection, wherever that is, and where it is told to") {
  const Vec2 off_centre{6 * R, 6 * R};
  CHECK(as_set(cut({.contacts = 2}, off_centre, {0, 1})) ==
        std::set<Pair>{across(2, 2), across(2, 3)});
  CHECK(as_set(cut({.contacts = 2}, off_centre, {1, 0})) ==
        std::set<Pair>{above(2, 2), above(3, 2)});
}

TEST_CASE("a preset crack of a given length cuts what lies within it") {
  const Vec2 middle{10 * R, 8 * R};  // the contacts are R, 3 R and 5 R from it
  CHECK(cut({.length = 1.9 * R}, middle, {0, 1}).empty());
  CHECK(cut({.length = 2.1 * R}, middle, {0, 1}).size() == 2);
  CHECK(cut({.length = 9.9 * R}, middle, {0, 1}).size() == 4);
  CHECK(cut({.contacts = 2, .length = 10.1 * R}, middle, {0, 1}).size() == 6);
}

TEST_CASE("a preset crack longer than the specimen is refused") {
  const Vec2 middle{10 * R, 8 * R};
  CHECK(cut({.contacts = 8}, middle, {0, 1}).size() == 8);
  CHECK_THROWS_AS(cut({.contacts = 9}, middle, {0, 1}), hfdem::InvalidParameter);
}

TEST_CASE("a crack runs along the greater stress") {
  CHECK(hfdem::crack_direction({10e6, 12e6}) == Vec2{0, 1});
  CHECK(hfdem::crack_direction({12e6, 10e6}) == Vec2{1, 0});
  CHECK(hfdem::crack_direction({10e6, 10e6}) == Vec2{0, 1});
}

TEST_CASE("a uniform shortening moves discs and platens towards the centre in proportion") {
  const auto s = hfdem::square_array(6, 4, R);
  hfdem::Discs discs(s);
  hfdem::shorten(discs, {1e-3, 2e-3}, s.width, s.height);
  for (Index i = 0; i < discs.size(); ++i) {
    const hfdem::Pack moved = discs.displacement[i];
    CHECK(moved[0] == near(-1e-3 * (s.centre[i].x - 6 * R), 1e-6));
    CHECK(moved[1] == near(-2e-3 * (s.centre[i].y - 4 * R), 1e-6));
    CHECK(moved[2] == 0);
  }
  const auto platen = [&](Side side) {
    const hfdem::Pack moved = discs.displacement[discs.platen(side)];
    return Vec2{moved[0], moved[1]};
  };
  CHECK(platen(Side::left).x == near(6e-3 * R, 1e-6));
  CHECK(platen(Side::right).x == near(-6e-3 * R, 1e-6));
  CHECK(platen(Side::bottom).y == near(8e-3 * R, 1e-6));
  CHECK(platen(Side::top).y == near(-8e-3 * R, 1e-6));
  CHECK(platen(Side::top).x == 0);
}

TEST_CASE("discs have the mass and inertia of circles") {
  const hfdem::Discs discs(
      hfdem::square_array({.columns = 2, .rows = 2, .radius = 0.1, .density = 3000}));
  const double mass = 3000 * std::acos(-1.0) * 0.01;
  CHECK(discs.mass[3] == near(mass));
  CHECK(discs.inertia(3) == near(mass * 0.01 / 2));
}
