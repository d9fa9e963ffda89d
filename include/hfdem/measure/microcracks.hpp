/// @file
/// The broken bonds of a run as plain data, and how many there are of each kind.
///
/// A microcrack is as long as its bond was wide, 2 Rb, and lies across its contact; one in a
/// natural fracture is the piece of it for which its joint contact stands. It is connected if fluid
/// reaches it from the injection through other microcracks, and waits otherwise (the paper's Table
/// 5 and its Figs. 14 and 15).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <hfdem/measure/crack.hpp>
#include <hfdem/state/contact.hpp>

namespace hfdem::measure {

/// One broken bond.
struct Microcrack {
  Index contact = nothing;                        ///< also the index of its flow channel
  Facet facet{};                                  ///< its ends, m
  std::array<Index, 2> domain{nothing, nothing};  ///< that its channel joins
  std::optional<Mode> mode = std::nullopt;        ///< none for the preset crack: it was cut
  bool connected = false;                         ///< to the injection
  bool in_joint = false;                          ///< or in rock
  double aperture = 0, opening = 0;               ///< w and w - w0, m; zero while unconnected
  double pressure = 0;                            ///< mean of its domains, Pa

  double length() const { return norm(facet.to - facet.from); }  ///< m
  Vec2 middle() const { return 0.5 * (facet.from + facet.to); }  ///< m
};

/// Those of a run: first the preset crack, then in the order of breaking.
template <class Sim>
std::vector<Microcrack> microcracks(const Sim& sim) {
  const auto& network = sim.network();
  std::vector<Microcrack> all;
  const auto add = [&](Index c, std::optional<Mode> mode) {
    Microcrack m{.contact = c,
                 .facet = facet(sim, c),
                 .domain = network.geometry().channels[c].domain,
                 .mode = mode,
                 .connected = network.is_wet(c),
                 .in_joint = sim.is_joint(c)};
    if (m.connected) {
      m.aperture = network.width(c);
      m.opening = m.aperture - network.rest_width(c);
      int sides = 0;
      for (const Index d : m.domain)
        if (d != nothing) m.pressure += network.pressure(d), ++sides;
      m.pressure /= sides;
    }
    all.push_back(m);
  };
  for (const Index c : sim.preset_contacts()) add(c, std::nullopt);
  for (const auto& b : sim.breaks()) add(b.contact, b.mode);
  return all;
}

/// Microcracks of one place, by the way in which they came about.
struct MicrocrackCount {
  int tension = 0, shear = 0;  ///< broken in that mode
  int preset = 0;              ///< cut before the run
  double length = 0;           ///< of all of them, m

  int total() const { return tension + shear + preset; }  ///< of all kinds

  /// Counts one more.
  void add(const Microcrack& m) {
    ++(!m.mode ? preset : *m.mode == Mode::tension ? tension : shear);
    length += m.length();
  }
};

/// Microcracks by what fluid they see.
struct MicrocrackCounts {
  MicrocrackCount connected, unconnected;  ///< to the injection

  int total() const { return connected.total() + unconnected.total(); }  ///< with fluid or without
};

/// Counts the microcracks of a list that are wanted.
/// @param microcracks of a run
/// @param wanted answers true for those to count
template <class Wanted>
MicrocrackCounts count(std::span<const Microcrack> microcracks, Wanted&& wanted) {
  MicrocrackCounts counts;
  for (const Microcrack& m : microcracks)
    if (wanted(m)) (m.connected ? counts.connected : counts.unconnected).add(m);
  return counts;
}
/// Counts all microcracks of a list.
inline MicrocrackCounts count(std::span<const Microcrack> microcracks) {
  return count(microcracks, [](const Microcrack&) { return true; });
}

}  // namespace hfdem::measure
