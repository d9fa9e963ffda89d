/// @file
/// The map of propagation regimes (the paper's Fig. 4): dimensionless time against dimensionless
/// toughness, the regions in which a vertex of the KGD fracture holds, and cases among them. Cases
/// without leak-off, whose time is zero, have a strip of their own beside the logarithmic axis.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <hfdem/analytic/kgd_regions.hpp>
#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/regime_layout.hpp>

namespace hfdem::observe {

namespace drawing {

/// A vertex as the map shows it: toughness in warm colours, viscosity in cold ones.
struct VertexStyle {
  analytic::KgdRegime vertex;
  Colour colour;
  std::string_view words;
};
inline constexpr std::array vertex_styles{
    VertexStyle{analytic::KgdRegime::storage_toughness, okabe_ito::vermillion,
                "storage, toughness (K)"},
    VertexStyle{analytic::KgdRegime::storage_viscosity, okabe_ito::blue, "storage, viscosity (M)"},
    VertexStyle{analytic::KgdRegime::leak_off_toughness, okabe_ito::orange,
                "leak-off, toughness (K~)"},
    VertexStyle{analytic::KgdRegime::leak_off_viscosity, okabe_ito::sky_blue,
                "leak-off, viscosity (M~)"}};

/// How far a vertex may be from the general solution, and how dark its region is then.
struct Shade {
  double tolerance, opacity;
  [[nodiscard]] std::string paint(Colour colour) const {
    return fill(colour) + attribute("fill-opacity", opacity);
  }
};
inline constexpr std::array shades{Shade{0.05, 0.16}, Shade{0.01, 0.24}};  ///< the wider one first

inline std::string percent(double part) { return number(100.0 * part) + "\u00a0%"; }

/// The bounds of a shade, in the order of `vertex_styles`; they are the same on every map.
struct RegimeBounds {
  std::array<std::vector<analytic::KgdPlace>, 4> leaky;
  double toughness, viscosity;  ///< without leak-off: log10 of K_m above and below which it holds

  explicit RegimeBounds(double tolerance) {
    using enum analytic::KgdRegime;
    for (std::size_t k = 0; k < leaky.size(); ++k)
      leaky[k] = analytic::region(vertex_styles[k].vertex, tolerance);
    toughness = std::log10(analytic::bound_without_leak_off(storage_toughness, tolerance));
    viscosity = std::log10(analytic::bound_without_leak_off(storage_viscosity, tolerance));
  }
};
inline const std::array<RegimeBounds, shades.size()>& regime_bounds() {
  static const std::array bounds{RegimeBounds(shades[0].tolerance),
                                 RegimeBounds(shades[1].tolerance)};
  return bounds;
}

/// The regions, in the strip and on the map.
inline std::string regions(const RegimeLayout& layout) {
  std::string in_map, in_strip;
  for (std::size_t s = 0; s < shades.size(); ++s) {
    const RegimeBounds& bounds = regime_bounds()[s];
    for (std::size_t k = 0; k < vertex_styles.size(); ++k) {
      const Colour colour = vertex_styles[k].colour;
      Line corners;
      for (const auto& place : bounds.leaky[k]) corners.push_back(layout.pixel(place));
      in_map += line(corners, shades[s].paint(colour)) +
                line({corners.begin(), corners.end() - 1}, stroke(colour, 1.2));
    }
    const auto band = [&](double from, double to, Colour colour) {
      in_strip += rectangle({layout.strip.left, layout.toughness.pixel(to), layout.strip.width,
                             layout.toughness.pixel(from) - layout.toughness.pixel(to)},
                            shades[s].paint(colour));
    };
    band(bounds.toughness, layout.toughness.range.high, vertex_styles[0].colour);
    band(layout.toughness.range.low, bounds.viscosity, vertex_styles[1].colour);
  }
  return window(layout.map, in_map) + in_strip;
}

/// The names of the regions, which the names of points had better not cover.
inline std::string region_names(const RegimeLayout& layout, Line& obstacles) {
  std::string out;
  for (std::size_t k = 0; k < vertex_styles.size(); ++k) {
    const TextStyle style{.colour = readable(vertex_styles[k].colour),
                          .anchor = k < 2 ? "start" : "end"};
    const auto words = wrap(vertex_styles[k].words, layout.name_width);
    Box box{.width = widest(words), .height = style.leading() * static_cast<double>(words.size())};
    box.left = k < 2 ? layout.map.left + 10.0 : layout.map.right() - 10.0 - box.width;
    // K~ leaves room only low, for its other bound is slanted.
    const double low = layout.toughness.pixel(regime_bounds()[1].leaky[2].front().log_toughness);
    box.top =
        k == 0 ? layout.map.top + 8.0 : (k == 2 ? low : layout.map.bottom()) - box.height - 4.0;
    // It makes room for rings, which cannot.
    for (int shift = 0; shift < 4 && layout.has_ring_in(box); ++shift)
      box.top += k == 0 ? 24.0 : -24.0;
    obstruct(obstacles, box);
    out += text({k < 2 ? box.left : box.right(), box.top + style.size}, words, style);
  }
  return out;
}

/// What the shades mean, above the map.
inline std::string shade_key(const RegimeLayout& layout) {
  std::string out;
  double right = layout.map.right();
  const auto put = [&](std::string_view words) {
    out += text({right, 10.0}, words, {.colour = grey, .anchor = "end"});
    right -= text_width(words) + 4.0;
  };
  const auto swatch = [&](std::size_t darkest) {
    for (std::size_t s = 0; s <= darkest; ++s)
      out += rectangle({right - 16.0, 0.0, 16.0, 12.0}, shades[s].paint(okabe_ito::black));
    right -= 24.0;
  };
  for (std::size_t s = shades.size(); s-- > 0; swatch(s)) put(percent(shades[s].tolerance));
  if (layout.wide) put("a vertex is within");
  return out;
}

inline std::string arrow(Pixel from, Pixel way) {
  const auto ahead = [&](double along, double aside) {
    return Pixel{from.x + along * way.x - aside * way.y, from.y + along * way.y + aside * way.x};
  };
  Path path;
  path.move_to(ahead(5.5, 0.0));
  path.line_to(ahead(14.0, 0.0));
  path.move_to(ahead(10.0, 3.5));
  path.line_to(ahead(14.0, 0.0));
  path.line_to(ahead(10.0, -3.5));
  return path.element(stroke(ink, 1.6));
}

/// Rings and names: those in the strip beside one another's, those on the map where there is room.
inline std::string cases(const RegimeLayout& layout, Line& obstacles) {
  std::string out;
  std::vector<EndLabel> names;
  for (const PlacedPoint& p : layout.points) {
    if (p.beyond) out += arrow(p.at, p.way);
    obstruct(obstacles, {p.at.x - 9.0, p.at.y - 9.0, 18.0, 18.0});
    if (p.in_strip) names.push_back({p.words, ink, p.at});
  }
  spread(names, layout.strip.top, layout.strip.bottom());
  for (const EndLabel& name : names) {
    const Pixel beside{layout.strip_names - 4.0, name.top + name.height() / 2.0};
    out += circle(name.end, 4.5, stroke(ink, 2.0)) +
           line({{name.end.x + 5.5, name.end.y}, beside}, stroke(ink, 0.7)) +
           text({layout.strip_names, name.top + 13.0}, name.words, {});
  }
  for (const PlacedPoint& p : layout.points)
    if (!p.in_strip) out += ring(p.at, p.words, ink, layout.map, obstacles);
  return out;
}

}  // namespace drawing

/// The caption of the picture, with what the shades and arrows mean.
inline std::string caption(const RegimeMap& map) {
  using drawing::percent, drawing::shades;
  const auto beyond = drawing::RegimeLayout(map, Medium::file).beyond();
  return map.caption + (map.caption.empty() ? "" : " ") +
         "Shaded is where one of the four vertices of the KGD fracture is within " +
         percent(shades[0].tolerance) + ", and darker where it is within " +
         percent(shades[1].tolerance) +
         ", of Dontsov's general solution, in half-length and width at the injection together." +
         (beyond ? " Arrows point to cases beyond the rim." : "");
}

/// The picture as SVG; in a file it is 848 pixels wide. The first one takes a second, for the
/// bounds of the regions.
inline std::string svg(const RegimeMap& map, Medium medium = Medium::file) {
  using namespace drawing;
  const RegimeLayout layout(map, medium);
  Line obstacles;
  std::string body = layout.axes() + regions(layout) + shade_key(layout);
  body += region_names(layout, obstacles);
  body += cases(layout, obstacles);
  return sheet(map.title, caption(map), map.conditions, layout.width, layout.height, body, medium);
}

}  // namespace hfdem::observe
