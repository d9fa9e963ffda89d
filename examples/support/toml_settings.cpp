#include <optional>
#include <vector>

#include <toml++/toml.h>

#include "support/settings.hpp"
#include "support/toml_file.hpp"

namespace hfdem::support {
namespace {

std::optional<Vec2> pair_in(const toml::node& node) {
  const toml::array* list = node.as_array();
  if (list == nullptr || list->size() != 2) return {};
  const auto x = (*list)[0].value<double>(), y = (*list)[1].value<double>();
  return x && y ? std::optional(Vec2{*x, *y}) : std::nullopt;
}

std::optional<std::vector<Vec2>> pairs_in(const toml::node& node) {
  const toml::array* list = node.as_array();
  if (list == nullptr) return {};
  std::vector<Vec2> pairs;
  for (const toml::node& entry : *list) {
    const auto pair = pair_in(entry);
    if (!pair) return {};
    pairs.push_back(*pair);
  }
  return pairs;
}

Setting setting(std::string section, std::string key, const toml::node& node, std::string where) {
  Setting s{std::move(section), std::move(key), false, written(node), std::move(where)};
  if (const auto* flag = node.as_boolean()) {
    s.value = flag->get();
  } else if (const auto* whole = node.as_integer()) {
    s.value = whole->get();
  } else if (const auto* real = node.as_floating_point()) {
    s.value = real->get();
  } else if (const auto* text = node.as_string()) {
    s.value = text->get();
  } else if (const auto pair = pair_in(node)) {
    s.value = *pair;
  } else if (const auto pairs = pairs_in(node)) {
    s.value = *pairs;
  } else {
    detail::wrong_type(s,
                       "a number, true or false, a word in quotes, [x, y], or a list of these "
                       "pairs, [[x, y], ...]");
  }
  return s;
}

}  // namespace

std::vector<Setting> read_toml(const std::string& path) {
  const toml::table file = parse_toml(path);
  std::vector<Setting> settings;
  for (const auto& [section, content] : file) {
    const std::string where = place_in(path, content.source());
    const toml::table* keys = content.as_table();
    if (keys == nullptr)
      throw InvalidParameter(where + ": \"" + std::string(section.str()) +
                             "\" stands outside of a [section]");
    for (const auto& [key, node] : *keys)
      settings.push_back(setting(std::string(section.str()), std::string(key.str()), node,
                                 place_in(path, node.source())));
  }
  return settings;
}

Setting read_assignment(const std::string& text) {
  const auto equals = text.find('='), dot = text.find('.');
  if (equals == std::string::npos || dot == std::string::npos || dot > equals || dot == 0 ||
      dot + 1 == equals || equals + 1 == text.size())
    throw InvalidParameter("--set " + text + ": write it as section.key=value");
  const std::string value = text.substr(equals + 1), where = "--set " + text;
  const std::string section = text.substr(0, dot), key = text.substr(dot + 1, equals - dot - 1);
  toml::table parsed;
  try {
    parsed = toml::parse("value = " + value);
  } catch (const toml::parse_error&) {
    // A bare word needs no quotes on a command line.
    return {section, key, value, value, where};
  }
  return setting(section, key, *parsed.get("value"), where);
}

}  // namespace hfdem::support
