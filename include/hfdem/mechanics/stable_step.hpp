/// @file
/// How long a mechanical step may be, and how an elastic assembly answers a change of stress.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include <hfdem/state/contact.hpp>
#include <hfdem/state/discs.hpp>

namespace hfdem {

/// Upper bound on the largest natural frequency of the assembly, 1/s.
///
/// Gershgorin's theorem on the stiffness matrix over the mass, disc by disc. Rotations are measured
/// as radius * rotation / 2.5, a scale that makes the bound tight (10 % on the default square
/// array).
class FrequencyBound {
 public:
  /// @param discs must outlive the bound
  explicit FrequencyBound(const Discs& discs) : discs_(discs), rows_(discs.size()) {}

  /// Adds a contact with its stiffest springs.
  void add(const ContactGeometry& contact, const Springs& k) {
    const Frame<double>& f = contact.frame;
    add_side(contact.bodies.first, f, k, f.arm_mean - f.arm_half_difference, contact.bodies.second);
    add_side(contact.bodies.second, f, k, f.arm_mean + f.arm_half_difference, contact.bodies.first);
  }

  /// The bound for the contacts added so far, 1/s.
  double value() const {
    double largest = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Row& r = rows_[i];
      const double scale = rotation_scale / discs_.radius[i];
      const double rotation = r.rotation + r.rotation_others +
                              (std::abs(r.x_rotation) + std::abs(r.y_rotation)) / scale;
      largest = std::fmax(largest, translation(i) / discs_.mass[i]);
      largest = std::fmax(largest, rotation / discs_.inertia(i));
    }
    return std::sqrt(largest);
  }

  /// What the bound has for a disc's two translations, N/m per m.
  double translation(std::size_t disc) const {
    const Row& r = rows_[disc];
    const double scale = rotation_scale / discs_.radius[disc];
    return std::fmax(r.xx + r.x_others + scale * std::abs(r.x_rotation),
                     r.yy + r.y_others + scale * std::abs(r.y_rotation));
  }

 private:
  static constexpr double rotation_scale = 2.5;
  /// The disc's own stiffness terms, and the sums of the sizes of all others in its rows, rotations
  /// scaled.
  struct Row {
    double xx = 0, yy = 0, rotation = 0, x_rotation = 0, y_rotation = 0;
    double x_others = 0, y_others = 0, rotation_others = 0;
  };

  void add_side(Index body, const Frame<double>& f, const Springs& k, double arm, Index other) {
    if (body >= rows_.size()) return;  // a platen
    const double nx = f.normal_x, ny = f.normal_y;
    const double xx = k.normal * nx * nx + k.shear * ny * ny;
    const double yy = k.normal * ny * ny + k.shear * nx * nx;
    const double xy = std::abs((k.normal - k.shear) * nx * ny);
    Row& r = rows_[body];
    r.xx += xx;
    r.yy += yy;
    r.rotation += k.shear * arm * arm + k.moment;
    const double out = body < other ? 1 : -1;  // the normal points away from the first body
    r.x_rotation += out * k.shear * arm * ny;
    r.y_rotation += out * k.shear * arm * nx;
    r.x_others += xy;
    r.y_others += xy;
    if (other >= rows_.size()) return;
    const double other_arm = 2 * f.arm_mean - arm;
    const double scale = rotation_scale / discs_.radius[body];
    const double other_scale = rotation_scale / discs_.radius[other];
    r.x_others += xx + xy + other_scale * k.shear * other_arm * std::abs(ny);
    r.y_others += yy + xy + other_scale * k.shear * other_arm * std::abs(nx);
    r.rotation_others += std::abs(k.shear * arm * other_arm - k.moment) * other_scale / scale +
                         k.shear * arm * (std::abs(nx) + std::abs(ny)) / scale;
  }

  const Discs& discs_;
  std::vector<Row> rows_;
};

/// The same bound with normal springs that come and go: those of a fluid between discs.
class SpringBound {
 public:
  SpringBound() = default;
  /// @param contacts the bound without such springs
  /// @param discs of which it is
  SpringBound(const FrequencyBound& contacts, const Discs& discs)
      : without_(contacts.value()), added_(discs.size()) {
    for (std::size_t i = 0; i < discs.size(); ++i) translation_.push_back(contacts.translation(i));
  }

  /// Adds a spring, N/m per m.
  void add(const ContactGeometry& contact, double stiffness) {
    const double x = std::abs(contact.frame.normal_x), y = std::abs(contact.frame.normal_y);
    for (const Index disc : {contact.bodies.first, contact.bodies.second}) {
      if (added_[disc].x == 0 && added_[disc].y == 0) touched_.push_back(disc);
      added_[disc] = added_[disc] + 2 * stiffness * (x + y) * Vec2{x, y};
    }
  }

  /// The bound for the springs added since the last call, 1/s; forgets them.
  double take(const Discs& discs) {
    double largest = without_ * without_;
    for (const Index i : touched_) {
      const double added = std::fmax(added_[i].x, added_[i].y);
      largest = std::fmax(largest, (translation_[i] + added) / discs.mass[i]);
      added_[i] = {};
    }
    touched_.clear();
    return std::sqrt(largest);
  }

 private:
  double without_ = 0;
  std::vector<double> translation_;
  std::vector<Vec2> added_;
  std::vector<Index> touched_;
};

/// Longest stable step of central differences with local damping, s: 2 / (w sqrt(1 + d)).
/// Local damping eats stability; above the limit the settled state is wrong long before it is NaN.
inline double stable_step(double largest_frequency, double damping) {
  return 2 / (largest_frequency * std::sqrt(1 + damping));
}

}  // namespace hfdem
