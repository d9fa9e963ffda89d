/// @file
/// A straight crack under uniform pressure in an infinite plane.
///
/// Source: A. A. Griffith, Phil. Trans. R. Soc. A 221 (1921) 163-198; I. N. Sneddon, Proc. R. Soc.
/// A 187 (1946) 229-260.
#pragma once

#include <cmath>
#include <numbers>

namespace hfdem::analytic {

/// A crack and what opens it.
struct PressurisedCrack {
  double E_prime;       ///< plane modulus, Pa
  double half_length;   ///< m
  double net_pressure;  ///< above the stress that closes the crack, Pa

  /// Width at the centre, m.
  double width() const { return 4 * net_pressure * half_length / E_prime; }
  /// Width at a distance from the centre, m.
  double width_at(double distance) const {
    const double xi = distance / half_length;
    return xi * xi < 1 ? width() * std::sqrt(1 - xi * xi) : 0;
  }
  /// Area of the ellipse, m2: volume per metre of thickness.
  double volume() const { return std::numbers::pi / 2 * half_length * width(); }
  /// K_I, Pa sqrt(m).
  double stress_intensity() const {
    return net_pressure * std::sqrt(std::numbers::pi * half_length);
  }
  /// Stress that the net pressure adds on the crack's line, Pa, tension positive, the same along
  /// and across the line: infinite at the tip, and minus the net pressure inside the crack.
  double stress_at(double distance) const {
    const double xi = std::abs(distance) / half_length;
    return xi < 1 ? -net_pressure : net_pressure * (xi / std::sqrt(xi * xi - 1) - 1);
  }
};

/// Net pressure at which a crack starts to grow, Pa: K_I = K_IC.
inline double growth_pressure(double K_IC, double half_length) {
  return K_IC / std::sqrt(std::numbers::pi * half_length);
}

}  // namespace hfdem::analytic
