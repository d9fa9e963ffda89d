/// @file
/// What every wet domain stores, and the wet part of the network as flow sees it: the common part
/// of the schemes that let fluid flow.
///
/// Domains and channels are numbered in the order in which they turned wet, the injection first, so
/// that loops run over short contiguous arrays, and the two wings of a straight crack, numbered
/// alike, get the same bits.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include <hfdem/base/pack.hpp>
#include <hfdem/state/network.hpp>
#include <hfdem/state/volume_balance.hpp>

namespace hfdem {

/// A wet channel between two wet domains.
struct WetChannel {
  Index channel;        ///< of the network
  Index first, second;  ///< its domains, by the order in which they turned wet
  double length;        ///< l_p, m

  /// All of it.
  void exchange(auto& archive) { archive(channel, first, second, length); }
};

/// The stored volumes S, as volumes at zero pressure.
class StoredFluid {
 public:
  /// Adds what has turned wet. A channel brings the fluid that was in it, half to each side: what
  /// its filled width holds, or all of it where it is narrower.
  void join(Network& network) {
    if (place_.empty()) place_.assign(network.geometry().centre.size(), nothing);
    const auto domains = network.wet_domains();
    for (std::size_t d = stored_.size(); d < domains.size(); ++d) {
      place_[domains[d]] = static_cast<Index>(d);
      stored_.push_back(0);
      half_length_.push_back(0);
    }
    const auto wet = network.wet_channels();
    for (; seen_ < wet.size(); ++seen_) {
      const Index c = wet[seen_];
      const auto& [ends, measured] = network.geometry().channels[c];
      if (ends[0] == nothing || ends[1] == nothing) continue;  // on the rim: the run is at its end
      if (ends[0] == ends[1]) continue;  // leads nowhere, as beside a disc with a single contact
      const double length = without_last_digits(measured);
      channels_.push_back({c, place_[ends[0]], place_[ends[1]], length});
      const double filled = min(network.filled_width(c), network.width(c));
      network.set_filled_width(c, filled);
      for (const Index d : {channels_.back().first, channels_.back().second}) {
        stored_[d] += length * filled / 2;
        half_length_[d] += length / 2;
      }
    }
  }

  /// Finds the room of each domain, V_d, from the present widths.
  void find_room(const Network& network) { find_room(network, room_); }

  /// Shares out what is injected among the domains that receive it, which were wet first.
  /// @param volume that is injected, m2
  /// @param points how many domains these are
  void inject(double volume, std::size_t points) {
    rounded_off_.resize(points, 0);
    for (std::size_t d = 0; d < points; ++d) {
      // A small volume many times to a large one is rounded the same way many times.
      const double before = stored_[d];
      const double more = volume / static_cast<double>(points) + rounded_off_[d];
      stored_[d] += more;
      rounded_off_[d] = more - (stored_[d] - before);
    }
  }

  std::span<const WetChannel> channels() const { return channels_; }  ///< that are wet
  std::size_t size() const { return stored_.size(); }                 ///< number of wet domains
  std::span<double> stored() { return stored_; }                      ///< S, m2, one per wet domain
  std::span<const double> stored() const { return stored_; }          ///< S, m2, one per wet domain
  std::span<const double> room() const { return room_; }              ///< V_d, m2
  /// Half the length of the wet channels around each wet domain, m.
  std::span<const double> half_length() const { return half_length_; }

  /// The ledger, without channels that have turned wet since the last `join`.
  /// @param network with widths and pressures
  /// @param injected so far, m2
  /// @param law of the fluid
  /// @param floor the least pressure, Pa
  template <class Fluid>
  VolumeBalance balance(const Network& network, double injected, const Fluid& law,
                        double floor) const {
    VolumeBalance b{.injected = injected};
    for (const WetChannel& c : channels_) b.initial += c.length * network.filled_width(c.channel);
    std::vector<double> room;
    find_room(network, room);
    const auto domains = network.wet_domains();
    for (std::size_t d = 0; d < stored_.size(); ++d) {
      const double pressure = network.pressure(domains[d]);
      const double holds = room[d] * law.filling(pressure);
      b.stored += holds;
      const double excess = stored_[d] - holds;
      (excess < 0 && pressure <= floor ? b.empty -= excess : b.unmet += excess);
    }
    return b;
  }

  /// Everything: what is stored, and in which order domains turned wet.
  void exchange(auto& archive) {
    archive(place_, stored_, rounded_off_, room_, half_length_, channels_, seen_);
  }

 private:
  void find_room(const Network& network, std::vector<double>& room) const {
    room.assign(stored_.size(), 0);
    for (const auto& [c, first, second, length] : channels_) {
      const double half = length * network.width(c) / 2;
      room[first] += half;
      room[second] += half;
    }
  }

  /// Mirror images of a channel lie at other coordinates, from which its length was rounded.
  static double without_last_digits(double length) {
    constexpr double femtometres = 1e15;
    return std::round(length * femtometres) / femtometres;
  }

  std::vector<Index> place_;  // of each domain of the network among the wet ones
  std::vector<double> stored_, room_, half_length_;
  std::vector<double> rounded_off_;  // of each domain that receives the injection, m2
  std::vector<WetChannel> channels_;
  std::size_t seen_ = 0;  // of the network's wet channels
};

}  // namespace hfdem
