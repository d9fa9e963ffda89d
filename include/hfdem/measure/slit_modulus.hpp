/// @file
/// Plane modulus and closing pressure of a rock, from slits held open by several pressures.
///
/// A slit of half-length a under net pressure p opens by V = 2 pi a^2 (p - p_c) f_V / E', with the
/// factor f_V of the finite plate. E' follows from the slope of V(p) alone. The intercept p_c is
/// the pressure above the in-situ stress at which the slit closes: the facets of a rough path do
/// not all face the least stress, and keep each other shut.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include <hfdem/base/fields.hpp>
#include <hfdem/measure/slit_readings.hpp>

namespace hfdem::measure {

/// Slits of several lengths, and the net pressures that hold them open. Pressures should be such
/// that the whole slit is open: twice the closing pressure of its path, or more.
struct HeldSlits {
  double shortest = 0.2;
  double longest = 0.4;
  int count = 3;
  double lowest_pressure = 2e6;
  double highest_pressure = 4e6;
  int pressures = 3;

  static constexpr auto fields() {
    using P = HeldSlits;
    return std::tuple{
        Field{"shortest", &P::shortest, "m", positive, "length of the shortest slit"},
        Field{"longest", &P::longest, "m", positive, "length of the longest slit"},
        Field{"count", &P::count, "", Range{2, 100}, "number of slits"},
        Field{"lowest_pressure", &P::lowest_pressure, "Pa", positive,
              "net pressure that the slopes begin with"},
        Field{"highest_pressure", &P::highest_pressure, "Pa", positive,
              "net pressure that the slopes end with"},
        Field{"pressures", &P::pressures, "", Range{2, 100}, "number of net pressures"}};
  }

  /// Checks that what is longest and highest is so.
  /// @throws InvalidParameter naming the field
  void check() const {
    validate(*this, "slits");
    if (!(longest > shortest))
      refuse("slits", "longest", to_text(longest) + " m",
             "greater than slits.shortest, which is " + to_text(shortest) + " m");
    if (!(highest_pressure > lowest_pressure))
      refuse("slits", "highest_pressure", to_text(highest_pressure) + " Pa",
             "greater than slits.lowest_pressure, which is " + to_text(lowest_pressure) + " Pa");
  }

  std::vector<double> lengths() const { return spread(shortest, longest, count); }  ///< m
  /// Pa
  std::vector<double> net_pressures() const {
    return spread(lowest_pressure, highest_pressure, pressures);
  }

 private:
  static std::vector<double> spread(double first, double last, int count) {
    std::vector<double> values;
    for (int k = 0; k < count; ++k) values.push_back(first + (last - first) * k / (count - 1));
    return values;
  }
};

/// What the slits of one specimen say of its modulus.
struct SlitModulus {
  /// One slit in the finite plate.
  struct Reading {
    SlitTest slit;                ///< what was read
    double E_prime;               ///< from its volume, Pa
    double E_prime_from_opening;  ///< Pa
    double closing_excess;        ///< p_c, Pa
  };
  std::vector<Reading> readings{};  ///< one per slit
  double E_prime = 0;               ///< mean, from the volumes, Pa
  double E_prime_from_opening = 0;  ///< mean, Pa
  double E_prime_spread = 0;        ///< largest less smallest from the volumes, over their mean
  double closing_excess = 0;        ///< mean, Pa
};

/// The mean height of the unit half-circle within `reach` of its middle: a crack is an ellipse,
/// nearly so in a finite plate.
/// @param reach from 0 to 1
inline double mean_of_ellipse(double reach) {
  return reach == 0 ? 1 : (std::sqrt(1 - reach * reach) + std::asin(reach) / reach) / 2;
}

/// Compares the slits with the finite plate, whose factors it needs and whose modulus it does not.
/// @param slits one or more, each read at two pressures or more
/// @param plate gives `factors(full_length)`, e.g. `CrackedPlate`
/// @param reach to both sides of the middle over which the openings are means, m
template <class Plate>
SlitModulus slit_modulus(const std::vector<SlitTest>& slits, const Plate& plate, double reach = 0) {
  SlitModulus modulus;
  const auto count = static_cast<double>(slits.size());
  for (const SlitTest& slit : slits) {
    const double a = slit.half_length;
    const auto factors = plate.factors(2 * a);
    const double E_prime = 2 * std::numbers::pi * a * a * factors.volume / slit.volume.slope;
    const double mean = mean_of_ellipse(std::fmin(reach / a, 1.0));
    const double from_opening = 4 * a * factors.width * mean / slit.opening.slope;
    const double closing = -slit.volume.intercept / slit.volume.slope;
    modulus.readings.push_back({slit, E_prime, from_opening, closing});
    modulus.E_prime += E_prime / count;
    modulus.E_prime_from_opening += from_opening / count;
    modulus.closing_excess += closing / count;
  }
  const auto [least, most] =
      std::minmax_element(modulus.readings.begin(), modulus.readings.end(),
                          [](const auto& a, const auto& b) { return a.E_prime < b.E_prime; });
  modulus.E_prime_spread = (most->E_prime - least->E_prime) / modulus.E_prime;
  return modulus;
}

}  // namespace hfdem::measure
