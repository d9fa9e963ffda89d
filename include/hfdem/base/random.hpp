/// @file
/// Random numbers that are the same on every machine, compiler and library: SplitMix64 (G. L.
/// Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014), and
/// our own mapping from its bits to numbers.
#pragma once

#include <cstdint>

namespace hfdem {

/// A stream of random numbers that depends on its seed alone.
class Random {
 public:
  /// @param seed any number
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// Leaves out so many numbers, at no cost: the stream can be entered anywhere.
  void skip(std::uint64_t numbers) { state_ += numbers * increment; }

  /// 64 random bits.
  std::uint64_t bits() {
    state_ += increment;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }

  /// Uniform in [0, 1): the upper 53 bits as a binary fraction, every one of them exact.
  double fraction() { return 0x1p-53 * static_cast<double>(bits() >> 11); }

  /// Uniform between `low` and `high`.
  double between(double low, double high) { return low + (high - low) * fraction(); }

 private:
  static constexpr std::uint64_t increment = 0x9e3779b97f4a7c15U;
  std::uint64_t state_;
};

}  // namespace hfdem
