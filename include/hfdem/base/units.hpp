/// @file
/// Units as a person says them; every value becomes SI: `5_mm`, `17_GPa`, `0.06_cp`.
#pragma once

#include <numbers>

namespace hfdem {
inline namespace literals {

// NOLINTBEGIN: one line per unit reads best
/// @name Units
/// @{
/// The value in SI (angles in radians).
constexpr double operator""_m(long double v) { return static_cast<double>(v); }
constexpr double operator""_mm(long double v) { return static_cast<double>(v * 1e-3L); }
constexpr double operator""_um(long double v) { return static_cast<double>(v * 1e-6L); }
constexpr double operator""_s(long double v) { return static_cast<double>(v); }
constexpr double operator""_Pa(long double v) { return static_cast<double>(v); }
constexpr double operator""_MPa(long double v) { return static_cast<double>(v * 1e6L); }
constexpr double operator""_GPa(long double v) { return static_cast<double>(v * 1e9L); }
/// Centipoise, the viscosity unit of the field: 1e-3 Pa s.
constexpr double operator""_cp(long double v) { return static_cast<double>(v * 1e-3L); }
constexpr double operator""_deg(long double v) {
  return static_cast<double>(v * std::numbers::pi_v<long double> / 180);
}

constexpr double operator""_m(unsigned long long v) { return static_cast<double>(v); }
constexpr double operator""_mm(unsigned long long v) { return static_cast<double>(v) / 1e3; }
constexpr double operator""_um(unsigned long long v) { return static_cast<double>(v) / 1e6; }
constexpr double operator""_s(unsigned long long v) { return static_cast<double>(v); }
constexpr double operator""_Pa(unsigned long long v) { return static_cast<double>(v); }
constexpr double operator""_MPa(unsigned long long v) { return static_cast<double>(v) * 1e6; }
constexpr double operator""_GPa(unsigned long long v) { return static_cast<double>(v) * 1e9; }
constexpr double operator""_cp(unsigned long long v) { return static_cast<double>(v) / 1e3; }
constexpr double operator""_deg(unsigned long long v) {
  return static_cast<double>(v) * std::numbers::pi / 180;
}
/// @}
// NOLINTEND

}  // namespace literals
}  // namespace hfdem
