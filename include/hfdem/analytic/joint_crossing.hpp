/// @file
/// Whether a fluid-driven crack crosses a closed joint that it meets, or makes it slip.
///
/// Source: C. E. Renshaw, D. D. Pollard, "An experimentally verified criterion for propagation
/// across unbounded frictional interfaces in brittle, linear elastic materials", Int. J. Rock Mech.
/// Min. Sci. 32 (1995) 237-249, for a joint across the crack; H. Gu, X. Weng, "Criterion for
/// fractures crossing frictional interfaces at non-orthogonal angles", 44th U.S. Rock Mechanics
/// Symposium (2010), paper ARMA 10-198, for any angle.
///
/// The crack's tip stands at the joint. Its field, that of a stress intensity factor, and the
/// in-situ stress are superposed. The crack goes on if the joint holds everything together until
/// the rock behind it breaks: at the distance from the tip where the largest tension along the
/// joint is just the rock's strength, the joint must not slip, to either side of the crack.
#pragma once

#include <cmath>
#include <numbers>

namespace hfdem::analytic {

/// Rock, joint and in-situ stress where a crack meets a joint; SI, compression positive.
struct JointCrossing {
  double angle = 90;              ///< of the joint to the crack, deg, above 0 up to 90
  double stress_along = 12e6;     ///< in-situ stress along the crack, the greater one, Pa
  double stress_across = 10e6;    ///< in-situ stress that closes the crack, Pa
  double tensile_strength = 5e6;  ///< of the rock, Pa
  double friction = 0.5;          ///< coefficient of the joint
  double cohesion = 0;            ///< of the joint, Pa

  /// Whether the crack crosses.
  bool crosses() const {
    const double ahead = angle * std::numbers::pi / 180;
    return holds(ahead) && holds(ahead - std::numbers::pi);
  }

  /// The least stress along the crack with which it crosses, Pa; the others as they are.
  /// @param highest where the search ends, Pa; the answer if it does not cross below
  double least_stress_along(double highest = 1e9) const {
    double low = stress_across, high = highest;
    for (int k = 0; k < 60; ++k) {
      JointCrossing probe = *this;
      probe.stress_along = (low + high) / 2;
      (probe.crosses() ? high : low) = probe.stress_along;
    }
    return high;
  }

 private:
  /// Tension positive; x along the crack.
  struct Stress {
    double xx, yy, xy;
    double largest() const { return (xx + yy) / 2 + std::hypot((xx - yy) / 2, xy); }
  };

  /// At an angle to the crack's direction, where the tip's field has the strength k, Pa.
  Stress at(double theta, double k) const {
    const double half = theta / 2, s = std::sin(half), c = std::cos(half);
    const double s3 = std::sin(3 * half), c3 = std::cos(3 * half);
    return {-stress_along + k * c * (1 - s * s3), -stress_across + k * c * (1 + s * s3),
            k * s * c * c3};
  }

  /// Whether the joint does not slip where the tension is the rock's strength.
  bool holds(double theta) const {
    double low = 0, high = 1e3 * (stress_along + stress_across + tensile_strength);
    for (int k = 0; k < 100; ++k) {
      const double middle = (low + high) / 2;
      (at(theta, middle).largest() < tensile_strength ? low : high) = middle;
    }
    const auto [xx, yy, xy] = at(theta, high);
    const double twice = 2 * theta;
    const double normal = (xx + yy) / 2 - (xx - yy) / 2 * std::cos(twice) - xy * std::sin(twice);
    const double shear = -(xx - yy) / 2 * std::sin(twice) + xy * std::cos(twice);
    return std::abs(shear) < cohesion - friction * normal;
  }
};

}  // namespace hfdem::analytic
