/// @file
/// For every atom of a concept a model that lacks only that one.
#pragma once

#include <tuple>

#include <hfdem/state/concepts.hpp>

#include "least/aperture_law.hpp"
#include "least/contact_law.hpp"
#include "least/fluid_law.hpp"
#include "least/joint_law.hpp"
#include "least/leakoff_law.hpp"
#include "least/neighbour_search.hpp"
#include "least/pressure_scheme.hpp"

namespace models {

using namespace hfdem;

using Law = GluedSprings;
using Joint = GluedWalls;
using Aperture = RoughWalls;
using Fluid = DenserFluid;
using Leak = FilterCake;
using Scheme = PressureSteps;
using Search = AllPairs;

struct ParamsWithoutFields {};
struct ParamsWithConstructor {
  ParamsWithConstructor() {}
  static constexpr auto fields() { return std::tuple{}; }
};
struct ParamsWithoutDefaults {
  double& host;
  static constexpr auto fields() { return std::tuple{}; }
};

/// Gives a policy other parameters, from which it can still be made.
template <class Policy, class P>
struct WithParams : Policy {
  using Params = P;
  explicit WithParams(const Params&) : Policy({}) {}
};
template <class Policy>
using WithoutFields = WithParams<Policy, ParamsWithoutFields>;

/// Takes away the construction from parameters.
template <class Policy>
struct MadeFromNothing : Policy {
  MadeFromNothing() : Policy({}) {}
};

// ---- contact law ------------------------------------------------------------------------------

using LawWithClosedParams = WithParams<Law, ParamsWithConstructor>;

struct LawWithClosedStiffness : Law {
  using Law::Law;
  template <class T>
  struct Stiffness : Law::Stiffness<T> {
    explicit Stiffness(const Law::Stiffness<T>& k) : Law::Stiffness<T>(k) {}
  };
  Stiffness<double> stiffness(Disc a, Disc b) const noexcept {
    return Stiffness<double>(Law::stiffness(a, b));
  }
  Stiffness<double> broken(const Stiffness<double>& k) const noexcept { return k; }
};

struct LawWithClosedMemory : Law {
  using Law::Law;
  template <class T>
  struct Memory : Law::Memory<T> {
    Memory(const Law::Memory<T>&) {}
  };
};

struct LawWithoutStiffness : Law {
  using Law::Law;
  void stiffness() = delete;
};

struct LawWithoutSprings : Law {
  using Law::Law;
  void springs() = delete;
};

/// All laws are called in loops that cannot catch anything.
struct LawWithThrowingSprings : Law {
  using Law::Law;
  Springs springs(const Stiffness<double>& k) const { return Law::springs(k); }
};

struct LawWithoutReaction : Law {
  using Law::Law;
  template <class T>
  struct Response : Law::Response<T> {
    void reaction() = delete;
  };
  template <class T>
  Response<T> respond(const Stiffness<T>& k, const Memory<T>& memory,
                      const Motion<T>& motion) const noexcept {
    return {Law::respond(k, memory, motion)};
  }
};

/// Answers one contact at a time only.
struct ScalarLaw : Law {
  using Law::Law;
  Response<double> respond(const Stiffness<double>& k, const Memory<double>& memory,
                           const Motion<double>& motion) const noexcept {
    return Law::respond(k, memory, motion);
  }
};

struct LawWithoutFailure : Law {
  using Law::Law;
  void failure() = delete;
};

struct LawWithoutBroken : Law {
  using Law::Law;
  void broken() = delete;
};

struct LawWithEnergy : Law {
  using Law::Law;
  double energy(const Stiffness<double>& k, const Memory<double>&,
                const Motion<double>& m) const noexcept {
    const double normal = m.opening < 0 ? std::fmax(k.pressed, k.glued) : k.glued;
    return (normal * m.opening * m.opening + k.glued * m.shear * m.shear) / 2;
  }
};

struct LawWithThrowingEnergy : Law {
  using Law::Law;
  double energy(const Stiffness<double>&, const Memory<double>&, const Motion<double>&) const {
    return 0;
  }
};

// ---- joint law --------------------------------------------------------------------------------

struct JointWithoutStiffness : Joint {
  using Joint::Joint;
  void stiffness() = delete;
};

struct JointWithoutLength : Joint {
  using Joint::Joint;
  void with_length() = delete;
};

struct JointWithClosedStiffness : Joint {
  using Joint::Joint;
  template <class T>
  struct Stiffness : Joint::Stiffness<T> {
    explicit Stiffness(const Joint::Stiffness<T>& k) : Joint::Stiffness<T>(k) {}
  };
  Stiffness<double> stiffness(double length) const noexcept {
    return Stiffness<double>(Joint::stiffness(length));
  }
  Stiffness<double> with_length(const Stiffness<double>& k, double length) const noexcept {
    return Stiffness<double>(Joint::with_length(k, length));
  }
  Stiffness<double> broken(const Stiffness<double>& k) const noexcept { return k; }
};

struct JointWithClosedMemory : Joint {
  using Joint::Joint;
  template <class T>
  struct Memory : Joint::Memory<T> {
    Memory(const Joint::Memory<T>&) {}
  };
};

/// Answers otherwise than its base.
template <template <class> class OtherResponse>
struct JointAnswering : Joint {
  using Joint::Joint;
  template <class T>
  using Response = OtherResponse<T>;
  template <class T>
  Response<T> respond(const Stiffness<T>& k, const Memory<T>& memory,
                      const Motion<T>& motion) const noexcept {
    return {Joint::respond(k, memory, motion)};
  }
};
template <class T>
struct ResponseWithoutReaction : Joint::Response<T> {
  void reaction() = delete;
};
template <class T>
struct ResponseWithoutStress : Joint::Response<T> {
  void normal_stress() = delete;
};
using JointWithoutReaction = JointAnswering<ResponseWithoutReaction>;
using JointWithoutStress = JointAnswering<ResponseWithoutStress>;

struct JointWithoutSprings : Joint {
  using Joint::Joint;
  void springs() = delete;
};

struct JointWithoutFailure : Joint {
  using Joint::Joint;
  void failure() = delete;
};

struct JointWithoutBroken : Joint {
  using Joint::Joint;
  void broken() = delete;
};

struct JointWithoutSlip : Joint {
  using Joint::Joint;
  void slip() = delete;
};

struct JointWithoutDilation : Joint {
  using Joint::Joint;
  void dilation() = delete;
};

struct JointWithoutRestWidth : Joint {
  using Joint::Joint;
  void rest_width() = delete;
};

struct JointWithoutContent : Joint {
  using Joint::Joint;
  void initially() = delete;
};

// ---- aperture law -----------------------------------------------------------------------------

struct ApertureWithoutRestWidth : Aperture {
  using Aperture::Aperture;
  void rest_width() = delete;
};

struct ApertureWithoutWidth : Aperture {
  using Aperture::Aperture;
  void width() = delete;
};

// ---- fluid law ----------------------------------------------------------------------------------

struct FluidWithoutConductance : Fluid {
  using Fluid::Fluid;
  void conductance() = delete;
};

/// Flow is computed in loops that cannot catch anything.
struct FluidWithThrowingConductance : Fluid {
  using Fluid::Fluid;
  double conductance(double width, double length, double drop, double mean) const {
    return Fluid::conductance(width, length, drop, mean);
  }
};

struct FluidWithoutFilling : Fluid {
  using Fluid::Fluid;
  void filling() = delete;
};

struct FluidWithoutPressure : Fluid {
  using Fluid::Fluid;
  void pressure() = delete;
};

struct FluidWithoutModulus : Fluid {
  using Fluid::Fluid;
  void modulus() = delete;
};

// ---- leak-off law -------------------------------------------------------------------------------

struct LeakWithoutWord : Leak {
  using Leak::Leak;

 private:
  static constexpr bool leaks = true;
};

struct LeakWithoutJoin : Leak {
  using Leak::Leak;
  void join(Network&) = delete;
};

struct LeakWithoutFinding : Leak {
  using Leak::Leak;
  void find_loss() {}
};

struct LeakWithoutLoss : Leak {
  using Leak::Leak;
  double loss(std::size_t) const { return 0; }
};

struct LeakWithoutSlope : Leak {
  using Leak::Leak;
  void slope(std::size_t) const {}
};

struct LeakWithoutCommit : Leak {
  using Leak::Leak;
  void commit() {}
};

struct LeakWithoutSum : Leak {
  using Leak::Leak;
  int leaked() const { return 0; }
};

// ---- pressure scheme --------------------------------------------------------------------------

/// It takes a fluid, and uses nothing of it.
struct SchemeWithFluid : Scheme {
  using Fluid = models::Fluid;
  SchemeWithFluid(const Params& params, const Fluid&, const RockResponse&) : Scheme(params) {}
};

/// It names a fluid, but takes none.
struct SchemeWithClosedFluid : Scheme {
  using Fluid = models::Fluid;
  using Scheme::Scheme;
};

/// What it takes is no fluid.
struct SchemeWithoutFluid : Scheme {
  using Fluid = Aperture;
  SchemeWithoutFluid(const Params& params, const Fluid&, const RockResponse&) : Scheme(params) {}
};

/// It does not say whether it holds fluid.
struct SchemeWithoutWord : Scheme {
  using Scheme::Scheme;
  void holds_fluid() = delete;
};

struct SchemeWithoutFluidDt : Scheme {
  using Scheme::Scheme;
  void fluid_dt() = delete;
};

struct SchemeWithoutAdvance : Scheme {
  using Scheme::Scheme;
  void advance() = delete;
};

// ---- neighbour search -------------------------------------------------------------------------

struct SearchWithoutReach : Search {
  explicit SearchWithoutReach(const Specimen& specimen) : Search(specimen, 0) {}
};

struct SearchWithoutPairs : Search {
  using Search::Search;
  void for_each_pair() = delete;
};

}  // namespace models
