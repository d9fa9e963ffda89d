/// @file
/// Neighbours by a k-d tree (the library nanoflann): the search for any specimen, however unequal
/// the discs and uneven their spread.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <nanoflann.hpp>
#include <vector>

#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// A `NeighbourSearch` that asks a tree of the centres for what is near each disc.
class KdTree {
 public:
  /// Finds the pairs.
  /// @param specimen is not kept
  /// @param reach largest gap of a pair, m
  KdTree(const Specimen& specimen, double reach) {
    const Points points{specimen.centre};
    const Tree tree(2, points, nanoflann::KDTreeSingleIndexAdaptorParams(leaf_size));
    Nearby nearby;
    for (Index i = 0; i < specimen.size(); ++i) {
      const double radius = specimen.radius[i];
      // The larger disc of a pair finds the smaller one, so that no disc looks farther than its
      // own size tells; a little farther, for rounding.
      const double range = (1 + 1e-9) * std::fmax(2 * radius + reach, 0.0);
      nearby.squared_range = range * range;
      nearby.discs.clear();
      const std::array<double, 2> at{specimen.centre[i].x, specimen.centre[i].y};
      tree.findNeighbors(nearby, at.data(), {});
      for (const Index j : nearby.discs) {
        const Pair pair{std::min(i, j), std::max(i, j)};
        const bool finds_it =
            specimen.radius[j] < radius || (specimen.radius[j] == radius && i < j);
        if (finds_it && specimen.gap(pair) <= reach) pairs_.push_back(pair);
      }
    }
    std::sort(pairs_.begin(), pairs_.end());
  }

  /// Calls `f(Pair)` for every pair whose gap is at most the reach, sorted.
  template <class F>
  void for_each_pair(F&& f) const {
    for (const Pair& p : pairs_) f(p);
  }

 private:
  static constexpr std::size_t leaf_size = 10;

  /// The centres, as nanoflann reads them.
  struct Points {
    const std::vector<Vec2>& centre;
    std::size_t kdtree_get_point_count() const { return centre.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t axis) const {
      return axis == 0 ? centre[i].x : centre[i].y;
    }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;  // let the tree find it
    }
  };
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Points>,
                                                   Points, 2, Index>;

  /// What nanoflann calls a result set: here every disc within a distance.
  struct Nearby {
    double squared_range = 0;
    std::vector<Index> discs{};
    std::size_t size() const { return discs.size(); }
    bool empty() const { return discs.empty(); }
    bool full() const { return true; }
    double worstDist() const { return squared_range; }
    bool addPoint(double /*squared_distance*/, Index disc) {
      discs.push_back(disc);
      return true;
    }
    void sort() {}
  };

  std::vector<Pair> pairs_;
};

}  // namespace hfdem
