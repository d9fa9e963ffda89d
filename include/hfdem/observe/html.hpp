/// @file
/// Words and numbers as HTML. Words may hold groups like `K_{IC}` and `10^{-6}`.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include <hfdem/observe/svg.hpp>

namespace hfdem::observe {
namespace drawing {

inline std::string escaped(std::string_view words) {
  std::string out;
  for (const char c : words) out += escaped(c);
  return out;
}

/// `S_{min}`, `10^{-6}` and ends of lines as HTML.
inline std::string html_words(std::string_view words) {
  std::string out, closing;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const char c = words[i];
    if (closing.empty() && (c == '_' || c == '^') && words.substr(i + 1).starts_with('{')) {
      const std::string tag = c == '_' ? "sub>" : "sup>";
      out += "<" + tag;
      closing = "</" + tag;
      ++i;  // past the brace
    } else if (c == '}' && !closing.empty()) {
      out += closing;
      closing.clear();
    } else if (c == '\n') {
      out += "<br>";
    } else {
      out += escaped(c);
    }
  }
  return out + closing;
}

}  // namespace drawing

/// A number as a reader expects it: `fixed(-0.0316, 3, "m")` is "−0.032 m"; no number is a dash.
inline std::string fixed(double value, int decimals, std::string_view unit = "") {
  if (!std::isfinite(value)) return "\u2013";
  std::array<char, 400> digits{};  // the largest double has 309 digits before the point
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), std::abs(value),
                                 std::chars_format::fixed, decimals)
                       .ptr;
  std::string words(digits.data(), end);
  if (value < 0 && words.find_first_not_of("0.") != std::string::npos) words.insert(0, "\u2212");
  return unit.empty() ? words : words + "\u00a0" + std::string(unit);
}

}  // namespace hfdem::observe
