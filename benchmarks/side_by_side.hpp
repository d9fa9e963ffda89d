/// @file
/// Timing two pieces of work in turn, so that whatever else a machine does slows both alike.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <vector>

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

template <class Work>
double seconds(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Medians over many pairs of timings; the ratio is the median of each pair's own ratio.
class SideBySide {
 public:
  /// Times both once; they take turns in going first.
  template <class A, class B>
  void pair(A&& a, B&& b) {
    const bool a_first = a_.size() % 2 == 0;
    if (a_first) a_.push_back(seconds(a));
    b_.push_back(seconds(b));
    if (!a_first) a_.push_back(seconds(a));
    ratio_.push_back(a_.back() / b_.back());
  }

  double last_a() const { return a_.back(); }  ///< s
  double a() const { return median(a_); }      ///< s
  double b() const { return median(b_); }      ///< s
  double a_over_b() const { return median(ratio_); }
  /// The shortest times, s: nearest to those of an idle machine.
  double best_a() const { return std::ranges::min(a_); }
  double best_b() const { return std::ranges::min(b_); }

 private:
  std::vector<double> a_, b_, ratio_;
};
