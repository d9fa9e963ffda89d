/// @file
/// What passes between a pressure scheme and its leak-off law.
#pragma once

#include <span>

namespace hfdem {

/// What the wet domains have, in the order in which they turned wet.
struct CrackFluid {
  std::span<const double> pressure;  ///< Pa
  std::span<const double> stored;    ///< m2 at zero pressure
};

/// How a law makes a fluid step: from what is known at its start, or towards its end.
enum class Euler { forward, backward };

}  // namespace hfdem
