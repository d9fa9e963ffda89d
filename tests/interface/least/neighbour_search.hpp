/// @file
/// The least neighbour search; docs/concepts/neighbour_search.md explains it.
#pragma once

#include <hfdem/state/concepts.hpp>

namespace models {

using namespace hfdem;

/// Looks at every pair: fine for some thousand discs.
class AllPairs {
 public:
  AllPairs(const Specimen& specimen, double reach) : specimen_(specimen), reach_(reach) {}

  template <class F>
  void for_each_pair(F&& f) const {
    for (Index second = 0; second < specimen_.size(); ++second)
      for (Index first = 0; first < second; ++first)
        if (const Pair pair{first, second}; specimen_.gap(pair) <= reach_) f(pair);
  }

 private:
  const Specimen& specimen_;
  double reach_;
};

}  // namespace models
