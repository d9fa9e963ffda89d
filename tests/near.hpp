// What "equal" means in these tests: close relative to the value itself, or the same bits.
#pragma once

#include <bit>
#include <cstdint>

#include <doctest/doctest.h>

namespace test {

/// Within a relative tolerance; doctest's own Approx would add an absolute one.
inline doctest::Approx near(double value, double tolerance = 1e-12) {
  return doctest::Approx(value).scale(0).epsilon(tolerance);
}

inline std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

}  // namespace test
