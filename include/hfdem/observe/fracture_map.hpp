/// \file
/// A crack from close up: its path, branches and microcracks (the paper's Fig. 7), natural
/// fractures that it met (its Figs. 14 and 15), or what it holds (its Figs. 8 and 9).
#pragma once

#include <string>

#include <hfdem/observe/fracture_drawing.hpp>
#include <hfdem/observe/fracture_layout.hpp>

namespace hfdem::observe {

namespace drawing {
/// For the caption; nothing without natural fractures.
inline std::string in_natural(const FractureMap& map) {
  if (map.natural.empty()) return "";
  const auto joints = measure::count(map.microcracks, [](const auto& m) { return m.in_joint; });
  return " In the " + std::to_string(map.natural.size()) +
         " natural fractures: " + std::to_string(joints.total()) + " of the microcracks, " +
         std::to_string(joints.connected.total()) + " of them connected.";
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
         "; asymmetry: " + number(crack.asymmetry(), 2) + "." + unconnected +
         drawing::in_natural(map);
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
