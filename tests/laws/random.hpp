// A linear congruential generator: the same numbers on every machine and library.
#pragma once

#include <cstdint>

namespace test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// Uniform between `low` and `high`.
  double operator()(double low, double high) {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    return low + (high - low) * 0x1p-53 * static_cast<double>(state_ >> 11);
  }

 private:
  std::uint64_t state_;
};

}  // namespace test
