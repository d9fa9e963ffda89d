// What "equal" means in these tests: close relative to the value itself, or the same bits.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <ostream>

#include <doctest/doctest.h>

namespace test {

/// A number within a relative tolerance; doctest's own Approx would add an absolute one, and does
/// not find zero near zero.
struct Near {
  double value, tolerance;
  double size = 0;  ///< of what the number is a difference of

  /// Within the tolerance of such a size besides.
  Near scale(double of) const { return {value, tolerance, of}; }

  friend bool operator==(double other, const Near& n) {
    return std::abs(other - n.value) <=
           n.tolerance * (n.size + std::max(std::abs(other), std::abs(n.value)));
  }
  friend std::ostream& operator<<(std::ostream& out, const Near& n) {
    return out << n.value << " to a part in " << 1 / n.tolerance;
  }
};

inline Near near(double value, double tolerance = 1e-12) { return {value, tolerance}; }

inline std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

}  // namespace test
