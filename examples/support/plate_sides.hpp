/// @file
/// What holds the sides of the plate that a specimen is.
#pragma once

#include <hfdem/analytic/plate.hpp>
#include <hfdem/mechanics/loading.hpp>

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

}  // namespace hfdem::support
