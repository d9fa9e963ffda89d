/// @file
/// The crack that an injection drives through a plate of isotropic rock, predicted from modulus and
/// toughness: what a run in a random specimen is compared with.
#pragma once

#include <cmath>
#include <optional>
#include <string>

#include <hfdem/analytic/plate_growth.hpp>
#include <hfdem/analytic/rock_fracture.hpp>
#include <hfdem/setup/preset_crack.hpp>

#include "support/plate_sides.hpp"

namespace hfdem::support {

/// A plate of isotropic rock and what is injected into its middle.
struct PlateInjection {
  double width = 1, height = 1;  ///< of the specimen, m
  BoundaryKind boundary = BoundaryKind::servo;
  Stress in_situ{};
  double rate = 0.5e-4;      ///< m2/s
  double preset_length = 0;  ///< of the crack when the injection begins, m
};

/// @throws InvalidParameter if the plate is too oblong for its solution
inline void check_shape(const PlateInjection& p) {
  if (p.width > 2 * p.height || p.height > 2 * p.width)
    refuse("specimen", "height", to_text(p.height) + " m",
           "half to twice specimen.width: the finite plate is solved for no others");
}

/// The plate in which a crack runs along the greater in-situ stress.
/// @param E_prime of the rock, Pa
/// @param poisson_ratio in the plane; only frozen platens feel it
/// @throws InvalidParameter if the plate is too oblong for its solution
inline analytic::CrackedPlate plate_of(const PlateInjection& p, double E_prime,
                                       double poisson_ratio) {
  check_shape(p);
  const bool upright = crack_direction(p.in_situ).y != 0;
  const double along = upright ? p.height : p.width, across = upright ? p.width : p.height;
  const analytic::OrthotropicPlane plane{E_prime, poisson_ratio,
                                         E_prime / (2 * (1 + poisson_ratio))};
  return {along, plane, plate_sides(p.boundary), across / along};
}

/// Growth of the crack without viscosity and leak-off, at K = K_IC, until the plate splits.
class GrowthPrediction {
 public:
  /// The crack at one moment.
  struct Crack {
    double full_length;  ///< m
    double opening;      ///< at the middle, m
    double pressure;     ///< of the fluid, Pa
  };

  /// @param rock as slits and running cracks say
  /// @param injection and the plate that it goes into
  /// @throws InvalidParameter if a number is out of range
  GrowthPrediction(const analytic::RockFracture& rock, const PlateInjection& injection)
      : plate_(plate_of(injection, rock.E_prime, rock.poisson_ratio)),
        growth_(plate_, {rock.K_IC, 0}),
        rate_(injection.rate),
        preset_(injection.preset_length),
        closing_(std::fmin(injection.in_situ.xx, injection.in_situ.yy) + rock.closing_excess) {
    hfdem::detail::check_range("injection", "rate", "m2/s", positive, rate_);
    const Range stable{.low = 0, .high = growth_.length_at_splitting(), .open_high = true};
    hfdem::detail::check_range("crack", "length", "m", stable, preset_);
  }

  /// Time at which the crack becomes unstable and splits the plate, s.
  double splitting_time() const { return growth_.volume_at_splitting() / rate_; }
  /// Length from which it does so, m.
  double splitting_length() const { return growth_.length_at_splitting(); }

  /// Nothing before the injection and once the plate has split. Until the pressure breaks its tips,
  /// the preset crack opens and keeps its length.
  std::optional<Crack> at(double time) const {
    const double volume = rate_ * time;
    if (!(volume > 0 && volume < growth_.volume_at_splitting())) return {};
    if (volume < growth_.volume(preset_)) {
      const double net = volume / plate_.volume(1, preset_);
      return Crack{preset_, plate_.opening(net, preset_), closing_ + net};
    }
    const auto now = growth_.at(volume);
    return Crack{now.full_length, now.width, closing_ + now.net_pressure};
  }

  /// Net pressure, above the closing pressure, at which a crack of a length runs, Pa.
  double net_pressure(double full_length) const { return growth_.pressure(full_length); }

 private:
  analytic::CrackedPlate plate_;
  analytic::PlateGrowth growth_;
  double rate_, preset_, closing_;
};

}  // namespace hfdem::support
