/// @file
/// Mean strains of an assembly, and the elastic moduli that follow from them.
#pragma once

#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include <hfdem/state/discs.hpp>

namespace hfdem::measure {

/// Raw values of the plane assembly, tested with its sides free to move.
struct ElasticModuli {
  double young;    ///< Pa
  double poisson;  ///< -
};

/// Mean strains (shortening positive) by a straight line through the displacements of some discs:
/// measured on the grains, not between platens.
inline Vec2 mean_shortening(const Discs& discs, std::span<const Index> some) {
  const auto slope = [&](double Vec2::*axis, int lane) {
    double mean_position = 0, mean_displacement = 0, covariance = 0, variance = 0;
    const auto count = static_cast<double>(some.size());
    for (const Index i : some) {
      mean_position += discs.centre[i].*axis / count;
      mean_displacement += discs.displacement[i][lane] / count;
    }
    for (const Index i : some) {
      const double away = discs.centre[i].*axis - mean_position;
      covariance += away * (discs.displacement[i][lane] - mean_displacement);
      variance += away * away;
    }
    return -covariance / variance;
  };
  return {slope(&Vec2::x, 0), slope(&Vec2::y, 1)};
}

/// The same of all discs.
inline Vec2 mean_shortening(const Discs& discs) {
  std::vector<Index> all(discs.size());
  std::iota(all.begin(), all.end(), Index{0});
  return mean_shortening(discs, all);
}

}  // namespace hfdem::measure
