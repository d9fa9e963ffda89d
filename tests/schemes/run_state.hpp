// All that can be read of a run and changes, as bits; through its own functions, not the archive.
#pragma once

#include <cstdint>
#include <vector>

#include <hfdem/contact/jointed.hpp>
#include <hfdem/mechanics/joint_contacts.hpp>

#include "near.hpp"

namespace test {

using Words = std::vector<std::uint64_t>;

inline void put(Words& words, double value) { words.push_back(bits(value)); }
inline void put(Words& words, hfdem::Vec2 v) { put(words, v.x), put(words, v.y); }
inline void put(Words& words, const hfdem::Pack& row) {
  for (std::size_t lane = 0; lane < 4; ++lane) put(words, row[lane]);
}

/// Joints that discs may have met across, with their pieces and their slip.
template <class Law>
void put(Words& words, const hfdem::JointContacts<Law>& joints) {
  for (std::size_t k = 0; k < joints.size(); ++k) {
    words.push_back(joints.has_met(k) ? 1 : 0);
    put(words, joints.piece(k).begin);
    put(words, joints.piece(k).end);
    const auto stiffness = joints.contacts().stiffness(k);
    const auto memory = joints.contacts().memory(k);
    for (const double v : {stiffness.length, stiffness.bond, memory.slip, memory.dilation})
      put(words, v);
  }
}
inline void put(Words&, const hfdem::JointContacts<hfdem::NoJoint>&) {}

/// The present state.
template <class Sim>
Words state(const Sim& sim) {
  Words words;
  for (const hfdem::Pack& row : sim.discs().displacement) put(words, row);
  for (const hfdem::Pack& row : sim.discs().velocity) put(words, row);
  for (const hfdem::Vec2 load : sim.discs().load) put(words, load);
  for (const hfdem::Pack& row : sim.forces().rows()) put(words, row);
  for (std::size_t c = 0; c < sim.contacts().size(); ++c) {
    const auto k = sim.contacts().stiffness(c);
    for (const double v : {k.normal, k.bond, k.bond_radius}) put(words, v);
    put(words, sim.contacts().memory(c).shear_offset);
  }
  put(words, sim.joints());
  const hfdem::Network& network = sim.network();
  for (hfdem::Index c = 0; c < network.geometry().channels.size(); ++c) {
    put(words, network.width(c));
    put(words, network.filled_width(c));
    words.push_back(network.is_open(c) ? 1 : 0);
    words.push_back(network.is_wet(c) ? 1 : 0);
  }
  for (const double p : network.pressures()) put(words, p);
  for (const auto list : {network.wet_channels(), network.wet_domains(), network.pushed_discs()})
    words.insert(words.end(), list.begin(), list.end());
  words.push_back(network.reached_rim() ? 1 : 0);
  for (const auto& b : sim.breaks()) {
    put(words, b.time);
    put(words, b.pressure);
    words.push_back(b.contact);
    words.push_back(static_cast<std::uint64_t>(b.mode));
  }
  put(words, sim.loading().stress().xx);
  put(words, sim.loading().stress().yy);
  for (hfdem::Index i = 0; i < sim.discs().size(); ++i) put(words, sim.loading().dead_load(i));
  for (const double v : {sim.time(), sim.injected_volume(), sim.mean_contact_force()})
    put(words, v);
  for (const long count : {sim.mechanical_steps(), sim.settling_steps(), sim.fluid_steps()})
    words.push_back(static_cast<std::uint64_t>(count));
  return words;
}

}  // namespace test
