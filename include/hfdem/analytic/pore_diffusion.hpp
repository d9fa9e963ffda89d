/// @file
/// Fluid that enters a porous half-plane from its wall at a constant pressure, in one dimension.
///
/// With the hydraulic diffusivity D = k K_f / (mu phi), k the permeability and phi the porosity,
///
///   saturated   P(x, t) = P0 erfc(x / (2 sqrt(D t)))
///   dry         P(x, t) = P0 [1 - erf(x / (2 sqrt(D t))) / erf(lambda)] up to the front at
///               2 lambda sqrt(D t),   sqrt(pi) lambda exp(lambda^2) erf(lambda) = P0 / K_f
///
/// Source: the first is the classical solution of diffusion; the second is Stefan's problem, the
/// front moving with the fluid that reaches it (H. S. Carslaw, J. C. Jaeger, Conduction of Heat in
/// Solids, 1959, Section 11.2).
#pragma once

#include <cmath>
#include <numbers>

namespace hfdem::analytic {

/// A wall at a constant pressure.
struct PoreDiffusion {
  double diffusivity = 0;   ///< D, m2/s
  double pressure = 0;      ///< P0, Pa
  double bulk_modulus = 0;  ///< K_f, Pa

  /// How far pressure reaches, m: sqrt(D t). @param time s
  double reach(double time) const { return std::sqrt(diffusivity * time); }

  /// In pores that were full, Pa. @param x distance from the wall, m @param time s
  double saturated(double x, double time) const {
    return pressure * std::erfc(x / (2 * reach(time)));
  }
  /// What full pores gain per area of the wall, over the porosity, m. @param time s
  double gained(double time) const {
    return 2 * pressure / bulk_modulus * reach(time) / std::sqrt(std::numbers::pi);
  }

  /// lambda: the front's distance over 2 sqrt(D t) in pores that were empty.
  double front_constant() const {
    const double wanted = pressure / bulk_modulus;
    double low = 0, high = 1 + std::sqrt(wanted);
    for (int k = 0; k < 200; ++k) {
      const double l = (low + high) / 2;
      (std::sqrt(std::numbers::pi) * l * std::exp(l * l) * std::erf(l) < wanted ? low : high) = l;
    }
    return low;
  }
  /// Of the front in pores that were empty, m. @param time s
  double front(double time) const { return 2 * front_constant() * reach(time); }
  /// In pores that were empty, Pa. @param x distance from the wall, m @param time s
  double dry(double x, double time) const {
    const double part = std::erf(x / (2 * reach(time))) / std::erf(front_constant());
    return part < 1 ? pressure * (1 - part) : 0;
  }
};

}  // namespace hfdem::analytic
