// Irregular cracks with known answers.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <hfdem/measure/crack_path.hpp>
#include <hfdem/measure/path_profile.hpp>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "measures/made_up_crack.hpp"
#include "near.hpp"

using hfdem::Index;
using hfdem::Vec2;
using hfdem::measure::CrackPath;
using test::MadeUpCrack;
using test::near;

namespace {

const double sqrt2 = std::sqrt(2.0);
constexpr double mm = 1e-3;

std::vector<Vec2> steps(std::size_t count, Vec2 step) { return {count, step}; }

/// To the right and to the left by turns.
std::vector<Vec2> zigzag(std::size_t count, Vec2 step) {
  std::vector<Vec2> all;
  for (std::size_t k = 0; k < count; ++k) all.push_back({k % 2 ? -step.x : step.x, step.y});
  return all;
}

std::vector<std::size_t> on_path(const CrackPath& crack) {
  std::vector<std::size_t> places;
  for (const auto& p : crack.points) places.push_back(p.microcrack);
  return places;
}

}  // namespace

TEST_CASE("a straight crack has a tortuosity of one and no branches") {
  MadeUpCrack made({0.5, 0.5});
  made.grow(steps(4, {0, 10 * mm}));
  made.grow(steps(4, {0, -10 * mm}));
  const CrackPath crack = made.measured();
  CHECK(crack.up.reach == near(40 * mm));
  CHECK(crack.down.reach == near(40 * mm));
  CHECK(crack.up.tip.y == near(0.54));
  CHECK(crack.down.tip.y == near(0.46));
  CHECK(crack.tip_distance() == near(80 * mm));
  CHECK(crack.path_length == near(80 * mm));
  CHECK(crack.connected_length() == near(80 * mm));
  CHECK(crack.tortuosity() == near(1));
  CHECK(crack.path_tortuosity() == near(1));
  CHECK(crack.mean_tortuosity() == near(1));
  CHECK(crack.asymmetry() < 1e-12);
  CHECK(crack.branches.empty());
  // From the lower tip to the upper, whatever the order in which the bonds broke.
  CHECK(on_path(crack) == std::vector<std::size_t>{7, 6, 5, 4, 0, 1, 2, 3});
  for (std::size_t k = 0; k < 8; ++k) {
    const double middle = (static_cast<double>(k) - 3.5) * 10 * mm;
    CHECK(crack.points[k].arc == near(middle));
    CHECK(crack.points[k].along == near(middle));
  }
}

TEST_CASE("a zigzag of 45 degrees has a tortuosity of the square root of two") {
  for (const Vec2 direction : {Vec2{0, 1}, Vec2{1, 0}}) {
    MadeUpCrack made({0.5, 0.5}, direction);
    for (const double sign : {1.0, -1.0}) {
      auto chain = zigzag(6, {5 * mm, sign * 5 * mm});
      if (direction.x > 0)
        for (Vec2& v : chain) v = {v.y, v.x};
      made.grow(chain);
    }
    const CrackPath crack = made.measured();
    CHECK(crack.tip_distance() == near(60 * mm));
    CHECK(crack.path_length == near(60 * mm * sqrt2));
    CHECK(crack.tortuosity() == near(sqrt2));
    CHECK(crack.mean_tortuosity() == near(sqrt2));
    CHECK(crack.points.back().arc == near(5.5 * 5 * mm * sqrt2));
    CHECK(crack.points.back().along == near(27.5 * mm));
    CHECK(crack.asymmetry() < 1e-12);
  }
}

TEST_CASE("unequal wings: asymmetry by their reaches, mean tortuosity of the two directions") {
  MadeUpCrack made;
  made.grow(steps(5, {0, 10 * mm}));
  made.grow(zigzag(6, {5 * mm, -5 * mm}));
  const CrackPath crack = made.measured();
  CHECK(crack.up.reach == near(50 * mm));
  CHECK(crack.down.reach == near(30 * mm));
  CHECK(crack.asymmetry() == near(0.25));
  CHECK(crack.up.tortuosity() == near(1));
  CHECK(crack.down.tortuosity() == near(sqrt2));
  CHECK(crack.mean_tortuosity() == near((1 + sqrt2) / 2));
  CHECK(crack.tortuosity() == near((50 + 30 * sqrt2) / 80));
}

TEST_CASE("a slanting crack is as long as the line between its ends, not as that line's height") {
  MadeUpCrack made;
  made.grow(steps(4, {3 * mm, 4 * mm}));
  made.grow(steps(2, {-3 * mm, -4 * mm}));
  const CrackPath crack = made.measured();
  CHECK(crack.up.reach == near(16 * mm));
  CHECK(crack.up.distance == near(20 * mm));
  CHECK(crack.tip_distance() == near(30 * mm));
  CHECK(crack.tortuosity() == near(1));
  CHECK(crack.mean_tortuosity() == near(1));
}

TEST_CASE("what leaves the path is a branch: its length counts, its way does not") {
  MadeUpCrack made;
  made.grow(steps(6, {0, 10 * mm}));
  made.grow(steps(6, {0, -10 * mm}));
  // Domains 1 to 6 lie on the upper wing.
  const Index fork = made.grow(2, steps(2, {8 * mm, 0}));  // 16 mm, then it forks
  made.grow(fork, steps(1, {6 * mm, 0}));
  made.grow(fork, steps(1, {0, 6 * mm}));
  made.grow(2, steps(1, {-7 * mm, 0}));  // from the same domain to the other side
  made.join(made.grow(8, steps(1, {-5 * mm, -5 * mm})), 9);  // a way around the third of the lower
  const CrackPath crack = made.measured();
  CHECK(crack.points.size() == 12);
  CHECK(crack.path_length == near(120 * mm));
  REQUIRE(crack.branches.size() == 3);
  CHECK(crack.branches[0].length == near(28 * mm));
  CHECK(crack.branches[0].microcracks == std::vector<std::size_t>{12, 13, 14, 15});
  CHECK(crack.branches[1].length == near(10 * sqrt2 * mm));
  CHECK(crack.branches[1].microcracks == std::vector<std::size_t>{17, 18});
  CHECK(crack.branches[2].length == near(7 * mm));
  CHECK(crack.up.length == near(95 * mm));
  CHECK(crack.down.length == near((60 + 10 * sqrt2) * mm));
  CHECK(crack.tortuosity() == near((155 + 10 * sqrt2) / 120));
  CHECK(crack.path_tortuosity() == near(1));
}

TEST_CASE("of two ways to a tip the path takes the shorter one, not that of fewer microcracks") {
  MadeUpCrack made;
  const Index meeting = made.grow({{20 * mm, 10 * mm}, {-20 * mm, 10 * mm}});
  made.join(made.grow(steps(3, {0, 5 * mm})), meeting);
  made.grow(meeting, {{0, 5 * mm}});
  const CrackPath crack = made.measured();
  CHECK(on_path(crack) == std::vector<std::size_t>{2, 3, 4, 5, 6});
  CHECK(crack.path_length == near(25 * mm));
  REQUIRE(crack.branches.size() == 1);
  CHECK(crack.branches[0].length == near(2 * std::sqrt(500.0) * mm));
}

TEST_CASE("an injection beside the crack feeds a path that passes it by") {
  MadeUpCrack made;
  const Index junction = made.grow({{6 * mm, 0}});
  made.grow(junction, steps(3, {0, 10 * mm}));
  made.grow(junction, steps(2, {0, -10 * mm}));
  const CrackPath crack = made.measured();
  CHECK(on_path(crack) == std::vector<std::size_t>{5, 4, 1, 2, 3});
  CHECK(crack.path_length == near(50 * mm));
  CHECK(crack.points.front().arc == near(-15 * mm));
  CHECK(crack.points.back().arc == near(25 * mm));
  REQUIRE(crack.branches.size() == 1);
  CHECK(crack.branches[0].length == near(6 * mm));
}

TEST_CASE("a wing that begins on the other's way shares it") {
  MadeUpCrack made;  // down first, then back up beside the injection: both tips on one way
  made.grow({{0, -10 * mm}, {10 * mm, 0}, {0, 10 * mm}, {0, 10 * mm}});
  const CrackPath crack = made.measured();
  CHECK(on_path(crack) == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(crack.path_length == near(40 * mm));
  CHECK(crack.branches.empty());
}

TEST_CASE("a crack to one side only is wholly asymmetric") {
  MadeUpCrack made;
  made.grow(steps(3, {0, 10 * mm}));
  const CrackPath crack = made.measured();
  CHECK(crack.asymmetry() == near(1));
  CHECK(crack.tip_distance() == near(30 * mm));
  CHECK(crack.down.reach == 0);
  CHECK(crack.down.tortuosity() == 0);
  CHECK(on_path(crack) == std::vector<std::size_t>{0, 1, 2});
}

TEST_CASE("microcracks that are not connected are no part of the crack") {
  MadeUpCrack made;
  made.grow(steps(2, {0, 10 * mm}));
  const Index away = made.domain({0.2, 0.2});
  made.grow(away, steps(3, {0, 10 * mm}));
  for (std::size_t m = 2; m < 5; ++m) made.microcracks[m].connected = false;
  const CrackPath crack = made.measured();
  CHECK(crack.tip_distance() == near(20 * mm));
  CHECK(crack.connected_length() == near(20 * mm));
  CHECK(crack.branches.empty());
}

TEST_CASE("a crack may end in a microcrack on the rim, behind which there is no domain") {
  MadeUpCrack made;
  const Index last = made.grow(steps(2, {0, 10 * mm}));
  made.grow(last, steps(1, {0, 10 * mm}));
  made.microcracks.back().domain[1] = hfdem::nothing;
  const CrackPath crack = made.measured();
  CHECK(crack.up.reach == near(30 * mm));
  CHECK(crack.path_length == near(30 * mm));
}

TEST_CASE("without a connected microcrack all is zero") {
  const CrackPath crack = MadeUpCrack({0.3, 0.4}).measured();
  CHECK(crack.points.empty());
  CHECK(crack.tip_distance() == 0);
  CHECK(crack.tortuosity() == 0);
  CHECK(crack.mean_tortuosity() == 0);
  CHECK(crack.asymmetry() == 0);
}

namespace {

/// Distance of every domain from the first by relaxing every edge again and again.
std::vector<double> distances(const MadeUpCrack& made, std::size_t domains) {
  std::vector<double> all(domains, std::numeric_limits<double>::infinity());
  all[0] = 0;
  for (std::size_t round = 0; round < domains; ++round)
    for (const auto& m : made.microcracks) {
      const auto [a, b] = m.domain;
      all[a] = std::min(all[a], all[b] + m.length());
      all[b] = std::min(all[b], all[a] + m.length());
    }
  return all;
}

}  // namespace

TEST_CASE(
    "in random webs the path is as short as brute force finds, and branches make up the rest") {
  test::Random random(7);
  for (int web = 0; web < 50; ++web) {
    MadeUpCrack made;
    const auto near_zero = [&] { return random(-0.1, 0.1); };
    constexpr Index domains = 40;
    for (Index d = 1; d < domains; ++d) {
      made.domain({near_zero(), near_zero()});
      made.join(static_cast<Index>(random(0, d)), d);  // connected to the injection
    }
    for (int extra = 0; extra < 15; ++extra) {
      const auto a = static_cast<Index>(random(0, domains)),
                 b = static_cast<Index>(random(0, domains));
      if (a != b) made.join(a, b);
    }
    const CrackPath crack = made.measured();
    const auto distance = distances(made, domains);

    double all = 0, branches = 0;
    for (const auto& m : made.microcracks) all += m.length();
    std::size_t off_path = 0;
    for (const auto& b : crack.branches) branches += b.length, off_path += b.microcracks.size();
    CHECK(crack.connected_length() == near(all, 1e-10));
    CHECK(crack.path_length + branches == near(all, 1e-10));
    CHECK(crack.points.size() + off_path == made.microcracks.size());
    CHECK(std::is_sorted(crack.branches.rbegin(), crack.branches.rend(),
                         [](const auto& a, const auto& b) { return a.length < b.length; }));

    // To each tip it goes the shortest way, which ends with the microcrack that has the tip.
    const auto to_tip = [&](std::size_t place) {
      const auto& m = made.microcracks[place];
      return std::min(distance[m.domain[0]], distance[m.domain[1]]) + m.length();
    };
    const auto& last = crack.points.back();
    const auto& first = crack.points.front();
    const double lengths = made.microcracks[last.microcrack].length() / 2 +
                           made.microcracks[first.microcrack].length() / 2;
    CHECK(last.arc - first.arc + lengths == near(crack.path_length, 1e-10));
    const double shared =
        (to_tip(last.microcrack) + to_tip(first.microcrack) - crack.path_length) / 2;
    CHECK(shared > -1e-12);
    const double skipped =
        to_tip(last.microcrack) - (last.arc + made.microcracks[last.microcrack].length() / 2);
    if (crack.points.front().arc < 0 && crack.points.back().arc > 0)
      CHECK(std::abs(skipped - shared) < 1e-12);

    // Neighbours on the path share a domain.
    for (std::size_t k = 1; k < crack.points.size(); ++k) {
      const auto& a = made.microcracks[crack.points[k - 1].microcrack].domain;
      const auto& b = made.microcracks[crack.points[k].microcrack].domain;
      CHECK((a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]));
    }
  }
}

TEST_CASE("the profile tells aperture and net pressure along the path") {
  MadeUpCrack made({0.1, 0.2});
  made.grow(zigzag(4, {5 * mm, 5 * mm}));
  made.grow(zigzag(2, {5 * mm, -5 * mm}));
  for (std::size_t m = 0; m < made.microcracks.size(); ++m) {
    made.microcracks[m].aperture = (20 + static_cast<double>(m)) * 1e-6;
    made.microcracks[m].opening = (14 + static_cast<double>(m)) * 1e-6;
    made.microcracks[m].pressure = 11e6 + 1e5 * static_cast<double>(m);
  }
  const auto profile = hfdem::measure::path_profile(made.microcracks, made.measured(), 10e6);
  REQUIRE(profile.size() == 6);
  const std::vector<double> order{5, 4, 0, 1, 2, 3};
  for (std::size_t k = 0; k < 6; ++k) {
    CHECK(profile[k].arc == near((static_cast<double>(k) - 1.5) * 5 * mm * sqrt2));
    CHECK(profile[k].along == near((static_cast<double>(k) - 1.5) * 5 * mm));
    CHECK(profile[k].position.y == near(0.2 + profile[k].along));
    CHECK(profile[k].length == near(5 * mm * sqrt2));
    CHECK(profile[k].aperture == near((20 + order[k]) * 1e-6));
    CHECK(profile[k].opening == near((14 + order[k]) * 1e-6));
    CHECK(profile[k].net_pressure == near(1e6 + 1e5 * order[k]));
  }
}

TEST_CASE("the mean aperture weighs what is near the injection by length, and nothing else") {
  MadeUpCrack made;
  made.grow({{0, 10 * mm}, {0, 30 * mm}, {0, 20 * mm}});  // middles at 5, 25 and 50 mm
  made.grow({{0, -20 * mm}, {0, -40 * mm}});              // at -10 and -40 mm
  const std::vector<double> width{100e-6, 60e-6, 1, 80e-6, 1};
  for (std::size_t m = 0; m < width.size(); ++m) {
    made.microcracks[m].aperture = width[m];
    made.microcracks[m].opening = width[m] - 6e-6;
  }
  const auto profile = hfdem::measure::path_profile(made.microcracks, made.measured(), 0);
  const auto mean = hfdem::measure::mean_aperture(profile);
  CHECK(mean.aperture == near((10 * 100e-6 + 30 * 60e-6 + 20 * 80e-6) / 60));
  CHECK(mean.opening == near(mean.aperture - 6e-6));
  CHECK(hfdem::measure::mean_aperture(profile, 6 * mm).aperture == near(100e-6));
  CHECK(hfdem::measure::mean_aperture(profile, 1 * mm).aperture == 0);
  CHECK_THROWS_WITH_AS(hfdem::measure::mean_aperture(profile, 0),
                       "mean_aperture.reach = 0 m is not allowed: it must be greater than 0 m",
                       hfdem::InvalidParameter);
}
