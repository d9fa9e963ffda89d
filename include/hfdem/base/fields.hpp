/// @file
/// A parameter is described once: name, unit, allowed range and meaning. Validation, printing and
/// reading from a file all follow from that one table.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/vec2.hpp>

namespace hfdem {

/// The allowed range of a number; an open end excludes the bound itself.
struct Range {
  double low = -std::numeric_limits<double>::infinity();  ///< the least allowed value
  double high = std::numeric_limits<double>::infinity();  ///< the greatest allowed value
  bool open_low = false;                                  ///< `low` itself is not allowed
  bool open_high = false;                                 ///< `high` itself is not allowed

  /// False for what is not a number.
  constexpr bool contains(double v) const {
    return (open_low ? v > low : v >= low) && (open_high ? v < high : v <= high);
  }
};
inline constexpr Range any_number{};                          ///< every finite number
inline constexpr Range positive{.low = 0, .open_low = true};  ///< greater than zero
inline constexpr Range non_negative{.low = 0};                ///< zero or greater

/// One parameter of an aggregate `Params`.
template <class Params, class T>
struct Field {
  std::string_view name;     ///< its key in a parameter file
  T Params::*member;         ///< where its value is kept
  std::string_view unit;     ///< SI or deg; empty for a pure number
  Range range;               ///< of a number, or of each component of a vector, also in a list
  std::string_view meaning;  ///< for people: a phrase without a full stop
};
/// Clang before 17 deduces no template arguments of aggregates without being told how.
template <class Params, class T>
Field(std::string_view, T Params::*, std::string_view, Range, std::string_view) -> Field<Params, T>;

/// A named group of parameters: a section of the parameter file.
template <class Params, class T>
struct Section {
  std::string_view name;  ///< its heading in a parameter file
  T Params::*member;      ///< where its parameters are kept
};
/// Told to clang, as for `Field`.
template <class Params, class T>
Section(std::string_view, T Params::*) -> Section<Params, T>;

/// Specialise for an enumeration to give its values' names, in order.
template <class Enum>
inline constexpr std::array<std::string_view, 0> names_of{};

/// Parameters that describe themselves by a table of fields.
template <class P>
concept Described = requires {
  P::fields();
};

/// Whether a parameter of this type may be left out.
template <class>
inline constexpr bool is_optional = false;
/// True for `std::optional`.
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// Whether a parameter of this type is a list: of vectors, or of what describes itself.
template <class>
inline constexpr bool is_list = false;
/// True for `std::vector`.
template <class T>
inline constexpr bool is_list<std::vector<T>> = true;

/// Calls `f(field)` for every field of a table.
template <Described P, class F>
void for_each_field(F&& f) {
  std::apply([&](const auto&... field) { (f(field), ...); }, P::fields());
}

/// Calls `f(name, section)` for every section of a tree of parameters.
template <class Tree, class F>
void for_each_section(Tree& tree, F&& f) {
  std::apply([&](const auto&... s) { (f(s.name, tree.*(s.member)), ...); }, Tree::sections());
}

/// The shortest decimal text that reads back as the same number.
inline std::string to_text(double v) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), v).ptr;
  return {buffer.data(), end};
}

/// A vector as a parameter file has it: "[0.5, 0.25]".
inline std::string to_text(Vec2 v) {
  return std::string("[").append(to_text(v.x)).append(", ").append(to_text(v.y)).append("]");
}

/// Described values as a list has them: "[0.3, 1e-04]".
template <Described P>
std::string to_text(const P& params) {
  std::string text;
  for_each_field<P>(
      [&](const auto& f) { text += (text.empty() ? "[" : ", ") + to_text(params.*(f.member)); });
  return text + "]";
}

/// A list as a parameter file has it: "[[0.3, 1e-04], [0.6, 0]]".
template <class T>
std::string to_text(const std::vector<T>& list) {
  std::string text = "[";
  for (const T& entry : list) text += (text.size() == 1 ? "" : ", ") + to_text(entry);
  return text + "]";
}

/// An entry of a list in a message, counted from one: "schedule, entry 2".
inline std::string entry_of(std::string_view list, std::size_t k) {
  return std::string(list) + ", entry " + std::to_string(k + 1);
}

/// A measured number in a message: six digits.
inline std::string in_words(double v) {
  std::array<char, 32> buffer{};
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), v, std::chars_format::general, 6)
          .ptr;
  return {buffer.data(), end};
}

/// The range as a message says it: "greater than 0 Pa and at most 1 Pa".
inline std::string to_text(const Range& range, std::string_view unit) {
  const auto bound = [&](double v) {
    return unit.empty() ? to_text(v) : to_text(v) + " " + std::string(unit);
  };
  const bool low = std::isfinite(range.low), high = std::isfinite(range.high);
  const std::string above = (range.open_low ? "greater than " : "at least ") + bound(range.low);
  const std::string below = (range.open_high ? "less than " : "at most ") + bound(range.high);
  if (low && high) return above + " and " + below;
  return low ? above : high ? below : "any finite number";
}

/// Refuses an input.
/// @throws InvalidParameter "section.field = value is not allowed: it must be allowed"
[[noreturn]] inline void refuse(std::string_view section, std::string_view field,
                                std::string_view value, std::string_view allowed) {
  throw InvalidParameter(std::string(section) + "." + std::string(field) + " = " +
                         std::string(value) + " is not allowed: it must be " +
                         std::string(allowed));
}

namespace detail {

template <class T>
void check_range(std::string_view section, std::string_view name, std::string_view unit,
                 const Range& range, const T& value) {
  if constexpr (is_optional<T>) {
    if (value) check_range(section, name, unit, range, *value);
  } else if constexpr (is_list<T>) {
    for (std::size_t k = 0; k < value.size(); ++k)
      check_range(section, entry_of(name, k), unit, range, value[k]);
  } else if constexpr (Described<T>) {
    for_each_field<T>([&](const auto& f) {
      check_range(section, std::string(name) + ", " + std::string(f.name), f.unit, f.range,
                  value.*(f.member));
    });
  } else if constexpr (std::is_same_v<T, Vec2>) {
    check_range(section, name, unit, range, value.x);
    check_range(section, name, unit, range, value.y);
  } else if constexpr (std::is_enum_v<T>) {
    const auto place = static_cast<std::size_t>(value);
    if (place >= names_of<T>.size())
      refuse(section, name, std::to_string(place), "one of its named values");
  } else if constexpr (!std::is_same_v<T, bool>) {
    const double number = value;
    if (!std::isfinite(number) || !range.contains(number)) {
      const std::string shown =
          unit.empty() ? to_text(number) : to_text(number) + " " + std::string(unit);
      refuse(section, name, shown, to_text(range, unit));
    }
  }
}

}  // namespace detail

/// Checks every field of one section against its range.
/// @throws InvalidParameter naming the field, its value and the allowed range.
template <Described P>
void validate(const P& params, std::string_view section) {
  for_each_field<P>([&](const auto& f) {
    detail::check_range(section, f.name, f.unit, f.range, params.*(f.member));
  });
}

}  // namespace hfdem
