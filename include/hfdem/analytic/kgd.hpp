/// @file
/// The plane-strain (KGD) hydraulic fracture in an infinite plane and its four vertices, each the
/// exact solution of one limit: fluid stored in the fracture or leaked into the rock, energy spent
/// on toughness or on viscosity.
///
///   storage-toughness  (K)   E. Detournay, Int. J. Geomech. 4 (2004) 35-45; the paper's Eqs. 10-12
///   storage-viscosity  (M)   J. I. Adachi, E. Detournay, Int. J. Numer. Anal. Meth. Geomech. 26
///                            (2002) 579-604
///   leak-off-toughness (K~)  A. P. Bunger, E. Detournay, D. I. Garagash, Int. J. Fract. 134 (2005)
///                            175-190
///   leak-off-viscosity (M~)  J. I. Adachi, E. Detournay, Eng. Fract. Mech. 75 (2008) 4666-4694
/// K and K~ are closed forms. The constants of M and M~ are a converged similarity solution (to
/// 3e-6); those published, 0.6152 / 1.1265 and 0.8165, are within 0.08 % of them. The shapes of the
/// width at M and M~ are Dontsov's (Int. J. Fract. 205 (2017) 221-237), within 0.5 % and 1 %.
#pragma once

#include <cmath>
#include <numbers>
#include <tuple>

#include <hfdem/analytic/kgd_profile.hpp>
#include <hfdem/base/fields.hpp>

namespace hfdem::analytic {

/// K' = 4 sqrt(2 / pi) K_IC, Pa sqrt(m).
inline double k_prime(double K_IC) { return 4 * std::sqrt(2 / std::numbers::pi) * K_IC; }

/// Constant injection into a fracture that grows symmetrically, without fluid lag.
struct KgdProblem {
  double E_prime = 0, K_IC = 0, viscosity = 0, leak_off = 0, rate = 0, time = 0;

  double K_prime() const { return k_prime(K_IC); }    ///< Pa sqrt(m)
  double mu_prime() const { return 12 * viscosity; }  ///< Pa s
  double C_prime() const { return 2 * leak_off; }     ///< m/s^0.5
  double volume() const { return rate * time; }       ///< injected by both wings, m2

  static constexpr auto fields() {
    using P = KgdProblem;
    // Wide enough for any rock and fluid, and no product of powers of them overflows.
    constexpr Range above_zero{.low = 1e-20, .high = 1e20}, from_zero{.low = 0, .high = 1e20};
    return std::tuple{
        Field{"E_prime", &P::E_prime, "Pa", above_zero, "plane modulus E' = E / (1 - nu^2)"},
        Field{"K_IC", &P::K_IC, "Pa m^0.5", from_zero, "fracture toughness"},
        Field{"viscosity", &P::viscosity, "Pa s", from_zero, "viscosity mu of the fluid"},
        Field{"leak_off", &P::leak_off, "m/s^0.5", from_zero, "Carter's leak-off coefficient C_L"},
        Field{"rate", &P::rate, "m2/s", above_zero, "total injection rate of both wings"},
        Field{"time", &P::time, "s", above_zero, "time since injection began"}};
  }
};

/// A symmetric fracture at one instant.
struct KgdFracture {
  double half_length = 0;   ///< l, m
  double width = 0;         ///< at the injection, m
  double net_pressure = 0;  ///< at the injection, Pa
  double efficiency = 1;    ///< volume of the fracture over volume injected
  WidthShape shape{};       ///< of the width along a wing
  FluidFlow flow{};         ///< along a wing

  double full_length() const { return 2 * half_length; }  ///< from tip to tip, m
  /// Volume of both wings, m2.
  double volume() const { return 2 * half_length * width * shape.area_beyond(0); }
  /// Width at a distance from the injection, m.
  double width_at(double distance) const { return width * shape.at(relative(distance)); }
  /// Net pressure at a distance from the injection, Pa; a viscous fluid's falls without bound
  /// towards the tip. Not a number beyond it.
  double net_pressure_at(double distance) const {
    const double xi = relative(distance);
    return xi <= 1 ? net_pressure - flow.drop(xi, shape) : std::nan("");
  }

 private:
  double relative(double distance) const { return std::abs(distance) / half_length; }
};

/// The numbers a problem consists of, without dimensions.
struct KgdScales {
  double length;     ///< (Q t)^(1/2), m: the unit of length and width
  double toughness;  ///< K' / (E' (Q t)^(1/4))
  double viscosity;  ///< mu' / (E' t)
  double leak_off;   ///< C' / Q^(1/2)
};

/// Those of a problem.
inline KgdScales scales(const KgdProblem& p) {
  const double length = std::sqrt(p.rate) * std::sqrt(p.time);
  return {length, p.K_prime() / p.E_prime / std::sqrt(length), p.mu_prime() / p.E_prime / p.time,
          p.C_prime() / std::sqrt(p.rate)};
}

/// mu' Q l / (2 w^3), Pa (FluidFlow::pressure_scale).
inline double pressure_scale(const KgdProblem& p, double half_length, double width) {
  return p.mu_prime() * (p.rate / width) * (half_length / width) / (2 * width);
}

/// E' w / (4 l), Pa: what opens an ellipse.
inline double even_pressure(const KgdProblem& p, double half_length, double width) {
  return p.E_prime * width / (4 * half_length);
}

/// K: no viscosity, no leak-off; l = 0.9324 (E' Q t / K')^(2/3).
inline KgdFracture storage_toughness(const KgdProblem& p) {
  const double coefficient = std::pow(2 * std::numbers::sqrt2 / std::numbers::pi, 2.0 / 3);
  const KgdScales s = scales(p);
  const double slenderness = std::pow(s.toughness, 2.0 / 3);
  const double half_length = coefficient * s.length / slenderness;
  const double width = std::sqrt(coefficient / 2) * s.length * slenderness;
  return {half_length, width, even_pressure(p, half_length, width)};
}

/// M: no toughness, no leak-off; l = 0.6154 (E' Q^3 t^4 / mu')^(1/6).
inline KgdFracture storage_viscosity(const KgdProblem& p) {
  const KgdScales s = scales(p);
  const double slenderness = std::pow(s.viscosity, 1.0 / 6);
  const double half_length = 0.615411 * s.length / slenderness;
  const double width = 1.125835 * s.length * slenderness;
  return {half_length,
          width,
          0.544817 * p.E_prime * std::cbrt(s.viscosity),
          1,
          {.mouth = 0.588, .tip = 2.0 / 3},
          {.pressure_scale = pressure_scale(p, half_length, width)}};
}

/// Q t^(1/2) / (pi C'), m: the half-length when almost all fluid has leaked off.
inline double leak_off_half_length(const KgdScales& s) {
  return s.length / (std::numbers::pi * s.leak_off);
}

/// K~: no viscosity, almost all fluid leaked off.
inline KgdFracture leak_off_toughness(const KgdProblem& p) {
  const KgdScales s = scales(p);
  const double half_length = leak_off_half_length(s);
  const double width = s.length * s.toughness / std::sqrt(2 * std::numbers::pi * s.leak_off);
  return {half_length,
          width,
          even_pressure(p, half_length, width),
          std::numbers::pi / 2 * (width / s.length) * (half_length / s.length),
          {},
          {.growth = 0.5, .efficiency = 0}};
}

/// M~: no toughness, almost all fluid leaked off.
inline KgdFracture leak_off_viscosity(const KgdProblem& p) {
  const KgdScales s = scales(p);
  const double half_length = leak_off_half_length(s);
  const double width = 0.816389 * s.length * std::pow(s.viscosity, 0.25) / std::sqrt(s.leak_off);
  return {
      half_length,
      width,
      0.751469 * p.E_prime * std::pow(s.viscosity, 0.25) * std::sqrt(s.leak_off),
      1.459991 * (width / s.length) * (half_length / s.length),
      {.mouth = 0.520, .tip = 0.625},
      {.pressure_scale = pressure_scale(p, half_length, width), .growth = 0.5, .efficiency = 0}};
}

/// The storage-toughness vertex without the other numbers of a problem; no fracture at time 0.
inline KgdFracture toughness_vertex(double E_prime, double K_IC, double rate, double time) {
  if (!(time > 0)) return {};
  return storage_toughness({.E_prime = E_prime, .K_IC = K_IC, .rate = rate, .time = time});
}

}  // namespace hfdem::analytic
