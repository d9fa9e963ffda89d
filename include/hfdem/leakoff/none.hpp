/// @file
/// Rock that lets nothing in: intact contacts are closed.
#pragma once

#include <tuple>

namespace hfdem {

/// A `LeakoffLaw` without leak-off.
class NoLeakoff {
 public:
  /// None.
  struct Params {
    static constexpr auto fields() { return std::tuple{}; }  ///< nothing to set
  };
  static constexpr bool leaks = false;  ///< nothing is lost

  /// Nothing to set.
  explicit NoLeakoff(const Params&) {}
};

}  // namespace hfdem
