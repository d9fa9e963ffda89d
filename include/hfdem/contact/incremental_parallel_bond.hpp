/// @file
/// Linear contact with a parallel bond, in incremental form: the bookkeeping of PFC2D, for
/// comparison with it.
///
/// Source: D. O. Potyondy, P. A. Cundall, "A bonded-particle model for rock", Int. J. Rock Mech.
/// Min. Sci. 41 (2004) 1329-1364, Section 2. Springs, strengths and slip are those of
/// `LinearParallelBond`; but every contact remembers its forces, and each step adds what the motion
/// since the last step changes. Only the normal force of the linear part follows from the overlap.
/// Both forms have the same forces to round-off; this one remembers seven numbers per contact,
/// which change in every step, where the other has one, which changes with slip.
#pragma once

#include <hfdem/contact/linear_parallel_bond.hpp>

namespace hfdem {

/// A `ContactLaw`: that of `LinearParallelBond`, step by step.
class IncrementalParallelBond : public LinearParallelBond {
 public:
  /// What evolves per contact.
  template <class T>
  struct Memory {
    T opening, shear, rotation;              ///< motion at the last step
    T linear_shear;                          ///< shear force of the linear part, N per m
    T bond_normal, bond_shear, bond_moment;  ///< of the bond, N per m (moment: N m per m)
  };

  /// Forces of both parts, N per m (moment: N m per m); compression positive.
  template <class T>
  struct Response : LinearParallelBond::Response<T> {
    Memory<T> memory;  ///< after this motion
  };

  /// @param p validated parameters
  explicit IncrementalParallelBond(const Params& p) : LinearParallelBond(p) {}

  /// The forces of the last step, changed by what has moved since; then slip is cut off.
  template <class T>
  Response<T> respond(const Stiffness<T>& k, const Memory<T>& last,
                      const Motion<T>& motion) const noexcept {
    const T closed = last.opening - motion.opening, slid = motion.shear - last.shear;
    const T normal = max(T{}, -(k.normal * motion.opening));
    const T limit = friction_ * normal;
    // Nothing is left of what a bond bore when it broke.
    const auto left = [&](const T& force) -> T { return k.bond > T{} ? force : T{}; };
    Response<T> r{};
    r.linear_normal = normal;
    r.linear_shear =
        clamp(last.linear_shear - (k.normal * shear_per_normal_) * slid, T(-limit), limit);
    r.bond_normal = left(last.bond_normal + k.bond * closed);
    r.bond_shear = left(last.bond_shear - (k.bond * bond_shear_per_normal_) * slid);
    r.bond_moment =
        left(last.bond_moment + bond_moment_stiffness(k) * (motion.rotation - last.rotation));
    r.memory = {motion.opening, motion.shear, motion.rotation, r.linear_shear,
                r.bond_normal,  r.bond_shear, r.bond_moment};
    return r;
  }

  /// As of the total form: what the forces change by is the same (see `ForeseesFailure`).
  template <class T>
  T margin(const Stiffness<T>& k, const Response<T>& r) const noexcept {
    return LinearParallelBond::margin(k, r);
  }

  /// What both parts store at this motion, J per m.
  template <class T>
  T energy(const Stiffness<T>& k, const Memory<T>& last, const Motion<T>& motion) const noexcept {
    const auto r = respond(k, last, motion);
    const T shear_stiffness = k.normal * shear_per_normal_;
    const T offset = r.linear_shear + shear_stiffness * motion.shear;
    return LinearParallelBond::energy(k, {offset}, motion);
  }
};

}  // namespace hfdem
