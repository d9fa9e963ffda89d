#include <toml++/toml.h>

#include "support/settings.hpp"
#include "support/toml_file.hpp"

namespace hfdem::support {
namespace {

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
  } else if (const auto* pair = node.as_array(); pair && pair->size() == 2) {
    const auto x = (*pair)[0].value<double>(), y = (*pair)[1].value<double>();
    if (!x || !y) detail::wrong_type(s, "two numbers, [x, y]");
    s.value = Vec2{*x, *y};
  } else {
    detail::wrong_type(s, "a number, true or false, a word in quotes, or [x, y]");
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
