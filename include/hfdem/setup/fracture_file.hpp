/// @file
/// Natural fractures as tables of comma-separated values.
///
///     # what follows a '#' does not count, nor do empty lines
///     x1_m,y1_m,x2_m,y2_m
///     0.1,0.25,0.2,0.4              one fracture: its ends, m
///
/// Numbers are the shortest decimals that read back as the same bits.
#pragma once

#include <algorithm>
#include <array>
#include <fstream>
#include <istream>
#include <ostream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/fields.hpp>
#include <hfdem/base/whole_file.hpp>
#include <hfdem/setup/data_lines.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// Natural fractures, and where each was written: as later checks name it.
struct NamedFractures {
  std::vector<NaturalFracture> fractures{};  ///< in the order of the file
  std::vector<std::string> names{};          ///< of each, e.g. "line 7 of fractures.csv"
};

namespace detail {

inline constexpr std::string_view fracture_header = "x1_m,y1_m,x2_m,y2_m";
inline constexpr std::array<std::string_view, 4> fracture_columns{"x1_m", "y1_m", "x2_m", "y2_m"};

}  // namespace detail

/// Writes a table of fractures; `read_fracture_table` gives them back bit for bit.
/// @param out gets the table
/// @param fractures to write
/// @param comment lines that go before the table; a '#' is put before each
inline void write_fracture_table(std::ostream& out, std::span<const NaturalFracture> fractures,
                                 const std::string& comment = {}) {
  std::istringstream lines(comment);
  for (std::string line; std::getline(lines, line);)
    out << '#' << (line.empty() ? "" : " ") << line << '\n';
  out << detail::fracture_header << '\n';
  for (const NaturalFracture& f : fractures)
    out << to_text(f.from.x) << ',' << to_text(f.from.y) << ',' << to_text(f.to.x) << ','
        << to_text(f.to.y) << '\n';
}

/// Reads a table of fractures; whether they fit a specimen is for `check_fractures` to say.
/// @param in text as described above
/// @param name of the file, for messages
/// @throws InvalidParameter naming the line and what is wrong with it, or if there is no fracture
inline NamedFractures read_fracture_table(std::istream& in, const std::string& name) {
  using Lines = detail::DataLines;
  Lines lines(in, "line ", " of " + name, Lines::Between::commas);
  const std::string header(detail::fracture_header);
  if (!lines.next()) lines.wrong("ends where the header " + header + " should follow");
  const auto& words = lines.words();
  if (!std::equal(words.begin(), words.end(), detail::fracture_columns.begin(),
                  detail::fracture_columns.end()))
    lines.wrong("this is no table of fractures: it does not begin with the header " + header);
  NamedFractures read;
  while (lines.next()) {
    lines.expect_words(4, header);
    const auto value = [&](std::size_t column) {
      return lines.value<double>(column, detail::fracture_columns[column], any_number, "m");
    };
    read.fractures.push_back({{value(0), value(1)}, {value(2), value(3)}});
    read.names.push_back(lines.place());
  }
  if (read.fractures.empty()) lines.wrong("ends where a fracture, " + header + ", should follow");
  return read;
}

/// Writes a table of fractures to a file; until it is complete, an old one of this name stands.
/// @param path of the file
/// @param fractures to write
/// @param comment lines that go before the table; a '#' is put before each
/// @throws WriteFailed if that does not succeed
inline void save_fractures(const std::string& path, std::span<const NaturalFracture> fractures,
                           const std::string& comment = {}) {
  std::ostringstream text;
  write_fracture_table(text, fractures, comment);
  write_whole_file(path, text.view());
}

/// Reads a table of fractures from a file.
/// @throws InvalidParameter if the file cannot be read, or naming the line and what is wrong with
///   it
inline NamedFractures load_fractures(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw InvalidParameter("fracture file " + path + " cannot be read");
  return read_fracture_table(in, path);
}

}  // namespace hfdem
