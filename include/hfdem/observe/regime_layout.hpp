/// @file
/// What a map of propagation regimes shows, and where.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <hfdem/analytic/kgd_regions.hpp>
#include <hfdem/observe/chart_layout.hpp>
#include <hfdem/observe/svg.hpp>

namespace hfdem::observe {

/// A case on the map. One that is known by tau and K_m alone: `analytic::problem_at`.
struct RegimePoint {
  std::string name{};              ///< beside it
  analytic::KgdProblem problem{};  ///< tau and K_m are its
  std::string verdict{};           ///< below the name, such as "length +1.2\u00a0%"
};

/// Cases among the regions.
struct RegimeMap {
  std::vector<RegimePoint> points{};                                     ///< later ones give way
  std::string title = "Propagation regimes of a plane-strain fracture";  ///< above the picture
  std::string caption{};                                                 ///< what to see
  std::string conditions{};                                              ///< with which parameters
};

namespace drawing {

/// A point on the page.
struct PlacedPoint {
  Pixel at{};
  Pixel way{};  ///< to where it really is, of length 1, if it is beyond the rim
  bool beyond = false, in_strip = false;
  std::vector<std::string> words{};
};

/// The map, and to its left the strip without leak-off, over one axis of toughness.
struct RegimeLayout {
  Box strip{.left = 40.0, .top = 24.0, .width = 72.0}, map{};
  Axis time{}, toughness{};   ///< log10 of tau and of K_m
  double strip_names = 0.0;   ///< where those of its points begin
  double name_width = 130.0;  ///< names are broken to
  double width = 800.0, height = 0.0;
  bool wide = true;
  std::vector<PlacedPoint> points{};

  RegimeLayout(const RegimeMap& regimes, Medium medium) : wide(medium != Medium::phone) {
    width = wide ? medium == Medium::page ? 880.0 : 800.0 : 400.0;
    if (!wide) name_width = 100.0;
    fit_axes(regimes);
    double names = 0.0;
    for (const RegimePoint& p : regimes.points) {
      if (p.problem.leak_off > 0) continue;
      const auto words = words_of(p);
      strip_names = strip.left + 28.0;
      strip.width = std::max(strip.width, 28.0 + widest(words) + 4.0);
      names += EndLabel{words, ink, {}}.height();
    }
    strip.height = std::max(wide ? 380.0 : 300.0, names);
    map = strip;
    map.left = strip.right() + 12.0;
    map.width = width - map.left - 20.0;  // half a tick label
    height = map.bottom() + 44.0;
    time.from = map.left, time.to = map.right();
    toughness.from = map.bottom(), toughness.to = map.top;
    for (const RegimePoint& p : regimes.points) points.push_back(placed(p));
  }

  [[nodiscard]] Pixel pixel(const analytic::KgdPlace& place) const {
    return {time.pixel(place.log_time), toughness.pixel(place.log_toughness)};
  }
  /// Whether there are points beyond the rim.
  [[nodiscard]] bool beyond() const { return std::ranges::any_of(points, &PlacedPoint::beyond); }

  [[nodiscard]] bool has_ring_in(const Box& box) const {
    const Box around{box.left - 9.0, box.top - 9.0, box.width + 18.0, box.height + 18.0};
    return std::ranges::any_of(points, [&](const auto& p) { return around.contains(p.at); });
  }

  [[nodiscard]] std::string axes() const {
    std::string out = text({0.0, 10.0}, wide ? "dimensionless toughness K_{m}" : "toughness K_{m}");
    TextStyle style{.colour = grey, .anchor = "end"};
    const bool many_decades = toughness.range.high - toughness.range.low > 3.5;
    for (double k = std::floor(toughness.range.low); k <= toughness.range.high; ++k)
      for (const double lead : {1.0, 2.0, 5.0}) {
        const double log_value = k + std::log10(lead), at = toughness.pixel(log_value);
        if (at > map.bottom() + 0.1 || at < map.top - 0.1 || (many_decades && lead > 1.0)) continue;
        for (const Box& box : {strip, map})
          out += line({{box.left, at}, {box.right(), at}}, stroke(pale, 1.0));
        out += text({strip.left - 8.0, at + 4.0}, number(lead * std::pow(10.0, k), 3), style);
      }
    style.anchor = "middle";
    const auto tick = [&](double at, const std::string& words) {
      out += line({{at, map.bottom()}, {at, map.bottom() + 5.0}}, stroke(grey, 1.0)) +
             text({at, map.bottom() + 19.0}, words, style);
    };
    const double step = wide ? 5.0 : 10.0;
    for (double k = std::ceil(time.range.low / step) * step; k <= time.range.high; k += step)
      tick(time.pixel(k), power_of_ten(k));
    tick(strip.left + strip.width / 2.0, "\u03c4 = 0");
    for (const Box& box : {strip, map})
      out += line({{box.left, box.bottom()}, {box.right(), box.bottom()}}, stroke(grey, 1.0));
    style.colour = ink;
    return out + text({strip.left + strip.width / 2.0, height - 2.0}, "no leak-off", style) +
           text({map.left + map.width / 2.0, height - 2.0}, "dimensionless time \u03c4", style);
  }

 private:
  static std::string power_of_ten(double exponent) {
    if (exponent == 0.0) return "1";
    return std::string("10^{") + (exponent < 0.0 ? "\u2212" : "") + number(std::abs(exponent)) +
           "}";
  }
  [[nodiscard]] std::vector<std::string> words_of(const RegimePoint& p) const {
    auto words = wrap(p.name, name_width);
    for (const auto& more : wrap(p.verdict, name_width)) words.push_back(more);
    return words;
  }

  /// The usual range, widened for points that are not far beyond it.
  void fit_axes(const RegimeMap& regimes) {
    time.range = {-20.0, 15.0};
    toughness.range = {-1.0, 1.5};
    const auto widen = [](Range& range, double value, double farthest, double step) {
      if (!(std::abs(value) < farthest)) return;
      if (value < range.low) range.low = std::floor(value / step) * step;
      if (value > range.high) range.high = std::ceil(value / step) * step;
    };
    for (const RegimePoint& p : regimes.points) {
      widen(time.range, std::log10(analytic::dimensionless_time(p.problem)), 30.0, 5.0);
      widen(toughness.range, std::log10(analytic::dimensionless_toughness(p.problem)), 3.0, 0.5);
    }
  }

  [[nodiscard]] PlacedPoint placed(const RegimePoint& p) const {
    PlacedPoint point{.in_strip = !(p.problem.leak_off > 0), .words = words_of(p)};
    double log_K = std::log10(analytic::dimensionless_toughness(p.problem));
    double log_tau = std::log10(analytic::dimensionless_time(p.problem));
    if (log_K > toughness.range.high) {
      // Where nothing depends on viscosity, what stays the same towards the rim is tau / K_m^4.
      log_tau = analytic::log_toughness_time(p.problem) + 4.0 * toughness.range.high;
      point.way.y = -1.0;
    } else if (log_K < toughness.range.low) {
      point.way.y = 1.0;
    }
    if (!point.in_strip) {
      if (log_tau < time.range.low) point.way.x = -1.0;
      if (log_tau > time.range.high) point.way.x = 1.0;
    }
    const auto clamped = [](double value, const Range& range) {
      return std::clamp(value, range.low, range.high);
    };
    point.at = pixel({clamped(log_tau, time.range), clamped(log_K, toughness.range)});
    if (point.in_strip) point.at.x = strip.left + 14.0;
    const double length = std::hypot(point.way.x, point.way.y);
    if (length > 0.0) {  // room for an arrow
      point.beyond = true;
      point.at = {point.at.x - 17.0 * point.way.x, point.at.y - 17.0 * point.way.y};
      point.way = {point.way.x / length, point.way.y / length};
    }
    return point;
  }
};

}  // namespace drawing
}  // namespace hfdem::observe
