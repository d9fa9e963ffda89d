/// @file
/// A mean over seeds and how far it can be trusted.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace hfdem::support {

/// Student's t that 95 % of all means stay within, for `freedom` = samples - 1.
inline double student_95(std::size_t freedom) {
  constexpr std::array table{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228,
                             2.201,  2.179, 2.160, 2.145, 2.131, 2.120, 2.110, 2.101, 2.093, 2.086,
                             2.080,  2.074, 2.069, 2.064, 2.060, 2.056, 2.052, 2.048, 2.045, 2.042};
  if (freedom == 0) return std::numeric_limits<double>::infinity();
  if (freedom <= table.size()) return table[freedom - 1];
  return 1.95996 + 2.4 / static_cast<double>(freedom);  // within 0.1 % from there on
}

/// Over independent samples of a normal distribution.
struct SeedMean {
  std::size_t samples = 0;
  double mean = 0;
  double deviation = 0;  ///< standard, of one sample; not a number for fewer than two
  double interval = 0;   ///< the true mean is within this of `mean`, at 95 %; the same

  static SeedMean of(const std::vector<double>& values) {
    SeedMean m{.samples = values.size()};
    const auto count = static_cast<double>(values.size());
    for (const double v : values) m.mean += v / count;
    for (const double v : values) m.deviation += (v - m.mean) * (v - m.mean);
    m.deviation = values.size() < 2 ? std::numeric_limits<double>::quiet_NaN()
                                    : std::sqrt(m.deviation / (count - 1));
    m.interval =
        student_95(values.size() < 2 ? 1 : values.size() - 1) * m.deviation / std::sqrt(count);
    return m;
  }
};

}  // namespace hfdem::support
