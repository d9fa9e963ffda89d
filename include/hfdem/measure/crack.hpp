/// @file
/// What a fluid-driven crack looks like: tips, aperture at the injection, profile.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <hfdem/base/index.hpp>
#include <hfdem/base/vec2.hpp>

namespace hfdem::measure {

/// The wet crack at one instant. Lengths are measured along the preset crack's direction.
struct CrackShape {
  double tip_up = 0;    ///< distance of the tip above the injection (to its right, along x), m
  double tip_down = 0;  ///< distance of the other tip, m
  double aperture = 0;  ///< w at the injection, with w0, m
  double opening = 0;   ///< w - w0 at the injection, m

  double full_length() const { return tip_up + tip_down; }  ///< from tip to tip, m
};

/// One broken contact of the crack.
struct CrackPoint {
  double along;     ///< signed distance from the injection along the crack's direction, m
  Vec2 position;    ///< of the contact, m
  double aperture;  ///< w, m
  double opening;   ///< w - w0, m
  double pressure;  ///< mean of the two domains that it joins, Pa
};

/// The ends of a broken contact's facet: as long as the bond was wide, across the contact; of a
/// joint, the piece of its fracture that the contact stands for.
struct Facet {
  Vec2 from, to;  ///< m
};

/// The facet of a contact, at the place where it was bonded.
template <class Sim>
Facet facet(const Sim& sim, Index contact) {
  if (sim.is_joint(contact)) {
    const auto [from, to] = sim.joints().ends(contact - sim.contacts().size());
    return {from, to};
  }
  const auto& [bodies, f] = sim.contact_geometry(contact);
  const double half =
      std::fmin(sim.discs().radius[bodies.first], sim.discs().radius[bodies.second]);
  const Vec2 along = half * left_of(Vec2{f.normal_x, f.normal_y});
  const Vec2 point = sim.contact_point(contact);
  return {point - along, point + along};
}

/// Centre of the domain that receives the fluid, m.
template <class Sim>
Vec2 injection_point(const Sim& sim) {
  return sim.network().geometry().centre[sim.network().injection_domain()];
}

/// Tips, and the mean aperture of the wet channels at the injection domain.
template <class Sim>
CrackShape crack_shape(const Sim& sim) {
  const auto& network = sim.network();
  const Vec2 origin = injection_point(sim), direction = sim.crack_direction();
  CrackShape shape;
  for (const Index c : network.wet_channels()) {
    const auto [from, to] = facet(sim, c);
    const double a = dot(from - origin, direction), b = dot(to - origin, direction);
    shape.tip_up = std::max({shape.tip_up, a, b});
    shape.tip_down = std::max({shape.tip_down, -a, -b});
  }
  int count = 0;
  for (const Index c : network.channels_of(network.injection_domain())) {
    if (!network.is_wet(c)) continue;
    shape.aperture += network.width(c);
    shape.opening += network.width(c) - network.rest_width(c);
    ++count;
  }
  if (count > 0) shape.aperture /= count, shape.opening /= count;
  return shape;
}

/// The wet channels from one tip to the other.
template <class Sim>
std::vector<CrackPoint> crack_profile(const Sim& sim) {
  const auto& network = sim.network();
  const Vec2 origin = injection_point(sim), direction = sim.crack_direction();
  std::vector<CrackPoint> points;
  for (const Index c : network.wet_channels()) {
    const Vec2 position = sim.contact_point(c);
    double pressure = 0;
    int sides = 0;
    for (const Index d : network.geometry().channels[c].domain)
      if (d != nothing) pressure += network.pressure(d), ++sides;
    points.push_back({dot(position - origin, direction), position, network.width(c),
                      network.width(c) - network.rest_width(c), pressure / sides});
  }
  std::sort(points.begin(), points.end(),
            [](const CrackPoint& a, const CrackPoint& b) { return a.along < b.along; });
  return points;
}

/// Bonds that broke away from the preset crack's line, by more than their own width.
template <class Sim>
int broken_off_plane(const Sim& sim) {
  const Vec2 origin = injection_point(sim), direction = sim.crack_direction();
  int count = 0;
  for (const auto& b : sim.breaks()) {
    const double away = std::abs(cross(direction, sim.contact_point(b.contact) - origin));
    const auto bodies = sim.contact_geometry(b.contact).bodies;
    if (away > 0.5 * std::fmin(sim.discs().radius[bodies.first], sim.discs().radius[bodies.second]))
      ++count;
  }
  return count;
}

}  // namespace hfdem::measure
