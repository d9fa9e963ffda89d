// The flow domains as faces of the contact graph: Euler's formula, areas, channels and corners.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/setup/flow_domains.hpp>
#include <hfdem/setup/square_array.hpp>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "loops/assembly.hpp"
#include "near.hpp"

namespace {

using hfdem::Index;
using hfdem::Pair;
using hfdem::Vec2;
using test::near;

/// A specimen's contact graph and its domains.
struct Graph {
  hfdem::Specimen specimen;
  std::vector<hfdem::ContactGeometry> contacts;
  hfdem::FlowDomains domains;

  explicit Graph(hfdem::Specimen s)
      : specimen(std::move(s)),
        contacts(hfdem::bonded_contacts<hfdem::FixedPairs>(specimen)),
        domains(hfdem::flow_domains(specimen, contacts)) {}

  /// The corners of a domain, in order around it.
  std::vector<Vec2> polygon(Index domain) const {
    std::vector<Vec2> corners;
    for (Index k = domains.discs_begin[domain]; k < domains.discs_begin[domain + 1]; ++k)
      corners.push_back(specimen.centre[domains.discs_of[k]]);
    return corners;
  }

  std::size_t components() const {
    std::vector<Index> root(specimen.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&](Index i) {
      while (root[i] != i) i = root[i];
      return i;
    };
    std::size_t count = specimen.size();
    for (const auto& c : contacts) {
      const Index a = find(c.bodies.first), b = find(c.bodies.second);
      if (a == b) continue;
      root[a] = b;
      --count;
    }
    return count;
  }
};

/// Equal discs wherever they are wanted, bonded as wanted.
Graph drawn(const std::vector<Vec2>& centres, std::vector<Pair> bonds) {
  return Graph({.width = 1,
                .height = 1,
                .density = 1,
                .centre = centres,
                .radius = std::vector<double>(centres.size(), 0.1),
                .bonding_gap = 10,
                .pairs = std::move(bonds)});
}

/// A square array without the discs that are named.
Graph square_without(int columns, int rows, const std::vector<Index>& missing) {
  hfdem::Specimen s = hfdem::square_array(columns, rows, 0.5);
  std::erase_if(s.pairs, [&](Pair p) {
    return std::any_of(missing.begin(), missing.end(),
                       [&](Index m) { return p.first == m || p.second == m; });
  });
  return Graph(s);  // the missing discs stay as components of their own
}

double area(const std::vector<Vec2>& polygon) {
  double twice = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    twice += cross(polygon[k], polygon[(k + 1) % polygon.size()]);
  return twice / 2;
}

/// A rectangle of discs, its rim in place and its inside jittered, with diagonals here and there:
/// triangles and quadrilaterals of many shapes, in a known outline.
Graph jittered_rectangle(Index columns, Index rows, std::uint64_t seed) {
  test::Random random(seed);
  hfdem::Specimen s = hfdem::square_array(static_cast<int>(columns), static_cast<int>(rows), 5e-3);
  s.bonding_gap = 1;  // bond the pairs that are listed
  for (Index r = 0; r < rows; ++r)
    for (Index c = 0; c < columns; ++c) {
      const Index disc = r * columns + c;
      s.radius[disc] = random(3e-3, 5e-3);
      if (r > 0 && c > 0 && r + 1 < rows && c + 1 < columns)
        s.centre[disc] = s.centre[disc] + Vec2{random(-2e-3, 2e-3), random(-2e-3, 2e-3)};
      if (r + 1 == rows || c + 1 == columns) continue;
      const double chance = random(0, 3);
      if (chance < 1) s.pairs.push_back({disc, disc + columns + 1});
      if (chance > 2) s.pairs.push_back({disc + 1, disc + columns});
    }
  return Graph(s);
}

std::vector<Graph> all_kinds() {
  std::vector<Graph> graphs;
  graphs.push_back(Graph(hfdem::square_array(5, 4, 5e-3)));
  graphs.push_back(square_without(7, 6, {16}));         // a hole
  graphs.push_back(square_without(7, 6, {8, 16, 17}));  // holes that touch
  graphs.push_back(square_without(7, 3, {3, 10, 17}));  // two components
  graphs.push_back(jittered_rectangle(8, 7, 1));
  graphs.push_back(jittered_rectangle(6, 9, 2));
  test::Random random(3);
  graphs.push_back(Graph(test::jittered_discs(8, 7, random)));
  graphs.push_back(Graph(test::jittered_discs(7, 9, random)));
  return graphs;
}

}  // namespace

TEST_CASE("Euler's formula counts the domains") {
  for (const Graph& g : all_kinds())  // V - E + F = 1 + components; the outside is a face too
    CHECK(g.specimen.size() + g.domains.centre.size() == g.contacts.size() + g.components());
}

TEST_CASE("the domains of drawn graphs are those that one sees") {
  const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<Pair> ring{{0, 1}, {1, 2}, {2, 3}, {0, 3}};

  SUBCASE("nothing is enclosed by a chain") {
    CHECK(drawn(square, {{0, 1}, {1, 2}, {2, 3}}).domains.centre.empty());
  }
  SUBCASE("a disc that dangles inside changes neither area nor centre") {
    auto centres = square;
    centres.push_back({0.3, 0.2});
    auto bonds = ring;
    bonds.push_back({0, 4});
    const Graph g = drawn(centres, bonds);
    REQUIRE(g.domains.centre.size() == 1);
    CHECK(area(g.polygon(0)) == near(1));
    CHECK(norm(g.domains.centre[0] - Vec2{0.5, 0.5}) < 1e-15);
    CHECK(g.contacts[2].bodies == Pair{0, 4});
    CHECK(g.domains.channels[2].domain == std::array<Index, 2>{0, 0});
    CHECK(g.domains.channels[2].length == 0);
  }
  SUBCASE("a disc that dangles outside belongs to no domain") {
    auto centres = square;
    centres.push_back({-1, -1});
    auto bonds = ring;
    bonds.push_back({0, 4});
    const Graph g = drawn(centres, bonds);
    REQUIRE(g.domains.centre.size() == 1);
    CHECK(g.contacts[2].bodies == Pair{0, 4});
    CHECK(g.domains.channels[2].domain == std::array<Index, 2>{hfdem::nothing, hfdem::nothing});
  }
  SUBCASE("two rings apart are two domains") {
    auto centres = square;
    for (const Vec2 c : square) centres.push_back(c + Vec2{3, 0});
    auto bonds = ring;
    for (const Pair p : ring) bonds.push_back({p.first + 4, p.second + 4});
    const Graph g = drawn(centres, bonds);
    REQUIRE(g.domains.centre.size() == 2);
    CHECK(norm(g.domains.centre[1] - g.domains.centre[0] - Vec2{3, 0}) < 1e-15);
  }
  SUBCASE("a missing disc leaves one domain of four cells") {
    const Graph g = square_without(3, 3, {4});
    REQUIRE(g.domains.centre.size() == 1);
    CHECK(area(g.polygon(0)) == near(4));
    CHECK(norm(g.domains.centre[0] - Vec2{1.5, 1.5}) < 1e-15);
  }
}

TEST_CASE("a domain's centre is its centre of area") {
  SUBCASE("a triangle") {
    const Graph g = drawn({{0, 0}, {3, 0}, {0, 6}}, {{0, 1}, {1, 2}, {0, 2}});
    CHECK(norm(g.domains.centre.at(0) - Vec2{1, 2}) < 1e-14);
  }
  SUBCASE("a trapezium of bases a and b and height h: h (a + 2 b) / (3 (a + b)) above a") {
    const Graph g = drawn({{-2, 5}, {2, 5}, {1, 8}, {-1, 8}}, {{0, 1}, {1, 2}, {2, 3}, {0, 3}});
    CHECK(norm(g.domains.centre.at(0) - Vec2{0, 5 + 3 * (4 + 2 * 2) / (3.0 * (4 + 2))}) < 1e-14);
  }
  SUBCASE("an angle of two rectangles") {  // 3 x 1 and, on its left end, 1 x 2
    const Graph g = drawn({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}},
                          {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {0, 5}});
    CHECK(norm(g.domains.centre.at(0) - 0.2 * (3 * Vec2{1.5, 0.5} + 2 * Vec2{0.5, 2})) < 1e-14);
  }
}

TEST_CASE("the domains fill the outline") {
  const auto filled = [](const Graph& g) {
    double sum = 0;
    for (Index d = 0; d < g.domains.centre.size(); ++d) {
      CHECK(area(g.polygon(d)) > 0);
      sum += area(g.polygon(d));
    }
    return sum;
  };
  CHECK(filled(Graph(hfdem::square_array(5, 4, 5e-3))) == near(4 * 3 * 1e-4));
  CHECK(filled(square_without(7, 6, {16})) == near(6 * 5));
  CHECK(filled(jittered_rectangle(8, 7, 1)) == near(7 * 6 * 1e-4));
  CHECK(filled(jittered_rectangle(6, 9, 2)) == near(5 * 8 * 1e-4));
}

TEST_CASE("a channel joins the domain left of its contact to the one on the right") {
  for (const Graph& g : all_kinds()) {
    std::size_t sides = 0;
    for (Index d = 0; d < g.domains.centre.size(); ++d) {
      // Around a domain counter-clockwise, it lies to the left of every contact.
      const Index begin = g.domains.discs_begin[d], size = g.domains.discs_begin[d + 1] - begin;
      REQUIRE(g.domains.channels_begin[d + 1] - g.domains.channels_begin[d] == size);
      for (Index k = 0; k < size; ++k) {
        const Index from = g.domains.discs_of[begin + k];
        const Index to = g.domains.discs_of[begin + (k + 1) % size];
        const Index c = g.domains.channels_of[g.domains.channels_begin[d] + k];
        const bool along = g.contacts[c].bodies == Pair{from, to};
        CHECK((along || g.contacts[c].bodies == Pair{to, from}));
        CHECK(g.domains.channels[c].domain[along ? 0 : 1] == d);
        ++sides;
      }
    }
    for (const auto& channel : g.domains.channels)
      sides += static_cast<std::size_t>(
          std::count(channel.domain.begin(), channel.domain.end(), hfdem::nothing));
    CHECK(sides == 2 * g.contacts.size());
  }
}

TEST_CASE("a channel is as long as its two centres are apart, and mirrored on the rim") {
  const Graph square(hfdem::square_array(5, 4, 5e-3));
  for (const auto& channel : square.domains.channels) CHECK(channel.length == near(10e-3));

  // Two triangles, 3 high and 6 high, on a common base.
  const Graph g =
      drawn({{0, 0}, {2, 0}, {1, 3}, {1, -6}}, {{0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}});
  CHECK(g.domains.channels.at(0).length == near(1 + 2));
  CHECK(g.contacts.at(1).bodies == Pair{0, 2});  // contact point half-way, centre at (1, 1)
  CHECK(g.domains.channels.at(1).length == near(2 * norm(Vec2{1, 1} - Vec2{0.5, 1.5})));
}

TEST_CASE("the pushes on the discs around a domain balance") {
  for (const Graph& g : all_kinds()) {
    std::vector<Vec2> sum(g.domains.centre.size());
    double largest = 0;
    for (const auto& corner : g.domains.corners) {
      sum[corner.domain] = sum[corner.domain] + corner.push;
      largest = std::fmax(largest, norm(corner.push));
    }
    for (const Vec2 s : sum) CHECK(norm(s) < 1e-15 * largest);
  }
}

TEST_CASE("a domain pushes a disc outwards by the chord between its two contact points") {
  constexpr double R = 5e-3;
  const Graph square(hfdem::square_array(5, 4, R));
  std::size_t corners = 0;
  for (Index disc = 0; disc < square.specimen.size(); ++disc)
    for (Index k = square.domains.corners_begin[disc]; k < square.domains.corners_begin[disc + 1];
         ++k) {
      const auto& corner = square.domains.corners[k];
      const Vec2 out = square.specimen.centre[disc] - square.domains.centre[corner.domain];
      CHECK(corner.push == Vec2{std::copysign(R, out.x), std::copysign(R, out.y)});
      ++corners;
    }
  CHECK(corners == 4 * 4 * 3);

  // Unequal discs: 1, 2 and 3 at the corners of a right triangle, just touching.
  hfdem::Specimen s{.width = 9,
                    .height = 9,
                    .density = 1,
                    .centre = {{0, 0}, {3, 0}, {0, 4}},
                    .radius = {1, 2, 3},
                    .bonding_gap = 1e-9,
                    .pairs = {{0, 1}, {0, 2}, {1, 2}}};
  const Graph triangle(s);
  const auto push = [&](Index disc) {
    return triangle.domains.corners.at(triangle.domains.corners_begin.at(disc)).push;
  };
  // Contact points (1, 0), (0, 1) and (3, 0) + 2 (-0.6, 0.8).
  CHECK(norm(push(0) - Vec2{-1, -1}) < 1e-15);
  CHECK(norm(push(1) - Vec2{1.6, -0.8}) < 1e-15);
  CHECK(norm(push(2) - Vec2{-0.6, 1.8}) < 1e-15);
}

TEST_CASE("channels may be as long as their bonds are wide") {
  hfdem::Specimen s = hfdem::square_array(3, 2, 5e-3);
  s.radius[1] = 4e-3;
  s.bonding_gap = 1.1e-3;
  const auto contacts = hfdem::bonded_contacts<hfdem::FixedPairs>(s);
  const auto domains = hfdem::flow_domains(s, contacts, hfdem::ChannelLength::bond);
  REQUIRE(contacts.size() == 7);
  for (Index c = 0; c < contacts.size(); ++c) {
    const auto [first, second] = contacts[c].bodies;
    const bool thin = first == 1 || second == 1;
    CHECK(domains.channels[c].length == near(thin ? 8e-3 : 10e-3));
  }
}
