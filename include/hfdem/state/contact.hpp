/// @file
/// The vocabulary of a contact: what moves, what answers, what fails. All are templates on the
/// value type, so one formula serves a single contact (`double`) and four at once (`Pack`).
#pragma once

#include <compare>

#include <hfdem/base/index.hpp>
#include <hfdem/base/pack.hpp>
#include <hfdem/base/vec2.hpp>

namespace hfdem {

/// A disc as a contact law sees it: radius in m.
struct Disc {
  double radius;  ///< m
};

/// Two discs that may be in contact, first < second.
struct Pair {
  Index first, second;  ///< bodies, as `Discs` counts them
  friend constexpr auto operator<=>(const Pair&, const Pair&) = default;
};

/// Relative motion of the two sides of a contact since the specimen was bonded.
template <class T>
struct Motion {
  T opening{};   ///< along the normal, m; positive when the gap grows
  T shear{};     ///< of the second side along the tangent (normal turned left), m
  T rotation{};  ///< of the second disc relative to the first, rad
};

/// What a contact does to its two sides.
template <class T>
struct Reaction {
  T normal;  ///< N per m of thickness; positive pushes the sides apart (compression)
  T shear;   ///< on the second side along the tangent, N per m
  T moment;  ///< that resists relative rotation, N m per m; acts as -moment on the second disc
};

/// For laws that remember nothing, whose response is their reaction: derive from it instead of
/// writing `Memory` and `Response`.
struct WithoutMemory {
  template <class T>
  struct Memory {};  ///< nothing evolves

  /// What a motion without history leads to.
  template <class T>
  struct Response {
    Reaction<T> force;                              ///< on the two sides
    Memory<T> memory{};                             ///< as before
    Reaction<T> reaction() const { return force; }  ///< the force
  };
};

/// The bonds that are over their strength, by mode (a bond over both breaks in tension).
template <class T>
struct Failure {
  MaskOf<T> tension;  ///< over the tensile strength
  MaskOf<T> shear;    ///< over the shear strength
};

/// How a bond broke.
enum class Mode { tension, shear };

/// The stiffest tangent springs that a contact can have, N/m per m of thickness (`moment`: N m).
/// They set the stable time step, the stiffness of platens and the first guess of a load step.
struct Springs {
  double normal = 0, shear = 0, moment = 0;  ///< per m of displacement, or per rad
};

/// Geometry of contacts, fixed at bonding (small strain).
///
/// A body's row holds (x, y, rotation, rotation). The *difference row* of a contact is
/// (dx, dy, rotation difference, rotation sum) = second + of_first * first, and its *force row* is
/// dual to it: the first body receives of_first times it, and the torque is the sum of the last two
/// lanes.
/// @tparam T value type
template <class T>
struct Frame {
  T normal_x, normal_y;   ///< unit vector from the first to the second side
  T arm_mean;             ///< mean distance from the discs' centres to the contact point, m
  T arm_half_difference;  ///< (second arm - first arm) / 2, m

  /// The relative motion from the four lanes of a difference row.
  Motion<T> motion(const T& dx, const T& dy, const T& rotation, const T& rotation_sum) const {
    return {.opening = dx * normal_x + dy * normal_y,
            .shear = (dy * normal_x - dx * normal_y) -
                     (arm_mean * rotation_sum + arm_half_difference * rotation),
            .rotation = rotation};
  }

  /// The four lanes of the force row on the second body.
  void force(const Reaction<T>& r, T& x, T& y, T& torque_difference, T& torque_sum) const {
    x = r.normal * normal_x - r.shear * normal_y;
    y = r.normal * normal_y + r.shear * normal_x;
    torque_difference = -(arm_half_difference * r.shear + r.moment);
    torque_sum = -(arm_mean * r.shear);
  }
};

/// A contact as it is set up: its two bodies and the geometry between them.
struct ContactGeometry {
  Pair bodies;          ///< two discs, or a disc and a platen
  Frame<double> frame;  ///< normal and arms at bonding
};

/// The signs with which a contact sees the row of its first body, and that body the contact's.
inline constexpr Pack of_first{-1, -1, -1, 1};

/// The difference row of two bodies' rows, m and rad.
inline Pack difference_row(const Pack& first, const Pack& second) {
  return plus_signed(second, of_first, first);
}

}  // namespace hfdem
