/// @file
/// Text files of numbers, line by line: what the readers of specimens and of fractures share.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <istream>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/fields.hpp>

namespace hfdem::detail {

/// The text between quotation marks.
inline std::string in_quotes(std::string_view text) {
  return std::string("\"").append(text) + "\"";
}

/// The lines of a file that count, split into words; refuses what is wrong with them.
class DataLines {
 public:
  /// What stands between two words.
  enum class Between { blanks, commas };

  /// @param in the file
  /// @param before in messages, what stands before the number of a line
  /// @param after and what after it
  /// @param between what stands between two words; a comma may have nothing beside it
  DataLines(std::istream& in, std::string before, std::string after,
            Between between = Between::blanks)
      : in_(in), before_(std::move(before)), after_(std::move(after)), between_(between) {}

  /// Goes to the next line that counts.
  /// @returns whether there is one
  bool next() {
    while (std::getline(in_, line_)) {
      ++number_;
      split(std::string_view(line_).substr(0, line_.find('#')));
      if (!words_.empty()) return true;
    }
    words_.clear();
    return false;
  }

  /// Goes to the next line, which must have so many words.
  void expect(std::size_t words, const std::string& what) {
    if (!next()) wrong("ends where " + what + " should follow");
    expect_words(words, what);
  }

  /// This line must have so many words.
  void expect_words(std::size_t words, const std::string& what) const {
    if (words_.size() != words)
      wrong(in_quotes(trimmed(line_)) + " has " + std::to_string(words_.size()) +
            (between_ == Between::commas ? " column" : " word") + (words_.size() == 1 ? "" : "s") +
            " where " + what + " should stand");
  }

  /// Goes to the next line, which must be a name and a value of the given type.
  template <class T>
  T named(std::string_view name, const Range& range, std::string_view unit) {
    expect(2, in_quotes(name) + " and its value");
    if (words_[0] != name)
      wrong(in_quotes(words_[0]) + " stands where " + in_quotes(name) + " should");
    return value<T>(1, name, range, unit);
  }

  /// The word at a place of this line as a number within a range.
  template <class T>
  T value(std::size_t place, std::string_view what, const Range& range,
          std::string_view unit) const {
    const std::string_view word = words_[place];
    T result{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), result);
    const bool read = error == std::errc{} && end == word.data() + word.size();
    const auto number = static_cast<double>(result);
    if (!read || !std::isfinite(number) || !range.contains(number)) {
      const bool bounded = std::isfinite(range.low) || std::isfinite(range.high);
      wrong(std::string(what) + " = " + (word.empty() ? "nothing" : std::string(word)) +
            " is not allowed: it must be " +
            (std::is_integral_v<T> ? "a whole number, "
             : bounded             ? "a number, "
                                   : "") +
            to_text(range, unit));
    }
    return result;
  }

  /// @throws InvalidParameter with the place of this line
  [[noreturn]] void wrong(const std::string& why) const {
    throw InvalidParameter(place() + ": " + why);
  }

  /// Of this line, as messages name it.
  std::string place() const { return before_ + std::to_string(number_) + after_; }

  const std::vector<std::string_view>& words() const { return words_; }  ///< of this line

 private:
  static std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
    return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
  }

  void split(std::string_view text) {
    const std::string_view ends = between_ == Between::commas ? "," : " \t\r";
    words_.clear();
    for (text = trimmed(text); !text.empty();) {
      const std::size_t end = text.find_first_of(ends);
      words_.push_back(trimmed(text.substr(0, end)));
      if (end == text.npos) return;
      text = trimmed(text.substr(end + 1));
    }
    if (!words_.empty()) words_.push_back(text);  // nothing stands behind a last comma
  }

  std::istream& in_;
  std::string before_, after_, line_{};
  Between between_;
  std::vector<std::string_view> words_{};
  std::size_t number_ = 0;
};

}  // namespace hfdem::detail
