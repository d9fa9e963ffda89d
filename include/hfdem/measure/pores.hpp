/// @file
/// The pores of a rock that leaks: their pressures, and how full they are (the paper's Fig. 17b).
#pragma once

#include <vector>

#include <hfdem/state/concepts.hpp>
#include <hfdem/state/network.hpp>

namespace hfdem::measure {

/// A domain of the network.
struct Pore {
  Index domain = nothing;       ///< its number
  Vec2 centre{};                ///< m
  std::vector<Vec2> corners{};  ///< centres of the discs around it, counter-clockwise, m
  double pressure = 0;          ///< Pa
  double filling = 0;           ///< part of it that is full
  bool in_crack = false;        ///< whether the crack has reached it
};

/// All domains, in the order of their numbers.
/// @tparam Sim a `Simulator` whose scheme flows through the rock
template <class Sim>
std::vector<Pore> pores(const Sim& sim) {
  const Network& network = sim.network();
  std::vector<Pore> all(network.pressures().size());
  for (Index d = 0; d < all.size(); ++d) {
    all[d] = {.domain = d,
              .centre = network.geometry().centre[d],
              .pressure = network.pressure(d),
              .filling = sim.pressure_scheme().leakoff().filling(network, d)};
    for (const Index disc : network.discs_of(d))
      all[d].corners.push_back(sim.specimen().centre[disc]);
  }
  for (const Index d : network.wet_domains()) all[d].in_crack = true;
  return all;
}

}  // namespace hfdem::measure
