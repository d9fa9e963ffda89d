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

/// Whether an observer wants to hear of the next mechanical steps: it has a member
/// `mechanical_step`, and no member `wants_mechanical_steps()` that answers false. Steps that
/// nobody hears of are faster.
template <class Observer, class Sim>
bool wants_mechanical_steps([[maybe_unused]] Observer& observer, [[maybe_unused]] const Sim& sim) {
  if constexpr (!requires { observer.mechanical_step(sim); })
    return false;
  else if constexpr (requires { observer.wants_mechanical_steps(); })
    return observer.wants_mechanical_steps();
  else
    return true;
}

/// In a mechanical step, once its forces and loads are known and before anything moves: calls
/// `observer.mechanical_step(sim)` if it wants to hear of it. Displacements and forces are those of
/// the same instant, velocities those of half a step before.
template <class Observer, class Sim>
void tell_mechanical_step(Observer& observer, const Sim& sim) {
  if constexpr (requires { observer.mechanical_step(sim); })
    if (wants_mechanical_steps(observer, sim)) observer.mechanical_step(sim);
}

}  // namespace hfdem
