/// @file
/// The elastic plate that a square array is, seen from far enough.
#pragma once

#include <string>

#include <hfdem/analytic/plate.hpp>

#include "support/plate_sides.hpp"
#include "support/toughness_model.hpp"

namespace hfdem::support {

/// @param rock with its Young's modulus, Poisson's ratio and shear modulus
/// @throws InvalidParameter if the plate is too oblong or too anisotropic for its solution
inline analytic::CrackedPlate plate_of(const SquareArray& array, const Loading::Params& boundary,
                                       Stress in_situ, const analytic::LatticeFracture& rock) {
  if (array.rows > 2 * array.columns || array.columns > 2 * array.rows)
    refuse("specimen", "rows", std::to_string(array.rows),
           "half to twice specimen.columns: the finite plate is solved for no others");
  const analytic::OrthotropicPlane plane{rock.E, rock.poisson_ratio, rock.shear_modulus};
  if (!(plane.rho() >= 0.3 && plane.rho() <= 6))
    refuse("contact", "stiffness_ratio", "such that E / (2 G) = " + in_words(plane.rho()),
           "such that this is 0.3 to 6: the finite plate is solved for no others");
  const double columns = array.columns, rows = array.rows;
  const bool upright = crack_direction(in_situ).y != 0;
  const double along = upright ? rows : columns, across = upright ? columns : rows;
  return {along * 2 * array.radius, plane, plate_sides(boundary.kind), across / along};
}

}  // namespace hfdem::support
