/// @file
/// A table that a program has written, read back by the names of its columns.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <hfdem/base/errors.hpp>

namespace hfdem::support {

/// Numbers under names; a cell without a number is not a number.
class CsvTable {
 public:
  /// @param path of the file
  /// @param origin who writes such a file, for the message if there is none
  /// @throws InvalidParameter if there is no such table, or it is damaged
  CsvTable(const std::string& path, std::string_view origin) {
    std::ifstream in(path);
    std::string line;
    if (!std::getline(in, line))
      throw InvalidParameter("cannot read " + path + ": it is written by " + std::string(origin));
    names_ = cells(line);
    columns_.resize(names_.size());
    while (std::getline(in, line)) {
      const auto row = cells(line);
      if (row.size() != names_.size())
        throw InvalidParameter(path + " is damaged: a row has " + std::to_string(row.size()) +
                               " cells, the first line " + std::to_string(names_.size()));
      for (std::size_t k = 0; k < row.size(); ++k) columns_[k].push_back(number(row[k]));
    }
  }

  std::size_t rows() const { return columns_.empty() ? 0 : columns_.front().size(); }
  /// Not a number where the table has no such column.
  std::vector<double> column(std::string_view name) const {
    const auto place = std::find(names_.begin(), names_.end(), name);
    if (place == names_.end()) return std::vector<double>(rows(), NAN);
    return columns_[static_cast<std::size_t>(place - names_.begin())];
  }

 private:
  static std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> all;
    std::istringstream in(line + ',');
    for (std::string cell; std::getline(in, cell, ',');) all.push_back(cell);
    return all;
  }
  static double number(const std::string& text) {
    double value = NAN;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
  }

  std::vector<std::string> names_;
  std::vector<std::vector<double>> columns_;
};

}  // namespace hfdem::support
