/// @file
/// The regular specimen: equal discs on a square grid, each touching its four neighbours (the
/// paper's verification model, Fig. 5).
#pragma once

#include <tuple>

#include <hfdem/base/fields.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// The default is the paper's: 1 m by 1 m of 10,000 discs.
struct SquareArray {
  int columns = 100;
  int rows = 100;
  double radius = 5e-3;
  double density = 3169;

  static constexpr auto fields() {
    using P = SquareArray;
    constexpr Range count{2, 10000};
    return std::tuple{Field{"columns", &P::columns, "", count, "discs side by side"},
                      Field{"rows", &P::rows, "", count, "discs one above the other"},
                      Field{"radius", &P::radius, "m", positive, "radius of the discs"},
                      Field{"density", &P::density, "kg/m3", positive, "density of the discs"}};
  }
};

/// Builds the array, its lower left corner at the origin; row by row from the bottom.
/// @throws InvalidParameter if a field is outside its range.
inline Specimen square_array(const SquareArray& array) {
  validate(array, "specimen");
  const double pitch = 2 * array.radius;
  Specimen s{.width = array.columns * pitch,
             .height = array.rows * pitch,
             .density = array.density,
             .bonding_gap = 1e-6 * array.radius};
  const auto columns = static_cast<Index>(array.columns), rows = static_cast<Index>(array.rows);
  s.radius.assign(std::size_t{columns} * rows, array.radius);
  for (Index r = 0; r < rows; ++r) {
    for (Index c = 0; c < columns; ++c) {
      const Index disc = r * columns + c;
      s.centre.push_back({(c + 0.5) * pitch, (r + 0.5) * pitch});
      if (c + 1 < columns) s.pairs.push_back({disc, disc + 1});
      if (r + 1 < rows) s.pairs.push_back({disc, disc + columns});
    }
  }
  return s;
}

/// The same with the default density.
/// @param columns discs side by side
/// @param rows discs one above the other
/// @param radius of the discs, m
/// @throws InvalidParameter if one is outside its range
inline Specimen square_array(int columns, int rows, double radius) {
  return square_array({.columns = columns, .rows = rows, .radius = radius});
}

}  // namespace hfdem
