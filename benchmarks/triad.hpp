/// @file
/// How fast this machine moves memory, now: a[i] = b[i] + s c[i] over arrays of a given size.
///
/// Source: J. D. McCalpin, "Memory bandwidth and machine balance in current high performance
/// computers", IEEE TCCA Newsletter (1995); bytes are counted as there: two read and one written.
#pragma once

#include <cstddef>
#include <vector>

#include <hfdem/base/parallel.hpp>

class Triad {
 public:
  /// @param bytes of the three arrays together
  explicit Triad(std::size_t bytes)
      : a_(bytes / (3 * sizeof(double)), 0), b_(a_.size(), 1), c_(a_.size(), 2) {}

  void run(int threads) {
    hfdem::for_chunks(a_.size(), 4096, threads,
                      [&](std::size_t, std::size_t begin, std::size_t end) {
                        double* a = a_.data();
                        const double *b = b_.data(), *c = c_.data();
                        for (std::size_t i = begin; i < end; ++i) a[i] = b[i] + 3.0 * c[i];
                      });
  }
  double bytes() const { return 3.0 * sizeof(double) * static_cast<double>(a_.size()); }

 private:
  std::vector<double> a_, b_, c_;
};
