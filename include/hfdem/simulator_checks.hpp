/// @file
/// What a simulator refuses when it is made, and what ends its run.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/fields.hpp>
#include <hfdem/setup/preset_crack.hpp>
#include <hfdem/state/contact.hpp>
#include <hfdem/state/network.hpp>
#include <hfdem/state/volume_balance.hpp>

namespace hfdem::detail {

/// A crack that cuts no contact at an injection point: the fluid has nowhere to go.
inline void refuse_short_crack(const Network& network, const PresetCrack& crack) {
  const auto has_crack = [&](Index domain) {
    const auto channels = network.channels_of(domain);
    return std::any_of(channels.begin(), channels.end(),
                       [&](Index c) { return network.is_wet(c); });
  };
  const auto domains = network.injection_domains();
  if (std::all_of(domains.begin(), domains.end(), has_crack)) return;
  if (crack.length)
    refuse("crack", "length", to_text(*crack.length) + " m",
           "long enough to cut a contact: the fluid needs a crack to enter");
  refuse("crack", "contacts", "0", "at least 1: the fluid needs a crack to enter");
}

/// The preset cracks and the domains that receive the fluid are to be in rock.
template <class Assembly>
void keep_joints_away(const Assembly& assembly, const Network& network,
                      std::span<const Index> preset) {
  const auto check = [&](Index contact, const char* allowed) {
    if (assembly.is_joint(contact))
      assembly.joints().refuse(contact - assembly.contacts().size(), allowed);
  };
  for (const Index c : preset) check(c, "away from the preset crack");
  for (const Index d : network.injection_domains())
    for (const Index c : network.channels_of(d)) check(c, "away from the injection");
}

/// The network has no outside that fluid could flow to.
inline void stop_at_rim(const Network& network, double time) {
  if (network.reached_rim())
    throw ReachedRim("the crack reached the rim of the specimen at t = " + in_words(time) +
                     " s: the fluid would leave it there");
}

inline void stop_unless_finite(double force, double time) {
  if (!std::isfinite(force))
    throw RunStopped("a force is not a finite number at t = " + in_words(time) +
                     " s: the mechanical step is unstable, or the specimen has come apart");
}

/// A scheme that loses fluid, or makes it.
inline void stop_unless_balanced(const VolumeBalance& balance, double time) {
  constexpr double round_off = 1e-10;
  if (!(balance.relative_error() <= round_off))
    throw RunStopped("the volumes of the fluid do not balance at t = " + in_words(time) + " s: " +
                     in_words(100 * balance.relative_error()) + " % of what came in is missing");
}

}  // namespace hfdem::detail
