/// @file
/// The plane-strain (KGD) hydraulic fracture: the storage-toughness vertex.
///
/// Source: the paper's Eqs. 10-12; E. Detournay, Int. J. Geomech. 4 (2004) 35-45. The coefficients
/// are the closed forms (2 sqrt(2) / pi)^(2/3) and the root of half of it.
#pragma once

#include <cmath>
#include <numbers>

namespace hfdem::analytic {

/// A symmetric fracture at one instant.
struct KgdFracture {
  double half_length;   ///< l, m
  double width;         ///< at the injection, m
  double net_pressure;  ///< at the injection, Pa

  double full_length() const { return 2 * half_length; }
  /// Width at a distance from the injection, m (uniform pressure: an ellipse).
  double width_at(double distance) const {
    const double xi = distance / half_length;
    return xi * xi < 1 ? width * std::sqrt(1 - xi * xi) : 0;
  }
};

/// K' = 4 sqrt(2 / pi) K_IC, Pa sqrt(m).
inline double k_prime(double K_IC) { return 4 * std::sqrt(2 / std::numbers::pi) * K_IC; }

/// No viscosity, no leak-off, an infinite plane.
/// @param E_prime plane modulus E', Pa
/// @param K_IC fracture toughness, Pa sqrt(m)
/// @param rate total injection rate of both wings, m2/s
/// @param time since injection began, s
inline KgdFracture toughness_vertex(double E_prime, double K_IC, double rate, double time) {
  const double coefficient = std::pow(2 * std::numbers::sqrt2 / std::numbers::pi, 2.0 / 3);
  const double K = k_prime(K_IC), volume = rate * time;
  const double half_length = coefficient * std::pow(E_prime * volume / K, 2.0 / 3);
  const double width = std::sqrt(coefficient / 2) * std::cbrt(K * K * volume / (E_prime * E_prime));
  return {half_length, width, time > 0 ? E_prime * width / (4 * half_length) : 0};
}

}  // namespace hfdem::analytic
