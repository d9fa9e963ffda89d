/// @file
/// What kgd_reference prints and draws: reference solutions as JSON, and the map of regimes.
#pragma once

#include <hfdem/analytic/kgd_regime.hpp>
#include <hfdem/analytic/plate_growth.hpp>
#include <hfdem/observe/regime_map.hpp>

#include "support/kgd_reference_options.hpp"
#include "support/summary.hpp"

namespace hfdem::support {

/// A fracture's numbers, below `path` ("" or a name and '/').
inline void describe(Summary& json, const std::string& path, const analytic::KgdFracture& f) {
  json.set(path + "half_length_m", f.half_length);
  json.set(path + "full_length_m", f.full_length());
  json.set(path + "aperture_at_injection_m", f.width);
  json.set(path + "net_pressure_Pa", f.net_pressure);
  json.set(path + "efficiency", f.efficiency);
}

inline std::string name(analytic::KgdRegime regime) {
  return std::string(names_of<analytic::KgdRegime>[static_cast<std::size_t>(regime)]);
}

/// The general solution, its place on the map of regimes, and the nearest vertex.
inline void describe(Summary& json, const analytic::KgdProblem& p, const analytic::KgdFracture& f) {
  describe(json, "", f);
  json.set("tau", analytic::dimensionless_time(p));
  json.set("K_m", analytic::dimensionless_toughness(p));
  json.set("regime", name(analytic::regime(p)));
  const auto nearest = analytic::nearest_vertex(p, f);
  json.set("nearest_vertex/name", name(nearest.regime));
  json.set("nearest_vertex/distance", nearest.distance);
  describe(json, "nearest_vertex/", nearest.fracture);
}

/// Width and net pressure at `points` places from the injection to the tip.
inline void describe_profile(Summary& json, const analytic::KgdFracture& f, int points) {
  for (int k = 0; k < points; ++k) {
    const double x = f.half_length * (k / (points - 1.0));
    const std::string place = "/" + std::to_string(k);  // numbers in a path make an array
    json.set("profile/x_m" + place, x);
    json.set("profile/aperture_m" + place, f.width_at(x));
    json.set("profile/net_pressure_Pa" + place, f.net_pressure_at(x));
  }
}

/// The crack that the injected volume has driven through a finite plate; null if it has split it.
inline void describe(Summary& json, const analytic::KgdProblem& p, const PlateOptions& specimen) {
  const analytic::PlateGrowth growth(specimen.plate, {.K_IC = p.K_IC});
  const bool split = p.volume() > growth.volume_at_splitting();
  const auto crack = split ? analytic::PlateGrowth::State{NAN, NAN, NAN} : growth.at(p.volume());
  json.set("plate/assumes", "isotropic rock, K_I = K_IC, no viscosity, no leak-off");
  json.set("plate/width_m", specimen.plate.width());
  json.set("plate/sides", specimen.sides);
  json.set("plate/split", split);
  json.set("plate/half_length_m", crack.full_length / 2);
  json.set("plate/full_length_m", crack.full_length);
  json.set("plate/aperture_at_injection_m", crack.width);
  json.set("plate/net_pressure_Pa", crack.net_pressure);
  json.set("plate/full_length_at_splitting_m", growth.length_at_splitting());
  json.set("plate/time_at_splitting_s", growth.volume_at_splitting() / p.rate);
}

/// The map of regimes with the fracture on it.
inline observe::RegimeMap regime_map(const analytic::KgdProblem& p,
                                     const analytic::KgdFracture& f) {
  std::string conditions;
  for_each_field<analytic::KgdProblem>([&](const auto& field) {
    conditions += (conditions.empty() ? "" : ", ") + std::string(field.name) + " = " +
                  to_text(p.*(field.member)) + "\u00a0" + std::string(field.unit);
  });
  const auto nearest = analytic::nearest_vertex(p, f);
  const std::string verdict = nearest.distance < 0.1 ? observe::drawing::percent(nearest.distance) +
                                                           " from " + name(nearest.regime)
                                                     : name(analytic::KgdRegime::transitional);
  return {.points = {{"this fracture", p, verdict}}, .conditions = conditions + "."};
}

}  // namespace hfdem::support
