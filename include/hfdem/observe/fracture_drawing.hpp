/// @file
/// The strokes of a crack's picture and what their colours mean.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <hfdem/observe/colour_bar.hpp>
#include <hfdem/observe/fracture_layout.hpp>
#include <hfdem/observe/specimen_picture.hpp>
#include <hfdem/observe/svg.hpp>

namespace hfdem::observe::drawing {

/// From zero to the values of the connected microcracks.
inline ColourScale colour_scale(const FractureMap& map) {
  std::vector<double> shown{0.0};
  for (std::size_t m = 0; m < map.microcracks.size(); ++m)
    if (map.microcracks[m].connected) shown.push_back(map.values->value[m]);
  return ColourScale::of(shown);
}

/// What a microcrack is in the picture.
enum class MicrocrackKind { unconnected, joint_unconnected, branch, path, joint };

/// How a kind is drawn, and called in the legend.
struct KindStyle {
  Colour colour;
  double width;  ///< over the thinnest
  std::string_view words;
};

/// With natural fractures, the colours of the paper's Figs. 14 and 15.
inline KindStyle style(MicrocrackKind kind, bool natural) {
  using enum MicrocrackKind;
  if (kind == path) return {okabe_ito::black, 1.4, "path from tip to tip"};
  if (kind == branch) return {natural ? okabe_ito::black : okabe_ito::blue, 1.0, "branches"};
  if (kind == joint) return {okabe_ito::blue, 1.4, "joint microcracks, connected"};
  if (kind == joint_unconnected) return {crack_red, 1.4, "joint microcracks, unconnected"};
  return {natural ? okabe_ito::purple : crack_red, 1.0, "unconnected microcracks"};
}

/// Of each microcrack.
inline std::vector<MicrocrackKind> kinds(const FractureMap& map) {
  using enum MicrocrackKind;
  std::vector<MicrocrackKind> kind;
  for (const auto& m : map.microcracks)
    kind.push_back(m.in_joint    ? (m.connected ? joint : joint_unconnected)
                   : m.connected ? branch
                                 : unconnected);
  for (const auto& point : map.crack.points)
    if (kind[point.microcrack] == branch) kind[point.microcrack] = path;
  return kind;
}

/// A map drawn in one of its panels.
class FractureDrawing {
 public:
  FractureDrawing(const FractureMap& map, const Panel& panel) : map_(map), panel_(panel) {}

  [[nodiscard]] std::string by_kind() const {
    using enum MicrocrackKind;
    std::array<Strokes, 5> strokes;
    Strokes preset;
    const auto kind = kinds(map_);
    for (std::size_t m = 0; m < kind.size(); ++m) {
      const auto [from, to] = ends(m);
      strokes[static_cast<std::size_t>(kind[m])].add(from, to,
                                                     look(kind[m]).width * panel_.thinnest);
      if (!map_.microcracks[m].mode) preset.add(from, to, 4.0 * panel_.thinnest);
    }
    std::string out = preset.elements(okabe_ito::orange) + natural();
    for (const auto k : {unconnected, joint_unconnected, branch, path, joint}) {
      if (k == path) out += way();
      const bool in_joint = k == joint || k == joint_unconnected;
      if (!in_joint || !map_.natural.empty())
        out += strokes[static_cast<std::size_t>(k)].elements(look(k).colour);
    }
    return out;
  }

  /// Colour and thickness show the values of the connected microcracks, the greatest on top.
  [[nodiscard]] std::string by_value(const ColourScale& scale) const {
    std::map<int, Strokes> bands;
    for (std::size_t m = 0; m < map_.microcracks.size(); ++m) {
      if (!map_.microcracks[m].connected) continue;
      const int band = scale.band(map_.values->value[m]);
      const auto [from, to] = ends(m);
      bands[band].add(from, to, panel_.thinnest * (1.0 + 3.0 * band / scale.bands));
    }
    std::string out = natural();
    for (const auto& [band, strokes] : bands) out += strokes.elements(scale.colour(band));
    return out;
  }

  [[nodiscard]] std::string grains() const {
    Strokes dots;
    for (std::size_t i = 0; map_.grains && i < map_.grains->size(); ++i) {
      const Pixel at = pixel(map_.grains->centre[i]);
      if (panel_.box.contains(at)) dots.add_disc(at, map_.grains->radius[i] * panel_.scale);
    }
    return map_.grains ? dots.elements(stone) : "";
  }

  [[nodiscard]] std::string tip_line() const {
    return line({pixel(map_.crack.down.tip), pixel(map_.crack.up.tip)}, tip_paint());
  }
  [[nodiscard]] std::string injection() const {
    return injection_mark(pixel(map_.origin.position));
  }

  static std::string tip_paint() {
    return stroke(okabe_ito::purple, 1.6) + attribute("stroke-dasharray", "7 4");
  }

 private:
  [[nodiscard]] Pixel pixel(Vec2 at) const { return panel_.pixel(at.x, at.y); }
  [[nodiscard]] std::pair<Pixel, Pixel> ends(std::size_t m) const {
    const auto& facet = map_.microcracks[m].facet;
    return {pixel(facet.from), pixel(facet.to)};
  }

  [[nodiscard]] KindStyle look(MicrocrackKind kind) const {
    return style(kind, !map_.natural.empty());
  }

  [[nodiscard]] std::string natural() const {
    if (map_.natural.empty()) return "";
    Strokes lines;
    for (const NaturalFracture& f : map_.natural)
      lines.add(pixel(f.from), pixel(f.to), panel_.thinnest);
    return lines.elements(okabe_ito::green);
  }

  /// From microcrack to microcrack of the path, which lie apart around larger pores.
  [[nodiscard]] std::string way() const {
    std::vector<Pixel> middles;
    for (const auto& point : map_.crack.points)
      middles.push_back(pixel(map_.microcracks[point.microcrack].middle()));
    return middles.empty() ? "" : line(middles, stroke(okabe_ito::black, 0.5 * panel_.thinnest));
  }

  const FractureMap& map_;
  const Panel& panel_;
};

/// What the colours of the kinds mean, one line under the other.
inline std::string fracture_key(const FractureMap& map, Pixel at) {
  std::string out;
  const auto entry = [&](const std::string& sample, std::string_view words) {
    out +=
        rock(rectangle({at.x, at.y - 11.0, 22.0, 14.0}, fill(map.grains ? stone : pore)) + sample) +
        text({at.x + 30.0, at.y}, words);
    at.y += 20.0;
  };
  const auto stretch = [&at](std::string_view paint) {
    return line({{at.x, at.y - 4.0}, {at.x + 22.0, at.y - 4.0}}, paint);
  };
  const auto kind = kinds(map);
  const auto has = [&kind](MicrocrackKind k) { return std::ranges::count(kind, k) > 0; };
  const bool preset =
      std::ranges::any_of(map.microcracks, [](const auto& m) { return !m.mode.has_value(); });
  using enum MicrocrackKind;
  if (!map.natural.empty()) entry(stretch(stroke(okabe_ito::green, 2.0)), "natural fractures");
  for (const auto k : {path, branch, joint, joint_unconnected, unconnected}) {
    const KindStyle look = style(k, !map.natural.empty());
    if (k == path || has(k)) entry(stretch(stroke(look.colour, k == path ? 3.0 : 2.0)), look.words);
  }
  if (preset) entry(stretch(stroke(okabe_ito::orange, 7.0)), "preset crack");
  entry(stretch(FractureDrawing::tip_paint()), "line between the tips");
  entry(injection_mark({at.x + 11.0, at.y - 4.0}), "injection");
  return out;
}

}  // namespace hfdem::observe::drawing
