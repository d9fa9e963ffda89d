/// @file
/// Moves a specimen by the uniform strain that an elastic answer to a change of stress would have,
/// so that settling starts near its end.
#pragma once

#include <hfdem/state/contact.hpp>
#include <hfdem/state/discs.hpp>

namespace hfdem {

/// The assembly's stiffness if all discs moved with a uniform strain (exact for a square array).
struct UniformStrainModulus {
  double xxxx = 0, xxyy = 0, yyyy = 0;  ///< component of the stiffness tensor, Pa

  /// Adds a contact.
  /// @param f its normal
  /// @param k its springs
  /// @param length between the two sides of the contact, m
  /// @param area of the specimen, m2
  void add(const Frame<double>& f, const Springs& k, double length, double area) {
    const double nx2 = f.normal_x * f.normal_x, ny2 = f.normal_y * f.normal_y;
    const double per_area = length * length / area;
    xxxx += per_area * (k.normal * nx2 * nx2 + k.shear * nx2 * ny2);
    yyyy += per_area * (k.normal * ny2 * ny2 + k.shear * nx2 * ny2);
    xxyy += per_area * (k.normal - k.shear) * nx2 * ny2;
  }

  /// Principal shortenings for a stress (compression positive).
  Vec2 shortening(Stress s) const {
    const double determinant = xxxx * yyyy - xxyy * xxyy;
    return {(s.xx * yyyy - s.yy * xxyy) / determinant, (s.yy * xxxx - s.xx * xxyy) / determinant};
  }
};

/// Shortens the specimen towards its centre, platens included.
inline void shorten(Discs& discs, Vec2 shortening, double width, double height) {
  const auto move = [&](std::size_t body, double x, double y) {
    // Distances from the centre in single precision: the last bits of the coordinates, which differ
    // between mirror images, must not enter.
    const auto dx = static_cast<float>(x - width / 2), dy = static_cast<float>(y - height / 2);
    discs.displacement[body] -= Pack{shortening.x * dx, shortening.y * dy, 0, 0};
  };
  for (std::size_t i = 0; i < discs.size(); ++i) move(i, discs.centre[i].x, discs.centre[i].y);
  move(discs.platen(Side::left), 0, height / 2);
  move(discs.platen(Side::right), width, height / 2);
  move(discs.platen(Side::bottom), width / 2, 0);
  move(discs.platen(Side::top), width / 2, height);
}

}  // namespace hfdem
