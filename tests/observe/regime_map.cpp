// The map of regimes, read back from its picture as a reader would: by the ticks of its axes.
#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <hfdem/observe/regime_map.hpp>

#include <doctest/doctest.h>

#include "analytic/kgd_truth.hpp"
#include "near.hpp"

using namespace hfdem::observe;
using namespace hfdem::analytic;
using test::near;
using Vertex = KgdRegime;

namespace {

struct Words {
  double x, y;
  std::string anchor, text;

  /// As wide as an average letter of DejaVu Sans makes them.
  drawing::Box box() const {
    const double width = 12.0 * 0.56 * static_cast<double>(text.size());
    const double left = anchor == "end" ? x - width : anchor == "middle" ? x - width / 2.0 : x;
    return {left, y - 10.0, width, 12.0};
  }
};

std::vector<Words> words_in(const std::string& svg) {
  static const std::regex element("<text x=\"([^\"]*)\" y=\"([^\"]*)\"([^>]*)>(.*)</text>\n");
  std::vector<Words> all;
  for (std::sregex_iterator it(svg.begin(), svg.end(), element), end; it != end; ++it) {
    const std::string style = (*it)[3];
    const std::string anchor = style.find("\"end\"") != std::string::npos      ? "end"
                               : style.find("\"middle\"") != std::string::npos ? "middle"
                                                                               : "start";
    all.push_back({std::stod((*it)[1]), std::stod((*it)[2]), anchor,
                   std::regex_replace(it->str(4), std::regex("<[^>]*>"), "")});
  }
  return all;
}

std::vector<drawing::Pixel> rings_in(const std::string& svg) {
  static const std::regex element("<circle cx=\"([^\"]*)\" cy=\"([^\"]*)\"");
  std::vector<drawing::Pixel> all;
  for (std::sregex_iterator it(svg.begin(), svg.end(), element), end; it != end; ++it)
    all.push_back({std::stod((*it)[1]), std::stod((*it)[2])});
  return all;
}

/// The axes of a picture.
class Ticks {
 public:
  explicit Ticks(const std::string& svg) {
    for (const Words& w : words_in(svg)) {
      if (w.text == "10\u221215") x_low_ = w.x;
      if (w.text == "1010") x_high_ = w.x;
      if (w.text == "0.1") y_low_ = w.y - 4.0;
      if (w.text == "10" && w.anchor == "end") y_high_ = w.y - 4.0;
    }
  }
  double log_time(double x) const { return -15.0 + 25.0 * (x - x_low_) / (x_high_ - x_low_); }
  double log_toughness(double y) const { return -1.0 + 2.0 * (y - y_low_) / (y_high_ - y_low_); }

 private:
  double x_low_ = 0, x_high_ = 0, y_low_ = 0, y_high_ = 0;
};

/// The corners of the unfilled lines of a colour.
std::vector<std::vector<drawing::Pixel>> lines_in(const std::string& svg, Colour colour) {
  const std::regex element("<path d=\"([^\"]*)\" fill=\"none\" stroke=\"" + drawing::hex(colour));
  std::vector<std::vector<drawing::Pixel>> lines;
  for (std::sregex_iterator it(svg.begin(), svg.end(), element), end; it != end; ++it) {
    std::istringstream steps(std::regex_replace(it->str(1), std::regex("[ml]|(-)"), " $1"));
    drawing::Pixel at{}, step{};
    lines.emplace_back();
    while (steps >> step.x >> step.y) {
      at = {at.x + step.x, at.y + step.y};
      lines.back().push_back(at);
    }
  }
  return lines;
}

double distance_at(Vertex vertex, double log_time, double log_toughness) {
  const auto p = test::unit_problem(std::pow(10, log_toughness), std::pow(10, log_time));
  const auto f = at_vertex(vertex, p), general = general_kgd(p);
  return std::hypot(std::log(f.half_length / general.half_length),
                    std::log(f.width / general.width));
}

RegimePoint at(const std::string& name, double log_time, double K_m) {
  return {name, problem_at({log_time, std::log10(K_m)}), "verdict of " + name};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t k = text.find(part); k != std::string::npos; k = text.find(part, k + 1)) ++n;
  return n;
}

/// No two words of a map's points and regions share a place, nor do words and rings.
void check_apart(const RegimeMap& map, Medium medium) {
  CAPTURE(static_cast<int>(medium));
  const std::string picture = svg(map, medium);
  const auto rings = rings_in(picture);
  CHECK(rings.size() == map.points.size());
  std::vector<Words> labels;
  for (const Words& w : words_in(picture))
    if (std::regex_search(w.text, std::regex("case|verdict|^storage|^leak-off|^toughness |^visc")))
      labels.push_back(w);
  CHECK(labels.size() >= 2 * map.points.size() + 8);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const drawing::Box a = labels[i].box();
    CAPTURE(labels[i].text);
    for (std::size_t k = 0; k < i; ++k) {
      CAPTURE(labels[k].text);
      const drawing::Box b = labels[k].box();
      CHECK((a.right() <= b.left || b.right() <= a.left || a.bottom() <= b.top ||
             b.bottom() <= a.top));
    }
    for (const drawing::Pixel& ring : rings)
      CHECK(!drawing::Box{a.left - 4.0, a.top - 4.0, a.width + 8.0, a.height + 8.0}.contains(ring));
  }
}

}  // namespace

TEST_CASE("on each line of the map a vertex is as far from the general solution as the key says") {
  const std::string picture = svg(RegimeMap{});
  const Ticks ticks(picture);
  for (const auto& style : drawing::vertex_styles) {
    const auto lines = lines_in(picture, style.colour);
    REQUIRE(lines.size() == 2);  // 5 % and 1 %
    CAPTURE(style.words);
    for (const std::size_t k : {0U, 1U}) {
      std::size_t checked = 0;
      for (const drawing::Pixel& corner : lines[k]) {
        const double x = ticks.log_time(corner.x), y = ticks.log_toughness(corner.y);
        if (x < -19 || x > 15 || y < -1 || y > 1.5) continue;
        CHECK(distance_at(style.vertex, x, y) == near(k == 0 ? 0.05 : 0.01, 0.025));
        ++checked;
      }
      CHECK(checked > 12);
    }
  }
  for (const char* words : {"5\u00a0%", "1\u00a0%", "a vertex is within", "no leak-off",
                            "\u03c4 = 0", "dimensionless time \u03c4", "toughness (K)",
                            "viscosity (M)", "toughness (K~)", "viscosity (M~)"})
    CHECK(count(picture, words) >= 1);
}

TEST_CASE("in the strip the bands end where the vertex is that far off without leak-off") {
  const std::string picture = svg(RegimeMap{});
  const Ticks ticks(picture);
  static const std::regex element(
      "<rect x=\"40\" y=\"([^\"]*)\" width=\"[^\"]*\" height=\"([^\"]*)\" fill=\"([^\"]*)\"");
  std::vector<double> bounds;
  for (std::sregex_iterator it(picture.begin(), picture.end(), element), end; it != end; ++it) {
    const bool upper = it->str(3) == drawing::hex(drawing::vertex_styles[0].colour);
    const double y = std::stod(it->str(1)) + (upper ? std::stod(it->str(2)) : 0.0);
    bounds.push_back(std::pow(10, ticks.log_toughness(y)));
  }
  REQUIRE(bounds.size() == 4);
  const auto off = [](Vertex vertex, double K_m) {
    const auto p = test::tight_problem(K_m);
    return vertex_distance(at_vertex(vertex, p), general_kgd(p));
  };
  CHECK(off(Vertex::storage_toughness, bounds[0]) == near(0.05, 0.01));
  CHECK(off(Vertex::storage_viscosity, bounds[1]) == near(0.05, 0.01));
  CHECK(off(Vertex::storage_toughness, bounds[2]) == near(0.01, 0.01));
  CHECK(off(Vertex::storage_viscosity, bounds[3]) == near(0.01, 0.01));
}

TEST_CASE("a point is at its tau and K_m, one without leak-off at its K_m in the strip") {
  const std::string picture = svg(RegimeMap{{at("A", -12.5, 3.0), at("B", -INFINITY, 0.7)}});
  const Ticks ticks(picture);
  const auto rings = rings_in(picture);
  REQUIRE(rings.size() == 2);
  const bool first_in_map = rings[0].x > rings[1].x;
  const auto &mapped = rings[first_in_map ? 0 : 1], &strip = rings[first_in_map ? 1 : 0];
  CHECK(ticks.log_time(mapped.x) == near(-12.5, 0.001));
  CHECK(std::pow(10, ticks.log_toughness(mapped.y)) == near(3.0, 0.005));
  CHECK(std::pow(10, ticks.log_toughness(strip.y)) == near(0.7, 0.005));
  CHECK(ticks.log_time(strip.x) < -20.0);
  CHECK(caption(RegimeMap{}).find("rrows") == std::string::npos);
}

TEST_CASE("points far away widen the axes, and what has no place has an arrow at the rim") {
  const auto wide =
      drawing::RegimeLayout({{at("thick", -23.0, 0.02), at("thin", 18.0, 200.0)}}, Medium::file);
  CHECK(wide.time.range.low == -25.0);
  CHECK(wide.time.range.high == 20.0);
  CHECK(wide.toughness.range.low == -2.0);
  CHECK(wide.toughness.range.high == 2.5);
  CHECK(!wide.beyond());

  // Without viscosity K_m and tau are infinite, but tau / K_m^4 is not.
  KgdProblem inviscid = problem_at({-6, 0.5});
  const double log_ratio = -6 - 4 * 0.5;
  inviscid.viscosity = 0;
  KgdProblem tight = inviscid, weak = problem_at({-6, 0.5});
  tight.leak_off = 0;
  weak.K_IC = 0;
  const RegimeMap map{{{"inviscid", inviscid}, {"tight", tight}, {"weak", weak}}};
  const drawing::RegimeLayout layout(map, Medium::file);
  CHECK(layout.time.range.low == -20.0);
  CHECK(layout.toughness.range.high == 1.5);
  CHECK(layout.points[0].at.x == near(layout.time.pixel(log_ratio + 4 * 1.5)));
  CHECK(layout.points[2].at.x == near(layout.time.pixel(-6)));
  for (const std::size_t k : {0U, 1U, 2U}) {
    CHECK(layout.points[k].beyond);
    CHECK(layout.points[k].way.x == 0.0);
    CHECK(layout.points[k].way.y == (k == 2 ? 1.0 : -1.0));
    const double rim = k == 2 ? layout.map.bottom() : layout.map.top;
    CHECK(std::abs(layout.points[k].at.y - rim) == near(17.0));
    CHECK(layout.points[k].in_strip == (k == 1));
  }
  CHECK(caption(map).find("Arrows point to cases beyond the rim.") != std::string::npos);
}

TEST_CASE("names keep clear of one another, of rings and of the names of the regions") {
  RegimeMap spread{{at("case A", -INFINITY, 7), at("case B", -INFINITY, 1.1),
                    at("case C", -INFINITY, 0.3), at("case D", -16, 8), at("case E", -15, 0.4),
                    at("case F", 11, 9), at("case G", 9, 0.3), at("case H", -4, 2)}};
  RegimeMap tight, corners,
      crowd{{at("case A", -7, 2), at("case B", -5.8, 2.1), at("case C", -5.8, 2.5),
             at("case D", -6.6, 1.8), at("case E", 14.3, 2.1), at("case F", 12.5, 2)}};
  for (const double K_m : {7.5, 5.0, 3.0, 2.0, 1.5, 1.0, 0.5, 0.2})
    tight.points.push_back(at("case at K_{m} = " + drawing::number(K_m), -INFINITY, K_m));
  for (const double log_time : {-19.0, 14.0})
    for (const double K_m : {0.12, 25.0}) corners.points.push_back(at("case X", log_time, K_m));
  for (const Medium medium : {Medium::file, Medium::page, Medium::phone}) {
    check_apart(tight, medium);
    if (medium == Medium::phone) continue;  // eight names and four regions fill it
    check_apart(spread, medium);
    check_apart(corners, medium);
    check_apart(crowd, medium);
  }
}
