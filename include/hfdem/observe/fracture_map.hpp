/// \file
/// A crack from close up: its path, branches and microcracks (the paper's Fig. 7), or what they
/// hold (its Figs. 8 and 9).
#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <hfdem/measure/crack_path.hpp>
#include <hfdem/observe/colour_bar.hpp>
#include <hfdem/observe/specimen_picture.hpp>
#include <hfdem/observe/svg.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem::observe {

/// A number for every connected microcrack, shown by colour and thickness.
struct MicrocrackValues {
  std::string name{};           ///< with its unit
  std::vector<double> value{};  ///< one per microcrack; those of unconnected ones do not count
};

/// w in µm.
inline MicrocrackValues apertures(const std::vector<measure::Microcrack>& microcracks) {
  MicrocrackValues values{.name = "aperture (\u00b5m)"};
  for (const auto& m : microcracks) values.value.push_back(1e6 * m.aperture);
  return values;
}

/// In MPa, above the closing stress in Pa.
inline MicrocrackValues net_pressures(const std::vector<measure::Microcrack>& microcracks,
                                      double closing_stress) {
  MicrocrackValues values{.name = "net pressure (MPa)"};
  for (const auto& m : microcracks) values.value.push_back(1e-6 * (m.pressure - closing_stress));
  return values;
}

/// A crack and how to show it.
struct FractureMap {
  std::vector<measure::Microcrack> microcracks{};  ///< as `crack` was measured in
  measure::CrackPath crack{};                      ///< tips, path and branches
  measure::CrackOrigin origin{};                   ///< where the fluid enters
  double width = 1.0, height = 1.0;  ///< of the specimen, m; its lower left corner is the origin
  const Specimen* grains = nullptr;  ///< drawn behind the crack if given
  std::optional<MicrocrackValues> values = std::nullopt;  ///< unset: what kind each microcrack is
  std::string title{};                                    ///< above the picture
  std::string caption{};                                  ///< what to see
  std::string conditions{};                               ///< with which parameters
};

namespace drawing {

/// The close-up of a crack and the whole specimen beside it; on a phone below it.
struct FractureLayout {
  Panel close{.thinnest = 2.0}, whole{.thinnest = 1.0};
  Pixel notes{};  ///< where the legend or the colour bar begins
  double width = 0.0, height = 0.0;

  FractureLayout(const FractureMap& map, Medium medium) {
    const bool phone = medium == Medium::phone;
    const Pixel low_high_x = zoom(map, &Vec2::x), low_high_y = zoom(map, &Vec2::y);
    double across = low_high_x.y - low_high_x.x, up = low_high_y.y - low_high_y.x;
    close.scale =
        phone ? std::min(340.0 / across, 480.0 / up) : std::min(600.0 / across, 560.0 / up);
    close.from_left = low_high_x.x;
    close.from_bottom = low_high_y.x;
    close.box = {.width = across * close.scale, .height = up * close.scale};

    const double side = phone ? 130.0 : 180.0;
    whole.scale = side / std::max(map.width, map.height);
    whole.box = {.width = map.width * whole.scale, .height = map.height * whole.scale};
    if (phone) {
      whole.box.top = close.box.bottom() + 50.0;
      notes = {whole.box.right() + 24.0, whole.box.top + 12.0};
      width = std::max(close.box.right(), 380.0);
      height = whole.box.top + std::max(whole.box.height, 160.0);
    } else {
      whole.box.left = close.box.right() + 40.0;
      notes = {whole.box.left, whole.box.bottom() + 44.0};
      width = whole.box.left + 270.0;
      height = std::max(close.box.bottom() + 30.0, notes.y + 160.0);
    }
  }

 private:
  /// The connected microcracks with some air, no thinner than half as wide as long.
  static Pixel zoom(const FractureMap& map, double Vec2::*axis) {
    const auto extent = [&](double Vec2::*along) {
      Range range{map.origin.position.*along, map.origin.position.*along};
      for (const auto& m : map.microcracks)
        if (m.connected)
          for (const Vec2 end : {m.facet.from, m.facet.to}) include(range, end.*along);
      return range;
    };
    const Range x = extent(&Vec2::x), y = extent(&Vec2::y);
    const double longer = std::max({x.high - x.low, y.high - y.low, 1e-3 * map.width});
    const Range range = extent(axis);
    const double half = std::max(0.25 * longer, (range.high - range.low) / 2.0) + 0.06 * longer;
    const double middle = (range.low + range.high) / 2.0;
    const double end = axis == &Vec2::x ? map.width : map.height;
    return {std::max(0.0, middle - half), std::min(end, middle + half)};
  }
};

/// From zero to the values of the connected microcracks.
inline ColourScale colour_scale(const FractureMap& map) {
  std::vector<double> shown{0.0};
  for (std::size_t m = 0; m < map.microcracks.size(); ++m)
    if (map.microcracks[m].connected) shown.push_back(map.values->value[m]);
  return ColourScale::of(shown);
}

/// What is drawn of each microcrack, in this order.
enum class MicrocrackKind { unconnected, branch, path };

inline std::vector<MicrocrackKind> kinds(const FractureMap& map) {
  std::vector<MicrocrackKind> kind;
  for (const auto& m : map.microcracks)
    kind.push_back(m.connected ? MicrocrackKind::branch : MicrocrackKind::unconnected);
  for (const auto& point : map.crack.points) kind[point.microcrack] = MicrocrackKind::path;
  return kind;
}

/// A map drawn in one of its panels.
class FractureDrawing {
 public:
  FractureDrawing(const FractureMap& map, const Panel& panel) : map_(map), panel_(panel) {}

  [[nodiscard]] std::string by_kind() const {
    Strokes unconnected, branch, path, preset;
    const auto kind = kinds(map_);
    for (std::size_t m = 0; m < kind.size(); ++m) {
      const auto [from, to] = ends(m);
      const bool on_path = kind[m] == MicrocrackKind::path;
      (on_path                             ? path
       : kind[m] == MicrocrackKind::branch ? branch
                                           : unconnected)
          .add(from, to, on_path ? 1.4 * panel_.thinnest : panel_.thinnest);
      if (!map_.microcracks[m].mode) preset.add(from, to, 4.0 * panel_.thinnest);
    }
    return preset.elements(okabe_ito::orange) + unconnected.elements(crack_red) +
           branch.elements(okabe_ito::blue) + way() + path.elements(okabe_ito::black);
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
    std::string out;
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
  entry(stretch(stroke(okabe_ito::black, 3.0)), "path from tip to tip");
  if (has(MicrocrackKind::branch)) entry(stretch(stroke(okabe_ito::blue, 2.0)), "branches");
  if (has(MicrocrackKind::unconnected))
    entry(stretch(stroke(crack_red, 2.0)), "unconnected microcracks");
  if (preset) entry(stretch(stroke(okabe_ito::orange, 7.0)), "preset crack");
  entry(stretch(FractureDrawing::tip_paint()), "line between the tips");
  entry(injection_mark({at.x + 11.0, at.y - 4.0}), "injection");
  return out;
}

}  // namespace drawing

/// The caption of the picture, with what was measured.
inline std::string caption(const FractureMap& map) {
  using drawing::number;
  const auto& crack = map.crack;
  const auto counts = measure::count(map.microcracks);
  const auto microcracks = [](const measure::MicrocrackCount& c) {
    return std::to_string(c.total()) + (c.total() == 1 ? " microcrack (" : " microcracks (") +
           std::to_string(c.tension) + " in tension, " + std::to_string(c.shear) + " in shear" +
           (c.preset > 0 ? ", " + std::to_string(c.preset) + " preset)" : ")");
  };
  const auto metres = [](double length) { return number(length, 3) + " m"; };
  const std::string unconnected = counts.unconnected.total() == 0
                                      ? " No microcrack is unconnected."
                                      : " Not connected: " + microcracks(counts.unconnected) + ".";
  return map.caption + " The tips are " + metres(crack.tip_distance()) + " apart; the path is " +
         metres(crack.path_length) + " long, and " + microcracks(counts.connected) +
         " connected to the injection make " + metres(crack.connected_length()) +
         ": a tortuosity of " + number(crack.tortuosity(), 2) + ", or " +
         number(crack.mean_tortuosity(), 2) +
         " as the mean of both wings. Branches: " + std::to_string(crack.branches.size()) +
         "; asymmetry: " + number(crack.asymmetry(), 2) + "." + unconnected;
}

/// The picture as SVG; in a file it is at most 960 pixels wide.
inline std::string svg(const FractureMap& map, Medium medium = Medium::file) {
  using namespace drawing;
  const FractureLayout layout(map, medium);
  const FractureDrawing close(map, layout.close), whole(map, layout.whole);
  const ColourScale scale = map.values ? colour_scale(map) : ColourScale{};
  const std::string thin = stroke(grey, 1.0);
  const auto cracks = [&](const FractureDrawing& drawing) {
    return map.values ? drawing.by_value(scale) : drawing.by_kind();
  };
  const Pixel lower = layout.whole.pixel(layout.close.from_left, layout.close.from_bottom);
  const double shrink = layout.whole.scale / layout.close.scale;
  const Box region{.left = lower.x,
                   .top = lower.y - layout.close.box.height * shrink,
                   .width = layout.close.box.width * shrink,
                   .height = layout.close.box.height * shrink};
  const std::string body =
      rock(window(layout.close.box, rectangle(layout.close.box, fill(pore)) + close.grains() +
                                        cracks(close) + (map.values ? "" : close.tip_line()) +
                                        close.injection()) +
           rectangle(layout.whole.box, fill(pore)) + cracks(whole) + rectangle(region, thin)) +
      rectangle(layout.close.box, thin) + rectangle(layout.whole.box, thin) +
      layout.close.scale_bar(18.0) +
      (map.values ? colour_bar({layout.notes.x, layout.notes.y + 12.0, 16.0, 140.0}, scale,
                               map.values->name)
                  : fracture_key(map, layout.notes));
  return sheet(map.title, caption(map), map.conditions, layout.width, layout.height, body, medium);
}

}  // namespace hfdem::observe
