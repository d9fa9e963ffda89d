/// @file
/// The mean over several specimens, and how well it is known.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>

namespace hfdem::measure {

/// How far the mean of normally distributed values is from their sample's, in standard errors, with
/// a probability of 95 %: Student's t.
///
/// From the distribution in closed form (M. Abramowitz, I. A. Stegun, Handbook of Mathematical
/// Functions, 26.7.3 and 26.7.4), by bisection.
/// @param freedom degrees of freedom, at least 1
inline double student_t_95(int freedom) {
  const auto within = [freedom](double theta) {  // P(|T| < sqrt(freedom) tan(theta))
    const double cosine = std::cos(theta), square = cosine * cosine;
    const bool odd = freedom % 2 == 1;
    double term = odd ? cosine : 1, sum = freedom == 1 ? 0 : term;
    for (int k = odd ? 3 : 2; k < freedom; k += 2) {
      term *= square * (k - 1) / k;
      sum += term;
    }
    return odd ? (theta + std::sin(theta) * sum) * 2 / std::numbers::pi : std::sin(theta) * sum;
  };
  double low = 0, high = std::numbers::pi / 2;
  for (int k = 0; k < 60; ++k) {
    const double middle = (low + high) / 2;
    (within(middle) < 0.95 ? low : high) = middle;
  }
  return std::sqrt(freedom) * std::tan(low);
}

/// A mean and the half width of its 95 % confidence interval, which a single value has not.
struct SampleMean {
  double mean;          ///< in the unit of the values
  double ci95;          ///< half width; not a number for a single value
  double deviation;     ///< standard deviation of the values; likewise
  std::size_t samples;  ///< number of values

  /// @param values any number; of none, not a number
  static SampleMean of(std::span<const double> values) {
    const auto count = static_cast<double>(values.size());
    double mean = 0, squares = 0;
    for (const double v : values) mean += v / count;
    for (const double v : values) squares += (v - mean) * (v - mean);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (values.empty()) return {none, none, none, 0};
    if (values.size() < 2) return {mean, none, none, 1};
    const double deviation = std::sqrt(squares / (count - 1));
    return {mean, student_t_95(static_cast<int>(values.size()) - 1) * deviation / std::sqrt(count),
            deviation, values.size()};
  }
};

}  // namespace hfdem::measure
