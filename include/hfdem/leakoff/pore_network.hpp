/// @file
/// The pores around a crack, the channels between them, and those through the crack's walls. Pores
/// far from the crack are left alone until pressure comes near.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <hfdem/state/network.hpp>

namespace hfdem {

/// Domains that are not on the crack, numbered in the order in which they were reached.
class PoreNetwork {
 public:
  /// A channel between two pores.
  struct Inner {
    Index channel;        ///< of the network
    Index first, second;  ///< pores

    /// All of it.
    void exchange(auto& archive) { archive(channel, first, second); }
  };
  /// A channel between the crack and a pore.
  struct Wall {
    Index channel;  ///< of the network
    Index crack;    ///< the domain, by the order in which it turned wet
    Index pore;     ///< what the fluid leaks into

    /// All of it.
    void exchange(auto& archive) { archive(channel, crack, pore); }
  };

  /// @param least_porosity least volume of a pore over the area of its domain
  explicit PoreNetwork(double least_porosity) : least_porosity_(least_porosity) {}

  /// Domains that have turned wet since are the crack's from now on.
  void join(const Network& network) {
    if (place_.empty()) {
      place_.assign(network.geometry().centre.size(), {nothing, nothing});
      reached_.assign(place_.size(), false);
    }
    const auto wet = network.wet_domains();
    if (crack_ == wet.size()) return;
    for (; crack_ < wet.size(); ++crack_) {
      place_[wet[crack_]].crack = static_cast<Index>(crack_);
      add(wet[crack_]);
      reach(network, wet[crack_]);
    }
    number(network);
  }

  /// Reaches out beyond the pores at the edge that fulfil a condition.
  /// @returns whether there were any
  template <class Condition>
  bool reach_beyond(const Network& network, Condition&& is_near) {
    bool any = false;
    for (Index m = 0; m < domains_.size(); ++m)
      if (at_edge_[m] && is_near(m)) reach(network, domains_[m]), any = true;
    if (any) number(network);
    return any;
  }

  std::size_t crack_size() const { return crack_; }            ///< wet domains that are known
  std::span<const Index> domains() const { return domains_; }  ///< of the network, one per pore
  std::span<const double> room() const { return room_; }       ///< volume of each pore, m2
  const std::vector<Inner>& inner() const { return inner_; }   ///< channels between pores
  std::span<const Wall> walls() const { return walls_; }       ///< channels to the crack
  /// All domains that have been reached, those of the crack too.
  std::span<const Index> reached() const { return all_; }

  /// Volume of the pore that a domain is, m2: its void, or what overlapping discs leave at least.
  double room(const Network& network, Index domain) const {
    const FlowDomains& g = network.geometry();
    return std::fmax(g.void_area[domain], least_porosity_ * g.area[domain]);
  }

  /// Which pores count.
  void exchange(auto& archive) {
    archive(place_, reached_, all_, crack_, domains_, room_, inner_, walls_, at_edge_);
  }

 private:
  /// Where a domain is.
  struct Place {
    Index crack, pore;  // `nothing` if it is not there

    void exchange(auto& archive) { archive(crack, pore); }
  };

  bool add(Index domain) {
    if (reached_[domain]) return false;
    reached_[domain] = true;
    all_.push_back(domain);
    return true;
  }

  /// Adds the domains that a few channels lead to.
  void reach(const Network& network, Index start) {
    constexpr int rings = 3;
    std::vector<Index> ring{start}, next;
    for (int k = 0; k < rings; ++k, ring.swap(next), next.clear())
      for (const Index d : ring)
        for (const Index c : network.channels_of(d))
          for (const Index end : network.geometry().channels[c].domain)
            if (end != nothing && add(end)) next.push_back(end);
  }

  void number(const Network& network) {
    domains_.clear(), room_.clear(), inner_.clear(), walls_.clear(), at_edge_.clear();
    for (const Index d : all_) {
      place_[d].pore = nothing;
      if (place_[d].crack != nothing) continue;
      place_[d].pore = static_cast<Index>(domains_.size());
      domains_.push_back(d);
      room_.push_back(room(network, d));
    }
    for (Index m = 0; m < domains_.size(); ++m) {
      bool at_edge = false;
      for (const Index c : network.channels_of(domains_[m])) {
        const auto ends = network.geometry().channels[c].domain;
        const Index other = ends[0] == domains_[m] ? ends[1] : ends[0];
        if (other == nothing || other == domains_[m]) continue;  // sealed, or leads nowhere
        const Place there = place_[other];
        if (!reached_[other])
          at_edge = true;
        else if (there.crack != nothing)
          walls_.push_back({c, there.crack, m});
        else if (there.pore > m)
          inner_.push_back({c, m, there.pore});
      }
      at_edge_.push_back(at_edge);
    }
  }

  double least_porosity_;
  std::vector<Place> place_;    // of each domain of the network
  std::vector<bool> reached_;   // each domain of the network
  std::vector<Index> all_;      // that have been reached, in order
  std::size_t crack_ = 0;       // wet domains that are known
  std::vector<Index> domains_;  // of each pore
  std::vector<double> room_;
  std::vector<Inner> inner_;
  std::vector<Wall> walls_;
  std::vector<bool> at_edge_;  // each pore: whether pores beside it have not been reached
};

}  // namespace hfdem
