/// @file
/// What a policy must offer. Each concept is a conjunction of named atoms, so that a compiler that
/// refuses a policy ends its message with the name of what is missing. Those of laws are in
/// law_concepts.hpp.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>

#include <hfdem/state/contact.hpp>
#include <hfdem/state/law_concepts.hpp>
#include <hfdem/state/leakoff.hpp>
#include <hfdem/state/network.hpp>
#include <hfdem/state/specimen.hpp>
#include <hfdem/state/step.hpp>
#include <hfdem/state/volume_balance.hpp>

namespace hfdem {

// ---- aperture law -----------------------------------------------------------------------------

/// `width(w0, compression, gap)` gives the hydraulic aperture, m.
template <class A>
concept gives_width = requires(const A& law, double value) {
  { law.width(value, value, value) }
  noexcept->std::same_as<double>;
};

/// How wide a flow channel is: a function of its contact's force and gap.
template <class A>
concept ApertureLaw = has_described_params<A> && constructible_from_params<A> &&
    gives_rest_width<A> && gives_width<A>;

// ---- fluid law ---------------------------------------------------------------------------------

/// `conductance(width, length, drop, pressure)` gives the flow through a channel per pressure drop,
/// m2/(s Pa).
template <class F>
concept gives_conductance = requires(const F& law, double value) {
  { law.conductance(value, value, value, value) }
  noexcept->std::same_as<double>;
};

/// `filling(pressure)` gives what a room holds over what it holds at zero pressure,
/// `pressure(filling)` its inverse, `modulus(pressure)` pressure per filling, Pa.
template <class F>
concept is_compressible = requires(const F& law, double value) {
  { law.filling(value) }
  noexcept->std::same_as<double>;
  { law.pressure(value) }
  noexcept->std::same_as<double>;
  { law.modulus(value) }
  noexcept->std::same_as<double>;
};

/// How a fluid flows through channels, and how pressure compresses it.
template <class F>
concept FluidLaw = has_described_params<F> && constructible_from_params<F> &&
    gives_conductance<F> && is_compressible<F>;

// ---- leak-off law -------------------------------------------------------------------------------

/// `leaks` says whether anything is lost.
template <class L>
concept says_whether_it_leaks = requires {
  { L::leaks } -> std::convertible_to<bool>;
};

/// Stands for a scheme's fluid.
struct SomeFluid {
  double conductance(double, double, double, double) const noexcept;  ///< see `FluidLaw`
  double filling(double) const noexcept;                              ///< see `FluidLaw`
  double pressure(double) const noexcept;                             ///< see `FluidLaw`
  double modulus(double) const noexcept;                              ///< see `FluidLaw`
};

/// `join(network)` learns what has turned wet; `find_loss(network, fluid, dt, crack, euler)` finds
/// what that loses in a step.
template <class L>
concept finds_loss = requires(L& law, Network& network, const SomeFluid& fluid, double dt,
                              const CrackFluid& crack) {
  law.join(network);
  law.find_loss(network, fluid, dt, crack, Euler::forward);
};

/// `size()`, `loss(domain, pressure)` and `slope(domain)` tell it, near the pressures at which it
/// was found.
template <class L>
concept tells_loss = requires(const L& law, std::size_t domain, double pressure) {
  { law.size() } -> std::same_as<std::size_t>;
  { law.loss(domain, pressure) } -> std::same_as<double>;
  { law.slope(domain) } -> std::same_as<double>;
};

/// `commit(network, fluid, crack)` ends the step; `leaked()` gives what has been lost so far.
template <class L>
concept commits_loss = requires(L& law, const L& read, Network& network, const SomeFluid& fluid,
                                const CrackFluid& crack) {
  law.commit(network, fluid, crack);
  { read.leaked() } -> std::same_as<double>;
};

/// What a crack loses into the rock around it.
template <class L>
concept LeakoffLaw = has_described_params<L> && constructible_from_params<L> &&
    says_whether_it_leaks<L> &&(!L::leaks || (finds_loss<L> && tells_loss<L> && commits_loss<L>));

// ---- pressure scheme --------------------------------------------------------------------------

/// `fluid_dt(mechanical_dt)` gives the length of the next fluid step, s.
template <class S>
concept gives_fluid_dt = requires(const S& scheme, double dt) {
  { scheme.fluid_dt(dt) } -> std::same_as<double>;
};

/// `holds_fluid` says whether the scheme needs a crack to put fluid into.
template <class S>
concept says_whether_it_holds_fluid = requires {
  { S::holds_fluid } -> std::convertible_to<bool>;
};

/// Stands for what the simulator passes: some callable, not a function.
struct SomeRelax {
  Relaxed operator()() const;  ///< one mechanical step
};

/// `advance(network, injected, relax)` makes one fluid step, calling `relax()` for each mechanical
/// step that it wants.
template <class S>
concept advances_fluid = requires(S& scheme, Network& network, const Injected& injected,
                                  SomeRelax relax) {
  { scheme.advance(network, injected, relax) } -> std::same_as<FluidStep>;
};

/// The fluid of a scheme flows: a nested `Fluid`.
template <class S>
concept names_fluid = requires {
  typename S::Fluid;
};

/// A scheme without a fluid that flows is made from its parameters.
template <class S>
concept made_from_params = names_fluid<S> || std::constructible_from<S, const typename S::Params&>;

/// A scheme with a fluid that flows is made from its parameters, the fluid and how the rock
/// answers.
template <class S>
concept made_with_fluid = std::constructible_from<S, const typename S::Params&,
                                                  const typename S::Fluid&, const RockResponse&>;

/// A scheme that names a fluid takes it.
template <class S>
concept takes_its_fluid = !names_fluid<S> || (FluidLaw<typename S::Fluid> && made_with_fluid<S>);

/// The crack of a scheme may lose fluid: a nested `Leakoff`.
template <class S>
concept names_leakoff = names_fluid<S> && requires {
  typename S::Leakoff;
};

/// A scheme with leak-off is made with the law of that, too.
template <class S>
concept takes_its_leakoff =
    !names_leakoff<S> ||
    (LeakoffLaw<typename S::Leakoff> &&
     std::constructible_from<S, const typename S::Params&, const typename S::Fluid&,
                             const RockResponse&, const typename S::Leakoff&>);

/// What every scheme needs, however it is made.
template <class S>
concept advances_pressure = has_described_params<S> && says_whether_it_holds_fluid<S> &&
    gives_fluid_dt<S> && advances_fluid<S>;

/// A scheme whose fluid flows.
template <class S>
concept FlowScheme =
    advances_pressure<S> && names_fluid<S> && takes_its_fluid<S> && takes_its_leakoff<S>;

/// How the fluid's pressure evolves in a fluid step.
template <class S>
concept PressureScheme =
    advances_pressure<S> && made_from_params<S> && takes_its_fluid<S> && takes_its_leakoff<S>;

/// A scheme whose fluid flows through intact contacts, too.
template <class S>
concept FlowsThroughRock = names_leakoff<S> && requires {
  requires S::Leakoff::conducts_when_intact;
};

/// A scheme that keeps account of its volumes: `balance(network, injected)`.
template <class S>
concept BalancesVolume = requires(const S& scheme, const Network& network, double injected) {
  { scheme.balance(network, injected) } -> std::same_as<VolumeBalance>;
};

// ---- neighbour search -------------------------------------------------------------------------

/// Made from a specimen and a reach: the largest gap of a pair, m.
template <class N>
concept searches_specimen = std::constructible_from<N, const Specimen&, double>;

/// Stands for what the simulator passes: some callable, not a function.
struct SomePairVisitor {
  void operator()(Pair) const;  ///< hears of a candidate
};

/// `for_each_pair(f)` calls f(Pair) for candidate pairs, each once, first < second.
template <class N>
concept gives_pairs = requires(const N& search, SomePairVisitor f) {
  search.for_each_pair(f);
};

/// Which pairs of discs may bond.
template <class N>
concept NeighbourSearch = searches_specimen<N> && gives_pairs<N>;

}  // namespace hfdem
