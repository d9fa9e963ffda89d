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

/// Medians over many rounds, in each of which every piece of work is timed once; they take turns
/// in going first. A ratio is the median of each round's own ratio.
class InTurns {
 public:
  template <class... Works>
  void round(Works&&... works) {
    times_.resize(sizeof...(works));
    for (std::size_t turn = 0; turn < sizeof...(works); ++turn) {
      const std::size_t now = (turn + rounds_) % sizeof...(works);
      std::size_t k = 0;
      ((k++ == now ? times_[k - 1].push_back(seconds(works)) : void()), ...);
    }
    ++rounds_;
  }

  double last(std::size_t work) const { return times_[work].back(); }   ///< s
  double time(std::size_t work) const { return median(times_[work]); }  ///< s
  /// The shortest time, s: nearest to that of an idle machine.
  double best(std::size_t work) const { return std::ranges::min(times_[work]); }
  double ratio(std::size_t a, std::size_t b) const {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < rounds_; ++k) ratios.push_back(times_[a][k] / times_[b][k]);
    return median(ratios);
  }

 private:
  std::size_t rounds_ = 0;
  std::vector<std::vector<double>> times_;
};

/// Two pieces of work in turns.
class SideBySide {
 public:
  /// Times both once.
  template <class A, class B>
  void pair(A&& a, B&& b) {
    turns_.round(a, b);
  }

  double last_a() const { return turns_.last(0); }  ///< s
  double a() const { return turns_.time(0); }       ///< s
  double b() const { return turns_.time(1); }       ///< s
  double a_over_b() const { return turns_.ratio(0, 1); }

 private:
  InTurns turns_;
};
