/// @file
/// What the compiler knows of an aggregate, to compare with what its table of fields says.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <utility>

/// Stands for a value of any type.
struct Anything {
  template <class T>
  operator T() const;
};

/// How many members an aggregate has: how many values its braces take.
template <class P, std::size_t taken = 0>
consteval std::size_t member_count() {
  constexpr bool takes_one_more = []<std::size_t... i>(std::index_sequence<i...>) {
    return requires { P{(static_cast<void>(i), Anything{})...}; };
  }
  (std::make_index_sequence<taken + 1>{});
  if constexpr (takes_one_more)
    return member_count<P, taken + 1>();
  else
    return taken;
}

/// The identifier of a member or an enumerator, as the compiler writes it.
template <auto entity>
consteval std::string_view identifier() {
  std::string_view text = __PRETTY_FUNCTION__;
  text.remove_prefix(text.find("entity = "));
  text = text.substr(0, text.find_first_of(";]"));
  return text.substr(text.rfind(':') + 1);
}

/// The names in a table of fields or sections, and the identifiers of the members that it points
/// to.
template <auto table>
struct Names {
  static constexpr std::size_t size = std::tuple_size_v<decltype(table())>;
  std::array<std::string_view, size> given{}, members{};

  consteval Names() {
    [this]<std::size_t... i>(std::index_sequence<i...>) {
      ((given[i] = std::get<i>(table()).name), ...);
      ((members[i] = identifier<std::get<i>(table()).member>()), ...);
    }
    (std::make_index_sequence<size>{});
  }
};
