/// @file
/// Smooth joint: two discs on either side of a natural fracture, which slide along the fracture and
/// not around one another.
///
/// Source: D. Mas Ivars et al., "The synthetic rock mass approach for jointed rock mass modelling",
/// Int. J. Rock Mech. Min. Sci. 48 (2011) 219-244; the smooth-joint model of PFC2D. A contact
/// stands for a piece of the fracture, of length l. Along the fracture's normal and tangent, with
/// the relative displacement of the two centres since bonding (opening o, shear s), per metre of
/// fracture:
///
///   normal stress   N = k_n (d - o)      d: dilation; no tension once the bond has broken
///   shear stress    S = k_s (p - s)      p: slip so far; |S| <= mu N once the bond has broken
///   breaks          in tension at -N > tensile strength, in shear at |S| > cohesion + mu N
///   dilation        grows by tan(dilation angle) times the slip of a closed joint
///
/// There is no moment, and the discs' rotations do not enter. Total form: slip and dilation are all
/// that is remembered.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <tuple>

#include <hfdem/base/fields.hpp>
#include <hfdem/base/pack.hpp>
#include <hfdem/state/contact.hpp>

namespace hfdem {

/// What is in a joint before the injected fluid reaches it.
enum class JointContent { dry, filled };
/// Their names in a parameter file.
template <>
inline constexpr auto names_of<JointContent> = std::to_array<std::string_view>({"dry", "filled"});

/// A `JointLaw`.
class SmoothJoint {
 public:
  /// Properties of the fracture; the defaults are those of the paper's Tables 2 and 3.
  struct Params {
    double normal_stiffness = 120e9;
    double shear_stiffness = 60e9;
    double tensile_strength = 0.1e6;
    double cohesion = 0.1e6;
    double friction = 0.5;
    double dilation_angle = 0;
    double w0 = 1e-4;
    JointContent initially = JointContent::dry;

    static constexpr auto fields() {
      using P = Params;
      return std::tuple{
          Field{"normal_stiffness", &P::normal_stiffness, "Pa/m", positive,
                "normal stiffness of the joint"},
          Field{"shear_stiffness", &P::shear_stiffness, "Pa/m", positive,
                "shear stiffness of the joint"},
          Field{"tensile_strength", &P::tensile_strength, "Pa", non_negative,
                "tensile strength of the joint's bond"},
          Field{"cohesion", &P::cohesion, "Pa", non_negative, "cohesion of the joint's bond"},
          Field{"friction", &P::friction, "", non_negative, "friction coefficient of the joint"},
          Field{"dilation_angle", &P::dilation_angle, "deg", Range{0, 60},
                "by how much a joint that slips rises over its slip"},
          Field{"w0", &P::w0, "m", positive, "aperture of the joint at zero normal stress"},
          Field{"initially", &P::initially, "", any_number,
                "dry: the injected fluid has to fill the joint; filled: the joint is full before"}};
    }
  };

  /// What is fixed per contact, as long as its joint is not shared out anew.
  template <class T>
  struct Stiffness {
    T length;  ///< of fracture that the contact stands for, m; zero while the discs have not met
    T bond;    ///< 1, or 0 once the bond has broken
  };

  /// What evolves per contact.
  template <class T>
  struct Memory {
    T slip;      ///< p, m
    T dilation;  ///< d, m
  };

  /// The force of the contact, compression positive.
  template <class T>
  struct Response {
    T normal_stress, shear_stress;  ///< Pa
    T length;                       ///< of fracture, m
    Memory<T> memory;               ///< after this motion

    /// Without a moment.
    Reaction<T> reaction() const { return {normal_stress * length, shear_stress * length, T{}}; }
  };

  /// @param p validated parameters
  explicit SmoothJoint(const Params& p)
      : params_(p),
        rise_(std::tan(p.dilation_angle * std::numbers::pi / 180)),
        slip_per_excess_(1 / (p.shear_stiffness + p.friction * p.normal_stiffness * rise_)) {}

  /// Of a new contact that stands for so many metres of fracture, its bond intact.
  Stiffness<double> stiffness(double length) const noexcept { return {length, 1}; }
  /// What is left of a contact whose bond has broken; also what discs have that meet later.
  Stiffness<double> broken(const Stiffness<double>& k) const noexcept { return {k.length, 0}; }
  /// The same contact where the fracture is shared out anew.
  Stiffness<double> with_length(const Stiffness<double>& k, double length) const noexcept {
    return {length, k.bond};
  }

  /// The joint is stiffest while it is closed and does not slip.
  Springs springs(const Stiffness<double>& k) const noexcept {
    return {params_.normal_stiffness * k.length, params_.shear_stiffness * k.length, 0};
  }

  /// The aperture at zero normal stress, m, before any dilation.
  double rest_width() const noexcept { return params_.w0; }
  /// What is in the joint before the fluid comes.
  JointContent initially() const noexcept { return params_.initially; }
  /// By how much slip has opened the joint, m.
  double dilation(const Memory<double>& memory) const noexcept { return memory.dilation; }
  /// How far the second side has slid along the tangent, m.
  double slip(const Memory<double>& memory) const noexcept { return memory.slip; }

  /// The stresses that follow from the displacement since bonding, after return mapping of slip:
  /// the slip is that at which friction holds under the normal stress that its dilation makes.
  template <class T>
  Response<T> respond(const Stiffness<T>& k, const Memory<T>& memory,
                      const Motion<T>& motion) const noexcept {
    const T zero{};
    const T trial = params_.normal_stiffness * (memory.dilation - motion.opening);
    const T closed = max(zero, trial);
    const T elastic = params_.shear_stiffness * (memory.slip - motion.shear);
    const T excess = max(zero, abs(elastic) - params_.friction * closed);
    const T on_closed = slip_per_excess_ * excess, on_open = excess * (1 / params_.shear_stiffness);
    const T loose = 1.0 - k.bond;
    const T slip = loose * (trial > zero ? on_closed : on_open);
    const T rise = trial > zero ? T(rise_ * slip) : zero;
    const T back = elastic > zero ? T(-slip) : slip;
    return {.normal_stress = (k.bond > zero ? trial : closed) + params_.normal_stiffness * rise,
            .shear_stress = elastic + params_.shear_stiffness * back,
            .length = k.length,
            .memory = {memory.slip + back, memory.dilation + rise}};
  }

  /// What the contact stores at this motion, J per m.
  template <class T>
  T energy(const Stiffness<T>& k, const Memory<T>& memory, const Motion<T>& motion) const noexcept {
    const T zero{};
    const T approach = memory.dilation - motion.opening;
    const T closing = k.bond > zero ? approach : max(zero, approach);
    const T elastic = memory.slip - motion.shear;
    return 0.5 * k.length *
           (params_.normal_stiffness * (closing * closing) +
            params_.shear_stiffness * (elastic * elastic));
  }

  /// A bond that has broken is under no stress here.
  template <class T>
  Failure<T> failure(const Stiffness<T>& k, const Response<T>& r) const noexcept {
    const T zero{};
    const T shear_strength = params_.cohesion + params_.friction * max(zero, r.normal_stress);
    return {-r.normal_stress * k.bond > params_.tensile_strength + zero,
            abs(r.shear_stress) * k.bond > shear_strength};
  }

 private:
  Params params_;
  double rise_, slip_per_excess_;
};

}  // namespace hfdem
