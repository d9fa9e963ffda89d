/// @file
/// Numbers discs along a space-filling curve, so that neighbours in the plane are neighbours in
/// memory: D. Hilbert, "Ueber die stetige Abbildung einer Linie auf ein Flaechenstueck", Math. Ann.
/// 38 (1891) 459-460.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// The place of a cell on the Hilbert curve through a square of `side` by `side` cells.
/// @param x column, less than `side`
/// @param y row, less than `side`
/// @param side a power of two, at most 2^16
constexpr std::uint32_t hilbert_index(std::uint32_t x, std::uint32_t y, std::uint32_t side) {
  std::uint32_t index = 0;
  for (std::uint32_t half = side / 2; half > 0; half /= 2) {
    const bool right = (x & half) != 0, upper = (y & half) != 0;
    index = 4 * index + (right ? (upper ? 2U : 3U) : (upper ? 1U : 0U));
    // Within the lower quarters the curve is mirrored about a diagonal.
    if (upper) continue;
    if (right) x = side - 1 - x, y = side - 1 - y;
    std::swap(x, y);
  }
  return index;
}

/// The discs in the order in which the curve through the specimen's box meets their centres.
inline std::vector<Index> order_along_curve(const Specimen& s) {
  constexpr std::uint32_t side = 1U << 16U;
  const double cells = side / std::fmax(s.width, s.height);
  const auto cell = [&](double at) {
    return static_cast<std::uint32_t>(std::clamp(at * cells, 0.0, side - 1.0));
  };
  // The curve starts along the longer side, and does not leave a box that fills half the square.
  const bool upright = s.height >= s.width;
  std::vector<std::pair<std::uint32_t, Index>> met;
  for (Index i = 0; i < s.size(); ++i) {
    const std::uint32_t x = cell(s.centre[i].x), y = cell(s.centre[i].y);
    met.emplace_back(upright ? hilbert_index(x, y, side) : hilbert_index(y, x, side), i);
  }
  std::sort(met.begin(), met.end());
  std::vector<Index> order;
  for (const auto& [place, disc] : met) order.push_back(disc);
  return order;
}

/// The same specimen with its discs numbered anew; `input_index` keeps their first numbers.
/// @param s the specimen
/// @param order `order[k]` is the present number of the disc that becomes number k
inline Specimen renumbered(const Specimen& s, const std::vector<Index>& order) {
  Specimen result{
      .width = s.width, .height = s.height, .density = s.density, .bonding_gap = s.bonding_gap};
  std::vector<Index> number(s.size());
  for (Index k = 0; k < order.size(); ++k) {
    result.centre.push_back(s.centre[order[k]]);
    result.radius.push_back(s.radius[order[k]]);
    result.input_index.push_back(s.input_index.empty() ? order[k] : s.input_index[order[k]]);
    number[order[k]] = k;
  }
  for (const Pair p : s.pairs) {
    const auto [first, second] = std::minmax(number[p.first], number[p.second]);
    result.pairs.push_back({first, second});
  }
  result.joints = s.joints;
  for (JointPair& joint : result.joints.pairs) {
    const Index first = number[joint.bodies.first], second = number[joint.bodies.second];
    if (first > second) joint.normal = -joint.normal;
    joint.bodies = {std::min(first, second), std::max(first, second)};
  }
  std::sort(result.joints.pairs.begin(), result.joints.pairs.end(),
            [](const JointPair& a, const JointPair& b) { return a.bodies < b.bodies; });
  return result;
}

}  // namespace hfdem
