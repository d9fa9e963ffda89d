// How fluid spreads through broken contacts, the volumes it fills, and the forces it exerts.
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/setup/flow_domains.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/state/network.hpp>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "loops/assembly.hpp"
#include "near.hpp"

namespace {

using hfdem::Index;
using hfdem::Pair;
using hfdem::Vec2;
using test::near;

constexpr double w0 = 6e-6, R = 5e-3, channel_length = 2 * R;
constexpr Index columns = 8, rows = 8;

/// The network of a square array, its channels named by where they are.
struct Square {
  std::vector<hfdem::ContactGeometry> contacts;
  hfdem::Network network;

  /// Injection into the domain of which disc (column, row) is the lower left corner.
  explicit Square(Index column, Index row) {
    const auto specimen = hfdem::square_array(columns, rows, R);
    contacts = hfdem::bonded_contacts<hfdem::FixedPairs>(specimen);
    network = hfdem::Network(hfdem::flow_domains(specimen, contacts), {domain(column, row)}, w0);
  }

  static Index domain(Index column, Index row) { return row * (columns - 1) + column; }
  /// Between the discs (column, row) and (column + 1, row).
  Index across(Index column, Index row) const {
    return contact({row * columns + column, row * columns + column + 1});
  }
  /// Between the discs (column, row) and (column, row + 1).
  Index above(Index column, Index row) const {
    return contact({row * columns + column, (row + 1) * columns + column});
  }
  Index contact(Pair discs) const {
    const auto found = std::find_if(contacts.begin(), contacts.end(),
                                    [&](const auto& c) { return c.bodies == discs; });
    REQUIRE(found != contacts.end());
    return static_cast<Index>(found - contacts.begin());
  }
};

template <class Span>
std::set<Index> as_set(const Span& span) {
  const std::set<Index> result(span.begin(), span.end());
  CHECK(result.size() == span.size());  // nothing is listed twice
  return result;
}

Vec2 total_force(const hfdem::Network& network) {
  Vec2 total;
  for (Index i = 0; i + 1 < network.geometry().corners_begin.size(); ++i)
    total = total + network.force_on(i);
  return total;
}

}  // namespace

TEST_CASE("the domains of a square array are numbered along its rows") {
  const Square square(3, 3);
  const Vec2 centre = square.network.geometry().centre[Square::domain(3, 2)];
  CHECK(centre.x == near(8 * R));
  CHECK(centre.y == near(6 * R));
}

TEST_CASE("at first only the injection domain is wet") {
  const Square square(3, 3);
  CHECK(square.network.wet_channels().empty());
  CHECK(as_set(square.network.wet_domains()) == std::set<Index>{Square::domain(3, 3)});
  CHECK(as_set(square.network.pushed_discs()) == std::set<Index>{27, 28, 35, 36});
  CHECK_FALSE(square.network.reached_rim());
}

TEST_CASE("a broken contact takes fluid from the domain beside it, and gives it to the other") {
  Square square(3, 3);
  const Index c = square.across(3, 4);
  square.network.open(c);
  CHECK(square.network.is_open(c));
  CHECK(square.network.is_wet(c));
  CHECK(square.network.width(c) == w0);
  CHECK(as_set(square.network.wet_domains()) ==
        std::set<Index>{Square::domain(3, 3), Square::domain(3, 4)});
  CHECK(as_set(square.network.pushed_discs()) == std::set<Index>{27, 28, 35, 36, 43, 44});
}

TEST_CASE("a broken contact without connection stays dry, and joins when connected") {
  Square square(3, 3);
  const Index near_one = square.across(3, 4), far_one = square.across(3, 5);
  square.network.open(far_one);
  CHECK(square.network.is_open(far_one));
  CHECK_FALSE(square.network.is_wet(far_one));
  CHECK(square.network.width(far_one) == 0);
  CHECK(square.network.total_volume() == 0);
  square.network.open(near_one);
  CHECK(square.network.is_wet(far_one));
  CHECK(square.network.width(far_one) == w0);
  CHECK(as_set(square.network.wet_domains()) ==
        std::set<Index>{Square::domain(3, 3), Square::domain(3, 4), Square::domain(3, 5)});
}

TEST_CASE("the order in which a crack breaks does not matter") {
  // Through two corners and a branch; the last contact is connected to nothing.
  const Square at_rest(3, 3);
  std::vector<Index> chain{at_rest.across(3, 4), at_rest.above(3, 4), at_rest.across(2, 5),
                           at_rest.across(2, 4), at_rest.above(2, 5), at_rest.above(6, 1)};
  const Index lonely = chain.back();
  const std::set<Index> connected(chain.begin(), chain.end() - 1);
  std::sort(chain.begin(), chain.end());
  std::set<Index> first_domains, first_discs;
  do {
    Square square(3, 3);
    for (const Index c : chain) square.network.open(c);
    CHECK(as_set(square.network.wet_channels()) == connected);
    CHECK_FALSE(square.network.is_wet(lonely));
    const auto domains = as_set(square.network.wet_domains());
    const auto discs = as_set(square.network.pushed_discs());
    if (first_domains.empty()) first_domains = domains, first_discs = discs;
    CHECK(domains == first_domains);
    CHECK(discs == first_discs);
  } while (std::next_permutation(chain.begin(), chain.end()));
  CHECK(first_domains.size() == 6);
}

TEST_CASE("a crack that closes on itself is counted once") {
  Square square(3, 3);  // around disc (4, 4)
  for (const Index c :
       {square.across(3, 4), square.above(4, 3), square.across(4, 4), square.above(4, 4)})
    square.network.open(c);
  CHECK(as_set(square.network.wet_channels()).size() == 4);
  CHECK(as_set(square.network.wet_domains()).size() == 4);
}

TEST_CASE("volumes are sums of length times width") {
  Square square(3, 3);
  square.network.open(square.across(3, 4));
  square.network.open(square.across(3, 5));
  square.network.open(square.above(6, 1));  // dry
  CHECK(square.network.rest_volume() == near(2 * channel_length * w0));
  CHECK(square.network.total_volume() == near(2 * channel_length * w0));
  CHECK(square.network.crack_volume() == 0);

  square.network.set_width(square.across(3, 4), 50e-6);
  square.network.set_width(square.across(3, 5), 2e-6);
  CHECK(square.network.total_volume() == near(channel_length * 52e-6));
  CHECK(square.network.crack_volume() == near(channel_length * 40e-6));
  CHECK(square.network.rest_volume() == near(2 * channel_length * w0));
  CHECK(square.network.domain_volume(Square::domain(3, 3)) == near(channel_length * 25e-6));
  CHECK(square.network.domain_volume(Square::domain(3, 4)) == near(channel_length * 26e-6));
  CHECK(square.network.domain_volume(Square::domain(3, 5)) == near(channel_length * 1e-6));
}

TEST_CASE("the volumes of the domains sum up to that of the channels, whatever their shapes") {
  test::Random random(1);
  const auto specimen = test::jittered_discs(9, 8, random);
  const auto contacts = hfdem::bonded_contacts<hfdem::FixedPairs>(specimen);
  const auto domains = hfdem::flow_domains(specimen, contacts);
  hfdem::Network network(domains, {static_cast<Index>(domains.centre.size() / 2)}, w0);
  for (Index c = 0; c < contacts.size(); ++c)
    if (domains.channels[c].domain[0] != hfdem::nothing &&
        domains.channels[c].domain[1] != hfdem::nothing)
      network.open(c);
  REQUIRE(network.wet_channels().size() > 20);
  double expected = 0;
  for (const Index c : network.wet_channels()) {
    const double width = random(1e-6, 1e-4);
    network.set_width(c, width);
    const auto [left, right] = domains.channels[c].domain;
    expected += width * norm(domains.centre[left] - domains.centre[right]);
  }
  double in_domains = 0;
  for (Index d = 0; d < domains.centre.size(); ++d) in_domains += network.domain_volume(d);
  CHECK(network.total_volume() == near(expected));
  CHECK(in_domains == near(expected));

  // The same network, under one pressure: the fluid pushes the specimen nowhere.
  for (const Index d : network.wet_domains()) network.set_pressure(d, 12e6);
  double largest = 0;
  for (Index i = 0; i < specimen.size(); ++i)
    largest = std::fmax(largest, norm(network.force_on(i)));
  CHECK(largest > 12e6 * 1e-3);
  CHECK(norm(total_force(network)) < 1e-13 * largest);
}

TEST_CASE("a pressurised slit pushes its two sides apart, and the next row along") {
  Square square(3, 3);
  square.network.open(square.across(3, 4));
  for (const Index d : square.network.wet_domains()) square.network.set_pressure(d, 10e6);
  const auto force_on = [&](Index column, Index row) {
    return square.network.force_on(row * columns + column);
  };
  const double chord = 10e6 * R;  // per coordinate
  // Beside the broken contact both domains push: twice sideways, nothing along.
  CHECK(force_on(3, 4).x == near(-2 * chord));
  CHECK(force_on(4, 4).x == near(2 * chord));
  CHECK(force_on(3, 4).y == 0);
  CHECK(force_on(4, 4).y == 0);
  // The discs at the ends of the two domains.
  for (const Index column : {3U, 4U})
    for (const Index row : {3U, 5U}) {
      CHECK(force_on(column, row).x == near(column == 3 ? -chord : chord));
      CHECK(force_on(column, row).y == near(row == 3 ? -chord : chord));
    }
  CHECK(norm(force_on(2, 4)) == 0);
  CHECK(norm(total_force(square.network)) == 0);
}

TEST_CASE("forces on mirror images are mirrored to the last bit") {
  struct Mirror {
    bool x, y;
  };
  for (const Mirror mirror : {Mirror{true, false}, Mirror{false, true}, Mirror{true, true}}) {
    const auto column = [&](Index c, Index count) { return mirror.x ? count - 1 - c : c; };
    const auto row = [&](Index r, Index count) { return mirror.y ? count - 1 - r : r; };
    Square one(3, 3), other(3, 3);
    // All domains from (2, 2) to (4, 4), each under a pressure of its own.
    for (const Index c : {2U, 3U, 4U})
      for (const Index r : {3U, 4U}) {
        one.network.open(one.across(c, r));
        other.network.open(other.across(column(c, columns - 1), row(r, rows)));
        one.network.open(one.above(r, c));
        other.network.open(other.above(column(r, columns), row(c, rows - 1)));
      }
    test::Random random(2);
    for (const Index c : {2U, 3U, 4U})
      for (const Index r : {2U, 3U, 4U}) {
        const double pressure = random(1e6, 2e7);
        one.network.set_pressure(Square::domain(c, r), pressure);
        other.network.set_pressure(Square::domain(column(c, columns - 1), row(r, rows - 1)),
                                   pressure);
      }
    for (Index c = 0; c < columns; ++c)
      for (Index r = 0; r < rows; ++r) {
        const Vec2 a = one.network.force_on(r * columns + c);
        const Vec2 b = other.network.force_on(row(r, rows) * columns + column(c, columns));
        CHECK(a.x == (mirror.x ? -b.x : b.x));
        CHECK(a.y == (mirror.y ? -b.y : b.y));
      }
  }
}

TEST_CASE("the network knows when fluid reaches the rim") {
  Square square(3, 5);
  square.network.open(square.across(3, 7));  // on the rim, but dry
  CHECK_FALSE(square.network.reached_rim());
  square.network.open(square.across(3, 6));
  CHECK(square.network.reached_rim());
}
