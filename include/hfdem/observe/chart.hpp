#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <hfdem/observe/chart_layout.hpp>
#include <hfdem/observe/svg.hpp>

/// \file
/// Line charts as SVG. Words may hold groups like `S_{min}` and `10^{-6}`.

namespace hfdem::observe {

/// A line through (x, y), named where it ends; a value that is not finite breaks it.
struct Series {
  /// How it is drawn.
  enum class Style { line, dashed, dotted, markers };

  std::string name{};                           ///< shown where the line ends
  std::vector<double> x{}, y{};                 ///< in the units of the axes
  Style style = Style::line;                    ///< how it is drawn
  std::optional<Colour> colour = std::nullopt;  ///< unset: the next one of the palette

  /// Number of points: values without a partner do not count.
  [[nodiscard]] std::size_t size() const { return std::min(x.size(), y.size()); }
};

/// A single value, such as a published one, drawn as a ring with its name beside it.
struct Point {
  std::string name;              ///< shown beside the ring
  double x = 0.0, y = 0.0;       ///< in the units of the axes
  Colour colour = drawing::ink;  ///< of the ring
};

/// Lines and single values over a pair of axes.
struct Chart {
  std::string title{}, x_label{}, y_label{};  ///< of the chart; of the axes, with their units
  std::string caption{};                      ///< what to see
  std::string conditions{};                   ///< with which parameters
  std::vector<Series> series{};               ///< later ones lie on top
  std::vector<Point> points{};                ///< over the lines
  std::optional<Range> x_range = std::nullopt, y_range = std::nullopt;  ///< unset: fit the data
};

namespace drawing {

/// The measures of a chart, in pixels. Charts of one page stand under one another: the least room
/// beside their plots lets the axes of time meet.
struct ChartSize {
  double width = 800.0, plot_height = 330.0;
  double name_width = 190.0;  ///< the names of lines and points are broken to
  double least_left = 0.0, least_right = 0.0;

  static constexpr ChartSize on(Medium medium) {
    if (medium == Medium::phone) return {400.0, 280.0, 84.0, 30.0, 76.0};
    if (medium == Medium::page) return {880.0, 360.0, 190.0, 36.0, 146.0};
    return {};
  }
};

inline std::string paint(Series::Style style, Colour colour) {
  const std::string round = R"( stroke-linecap="round" stroke-linejoin="round")";
  switch (style) {
    case Series::Style::line:
      return stroke(colour, 1.6) + round;
    case Series::Style::dashed:
      return stroke(colour, 1.8) + attribute("stroke-dasharray", "7 4");
    case Series::Style::dotted:
      return stroke(colour, 2.4) + round + attribute("stroke-dasharray", "0 5");
    case Series::Style::markers:
      break;
  }
  return stroke(colour, 5.0) + round;
}

/// A ring and its name, clear of the obstacles where that can be; the name is one more of them.
inline std::string ring(Pixel at, const std::vector<std::string>& words, Colour colour,
                        const Box& plot, Line& obstacles) {
  TextStyle style{.colour = readable(colour), .halo = true};
  const auto [box, anchor] = place_beside(
      at, {.width = widest(words), .height = style.leading() * static_cast<double>(words.size())},
      plot, obstacles);
  obstruct(obstacles, box);
  style.anchor = anchor;
  const double share = anchor == "start" ? 0.0 : anchor == "end" ? 1.0 : 0.5;
  const Pixel near{std::clamp(at.x, box.left, box.right()),
                   std::clamp(at.y, box.top, box.bottom())};
  const double distance = std::hypot(near.x - at.x, near.y - at.y);
  std::string leader;
  if (distance > 15.0) {
    const double rim = 5.5 / distance;
    leader = line({{std::lerp(at.x, near.x, rim), std::lerp(at.y, near.y, rim)}, near},
                  stroke(style.colour, 0.7));
  }
  return leader + circle(at, 4.5, stroke(colour, 2.0)) +
         text({box.left + share * box.width, box.top + style.size}, words, style);
}

/// The parts of a chart that depend on its axes.
class Plot {
 public:
  /// Leaves room for the tick labels on the left and for names of `names_width` on the right.
  Plot(Range x, Range y, double names_width, const ChartSize& size) : name_width_(size.name_width) {
    box_.left = size.least_left;
    box_.top = 24.0;  // below the label of the y axis
    box_.height = size.plot_height;
    y_ = {y, box_.bottom(), box_.top};
    for (const double tick : y_.ticks()) {
      box_.left = std::max(box_.left, text_width(y_.tick_label(tick)) + 8.0);
    }
    box_.width = size.width - box_.left - (names_width > 0.0 ? names_width + 16.0 : 8.0);
    x_ = {x, box_.left, box_.right()};
  }

  [[nodiscard]] double height() const { return box_.bottom() + 44.0; }

  [[nodiscard]] std::string axes(const Chart& chart) const {
    TextStyle style{.colour = grey, .anchor = "end"};
    std::string out = text({0.0, 10.0}, y_.label(chart.y_label));
    for (const double tick : y_.ticks()) {
      const double at = y_.pixel(tick);
      out += line({{box_.left, at}, {box_.right(), at}}, stroke(pale, 1.0)) +
             text({box_.left - 8.0, at + 4.0}, y_.tick_label(tick), style);
    }
    style.anchor = "middle";
    for (const double tick : x_.ticks()) {
      const double at = x_.pixel(tick);
      out += line({{at, box_.bottom()}, {at, box_.bottom() + 5.0}}, stroke(grey, 1.0)) +
             text({at, box_.bottom() + 19.0}, x_.tick_label(tick), style);
    }
    style.colour = ink;
    return out +
           line({{box_.left, box_.bottom()}, {box_.right(), box_.bottom()}}, stroke(grey, 1.0)) +
           text({box_.left + box_.width / 2.0, height() - 2.0}, x_.label(chart.x_label), style);
  }

  /// The line itself; its name waits for `names`.
  [[nodiscard]] std::string curve(const Series& series, Colour colour) {
    Path path;
    std::string lone;  // points without neighbours to draw a line to
    std::optional<Pixel> end;
    for (const Line& piece : pieces(series)) {
      if (const auto piece_end = end_in(box_, piece)) end = piece_end;
      const bool dots = series.style == Series::Style::markers;
      const Line shown = dots ? piece : simplified(piece);
      path.move_to(shown.front());
      for (const Pixel& p : shown) dots ? path.dot(p) : path.line_to(p);
      if (piece.size() == 1) lone += circle(piece.front(), 2.5, fill(colour));
      obstruct(obstacles_, shown);
    }
    if (!end) return {};
    const auto words = wrap(series.name, name_width_);
    if (!words.empty()) names_.push_back({words, readable(colour), *end});
    // wider than the plot by half a stroke
    return window({box_.left - 3.0, box_.top - 3.0, box_.width + 6.0, box_.height + 6.0},
                  path.element(paint(series.style, colour)) + lone);
  }

  /// The names of the lines so far.
  [[nodiscard]] std::string names() {
    spread(names_, box_.top - 8.0, box_.bottom() + 8.0);
    std::string out;
    for (const EndLabel& name : names_) {
      const Pixel start{box_.right() + 14.0, name.top + name.height() / 2.0};
      const bool ends_early = name.end.x < box_.right() - 4.0;
      if (ends_early || std::abs(start.y - name.end.y) > 2.0) {
        const Line leader{name.end, {box_.right() + 2.0, name.end.y}, {start.x - 2.0, start.y}};
        out += line(leader, stroke(name.colour, 0.7) +
                                (ends_early ? attribute("stroke-dasharray", "1 3") : ""));
        obstruct(obstacles_, leader);
      }
      out += text({start.x, name.top + 13.0}, name.words, {.colour = name.colour});
    }
    return out;
  }

  /// Rings and their names, clear of what has been drawn where that can be.
  [[nodiscard]] std::string marks(const std::vector<Point>& points) {
    std::vector<std::pair<Pixel, const Point*>> visible;
    for (const Point& point : points) {
      const Pixel at = pixel(point.x, point.y);
      if (!box_.contains(at)) continue;  // nor does it contain what is not finite
      visible.emplace_back(at, &point);
      obstruct(obstacles_, {{at.x - 6.0, at.y}, {at.x + 6.0, at.y}, {at.x, at.y - 6.0}});
    }
    std::string out;
    for (const auto& [at, point] : visible)
      out += ring(at, wrap(point->name, name_width_), point->colour, box_, obstacles_);
    return out;
  }

 private:
  [[nodiscard]] Pixel pixel(double x, double y) const { return {x_.pixel(x), y_.pixel(y)}; }

  /// The unbroken parts of a series.
  [[nodiscard]] std::vector<Line> pieces(const Series& series) const {
    std::vector<Line> lines(1);
    for (std::size_t i = 0; i < series.size(); ++i) {
      const Pixel p = pixel(series.x[i], series.y[i]);
      if (std::isfinite(p.x) && std::isfinite(p.y))
        lines.back().push_back(p);
      else if (!lines.back().empty())
        lines.emplace_back();
    }
    if (lines.back().empty()) lines.pop_back();
    return lines;
  }

  Box box_;
  Axis x_, y_;
  double name_width_;
  std::vector<EndLabel> names_;
  Line obstacles_;  ///< samples of all that names of points should not cover
};

}  // namespace drawing

/// The caption of the picture.
inline std::string caption(const Chart& chart) { return chart.caption; }

/// The chart as SVG; in a file it is 848 pixels wide.
inline std::string svg(const Chart& chart, Medium medium = Medium::file) {
  using namespace drawing;
  const ChartSize size = ChartSize::on(medium);
  Range x_data = no_range, y_data = no_range;
  const auto include_datum = [&](double x, double y) {
    if (!std::isfinite(x) || !std::isfinite(y)) return;
    if (chart.x_range && (x < chart.x_range->low || x > chart.x_range->high)) return;
    include(x_data, x);
    include(y_data, y);
  };
  double names_width = size.least_right;
  for (const Series& s : chart.series) {
    for (std::size_t i = 0; i < s.size(); ++i) include_datum(s.x[i], s.y[i]);
    names_width = std::max(names_width, widest(wrap(s.name, size.name_width)));
  }
  for (const Point& p : chart.points) include_datum(p.x, p.y);

  Plot plot(widened(chart.x_range.value_or(x_data)),
            widened(chart.y_range.value_or(padded(y_data))), names_width, size);
  std::string body = plot.axes(chart);
  std::size_t next = 0;
  for (const Series& s : chart.series) {
    body += plot.curve(s, s.colour.value_or(palette[next++ % palette.size()]));
  }
  body += plot.names();
  body += plot.marks(chart.points);
  return sheet(chart.title, chart.caption, chart.conditions, size.width, plot.height(), body,
               medium);
}

}  // namespace hfdem::observe
