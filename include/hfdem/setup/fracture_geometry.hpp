/// @file
/// Segments for Boost.Geometry: how far apart natural fractures are, and which of them are near.
/// The only header that includes Boost, which takes long to compile.
#pragma once

// Boost 1.74 would tell users of its own use of an old name.
#ifndef BOOST_ALLOW_DEPRECATED_HEADERS
#define BOOST_ALLOW_DEPRECATED_HEADERS
#endif

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <hfdem/state/specimen.hpp>

#include <boost/geometry/algorithms/distance.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/segment.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>

namespace hfdem {

namespace detail {

using BoostPoint = boost::geometry::model::d2::point_xy<double>;
using BoostBox = boost::geometry::model::box<BoostPoint>;
using BoostSegment = boost::geometry::model::segment<BoostPoint>;

inline BoostPoint boost_point(Vec2 p) { return {p.x, p.y}; }
inline BoostSegment boost_segment(const NaturalFracture& f) {
  return {boost_point(f.from), boost_point(f.to)};
}
/// The box around a segment, wider by a margin on each side.
inline BoostBox boost_box(Vec2 a, Vec2 b, double margin = 0) {
  return {{std::fmin(a.x, b.x) - margin, std::fmin(a.y, b.y) - margin},
          {std::fmax(a.x, b.x) + margin, std::fmax(a.y, b.y) + margin}};
}

}  // namespace detail

/// Shortest distance between two segments, m; zero if they meet.
inline double distance(const NaturalFracture& a, const NaturalFracture& b) {
  return boost::geometry::distance(detail::boost_segment(a), detail::boost_segment(b));
}
/// Shortest distance of a point from a segment, m.
inline double distance(const NaturalFracture& a, Vec2 point) {
  return boost::geometry::distance(detail::boost_point(point), detail::boost_segment(a));
}

/// Fractures in a tree of the boxes around them, to find those near a place fast.
class FractureTree {
 public:
  /// Empty.
  FractureTree() = default;
  /// Numbers the fractures in their order.
  explicit FractureTree(const std::vector<NaturalFracture>& fractures) {
    for (const NaturalFracture& f : fractures) insert(f);
  }

  /// Adds a fracture, with the next number.
  void insert(const NaturalFracture& f) {
    tree_.insert({detail::boost_box(f.from, f.to), static_cast<Index>(tree_.size())});
  }

  /// Finds every fracture that can be within a distance of a segment, and perhaps others.
  /// @param a end of the segment, m
  /// @param b its other end, m
  /// @param margin the distance, m
  /// @param found replaced by the numbers of the fractures, sorted
  void near(Vec2 a, Vec2 b, double margin, std::vector<Index>& found) const {
    found.clear();
    tree_.query(boost::geometry::index::intersects(detail::boost_box(a, b, margin)),
                boost::make_function_output_iterator(
                    [&](const Boxed& fracture) { found.push_back(fracture.second); }));
    std::sort(found.begin(), found.end());
  }

 private:
  using Boxed = std::pair<detail::BoostBox, Index>;
  boost::geometry::index::rtree<Boxed, boost::geometry::index::quadratic<8>> tree_;
};

}  // namespace hfdem
