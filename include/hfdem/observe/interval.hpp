/// @file
/// When an observer writes: at the first fluid step at or after each multiple of an interval.
#pragma once

#include <cmath>

namespace hfdem::observe {

/// A clock of simulated time.
class Interval {
 public:
  /// @param interval s, greater than 0
  explicit Interval(double interval) : interval_(interval) {}

  /// Whether the next multiple has come; rounding of the time does not delay it.
  bool is_due(double time) const { return time + 1e-6 * interval_ >= next_; }
  /// Waits for the first multiple after a time.
  void wait_from(double time) { next_ = interval_ * (std::floor(time / interval_ + 1e-6) + 1); }

  /// When it is due again.
  void exchange(auto& archive) { archive(next_); }

 private:
  double interval_, next_ = 0;
};

}  // namespace hfdem::observe
