#include "support/fracture_input.hpp"

#include <cmath>
#include <filesystem>
#include <optional>

#include "support/toml_file.hpp"

namespace hfdem::support {
namespace {

std::optional<double> finite_number(const toml::node& node) {
  const auto number = node.value<double>();
  return number && std::isfinite(*number) ? number : std::nullopt;
}

/// One end of a fracture.
Vec2 read_end(const toml::table& fracture, const std::string& key, const std::string& path) {
  const toml::node* node = fracture.get(key);
  if (node == nullptr)
    throw InvalidParameter(place_in(path, fracture.source()) + ": this fracture has no \"" + key +
                           " = [x, y]\"");
  if (const toml::array* pair = node->as_array(); pair && pair->size() == 2) {
    const auto x = finite_number((*pair)[0]), y = finite_number((*pair)[1]);
    if (x && y) return {*x, *y};
  }
  throw InvalidParameter(place_in(path, node->source()) + ": " + key + " = " + written(*node) +
                         " is not allowed: it must be two finite numbers, [x, y]");
}

/// What is not of the form [[fracture]].
[[noreturn]] void refuse_form(const toml::node& node, const std::string& path) {
  throw InvalidParameter(place_in(path, node.source()) +
                         ": a fracture is written as [[fracture]], with its ends below");
}

NaturalFracture read_fracture(const toml::node& node, const std::string& path) {
  const toml::table* fracture = node.as_table();
  if (fracture == nullptr) refuse_form(node, path);
  for (const auto& [key, value] : *fracture)
    if (key != "from" && key != "to")
      throw InvalidParameter(place_in(path, value.source()) + ": there is no key \"" +
                             std::string(key.str()) + "\" in a fracture; its keys are from, to");
  return {read_end(*fracture, "from", path), read_end(*fracture, "to", path)};
}

NamedFractures read_fracture_toml(const std::string& path) {
  NamedFractures read;
  for (const auto& [key, content] : parse_toml(path)) {
    if (key != "fracture")
      throw InvalidParameter(place_in(path, content.source()) + ": \"" + std::string(key.str()) +
                             "\" is not known: there are only fractures, [[fracture]]");
    if (!content.is_array()) refuse_form(content, path);
    for (const toml::node& node : *content.as_array()) {
      read.fractures.push_back(read_fracture(node, path));
      read.names.push_back(place_in(path, node.source()));
    }
  }
  if (read.fractures.empty())
    throw InvalidParameter(path + " has no fracture: it needs at least one [[fracture]]");
  return read;
}

}  // namespace

NamedFractures read_fractures(const std::string& path) {
  const auto ending = std::filesystem::path(path).extension();
  if (ending == ".csv") return load_fractures(path);
  if (ending == ".toml") return read_fracture_toml(path);
  throw InvalidParameter("fracture file " + path +
                         " is not known by its ending: it must be .csv or .toml");
}

}  // namespace hfdem::support
