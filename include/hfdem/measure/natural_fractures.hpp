/// @file
/// What has become of natural fractures: how much of them broke, slid, opened and took up fluid
/// (the paper's Table 5 and its Figs. 14 and 15).
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <hfdem/state/contact.hpp>

namespace hfdem::measure {

/// Of one fracture, or of several. Slip is what friction keeps when the load goes, as the joints'
/// law remembers it, without its sign. Opening is how much farther the sides are apart than they
/// were bonded, zero where they are closer. Means are over the length that has broken.
struct FractureActivity {
  int broken = 0;               ///< contacts, that is microcracks
  int connected = 0;            ///< those that fluid reaches from the injection
  double length = 0;            ///< of the fracture, m
  double broken_length = 0;     ///< of the pieces for which the broken contacts stand, m
  double connected_length = 0;  ///< of those that fluid reaches, m
  double slip = 0;              ///< mean, m; zero if nothing has broken
  double opening = 0;           ///< mean, m; zero if nothing has broken
  double largest_slip = 0;      ///< m
  double largest_opening = 0;   ///< m

  /// Takes another one in.
  FractureActivity& operator+=(const FractureActivity& b) {
    const double both = broken_length + b.broken_length;
    if (both > 0) {
      slip = (slip * broken_length + b.slip * b.broken_length) / both;
      opening = (opening * broken_length + b.opening * b.broken_length) / both;
    }
    broken += b.broken;
    connected += b.connected;
    length += b.length;
    broken_length = both;
    connected_length += b.connected_length;
    largest_slip = std::fmax(largest_slip, b.largest_slip);
    largest_opening = std::fmax(largest_opening, b.largest_opening);
    return *this;
  }
};

/// Of each natural fracture, in their order.
template <class Sim>
std::vector<FractureActivity> fracture_activity(const Sim& sim) {
  const auto& joints = sim.joints();
  const auto& contacts = joints.contacts();
  std::vector<FractureActivity> all;
  for (const auto& fracture : joints.fractures()) all.push_back({.length = fracture.length()});
  for (const auto& b : sim.breaks()) {
    if (!sim.is_joint(b.contact)) continue;
    const auto k = b.contact - sim.contacts().size();
    const double length = joints.piece(k).length();
    const bool connected = sim.network().is_wet(b.contact);
    const double slip = std::abs(contacts.law().slip(contacts.memory(k)));
    const double opening = std::fmax(0, contacts.motion(k, sim.discs().displacement).opening);
    all[joints.pair(k).fracture] += {.broken = 1,
                                     .connected = connected ? 1 : 0,
                                     .broken_length = length,
                                     .connected_length = connected ? length : 0,
                                     .slip = slip,
                                     .opening = opening,
                                     .largest_slip = slip,
                                     .largest_opening = opening};
  }
  return all;
}

/// Of all fractures together.
inline FractureActivity total(std::span<const FractureActivity> each) {
  FractureActivity sum;
  for (const FractureActivity& one : each) sum += one;
  return sum;
}

}  // namespace hfdem::measure
