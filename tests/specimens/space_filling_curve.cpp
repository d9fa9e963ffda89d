// Numbering along the Hilbert curve.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <hfdem/base/random.hpp>
#include <hfdem/setup/space_filling_curve.hpp>
#include <hfdem/setup/square_array.hpp>

#include <doctest/doctest.h>

TEST_CASE("the curve visits every cell once, and each step leads to the next cell") {
  constexpr std::uint32_t side = 32;
  std::vector<int> x(side * side, -1), y(side * side, -1);
  for (std::uint32_t column = 0; column < side; ++column)
    for (std::uint32_t row = 0; row < side; ++row) {
      const auto place = hfdem::hilbert_index(column, row, side);
      REQUIRE(place < side * side);
      CHECK(x[place] == -1);
      x[place] = static_cast<int>(column);
      y[place] = static_cast<int>(row);
    }
  for (std::size_t k = 1; k < side * side; ++k)
    CHECK(std::abs(x[k] - x[k - 1]) + std::abs(y[k] - y[k - 1]) == 1);
}

TEST_CASE("renumbering keeps the discs and their pairs, and puts neighbours side by side") {
  const auto array = hfdem::square_array(32, 16, 5e-3);
  const auto order = hfdem::order_along_curve(array);
  const auto s = hfdem::renumbered(array, order);
  REQUIRE(s.size() == array.size());
  CHECK(s.width == array.width);
  CHECK(s.height == array.height);
  CHECK(s.density == array.density);
  CHECK(s.bonding_gap == array.bonding_gap);
  CHECK(s.input_index == order);
  CHECK(hfdem::renumbered(s, hfdem::order_along_curve(s)).input_index == order);
  REQUIRE(s.pairs.size() == array.pairs.size());
  std::vector<int> times(array.size(), 0);
  for (hfdem::Index k = 0; k < s.size(); ++k) {
    ++times[order[k]];
    CHECK(s.centre[k] == array.centre[order[k]]);
  }
  CHECK(times == std::vector<int>(array.size(), 1));
  for (std::size_t k = 0; k < s.pairs.size(); ++k) {
    CHECK(s.pairs[k].first < s.pairs[k].second);
    CHECK(std::abs(s.gap(s.pairs[k])) < 1e-9);
  }
  for (std::size_t k = 1; k < s.size(); ++k)
    CHECK(hfdem::norm(s.centre[k] - s.centre[k - 1]) < 0.0101);

  const auto upright = hfdem::square_array(16, 32, 5e-3);
  const auto along = hfdem::order_along_curve(upright);
  for (std::size_t k = 1; k < along.size(); ++k)
    CHECK(hfdem::norm(upright.centre[along[k]] - upright.centre[along[k - 1]]) < 0.0101);
}
