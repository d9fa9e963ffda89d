/// @file
/// Stress in measurement circles, and its field on a grid of them (the paper's Fig. 18).
///
/// The stress of a circle is the mean over the discs whose centres it holds, each with its share of
/// the specimen's area: D. O. Potyondy, P. A. Cundall, Int. J. Rock Mech. Min. Sci. 41 (2004)
/// 1329-1364, with the porosity of the whole specimen in place of the circle's own. So a stress
/// that all discs share is found exactly, whichever discs the circle happens to hold.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <hfdem/base/fields.hpp>
#include <hfdem/measure/particle_stress.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem::measure {

/// Where a stress is measured.
struct MeasurementCircle {
  Vec2 centre{};      ///< m
  double radius = 0;  ///< m

  /// Whether a point is inside or on the rim.
  bool holds(Vec2 point) const {
    const Vec2 away = point - centre;
    return dot(away, away) <= radius * radius;
  }
};

namespace detail {

/// Gathers discs into a mean stress; shares of area go as R^2.
class StressMean {
 public:
  void add(double radius, const StressTensor& s) {
    const double weight = radius * radius;
    weight_ += weight;
    sum_.xx += weight * s.xx;
    sum_.yy += weight * s.yy;
    sum_.xy += weight * s.xy;
  }
  /// @throws InvalidParameter without a disc
  StressTensor value(const MeasurementCircle& circle) const {
    if (!(weight_ > 0))
      refuse("circle", "radius", to_text(circle.radius) + " m",
             "large enough to hold the centre of a disc around [" + in_words(circle.centre.x) +
                 ", " + in_words(circle.centre.y) + "] m");
    return {sum_.xx / weight_, sum_.yy / weight_, sum_.xy / weight_};
  }

 private:
  double weight_ = 0;
  StressTensor sum_{};
};

}  // namespace detail

/// Mean stress in a circle; a part beyond the specimen's sides does not count.
/// @param specimen whose discs are looked for in the circle
/// @param particle_stress one per disc, as from `particle_stress`
/// @param circle inside the specimen or across its sides
/// @throws InvalidParameter if the circle holds the centre of no disc
inline StressTensor circle_stress(const Specimen& specimen,
                                  std::span<const StressTensor> particle_stress,
                                  const MeasurementCircle& circle) {
  detail::StressMean mean;
  for (std::size_t i = 0; i < specimen.size(); ++i)
    if (circle.holds(specimen.centre[i])) mean.add(specimen.radius[i], particle_stress[i]);
  return mean.value(circle);
}

/// Circles on a grid; they overlap where the radius is more than half the spacing.
struct CircleGrid {
  double spacing = 10e-3;
  double radius = 15e-3;

  static constexpr auto fields() {
    using P = CircleGrid;
    return std::tuple{Field{"spacing", &P::spacing, "m", positive,
                            "distance between neighbouring circles, rounded so that they fit"},
                      Field{"radius", &P::radius, "m", positive, "of every circle"}};
  }
};

/// Stresses at the centres of the cells into which a grid divides the specimen, row by row from the
/// lower left.
struct StressField {
  Index columns = 0, rows = 0;         ///< number of cells along x and along y
  Vec2 spacing{};                      ///< of the cells, m
  std::vector<StressTensor> stress{};  ///< Pa, compression positive

  /// Of a cell, m.
  Vec2 centre(Index column, Index row) const {
    return {(column + 0.5) * spacing.x, (row + 0.5) * spacing.y};
  }
  /// Stress at the centre of a cell, Pa.
  const StressTensor& at(Index column, Index row) const {
    return stress[std::size_t{row} * columns + column];
  }
};

/// Measures circles all over a specimen. The time it takes grows with the number of discs times
/// that of the circles that share one.
/// @param specimen all of which is covered
/// @param particle_stress one per disc, as from `particle_stress`
/// @param grid of the circles
/// @throws InvalidParameter if a field is out of range or a circle holds the centre of no disc
inline StressField stress_field(const Specimen& specimen,
                                std::span<const StressTensor> particle_stress,
                                const CircleGrid& grid = {}) {
  validate(grid, "circles");
  const auto cells = [&](double length) {
    return static_cast<Index>(std::fmax(1.0, std::round(length / grid.spacing)));
  };
  StressField field{.columns = cells(specimen.width), .rows = cells(specimen.height)};
  field.spacing = {specimen.width / field.columns, specimen.height / field.rows};

  std::vector<detail::StressMean> means(std::size_t{field.columns} * field.rows);
  for (std::size_t i = 0; i < specimen.size(); ++i) {
    const MeasurementCircle around{specimen.centre[i], grid.radius};
    // The first and last of `count` cells whose centres may be near enough.
    const auto range = [&](double at, double spacing, Index count) {
      const auto cell = [&](double x) {
        return static_cast<Index>(std::clamp(x / spacing - 0.5, 0.0, count - 1.0));
      };
      return std::pair{cell(at - grid.radius), cell(at + grid.radius)};
    };
    const auto [left, right] = range(specimen.centre[i].x, field.spacing.x, field.columns);
    const auto [bottom, top] = range(specimen.centre[i].y, field.spacing.y, field.rows);
    for (Index row = bottom; row <= top; ++row)
      for (Index column = left; column <= right; ++column)
        if (around.holds(field.centre(column, row)))
          means[std::size_t{row} * field.columns + column].add(specimen.radius[i],
                                                               particle_stress[i]);
  }
  for (Index row = 0; row < field.rows; ++row)
    for (Index column = 0; column < field.columns; ++column)
      field.stress.push_back(means[std::size_t{row} * field.columns + column].value(
          {field.centre(column, row), grid.radius}));
  return field;
}

}  // namespace hfdem::measure
