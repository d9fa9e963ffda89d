/// @file
/// What a fracture meets in a lattice of bonded discs, in the numbers that slit tests measure.
#pragma once

#include <tuple>

#include <hfdem/base/fields.hpp>

namespace hfdem::analytic {

/// A lattice opens like an elastic plane, but for the contacts at its tips and those that the
/// in-situ stress had closed; and its toughness is the strength of one contact, so it grows with
/// the net pressure at which that contact breaks.
struct LatticeFracture {
  double E = 0;
  double poisson_ratio = 0;
  double shear_modulus = 0;
  double E_prime = 0;
  double K_IC = 0;
  double K_IC_per_pressure = 0;
  double opening_offset = 0;
  double volume_offset = 0;
  double overhang = 0;

  static constexpr auto fields() {
    using P = LatticeFracture;
    return std::tuple{
        Field{"E", &P::E, "Pa", positive, "Young's modulus, along both axes"},
        Field{"poisson_ratio", &P::poisson_ratio, "", Range{-1, 1, true, true}, "Poisson's ratio"},
        Field{"shear_modulus", &P::shear_modulus, "Pa", positive, "shear modulus"},
        Field{"E_prime", &P::E_prime, "Pa", positive,
              "modulus with which a crack along an axis opens, E'"},
        Field{"K_IC", &P::K_IC, "Pa sqrt(m)", positive,
              "toughness, extrapolated to no net pressure"},
        Field{"K_IC_per_pressure", &P::K_IC_per_pressure, "sqrt(m)", any_number,
              "growth of the toughness with the net pressure at which a contact breaks"},
        Field{"opening_offset", &P::opening_offset, "m", any_number,
              "by which a slit opens less in its middle than a crack in a continuum"},
        Field{"volume_offset", &P::volume_offset, "m", any_number,
              "the same for the mean opening, volume over length"},
        Field{"overhang", &P::overhang, "m", any_number,
              "by which a slit is longer at each tip for its volume"}};
  }

  /// K_IC at a net pressure, Pa sqrt(m).
  double toughness(double net_pressure) const { return K_IC + K_IC_per_pressure * net_pressure; }
};

}  // namespace hfdem::analytic
