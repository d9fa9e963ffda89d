// Each neighbour search against brute force.
#include <cstddef>
#include <vector>

#include <hfdem/base/random.hpp>
#include <hfdem/neighbours/cell_grid.hpp>
#include <hfdem/neighbours/kd_tree.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/state/concepts.hpp>

#include <doctest/doctest.h>

namespace {

using hfdem::Index;
using hfdem::Pair;
using hfdem::Specimen;

static_assert(hfdem::NeighbourSearch<hfdem::KdTree>);
static_assert(hfdem::NeighbourSearch<hfdem::CellGrid>);

template <class Search>
std::vector<Pair> found(const Specimen& s, double reach) {
  std::vector<Pair> pairs;
  Search(s, reach).for_each_pair([&](Pair p) { pairs.push_back(p); });
  return pairs;
}

std::vector<Pair> by_brute_force(const Specimen& s, double reach) {
  std::vector<Pair> pairs;
  for (Index i = 0; i < s.size(); ++i)
    for (Index j = i + 1; j < s.size(); ++j)
      if (s.gap({i, j}) <= reach) pairs.push_back({i, j});
  return pairs;
}

Specimen scattered(int count, double width, double height, double smallest, double largest,
                   std::uint64_t seed) {
  hfdem::Random random(seed);
  Specimen s{.width = width, .height = height, .density = 1};
  for (int k = 0; k < count; ++k) {
    s.centre.push_back({random.between(0, width), random.between(0, height)});
    s.radius.push_back(random.between(smallest, largest));
  }
  return s;
}

}  // namespace

TEST_CASE_TEMPLATE("the search finds what brute force finds, in the same order", Search,
                   hfdem::KdTree, hfdem::CellGrid) {
  const auto as_brute_force = [](const Specimen& s, double reach) {
    const auto truth = by_brute_force(s, reach);
    CHECK(found<Search>(s, reach) == truth);
    return truth.size();
  };

  SUBCASE("evenly spread") {
    const auto s = scattered(500, 1, 1, 0.01, 0.03, 1);
    CHECK(as_brute_force(s, 0) > 200);
    CHECK(as_brute_force(s, 0.02) > 400);
    CHECK(as_brute_force(s, -0.01) > 50);
    CHECK(as_brute_force(s, -1) == 0);
    CHECK(as_brute_force(s, 2) == 500 * 499 / 2);
  }
  SUBCASE("radii from one to a thousand") {
    auto s = scattered(400, 1, 1, 1e-3, 2e-3, 2);
    s.radius[7] = 1;
    s.radius[300] = 0.3;
    CHECK(as_brute_force(s, 1e-3) > 400);
  }
  SUBCASE("equal radii") { CHECK(as_brute_force(scattered(400, 1, 1, 0.02, 0.02, 3), 0) > 100); }
  SUBCASE("a long strip") { CHECK(as_brute_force(scattered(300, 100, 1, 0.2, 0.4, 4), 0.1) > 100); }
  SUBCASE("in one line") { CHECK(as_brute_force(scattered(300, 0, 1, 0.01, 0.02, 5), 0) > 100); }
  SUBCASE("two clusters far apart, and far from the origin") {
    auto s = scattered(300, 1e-3, 1e-3, 1e-5, 3e-5, 6);
    for (Index i = 0; i < 150; ++i) s.centre[i] = s.centre[i] + hfdem::Vec2{1e3, -1e3};
    CHECK(as_brute_force(s, 1e-5) > 100);
  }
  SUBCASE("all in one place") {
    auto s = scattered(50, 1, 1, 0.1, 0.2, 7);
    for (auto& c : s.centre) c = {0.5, 0.5};
    CHECK(as_brute_force(s, 0) == 50 * 49 / 2);
  }
  SUBCASE("none, one and two discs") {
    CHECK(as_brute_force(scattered(0, 1, 1, 0.1, 0.2, 8), 1) == 0);
    CHECK(as_brute_force(scattered(1, 1, 1, 0.1, 0.2, 8), 1) == 0);
    CHECK(as_brute_force(scattered(2, 1, 1, 0.1, 0.2, 8), 2) == 1);
    CHECK(as_brute_force(scattered(2, 100, 100, 0.1, 0.2, 8), 1e-3) == 0);
  }
}

TEST_CASE_TEMPLATE("a pair exactly at reach is found, one a bit beyond is not", Search,
                   hfdem::KdTree, hfdem::CellGrid) {
  // Powers of two, so that no gap is rounded; 3-4-5 triangles, so that none is along an axis.
  Specimen s{.width = 64, .height = 64, .density = 1};
  for (int k = 0; k < 4; ++k) {
    s.centre.push_back({3.0 * k, 4.0 * k});
    s.radius.push_back(k % 2 == 0 ? 1 : 2);
  }
  CHECK(found<Search>(s, 2) == std::vector<Pair>{{0, 1}, {1, 2}, {2, 3}});
  CHECK(found<Search>(s, std::nextafter(2.0, 0.0)).empty());

  const auto array = hfdem::square_array(20, 15, 0.5);
  CHECK(found<Search>(array, 0) == by_brute_force(array, 0));
  CHECK(found<Search>(array, 0).size() == array.pairs.size());
}

TEST_CASE("contacts do not depend on the search, to the last bit") {
  auto s = scattered(1000, 1, 1, 0.01, 0.03, 9);
  s.bonding_gap = 1e-3;
  const auto tree = hfdem::bonded_contacts<hfdem::KdTree>(s);
  const auto grid = hfdem::bonded_contacts<hfdem::CellGrid>(s);
  REQUIRE(tree.size() == grid.size());
  CHECK(tree.size() > 500);
  for (std::size_t c = 0; c < tree.size(); ++c) {
    CHECK(tree[c].bodies == grid[c].bodies);
    CHECK(tree[c].frame.normal_x == grid[c].frame.normal_x);
    CHECK(tree[c].frame.arm_mean == grid[c].frame.arm_mean);
  }
}
