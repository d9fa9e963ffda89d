/// @file
/// The conventional hydromechanical scheme: explicit flow from domain to domain, the paper's
/// Eqs. 4 and 5.
///
/// The state is what each domain stores, S; its pressure follows from the room that the solid
/// leaves it, P = K_f (S / V_d - 1), but not below a floor. That is Eq. 4 summed up, and it keeps
/// the volume exactly where bonds break or the pressure is at the floor. One fluid step is one
/// mechanical step; within it the flow makes as many steps at the present widths as
///
///   dt_f < min over domains of V_d / (K_f sum w^3 / (12 mu l_p))
///
/// asks for: above it pressures are wrong, though nothing blows up. A wet channel is also a spring,
/// K_f / w for the discs beside it, so that the mechanical step must be shorter than without fluid.
/// Start-up is a water hammer: its pressures in the first milliseconds are no breakdown.
#pragma once

#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include <hfdem/base/fields.hpp>
#include <hfdem/base/pack.hpp>
#include <hfdem/fluid/newtonian.hpp>
#include <hfdem/leakoff/none.hpp>
#include <hfdem/pressure/stored_fluid.hpp>
#include <hfdem/state/concepts.hpp>
#include <hfdem/state/leakoff.hpp>
#include <hfdem/state/step.hpp>

namespace hfdem {

/// Steps and floor of `ConventionalFlow`, whatever its policies.
struct ConventionalFlowParams {
  double fluid_dt = 2e-6;
  double limit_fraction = 0.8;
  bool sub_cycling = true;
  double pressure_floor = 0;

  static constexpr auto fields() {
    using P = ConventionalFlowParams;
    return std::tuple{
        Field{"fluid_dt", &P::fluid_dt, "s", positive,
              "fluid time step, in which the discs move by one mechanical step"},
        Field{"limit_fraction", &P::limit_fraction, "", Range{0, 1, true},
              "time step of the flow over the longest stable one"},
        Field{"sub_cycling", &P::sub_cycling, "", any_number,
              "several steps of the flow per mechanical step; otherwise as many mechanical ones"},
        Field{"pressure_floor", &P::pressure_floor, "Pa", any_number,
              "least pressure of the fluid; far below zero, as -1e12, for none"}};
  }
};

/// A `FlowScheme`: explicit.
/// @tparam FluidPolicy law of the fluid
/// @tparam LeakoffPolicy what the crack loses into the rock
template <FluidLaw FluidPolicy = NewtonianFluid, LeakoffLaw LeakoffPolicy = NoLeakoff>
class ConventionalFlow {
 public:
  using Fluid = FluidPolicy;              ///< as composed
  using Leakoff = LeakoffPolicy;          ///< as composed
  using Params = ConventionalFlowParams;  ///< as given

  static constexpr bool holds_fluid = true;  ///< needs a crack to enter

  /// @param params validated
  /// @param law of the fluid
  /// @param leakoff law of what is lost
  ConventionalFlow(const Params& params, const Fluid& law, const RockResponse&,
                   const Leakoff& leakoff = Leakoff({}))
      : params_(params), law_(law), leakoff_(leakoff) {}

  /// Length of the next fluid step, s: as given, or one step of the flow.
  double fluid_dt(double) const {
    return params_.sub_cycling ? params_.fluid_dt : min(params_.fluid_dt, longest_flow_step());
  }

  /// Lets the fluid flow at the present widths, then the discs move at the present pressures.
  /// @throws RunStopped if that takes more steps of the flow than anybody would wait for
  template <class Relax>
  FluidStep advance(Network& network, const Injected& injected, Relax&& relax) {
    fluid_.join(network);
    fluid_.find_room(network);
    find_conductances(network);
    find_leakoff(network, injected.dt);
    find_limit(injected.dt);
    const double wanted = std::ceil(injected.dt / longest_flow_step());
    constexpr double far_too_many = 1e7;
    if (wanted > far_too_many)
      throw RunStopped("explicit flow would take " + in_words(wanted) +
                       " steps in a fluid step: a channel is too wide, or its fluid too thin");
    const auto flow_steps = static_cast<long>(max(1.0, wanted));
    for (long k = 0; k < flow_steps; ++k)
      flow(network, injected.dt / static_cast<double>(flow_steps),
           injected.step / static_cast<double>(flow_steps), 1 / static_cast<double>(flow_steps));
    publish(network);
    lose(network, flow_steps);
    const Relaxed relaxed = relax();
    // What the discs have moved, and the channels that they have opened, changes the pressures.
    fluid_.join(network);
    fluid_.find_room(network);
    find_pressures();
    publish(network);
    return {.mechanical_steps = 1,
            .unbalanced_ratio = relaxed.unbalanced_ratio,
            .flow_steps = flow_steps};
  }

  /// The longest step of the flow that would be stable, s, as of the last fluid step.
  double flow_limit() const { return limit_; }
  /// The channel that sets this limit: the most conductive one beside the domain that answers
  /// fastest; `nothing` before the first step.
  Index limiting_channel() const { return limiting_channel_; }

  /// The spring that a wet channel is for the discs beside it, N/m per m: an upper bound in that
  /// the springs of all channels together are no softer than the fluid.
  template <class F>
  void for_each_spring(F&& f) const {
    const auto room = fluid_.room(), half_length = fluid_.half_length();
    for (const auto& [c, first, second, length] : fluid_.channels())
      f(c, length / 2 *
               (law_.modulus(pressure_[first]) * half_length[first] / room[first] +
                law_.modulus(pressure_[second]) * half_length[second] / room[second]));
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

  /// What is stored and lost, and the limit.
  void exchange(auto& archive) {
    archive(fluid_, pressure_, limit_, limiting_channel_);
    if constexpr (Leakoff::leaks) archive(leakoff_);
  }

 private:
  double longest_flow_step() const { return params_.limit_fraction * limit_; }

  void find_conductances(const Network& network) {
    pressure_.resize(fluid_.size(), 0);
    conductance_.clear();
    for (const auto& [c, first, second, length] : fluid_.channels()) {
      const double a = pressure_[first], b = pressure_[second];
      conductance_.push_back(law_.conductance(network.width(c), length, a - b, (a + b) / 2));
    }
  }

  void find_leakoff(Network& network, double dt) {
    if constexpr (Leakoff::leaks) {
      leakoff_.join(network);
      leakoff_.find_loss(network, law_, dt, {pressure_, fluid_.stored()}, Euler::forward);
      taken_.assign(leakoff_.size(), 0);
      mean_.assign(leakoff_.size(), 0);
    }
  }

  /// What the flow took bit by bit, once more as the law has it at the mean pressures.
  void lose(Network& network, long flow_steps) {
    if constexpr (Leakoff::leaks) {
      for (double& p : mean_) p /= static_cast<double>(flow_steps);
      const auto stored = fluid_.stored();
      for (std::size_t d = 0; d < leakoff_.size(); ++d) stored[d] += taken_[d];
      leakoff_.commit(network, law_, {mean_, stored});
      for (std::size_t d = 0; d < leakoff_.size(); ++d) stored[d] -= leakoff_.loss(d, mean_[d]);
    }
  }

  void find_limit([[maybe_unused]] double dt) {
    const auto channels = fluid_.channels();
    leaving_.assign(fluid_.size(), 0);
    if constexpr (Leakoff::leaks)
      for (std::size_t d = 0; d < leakoff_.size(); ++d) leaving_[d] = leakoff_.slope(d) / dt;
    for (std::size_t k = 0; k < channels.size(); ++k) {
      leaving_[channels[k].first] += conductance_[k];
      leaving_[channels[k].second] += conductance_[k];
    }
    limit_ = std::numeric_limits<double>::infinity();
    std::size_t fastest = 0;
    for (std::size_t d = 0; d < fluid_.size(); ++d) {
      const double limit = fluid_.room()[d] / (law_.modulus(pressure_[d]) * leaving_[d]);
      if (limit < limit_) limit_ = limit, fastest = d;
    }
    double most = 0;
    for (std::size_t k = 0; k < channels.size(); ++k) {
      const bool beside = channels[k].first == fastest || channels[k].second == fastest;
      if (beside && conductance_[k] > most)
        most = conductance_[k], limiting_channel_ = channels[k].channel;
    }
  }

  void flow(const Network& network, double dt, double injected, [[maybe_unused]] double part) {
    const auto channels = fluid_.channels();
    const auto stored = fluid_.stored();
    for (std::size_t k = 0; k < channels.size(); ++k) {
      const auto [first, second] = std::pair{channels[k].first, channels[k].second};
      const double volume = conductance_[k] * (pressure_[first] - pressure_[second]) * dt;
      stored[first] -= volume;
      stored[second] += volume;
    }
    if constexpr (Leakoff::leaks)
      for (std::size_t d = 0; d < leakoff_.size(); ++d) {
        const double loss = part * leakoff_.loss(d, pressure_[d]);
        stored[d] -= loss;
        taken_[d] += loss;
        mean_[d] += pressure_[d];
      }
    fluid_.inject(injected, network.injection_domains().size());
    find_pressures();
  }

  void find_pressures() {
    pressure_.resize(fluid_.size(), 0);
    const auto stored = fluid_.stored();
    const auto room = fluid_.room();
    for (std::size_t d = 0; d < stored.size(); ++d)
      pressure_[d] = max(params_.pressure_floor, law_.pressure(stored[d] / room[d]));
  }

  void publish(Network& network) const {
    const auto domains = network.wet_domains();
    for (std::size_t d = 0; d < pressure_.size(); ++d)
      network.set_pressure(domains[d], pressure_[d]);
  }

  Params params_;
  Fluid law_;
  Leakoff leakoff_;
  StoredFluid fluid_;
  std::vector<double> pressure_;               // of each wet domain, Pa
  std::vector<double> taken_, mean_;           // of each: lost in this step, and mean pressure
  std::vector<double> conductance_, leaving_;  // of each wet channel, and around a domain
  double limit_ = std::numeric_limits<double>::infinity();
  Index limiting_channel_ = nothing;
};

}  // namespace hfdem
