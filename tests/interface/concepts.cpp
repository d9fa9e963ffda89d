/// @file
/// The concepts, atom by atom: what each accepts, and that it refuses a model that lacks one atom.
#include <initializer_list>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/contact/incremental_parallel_bond.hpp>
#include <hfdem/contact/jointed.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/contact/scattered_parallel_bond.hpp>
#include <hfdem/contact/smooth_joint.hpp>
#include <hfdem/contact/smooth_platen.hpp>
#include <hfdem/contact/unbreakable.hpp>
#include <hfdem/fluid/newtonian.hpp>
#include <hfdem/leakoff/carter.hpp>
#include <hfdem/leakoff/matrix_flow.hpp>
#include <hfdem/leakoff/none.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/pressure/conventional.hpp>
#include <hfdem/pressure/dry.hpp>
#include <hfdem/pressure/held.hpp>
#include <hfdem/pressure/implicit.hpp>
#include <hfdem/pressure/leaky_uniform.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/state/concepts.hpp>

#include "models.hpp"

namespace {

using namespace models;

/// One bit for every atom that does not hold.
constexpr unsigned lacking(std::initializer_list<bool> atoms_that_hold) {
  unsigned bits = 0, bit = 1;
  for (const bool holds : atoms_that_hold) {
    if (!holds) bits |= bit;
    bit *= 2;
  }
  return bits;
}

// ---- the policies of the library --------------------------------------------------------------

static_assert(ContactLaw<LinearParallelBond> && ContactLaw<IncrementalParallelBond>);
static_assert(JointLaw<SmoothJoint>);
static_assert(ContactLaw<Jointed<LinearParallelBond>> && HasJoints<Jointed<LinearParallelBond>>);
static_assert(!HasJoints<LinearParallelBond>);
static_assert(ApertureLaw<HyperbolicAperture>);
static_assert(PressureScheme<UniformPressure> && PressureScheme<HeldPressure>);
static_assert(PressureScheme<Dry>);
static_assert(FluidLaw<NewtonianFluid>);
static_assert(FlowScheme<ConventionalFlow<>> && FlowScheme<ImplicitFlow<>>);
static_assert(PressureScheme<ConventionalFlow<>> && PressureScheme<ImplicitFlow<>>);
static_assert(!FlowScheme<UniformPressure> && !FlowScheme<HeldPressure> && !FlowScheme<Dry>);
static_assert(BalancesVolume<ConventionalFlow<>> && BalancesVolume<ImplicitFlow<>>);
static_assert(BalancesVolume<UniformPressure>);
static_assert(!BalancesVolume<HeldPressure> && !BalancesVolume<Dry>, "they keep no account");
static_assert(NeighbourSearch<FixedPairs>);

static_assert(RespondingLaw<SmoothPlaten>, "the contact loop runs over platens too");
static_assert(!BreakableLaw<SmoothPlaten>, "but they have no bonds");
static_assert(!ContactLaw<HyperbolicAperture> && !ContactLaw<UniformPressure> && !ContactLaw<int>);
static_assert(!ContactLaw<SmoothJoint> && !JointLaw<LinearParallelBond> && !JointLaw<int>);
static_assert(!ApertureLaw<LinearParallelBond> && !ApertureLaw<Dry> && !ApertureLaw<int>);
static_assert(!PressureScheme<HyperbolicAperture> && !PressureScheme<FixedPairs>);
static_assert(!NeighbourSearch<Dry> && !NeighbourSearch<Specimen>);

// ---- contact law ------------------------------------------------------------------------------

enum LawAtom : unsigned {
  law_params = 1,
  law_from_params = 2,
  stiffness_of_two_discs = 4,
  stiffness_record = 8,
  memory_record = 16,
  response = 32,
  springs = 64,
  failure = 128,
  broken = 256
};

template <class L>
constexpr unsigned law_lacks = lacking({has_described_params<L>, constructible_from_params<L>,
                                        gives_stiffness_of_two_discs<L>, has_stiffness_record<L>,
                                        has_memory_record<L>, responds_to_motion<L>,
                                        gives_springs<L>, tells_failure<L>,
                                        gives_broken_stiffness<L>});

/// The law lacks these atoms and no other, and is refused for it.
template <class L, LawAtom... atoms>
constexpr bool incomplete_law = law_lacks<L> == (0 | ... | atoms) && !ContactLaw<L>;

static_assert(law_lacks<Law> == 0 && ContactLaw<Law>);
static_assert(incomplete_law<WithoutFields<Law>, law_params>);
static_assert(incomplete_law<LawWithClosedParams, law_params>);
static_assert(incomplete_law<WithParams<Law, ParamsWithoutDefaults>, law_params>);
static_assert(incomplete_law<MadeFromNothing<Law>, law_from_params>);
static_assert(incomplete_law<LawWithoutStiffness, stiffness_of_two_discs>);
static_assert(incomplete_law<LawWithClosedStiffness, stiffness_record>);
static_assert(incomplete_law<LawWithClosedMemory, memory_record>);
static_assert(incomplete_law<LawWithoutReaction, response>);
static_assert(incomplete_law<ScalarLaw, response, failure>);
static_assert(incomplete_law<LawWithoutSprings, springs>);
static_assert(incomplete_law<LawWithThrowingSprings, springs>);
static_assert(incomplete_law<LawWithoutFailure, failure>);
static_assert(incomplete_law<LawWithoutBroken, broken>);

static_assert(!RespondingLaw<LawWithoutSprings> && !RespondingLaw<LawWithoutReaction>);
static_assert(!RespondingLaw<LawWithClosedStiffness> && !RespondingLaw<LawWithClosedMemory>);
static_assert(RespondingLaw<LawWithoutFailure> && !BreakableLaw<LawWithoutFailure>);
static_assert(RespondingLaw<LawWithoutBroken> && !BreakableLaw<LawWithoutBroken>);
static_assert(BreakableLaw<MadeFromNothing<Law>>, "the loop does not care where a law comes from");

static_assert(StoresEnergy<LinearParallelBond> && StoresEnergy<Unbreakable<LinearParallelBond>>);
static_assert(StoresEnergy<SmoothPlaten>, "books of energy run over platens too");
static_assert(ContactLaw<Law> && !StoresEnergy<Law>, "no simulator needs the energy");
static_assert(StoresEnergy<LawWithEnergy> && !StoresEnergy<LawWithThrowingEnergy>);
static_assert(!StoresEnergy<Unbreakable<Law>>, "it stores what its law stores");

struct OtherStrength : LinearParallelBond {
  using LinearParallelBond::LinearParallelBond;
  template <class T>
  Failure<T> failure(const Stiffness<T>& k, const Response<T>& r) const noexcept {
    return {r.bond_normal<-1e5 * k.bond_radius, r.bond_shear> 1e5 * k.bond_radius};
  }
};
struct OtherForces : LinearParallelBond {
  using LinearParallelBond::LinearParallelBond;
  template <class T>
  Response<T> respond(const Stiffness<T>& k, const Memory<T>& m,
                      const Motion<T>& u) const noexcept {
    return LinearParallelBond::respond(k, m, u);
  }
};
static_assert(ForeseesFailure<LinearParallelBond> && ForeseesFailure<ScatteredParallelBond>);
static_assert(ForeseesFailure<IncrementalParallelBond>);
static_assert(ForeseesFailure<Unbreakable<LinearParallelBond>>);
static_assert(ForeseesFailure<Unbreakable<Law>>, "whether or not its law does");
static_assert(ContactLaw<Law> && !ForeseesFailure<Law>, "no simulator needs the margin");
static_assert(ContactLaw<OtherStrength> && !ForeseesFailure<OtherStrength>,
              "the margin of another strength is not inherited");
static_assert(ContactLaw<OtherForces> && !ForeseesFailure<OtherForces>,
              "nor is that of other forces");

// ---- joint law --------------------------------------------------------------------------------

enum JointAtom : unsigned {
  joint_params = 1,
  joint_from_params = 2,
  stiffness_of_length = 4,
  joint_stiffness_record = 8,
  joint_memory_record = 16,
  joint_response = 32,
  joint_springs = 64,
  joint_failure = 128,
  joint_broken = 256,
  slip = 512,
  normal_stress = 1024,
  joint_rest_width = 2048,
  content = 4096
};

template <class J>
constexpr unsigned joint_lacks =
    lacking({has_described_params<J>, constructible_from_params<J>, gives_stiffness_of_length<J>,
             has_stiffness_record<J>, has_memory_record<J>, responds_to_motion<J>, gives_springs<J>,
             tells_failure<J>, gives_broken_stiffness<J>, tells_slip<J>, tells_normal_stress<J>,
             gives_rest_width<J>, tells_content<J>});

template <class J, JointAtom atom>
constexpr bool incomplete_joint = joint_lacks<J> == atom && !JointLaw<J>;

static_assert(joint_lacks<Joint> == 0 && JointLaw<Joint>);
static_assert(incomplete_joint<WithoutFields<Joint>, joint_params>);
static_assert(incomplete_joint<MadeFromNothing<Joint>, joint_from_params>);
static_assert(incomplete_joint<JointWithoutStiffness, stiffness_of_length>);
static_assert(incomplete_joint<JointWithoutLength, stiffness_of_length>);
static_assert(incomplete_joint<JointWithClosedStiffness, joint_stiffness_record>);
static_assert(incomplete_joint<JointWithClosedMemory, joint_memory_record>);
static_assert(incomplete_joint<JointWithoutReaction, joint_response>);
static_assert(incomplete_joint<JointWithoutSprings, joint_springs>);
static_assert(incomplete_joint<JointWithoutFailure, joint_failure>);
static_assert(incomplete_joint<JointWithoutBroken, joint_broken>);
static_assert(incomplete_joint<JointWithoutSlip, slip>);
static_assert(incomplete_joint<JointWithoutDilation, slip>);
static_assert(incomplete_joint<JointWithoutStress, normal_stress>);
static_assert(incomplete_joint<JointWithoutRestWidth, joint_rest_width>);
static_assert(incomplete_joint<JointWithoutContent, content>);

static_assert(StoresEnergy<SmoothJoint> && !StoresEnergy<Joint>, "no simulator needs the energy");

// ---- aperture law -----------------------------------------------------------------------------

enum ApertureAtom : unsigned {
  aperture_params = 1,
  aperture_from_params = 2,
  rest_width = 4,
  width = 8
};

template <class A>
constexpr unsigned aperture_lacks = lacking({has_described_params<A>, constructible_from_params<A>,
                                             gives_rest_width<A>, gives_width<A>});

template <class A, ApertureAtom atom>
constexpr bool incomplete_aperture = aperture_lacks<A> == atom && !ApertureLaw<A>;

static_assert(aperture_lacks<Aperture> == 0 && ApertureLaw<Aperture>);
static_assert(incomplete_aperture<WithoutFields<Aperture>, aperture_params>);
static_assert(incomplete_aperture<MadeFromNothing<Aperture>, aperture_from_params>);
static_assert(incomplete_aperture<ApertureWithoutRestWidth, rest_width>);
static_assert(incomplete_aperture<ApertureWithoutWidth, width>);

// ---- fluid law ----------------------------------------------------------------------------------

enum FluidAtom : unsigned {
  fluid_params = 1,
  fluid_from_params = 2,
  conductance = 4,
  compressible = 8
};

template <class F>
constexpr unsigned fluid_lacks = lacking({has_described_params<F>, constructible_from_params<F>,
                                          gives_conductance<F>, is_compressible<F>});

template <class F, FluidAtom atom>
constexpr bool incomplete_fluid = fluid_lacks<F> == atom && !FluidLaw<F>;

static_assert(fluid_lacks<Fluid> == 0 && FluidLaw<Fluid>);
static_assert(incomplete_fluid<WithoutFields<Fluid>, fluid_params>);
static_assert(incomplete_fluid<MadeFromNothing<Fluid>, fluid_from_params>);
static_assert(incomplete_fluid<FluidWithoutConductance, conductance>);
static_assert(incomplete_fluid<FluidWithThrowingConductance, conductance>);
static_assert(incomplete_fluid<FluidWithoutFilling, compressible>);
static_assert(incomplete_fluid<FluidWithoutPressure, compressible>);
static_assert(incomplete_fluid<FluidWithoutModulus, compressible>);
static_assert(!FluidLaw<HyperbolicAperture> && !FluidLaw<UniformPressure> && !FluidLaw<int>);
static_assert(!ApertureLaw<NewtonianFluid> && !PressureScheme<NewtonianFluid>);

// ---- leak-off law -------------------------------------------------------------------------------

enum LeakAtom : unsigned {
  leak_params = 1,
  leak_from_params = 2,
  says_leaks = 4,
  finds = 8,
  tells = 16,
  commits = 32
};

template <class L>
constexpr unsigned leak_lacks = lacking({has_described_params<L>, constructible_from_params<L>,
                                         says_whether_it_leaks<L>, finds_loss<L>, tells_loss<L>,
                                         commits_loss<L>});

template <class L, LeakAtom atom>
constexpr bool incomplete_leak = leak_lacks<L> == atom && !LeakoffLaw<L>;

static_assert(leak_lacks<Leak> == 0 && LeakoffLaw<Leak>);
static_assert(incomplete_leak<WithoutFields<Leak>, leak_params>);
static_assert(incomplete_leak<MadeFromNothing<Leak>, leak_from_params>);
static_assert(incomplete_leak<LeakWithoutWord, says_leaks>);
static_assert(incomplete_leak<LeakWithoutJoin, finds>);
static_assert(incomplete_leak<LeakWithoutFinding, finds>);
static_assert(incomplete_leak<LeakWithoutLoss, tells>);
static_assert(incomplete_leak<LeakWithoutSlope, tells>);
static_assert(incomplete_leak<LeakWithoutCommit, commits>);
static_assert(incomplete_leak<LeakWithoutSum, commits>);
static_assert(LeakoffLaw<NoLeakoff> && LeakoffLaw<CarterLeakoff> && LeakoffLaw<MatrixFlow>);
static_assert(!LeakoffLaw<NewtonianFluid> && !LeakoffLaw<UniformPressure> && !LeakoffLaw<int>);
static_assert(FlowScheme<LeakyUniformPressure<CarterLeakoff>>);
static_assert(FlowScheme<ConventionalFlow<Fluid, Leak>> && FlowScheme<ImplicitFlow<Fluid, Leak>>);
static_assert(FlowsThroughRock<ImplicitFlow<Fluid, MatrixFlow>>);
static_assert(!FlowsThroughRock<ImplicitFlow<Fluid, Leak>> && !FlowsThroughRock<ImplicitFlow<>>);
static_assert(!FlowsThroughRock<UniformPressure>);

// ---- pressure scheme --------------------------------------------------------------------------

enum SchemeAtom : unsigned {
  scheme_params = 1,
  scheme_from_params = 2,
  fluid_dt = 4,
  advance = 8,
  fluid = 16,
  own_fluid = 32
};

template <class S>
constexpr unsigned scheme_lacks = lacking({has_described_params<S>, made_from_params<S>,
                                           gives_fluid_dt<S>, advances_fluid<S>,
                                           says_whether_it_holds_fluid<S>, takes_its_fluid<S>});

template <class S, SchemeAtom atom>
constexpr bool incomplete_scheme = scheme_lacks<S> == atom && !PressureScheme<S>;

static_assert(scheme_lacks<Scheme> == 0 && PressureScheme<Scheme>);
static_assert(incomplete_scheme<WithoutFields<Scheme>, scheme_params>);
static_assert(incomplete_scheme<MadeFromNothing<Scheme>, scheme_from_params>);
static_assert(incomplete_scheme<SchemeWithoutFluidDt, fluid_dt>);
static_assert(incomplete_scheme<SchemeWithoutAdvance, advance>);
static_assert(incomplete_scheme<SchemeWithoutWord, fluid>);

static_assert(FlowScheme<SchemeWithFluid> && PressureScheme<SchemeWithFluid>);
static_assert(!FlowScheme<Scheme>, "it names no fluid");
static_assert(incomplete_scheme<SchemeWithClosedFluid, own_fluid>);
static_assert(incomplete_scheme<SchemeWithoutFluid, own_fluid>);

// ---- neighbour search -------------------------------------------------------------------------

static_assert(searches_specimen<Search> && gives_pairs<Search> && NeighbourSearch<Search>);
static_assert(!searches_specimen<SearchWithoutReach> && gives_pairs<SearchWithoutReach>);
static_assert(searches_specimen<SearchWithoutPairs> && !gives_pairs<SearchWithoutPairs>);
static_assert(!NeighbourSearch<SearchWithoutReach> && !NeighbourSearch<SearchWithoutPairs>);

}  // namespace
