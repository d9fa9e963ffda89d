// The random packing: what was asked for, in equilibrium, disordered, and the same every time.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include <hfdem/neighbours/kd_tree.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/setup/flow_domains.hpp>
#include <hfdem/setup/random_packing.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

namespace {

using hfdem::Index;
using hfdem::RandomPacking;
using hfdem::Side;
using hfdem::Specimen;
using hfdem::Vec2;
using test::near;

constexpr int grains = 3000;

/// 3000 grains of the paper's rock, with twice the width as height.
const Specimen& rock() {
  static const Specimen s =
      hfdem::random_packing({.width = 0.585, .height = 0.2924, .grains = grains, .seed = 3});
  return s;
}

const std::vector<hfdem::ContactGeometry>& bonds() {
  static const auto contacts = hfdem::bonded_contacts<hfdem::KdTree>(rock());
  return contacts;
}

double disc_area(const Specimen& s) {
  double sum = 0;
  for (const double r : s.radius) sum += std::numbers::pi * r * r;
  return sum;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

bool same_bits(const Specimen& a, const Specimen& b) {
  return a.centre == b.centre && a.radius == b.radius && a.bonding_gap == b.bonding_gap;
}

/// How many of the discs touch fewer than three others and walls.
long floaters(const Specimen& s) {
  std::vector<int> touching(s.size(), 0);
  for (Index i = 0; i < s.size(); ++i) {
    for (Index j = 0; j < s.size(); ++j) touching[i] += i != j && s.gap({i, j}) <= 0 ? 1 : 0;
    for (const Side side : hfdem::all_sides) touching[i] += s.gap(i, side) <= 0 ? 1 : 0;
  }
  return std::count_if(touching.begin(), touching.end(), [](int n) { return n < 3; });
}

/// Of the discs with six bonds, the mean size of the sum of exp(6 i angle) / 6: one in a crystal.
double hexagonal_order(const Specimen& s) {
  std::vector<std::complex<double>> sum(s.size());
  std::vector<int> count(s.size(), 0);
  for (const auto& c : hfdem::bonded_contacts<hfdem::KdTree>(s)) {
    const double angle = std::atan2(c.frame.normal_y, c.frame.normal_x);
    for (const Index i : {c.bodies.first, c.bodies.second})  // half a turn changes nothing
      sum[i] += std::polar(1.0, 6 * angle), ++count[i];
  }
  double total = 0;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (count[i] > 0) total += std::abs(sum[i]) / count[i];
  return total / static_cast<double>(s.size());
}

}  // namespace

TEST_CASE("a packing has exactly the grains that were asked for, all in the box") {
  const Specimen& s = rock();
  CHECK(s.size() == grains);
  CHECK(s.width == 0.585);
  CHECK(s.height == 0.2924);
  CHECK(s.density == 3169);
  CHECK(s.bonding_gap == near(0.02 * mean(s.radius)));
  for (const Vec2 c : s.centre) {
    CHECK(c.x > 0);
    CHECK(c.x < s.width);
    CHECK(c.y > 0);
    CHECK(c.y < s.height);
  }
}

TEST_CASE("a packing has the porosity that was asked for, within one grain") {
  for (const double porosity : {0.08, 0.1, 0.13}) {
    const auto s = hfdem::random_packing({.width = 0.2, .height = 0.3, .porosity = porosity});
    const double grain = std::numbers::pi * 5e-3 * 5e-3 / (s.width * s.height);
    CHECK(std::abs(1 - disc_area(s) / (s.width * s.height) - porosity) < grain);
  }
}

TEST_CASE("radii are uniform within their range") {
  std::vector<double> radius = rock().radius;
  std::sort(radius.begin(), radius.end());
  CHECK(radius.front() >= 3e-3);
  CHECK(radius.back() <= 5e-3);
  // Kolmogorov and Smirnov: a distance that one sample in a hundred exceeds.
  double distance = 0;
  for (std::size_t k = 0; k < radius.size(); ++k) {
    const double expected = (radius[k] - 3e-3) / 2e-3;
    distance = std::max({distance, std::abs(expected - static_cast<double>(k) / grains),
                         std::abs(expected - static_cast<double>(k + 1) / grains)});
  }
  CHECK(distance < 1.63 / std::sqrt(grains));
}

TEST_CASE("the grains hold each other: none floats, and the forces of springs balance") {
  const Specimen& s = rock();
  CHECK(floaters(s) == 0);

  double resultant = 0, force_sum = 0, contacts = 0;
  for (Index i = 0; i < s.size(); ++i) {
    Vec2 sum;
    const auto push = [&](double overlap, Vec2 direction) {
      if (overlap <= 0) return;
      sum = sum + overlap * direction;
      force_sum += overlap;
      ++contacts;
    };
    for (Index j = 0; j < s.size(); ++j) {
      if (i == j) continue;
      const Vec2 away = s.centre[i] - s.centre[j];
      push(-s.gap({i, j}), (1 / hfdem::norm(away)) * away);
    }
    for (const Side side : hfdem::all_sides) push(-2 * s.gap(i, side), -hfdem::outward(side));
    resultant += hfdem::norm(sum);
  }
  CHECK(resultant / grains < 1.01e-3 * force_sum / contacts);
}

TEST_CASE("floaters among equal discs are cured as well") {
  const auto s = hfdem::random_packing(
      {.width = 0.2, .height = 0.2, .radius_min = 4e-3, .radius_max = 4e-3, .seed = 2});
  CHECK(floaters(s) == 0);
}

TEST_CASE("the bonds of a packing are as many as published, and its overlaps as deep") {
  // Of 17,511 discs: 42,900 bonds, 4.90 per disc; the mean overlap 4.5 % of the radius, the
  // largest 19 %. A disc at a wall has about two bonds fewer, and 6.2 % of these discs are there.
  double overlap = 0, largest = 0, overlapping = 0;
  for (const auto& c : bonds()) {
    const auto [i, j] = c.bodies;
    const double share = -2 * rock().gap(c.bodies) / (rock().radius[i] + rock().radius[j]);
    if (share <= 0) continue;
    overlap += share;
    largest = std::max(largest, share);
    ++overlapping;
  }
  CHECK(2.0 * static_cast<double>(bonds().size()) / grains == near(4.83, 0.015));
  CHECK(overlap / overlapping == near(0.045, 0.12));
  CHECK(largest < 0.23);
}

TEST_CASE("the bonds make one connected graph, whose faces are the flow domains") {
  std::vector<Index> root(grains);
  std::iota(root.begin(), root.end(), Index{0});
  const auto find = [&](Index i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  std::size_t trees = grains;
  for (const auto& c : bonds()) {
    const Index a = find(c.bodies.first), b = find(c.bodies.second);
    if (a != b) root[a] = b, --trees;
  }
  CHECK(trees == 1);

  // Euler: vertices - edges + faces = 2, the outside being a face.
  const auto domains = hfdem::flow_domains(rock(), bonds());
  CHECK(domains.centre.size() == bonds().size() - grains + 1);

  // Published shares: 69 % triangles, 27 % quadrangles, 4 % pentagons.
  std::vector<double> share(10, 0);
  for (std::size_t d = 0; d + 1 < domains.discs_begin.size(); ++d)
    share[std::min<std::size_t>(9, domains.discs_begin[d + 1] - domains.discs_begin[d])] +=
        1 / static_cast<double>(domains.centre.size());
  CHECK(share[3] == near(0.69, 0.03));
  CHECK(share[4] == near(0.27, 0.07));
  CHECK(share[5] == near(0.045, 0.25));
}

TEST_CASE("grains line all four walls, overlapping them half as deep as each other") {
  const Specimen& s = rock();
  for (const Side side : hfdem::all_sides) {
    std::vector<double> place{0, hfdem::is_vertical(side) ? s.height : s.width};
    double overlap = 0;
    for (Index i = 0; i < s.size(); ++i) {
      if (s.gap(i, side) > 0) continue;
      place.push_back(hfdem::is_vertical(side) ? s.centre[i].y : s.centre[i].x);
      overlap -= s.gap(i, side);
    }
    std::sort(place.begin(), place.end());
    for (std::size_t k = 1; k < place.size(); ++k)
      CHECK(place[k] - place[k - 1] < 6 * 4e-3);  // a disc between two may stand back
    const double touching = static_cast<double>(place.size()) - 2;
    CHECK(touching > 0.8 * place.back() / 8e-3);
    CHECK(overlap / touching == near(0.045 * 4e-3 / 2, 0.35));
  }
}

TEST_CASE("bonds have no preferred direction") {
  // Away from the walls, to which the outer layers are parallel.
  double cosine = 0, sine = 0, count = 0;
  for (const auto& c : bonds()) {
    const Vec2 at = rock().centre[c.bodies.first];
    if (std::min({at.x, at.y, 0.585 - at.x, 0.2924 - at.y}) < 0.03) continue;
    const double twice = 2 * std::atan2(c.frame.normal_y, c.frame.normal_x);
    cosine += std::cos(twice);
    sine += std::sin(twice);
    ++count;
  }
  // Four standard errors of independent directions.
  CHECK(std::abs(cosine / count) < 4 / std::sqrt(2 * count));
  CHECK(std::abs(sine / count) < 4 / std::sqrt(2 * count));
}

TEST_CASE("unequal discs do not crystallise, as equal ones do") {
  const RandomPacking equal{.width = 0.2, .height = 0.2, .radius_min = 4e-3, .radius_max = 4e-3};
  CHECK(hexagonal_order(rock()) < 0.7);
  CHECK(hexagonal_order(hfdem::random_packing(equal)) > 0.9);
}

TEST_CASE("a seed gives the same bits every time, with any number of threads") {
  RandomPacking p{.width = 0.58, .height = 0.58, .seed = 11};  // more than eight chunks
  const auto once = hfdem::random_packing(p);
  CHECK(once.size() > 5000);
  CHECK(same_bits(once, hfdem::random_packing(p, 2)));
  CHECK(same_bits(once, hfdem::random_packing(p, 5)));
  p.seed = 12;
  CHECK_FALSE(same_bits(once, hfdem::random_packing(p)));
}

TEST_CASE("discs are numbered along the curve") {
  const Specimen& s = rock();
  double jump = 0;
  for (std::size_t k = 1; k < s.size(); ++k) jump += hfdem::norm(s.centre[k] - s.centre[k - 1]);
  CHECK(jump / grains < 3 * 4e-3);  // hardly more than a diameter
}
