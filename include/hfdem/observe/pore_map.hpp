/// \file
/// The pressure in the pores of a rock that leaks, with the trace of the crack (the paper's
/// Fig. 17b).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <hfdem/measure/microcracks.hpp>
#include <hfdem/measure/pores.hpp>
#include <hfdem/observe/colour_bar.hpp>
#include <hfdem/observe/field_sheet.hpp>
#include <hfdem/observe/specimen_layout.hpp>
#include <hfdem/observe/svg.hpp>

namespace hfdem::observe {

/// Pores around a crack.
struct PoreMap {
  std::vector<measure::Pore> pores{};              ///< those without pressure or fluid stay blank
  std::vector<measure::Microcrack> microcracks{};  ///< the connected ones are drawn
  double saturation = 0.0;                         ///< how full pores were at first
  Vec2 injection{};                                ///< m
  double width = 1.0, height = 1.0;                ///< of the specimen, m
  std::optional<Range> range = std::nullopt;       ///< MPa; unset: from zero to the highest
  std::string title{};                             ///< above the picture
  std::string caption{};                           ///< what to see
  std::string conditions{};                        ///< with which parameters
};

/// The caption of the picture.
inline std::string caption(const PoreMap& map) { return map.caption; }

namespace drawing {

inline constexpr Colour damp_stone{203, 215, 228};  // fluid without pressure

/// How a pore is drawn.
enum class PoreLook { blank, damp, pressed };
inline PoreLook look(const measure::Pore& p, double highest, double saturation) {
  constexpr double shown = 0.02;  // of the highest pressure: what spreads ahead of it has no edge
  if (p.pressure > shown * highest) return PoreLook::pressed;
  return p.filling > saturation ? PoreLook::damp : PoreLook::blank;
}
inline double highest_pressure(const PoreMap& map) {
  double highest = 0.0;
  for (const measure::Pore& p : map.pores) highest = std::max(highest, p.pressure);
  return highest;
}

/// The part of a specimen that holds all pores that are drawn, and half as much around it.
inline Box seen_part(const PoreMap& map) {
  Range x = no_range, y = no_range;
  const double highest = highest_pressure(map);
  for (const measure::Pore& p : map.pores) {
    if (look(p, highest, map.saturation) == PoreLook::blank) continue;
    include(x, p.centre.x), include(y, p.centre.y);
  }
  if (!(x.low <= x.high)) return {0.0, 0.0, map.width, map.height};
  const double side =
      std::min(std::max(map.width, map.height), 1.5 * std::max(x.high - x.low, y.high - y.low));
  const double width = std::min(side, map.width), height = std::min(side, map.height);
  return {std::clamp((x.low + x.high - width) / 2.0, 0.0, map.width - width),
          std::clamp((y.low + y.high - height) / 2.0, 0.0, map.height - height), width, height};
}

}  // namespace drawing

/// The picture as SVG; in a file it is at most 700 pixels wide. It shows the part of the specimen
/// in which there is fluid.
inline std::string svg(const PoreMap& map, Medium medium = Medium::file) {
  using namespace drawing;
  const Box part = seen_part(map);
  Panel panel{.scale =
                  (medium == Medium::phone ? 290.0 : 540.0) / std::max(part.width, part.height)};
  panel.box = {.width = part.width * panel.scale, .height = part.height * panel.scale};
  panel.from_left = part.left, panel.from_bottom = part.top;

  const double highest = highest_pressure(map);
  const ColourScale scale{map.range.value_or(Range{0.0, highest > 0.0 ? 1e-6 * highest : 1.0}), 20};
  Path damp_pores;
  std::vector<Path> pressed(static_cast<std::size_t>(scale.bands));
  for (const measure::Pore& p : map.pores) {
    const PoreLook seen = look(p, highest, map.saturation);
    if (seen == PoreLook::blank) continue;
    Path& path = seen == PoreLook::damp
                     ? damp_pores
                     : pressed[static_cast<std::size_t>(scale.band(1e-6 * p.pressure))];
    for (std::size_t k = 0; k < p.corners.size(); ++k) {
      const Pixel at = panel.pixel(p.corners[k].x, p.corners[k].y);
      k == 0 ? path.move_to(at) : path.line_to(at);
    }
  }
  std::string filled = damp_pores.element(fill(damp_stone));
  for (int band = 0; band < scale.bands; ++band)
    filled += pressed[static_cast<std::size_t>(band)].element(fill(scale.colour(band)));
  Strokes trace;
  for (const auto& m : map.microcracks)
    if (m.connected)
      trace.add(panel.pixel(m.facet.from.x, m.facet.from.y),
                panel.pixel(m.facet.to.x, m.facet.to.y), 1.6);
  const std::string field =
      rectangle(panel.box, fill(stone)) + filled + trace.elements(okabe_ito::black);
  return field_sheet(map, panel, scale, "MPa", field, medium);
}

}  // namespace hfdem::observe
