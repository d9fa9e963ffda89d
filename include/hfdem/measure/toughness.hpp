/// @file
/// Plane modulus and toughness of a specimen, read from slits of several lengths.
///
/// A slit of half-length a under net pressure p opens, once its tips are softened, along a straight
/// line: w - w0 = 4 a p f_w / E' - w_off at its middle, V = 2 pi (a + b)^2 p f_V / E' - 2 a v_off
/// for its volume. f_w and f_V are the factors of the finite plate; the offsets and the overhang b
/// are what a row of discs has and a continuum has not: contacts that were closed by the in-situ
/// stress, and end domains whose pressure pushes the next row along the slit. Toughness is
/// K = p F_K sqrt(pi a) at the first break. It is no single number: what breaks is a contact of a
/// given strength, not a singular stress field, so K grows with the pressure at which it happens.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <hfdem/analytic/lattice_fracture.hpp>
#include <hfdem/analytic/plate.hpp>
#include <hfdem/base/fields.hpp>
#include <hfdem/measure/slit_readings.hpp>

namespace hfdem::measure {

/// The slits to test.
struct SlitSeries {
  int shortest = 10;
  int longest = 40;
  int count = 4;
  double accuracy = 1e-3;

  static constexpr auto fields() {
    using P = SlitSeries;
    return std::tuple{
        Field{"shortest", &P::shortest, "", Range{4}, "broken contacts of the shortest slit"},
        Field{"longest", &P::longest, "", Range{6}, "broken contacts of the longest slit"},
        Field{"count", &P::count, "", Range{2, 100}, "number of slits"},
        Field{"accuracy", &P::accuracy, "", Range{1e-6, 0.01}, "of the pressure at first break"}};
  }

  /// Broken contacts of each slit, even numbers, evenly spread.
  /// @throws InvalidParameter if there are not so many
  std::vector<int> contacts() const {
    validate(*this, "slits");
    const int least = (shortest + 1) / 2;  // pairs of contacts
    if (longest / 2 - least < count - 1)
      refuse("slits", "count", std::to_string(count),
             "at most " + std::to_string(std::max(0, longest / 2 - least + 1)) +
                 ", the even numbers from slits.shortest to slits.longest");
    std::vector<int> all;
    for (int k = 0; k < count; ++k)
      all.push_back(2 * (least + (longest / 2 - least) * k / (count - 1)));
    return all;
  }
};

/// What the slits of one specimen say together.
struct ToughnessTest {
  /// One slit in the finite plate.
  struct Reading {
    SlitTest slit;   ///< what was read
    double E_prime;  ///< from its opening, Pa
    double K_IC;     ///< at its first break, Pa sqrt(m)
  };
  std::vector<Reading> readings{};   ///< one per slit
  double E_prime_spread = 0;         ///< largest less smallest from the openings, over their mean
  double E_prime_from_volume = 0;    ///< Pa; that of `rock` is from the openings
  analytic::LatticeFracture rock{};  ///< what all slits say of it
};

/// Fits the slits to the finite plate. Young's modulus, Poisson's ratio and shear modulus of `rock`
/// are taken over.
/// @tparam Plate gives `factors(full_length)` of width, volume and toughness, e.g. `CrackedPlate`
template <class Plate>
ToughnessTest toughness_test(const std::vector<SlitTest>& slits, const Plate& plate,
                             const analytic::LatticeFracture& rock) {
  using std::numbers::pi;
  ToughnessTest test{.rock = rock};
  std::vector<Vec2> toughness, roots;
  const auto count = static_cast<double>(slits.size());
  test.rock.E_prime = test.rock.opening_offset = test.rock.volume_offset = test.rock.overhang = 0;
  for (const SlitTest& slit : slits) {
    const double a = slit.half_length, p = slit.net_pressure_at_break;
    const auto factors = plate.factors(2 * a);
    const double E_prime = 4 * a * factors.width / slit.opening.slope;
    const double K = p * factors.toughness * std::sqrt(pi * a);
    test.readings.push_back({slit, E_prime, K});
    toughness.push_back({p, K});
    // sqrt(dV/dp / (2 pi f_V)) = (a + b) / sqrt(E')
    roots.push_back({a, std::sqrt(slit.volume.slope / (2 * pi * factors.volume))});
    test.rock.E_prime += E_prime / count;
    test.rock.opening_offset -= slit.opening.intercept / count;
    test.rock.volume_offset -= slit.volume.intercept / (2 * a) / count;
  }
  for (const Vec2& r : roots)
    test.rock.overhang += (r.y * std::sqrt(test.rock.E_prime) - r.x) / count;
  const Line K = Line::through(toughness), root = Line::through(roots);
  const auto [least, most] =
      std::minmax_element(test.readings.begin(), test.readings.end(),
                          [](const auto& a, const auto& b) { return a.E_prime < b.E_prime; });
  test.E_prime_spread = (most->E_prime - least->E_prime) / test.rock.E_prime;
  test.rock.K_IC = K.intercept;
  test.rock.K_IC_per_pressure = K.slope;
  test.E_prime_from_volume = 1 / (root.slope * root.slope);
  return test;
}

}  // namespace hfdem::measure
