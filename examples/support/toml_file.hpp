/// @file
/// What all readers of TOML files share; for their sources only, as toml++ takes long to compile.
#pragma once

#include <sstream>
#include <string>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/fields.hpp>

#include <toml++/toml.h>

namespace hfdem::support {

/// For messages, e.g. "line 12 of run.toml".
inline std::string place_in(const std::string& path, const toml::source_region& source) {
  return "line " + std::to_string(source.begin.line) + " of " + path;
}

/// A value on one line, numbers as short as they may be; for messages.
inline std::string written(const toml::node& node) {
  if (const auto* real = node.as_floating_point()) return to_text(real->get());
  if (const toml::array* list = node.as_array()) {
    std::string text = "[";
    for (const toml::node& element : *list)
      text += (text.size() == 1 ? "" : ", ") + written(element);
    return text + "]";
  }
  std::ostringstream text;
  node.visit([&](const auto& n) { text << n; });
  return text.str();
}

/// @throws InvalidParameter, with the line, if the file is not there or not TOML
inline toml::table parse_toml(const std::string& path) {
  try {
    return toml::parse_file(path);
  } catch (const toml::parse_error& e) {
    const std::string why(e.description());
    if (e.source().begin.line == 0) throw InvalidParameter("cannot read " + path + ": " + why);
    throw InvalidParameter(place_in(path, e.source()) + ": " + why);
  }
}

}  // namespace hfdem::support
