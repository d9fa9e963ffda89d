/// @file
/// What a picture of a crack shows, and where: close up, and in the whole specimen.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <hfdem/measure/crack_path.hpp>
#include <hfdem/observe/chart_layout.hpp>
#include <hfdem/observe/specimen_layout.hpp>
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
  std::vector<NaturalFracture> natural{};  ///< if there are any, in the colours of Figs. 14 and 15
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
  /// The connected microcracks and the natural fractures with some air, no thinner than half as
  /// wide as long.
  static Pixel zoom(const FractureMap& map, double Vec2::*axis) {
    const auto extent = [&](double Vec2::*along) {
      Range range{map.origin.position.*along, map.origin.position.*along};
      for (const auto& m : map.microcracks)
        if (m.connected)
          for (const Vec2 end : {m.facet.from, m.facet.to}) include(range, end.*along);
      for (const NaturalFracture& f : map.natural)
        for (const Vec2 end : {f.from, f.to}) include(range, end.*along);
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

}  // namespace drawing
}  // namespace hfdem::observe
