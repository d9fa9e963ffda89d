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
/// as arm * rotation / 2.5, a scale that makes the bound tight (within 10 % on the square array).
class FrequencyBound {
 public:
  explicit FrequencyBound(const Discs& discs) : discs_(discs), rows_(discs.size()) {}

  void add(const ContactGeometry& contact, const Springs& k) {
    const Frame<double>& f = contact.frame;
    add_side(contact.bodies.first, f, k, f.arm_mean - f.arm_half_difference, contact.bodies.second);
    add_side(contact.bodies.second, f, k, f.arm_mean + f.arm_half_difference, contact.bodies.first);
  }

  double value() const {
    double largest = 0;
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Row& r = rows_[i];
      const double coupling = rotation_scale / discs_.radius[i];
      const double x = (r.xx + r.off_x + coupling * (std::abs(r.x_rotation) + r.off_x_rotation));
      const double y = (r.yy + r.off_y + coupling * (std::abs(r.y_rotation) + r.off_y_rotation));
      const double rotation =
          r.rotation + r.off_rotation +
          (std::abs(r.x_rotation) + std::abs(r.y_rotation) + r.off_x_rotation + r.off_y_rotation) /
              coupling;
      largest = std::fmax(largest, std::fmax(x, y) / discs_.mass[i]);
      largest = std::fmax(largest, rotation / discs_.inertia(i));
    }
    return std::sqrt(largest);
  }

 private:
  static constexpr double rotation_scale = 2.5;
  /// The disc's own stiffness terms, and the sums of the sizes of its neighbours' terms.
  struct Row {
    double xx = 0, yy = 0, rotation = 0, x_rotation = 0, y_rotation = 0;
    double off_x = 0, off_y = 0, off_rotation = 0, off_x_rotation = 0, off_y_rotation = 0;
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
    r.off_x += xy;  // own coupling of x and y, bounded by the sum of its sizes
    r.off_y += xy;
    const double out = body < other ? 1 : -1;  // the normal points away from the first body
    r.x_rotation += out * k.shear * arm * ny;
    r.y_rotation += out * k.shear * arm * nx;
    if (other >= rows_.size()) return;
    const double other_arm = 2 * f.arm_mean - arm;
    r.off_x += xx + xy;
    r.off_y += yy + xy;
    r.off_rotation += std::abs(k.shear * arm * other_arm - k.moment);
    r.off_x_rotation += k.shear * arm * std::abs(ny);
    r.off_y_rotation += k.shear * arm * std::abs(nx);
  }

  const Discs& discs_;
  std::vector<Row> rows_;
};

/// Longest stable step of central differences with local damping, s: 2 / (w sqrt(1 + d)).
/// Local damping eats stability; above the limit the settled state is wrong long before it is NaN.
inline double stable_step(double largest_frequency, double damping) {
  return 2 / (largest_frequency * std::sqrt(1 + damping));
}

}  // namespace hfdem
