/// @file
/// Friction angle and cohesion from strengths under several confinements.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <hfdem/measure/slit_readings.hpp>

namespace hfdem::measure {

/// The straight Mohr-Coulomb envelope sigma_1 = q + K sigma_3, with K = (1 + sin phi) / (1 - sin
/// phi) and q = 2 c sqrt(K).
struct MohrCoulomb {
  double friction_angle;  ///< phi, deg
  double cohesion;        ///< c, Pa
  Line envelope;          ///< sigma_1 over sigma_3, Pa

  /// By least squares of sigma_1 over all tests, the unconfined one included. An assembly's
  /// envelope is curved: the values depend on the confinements.
  /// @param strengths (sigma_3, sigma_1) of each test, Pa; at two confinements or more
  static MohrCoulomb through(const std::vector<Vec2>& strengths) {
    const Line line = Line::through(strengths);
    const double K = line.slope;
    return {std::asin((K - 1) / (K + 1)) * 180 / std::numbers::pi,
            line.intercept / (2 * std::sqrt(K)), line};
  }
};

}  // namespace hfdem::measure
