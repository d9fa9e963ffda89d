/// @file
/// The elastic plate that a square array is, seen from far enough.
#pragma once

#include <hfdem/analytic/plate.hpp>

#include "support/toughness_model.hpp"

namespace hfdem::support {

constexpr analytic::PlateSides plate_sides(BoundaryKind boundary) {
  switch (boundary) {
    case BoundaryKind::servo:
      return analytic::PlateSides::rigid;
    case BoundaryKind::frozen:
      return analytic::PlateSides::fixed;
    case BoundaryKind::dead_loads:
      break;
  }
  return analytic::PlateSides::stress;
}

/// @param rock with its Young's modulus, Poisson's ratio and shear modulus
/// @throws InvalidParameter if the plate is too oblong or too anisotropic
inline analytic::CrackedPlate plate_of(const SquareArray& array, const Loading::Params& boundary,
                                       Stress in_situ, const analytic::LatticeFracture& rock) {
  const double columns = array.columns, rows = array.rows;
  const bool upright = crack_direction(in_situ).y != 0;
  const double along = upright ? rows : columns, across = upright ? columns : rows;
  return {along * 2 * array.radius,
          {rock.E, rock.poisson_ratio, rock.shear_modulus},
          plate_sides(boundary.kind),
          across / along};
}

}  // namespace hfdem::support
