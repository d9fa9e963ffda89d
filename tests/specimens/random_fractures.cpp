// Random natural fractures: their lengths, angles and distances, and sets that find no room.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <hfdem/setup/random_fractures.hpp>

#include <doctest/doctest.h>

#include "refusal.hpp"

using namespace hfdem;

namespace {

/// Distance of a point from a segment: to an end, or along the normal.
double from_segment(Vec2 p, const NaturalFracture& f) {
  const double along = dot(p - f.from, f.direction());
  if (along < 0) return norm(p - f.from);
  if (along > f.length()) return norm(p - f.to);
  return std::abs(cross(p - f.from, f.direction()));
}

bool meet(const NaturalFracture& a, const NaturalFracture& b) {
  const auto parts = [](const NaturalFracture& f, const NaturalFracture& g) {
    const Vec2 d = f.to - f.from;
    return cross(d, g.from - f.from) * cross(d, g.to - f.from) <= 0;
  };
  return parts(a, b) && parts(b, a);
}

double apart(const NaturalFracture& a, const NaturalFracture& b) {
  if (meet(a, b)) return 0;
  return std::min({from_segment(a.from, b), from_segment(a.to, b), from_segment(b.from, a),
                   from_segment(b.to, a)});
}

/// The least distance between any two.
double least_distance(const std::vector<NaturalFracture>& set) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < set.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::fmin(least, apart(set[i], set[j]));
  return least;
}

/// From the x axis, deg; 0 to 180.
double angle(const NaturalFracture& f) {
  const Vec2 d = f.to - f.from;
  const double a = std::atan2(d.y, d.x) * 180 / std::numbers::pi;
  return a < 0 ? a + 180 : a;
}

/// Values that are uniform in a range: none outside, the ends nearly reached, the mean within four
/// standard errors.
void check_uniform(const std::vector<double>& values, double low, double high) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  const double width = high - low;
  CHECK(*least >= low - 1e-9 * high);
  CHECK(*greatest <= high * (1 + 1e-9));
  CHECK(*least < low + 0.05 * width);
  CHECK(*greatest > high - 0.05 * width);
  double sum = 0;
  for (const double v : values) sum += v;
  const auto count = static_cast<double>(values.size());
  CHECK(std::abs(sum / count - (low + high) / 2) < 4 * width / std::sqrt(12 * count));
}

std::string said_of(const RandomFractures& p) {
  return refusal([&] { random_fractures(p, 1, 1); });
}

}  // namespace

TEST_CASE("a crowded set keeps its distances to each other, to the rim and to the injection") {
  const RandomFractures p{.count = 60,
                          .shortest = 0.05,
                          .longest = 0.2,
                          .angle = 80,
                          .angle_spread = 90,
                          .spacing = 0.02,
                          .margin = 0.03,
                          .clearance = 0.15};
  const Vec2 injection{0.4, 0.7};
  const auto set = random_fractures(p, 1.2, 0.9, injection);
  REQUIRE(set.size() == 60);
  const double spacing = least_distance(set);
  CHECK(spacing >= p.spacing);
  CHECK(spacing < 1.1 * p.spacing);
  double margin = 1, clearance = 1;
  for (const NaturalFracture& f : set) {
    for (const Vec2 end : {f.from, f.to})
      margin = std::min({margin, end.x, 1.2 - end.x, end.y, 0.9 - end.y});
    clearance = std::fmin(clearance, from_segment(injection, f));
  }
  CHECK(margin >= p.margin - 1e-12);
  CHECK(margin < p.margin + 0.02);
  CHECK(clearance >= p.clearance);
  CHECK(clearance < p.clearance + 0.03);
}

TEST_CASE("by default the injection is in the middle") {
  const auto set = random_fractures({.count = 30, .clearance = 0.3}, 2, 1);
  for (const NaturalFracture& f : set) CHECK(from_segment({1, 0.5}, f) >= 0.3);
}

TEST_CASE("lengths and angles are uniform in their ranges, in both families") {
  for (const bool conjugate : {false, true}) {
    const auto set = random_fractures({.count = 500,
                                       .shortest = 0.1,
                                       .longest = 0.5,
                                       .angle = 50,
                                       .angle_spread = 20,
                                       .conjugate = conjugate},
                                      30, 20);
    std::vector<double> lengths, angles, mirrored;
    for (const NaturalFracture& f : set) {
      lengths.push_back(f.length());
      (angle(f) < 90 ? angles : mirrored).push_back(angle(f));
    }
    check_uniform(lengths, 0.1, 0.5);
    check_uniform(angles, 30, 70);
    CHECK(mirrored.size() == (conjugate ? 250 : 0));
    if (conjugate) check_uniform(mirrored, 110, 150);
  }
}

TEST_CASE("the same seed gives the same set, another seed another one") {
  const auto same = [](const RandomFractures& p, const RandomFractures& q) {
    const auto a = random_fractures(p, 1, 1), b = random_fractures(q, 1, 1);
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& f, const auto& g) {
      return f.from == g.from && f.to == g.to;
    });
  };
  CHECK(same({.seed = 3}, {.seed = 3}));
  CHECK_FALSE(same({.seed = 3}, {.seed = 4}));
}

TEST_CASE("fractures without a spacing do not cross all the same") {
  const auto set = random_fractures({.count = 40, .spacing = 0, .margin = 0}, 1, 1);
  CHECK(least_distance(set) > 0);
}

TEST_CASE("a set that finds no room is refused with the number that did") {
  // Each fracture keeps a strip of its length and of twice half the spacing for itself.
  const RandomFractures p{.count = 1000};
  const std::string said = said_of(p),
                    start = "fractures.count = 1000 is not allowed: it must be at most ";
  REQUIRE(said.find(start) == 0);
  const int placed = std::stoi(said.substr(start.size()));
  CHECK(placed >= 18);
  CHECK(placed < 1 / (p.shortest * p.spacing));
  CHECK(said == start + std::to_string(placed) +
                    ": 10000 random places for one more, of a length from 0.15 m to 0.25 m, did "
                    "not leave a spacing of 0.03 m, a margin of 0.02 m and a clearance of 0.06 m");
  CHECK(said_of({.count = placed}) == "accepted");
  CHECK(said_of({.count = placed + 1}) != "accepted");
  CHECK(said_of({.shortest = 1.5, .longest = 1.5}).find("it must be at most 0: ") !=
        std::string::npos);
  CHECK(said_of({.clearance = 0.7}).find("it must be at most 0: ") != std::string::npos);
}

TEST_CASE("bad fields of a random set are named with their values and what is allowed") {
  CHECK(said_of({.count = 0}) ==
        "fractures.count = 0 is not allowed: it must be at least 1 and at most 1e+05");
  CHECK(said_of({.shortest = 0.3}) ==
        "fractures.shortest = 0.3 m is not allowed: it must be at most longest, which is 0.25 m");
  CHECK(said_of({.spacing = -0.1}) ==
        "fractures.spacing = -0.1 m is not allowed: it must be at least 0 m");
}
