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
#include <cmath>
#include <cstdint>
#include <fstream>
#include <istream>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/fields.hpp>
#include <hfdem/base/whole_file.hpp>
#include <hfdem/setup/data_lines.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

namespace detail {

inline void read_discs(DataLines& lines, Specimen& s) {
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

inline void read_pairs(DataLines& lines, Specimen& s) {
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
  detail::DataLines lines(in, "specimen file " + name + ", line ", "");
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
