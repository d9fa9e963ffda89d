/// @file
/// The cracks of a study beside their KGD fractures.
#pragma once

#include <string>
#include <vector>

#include <hfdem/analytic/plate.hpp>

#include "support/plate_of_lattice.hpp"
#include "support/regimes_model.hpp"
#include "support/regimes_reading.hpp"
#include "support/regimes_reference.hpp"
#include "support/run_report.hpp"

namespace hfdem::support {

/// One crack beside its reference.
struct RegimePoint {
  std::string key{}, name{};  ///< as sections have it; in words
  RegimeCase crack{};
  analytic::LatticeFracture rock{};
  CrackReading ours{};
  RegimeReference reference{};       ///< toughness at the tip's pressure
  RegimeReference mean_toughness{};  ///< toughness at the mean pressure
  double length_to_width = 0;        ///< 2a / W
  analytic::PlateFactors plate{};    ///< of the finite array at this length
  double disc = 0;                   ///< diameter, m

  /// The crack of a continuum that opens like ours, m.
  double opening() const { return ours.opening + rock.opening_offset; }
  double kgd_opening() const { return reference.fracture.width; }
  double kgd_half_length() const { return reference.fracture.half_length; }

  bool leaks() const { return crack.leakoff > 0; }
  /// Of a continuum that lost as much: its crack holds more than ours.
  double efficiency() const { return 1 - ours.leaked * crack.rate / reference.problem.rate; }
  double kgd_efficiency() const { return reference.fracture.efficiency; }

  bool length_holds() const {
    return RegimeTolerance::length_holds(ours.half_length, kgd_half_length(), disc, leaks());
  }
  bool efficiency_holds() const {
    return !leaks() || RegimeTolerance::efficiency_holds(efficiency(), kgd_efficiency());
  }
  bool opening_holds() const { return RegimeTolerance::opening_holds(opening(), kgd_opening()); }
  bool holds() const {
    return ours.stopped.empty() && length_holds() && opening_holds() && efficiency_holds();
  }
};

/// The cracks that came to their end.
inline std::vector<const RegimePoint*> arrived(const std::vector<RegimePoint>& points) {
  std::vector<const RegimePoint*> all;
  for (const RegimePoint& p : points)
    if (p.ours.stopped.empty()) all.push_back(&p);
  return all;
}

inline std::string rock_name(RockKind kind) {
  return std::string(names_of<RockKind>[static_cast<std::size_t>(kind)]);
}

/// What the slits of a rock say.
/// @throws InvalidParameter if the array is no plate that the solution knows
inline analytic::LatticeFracture fracture_of(const ToughnessConfig& slits,
                                             const std::vector<measure::SlitTest>& tests) {
  const Lattice& l = slits.lattice;
  const analytic::LatticeFracture rock = square_lattice(l);
  return measure::toughness_test(tests, plate_of(l.specimen, l.boundary, l.in_situ, rock), rock)
      .rock;
}

/// @param number of the crack
/// @param rock as its slits say
inline RegimePoint regime_point(const RegimesConfig& config, std::size_t number,
                                const analytic::LatticeFracture& rock, const CrackReading& ours) {
  const RegimeCase& c = config.cracks[number];
  const Lattice l = config.rock(c.rock).lattice(c.discs);
  RegimePoint point{.key = std::string(RegimesConfig::names[number]),
                    .crack = c,
                    .rock = rock,
                    .ours = ours,
                    .disc = 2 * l.specimen.radius};
  point.name = point.key;
  std::replace(point.name.begin(), point.name.end(), '_', ' ');
  if (!ours.stopped.empty()) return point;
  const auto reference = [&](ToughnessAt at) {
    return regime_reference(rock, c.viscosity, c.rate, ours.time, point.disc, at, c.leakoff);
  };
  point.reference = reference(ToughnessAt::tip);
  point.mean_toughness = reference(ToughnessAt::mean);
  const auto plate = plate_of(l.specimen, l.boundary, l.in_situ, rock);
  point.length_to_width = 2 * ours.half_length / plate.width();
  point.plate = plate.factors(2 * ours.half_length);
  return point;
}

}  // namespace hfdem::support
