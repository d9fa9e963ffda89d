/// \file
/// The page of a map of a field: its colours over the specimen, the injection, a length, a colour
/// bar.
#pragma once

#include <string>
#include <string_view>

#include <hfdem/observe/colour_bar.hpp>
#include <hfdem/observe/specimen_picture.hpp>
#include <hfdem/observe/svg.hpp>

namespace hfdem::observe::drawing {

/// The whole picture as SVG.
/// @tparam Map with an injection, a title, conditions and a caption
/// @param map what is drawn
/// @param panel where its field lies
/// @param scale of its values
/// @param unit above the colour bar
/// @param field its elements
/// @param medium for which it is
template <class Map>
std::string field_sheet(const Map& map, const Panel& panel, const ColourScale& scale,
                        std::string_view unit, const std::string& field, Medium medium) {
  const Box& box = panel.box;
  const std::string body =
      rock(window(box, field + injection_mark(panel.pixel(map.injection.x, map.injection.y)))) +
      rectangle(box, stroke(grey, 1.0)) + panel.scale_bar(18.0) +
      colour_bar({box.right() + 24.0, 40.0, 16.0, box.height - 60.0}, scale, unit);
  return sheet(map.title, caption(map), map.conditions, box.right() + 90.0, box.bottom() + 26.0,
               body, medium);
}

}  // namespace hfdem::observe::drawing
