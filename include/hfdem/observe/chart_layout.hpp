#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <hfdem/observe/svg.hpp>

/// \file
/// What a chart needs to fit its axes, thin its lines and keep its names apart.

namespace hfdem::observe {

/// The values between two numbers.
struct Range {
  double low = 0.0, high = 1.0;  ///< its ends
};

namespace drawing {

/// One axis: data `range` between the pixels `from` and `to`, with a tick at multiples of `step`.
struct Axis {
  Range range;
  double from = 0.0, to = 1.0;

  [[nodiscard]] double pixel(double value) const {
    return from + (value - range.low) / (range.high - range.low) * (to - from);
  }
  [[nodiscard]] double step() const { return round_down((range.high - range.low) / 4.0); }
  [[nodiscard]] std::vector<double> ticks() const {
    std::vector<double> values;
    for (double i = std::ceil(range.low / step() - 1e-6); i * step() < range.high + 1e-6 * step();
         ++i) {
      values.push_back(i * step());
    }
    return values;
  }
  /// Power of ten, a multiple of three, that the tick labels leave to the axis label.
  [[nodiscard]] int exponent() const {
    const double largest = std::max(std::abs(range.low), std::abs(range.high));
    if (largest >= 1e-2 && largest < 1e5) return 0;
    return 3 * static_cast<int>(std::floor(std::log10(largest) / 3.0 + 1e-9));
  }
  [[nodiscard]] std::string tick_label(double tick) const {
    const double unit = std::pow(10.0, exponent());
    const auto decimals = static_cast<int>(-std::floor(std::log10(step() / unit) + 1e-9));
    const std::string digits = number(std::abs(tick) / unit, std::max(decimals, 0));
    return tick < 0.0 ? "\u2212" + digits : digits;
  }
  [[nodiscard]] std::string label(const std::string& words) const {
    return exponent() == 0 ? words
                           : words + ", ticks \u00d7 10^{" + std::to_string(exponent()) + "}";
  }
};

/// A range of no values, ready to include some.
inline constexpr Range no_range{std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity()};

inline void include(Range& range, double value) {
  range = {std::min(range.low, value), std::max(range.high, value)};
}

/// `range` if it has a width, else one around its only value, or [0, 1] around none or zero.
inline Range widened(Range range) {
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  if (range.high - range.low > 1e-9 * size) return range;  // more than rounding errors
  if (range.low > range.high || size == 0.0) return {0.0, 1.0};
  return {range.low - 0.1 * size, range.high + 0.1 * size};
}

/// `data` with some air, out to the next ticks, and from zero if there is none or zero is near.
inline Range padded(Range data) {
  const bool from_zero =
      data.low > data.high || (data.low >= -1e-3 * data.high && data.low <= 0.4 * data.high);
  data = widened(from_zero ? Range{0.0, data.high} : data);
  const double air = 0.03 * (data.high - data.low);
  data = {from_zero ? 0.0 : data.low - air, data.high + air};
  const double step = Axis{.range = data}.step();
  return {std::floor(data.low / step) * step, std::ceil(data.high / step) * step};
}

using Line = std::vector<Pixel>;

/// Distance of `p` from the segment between `a` and `b`.
inline double off(Pixel p, Pixel a, Pixel b) {
  const Pixel chord{b.x - a.x, b.y - a.y};
  const double square = std::max(chord.x * chord.x + chord.y * chord.y, 1e-12);
  const double along =
      std::clamp(((p.x - a.x) * chord.x + (p.y - a.y) * chord.y) / square, 0.0, 1.0);
  return std::hypot(p.x - a.x - along * chord.x, p.y - a.y - along * chord.y);
}

/// `line` without the points that a reader cannot see: first all but the extremes of each half
/// pixel of width, then those within 0.15 pixels of a chord.
inline Line simplified(const Line& line) {
  Line kept;
  for (std::size_t i = 0, next = 0; i < line.size(); i = next) {
    std::size_t low = i, high = i;
    const double column = std::floor(2.0 * line[i].x);
    for (next = i; next < line.size() && std::floor(2.0 * line[next].x) == column; ++next) {
      if (line[next].y < line[low].y) low = next;
      if (line[next].y > line[high].y) high = next;
    }
    std::array indices{i, low, high, next - 1};
    std::ranges::sort(indices);
    for (std::size_t k = 0; k < indices.size(); ++k) {
      if (k == 0 || indices[k] != indices[k - 1]) kept.push_back(line[indices[k]]);
    }
  }
  Line result{kept.front()};
  for (std::size_t begin = 0, end = 1; end < kept.size(); begin = end++) {
    const auto hidden = [&](Pixel p) { return off(p, kept[begin], kept[end + 1]) < 0.15; };
    while (end + 1 < kept.size() &&
           std::ranges::all_of(std::span(kept).subspan(begin + 1, end - begin), hidden)) {
      ++end;
    }
    result.push_back(kept[end]);
  }
  return result;
}

/// The name of a line, beside the right end of the plot.
struct EndLabel {
  std::vector<std::string> words;
  Colour colour;
  Pixel end;         ///< of the line
  double top = 0.0;  ///< of the label

  [[nodiscard]] double height() const {
    return TextStyle{}.leading() * static_cast<double>(words.size()) + 3.0;
  }
};

/// Puts the labels as close to the ends of their lines as they can be without overlap.
inline void spread(std::vector<EndLabel>& labels, double low, double high) {
  std::ranges::stable_sort(labels, {}, [](const EndLabel& label) { return label.end.y; });
  std::vector<double> tops;
  for (const EndLabel& label : labels) tops.push_back(label.end.y - label.height() / 2.0);
  const auto push_down = [&](std::vector<double> y, double next) {
    for (std::size_t i = 0; i < y.size(); ++i)
      next = (y[i] = std::max(y[i], next)) + labels[i].height();
    return y;
  };
  const auto push_up = [&](std::vector<double> y, double next) {
    for (std::size_t i = y.size(); i-- > 0;)
      next = y[i] = std::min(y[i], next - labels[i].height());
    return y;
  };
  // either way clears the overlaps, so their mean does, and it moves the labels less
  const auto down = push_down(tops, low), up = push_up(tops, high);
  std::ranges::transform(down, up, tops.begin(), [](double a, double b) { return (a + b) / 2.0; });
  tops = push_down(push_up(tops, high), low);
  for (std::size_t i = 0; i < tops.size(); ++i) labels[i].top = tops[i];
}

/// Adds samples along `line` to `obstacles`, which the names of points had better not cover.
inline void obstruct(Line& obstacles, const Line& line) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Pixel a = line[i - 1], b = line[i];
    const double count = std::clamp(std::hypot(b.x - a.x, b.y - a.y) / 3.0, 1.0, 1e3);
    for (double k = 0.0; k < count; ++k) {
      obstacles.push_back({std::lerp(a.x, b.x, k / count), std::lerp(a.y, b.y, k / count)});
    }
  }
}

/// The same all over `box`.
inline void obstruct(Line& obstacles, const Box& box) {
  for (double y = box.top; y < box.bottom(); y += 6.0)
    obstruct(obstacles, {{box.left, y}, {box.right(), y}});
}

/// Where a line leaves the plot on the right, or ends in it, if it enters it at all.
inline std::optional<Pixel> end_in(const Box& plot, const Line& line) {
  std::optional<Pixel> end;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Pixel p = line[i], last = line[i == 0 ? 0 : i - 1];
    if (p.x > plot.left - 1.0 && p.x < plot.right() + 1.0) {
      end = p;
    } else if (p.x > plot.right() && last.x <= plot.right()) {
      const double part = (plot.right() - last.x) / (p.x - last.x);
      end = Pixel{plot.right(), std::lerp(last.y, p.y, part)};
    }
  }
  if (end) end->y = std::clamp(end->y, plot.top, plot.bottom());
  return end;
}

inline double widest(const std::vector<std::string>& lines) {
  double width = 0.0;
  for (const std::string& words : lines) width = std::max(width, text_width(words));
  return width;
}

/// Where the words of a name go.
struct Place {
  Box box;
  std::string_view anchor;
};

/// The place for words of the size of `box` near `at` in `plot` that covers least of `obstacles`.
inline Place place_beside(Pixel at, Box box, const Box& plot, const Line& obstacles) {
  constexpr std::array<std::string_view, 3> anchors{"end", "middle", "start"};
  Place best;
  double least = std::numeric_limits<double>::infinity();
  for (const double gap : {10.0, 26.0, 44.0, 66.0}) {
    for (const std::size_t way : {5U, 3U, 1U, 7U, 2U, 0U, 8U, 6U}) {  // of a 3 by 3 grid
      const Pixel side{static_cast<double>(way % 3) - 1.0, static_cast<double>(way / 3) - 1.0};
      box.left = at.x + side.x * gap + (side.x - 1.0) / 2.0 * box.width;
      box.top = at.y + side.y * gap + (side.y - 1.0) / 2.0 * box.height;
      box.left = std::max(plot.left, std::min(box.left, plot.right() - box.width));
      box.top = std::max(plot.top, std::min(box.top, plot.bottom() - box.height));
      const auto covers = [&](Pixel p) { return box.contains(p); };
      const double cost = 0.05 * gap + (covers(at) ? 1e6 : 0.0) +
                          static_cast<double>(std::ranges::count_if(obstacles, covers));
      if (cost < least) {
        least = cost;
        best = {box, anchors[way % 3]};
      }
    }
  }
  return best;
}

}  // namespace drawing
}  // namespace hfdem::observe
