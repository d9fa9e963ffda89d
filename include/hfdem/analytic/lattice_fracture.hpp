/// @file
/// What a fracture meets in a lattice of bonded discs, in the numbers that slit tests measure.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>
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

/// A crack in a lattice at one moment.
struct LatticeCrack {
  double full_length;   ///< m
  double opening;       ///< w - w0 at the middle, m
  double net_pressure;  ///< Pa
};

/// The crack that a volume drives through an infinite plane of such rock: p sqrt(pi a) = K_IC(p),
/// no viscosity, no leak-off. The toughness of a lattice lets no short crack grow steadily: below
/// sqrt(pi a) = 4/3 of `K_IC_per_pressure` a longer one needs less volume.
/// @param rock as slit tests say
/// @param volume injected, m2
/// @returns nothing for a volume too small for steady growth
inline std::optional<LatticeCrack> crack_in_plane(const LatticeFracture& rock, double volume) {
  using std::numbers::pi;
  const double k = rock.K_IC_per_pressure;
  const auto pressure = [&](double root) { return rock.K_IC / (root - k); };  // root: sqrt(pi a)
  const auto needs = [&](double root) {
    return 2 * root * root * root * root / pi * pressure(root) / rock.E_prime;
  };
  double low = std::fmax(0, 4 * k / 3), high = low + 1;
  if (low > 0 && !(volume >= needs(low))) return {};
  while (needs(high) < volume) high *= 2;
  for (int halving = 0; halving < 100; ++halving) {
    const double middle = (low + high) / 2;
    (needs(middle) < volume ? low : high) = middle;
  }
  const double a = high * high / pi, p = pressure(high);
  return LatticeCrack{2 * a, 4 * a * p / rock.E_prime, p};
}

}  // namespace hfdem::analytic
