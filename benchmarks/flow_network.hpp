/// @file
/// Cracks of any number of domains whose walls do not move: what is left of a fluid step is the
/// fluid's own part.
#pragma once

#include <cmath>
#include <utility>

#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/setup/flow_domains.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/state/network.hpp>
#include <hfdem/state/step.hpp>

namespace hfdem::benchmark_support {

/// Straight cracks side by side, of at most 10 000 domains each, joined by one across them in the
/// middle; every channel is one disc's diameter long.
/// @param domains how many, about; at least 3
/// @param radius of the discs, m
/// @param width of every channel, m
inline Network flow_network(int domains, double radius, double width) {
  constexpr int longest = 9999;
  const int cracks = (domains + longest - 1) / longest, columns = domains / cracks + 1;
  const Specimen array = square_array(columns, 2 * cracks, radius);
  const auto contacts = bonded_contacts<FixedPairs>(array);
  FlowDomains faces = flow_domains(array, contacts);
  const Index middle = injection_domains(faces, array, {}).front();
  const Vec2 centre = faces.centre[middle];
  const double diameter = 2 * radius;
  Network network(std::move(faces), {middle}, width);
  const auto in_rock = [&](Vec2 p) {
    const double rim = 0.75 * diameter;
    return p.x > rim && p.x < array.width - rim && p.y > rim && p.y < array.height - rim;
  };
  for (Index c = 0; c < contacts.size(); ++c) {
    const Vec2 a = array.centre[contacts[c].bodies.first];
    const Vec2 b = array.centre[contacts[c].bodies.second];
    const Vec2 between = 0.5 * (a + b);
    const bool upright = std::abs(b.x - a.x) < radius;  // a channel of a crack that lies
    const long row = std::lround(between.y / diameter);
    const bool across = !upright && std::abs(between.x - centre.x) < radius;
    if (in_rock(between) && ((upright && row % 2 == 1) || across)) network.open(c);
  }
  for (const Index c : network.wet_channels()) network.set_width(c, width);
  return network;
}

}  // namespace hfdem::benchmark_support
