/// @file
/// Profiles along a KGD fracture: width, flow and the pressure that the flow uses up.
///
/// With xi = x / l, 0 at the injection and 1 at the tip:
///   width      w / w(0) = (1 + xi)^a (1 - xi)^b                E. V. Dontsov, Int. J. Fract. 205
///                                                              (2017) 221-237
///   flow       q(xi) = what the fracture beyond xi stores and leaks per second, while l grows as
///              t^alpha and fluid leaks by Carter's law
///   pressure   dp/dx = -mu' q / w^3
/// The approximate width has a small kink at the injection, so elasticity applied to it would give
/// an infinite pressure there. Hence the pressure drop is the fluid's, and the pressure level comes
/// from elasticity as a mean, which is exact for any pressure (Betti's theorem with a uniformly
/// pressurised crack): the integral of p (1 - xi^2)^(1/2) over (0, 1) is E' V / (8 l^2).
#pragma once

#include <cmath>
#include <numbers>

namespace hfdem::analytic {

/// Euler's beta function; std::beta is missing from some standard libraries.
inline double beta(double a, double b) {
  return std::tgamma(a) * std::tgamma(b) / std::tgamma(a + b);
}

/// Integral of u^(a-1) (1-u)^(b-1) over (0, x), for x in [0, 1].
inline double incomplete_beta(double x, double a, double b) {
  if (x > 0.5) return beta(a, b) - incomplete_beta(1 - x, b, a);
  double sum = 0, term = 1;
  for (int k = 0; k < 60 && std::abs(term) > 1e-17; ++k) {
    sum += term / (a + k);
    term *= x * (k + 1 - b) / (k + 1);
  }
  return std::pow(x, a) * sum;
}

/// Width relative to the injection: (1 + xi)^mouth (1 - xi)^tip. The default is an ellipse.
struct WidthShape {
  double mouth = 0.5;  ///< power of 1 + xi
  double tip = 0.5;    ///< power of 1 - xi: how the tip closes

  /// w / w(0) at `xi`; 0 beyond the tip.
  double at(double xi) const {
    return xi < 1 ? std::pow(1 + xi, mouth) * std::pow(1 - xi, tip) : 0;
  }
  /// Integral of the shape over (xi, 1).
  double area_beyond(double xi) const {
    return std::exp2(1 + mouth + tip) * incomplete_beta((1 - xi) / 2, tip + 1, mouth + 1);
  }
};

/// Flow along one wing and the pressure it uses up. The default is a fluid without viscosity.
struct FluidFlow {
  /// mu' Q l / (2 w(0)^3), Pa: the drop if all fluid flowed to the tip through the injection's
  /// width.
  double pressure_scale = 0;
  double growth = 2.0 / 3;  ///< alpha = d ln l / d ln t
  double efficiency = 1;    ///< fraction of the injected fluid that is in the fracture

  /// q / q(0) at `xi`, for a width of shape `shape`.
  double at(double xi, const WidthShape& shape) const {
    // Both balances of fluid, of all that was injected and of what is injected now, hold if this
    // part of the flow leaks and the rest is stored.
    const double leaking = (1 - efficiency) * (growth + 0.5);
    const double leak = incomplete_beta(1 - std::pow(xi, 1 / growth), 0.5, growth);
    return ((1 - leaking) * shape.area_beyond(xi) + efficiency * growth * xi * shape.at(xi)) /
               shape.area_beyond(0) +
           leaking * leak / beta(0.5, growth);
  }

  /// Pressure at the injection minus pressure at `xi`, Pa; infinite at the tip.
  double drop(double xi, const WidthShape& shape) const {
    if (pressure_scale == 0) return 0;
    if (xi >= 1) return INFINITY;
    return pressure_scale *
           graded_integral(xi, [&](double s) { return at(s, shape) / cube(shape.at(s)); });
  }

  /// Pressure at the injection minus the mean that holds the fracture open, Pa.
  double drop_to_mean(const WidthShape& shape) const {
    if (pressure_scale == 0) return 0;
    return pressure_scale * 4 / std::numbers::pi * graded_integral(1, [&](double s) {
             const double weight = (std::acos(s) - s * std::sqrt(1 - s * s)) / 2;
             return weight * at(s, shape) / cube(shape.at(s));
           });
  }

 private:
  static double cube(double v) { return v * v * v; }

  /// Midpoint rule over (0, xi); the powers of 1 - s at the tip are smooth in y = (1 - s)^(1/4).
  template <class F>
  static double graded_integral(double xi, F&& f) {
    constexpr int cells = 200;
    const double nearest = std::pow(1 - xi, 0.25), step = (1 - nearest) / cells;
    double sum = 0;
    for (int k = 0; k < cells; ++k) {
      const double y = nearest + (k + 0.5) * step;
      sum += 4 * cube(y) * f(1 - cube(y) * y);
    }
    return sum * step;
  }
};

}  // namespace hfdem::analytic
