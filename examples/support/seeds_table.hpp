/// @file
/// The table seeds.csv of a study over several rocks, read back, and how two of them compare.
#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <hfdem/measure/sample_mean.hpp>

#include "support/csv_table.hpp"

namespace hfdem::support {

class SeedsTable {
 public:
  /// @throws InvalidParameter if there is no such table, or it is damaged
  explicit SeedsTable(const std::string& path) : table_(path, "a run with --seeds") {
    for (const double seed : table_.column("seed")) seeds_.push_back(static_cast<int>(seed));
  }

  const std::vector<int>& seeds() const { return seeds_; }
  /// Of a rock; not a number if the table has none.
  double value(int seed, std::string_view key) const {
    const auto values = table_.column(key);
    for (std::size_t k = 0; k < seeds_.size(); ++k)
      if (seeds_[k] == seed) return values[k];
    return NAN;
  }

 private:
  CsvTable table_;
  std::vector<int> seeds_;
};

/// A reading of the same rocks in two studies.
struct PairedReading {
  measure::SampleMean first, second, change;  ///< over the rocks that have it in both
  std::size_t rocks = 0;
};

/// @param factor to another unit
inline PairedReading paired(const SeedsTable& first, const SeedsTable& second, std::string_view key,
                            double factor) {
  std::vector<double> a, b, change;
  for (const int seed : first.seeds()) {
    const double x = factor * first.value(seed, key), y = factor * second.value(seed, key);
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    a.push_back(x), b.push_back(y), change.push_back(x - y);
  }
  if (change.empty()) return {};
  return {measure::SampleMean::of(a), measure::SampleMean::of(b), measure::SampleMean::of(change),
          change.size()};
}

/// Whether a change has a sign, and which. @param expected +1 or -1, or 0 if nothing is expected
/// @param as words for a change that is as expected
inline std::string_view verdict(const measure::SampleMean& change, int expected,
                                std::string_view as) {
  if (!(std::abs(change.mean) > change.ci95)) return "not told apart";
  if (expected == 0) return change.mean > 0 ? "more" : "less";
  return change.mean * expected > 0 ? as : "the other way round";
}

}  // namespace hfdem::support
