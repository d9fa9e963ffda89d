/// @file
/// The specimen of a Brazilian test: a round plate of a random packing with two flats, on which
/// platens press.
///
/// The flats are walls of the packing, so that the platens touch whole rows of its discs, free of
/// stress. Flats: Q. Z. Wang, X. M. Jia, S. Q. Kou, Z. X. Zhang, P.-A. Lindqvist, Int. J. Rock
/// Mech. Min. Sci. 41 (2004) 245-253.
#pragma once

#include <cmath>
#include <numbers>
#include <tuple>

#include <hfdem/setup/random_packing.hpp>

namespace hfdem {

/// The round plate.
struct BrazilianDisc {
  double diameter = 0.3;
  double loading_angle = 20;

  static constexpr auto fields() {
    using P = BrazilianDisc;
    return std::tuple{Field{"diameter", &P::diameter, "m", positive, "of the round plate"},
                      Field{"loading_angle", &P::loading_angle, "deg", Range{5, 60},
                            "that each of its two flats is seen under from the middle"}};
  }

  /// Half the angle of a flat, rad.
  double half_angle() const { return loading_angle / 2 * std::numbers::pi / 180; }
  /// Between the flats, m.
  double height() const { return diameter * std::cos(half_angle()); }

  /// Tension in the middle of an isotropic elastic plate under even pressure on both arcs (G.
  /// Hondros, Austral. J. Appl. Sci. 10 (1959) 243-268), Pa.
  /// @param load resultant of the pressure on an arc, N per m of thickness
  double tension(double load) const {
    const double a = half_angle();
    return 2 * load / (std::numbers::pi * diameter) * (std::sin(2 * a) - a) / std::sin(a);
  }
};

/// Cuts the plate out of a packing: the discs whose centres lie in the circle, without those that
/// would touch a platen beside its flat. Its area is that of the circle, its rim as rough as a
/// grain.
/// @param plate its measures
/// @param grains of the packing; its width and height do not count, nor does an exact number
/// @param threads to use
/// @throws InvalidParameter if a field is outside its range, or the plate is too small for its
/// grains
/// @throws RunStopped as `random_packing` does
inline Specimen brazilian_disc(const BrazilianDisc& plate, RandomPacking grains, int threads = 1) {
  validate(plate, "brazilian");
  grains.width = plate.diameter;
  grains.height = plate.height();
  grains.grains.reset();
  if (plate.diameter < 16 * grains.radius_max)
    refuse("brazilian", "diameter", to_text(plate.diameter) + " m",
           "at least " + to_text(16 * grains.radius_max) + " m, 16 times specimen.radius_max");
  const Specimen box = random_packing(grains, threads);
  Specimen round = box;
  round.centre.clear();
  round.radius.clear();
  for (Index i = 0; i < box.size(); ++i) {
    const Vec2 from_middle = box.centre[i] - 0.5 * Vec2{box.width, box.height};
    const bool beside_flat =
        std::abs(from_middle.x) > plate.diameter / 2 * std::sin(plate.half_angle());
    const bool at_platen = box.touches(i, Side::bottom) || box.touches(i, Side::top);
    if (norm(from_middle) > plate.diameter / 2 || (beside_flat && at_platen)) continue;
    round.centre.push_back(box.centre[i]);
    round.radius.push_back(box.radius[i]);
  }
  return round;
}

}  // namespace hfdem
