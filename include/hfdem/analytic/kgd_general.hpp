/// @file
/// The plane-strain (KGD) fracture with toughness, viscosity and leak-off at once.
///
/// Source: E. V. Dontsov, "An approximate solution for a plane strain hydraulic fracture that
/// accounts for fracture toughness, fluid viscosity, and leak-off", Int. J. Fract. 205 (2017)
/// 221-237. The width near the tip obeys the tip's solution, taken at s = l with the speed V =
/// alpha l / t; its continuation to the injection is w(0) (1 + xi)^a (1 - xi)^b; all injected fluid
/// is in the fracture or leaked off, at xi since t xi^(1/alpha). Two equations for l and w(0), with
/// alpha = d ln l / d ln t found by differentiating them at a fixed alpha.
///
/// Against converged numerical solutions for K_m = 0.2 to 10 (0.7 to 7 with leak-off): l within
/// 0.55 %, w(0) within 0.8 %, efficiency within 0.002. The net pressure (kgd_profile.hpp) is not
/// Dontsov's: at the injection within 0.9 %.
#pragma once

#include <cmath>

#include <hfdem/analytic/kgd.hpp>
#include <hfdem/analytic/kgd_tip.hpp>

namespace hfdem::analytic {

namespace detail {

/// The zero between a and b of a function with opposite signs there, otherwise b (regula falsi,
/// Illinois rule): where the function is `precision` of its value at a, or less.
template <class F>
double zero_between(double a, double b, F&& f, double precision = 1e-14) {
  double f_a = f(a), f_b = f(b);
  if ((f_a < 0) == (f_b < 0)) return b;
  const double close = precision * std::abs(f_a);
  for (int k = 0; k < 200 && std::abs(f_b) > close && std::abs(b - a) > 1e-15 * std::abs(b); ++k) {
    double c = b - f_b * (b - a) / (f_b - f_a);
    if (!(c > std::fmin(a, b) && c < std::fmax(a, b))) c = (a + b) / 2;
    const double f_c = f(c);
    if ((f_c < 0) != (f_b < 0))
      a = b, f_a = f_b;
    else
      f_a /= 2;
    b = c, f_b = f_c;
  }
  return b;
}

/// A fracture that obeys the tip's solution, in the units of KgdScales.
struct TippedFracture {
  double tip_width;  ///< the tip's width, continued to the injection
  double half_length;
  double growth;  ///< alpha
  KgdTip tip;
  WidthShape shape{};

  /// Width at the injection.
  double width() const { return tip_width / std::exp2(shape.mouth); }
  /// Volume of one wing.
  double stored() const { return width() * half_length * shape.area_beyond(0); }
  /// Volume leaked off one wing.
  double leaked() const {
    return tip_width * half_length * tip.leak_off * std::pow(growth, 1.5) * beta(growth, 1.5);
  }
  double efficiency() const { return stored() / (stored() + leaked()); }
};

/// The longest fracture of a given tip width.
inline TippedFracture longest(const KgdScales& s, double growth, double tip_width) {
  const double leak_off = 2 * s.leak_off / (std::sqrt(growth) * tip_width);
  const auto tip = [&](double half_length) {
    return KgdTip{std::fmin(1, s.toughness * std::sqrt(half_length) / tip_width), leak_off};
  };
  // Either toughness or viscosity alone allows a longer one.
  const double drag = s.viscosity * growth;
  const double tough = tip_width / s.toughness * (tip_width / s.toughness);
  const double viscous = tip_width * std::cbrt(tip(0).viscosity() / drag);
  const double limit = std::fmin(tough, viscous);
  const double part = zero_between(0, 1, [&](double x) {
    return drag * std::pow(x * limit / tip_width, 3) - tip(x * limit).viscosity();
  });
  TippedFracture f{tip_width, part * limit, growth, tip(part * limit)};
  // Dontsov's shape: between those of the four vertices.
  f.shape.tip = f.tip.exponent();
  f.shape.mouth = 0.5;
  const double efficiency = f.efficiency();
  const double tough_part = std::pow(f.tip.toughness, 3);
  f.shape.mouth =
      0.5 * tough_part + (1 - tough_part) * (0.588 * efficiency + 0.520 * (1 - efficiency));
  return f;
}

/// The one that holds the injected fluid: half of it in one wing.
inline TippedFracture with_all_fluid(const KgdScales& s, double growth) {
  const auto surplus = [&](double log_width) {
    const TippedFracture f = longest(s, growth, std::exp(log_width));
    return std::log(2 * (f.stored() + f.leaked()));
  };
  double a = 0, step = surplus(a) > 0 ? -1 : 1;
  while (std::abs(step) < 2000 && (surplus(a + step) > 0) == (step < 0)) a += step, step *= 2;
  return longest(s, growth, std::exp(zero_between(a, a + step, surplus)));
}

}  // namespace detail

/// The general solution.
/// @throws InvalidParameter for numbers out of their range, or with neither toughness nor viscosity
inline KgdFracture general_kgd(const KgdProblem& p) {
  validate(p, "kgd");
  if (p.K_IC < 1e-20 && p.viscosity < 1e-20)
    throw InvalidParameter("K_IC = " + to_text(p.K_IC) +
                           " Pa m^0.5 together with viscosity = " + to_text(p.viscosity) +
                           " Pa s is not allowed: one of them must be at least 1e-20, for nothing "
                           "else holds the tips back");
  const KgdScales s = scales(p);
  const auto log_length = [&](double growth, double log_time) {
    const KgdScales later{s.length, s.toughness * std::exp(-log_time / 4),
                          s.viscosity * std::exp(-log_time), s.leak_off};
    return log_time / 2 + std::log(detail::with_all_fluid(later, growth).half_length);
  };
  double growth = 2.0 / 3;  // where all fluid is stored; each round brings 1.5 digits
  for (int round = 0; round < 5; ++round) {
    constexpr double h = 1e-3;
    growth = (log_length(growth, h) - log_length(growth, -h)) / (2 * h);
  }
  const detail::TippedFracture f = detail::with_all_fluid(s, growth);
  const double half_length = s.length * f.half_length, width = s.length * f.width();
  const FluidFlow flow{pressure_scale(p, half_length, width), growth, f.efficiency()};
  const double mean = p.E_prime * f.stored() / (std::numbers::pi * f.half_length * f.half_length);
  return {half_length, width, mean + flow.drop_to_mean(f.shape), f.efficiency(), f.shape, flow};
}

}  // namespace hfdem::analytic
