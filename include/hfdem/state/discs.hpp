/// @file
/// The bodies of the assembly and their motion.
#pragma once

#include <numbers>
#include <span>
#include <vector>

#include <hfdem/base/pack.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// Discs 0 .. size() - 1, then the four platens in the order of `Side`.
///
/// Motion is stored in rows of four: (x, y, rotation, rotation), m and rad, or m/s and rad/s; the
/// twin of the rotation lets one subtraction of rows give everything a contact needs.
struct Discs {
  std::vector<Vec2> centre;        ///< where the disc was bonded, m
  std::vector<double> radius;      ///< m
  std::vector<double> mass;        ///< kg per m
  std::vector<Pack> displacement;  ///< since bonding; one row per body
  std::vector<Pack> velocity;      ///< one row per body
  std::vector<Vec2> load;          ///< fluid and dead loads on each disc, N per m

  Discs() = default;
  /// At rest where the specimen has them, without loads.
  explicit Discs(const Specimen& s)
      : centre(s.centre),
        radius(s.radius),
        mass(s.size()),
        displacement(s.size() + all_sides.size(), Pack{}),
        velocity(s.size() + all_sides.size(), Pack{}),
        load(s.size()) {
    for (std::size_t i = 0; i < mass.size(); ++i)
      mass[i] = s.density * std::numbers::pi * radius[i] * radius[i];
  }

  /// The motion and what drives it.
  void exchange(auto& archive) {
    archive(std::span(displacement), std::span(velocity), std::span(load));
  }

  std::size_t size() const { return centre.size(); }  ///< without the platens
  /// The body that stands for a platen.
  Index platen(Side side) const { return static_cast<Index>(size()) + static_cast<Index>(side); }
  /// Moment of inertia, m R^2 / 2, kg m2 per m.
  double inertia(std::size_t disc) const { return mass[disc] * radius[disc] * radius[disc] / 2; }
};

}  // namespace hfdem
