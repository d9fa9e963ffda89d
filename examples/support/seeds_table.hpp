/// @file
/// The table seeds.csv of a study over several rocks, read back.
#pragma once

#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <hfdem/base/errors.hpp>

namespace hfdem::support {

class SeedsTable {
 public:
  /// @throws InvalidParameter if there is no such table, or it is damaged
  explicit SeedsTable(const std::string& path) {
    std::ifstream in(path);
    std::string line;
    if (!std::getline(in, line))
      throw InvalidParameter("cannot read " + path + ": it is written by a run with --seeds");
    keys_ = cells(line);
    while (std::getline(in, line)) {
      const auto row = cells(line);
      if (row.size() != keys_.size())
        throw InvalidParameter(path + " is damaged: a row has " + std::to_string(row.size()) +
                               " cells, the first line " + std::to_string(keys_.size()));
      seeds_.push_back(static_cast<int>(number(row.front())));
      for (std::size_t k = 1; k < row.size(); ++k)
        values_[{seeds_.back(), keys_[k]}] = number(row[k]);
    }
  }

  const std::vector<int>& seeds() const { return seeds_; }
  /// Of a rock; not a number if the table has none.
  double value(int seed, std::string_view key) const {
    const auto place = values_.find({seed, std::string(key)});
    return place == values_.end() ? NAN : place->second;
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

  std::vector<std::string> keys_;
  std::vector<int> seeds_;
  std::map<std::pair<int, std::string>, double> values_;
};

}  // namespace hfdem::support
