/// @file
/// Ways and branches in a crack: its microcracks are the edges of a graph of flow domains.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include <hfdem/measure/microcracks.hpp>

namespace hfdem::measure {

/// Connected microcracks that hang together, but not through the path.
struct Branch {
  std::vector<std::size_t> microcracks{};  ///< their places in the list that was measured
  double length = 0;                       ///< of all of them, m
};

/// The connected microcracks, and from each flow domain the shortest way back to the injection, in
/// lengths of microcracks (E. W. Dijkstra, Numer. Math. 1 (1959) 269-271).
class CrackGraph {
 public:
  using Way = std::vector<std::size_t>;  ///< places in the list of microcracks

  /// @param microcracks must outlive the graph
  /// @param origin domain that receives the fluid
  CrackGraph(std::span<const Microcrack> microcracks, Index origin) : microcracks_(microcracks) {
    domains_ = {origin};
    for (std::size_t m = 0; m < microcracks.size(); ++m) {
      if (!microcracks[m].connected) continue;
      edges_.push_back(m);
      for (const Index d : microcracks[m].domain)
        if (d != nothing) domains_.push_back(d);
    }
    std::sort(domains_.begin(), domains_.end());
    domains_.erase(std::unique(domains_.begin(), domains_.end()), domains_.end());
    at_.resize(domains_.size());
    for (const std::size_t m : edges_)
      for (const Index d : microcracks[m].domain)
        if (d != nothing) at_[node(d)].push_back(m);
    find_ways(node(origin));
  }

  /// The connected microcracks.
  const Way& edges() const { return edges_; }

  /// The microcracks from one of them to the injection, both ends included.
  Way way_back(std::size_t microcrack) const {
    Way way{microcrack};
    for (std::size_t here = nearer_end(microcrack); came_by_[here] != none;) {
      way.push_back(came_by_[here]);
      here = other_end(came_by_[here], here);
    }
    return way;
  }

  /// The groups of microcracks off the path, the longest first.
  std::vector<Branch> branches(const std::vector<bool>& on_path) const {
    std::vector<bool> taken = on_path, barrier(domains_.size(), false);
    for (const std::size_t m : edges_)
      if (on_path[m]) for_each_end(m, [&](std::size_t n) { barrier[n] = true; });
    std::vector<Branch> found;
    for (const std::size_t start : edges_) {
      if (taken[start]) continue;
      Branch branch{.microcracks = {start}};
      taken[start] = true;
      for (std::size_t k = 0; k < branch.microcracks.size(); ++k) {
        branch.length += microcracks_[branch.microcracks[k]].length();
        for_each_end(branch.microcracks[k], [&](std::size_t n) {
          if (barrier[n]) return;
          for (const std::size_t next : at_[n]) {
            if (taken[next]) continue;
            taken[next] = true;
            branch.microcracks.push_back(next);
          }
        });
      }
      found.push_back(std::move(branch));
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const Branch& a, const Branch& b) { return a.length > b.length; });
    return found;
  }

 private:
  static constexpr std::size_t none = ~std::size_t{0};

  std::size_t node(Index domain) const {
    return static_cast<std::size_t>(std::lower_bound(domains_.begin(), domains_.end(), domain) -
                                    domains_.begin());
  }
  template <class F>
  void for_each_end(std::size_t microcrack, F&& f) const {
    for (const Index d : microcracks_[microcrack].domain)
      if (d != nothing) f(node(d));
  }
  /// The node across a microcrack; the same one where it leads out of the specimen.
  std::size_t other_end(std::size_t microcrack, std::size_t here) const {
    std::size_t there = here;
    for_each_end(microcrack, [&](std::size_t n) { there = n != here ? n : there; });
    return there;
  }
  std::size_t nearer_end(std::size_t microcrack) const {
    std::size_t nearer = none;
    for_each_end(microcrack, [&](std::size_t n) {
      if (nearer == none || distance_[n] < distance_[nearer]) nearer = n;
    });
    return nearer;
  }

  void find_ways(std::size_t origin) {
    using Front = std::pair<double, std::size_t>;
    std::priority_queue<Front, std::vector<Front>, std::greater<>> front;
    distance_.assign(domains_.size(), std::numeric_limits<double>::infinity());
    came_by_.assign(domains_.size(), none);
    distance_[origin] = 0;
    front.push({0, origin});
    while (!front.empty()) {
      const auto [distance, here] = front.top();
      front.pop();
      if (distance > distance_[here]) continue;
      for (const std::size_t m : at_[here]) {
        const std::size_t there = other_end(m, here);
        const double farther = distance + microcracks_[m].length();
        if (farther >= distance_[there]) continue;
        distance_[there] = farther;
        came_by_[there] = m;
        front.push({farther, there});
      }
    }
  }

  std::span<const Microcrack> microcracks_;
  Way edges_{};
  std::vector<Index> domains_{};        ///< the nodes, sorted
  std::vector<Way> at_{};               ///< the microcracks around each node
  std::vector<double> distance_{};      ///< of each node from the injection, m
  std::vector<std::size_t> came_by_{};  ///< the last microcrack on the way to it
};

}  // namespace hfdem::measure
