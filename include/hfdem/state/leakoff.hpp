/// @file
/// What passes between a pressure scheme and its leak-off law, and what such a law must offer.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>

#include <hfdem/state/law_concepts.hpp>
#include <hfdem/state/network.hpp>

namespace hfdem {

/// What the wet domains have, in the order in which they turned wet.
struct CrackFluid {
  std::span<const double> pressure;  ///< Pa
  std::span<const double> stored;    ///< m2 at zero pressure
};

/// How a law makes a fluid step: from what is known at its start, or towards its end.
enum class Euler { forward, backward };

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

/// `commit(network, fluid, pressures)` ends the step; `leaked()` gives what has been lost so far.
template <class L>
concept commits_loss = requires(L& law, const L& read, Network& network, const SomeFluid& fluid,
                                std::span<const double> pressures) {
  law.commit(network, fluid, pressures);
  { read.leaked() } -> std::same_as<double>;
};

/// What a crack loses into the rock around it.
template <class L>
concept LeakoffLaw = has_described_params<L> && constructible_from_params<L> &&
    says_whether_it_leaks<L> &&(!L::leaks || (finds_loss<L> && tells_loss<L> && commits_loss<L>));

}  // namespace hfdem
