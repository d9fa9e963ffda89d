// Simulators on small square arrays, and what symmetry demands of them.
#pragma once

#include <cmath>
#include <cstddef>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/pressure/dry.hpp>
#include <hfdem/pressure/held.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

namespace test {

template <class Pressure>
using SquareRock = hfdem::Simulator<hfdem::LinearParallelBond, hfdem::HyperbolicAperture, Pressure,
                                    hfdem::FixedPairs>;
using Injected = SquareRock<hfdem::UniformPressure>;

inline constexpr double radius = 5e-3;

inline hfdem::Specimen square(int size) { return hfdem::square_array(size, size, radius); }

/// How many discs of a square array have moved otherwise than their mirror images about the two
/// mid-planes, to the last bit; zeros of either sign are equal.
inline std::size_t asymmetric_discs(const hfdem::Discs& discs) {
  const auto n = static_cast<std::size_t>(std::lround(std::sqrt(discs.size())));
  std::size_t count = 0;
  for (std::size_t row = 0; row < n; ++row)
    for (std::size_t column = 0; column < n; ++column) {
      const hfdem::Pack& own = discs.displacement[row * n + column];
      const hfdem::Pack& across = discs.displacement[row * n + n - 1 - column];
      const hfdem::Pack& above = discs.displacement[(n - 1 - row) * n + column];
      const bool symmetric = own[0] == -across[0] && own[1] == across[1] && own[2] == -across[2] &&
                             own[0] == above[0] && own[1] == -above[1] && own[2] == -above[2];
      count += symmetric ? 0 : 1;
    }
  return count;
}

}  // namespace test
