// The forces of a bonded assembly, written a second time and in the plainest way: every pair of
// discs is tried, forces are vectors at contact points, stresses are forces over areas. Of the
// library it uses the parameters, the specimen and the rows of motion; no formula.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <hfdem/base/pack.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/state/specimen.hpp>

namespace test {

struct Load {
  hfdem::Vec2 force;
  double torque = 0;
};

class Textbook {
 public:
  Textbook(const hfdem::Specimen& specimen, const hfdem::LinearParallelBond::Params& rock)
      : specimen_(specimen), rock_(rock) {
    for (hfdem::Index i = 0; i < specimen.size(); ++i)
      for (hfdem::Index j = i + 1; j < specimen.size(); ++j)
        if (distance(i, j) - specimen.radius[i] - specimen.radius[j] <= specimen.bonding_gap)
          contacts_.push_back(Contact{i, j});
  }

  std::size_t size() const { return contacts_.size(); }
  void break_bond(std::size_t c) { contacts_[c].bonded = false; }
  std::size_t slipped() const {
    return static_cast<std::size_t>(std::count_if(contacts_.begin(), contacts_.end(),
                                                  [](const Contact& c) { return c.offset != 0; }));
  }

  /// Forces and torques on the discs, then forces on the four platens. Slip is remembered.
  std::vector<Load> loads(std::span<const hfdem::Pack> moved) {
    std::vector<Load> result(specimen_.size() + 4);
    for (Contact& c : contacts_) {
      const Forces f = respond(c, moved);
      c.offset = f.offset;
      const hfdem::Vec2 at = point(c);
      add(result[c.j], f.on_second, cross(at - specimen_.centre[c.j], f.on_second) - f.moment);
      add(result[c.i], -f.on_second, cross(at - specimen_.centre[c.i], -f.on_second) + f.moment);
    }
    for (hfdem::Index i = 0; i < specimen_.size(); ++i) push_by_platens(i, moved, result);
    return result;
  }

  struct Strength {
    bool tension, shear;  // is exceeded
  };
  /// Which strengths of a contact's bond its present stresses exceed.
  Strength over_strength(std::size_t c, std::span<const hfdem::Pack> moved) const {
    if (!contacts_[c].bonded) return {false, false};
    const Forces f = respond(contacts_[c], moved);
    const double Rb = bond_radius(contacts_[c]), area = 2 * Rb, inertia = 2.0 / 3 * Rb * Rb * Rb;
    const double tension = -f.bond_normal / area;
    const double bending = std::fabs(f.moment) * Rb / inertia;
    const double friction =
        std::tan(rock_.friction_angle * std::numbers::pi / 180) * std::fmax(0, -tension);
    return {tension + rock_.moment_factor * bending > rock_.tensile_strength,
            std::fabs(f.bond_shear) / area > rock_.cohesion + friction};
  }

 private:
  struct Contact {
    hfdem::Index i, j;
    bool bonded = true;
    double offset = 0;  // shear force taken up by slip
  };
  struct Forces {
    hfdem::Vec2 on_second;
    double moment, bond_normal, bond_shear, offset;
  };

  double distance(hfdem::Index i, hfdem::Index j) const {
    return std::hypot(specimen_.centre[j].x - specimen_.centre[i].x,
                      specimen_.centre[j].y - specimen_.centre[i].y);
  }
  double bond_radius(const Contact& c) const {
    return std::fmin(specimen_.radius[c.i], specimen_.radius[c.j]);
  }
  hfdem::Vec2 normal(const Contact& c) const {
    return (1 / distance(c.i, c.j)) * (specimen_.centre[c.j] - specimen_.centre[c.i]);
  }
  /// In the middle of the gap or overlap.
  hfdem::Vec2 point(const Contact& c) const {
    const double R1 = specimen_.radius[c.i], R2 = specimen_.radius[c.j];
    const double gap = distance(c.i, c.j) - R1 - R2;
    return specimen_.centre[c.i] + (R1 + gap / 2) * normal(c);
  }

  /// How the point of a body moves.
  hfdem::Vec2 motion(hfdem::Index i, hfdem::Vec2 at, std::span<const hfdem::Pack> moved) const {
    const hfdem::Vec2 arm = at - specimen_.centre[i];
    return {moved[i][0] - moved[i][2] * arm.y, moved[i][1] + moved[i][2] * arm.x};
  }

  Forces respond(const Contact& c, std::span<const hfdem::Pack> moved) const {
    const hfdem::Vec2 n = normal(c), t{-n.y, n.x};
    const hfdem::Vec2 moves = motion(c.j, point(c), moved) - motion(c.i, point(c), moved);
    const double opening = dot(moves, n), shear = dot(moves, t);
    const double turn = moved[c.j][2] - moved[c.i][2];

    const double L = specimen_.radius[c.i] + specimen_.radius[c.j], Rb = bond_radius(c);
    const double k_n = 2 * Rb * rock_.E / L, k_s = k_n / rock_.stiffness_ratio;
    const double linear_normal = opening < 0 ? -k_n * opening : 0;
    const double trial = c.offset - k_s * shear;
    const double linear_shear =
        std::copysign(std::fmin(std::fabs(trial), rock_.friction * linear_normal), trial);

    const double per_area = c.bonded ? rock_.bond_E / L : 0;
    const double bond_normal = -per_area * 2 * Rb * opening;
    const double bond_shear = -per_area / rock_.bond_stiffness_ratio * 2 * Rb * shear;
    const double moment = per_area * (2.0 / 3 * Rb * Rb * Rb) * turn;
    return {(linear_normal + bond_normal) * n + (linear_shear + bond_shear) * t, moment,
            bond_normal, bond_shear, c.offset + linear_shear - trial};
  }

  /// A wall with twice the stiffness of the disc's contact with its like, and no tension.
  void push_by_platens(hfdem::Index i, std::span<const hfdem::Pack> moved,
                       std::vector<Load>& result) const {
    const double R = specimen_.radius[i], k = 2 * (rock_.E + rock_.bond_E);
    const hfdem::Vec2 at = specimen_.centre[i];
    const auto push = [&](std::size_t side, double gap, hfdem::Vec2 out) {
      if (gap > specimen_.bonding_gap) return;
      const std::size_t platen = specimen_.size() + side;
      const hfdem::Vec2 moves{moved[i][0] - moved[platen][0], moved[i][1] - moved[platen][1]};
      const double overlap = dot(moves, out);
      if (overlap <= 0) return;
      add(result[i], -(k * overlap) * out, 0);
      add(result[platen], k * overlap * out, 0);
    };
    push(0, at.x - R, {-1, 0});
    push(1, specimen_.width - at.x - R, {1, 0});
    push(2, at.y - R, {0, -1});
    push(3, specimen_.height - at.y - R, {0, 1});
  }

  static void add(Load& load, hfdem::Vec2 force, double torque) {
    load.force = load.force + force;
    load.torque += torque;
  }

  hfdem::Specimen specimen_;
  hfdem::LinearParallelBond::Params rock_;
  std::vector<Contact> contacts_;
};

}  // namespace test
