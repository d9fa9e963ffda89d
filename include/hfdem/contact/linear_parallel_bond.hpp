/// @file
/// Linear contact with a parallel bond, in total form.
///
/// Source: D. O. Potyondy, P. A. Cundall, "A bonded-particle model for rock", Int. J. Rock Mech.
/// Min. Sci. 41 (2004) 1329-1364; the plane form of PFC2D. Per metre of thickness, for discs of
/// radii R1, R2: L = R1 + R2, Rb = min(R1, R2), area A = 2 Rb, inertia I = (2/3) Rb^3.
///
///   linear part   k_n = A E / L, k_s = k_n / ratio; no tension; shear slips at friction * normal
///   bond          per area E_b / L and (E_b / L) / ratio; tension, compression, shear and moment
///   breaks        in tension at  F / A + beta |M| Rb / I > tensile strength      (F tension)
///                 in shear at    |S| / A > cohesion + compressive stress * tan(friction angle)
///
/// Total form: every force follows from the displacement since bonding; the one thing remembered is
/// the shear offset that carries slip (return mapping). It writes nothing while nothing slips.
#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include <hfdem/base/fields.hpp>
#include <hfdem/base/pack.hpp>
#include <hfdem/state/contact.hpp>

namespace hfdem {

/// A `ContactLaw`: an elastic, frictional contact and a bond beside it, both linear.
class LinearParallelBond {
 public:
  /// Micro-parameters; the defaults are those of the paper's Table 3.
  struct Params {
    double E = 17e9;
    double stiffness_ratio = 2.5;
    double friction = 0.5;
    double bond_E = 17e9;
    double bond_stiffness_ratio = 2.5;
    double tensile_strength = 8e6;
    double cohesion = 15e6;
    double friction_angle = 30;
    double moment_factor = 1;

    static constexpr auto fields() {
      using P = Params;
      return std::tuple{
          Field{"E", &P::E, "Pa", positive, "Young's modulus of the particle"},
          Field{"stiffness_ratio", &P::stiffness_ratio, "", positive,
                "normal to shear stiffness of the particle"},
          Field{"friction", &P::friction, "", non_negative, "friction coefficient of the particle"},
          Field{"bond_E", &P::bond_E, "Pa", non_negative, "Young's modulus of the parallel bond"},
          Field{"bond_stiffness_ratio", &P::bond_stiffness_ratio, "", positive,
                "normal to shear stiffness of the parallel bond"},
          Field{"tensile_strength", &P::tensile_strength, "Pa", non_negative,
                "tensile strength of the parallel bond"},
          Field{"cohesion", &P::cohesion, "Pa", non_negative, "cohesion of the parallel bond"},
          Field{"friction_angle", &P::friction_angle, "deg", Range{0, 90, false, true},
                "friction angle of the parallel bond"},
          Field{"moment_factor", &P::moment_factor, "", Range{0, 1},
                "part of the bond's moment that counts in its tensile stress (beta)"}};
    }
  };

  /// What is fixed per contact.
  template <class T>
  struct Stiffness {
    T normal;       ///< linear part, N/m per m
    T bond;         ///< bond, N/m per m; zero once broken
    T bond_radius;  ///< Rb, m
  };

  /// What evolves per contact.
  template <class T>
  struct Memory {
    T shear_offset;  ///< shear force of the linear part that slip has taken up, N per m
  };

  /// Forces of both parts, N per m (moment: N m per m); compression positive.
  template <class T>
  struct Response {
    T linear_normal, linear_shear;           ///< of the linear part; no tension
    T bond_normal, bond_shear, bond_moment;  ///< of the bond
    Memory<T> memory;                        ///< after this motion

    /// Both parts together.
    Reaction<T> reaction() const {
      return {linear_normal + bond_normal, linear_shear + bond_shear, bond_moment};
    }
  };

  /// @param p validated parameters
  explicit LinearParallelBond(const Params& p)
      : shear_per_normal_(1 / p.stiffness_ratio),
        bond_shear_per_normal_(1 / p.bond_stiffness_ratio),
        friction_(p.friction),
        E_(p.E),
        bond_E_(p.bond_E),
        twice_tensile_strength_(2 * p.tensile_strength),
        twice_cohesion_(2 * p.cohesion),
        tan_friction_angle_(std::tan(p.friction_angle * std::numbers::pi / 180)),
        thrice_moment_factor_(3 * p.moment_factor) {}

  /// Of a new contact, its bond intact.
  Stiffness<double> stiffness(Disc a, Disc b) const noexcept {
    const double length = a.radius + b.radius, bond_radius = std::fmin(a.radius, b.radius);
    const double slenderness = 2 * bond_radius / length;
    return {slenderness * E_, slenderness * bond_E_, bond_radius};
  }

  /// What is left of a contact whose bond has broken.
  Stiffness<double> broken(const Stiffness<double>& k) const noexcept {
    return {k.normal, 0, k.bond_radius};
  }

  /// Both parts together; what slips or opens is softer.
  Springs springs(const Stiffness<double>& k) const noexcept {
    return {k.normal + k.bond, k.normal * shear_per_normal_ + k.bond * bond_shear_per_normal_,
            k.bond * k.bond_radius * k.bond_radius / 3};
  }

  /// The forces that follow from the displacement since bonding, after return mapping of slip.
  template <class T>
  Response<T> respond(const Stiffness<T>& k, const Memory<T>& memory,
                      const Motion<T>& motion) const noexcept {
    const T closing = -motion.opening;
    const T normal = max(T{}, k.normal * closing);
    const T elastic = memory.shear_offset - (k.normal * shear_per_normal_) * motion.shear;
    const T limit = friction_ * normal;
    const T shear = clamp(elastic, T(-limit), limit);
    return {.linear_normal = normal,
            .linear_shear = shear,
            .bond_normal = k.bond * closing,
            .bond_shear = -((k.bond * bond_shear_per_normal_) * motion.shear),
            .bond_moment = bond_moment_stiffness(k) * motion.rotation,
            .memory = {memory.shear_offset + (shear - elastic)}};
  }

  /// What both parts store at this motion, J per m; slip has taken up `memory`.
  template <class T>
  T energy(const Stiffness<T>& k, const Memory<T>& memory, const Motion<T>& motion) const noexcept {
    const T closing = max(T{}, -motion.opening);
    const T shear_stiffness = k.normal * shear_per_normal_;
    const T shear = memory.shear_offset - shear_stiffness * motion.shear;
    const T bond =
        motion.opening * motion.opening + bond_shear_per_normal_ * (motion.shear * motion.shear) +
        (1.0 / 3.0) * (k.bond_radius * k.bond_radius) * motion.rotation * motion.rotation;
    return 0.5 * (k.normal * (closing * closing) + shear * shear / shear_stiffness + k.bond * bond);
  }

  /// Both criteria are multiplied by the area, the tensile one by Rb too: no division.
  template <class T>
  Failure<T> failure(const Stiffness<T>& k, const Response<T>& r) const noexcept {
    // A = 2 Rb and Rb / I = 3 / (A Rb)
    const T tension = thrice_moment_factor_ * abs(r.bond_moment) - r.bond_normal * k.bond_radius;
    const auto in_tension = tension > (twice_tensile_strength_ * k.bond_radius) * k.bond_radius;
    const T shear_strength =
        twice_cohesion_ * k.bond_radius + tan_friction_angle_ * max(T{}, r.bond_normal);
    return {in_tension, abs(r.bond_shear) > shear_strength};
  }

  /// How far a contact may still move before its bond can fail, m (see `ForeseesFailure`): both
  /// criteria are linear in the forces, and these in the motion; a moment counts at most in full.
  template <class T>
  T margin(const Stiffness<T>& k, const Response<T>& r) const noexcept {
    const T tension = thrice_moment_factor_ * abs(r.bond_moment) - r.bond_normal * k.bond_radius;
    const T to_tension = (twice_tensile_strength_ * k.bond_radius) * k.bond_radius - tension;
    const T to_shear = twice_cohesion_ * k.bond_radius +
                       tan_friction_angle_ * max(T{}, r.bond_normal) - abs(r.bond_shear);
    const T smaller = min(to_tension / k.bond_radius,
                          to_shear * (1 / std::fmax(tan_friction_angle_, bond_shear_per_normal_)));
    const T unlimited = T{} + std::numeric_limits<double>::max();
    return k.bond > T{} ? T(smaller / k.bond) : unlimited;
  }

 protected:
  /// Moment of the bond per relative rotation, (E_b / L) I = k_bond Rb^2 / 3, N m per m and rad.
  template <class T>
  static T bond_moment_stiffness(const Stiffness<T>& k) noexcept {
    return (1.0 / 3.0) * k.bond * (k.bond_radius * k.bond_radius);
  }

  double shear_per_normal_;  ///< stiffness of the linear part in shear over that in compression
  double bond_shear_per_normal_;  ///< the same of the bond
  double friction_;               ///< coefficient of the linear part

 private:
  double E_, bond_E_;
  double twice_tensile_strength_, twice_cohesion_, tan_friction_angle_, thrice_moment_factor_;
};

}  // namespace hfdem
