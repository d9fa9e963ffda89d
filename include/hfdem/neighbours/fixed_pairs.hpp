/// @file
/// No search: the specimen already knows its pairs, as a regular array does.
#pragma once

#include <vector>

#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// A `NeighbourSearch` that proposes `Specimen::pairs`.
class FixedPairs {
 public:
  /// @param specimen whose pairs are copied
  FixedPairs(const Specimen& specimen, double /*reach*/) : pairs_(specimen.pairs) {}

  /// Calls `f(Pair)` in the specimen's order.
  template <class F>
  void for_each_pair(F&& f) const {
    for (const Pair& p : pairs_) f(p);
  }

 private:
  std::vector<Pair> pairs_;
};

}  // namespace hfdem
