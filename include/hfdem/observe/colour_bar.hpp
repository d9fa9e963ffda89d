/// \file
/// Colours for fields, and the bar that says what they mean.
///
/// Viridis by S. van der Walt and N. Smith (2015, CC0), which grows evenly brighter and reads in
/// greyscale, through nine of its colours.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <hfdem/observe/chart_layout.hpp>
#include <hfdem/observe/svg.hpp>

namespace hfdem::observe {

/// The colour of a share of the range; shares outside [0, 1] get that of its ends.
inline Colour viridis(double share) {
  constexpr std::array<Colour, 9> colours{{{68, 1, 84},
                                           {71, 45, 123},
                                           {59, 82, 139},
                                           {44, 114, 142},
                                           {33, 145, 140},
                                           {40, 174, 128},
                                           {94, 201, 98},
                                           {173, 220, 48},
                                           {253, 231, 37}}};
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(colours.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), colours.size() - 2);
  const double part = place - static_cast<double>(below);
  const Colour from = colours[below], to = colours[below + 1];
  const auto mix = [&](std::uint8_t Colour::*channel) {
    const double difference = to.*channel - from.*channel;
    return static_cast<std::uint8_t>(std::lround(from.*channel + part * difference));
  };
  return {mix(&Colour::red), mix(&Colour::green), mix(&Colour::blue)};
}

/// A range of values in `bands` colours.
struct ColourScale {
  Range range;     ///< of the values
  int bands = 32;  ///< number of colours

  /// Where a finite value belongs, from 0; values out of range belong to the first or last band.
  [[nodiscard]] int band(double value) const {
    const double share = (value - range.low) / (range.high - range.low);
    return std::clamp(static_cast<int>(std::floor(share * bands)), 0, bands - 1);
  }
  /// That of a band.
  [[nodiscard]] Colour colour(int band) const { return viridis((band + 0.5) / bands); }

  /// Fits the values that are finite, out to round numbers.
  static ColourScale of(const std::vector<double>& values) {
    Range range = drawing::no_range;
    for (const double v : values)
      if (std::isfinite(v)) drawing::include(range, v);
    return {drawing::padded(range)};
  }
};

namespace drawing {

/// The scale as an upright bar with ticks to its right and `label` above it.
inline std::string colour_bar(const Box& box, const ColourScale& scale, std::string_view label) {
  std::string out = text({box.left, box.top - 10.0}, label);
  const double step = box.height / scale.bands;
  std::string bands;
  for (int k = 0; k < scale.bands; ++k)  // each reaches under the next: no gaps between them
    bands += rectangle({box.left, box.bottom() - (k + 1) * step, box.width, step + (k ? 0.5 : 0.0)},
                       fill(scale.colour(k)));
  out += "<g class=\"rock\">\n" + bands + "</g>\n" + rectangle(box, stroke(grey, 0.7));
  const Axis axis{scale.range, box.bottom(), box.top};
  for (const double tick : axis.ticks()) {
    const double at = axis.pixel(tick);
    out += line({{box.right(), at}, {box.right() + 4.0, at}}, stroke(grey, 1.0)) +
           text({box.right() + 8.0, at + 4.0}, axis.tick_label(tick));
  }
  return out;
}

}  // namespace drawing
}  // namespace hfdem::observe
