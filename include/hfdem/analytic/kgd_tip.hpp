/// @file
/// The tip of a hydraulic fracture that moves steadily through rock with toughness, against fluid
/// viscosity and Carter leak-off: what holds near the tip of every fracture.
///
/// Source: E. V. Dontsov, A. P. Peirce, J. Fluid Mech. 781 (2015) R1: at the distance s from the
/// tip, where the width is w and the tip's speed V, three numbers without dimensions are bound,
///   mu' V s^2 / (E' w^3) = g(K' s^(1/2) / (E' w), 2 C' s^(1/2) / (V^(1/2) w)).
/// This is their approximate closed form of g.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hfdem::analytic {

/// Two of the three numbers, which give the third.
struct KgdTip {
  double toughness;  ///< K' s^(1/2) / (E' w): 0 without toughness, 1 without viscosity
  double leak_off;   ///< 2 C' s^(1/2) / (V^(1/2) w)

  /// mu' V s^2 / (E' w^3).
  double viscosity() const {
    const double d = std::clamp(excess(), 1e-8, 1.0 / 3 - 1e-8);  // the ends are limits of 0 / 0
    constexpr double pi = std::numbers::pi;
    const double C1 = 4 * (1 - 2 * d) / (d * (1 - d)) * std::tan(pi * d);
    const double C2 = 16 * (1 - 3 * d) / (3 * d * (2 - 3 * d)) * std::tan(1.5 * pi * d);
    return integral(toughness, leak_off * C2 / C1) / C1;
  }

  /// The power of s with which the width opens: 1/2 (toughness), 5/8 (viscosity and leak-off) to
  /// 2/3 (viscosity).
  double exponent() const { return (1 + excess()) / 2; }

 private:
  /// Twice the exponent, less one, by the zeroth-order solution.
  double excess() const {
    // Widths at the ends: w^3 = beta_m^3 mu' V s^2 / E', and w^8 = beta_mt^8 (...) s^5.
    const double beta_m_3 = 2 * std::pow(3, 2.5);
    const double beta_mt_4 = 256 / (15 * (std::numbers::sqrt2 - 1));
    const double C = 0.75 * beta_mt_4 / beta_m_3 * leak_off;
    return integral(toughness, C) * (1 + C);
  }

  /// Integral of y^3 / (y + C) over (K, 1).
  static double integral(double K, double C) {
    if (C < 1e-100) return (1 - K * K * K) / 3;  // no more infinity times 0 where K = 0
    if (C < 10)
      return (1 - K * K * K) / 3 - C * (1 - K * K) / 2 + C * C * (1 - K) -
             C * C * C * std::log1p((1 - K) / (K + C));
    // The closed form cancels where leak-off is strong; the series in 1 / C does not.
    double sum = 0, factor = 1 / C, power = K * K * K * K;
    for (int k = 4; k < 18; ++k) {
      sum += factor * (1 - power) / k;
      factor /= -C;
      power *= K;
    }
    return sum;
  }
};

}  // namespace hfdem::analytic
