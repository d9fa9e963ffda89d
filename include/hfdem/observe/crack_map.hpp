/// \file
/// Deformed specimens side by side with the bonds that broke in them, coloured by mode.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include <hfdem/measure/rock_test.hpp>
#include <hfdem/observe/specimen_picture.hpp>

namespace hfdem::observe {

/// One specimen, by its own name.
struct BrokenSpecimen {
  std::string name{};             ///< below it
  const measure::RockTest* test;  ///< whose end is shown
};

/// Specimens in the order in which they are shown.
struct CrackMap {
  std::vector<BrokenSpecimen> specimens{};  ///< must outlive the map
  double exaggeration = 10.0;               ///< of displacements
  std::string title{};                      ///< above the picture
  std::string caption{};                    ///< what to see
  std::string conditions{};                 ///< with which parameters
};

/// The caption of the picture, with what is exaggerated.
inline std::string caption(const CrackMap& map) {
  return map.caption + " Displacements are drawn " + drawing::number(map.exaggeration) +
         " times as large as they are.";
}

namespace drawing {

/// Where a disc is drawn, m.
inline Vec2 drawn_centre(const measure::RockTest& test, Index disc, double exaggeration) {
  return test.specimen.centre[disc] + exaggeration * test.displacement[disc];
}

/// Discs in stone; facets, as long as their bonds were wide, black if torn and vermillion if
/// sheared.
inline std::string broken_specimen(const measure::RockTest& test, double exaggeration,
                                   const Panel& panel) {
  Strokes discs, torn, sheared;
  const auto pixel = [&panel](Vec2 at) { return panel.pixel(at.x, at.y); };
  for (Index i = 0; i < test.specimen.size(); ++i)
    discs.add_disc(pixel(drawn_centre(test, i, exaggeration)),
                   test.specimen.radius[i] * panel.scale);
  for (const auto& [strain, mode, contact] : test.breaks) {
    const auto& [bodies, frame] = contact;
    const Vec2 middle = 0.5 * (drawn_centre(test, bodies.first, exaggeration) +
                               drawn_centre(test, bodies.second, exaggeration));
    const double half =
        std::min(test.specimen.radius[bodies.first], test.specimen.radius[bodies.second]);
    const Vec2 along = half * left_of(Vec2{frame.normal_x, frame.normal_y});
    (mode == Mode::tension ? torn : sheared)
        .add(pixel(middle - along), pixel(middle + along), panel.thinnest);
  }
  return discs.elements(stone) + torn.elements(okabe_ito::black) +
         sheared.elements(okabe_ito::vermillion);
}

}  // namespace drawing

/// The picture as SVG; in a file it is at most 900 pixels wide.
inline std::string svg(const CrackMap& map, Medium medium = Medium::file) {
  using namespace drawing;
  const bool phone = medium == Medium::phone;
  const double width = phone ? 380.0 : 880.0, between = 24.0;
  const std::size_t in_a_row = phone ? 2 : 3;

  constexpr double room = 1.16;  // of a frame over its specimen, which bulges
  double widest = 0.0;
  for (const auto& s : map.specimens) widest = std::max(widest, s.test->specimen.width);
  const double column = (width + between) / static_cast<double>(in_a_row);
  const double scale = (column - between) / (room * widest);

  std::string body;
  double top = 0.0, bottom = 0.0;
  Panel panel{.scale = scale, .thinnest = phone ? 1.2 : 1.6};
  for (std::size_t k = 0; k < map.specimens.size(); ++k) {
    const auto& [name, test] = map.specimens[k];
    const auto& [w, h] = std::tie(test->specimen.width, test->specimen.height);
    if (k % in_a_row == 0) top = bottom;
    panel.box = {.left = column * static_cast<double>(k % in_a_row),
                 .top = top,
                 .width = room * w * scale,
                 .height = (h + (room - 1.0) * w) * scale};
    panel.from_left = panel.from_bottom = (1.0 - room) / 2.0 * w;
    const auto words = wrap(name, column - between);
    const TextStyle style{};
    body += rock(window(panel.box, rectangle(panel.box, fill(pore)) +
                                       broken_specimen(*test, map.exaggeration, panel))) +
            text({panel.box.left, panel.box.bottom() + 20.0}, words, style);
    bottom = std::max(
        bottom, panel.box.bottom() + 34.0 + style.leading() * static_cast<double>(words.size()));
  }
  const Pixel key{0.0, bottom + 12.0};
  const auto entry = [&](double left, Colour colour, std::string_view words) {
    return line({{left, key.y - 4.0}, {left + 18.0, key.y - 4.0}}, stroke(colour, 3.0)) +
           text({left + 26.0, key.y}, words);
  };
  body += entry(0.0, okabe_ito::black, "bond broken in tension") +
          entry(phone ? 190.0 : 240.0, okabe_ito::vermillion, "bond broken in shear");
  return sheet(map.title, caption(map), map.conditions, width, key.y + 6.0, body, medium);
}

}  // namespace hfdem::observe
