#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <hfdem/observe/specimen_layout.hpp>
#include <hfdem/observe/svg.hpp>

/// \file
/// The discs of a specimen and the crack among them as SVG: the whole and a close-up. What to draw
/// is a `SpecimenPicture` (specimen_layout.hpp).

namespace hfdem::observe {
namespace drawing {

/// Name of the stress on one pair of walls, given that on the other pair, both in Pa.
inline std::string stress_label(double stress, double other) {
  const std::string name = stress == other ? "S" : stress < other ? "S_{min}" : "S_{max}";
  return name + " " + number(stress * 1e-6, 2) + " MPa";
}

/// Platen and arrows of one wall of `length` pixels, whose outside is up before it is turned by
/// `angle` degrees about its middle.
inline std::string wall(Pixel middle, double angle, double length, double stress, bool platen,
                        std::string_view label) {
  std::string out =
      "<g" +
      attribute("transform", "translate(" + number(middle.x) + " " + number(middle.y) +
                                 ") rotate(" + number(angle) + ")") +
      ">\n";
  const double foot = platen ? -15.0 : -4.0;  // of the arrows
  if (platen) out += rectangle({-length / 2.0, -12.0, length, 9.0}, fill(steel));
  if (stress != 0.0) {
    const double tail = foot - 26.0, tip = stress > 0.0 ? foot : tail;
    const double barb = tip + (stress > 0.0 ? -6.0 : 6.0);
    const double count = std::clamp(std::floor(length / 70.0), 2.0, 7.0);
    Path arrows;
    for (double k = 0.5; k < count; ++k) {
      const double x = length * (k / count - 0.5);
      arrows.move_to({x, foot + tail - tip});
      for (const Pixel p : {Pixel{x, tip}, {x - 3.5, barb}}) arrows.line_to(p);
      arrows.move_to({x + 3.5, barb});
      arrows.line_to({x, tip});
    }
    out += arrows.element(stroke(ink, 1.2)) +
           text({0.0, tail - 7.0}, label, {.anchor = "middle", .halo = true});
  }
  return out + "</g>\n";
}

/// Platens and stresses around `box`.
inline std::string walls(const SpecimenPicture& picture, const Box& box) {
  const std::string x_label = stress_label(picture.stress_x, picture.stress_y);
  const std::string y_label = stress_label(picture.stress_y, picture.stress_x);
  const Pixel middle{box.left + box.width / 2.0, box.top + box.height / 2.0};
  const auto pair = [&](Pixel first, Pixel second, double angle, double length, double stress,
                        std::string_view label) {
    return wall(first, angle, length, stress, picture.platens, label) +
           wall(second, angle + 180.0, length, stress, picture.platens, "");
  };
  return pair({middle.x, box.top}, {middle.x, box.bottom()}, 0.0, box.width, picture.stress_y,
              y_label) +
         pair({box.left, middle.y}, {box.right(), middle.y}, 270.0, box.height, picture.stress_x,
              x_label);
}

/// Elements that keep their colours on a dark background.
inline std::string rock(const std::string& elements) {
  return "<g class=\"rock\">\n" + elements + "</g>\n";
}

/// What the colours of `picture` mean, one line under the other.
inline std::string key(const SpecimenPicture& picture, Pixel at) {
  std::string out;
  const auto entry = [&](const std::string& sample, std::string_view words) {
    out += rock(rectangle({at.x, at.y - 11.0, 22.0, 14.0}, fill(stone)) + sample) +
           text({at.x + 30.0, at.y}, words);
    at.y += 20.0;
  };
  const auto stretch = [&at](Colour colour) {
    return line({{at.x + 4.0, at.y - 4.0}, {at.x + 18.0, at.y - 4.0}}, stroke(colour, 3.0));
  };
  if (!picture.main_crack.empty())
    entry(stretch(okabe_ito::black), "crack connected to the injection");
  if (!picture.unconnected.empty()) entry(stretch(crack_red), "microcracks not connected to it");
  entry(injection_mark({at.x + 11.0, at.y - 4.0}), "injection point");
  return out;
}

}  // namespace drawing

/// The caption of the picture, with what the thickness of its cracks means.
inline std::string caption(const SpecimenPicture& picture) {
  const double widest = drawing::widest_aperture(picture);
  if (widest == 0.0) return picture.caption;
  const drawing::Layout layout = drawing::laid_out(picture, Medium::file);
  return picture.caption + " Crack thickness shows the aperture (at most " +
         drawing::number(1e6 * widest) + " \u00b5m) times " +
         drawing::number(layout.whole.exaggeration) + " in the whole and times " +
         drawing::number(layout.close.exaggeration) + " in the close-up.";
}

/// The picture as SVG; in a file it is at most 1050 pixels wide.
inline std::string svg(const SpecimenPicture& picture, Medium medium = Medium::file) {
  using namespace drawing;
  const Layout layout = laid_out(picture, medium);
  const Panel &whole = layout.whole, &close = layout.close;
  const std::size_t discs = std::min({picture.x.size(), picture.y.size(), picture.radius.size()});

  Strokes dots;
  std::string rings;
  for (std::size_t i = 0; i < discs; ++i) {
    const double radius = picture.radius[i];
    if (!std::isfinite(picture.x[i] + picture.y[i] + radius)) continue;  // would end the path
    dots.add_disc(whole.pixel(picture.x[i], picture.y[i]), radius * whole.scale);
    const Pixel centre = close.pixel(picture.x[i], picture.y[i]);
    const double reach = radius * close.scale;
    const Box visible{close.box.left - reach, close.box.top - reach, close.box.width + 2.0 * reach,
                      close.box.height + 2.0 * reach};
    if (visible.contains(centre)) rings += circle(centre, reach);
  }
  const std::string thin = stroke(grey, 1.0);
  const std::string body =
      rock(rectangle(whole.box, fill(pore)) + dots.elements(stone) + whole.cracks(picture) +
           rectangle(layout.region(), thin) + whole.injection(picture)) +
      (picture.platens ? "" : rectangle(whole.box, thin)) + walls(picture, whole.box) +
      layout.leaders(medium, thin) + whole.scale_bar(Layout::surround) +
      rock(window(close.box, rectangle(close.box, fill(pore)) + "<g" + fill(stone) +
                                 attribute("stroke", hex(stone_rim)) + ">\n" + rings + "</g>\n" +
                                 close.cracks(picture)) +
           close.injection(picture)) +
      rectangle(close.box, thin) + close.scale_bar(18.0) +
      key(picture, {close.box.left, close.box.bottom() + 50.0});
  return sheet(picture.title, caption(picture), picture.conditions, layout.width, layout.height,
               body, medium);
}

}  // namespace hfdem::observe
