/// @file
/// What a run injects: for captions, and for references that hold for one point or one rate.
#pragma once

#include <string>

#include <hfdem/analytic/kgd.hpp>
#include <hfdem/state/injection.hpp>

namespace hfdem::support {

/// Rate and points, for captions.
/// @param fluid " of a fluid of 100 cp", or nothing
inline std::string described(const Injection& injection, const std::string& fluid) {
  std::string text = in_words(injection.rate * 1e4) + " × 10^{-4} m²/s" + fluid + " injected";
  if (injection.rise > 0) text += ", after a rise of " + in_words(injection.rise) + " s";
  if (!injection.schedule.empty()) text += " at first, then by a schedule";
  if (!injection.further_points.empty())
    text += " through " + std::to_string(1 + injection.further_points.size()) + " points";
  return text;
}

/// The KGD fracture without viscosity and leak-off: it depends on the volume injected alone,
/// however the rate changed.
/// @param E_prime of the rock, Pa
/// @param K_IC of the rock, Pa sqrt(m)
/// @param injection through one point
/// @param time since it began, s
inline analytic::KgdFracture toughness_vertex(double E_prime, double K_IC,
                                              const Injection& injection, double time) {
  if (injection.schedule.empty() && injection.rise == 0)
    return analytic::toughness_vertex(E_prime, K_IC, injection.rate, time);
  const double volume = InjectionRate(injection).volume(0, time);
  if (!(volume > 0)) return {};
  return analytic::toughness_vertex(E_prime, K_IC, volume / time, time);
}

/// A prediction holds for one crack that takes what a constant rate gives.
/// @throws InvalidParameter if the rate changes or is shared by several points
inline void check_predictable(const Injection& injection) {
  const std::string allowed = "left out: the prediction is for one point and a constant rate";
  if (injection.rise > 0) refuse("injection", "rise", to_text(injection.rise) + " s", allowed);
  if (!injection.schedule.empty())
    refuse("injection", "schedule", to_text(injection.schedule), allowed);
  if (!injection.further_points.empty())
    refuse("injection", "further_points", to_text(injection.further_points), allowed);
}

}  // namespace hfdem::support
