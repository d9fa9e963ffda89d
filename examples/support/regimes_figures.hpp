/// @file
/// The pictures of a study of regimes.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/regime_map.hpp>

#include "support/regimes_points.hpp"
#include "support/run_report.hpp"

namespace hfdem::support {

inline std::string said_rocks(const RegimesConfig& config) {
  const RegimeRock& p = config.tough;
  return "Square arrays of discs of radius 5 mm; contacts of " +
         in_words(p.tensile_strength / 1e6) + " MPa under " + in_words(p.across / 1e6) +
         " MPa, and of " + in_words(config.weak.tensile_strength / 1e6) + " MPa under " +
         in_words(config.weak.across / 1e6) + " MPa.";
}

inline std::string verdict(const RegimePoint& p) {
  return "length " + difference(p.ours.half_length, p.kgd_half_length()) + ", opening " +
         difference(p.opening(), p.kgd_opening()) +
         (p.leaks() ? ", efficiency " + difference(p.efficiency(), p.kgd_efficiency()) : "");
}

/// The cracks that came to their end, on the map of regimes.
inline observe::RegimeMap regimes_map(const RegimesConfig& config,
                                      const std::vector<RegimePoint>& points) {
  observe::RegimeMap map{
      .title = "From toughness to viscosity, from storage to leak-off",
      .caption =
          "Each ring is a crack through an array of discs. Below its name stands how far "
          "its length and its opening at the injection are from the general solution for "
          "the modulus and the toughness of slits.",
      .conditions = said_rocks(config)};
  for (const RegimePoint* p : arrived(points))
    map.points.push_back({p->name, p->reference.problem, verdict(*p)});
  return map;
}

inline std::string said_crack(const RegimePoint& p) {
  return in_words(p.crack.viscosity * 1e3) + " cp, " + in_words(p.crack.rate * 1e4) +
         " × 10^{-4} m²/s, " + in_words(p.crack.time) + " s; " + std::to_string(p.crack.discs) +
         " x " + std::to_string(p.crack.discs) + " discs; " +
         (p.leaks() ? "C_{L} " + in_words(p.crack.leakoff * 1e3) + " mm/s^{1/2}; "
                    : std::string()) +
         "K_{m} " + observe::fixed(p.reference.K_m(), 2) + ".";
}

/// Ours and KGD's along one wing.
template <class Ours, class Kgd>
observe::Chart profile_chart(const RegimePoint& p, const std::string& title,
                             const std::string& unit, Ours&& ours, Kgd&& kgd) {
  observe::Chart chart{.title = title + ": " + p.name,
                       .x_label = "distance from the injection (m)",
                       .y_label = unit,
                       .caption =
                           "Means over the window of time; where the crack was broken all "
                           "that time.",
                       .conditions = said_crack(p)};
  observe::Series lattice{.name = "discs", .style = observe::Series::Style::markers};
  for (const MeanPoint& m : p.ours.profile)
    lattice.x.push_back(m.along), lattice.y.push_back(ours(m));
  observe::Series general{.name = "KGD", .colour = observe::okabe_ito::black};
  constexpr int points = 200;
  for (int k = 0; k <= points; ++k) {
    const double part = 1 - static_cast<double>(k) / points;
    const double x = p.kgd_half_length() * (1 - part * part);
    if (const double y = kgd(x); std::isfinite(y)) general.x.push_back(x), general.y.push_back(y);
  }
  chart.series = {general, lattice};
  return chart;
}

inline observe::Chart opening_chart(const RegimePoint& p) {
  return profile_chart(
      p, "Opening", "opening (µm)",
      [&](const MeanPoint& m) { return (m.opening + p.rock.opening_offset) * 1e6; },
      [&](double x) { return p.reference.fracture.width_at(x) * 1e6; });
}

inline observe::Chart pressure_chart(const RegimePoint& p) {
  double least = 0;
  for (const MeanPoint& m : p.ours.profile) least = std::fmin(least, m.net_pressure);
  return profile_chart(
      p, "Net pressure", "net pressure (MPa)",
      [&](const MeanPoint& m) { return m.net_pressure / 1e6; },
      [&](double x) {
        const double pressure = p.reference.fracture.net_pressure_at(x);
        return pressure < 1.2 * least - 1e6 ? NAN : pressure / 1e6;
      });
}

}  // namespace hfdem::support
