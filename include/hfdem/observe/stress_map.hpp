/// \file
/// The minimum principal stress of a specimen in bands of colour, with the trace of the crack (the
/// paper's Fig. 18).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <hfdem/measure/measurement_circle.hpp>
#include <hfdem/measure/microcracks.hpp>
#include <hfdem/observe/colour_bar.hpp>
#include <hfdem/observe/field_sheet.hpp>
#include <hfdem/observe/specimen_layout.hpp>
#include <hfdem/observe/svg.hpp>

namespace hfdem::observe {

/// A stress field and the crack in it.
struct StressMap {
  measure::StressField field{};                    ///< of the whole specimen
  std::vector<measure::Microcrack> microcracks{};  ///< the connected ones are drawn
  Vec2 injection{};                                ///< m
  std::optional<Range> range = std::nullopt;       ///< MPa; unset: all but the utmost values
  std::string title{};                             ///< above the picture
  std::string caption{};                           ///< what to see
  std::string conditions{};                        ///< with which parameters
};

/// The caption of the picture, with the sign of stresses.
inline std::string caption(const StressMap& map) {
  return map.caption + " Compression is positive.";
}

namespace drawing {

/// The field in MPa between the centres of its cells by bilinear interpolation, and as at the
/// nearest of them beyond.
class MinimumStress {
 public:
  explicit MinimumStress(const measure::StressField& field) : field_(field) {
    for (const auto& s : field.stress) value_.push_back(1e-6 * s.minor());
  }
  [[nodiscard]] double at(Vec2 point) const {
    const auto [left, right, x] = between(point.x / field_.spacing.x, field_.columns);
    const auto [below, above, y] = between(point.y / field_.spacing.y, field_.rows);
    return std::lerp(std::lerp(value(left, below), value(right, below), x),
                     std::lerp(value(left, above), value(right, above), x), y);
  }
  /// From the first to the last but `left_out` of the values at each end.
  [[nodiscard]] Range range(double left_out) const {
    auto sorted = value_;
    std::ranges::sort(sorted);
    const auto skipped = static_cast<std::size_t>(left_out * static_cast<double>(sorted.size()));
    return padded({sorted[skipped], sorted[sorted.size() - 1 - skipped]});
  }

 private:
  struct Between {
    Index low, high;
    double part;
  };
  static Between between(double cells, Index count) {
    const double place = std::clamp(cells - 0.5, 0.0, count - 1.0);
    const auto low = static_cast<Index>(place);
    return {low, std::min(low + 1, count - 1), place - low};
  }
  [[nodiscard]] double value(Index column, Index row) const {
    return value_[std::size_t{row} * field_.columns + column];
  }

  const measure::StressField& field_;
  std::vector<double> value_{};
};

/// Runs of one band along the rows of a raster, one path per band.
inline std::string bands(const MinimumStress& stress, const ColourScale& scale,
                         const Panel& panel) {
  constexpr double pixel = 3.0;
  const auto columns = static_cast<int>(std::ceil(panel.box.width / pixel));
  const auto rows = static_cast<int>(std::ceil(panel.box.height / pixel));
  std::vector<Path> paths(static_cast<std::size_t>(scale.bands));
  for (int row = 0; row < rows; ++row) {
    const double y = panel.box.top + (row + 0.5) * pixel;
    const auto band_of = [&](int column) {
      const Vec2 at{(column + 0.5) * pixel / panel.scale, (panel.box.bottom() - y) / panel.scale};
      return scale.band(stress.at(at));
    };
    for (int begin = 0, end = 0; begin < columns; begin = end) {
      const int band = band_of(begin);
      while (end < columns && band_of(end) == band) ++end;
      Path& path = paths[static_cast<std::size_t>(band)];
      path.move_to({panel.box.left + begin * pixel, y});
      path.line_to({panel.box.left + end * pixel + 0.4, y});  // over the seam
    }
  }
  std::string out;
  for (int band = 0; band < scale.bands; ++band)
    out += paths[static_cast<std::size_t>(band)].element(stroke(scale.colour(band), pixel + 0.4));
  return out;
}

}  // namespace drawing

/// The picture as SVG; in a file it is at most 700 pixels wide.
inline std::string svg(const StressMap& map, Medium medium = Medium::file) {
  using namespace drawing;
  const bool phone = medium == Medium::phone;
  const double width = map.field.spacing.x * map.field.columns;
  const double height = map.field.spacing.y * map.field.rows;
  Panel panel{.scale = (phone ? 290.0 : 540.0) / std::max(width, height)};
  panel.box = {.width = width * panel.scale, .height = height * panel.scale};

  const MinimumStress stress(map.field);
  const ColourScale scale{map.range.value_or(stress.range(0.005)), 20};
  Strokes halo, trace;
  for (const auto& m : map.microcracks) {
    if (!m.connected) continue;
    const auto [from, to] = m.facet;
    halo.add(panel.pixel(from.x, from.y), panel.pixel(to.x, to.y), 3.4);
    trace.add(panel.pixel(from.x, from.y), panel.pixel(to.x, to.y), 1.8);
  }
  const std::string field =
      bands(stress, scale, panel) + halo.elements(white) + trace.elements(okabe_ito::black);
  return field_sheet(map, panel, scale, "MPa", field, medium);
}

}  // namespace hfdem::observe
