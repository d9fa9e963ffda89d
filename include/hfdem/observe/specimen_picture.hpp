#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <hfdem/observe/svg.hpp>

/// \file
/// The discs of a specimen and the crack among them as SVG: the whole and a close-up.

namespace hfdem::observe {

/// A straight piece of crack; lengths in m.
struct CrackSegment {
  double x0 = 0.0, y0 = 0.0, x1 = 0.0, y1 = 0.0;
  double aperture = 0.0;
};

/// Lengths in m, y up, the lower left corner of the box at (0, 0).
struct SpecimenPicture {
  std::span<const double> x{}, y{}, radius{};  ///< of the discs
  double width = 1.0, height = 1.0;            ///< of the box
  std::vector<CrackSegment> main_crack{};      ///< filled by the injection
  std::vector<CrackSegment> unconnected{};     ///< bonds broken elsewhere
  double injection_x = 0.0, injection_y = 0.0;
  double stress_x = 0.0, stress_y = 0.0;  ///< on the walls in Pa, compression positive; 0: none
  bool platens = true;
  std::string title{}, caption{};
};

namespace drawing {

inline constexpr Colour stone{222, 215, 203}, stone_rim{150, 140, 124}, steel{120, 128, 136},
    crack_red{204, 0, 0};

/// Strokes sorted by their width, so that one path can hold all those that look alike.
class Strokes {
 public:
  void add(Pixel from, Pixel to, double width) {
    Path& path = paths_[std::lround(width / step)];
    path.move_to(from);
    path.line_to(to);
  }
  void add_disc(Pixel centre, double radius) {
    paths_[std::lround(2.0 * radius / step)].dot(centre);
  }
  [[nodiscard]] std::string elements(Colour colour) const {
    std::string out;
    for (const auto& [width, path] : paths_) {
      out += path.element(attribute("stroke-width", static_cast<double>(width) * step));
    }
    return "<g" + attribute("stroke", hex(colour)) + attribute("stroke-linecap", "round") +
           attribute("fill", "none") + ">\n" + out + "</g>\n";
  }

 private:
  static constexpr double step = 0.1;  // of the widths
  std::map<long, Path> paths_;
};

inline std::string injection_mark(Pixel at) {
  return circle(at, 6.0, fill(white)) + circle(at, 4.5, fill(okabe_ito::blue));
}

/// A part of the specimen on the page: (from_left, from_bottom), in m, lies at its lower corner.
struct Panel {
  Box box{};
  double scale = 1.0;  ///< pixels per m
  double from_left = 0.0, from_bottom = 0.0;
  double thinnest = 1.0;      ///< pixels that a crack is wide at least
  double exaggeration = 1.0;  ///< of apertures beyond the scale

  [[nodiscard]] Pixel pixel(double x, double y) const {
    return {box.left + (x - from_left) * scale, box.bottom() - (y - from_bottom) * scale};
  }

  [[nodiscard]] std::string cracks(const SpecimenPicture& picture) const {
    const auto drawn = [this](const std::vector<CrackSegment>& segments, Colour colour) {
      Strokes strokes;
      for (const CrackSegment& s : segments) {
        strokes.add(pixel(s.x0, s.y0), pixel(s.x1, s.y1),
                    std::max(thinnest, s.aperture * scale * exaggeration));
      }
      return strokes.elements(colour);
    };
    return drawn(picture.unconnected, crack_red) + drawn(picture.main_crack, okabe_ito::black);
  }
  [[nodiscard]] std::string injection(const SpecimenPicture& picture) const {
    return injection_mark(pixel(picture.injection_x, picture.injection_y));
  }

  /// A round length below the panel, about an eighth of its longer side.
  [[nodiscard]] std::string scale_bar(double below) const {
    const double length = round_down(std::max(box.width, box.height) / scale / 8.0);
    const Pixel start{box.left, box.bottom() + below};
    const double end = start.x + length * scale;
    const std::string words =
        length < 0.09 ? number(1e3 * length, 3) + " mm" : number(length) + " m";
    return line({{start.x, start.y - 4.0}, start, {end, start.y}, {end, start.y - 4.0}},
                stroke(ink, 1.2)) +
           text({end + 8.0, start.y + 2.0}, words);
  }
};

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

/// What the colours of `picture` mean, one line under the other.
inline std::string key(const SpecimenPicture& picture, Pixel at) {
  std::string out;
  const auto entry = [&](const std::string& sample, std::string_view words) {
    out += sample + text({at.x + 26.0, at.y}, words);
    at.y += 18.0;
  };
  const auto stretch = [&at](Colour colour) {
    return line({{at.x, at.y - 4.0}, {at.x + 18.0, at.y - 4.0}}, stroke(colour, 3.0));
  };
  if (!picture.main_crack.empty())
    entry(stretch(okabe_ito::black), "crack connected to the injection");
  if (!picture.unconnected.empty()) entry(stretch(crack_red), "microcracks not connected to it");
  entry(injection_mark({at.x + 9.0, at.y - 4.0}), "injection point");
  return out;
}

}  // namespace drawing

/// The picture as an SVG document, at most 1050 pixels wide.
inline std::string svg(const SpecimenPicture& picture) {
  using namespace drawing;
  constexpr double longest = 500.0, close_side = 360.0, surround = 62.0;
  const std::size_t discs = std::min({picture.x.size(), picture.y.size(), picture.radius.size()});
  double diameters = 0.0;
  for (const double r : picture.radius) diameters += 2.0 * r;
  double widest = 0.0;
  for (const auto* segments : {&picture.main_crack, &picture.unconnected}) {
    for (const CrackSegment& s : *segments) widest = std::max(widest, s.aperture);
  }
  const auto exaggeration = [widest](double scale, double pixels) {
    return widest > 0.0 ? std::max(1.0, round_down(pixels / (widest * scale))) : 1.0;
  };

  Panel whole{.scale = longest / std::max(picture.width, picture.height), .thinnest = 1.2};
  whole.box = {.left = surround,
               .width = picture.width * whole.scale,
               .height = picture.height * whole.scale};
  whole.box.top = std::max(surround, (close_side - whole.box.height) / 2.0);
  whole.exaggeration = exaggeration(whole.scale, 5.0);

  double side = 0.6 * std::min(picture.width, picture.height);
  if (discs > 0) side = std::min(side, 12.0 * diameters / static_cast<double>(discs));
  Panel close{.scale = close_side / side, .thinnest = 2.0};
  close.from_left = std::clamp(picture.injection_x - side / 2.0, 0.0, picture.width - side);
  close.from_bottom = std::clamp(picture.injection_y - side / 2.0, 0.0, picture.height - side);
  close.box = {whole.box.right() + 80.0, whole.box.top + (whole.box.height - close_side) / 2.0,
               close_side, close_side};
  close.exaggeration = exaggeration(close.scale, 8.0);

  Strokes dots;
  std::string rings;
  for (std::size_t i = 0; i < discs; ++i) {
    const double radius = picture.radius[i];
    if (!std::isfinite(picture.x[i] + picture.y[i] + radius)) continue;  // would end the path
    dots.add_disc(whole.pixel(picture.x[i], picture.y[i]), radius * whole.scale);
    const Pixel centre = close.pixel(picture.x[i], picture.y[i]);
    const double reach = radius * close.scale;
    const Box visible{close.box.left - reach, close.box.top - reach, close_side + 2.0 * reach,
                      close_side + 2.0 * reach};
    if (visible.contains(centre)) rings += circle(centre, reach);
  }
  const Pixel corner = whole.pixel(close.from_left, close.from_bottom + side);
  const Box region{corner.x, corner.y, side * whole.scale, side * whole.scale};
  const std::string thin = stroke(grey, 1.0);
  const std::string body =
      dots.elements(stone) + whole.cracks(picture) + rectangle(region, thin) +
      line({{region.right(), region.top}, {close.box.left, close.box.top}}, thin) +
      line({{region.right(), region.bottom()}, {close.box.left, close.box.bottom()}}, thin) +
      (picture.platens ? "" : rectangle(whole.box, thin)) + walls(picture, whole.box) +
      whole.injection(picture) + whole.scale_bar(surround) +
      window(close.box, "<g" + fill(stone) + attribute("stroke", hex(stone_rim)) + ">\n" + rings +
                            "</g>\n" + close.cracks(picture)) +
      rectangle(close.box, thin) + close.injection(picture) + close.scale_bar(18.0) +
      key(picture, {close.box.left, close.box.bottom() + 48.0});

  std::string caption = picture.caption;
  if (widest > 0.0) {
    caption += " Crack thickness shows the aperture (at most " + number(1e6 * widest) +
               " \u00b5m) times " + number(whole.exaggeration) + " on the left and times " +
               number(close.exaggeration) + " in the close-up.";
  }
  const double height = std::max(whole.box.bottom() + surround + 6.0, close.box.bottom() + 88.0);
  return page(picture.title, caption, close.box.right(), height, body);
}

}  // namespace hfdem::observe
