/// @file
/// Parameters from text and back: a parameter file is a list of settings, applied one by one to the
/// sections that describe themselves (hfdem/base/fields.hpp).
#pragma once

#include <cmath>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <hfdem/base/fields.hpp>

namespace hfdem::support {

/// `section.key = value`, and where it was written.
struct Setting {
  std::string section, key;
  std::variant<bool, std::int64_t, double, std::string, Vec2, std::vector<Vec2>> value;
  std::string text;   ///< the value as written
  std::string where;  ///< for messages, e.g. "line 12 of run.toml"
};

/// @throws InvalidParameter with the line if the text is not TOML or not made of sections
std::vector<Setting> read_toml(const std::string& path);
/// Reads `section.key=value` from a command line.
/// @throws InvalidParameter if it has another form
Setting read_assignment(const std::string& text);

namespace detail {

[[noreturn]] inline void wrong_type(const Setting& s, std::string_view expected) {
  throw InvalidParameter(s.where + ": " + s.section + "." + s.key + " = " + s.text +
                         " is not allowed: it must be " + std::string(expected));
}

/// What an entry of a list looks like: "[x, y]", or "[time, rate]" by the names of its fields.
template <class T>
std::string written_pair() {
  if constexpr (Described<T>) {
    std::string text;
    for_each_field<T>(
        [&](const auto& field) { text += (text.empty() ? "[" : ", ") + std::string(field.name); });
    return text + "]";
  } else {
    return "[x, y]";
  }
}

template <class T>
void assign(T& target, const Setting& s) {
  if constexpr (is_optional<T>) {
    typename T::value_type value{};
    assign(value, s);
    target = value;
  } else if constexpr (std::is_same_v<T, bool>) {
    if (!std::holds_alternative<bool>(s.value)) wrong_type(s, "true or false");
    target = std::get<bool>(s.value);
  } else if constexpr (std::is_same_v<T, int>) {
    const auto* whole = std::get_if<std::int64_t>(&s.value);
    if (whole == nullptr || std::abs(*whole) > std::numeric_limits<int>::max())
      wrong_type(s, "a whole number of at most 2147483647");
    target = static_cast<int>(*whole);
  } else if constexpr (std::is_same_v<T, double>) {
    if (const auto* whole = std::get_if<std::int64_t>(&s.value))
      target = static_cast<double>(*whole);
    else if (const auto* real = std::get_if<double>(&s.value))
      target = *real;
    else
      wrong_type(s, "a number");
  } else if constexpr (std::is_same_v<T, Vec2>) {
    if (!std::holds_alternative<Vec2>(s.value)) wrong_type(s, "two numbers, [x, y]");
    target = std::get<Vec2>(s.value);
  } else if constexpr (is_list<T>) {
    using Entry = typename T::value_type;
    const auto* pairs = std::get_if<std::vector<Vec2>>(&s.value);
    if (pairs == nullptr) wrong_type(s, "a list of pairs, [" + written_pair<Entry>() + ", ...]");
    target.clear();
    for (const Vec2 pair : *pairs) target.push_back(Entry{pair.x, pair.y});
  } else {
    std::string names;
    for (std::size_t k = 0; k < names_of<T>.size(); ++k) {
      if (const auto* name = std::get_if<std::string>(&s.value); name && *name == names_of<T>[k]) {
        target = static_cast<T>(k);
        return;
      }
      names += (k == 0                        ? ""
                : k + 1 == names_of<T>.size() ? " or "
                                              : ", ") +
               ('"' + std::string(names_of<T>[k])) + '"';
    }
    wrong_type(s, names);
  }
}

template <class T>
std::string toml_value(const T& value) {
  if constexpr (is_optional<T>)
    return toml_value(*value);
  else if constexpr (std::is_same_v<T, bool>)
    return value ? "true" : "false";
  else if constexpr (std::is_same_v<T, int>)
    return std::to_string(value);
  else if constexpr (std::is_same_v<T, double>)
    return to_text(value);
  else if constexpr (std::is_same_v<T, Vec2> || is_list<T>)
    return to_text(value);
  else
    return '"' + std::string(names_of<T>[static_cast<std::size_t>(value)]) + '"';
}

/// Whether a parameter has no value of its own, or an empty list.
template <class T>
bool is_left_out(const T& value) {
  if constexpr (is_optional<T>)
    return !value;
  else if constexpr (is_list<T>)
    return value.empty();
  else
    return false;
}

}  // namespace detail

/// A tree of sections: a program's parameter file. Derive, and list the sections in a static
/// `visit(self, f)` that calls `f(name, section)` for each.
template <class Tree>
struct SectionTree {
  template <class F>
  void for_each_section(F&& f) {
    Tree::visit(static_cast<Tree&>(*this), f);
  }
  template <class F>
  void for_each_section(F&& f) const {
    Tree::visit(static_cast<const Tree&>(*this), f);
  }
  /// Every section.
  void exchange(auto& archive) {
    for_each_section([&](std::string_view, auto& section) { archive(section); });
  }
};

/// Applies one setting to a tree of sections.
/// @throws InvalidParameter if no such section or key exists (naming those that do), or the value
///   has the wrong type
template <class Tree>
void apply(Tree& tree, const Setting& s) {
  bool found_section = false, found_key = false;
  std::string sections, keys;
  tree.for_each_section([&](std::string_view name, auto& section) {
    sections += (sections.empty() ? "" : ", ") + std::string(name);
    if (name != s.section) return;
    found_section = true;
    for_each_field<std::remove_cvref_t<decltype(section)>>([&](const auto& field) {
      keys += (keys.empty() ? "" : ", ") + std::string(field.name);
      if (field.name != s.key) return;
      found_key = true;
      detail::assign(section.*(field.member), s);
    });
  });
  if (!found_section)
    throw InvalidParameter(s.where + ": there is no section \"" + s.section +
                           "\"; the sections are " + sections);
  if (!found_key)
    throw InvalidParameter(s.where + ": there is no key \"" + s.key + "\" in section \"" +
                           s.section + "\"; its keys are " + keys);
}

/// Checks every section. @throws InvalidParameter naming the field, its value and allowed range
template <class Tree>
void validate_all(const Tree& tree) {
  tree.for_each_section([](std::string_view name, const auto& s) { hfdem::validate(s, name); });
}

/// The whole tree as a parameter file; what is not set is left out, and so are empty lists.
template <class Tree>
std::string to_toml(const Tree& tree) {
  std::string text;
  tree.for_each_section([&](std::string_view name, const auto& section) {
    text += (text.empty() ? "[" : "\n[") + std::string(name) + "]\n";
    for_each_field<std::remove_cvref_t<decltype(section)>>([&](const auto& field) {
      const auto& value = section.*(field.member);
      if (detail::is_left_out(value)) return;
      std::string line = std::string(field.name) + " = " + detail::toml_value(value);
      line.resize(std::max<std::size_t>(line.size() + 1, 32), ' ');
      text += line + "# ";
      if (!field.unit.empty()) text += std::string(field.unit) + "; ";
      text += std::string(field.meaning) + "\n";
    });
  });
  return text;
}

}  // namespace hfdem::support
