/// @file
/// How a run tells its observers what happens. Every event is optional and costs nothing where an
/// observer does not ask for it.
#pragma once

#include <type_traits>

#include <hfdem/state/contact.hpp>
#include <hfdem/state/step.hpp>

namespace hfdem {

/// A bond that broke during a run.
struct BondBreak {
  double time;      ///< end of the fluid step in which it broke, s
  Index contact;    ///< also the index of its flow channel
  Mode mode;        ///< in tension or in shear
  double pressure;  ///< at the injection when it broke, Pa
};

/// After a fluid step: calls `observer.fluid_step(sim, step)` or `observer(sim)`, whichever exists.
/// @returns false if the observer answers so, which ends the run
template <class Observer, class Sim>
bool tell_fluid_step(Observer& observer, const Sim& sim, [[maybe_unused]] const FluidStep& step) {
  const auto answer = [&] {
    if constexpr (requires { observer.fluid_step(sim, step); })
      return observer.fluid_step(sim, step);
    else if constexpr (requires { observer(sim); })
      return observer(sim);
  };
  if constexpr (std::is_void_v<decltype(answer())>) {
    answer();
    return true;
  } else {
    return answer();
  }
}

/// For every bond that broke: calls `observer.bond_break(sim, broken)` where it exists.
template <class Observer, class Sim>
void tell_bond_break(Observer& observer, const Sim& sim, const BondBreak& broken) {
  if constexpr (requires { observer.bond_break(sim, broken); }) observer.bond_break(sim, broken);
}

/// An observer that asks for every mechanical step.
template <class Observer, class Sim>
concept hears_mechanical_steps = requires(Observer& observer, const Sim& sim) {
  observer.mechanical_step(sim);
};

/// In a mechanical step, once its forces and loads are known and before anything moves: calls
/// `observer.mechanical_step(sim)` where it exists. Displacements and forces are those of the same
/// instant, velocities those of half a step before.
template <class Observer, class Sim>
void tell_mechanical_step(Observer& observer, const Sim& sim) {
  if constexpr (hears_mechanical_steps<Observer, Sim>) observer.mechanical_step(sim);
}

}  // namespace hfdem
