/// @file
/// Specimens as plain text files.
///
///     hfdem specimen 1              the format's version
///     width 0.3                     of the box, m; its lower left corner is the origin
///     height 0.6                    m
///     density 3169                  of the discs, kg/m3
///     bonding_gap 8e-05             gap up to which discs bond, m
///     discs 2                       then one line for each: x, y and radius, m
///     0.1 0.25 0.004
///     0.1041 0.257 0.00421
///     pairs 1                       then one line for each: two discs, counted from 0, the lower
///     0 1                           first; for the search FixedPairs, else `pairs 0`
///
/// Empty lines, and what follows a `#`, do not count. Numbers are the shortest decimals that read
/// back as the same bits. A disc may overlap the walls, as in a packing, but its centre is inside.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <istream>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/fields.hpp>
#include <hfdem/base/whole_file.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

namespace detail {

/// The text between quotation marks.
inline std::string in_quotes(std::string_view text) {
  return std::string("\"").append(text) + "\"";
}

/// The lines of a specimen file that count, split into words; refuses what is wrong with them.
class SpecimenLines {
 public:
  /// @param name of the file, for messages
  SpecimenLines(std::istream& in, std::string name) : in_(in), name_(std::move(name)) {}

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
    if (words_.size() != words)
      wrong(in_quotes(line_) + " has " + std::to_string(words_.size()) +
            (words_.size() == 1 ? " word" : " words") + " where " + what + " should stand");
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
    if (!read || !std::isfinite(number) || !range.contains(number))
      wrong(std::string(what) + " = " + std::string(word) + " is not allowed: it must be " +
            (std::is_integral_v<T> ? "a whole number, " : "a number, ") + to_text(range, unit));
    return result;
  }

  /// @throws InvalidParameter "specimen file NAME, line N: ..."
  [[noreturn]] void wrong(const std::string& why) const {
    throw InvalidParameter("specimen file " + name_ + ", line " + std::to_string(number_) + ": " +
                           why);
  }

  const std::vector<std::string_view>& words() const { return words_; }  ///< of this line

 private:
  void split(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    words_.clear();
    for (std::size_t begin = text.find_first_not_of(blanks); begin != text.npos;) {
      const std::size_t end = std::min(text.find_first_of(blanks, begin), text.size());
      words_.push_back(text.substr(begin, end - begin));
      begin = text.find_first_not_of(blanks, end);
    }
  }

  std::istream& in_;
  std::string name_, line_{};
  std::vector<std::string_view> words_{};
  std::size_t number_ = 0;
};

inline void read_discs(SpecimenLines& lines, Specimen& s) {
  // Not reserved: the number may be nonsense.
  const auto count = lines.named<std::uint32_t>("discs", Range{1, nothing - 8.0}, "");
  for (Index i = 0; i < count; ++i) {
    const std::string disc =
        std::string("disc ") + std::to_string(i) + " of " + std::to_string(count);
    lines.expect(3, disc + ", \"x y radius\",");
    const double x = lines.value<double>(0, "x", Range{0, s.width}, "m");
    const double y = lines.value<double>(1, "y", Range{0, s.height}, "m");
    s.centre.push_back({x, y});
    s.radius.push_back(
        lines.value<double>(2, "radius", Range{0, std::fmin(s.width, s.height) / 2, true}, "m"));
  }
}

inline void read_pairs(SpecimenLines& lines, Specimen& s) {
  const auto count = lines.named<std::uint32_t>("pairs", Range{0, nothing - 1.0}, "");
  const double last = static_cast<double>(s.size()) - 1;
  for (Index k = 0; k < count; ++k) {
    const std::string pair =
        std::string("pair ") + std::to_string(k) + " of " + std::to_string(count);
    lines.expect(2, pair + ", \"first second\",");
    const auto first = lines.value<Index>(0, "first disc", Range{0, last - 1}, "");
    s.pairs.push_back({first, lines.value<Index>(1, "second disc", Range{first + 1.0, last}, "")});
  }
  std::vector<Pair> sorted = s.pairs;
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  if (twice != sorted.end())
    lines.wrong(std::string("discs ") + std::to_string(twice->first) + " and " +
                std::to_string(twice->second) + " are a pair twice");
}

}  // namespace detail

/// Writes a specimen; `read_specimen` gives it back bit for bit.
inline void write_specimen(std::ostream& out, const Specimen& s) {
  out << "hfdem specimen 1\n"
      << "width " << to_text(s.width) << "  # m\nheight " << to_text(s.height) << "  # m\ndensity "
      << to_text(s.density) << "  # kg/m3\nbonding_gap " << to_text(s.bonding_gap)
      << "  # m\ndiscs " << s.size() << "  # x y radius, m\n";
  for (std::size_t i = 0; i < s.size(); ++i)
    out << to_text(s.centre[i].x) << ' ' << to_text(s.centre[i].y) << ' ' << to_text(s.radius[i])
        << '\n';
  out << "pairs " << s.pairs.size() << "  # two discs, counted from 0\n";
  for (const Pair& p : s.pairs) out << p.first << ' ' << p.second << '\n';
}

/// Reads a specimen.
/// @param in text as described above
/// @param name of the file, for messages
/// @throws InvalidParameter naming the file, the line and what is wrong with it
inline Specimen read_specimen(std::istream& in, const std::string& name) {
  detail::SpecimenLines lines(in, name);
  lines.expect(3, "\"hfdem specimen 1\"");
  if (lines.words()[0] != "hfdem" || lines.words()[1] != "specimen")
    lines.wrong("this is no specimen file: it does not begin with \"hfdem specimen 1\"");
  if (lines.words()[2] != "1")
    lines.wrong(std::string("version ").append(lines.words()[2]) +
                " of the format is not known: only version 1 is");
  Specimen s;
  s.width = lines.named<double>("width", positive, "m");
  s.height = lines.named<double>("height", positive, "m");
  s.density = lines.named<double>("density", positive, "kg/m3");
  s.bonding_gap = lines.named<double>("bonding_gap", non_negative, "m");
  detail::read_discs(lines, s);
  detail::read_pairs(lines, s);
  if (lines.next()) lines.wrong("the file should end before this line");
  return s;
}

/// Writes a specimen to a file; until it is complete, an old one of this name stands.
/// @throws WriteFailed if that does not succeed
inline void save_specimen(const std::string& path, const Specimen& s) {
  std::ostringstream text;
  write_specimen(text, s);
  write_whole_file(path, text.view());
}

/// Reads a specimen from a file.
/// @throws InvalidParameter if the file cannot be read, or naming the line and what is wrong with
/// it
inline Specimen load_specimen(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InvalidParameter("specimen file " + path + " cannot be read");
  return read_specimen(in, path);
}

}  // namespace hfdem
