/// @file
/// Growth of a crack through a finite plate at K_I = K_IC under a given injected volume: no
/// viscosity, no leak-off, no lag.
#pragma once

#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <hfdem/analytic/plate.hpp>

namespace hfdem::analytic {

/// Toughness at a net pressure p: K_IC + per_pressure p. That of a lattice of bonded discs grows
/// with the net pressure, since its strength is that of one contact.
struct ToughnessLaw {
  double K_IC = 0;          ///< Pa sqrt(m)
  double per_pressure = 0;  ///< sqrt(m)

  static constexpr auto fields() {
    using P = ToughnessLaw;
    return std::tuple{Field{"K_IC", &P::K_IC, "Pa sqrt(m)", positive, "toughness"},
                      Field{"per_pressure", &P::per_pressure, "sqrt(m)", any_number,
                            "its growth with the net pressure"}};
  }
};

/// The lengths through which more volume drives the crack further: from the shortest at which the
/// toughness lets it break (0 if that does not grow with pressure) to the one at which it becomes
/// unstable and splits the plate.
class PlateGrowth {
 public:
  /// A crack about to grow.
  struct State {
    double full_length;   ///< m
    double width;         ///< at the middle, m
    double net_pressure;  ///< Pa
  };

  /// @throws InvalidParameter if the toughness is out of range, or no length of the plate is stable
  PlateGrowth(CrackedPlate plate, const ToughnessLaw& rock)
      : plate_(std::move(plate)), rock_(rock) {
    validate(rock, "rock");
    constexpr int steps = 500;
    const double step = plate_.longest() / steps;
    const auto at = [&](int n) { return volume(std::fmin(n * step, plate_.longest())); };
    int from = 0, to = 0;
    if (rock.per_pressure > 0)  // a short crack needs less volume the longer it is
      for (from = 1; from < steps && !(at(from + 1) > at(from));) ++from;
    for (to = from; to < steps && at(to + 1) > at(to);) ++to;
    if (to == from)
      refuse("rock", "per_pressure", to_text(rock.per_pressure) + " sqrt(m)",
             "small enough for a crack to grow in this plate");
    start_ = from == 0 ? 0 : extremum(from * step, step, -1);
    end_ = to == steps ? plate_.longest() : extremum(to * step, step, 1);
  }

  /// Net pressure at which a crack breaks, Pa; infinite if no pressure breaks it.
  double pressure(double full_length) const {
    const double left = plate_.stress_intensity(1, full_length) - rock_.per_pressure;
    return left > 0 ? rock_.K_IC / left : std::numeric_limits<double>::infinity();
  }
  /// Injected volume at which a crack breaks, m2.
  double volume(double full_length) const {
    return full_length == 0 ? 0 : plate_.volume(pressure(full_length), full_length);
  }

  /// Full length of the shortest crack that grows with the volume, m.
  double shortest_stable() const { return start_; }
  /// Full length at which the crack becomes unstable, m; `longest()` of the plate if it is stable
  /// until there.
  double length_at_splitting() const { return end_; }
  /// Injected volume at which the plate splits, m2.
  double volume_at_splitting() const { return volume(end_); }

  /// The crack after an injected volume, m2.
  /// @throws InvalidParameter unless it is between that of the shortest stable crack and
  /// `volume_at_splitting()`
  State at(double injected) const {
    const Range stable{volume(start_), volume(end_), start_ == 0, false};
    hfdem::detail::check_range("crack", "volume", "m2", stable, injected);
    double low = start_, high = end_;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = (low + high) / 2;
      (volume(middle) < injected ? low : high) = middle;
    }
    const double p = pressure(high);
    return {high, plate_.opening(p, high), p};
  }

 private:
  /// Where the volume is largest (sign 1) or least (-1), by golden sections around a length.
  double extremum(double about, double reach, double sign) const {
    constexpr double golden = 0.6180339887498949;
    double low = about - reach, high = std::fmin(about + reach, plate_.longest());
    while (high - low > 1e-9 * high) {
      const double left = high - golden * (high - low), right = low + golden * (high - low);
      if (sign * volume(left) > sign * volume(right))
        high = right;
      else
        low = left;
    }
    return (low + high) / 2;
  }

  CrackedPlate plate_;
  ToughnessLaw rock_;
  double start_ = 0, end_ = 0;
};

}  // namespace hfdem::analytic
