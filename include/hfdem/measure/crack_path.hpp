/// @file
/// The shape of an irregular crack: tips, the path between them, branches, tortuosity, asymmetry.
///
/// Tips are the paper's "tip location on the y-axis" (its Figs. 10 and 11): on either side of the
/// injection, that end of a connected microcrack which is farthest from it along the direction in
/// which the crack is expected to run. They are the "two ends of the fracture", whose connecting
/// line its Fig. 7 shows. Tortuosity is "the total fracture length along a pathway (L_0) divided by
/// the distance between the two ends of the fracture (L)", with the total length "the sum of the
/// length of all microcracks" (its Section 4.1); those that are not connected to the fracture are
/// left out here. A microcrack is 2 Rb long, more than the flow channel across it, so that even a
/// crack that looks straight in a random specimen has a tortuosity well above one.
///
/// The connected microcracks are the edges of a graph whose nodes are flow domains. The path runs
/// on the shortest ways, in lengths of microcracks, from the injection to both tips; if both begin
/// alike, it skips what they share.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <hfdem/measure/crack_graph.hpp>
#include <hfdem/measure/microcracks.hpp>

namespace hfdem::measure {

/// Where a crack begins.
struct CrackOrigin {
  Index domain = nothing;  ///< that receives the fluid
  Vec2 position{};         ///< its centre, m
  Vec2 direction{0, 1};    ///< unit vector along which the crack is expected to run

  double along(Vec2 point) const { return dot(point - position, direction); }  ///< m
};

/// Where that of a run begins.
template <class Sim>
CrackOrigin crack_origin(const Sim& sim) {
  return {sim.network().injection_domain(), injection_point(sim), sim.crack_direction()};
}

/// What lies on one side of the injection.
struct Wing {
  Vec2 tip{};           ///< m; at the injection if there is no crack on this side
  double reach = 0;     ///< of the tip along the crack's direction, m
  double distance = 0;  ///< from the injection to the tip, m
  double length = 0;    ///< of all connected microcracks, branches included, m

  double tortuosity() const { return distance > 0 ? length / distance : 0; }  ///< 0 without a crack
};

/// One microcrack of the path.
struct PathPoint {
  std::size_t microcrack;  ///< its place in the list that was measured
  double arc;              ///< from where the fluid enters the path to its middle, m; < 0 downwards
  double along;            ///< of its middle from the injection along the crack's direction, m
};

/// The fluid-filled crack.
struct CrackPath {
  Wing up, down;                    ///< along the crack's direction, and against it
  std::vector<PathPoint> points{};  ///< from the lower to the upper tip
  double path_length = 0;           ///< of the path's microcracks, m
  std::vector<Branch> branches{};   ///< the longest first

  double tip_distance() const { return norm(up.tip - down.tip); }      ///< L, m
  double connected_length() const { return up.length + down.length; }  ///< L_0, m
  /// L_0 / L with the branches; 0 without a crack.
  double tortuosity() const { return over_tip_distance(connected_length()); }
  /// The same of the path alone.
  double path_tortuosity() const { return over_tip_distance(path_length); }
  /// "The average tortuosity in the two directions", which the paper's Fig. 7 names: the mean of
  /// the wings', each seen from the injection.
  double mean_tortuosity() const { return (up.tortuosity() + down.tortuosity()) / 2; }
  /// |l1 - l2| / (l1 + l2) of the wings' reaches: 0 if they are equal, 1 if there is only one.
  double asymmetry() const {
    const double sum = up.reach + down.reach;
    return sum > 0 ? std::abs(up.reach - down.reach) / sum : 0;
  }

 private:
  double over_tip_distance(double length) const {
    return tip_distance() > 0 ? length / tip_distance() : 0;
  }
};

namespace detail {

/// What two ways back to the injection end with is on the path only if a tip lies on it.
inline void drop_shared_end(CrackGraph::Way& one, CrackGraph::Way& other) {
  auto& shorter = one.size() < other.size() ? one : other;
  const auto parted = std::mismatch(one.rbegin(), one.rend(), other.rbegin(), other.rend());
  const auto shared = static_cast<std::size_t>(parted.first - one.rbegin());
  if (shared == shorter.size()) {
    shorter.clear();  // its tip lies on the other's way
  } else {
    one.resize(one.size() - shared);
    other.resize(other.size() - shared);
  }
}

}  // namespace detail

/// Measures the connected microcracks. In n of them it takes a time of order n log n.
/// @param microcracks as from `microcracks(sim)`, in any order
/// @param origin as from `crack_origin(sim)`
inline CrackPath crack_path(std::span<const Microcrack> microcracks, const CrackOrigin& origin) {
  const CrackGraph graph(microcracks, origin.domain);
  CrackPath crack{.up = {.tip = origin.position}, .down = {.tip = origin.position}};
  if (graph.edges().empty()) return crack;

  std::size_t upmost = graph.edges().front(), downmost = upmost;
  for (const std::size_t m : graph.edges()) {
    const auto stretch = [&](Wing& wing, double sign, std::size_t& farthest) {
      for (const Vec2 end : {microcracks[m].facet.from, microcracks[m].facet.to}) {
        const double reach = sign * origin.along(end);
        if (reach <= wing.reach) continue;
        wing.tip = end;
        wing.reach = reach;
        wing.distance = norm(end - origin.position);
        farthest = m;
      }
    };
    stretch(crack.up, 1, upmost);
    stretch(crack.down, -1, downmost);
    const bool above = origin.along(microcracks[m].middle()) >= 0;
    (above ? crack.up : crack.down).length += microcracks[m].length();
  }

  auto lower = crack.down.reach > 0 ? graph.way_back(downmost) : CrackGraph::Way{};
  auto upper = crack.up.reach > 0 ? graph.way_back(upmost) : CrackGraph::Way{};
  detail::drop_shared_end(lower, upper);
  double arc = 0;
  for (const std::size_t m : lower) arc -= microcracks[m].length();
  std::vector<bool> on_path(microcracks.size(), false);
  lower.insert(lower.end(), upper.rbegin(), upper.rend());
  for (const std::size_t m : lower) {
    const double length = microcracks[m].length();
    crack.points.push_back({m, arc + length / 2, origin.along(microcracks[m].middle())});
    arc += length;
    crack.path_length += length;
    on_path[m] = true;
  }
  crack.branches = graph.branches(on_path);
  return crack;
}

}  // namespace hfdem::measure
