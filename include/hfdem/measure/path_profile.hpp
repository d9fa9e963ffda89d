/// @file
/// Aperture and net pressure along a crack's path (the paper's Figs. 8, 9 and 12a).
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include <hfdem/base/fields.hpp>
#include <hfdem/measure/crack_path.hpp>

namespace hfdem::measure {

/// What one microcrack of the path holds.
struct ProfilePoint {
  double arc;           ///< from where the fluid enters the path to its middle, m; < 0 downwards
  double along;         ///< of its middle from the injection along the crack's direction, m
  Vec2 position;        ///< of its middle, m
  double length;        ///< 2 Rb, m
  double aperture;      ///< w, m
  double opening;       ///< w - w0, m
  double net_pressure;  ///< above the closing stress, Pa
};

/// The path from the lower to the upper tip.
/// @param microcracks the list in which the path was measured
/// @param crack its path
/// @param closing_stress the in-situ stress across the crack, Pa
inline std::vector<ProfilePoint> path_profile(std::span<const Microcrack> microcracks,
                                              const CrackPath& crack, double closing_stress) {
  std::vector<ProfilePoint> profile;
  for (const PathPoint& point : crack.points) {
    const Microcrack& m = microcracks[point.microcrack];
    profile.push_back({point.arc, point.along, m.middle(), m.length(), m.aperture, m.opening,
                       m.pressure - closing_stress});
  }
  return profile;
}

/// Means over a part of the path.
struct MeanAperture {
  double aperture = 0, opening = 0;  ///< w and w - w0, m; zero where there is no path
};

/// Means over the path's microcracks near the injection, each weighted by its length: a single one
/// opens anything between half of them and half as much again.
/// @param profile of the whole path
/// @param reach to both sides, along the crack's direction, m
/// @throws InvalidParameter if the reach is not positive
inline MeanAperture mean_aperture(std::span<const ProfilePoint> profile, double reach = 30e-3) {
  hfdem::detail::check_range("mean_aperture", "reach", "m", positive, reach);
  MeanAperture mean;
  double length = 0;
  for (const ProfilePoint& p : profile) {
    if (std::abs(p.along) > reach) continue;
    mean.aperture += p.length * p.aperture;
    mean.opening += p.length * p.opening;
    length += p.length;
  }
  return length > 0 ? MeanAperture{mean.aperture / length, mean.opening / length} : MeanAperture{};
}

}  // namespace hfdem::measure
