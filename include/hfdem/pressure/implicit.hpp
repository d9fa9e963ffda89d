/// @file
/// Implicit flow: backward Euler on the channel network, with the rock's answer in the Jacobian.
/// Any viscosity, any fluid time step.
///
/// What each domain is to store at the end of a step, S* plus the flow at the new pressures, has to
/// fit into the room that the rock leaves it at these pressures:
///
///   r(P) = S* + dt (net inflow at P) - V_d(P) filling(P) = 0
///
/// Each mechanical step makes one Newton step towards that,
///
///   [T C + diag(V_d / K_f) + dt L(w)] dP = r,
///
/// L being the Laplacian of the conductances, C a model of how the room answers pressure: that of a
/// straight crack as a whole, and of each domain on its own,
///
///   C = c_u 1 1^T + c_l I,  c_l = 8 l_p^2 / E',  1^T C 1 = 2 pi a^2 / E'.
///
/// a being half the length of what is full. The rock answers when a wave has run along the crack;
/// T is 0.1 of the steps which that takes. Until then rooms go on changing as they do: the right
/// side is what r will be after some steps at the rate of the last one, T of them and a tenth of
/// those made so far, up to 20. Without that, pressure turns for ever beside grains that hardly
/// anything holds: a pressure that only sums up r pushes a quarter of a turn late. Model and
/// outlook guide the search alone: what counts is r, and the balance of forces. Domains at the
/// least pressure that are not full stay out of the system (pressure/flow_system.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include <hfdem/base/fields.hpp>
#include <hfdem/base/pack.hpp>
#include <hfdem/fluid/newtonian.hpp>
#include <hfdem/leakoff/none.hpp>
#include <hfdem/pressure/flow_system.hpp>
#include <hfdem/pressure/stored_fluid.hpp>
#include <hfdem/state/concepts.hpp>
#include <hfdem/state/leakoff.hpp>
#include <hfdem/state/step.hpp>

namespace hfdem {

/// Step, tolerances and floor of `ImplicitFlow`, whatever its policies.
struct ImplicitFlowParams {
  double fluid_dt = 1e-4;
  double volume_tolerance = 1e-3;
  double unbalanced_tolerance = 1e-3;
  int max_mechanical_steps = 1000;
  double pressure_floor = 0;

  static constexpr auto fields() {
    using P = ImplicitFlowParams;
    return std::tuple{
        Field{"fluid_dt", &P::fluid_dt, "s", positive,
              "longest fluid time step; shorter where one does not converge"},
        Field{"volume_tolerance", &P::volume_tolerance, "", Range{0, 1, true},
              "largest volume without its room at the end of a fluid step, over that injected, "
              "or over that of the unloaded crack if that is more"},
        Field{"unbalanced_tolerance", &P::unbalanced_tolerance, "", positive,
              "largest resultant on a disc over the mean contact force at equilibrium"},
        Field{"max_mechanical_steps", &P::max_mechanical_steps, "", Range{1},
              "mechanical steps after which a fluid step ends in any case"},
        Field{"pressure_floor", &P::pressure_floor, "Pa", any_number,
              "least pressure of the fluid; far below zero, as -1e12, for none"}};
  }
};

/// A `FlowScheme`: implicit.
/// @tparam FluidPolicy law of the fluid
/// @tparam LeakoffPolicy what the crack loses into the rock
template <FluidLaw FluidPolicy = NewtonianFluid, LeakoffLaw LeakoffPolicy = NoLeakoff>
class ImplicitFlow {
 public:
  using Fluid = FluidPolicy;          ///< as composed
  using Leakoff = LeakoffPolicy;      ///< as composed
  using Params = ImplicitFlowParams;  ///< as given

  static constexpr bool holds_fluid = true;  ///< needs a crack to enter

  /// @param params validated
  /// @param law of the fluid
  /// @param rock how it answers, roughly; a modulus of infinity for walls that do not move
  /// @param leakoff law of what is lost
  ImplicitFlow(const Params& params, const Fluid& law, const RockResponse& rock,
               const Leakoff& leakoff = Leakoff({}))
      : params_(params), law_(law), leakoff_(leakoff), rock_(rock), dt_(params.fluid_dt) {}

  /// Length of the next fluid step, s.
  double fluid_dt(double) const { return dt_; }

  /// Finds the pressures at the end of the step: one Newton step, one mechanical step, again until
  /// volumes and forces are met.
  /// @throws RunStopped if the equations have no solution
  template <class Relax>
  FluidStep advance(Network& network, const Injected& injected, Relax&& relax) {
    fluid_.join(network);
    fluid_.inject(injected.step, network.injection_domains().size());
    if constexpr (Leakoff::leaks) leakoff_.join(network);
    pressure_.resize(fluid_.size(), 0);
    find_leakoff(network, injected.dt);
    take_stock(network, injected.dt);
    room_before_.clear();
    FluidStep step;
    do {
      solve(injected.dt, step.mechanical_steps);
      publish(network);
      room_before_.assign(fluid_.room().begin(), fluid_.room().end());
      const Relaxed relaxed = relax();
      fluid_.join(network);
      take_stock(network, injected.dt);
      ++step.mechanical_steps;
      step.unbalanced_ratio = relaxed.unbalanced_ratio;
      // At the very beginning next to nothing has been injected into a crack that is full already.
      const double whole = max(injected.total, network.rest_volume());
      step.volume_error = missing_room() / whole;
      const bool balanced = relaxed.unbalanced_ratio < params_.unbalanced_tolerance;
      // What leaks off was estimated from the last time it was found.
      if (Leakoff::leaks && balanced && step.volume_error <= params_.volume_tolerance) {
        find_leakoff(network, injected.dt);
        find_residual(injected.dt);
        step.volume_error = missing_room() / whole;
      }
      step.converged = balanced && step.volume_error <= params_.volume_tolerance;
    } while (!step.converged && step.mechanical_steps < params_.max_mechanical_steps);
    step.flow_steps = step.mechanical_steps;
    if (Leakoff::leaks && !step.converged) find_leakoff(network, injected.dt);
    let_flow(injected.dt);
    lose(network);
    publish(network);
    constexpr double shorter = 0.5, longer = 1.25, shortest = 1.0 / 16;
    dt_ = clamp(dt_ * (step.converged ? longer : shorter), shortest * params_.fluid_dt,
                params_.fluid_dt);
    return step;
  }

  /// Where the fluid is.
  /// @param network with widths and pressures
  /// @param injected so far, m2
  VolumeBalance balance(const Network& network, double injected) const {
    VolumeBalance b = fluid_.balance(network, injected, law_, params_.pressure_floor);
    if constexpr (Leakoff::leaks) b.leaked = leakoff_.leaked();
    return b;
  }
  const Leakoff& leakoff() const { return leakoff_; }  ///< to be read

  /// What is stored and lost, the pressures and the step.
  void exchange(auto& archive) {
    archive(fluid_, pressure_, dt_);
    if constexpr (Leakoff::leaks) archive(leakoff_);
  }

 private:
  void find_leakoff(const Network& network, double dt) {
    if constexpr (Leakoff::leaks)
      leakoff_.find_loss(network, law_, dt, {pressure_, fluid_.stored()}, Euler::backward);
  }
  void lose(Network& network) {
    if constexpr (Leakoff::leaks) {
      leakoff_.commit(network, law_, {pressure_, fluid_.stored()});
      for (std::size_t d = 0; d < leakoff_.size(); ++d)
        fluid_.stored()[d] -= leakoff_.loss(d, pressure_[d]);
    }
  }

  /// What flows at the present widths and pressures, and what has no room then.
  void take_stock(const Network& network, double dt) {
    fluid_.find_room(network);
    find_flow(network);
    find_residual(dt);
  }

  void find_flow(const Network& network) {
    pressure_.resize(fluid_.size(), 0);
    conductance_.clear();
    for (const auto& [c, first, second, length] : fluid_.channels()) {
      const double a = pressure_[first], b = pressure_[second];
      conductance_.push_back(law_.conductance(network.width(c), length, a - b, (a + b) / 2));
    }
  }

  /// Calls f(channel's first domain, its second, volume that flows to the second in dt).
  template <class F>
  void for_each_flow(double dt, F&& f) const {
    const auto channels = fluid_.channels();
    for (std::size_t k = 0; k < channels.size(); ++k) {
      const Index first = channels[k].first, second = channels[k].second;
      f(first, second, dt * conductance_[k] * (pressure_[first] - pressure_[second]));
    }
  }

  void find_residual(double dt) {
    residual_.assign(fluid_.stored().begin(), fluid_.stored().end());
    for_each_flow(dt, [&](Index first, Index second, double volume) {
      residual_[first] -= volume;
      residual_[second] += volume;
    });
    for (std::size_t d = 0; d < residual_.size(); ++d)
      residual_[d] -= fluid_.room()[d] * law_.filling(pressure_[d]);
    if constexpr (Leakoff::leaks)
      for (std::size_t d = 0; d < leakoff_.size(); ++d)
        residual_[d] -= leakoff_.loss(d, pressure_[d]);
  }

  /// Not full at the least pressure, nor about to be. Full to the last digits is full: or pressure
  /// would reach one more domain of a full crack in each Newton step.
  bool is_empty(std::size_t d) const {
    constexpr double last_digits = 1e-12;
    return pressure_[d] <= params_.pressure_floor && residual_[d] < -last_digits * fluid_.room()[d];
  }

  /// What the rooms hold too much or too little, m2.
  double missing_room() const {
    double missing = 0;
    for (std::size_t d = 0; d < residual_.size(); ++d)
      if (!is_empty(d)) missing += std::abs(residual_[d]);
    return missing;
  }

  /// How the rooms answer pressure: C, and how many steps it takes.
  struct Answer {
    double steps;           ///< T
    double together, each;  ///< T c_u and T c_l, m2/Pa
  };
  Answer answer() const {
    if (std::isinf(rock_.modulus)) return {0, 0, 0};
    // Only what is full pushes the rock: a crack that long.
    double length = 0, squares = 0, full = 0;
    for (std::size_t d = 0; d < full_.size(); ++d) {
      if (!full_[d]) continue;
      length += fluid_.half_length()[d];
      squares += fluid_.half_length()[d] * fluid_.half_length()[d];
      ++full;
    }
    const double half = length / 2;
    const double steps = max(2.0, 0.1 * std::numbers::pi * half / (2 * rock_.wave_step));
    const double each = 8 * squares / full / rock_.modulus;
    const double whole = 2 * std::numbers::pi * half * half / rock_.modulus;
    return {steps, steps * max(0.0, whole - full * each) / (full * full), steps * each};
  }

  /// One step of Newton's method.
  /// @param dt of the fluid step, s
  /// @param made mechanical steps in this fluid step so far
  void solve(double dt, int made) {
    full_.assign(fluid_.size(), false);
    for (std::size_t d = 0; d < full_.size(); ++d) full_[d] = !is_empty(d);
    if (std::find(full_.begin(), full_.end(), true) == full_.end()) return;
    const Answer c = answer();
    own_.clear(), flow_.clear();
    for (std::size_t d = 0; d < pressure_.size(); ++d)
      own_.push_back(c.each + fluid_.room()[d] / law_.modulus(pressure_[d]));
    if constexpr (Leakoff::leaks)
      for (std::size_t d = 0; d < leakoff_.size(); ++d) own_[d] += leakoff_.slope(d);
    for (const double conductance : conductance_) flow_.push_back(dt * conductance);
    constexpr double at_most = 20;  // farther ahead, it is too stiff a spring
    const double ahead = c.steps + min(at_most, made / 10.0);
    for (std::size_t d = 0; d < room_before_.size(); ++d)
      residual_[d] -= ahead * (fluid_.room()[d] - room_before_[d]);
    system_.add_solution(fluid_, {own_, flow_, c.together}, residual_, full_, pressure_);
    for (double& p : pressure_) p = max(params_.pressure_floor, p);
  }

  void let_flow(double dt) {
    const auto stored = fluid_.stored();
    for_each_flow(dt, [&](Index first, Index second, double volume) {
      stored[first] -= volume;
      stored[second] += volume;
    });
  }

  void publish(Network& network) const {
    const auto domains = network.wet_domains();
    for (std::size_t d = 0; d < pressure_.size(); ++d)
      network.set_pressure(domains[d], pressure_[d]);
  }

  Params params_;
  Fluid law_;
  Leakoff leakoff_;
  RockResponse rock_;
  StoredFluid fluid_;
  std::vector<double> pressure_;                // of each wet domain, Pa
  std::vector<double> room_before_;             // the last mechanical step, m2
  std::vector<double> conductance_, residual_;  // of each wet channel, of each wet domain
  double dt_;
  FlowSystem system_;
  std::vector<double> own_, flow_;  // its coefficients
  std::vector<bool> full_;          // the domains that take part in it
};

}  // namespace hfdem
