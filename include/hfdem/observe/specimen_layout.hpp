#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <hfdem/observe/svg.hpp>

/// \file
/// What a picture of a specimen needs to lay out its two panels and to draw cracks in them.

namespace hfdem::observe {

/// A straight piece of crack; lengths in m.
struct CrackSegment {
  double x0 = 0.0, y0 = 0.0, x1 = 0.0, y1 = 0.0;  ///< its ends
  double aperture = 0.0;                          ///< w
};

/// Lengths in m, y up, the lower left corner of the box at (0, 0).
struct SpecimenPicture {
  std::vector<double> x{}, y{}, radius{};       ///< of the discs
  double width = 1.0, height = 1.0;             ///< of the box
  std::vector<CrackSegment> main_crack{};       ///< filled by the injection
  std::vector<CrackSegment> unconnected{};      ///< bonds broken elsewhere
  double injection_x = 0.0, injection_y = 0.0;  ///< where the fluid enters
  double stress_x = 0.0, stress_y = 0.0;  ///< on the walls in Pa, compression positive; 0: none
  bool platens = true;                    ///< whether they are drawn
  std::string title{};                    ///< above the picture
  std::string caption{};                  ///< what to see
  std::string conditions{};               ///< with which parameters
};

namespace drawing {

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

/// Where the whole and the close-up lie: side by side, or on a phone one under the other.
struct Layout {
  static constexpr double surround = 62.0;  ///< around the whole: platens, arrows, stresses

  Panel whole{.thinnest = 1.2}, close{.thinnest = 2.0};
  double width = 0.0, height = 0.0;

  Layout(const SpecimenPicture& picture, Medium medium) {
    const bool stacked = medium == Medium::phone;
    const double longest = stacked ? 276.0 : 500.0, close_side = stacked ? 276.0 : 360.0;
    whole.scale = longest / std::max(picture.width, picture.height);
    whole.box = {.left = surround,
                 .width = picture.width * whole.scale,
                 .height = picture.height * whole.scale};
    whole.box.top = stacked ? surround : std::max(surround, (close_side - whole.box.height) / 2.0);

    const double side = close_up_side(picture);
    close.scale = close_side / side;
    close.from_left = std::clamp(picture.injection_x - side / 2.0, 0.0, picture.width - side);
    close.from_bottom = std::clamp(picture.injection_y - side / 2.0, 0.0, picture.height - side);
    close.box = {.width = close_side, .height = close_side};
    if (stacked) {
      close.box.left = surround;
      close.box.top = whole.box.bottom() + surround + 30.0;
      width = std::max(whole.box.right(), close.box.right()) + surround;
      height = close.box.bottom() + 100.0;
    } else {
      close.box.left = whole.box.right() + 80.0;
      close.box.top = whole.box.top + (whole.box.height - close_side) / 2.0;
      width = close.box.right();
      height = std::max(whole.box.bottom() + surround + 6.0, close.box.bottom() + 92.0);
    }
  }

  /// The close-up's part of the whole.
  [[nodiscard]] Box region() const {
    const double side = close.box.width / close.scale * whole.scale;
    const Pixel corner = whole.pixel(close.from_left, close.from_bottom);
    return {corner.x, corner.y - side, side, side};
  }

  /// From the region to the close-up.
  [[nodiscard]] std::string leaders(Medium medium, std::string_view paint) const {
    const Box from = region();
    if (medium == Medium::phone)
      return line({{from.left, from.bottom()}, {close.box.left, close.box.top}}, paint) +
             line({{from.right(), from.bottom()}, {close.box.right(), close.box.top}}, paint);
    return line({{from.right(), from.top}, {close.box.left, close.box.top}}, paint) +
           line({{from.right(), from.bottom()}, {close.box.left, close.box.bottom()}}, paint);
  }

 private:
  /// Six diameters to each side of the injection, if the specimen is that large.
  static double close_up_side(const SpecimenPicture& picture) {
    const double side = 0.6 * std::min(picture.width, picture.height);
    double diameters = 0.0;
    for (const double r : picture.radius) diameters += 2.0 * r;
    const auto discs = static_cast<double>(picture.radius.size());
    return discs > 0.0 ? std::min(side, 12.0 * diameters / discs) : side;
  }
};

inline double widest_aperture(const SpecimenPicture& picture) {
  double widest = 0.0;
  for (const auto* segments : {&picture.main_crack, &picture.unconnected})
    for (const CrackSegment& s : *segments) widest = std::max(widest, s.aperture);
  return widest;
}

/// Both panels, with thicknesses that show apertures: exaggerated alike on every medium.
inline Layout laid_out(const SpecimenPicture& picture, Medium medium) {
  Layout layout(picture, medium);
  const Layout on_file(picture, Medium::file);
  const double widest = widest_aperture(picture);
  const auto exaggeration = [widest](double scale, double pixels) {
    return widest > 0.0 ? std::max(1.0, round_down(pixels / (widest * scale))) : 1.0;
  };
  layout.whole.exaggeration = exaggeration(on_file.whole.scale, 5.0);
  layout.close.exaggeration = exaggeration(on_file.close.scale, 8.0);
  return layout;
}

}  // namespace drawing
}  // namespace hfdem::observe
