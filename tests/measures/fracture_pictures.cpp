// What the pictures of a crack draw, element by element.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <hfdem/observe/fracture_map.hpp>
#include <hfdem/observe/stress_map.hpp>

#include <doctest/doctest.h>

#include "measures/made_up_crack.hpp"
#include "near.hpp"
#include "schemes/small_array.hpp"

namespace observe = hfdem::observe;
namespace drawing = hfdem::observe::drawing;
using hfdem::Mode;
using test::near;

namespace {

/// A crack of 5 microcracks of 40 mm upwards and 2 of 50 mm downwards, one of them preset, with a
/// branch of 2 and 3 that are not connected.
observe::FractureMap branched() {
  test::MadeUpCrack made({0.5, 0.4});
  made.grow({{0, 0.04}, {0, 0.04}, {0, 0.04}, {0, 0.04}, {0, 0.04}});
  made.grow({{0, -0.05}, {0, -0.05}});
  made.grow(2, {{0.03, 0}, {0.03, 0}});
  made.microcracks[0].mode.reset();
  made.microcracks[1].mode = Mode::shear;
  for (int k = 0; k < 3; ++k) {
    made.grow(made.domain({0.45, 0.35 + 0.1 * k}), {{0, 0.01}});
    made.microcracks.back().connected = false;
  }
  for (std::size_t m = 0; m < made.microcracks.size(); ++m) {
    made.microcracks[m].aperture = 1e-5 * static_cast<double>(m);
    made.microcracks[m].pressure = 12.5e6;
  }
  return {.microcracks = made.microcracks,
          .crack = made.measured(),
          .origin = made.origin,
          .title = "A crack",
          .caption = "See."};
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

/// Pieces of line in the groups of a colour, in both panels; the legend has none of these groups.
std::size_t strokes(const std::string& svg, observe::Colour colour) {
  const std::string group = "<g stroke=\"" + drawing::hex(colour) + "\"";
  std::size_t count = 0;
  for (std::size_t at = svg.find(group); at != std::string::npos; at = svg.find(group, at + 1)) {
    const std::string drawn = svg.substr(at, svg.find("</g>", at) - at);
    for (std::size_t d = drawn.find(" d=\""); d != std::string::npos;
         d = drawn.find(" d=\"", d + 1))
      count += occurrences(drawn.substr(d + 4, drawn.find('"', d + 4) - d - 4), "m");
  }
  return count;
}

double brightness(observe::Colour c) { return 0.3 * c.red + 0.59 * c.green + 0.11 * c.blue; }

}  // namespace

TEST_CASE("the map draws each kind of microcrack in its colour, close up and in the whole") {
  const std::string svg = observe::svg(branched());
  CHECK(strokes(svg, observe::okabe_ito::black) == 2 * 7);
  CHECK(strokes(svg, observe::okabe_ito::blue) == 2 * 2);
  CHECK(strokes(svg, drawing::crack_red) == 2 * 3);
  CHECK(strokes(svg, observe::okabe_ito::orange) == 2 * 1);
  for (const char* word : {"path from tip to tip", "branches", "unconnected microcracks",
                           "preset crack", "line between the tips", "injection", "20 mm"})
    CHECK(occurrences(svg, word) >= 1);
}

TEST_CASE("with natural fractures the map has the colours of the paper's Figs. 14 and 15") {
  auto map = branched();
  map.natural = {{{0.2, 0.1}, {0.4, 0.2}}, {{0.6, 0.8}, {0.7, 0.9}}};
  for (const std::size_t m : {2, 7, 9, 10}) map.microcracks[m].in_joint = true;
  const std::string svg = observe::svg(map);
  CHECK(strokes(svg, observe::okabe_ito::green) == 2 * 2);
  CHECK(strokes(svg, observe::okabe_ito::black) == 2 * (6 + 1));  // path and branch in rock
  CHECK(strokes(svg, observe::okabe_ito::blue) == 2 * 2);
  CHECK(strokes(svg, drawing::crack_red) == 2 * 2);
  CHECK(strokes(svg, observe::okabe_ito::purple) == 2 * 1);
  for (const char* word : {"natural fractures", "joint microcracks, connected",
                           "joint microcracks, unconnected", "unconnected microcracks"})
    CHECK(occurrences(svg, word) >= 1);
  CHECK(observe::caption(map).find(
            " In the 2 natural fractures: 4 of the microcracks, 2 of them connected.") !=
        std::string::npos);
  // All of the natural fractures are in the close view, 6 % of 0.8 m around them.
  const drawing::FractureLayout layout(map, observe::Medium::file);
  CHECK(layout.close.from_bottom == near(0.1 - 0.048));
}

TEST_CASE("the map is zoomed to the crack, and its dashed line runs from tip to tip") {
  const auto map = branched();
  const drawing::FractureLayout layout(map, observe::Medium::file);
  const auto& close = layout.close;
  // 300 mm long and 60 mm wide: 6 % of air around it, and half as wide as long.
  CHECK(close.box.height / close.scale == near(0.336));
  CHECK(close.box.width / close.scale == near(0.186));
  CHECK(close.from_bottom == near(0.3 - 0.018));
  CHECK(close.from_left == near(0.53 - 0.093));
  const auto tip = close.pixel(0.5, 0.6);
  CHECK(tip.y == near(0.018 * close.scale));
  // The line starts at the lower tip and is as long as the tips are apart.
  const auto low = close.pixel(0.5, 0.3);
  const std::string start = "d=\"m" + drawing::number(low.x) + " " + drawing::number(low.y);
  const std::string line = drawing::FractureDrawing(map, close).tip_line();
  CHECK(line.find(start) != std::string::npos);
  CHECK(line.find("-" + drawing::number(0.3 * close.scale) + "\"") != std::string::npos);
  CHECK(observe::svg(map).find(line) != std::string::npos);
}

TEST_CASE("the caption tells what was measured") {
  const std::string words = observe::caption(branched());
  CHECK(words ==
        "See. The tips are 0.3 m apart; the path is 0.3 m long, and 9 microcracks (7 in tension, 1 "
        "in shear, 1 preset) connected to the injection make 0.36 m: a tortuosity of 1.2, or 1.15 "
        "as the mean of both wings. Branches: 1; asymmetry: 0.33. Not connected: 3 microcracks (3 "
        "in tension, 0 in shear).");
}

TEST_CASE("values of the connected microcracks are shown by colours from zero upwards") {
  auto map = branched();
  map.values = observe::apertures(map.microcracks);
  CHECK(map.values->value[4] == near(40));
  const auto scale = drawing::colour_scale(map);
  CHECK(scale.range.low == 0);
  CHECK(scale.range.high == 100);  // 80 um at most and some air; the unconnected have 110
  const std::string svg = observe::svg(map);
  for (std::size_t m = 0; m < 9; ++m)
    CHECK(strokes(svg, scale.colour(scale.band(10 * static_cast<double>(m)))) == 2);
  CHECK(strokes(svg, drawing::crack_red) == 0);
  CHECK(svg.find("aperture (\u00b5m)") != std::string::npos);

  map.values = observe::net_pressures(map.microcracks, 10e6);
  CHECK(map.values->value[3] == near(2.5));
  CHECK(strokes(observe::svg(map), drawing::colour_scale(map).colour(26)) == 2 * 9);  // 2.5 of 3
}

TEST_CASE("a picture of the paper's number of grains stays below 2 MB") {
  const auto rock = hfdem::square_array(133, 132, 5e-3);
  auto map = branched();
  map.grains = &rock;
  map.width = rock.width;
  map.height = rock.height;
  map.microcracks[4].facet.to = {1.3, 1.3};
  map.microcracks[6].facet.to = {0, 0};
  const std::string svg = observe::svg(map);
  CHECK(strokes(svg, drawing::stone) > 17000);
  CHECK(svg.size() < 2'000'000);
}

TEST_CASE("viridis grows evenly brighter from end to end") {
  CHECK(drawing::hex(observe::viridis(0)) == "#440154");
  CHECK(drawing::hex(observe::viridis(1)) == "#fde725");
  CHECK(drawing::hex(observe::viridis(0.5)) == "#21918c");
  CHECK(drawing::hex(observe::viridis(-3)) == "#440154");
  CHECK(drawing::hex(observe::viridis(7)) == "#fde725");
  const double whole = brightness(observe::viridis(1)) - brightness(observe::viridis(0));
  for (int k = 0; k < 20; ++k) {
    const double step =
        brightness(observe::viridis((k + 1) / 20.0)) - brightness(observe::viridis(k / 20.0));
    CHECK(step > 0.6 * whole / 20);
    CHECK(step < 1.4 * whole / 20);
  }
}

namespace {

/// A field whose minimum principal stress is 2 MPa at x = 0 and rises by 1 MPa per 0.1 m.
observe::StressMap rising(hfdem::Index columns, hfdem::Index rows) {
  observe::StressMap map{.field = {columns, rows, {0.1, 0.1}}};
  for (hfdem::Index row = 0; row < rows; ++row)
    for (hfdem::Index column = 0; column < columns; ++column)
      map.field.stress.push_back({30e6, 2e6 + 1e7 * map.field.centre(column, row).x});
  return map;
}

}  // namespace

TEST_CASE("the stress map interpolates between circles and says the least compression") {
  const auto map = rising(10, 6);
  const drawing::MinimumStress stress(map.field);
  CHECK(stress.at({0.05, 0.05}) == near(2.5));
  CHECK(stress.at({0.31, 0.07}) == near(5.1));
  CHECK(stress.at({0.44, 0.59}) == near(6.4));
  CHECK(stress.at({0.999, 0.3}) == near(11.5));  // as the last centre
}

TEST_CASE("the stress map's bands stand side by side where the stress rises to the right") {
  auto map = rising(10, 10);
  map.range = observe::Range{2, 12};
  const observe::ColourScale scale{*map.range, 20};
  const std::string svg = observe::svg(map);
  for (int band = 2; band < 19; ++band) {  // half a cell at the rim has no gradient
    const std::string colour = drawing::hex(scale.colour(band));
    const std::size_t paint = svg.find("stroke=\"" + colour + "\"");
    REQUIRE(paint != std::string::npos);
    const std::size_t begin = svg.rfind("d=\"m", paint);
    // 540 pixels for 20 bands of half a MPa, in pixels of 3.
    CHECK(std::abs(std::stod(svg.substr(begin + 4)) - 27 * band) <= 3.0);
    CHECK(occurrences(svg.substr(begin, paint - begin), "m") == 180);  // one run in every row
  }
  CHECK(svg.size() < 2'000'000);
}
