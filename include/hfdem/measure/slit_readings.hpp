/// @file
/// What slit tests read, and the straight lines through it.
#pragma once

#include <vector>

#include <hfdem/base/vec2.hpp>

namespace hfdem::measure {

/// What a slit does at one pressure.
struct SlitState {
  double net_pressure;  ///< above the in-situ stress across the slit, Pa
  double opening;       ///< w - w0 at the middle, m
  double volume;        ///< sum of l_p (w - w0), m2
};

/// A straight line through points, by least squares.
struct Line {
  double slope = 0, intercept = 0;  ///< y = slope x + intercept

  /// @param points at two places x or more
  static Line through(const std::vector<Vec2>& points) {
    Vec2 mean{};
    for (const Vec2& p : points) mean = mean + (1 / static_cast<double>(points.size())) * p;
    double covariance = 0, variance = 0;
    for (const Vec2& p : points) {
      covariance += (p.x - mean.x) * (p.y - mean.y);
      variance += (p.x - mean.x) * (p.x - mean.x);
    }
    const double slope = covariance / variance;
    return {slope, mean.y - slope * mean.x};
  }
};

/// What one slit said.
struct SlitTest {
  int contacts = 0;                  ///< broken ones
  double half_length = 0;            ///< a, m
  double net_pressure_at_break = 0;  ///< Pa
  std::vector<SlitState> states{};   ///< at rising pressures below it, tips softened
  Line opening{}, volume{};          ///< against net pressure

  /// All of it.
  void exchange(auto& archive) {
    archive(contacts, half_length, net_pressure_at_break, states, opening.slope, opening.intercept,
            volume.slope, volume.intercept);
  }
};

}  // namespace hfdem::measure
