/// @file
/// The stress tensor of every disc.
///
/// By the divergence theorem, what a body in equilibrium carries is the sum over its boundary of
/// place times force: sigma_ij = -(1/A) sum x_i f_j, compression positive, x measured from the
/// disc's centre. The body here is a disc's cell, which is bounded by its contact points and the
/// centres of the flow domains around it: contact forces act at the contact points, platens and
/// dead loads where the disc touches the side, and the fluid of wet domains along the cell's edge.
/// So this is a total stress; of a specimen in equilibrium, the mean over all cells is the stress
/// on its sides, whatever the pressure in its crack.
///
/// A is the disc's share of the specimen, pi R^2 / (1 - n) with the porosity n of the whole: the
/// porosity correction with which D. O. Potyondy, P. A. Cundall, Int. J. Rock Mech. Min. Sci. 41
/// (2004) 1329-1364, average over measurement regions. In a square array it is the cell, (2 R)^2.
#pragma once

#include <cmath>
#include <vector>

#include <hfdem/base/vec2.hpp>
#include <hfdem/state/contact.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem::measure {

/// A stress in the plane, Pa, compression positive. The symmetric part: bond moments make the rest.
struct StressTensor {
  double xx = 0, yy = 0, xy = 0;  ///< Pa

  /// The greater principal stress, Pa.
  double major() const { return (xx + yy) / 2 + std::hypot((xx - yy) / 2, xy); }
  /// The smaller principal stress in the plane, Pa.
  double minor() const { return (xx + yy) / 2 - std::hypot((xx - yy) / 2, xy); }
};

/// The part of the specimen that counts as a disc's, m2; all sum up to its area.
class CellArea {
 public:
  /// @param specimen whose area is shared out
  explicit CellArea(const Specimen& specimen) {
    double squares = 0;
    for (const double r : specimen.radius) squares += r * r;
    per_square_ = specimen.width * specimen.height / squares;
  }
  /// Of a disc of this radius, m2.
  double operator()(double radius) const { return per_square_ * radius * radius; }

 private:
  double per_square_;
};

/// One tensor per disc, from the forces of the last mechanical step and the present pressures.
template <class Sim>
std::vector<StressTensor> particle_stress(const Sim& sim) {
  const auto& discs = sim.discs();
  const auto& rock = sim.contacts();
  const auto& network = sim.network();
  std::vector<StressTensor> stress(discs.size());
  const auto add = [&](Index disc, Vec2 arm, Vec2 force) {
    StressTensor& s = stress[disc];
    s.xx -= arm.x * force.x;
    s.yy -= arm.y * force.y;
    s.xy -= (arm.x * force.y + arm.y * force.x) / 2;
  };
  const auto force_on_second = [&](std::size_t row) {
    const Pack& force = sim.forces().rows()[row];
    return Vec2{force[0], force[1]};
  };

  for (Index c = 0; c < rock.size(); ++c) {
    const auto [first, second] = rock.bodies(c);
    const Vec2 point = sim.contact_point(c), force = force_on_second(rock.first_row() + c);
    add(first, point - discs.centre[first], -force);
    add(second, point - discs.centre[second], force);
  }

  for (std::size_t k = 0; k < sim.joints().size(); ++k) {
    const auto [first, second] = sim.joints().pair(k).bodies;
    const Vec2 point = sim.joints().crossing(k);
    const Vec2 force = force_on_second(sim.joints().contacts().first_row() + k);
    add(first, point - discs.centre[first], -force);
    add(second, point - discs.centre[second], force);
  }

  std::size_t row = sim.platens().first_row();
  for (const auto& [bodies, f] : sim.platen_geometry())
    add(bodies.first, discs.radius[bodies.first] * Vec2{f.normal_x, f.normal_y},
        -force_on_second(row++));

  for (const Index domain : network.wet_domains()) {
    // Both run around the domain counter-clockwise: disc k lies between contacts k - 1 and k.
    const auto around = network.discs_of(domain), contacts = network.channels_of(domain);
    const Vec2 middle = network.geometry().centre[domain];
    Vec2 before = sim.contact_point(contacts.back());
    for (std::size_t k = 0; k < around.size(); ++k) {
      const Vec2 after = sim.contact_point(contacts[k]), centre = discs.centre[around[k]];
      const auto press = [&](Vec2 from, Vec2 to) {
        add(around[k], 0.5 * (from + to) - centre, network.pressure(domain) * left_of(from - to));
      };
      press(before, middle);
      press(middle, after);
      before = after;
    }
  }

  const CellArea area(sim.specimen());
  for (Index i = 0; i < discs.size(); ++i) {
    const double r = discs.radius[i], a = area(r);
    // A dead load presses inwards from the side that it acts on.
    const Vec2 load = sim.loading().dead_load(i);
    stress[i] = {(stress[i].xx + r * std::abs(load.x)) / a,
                 (stress[i].yy + r * std::abs(load.y)) / a, stress[i].xy / a};
  }
  return stress;
}

}  // namespace hfdem::measure
