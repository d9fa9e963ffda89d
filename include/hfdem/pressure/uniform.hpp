/// @file
/// The uniform-pressure algorithm for the toughness-dominated regime: the paper's Section 2.1,
/// Eqs. 1-3 and Fig. 2.
///
/// Viscosity spends nothing, so one pressure fills the whole crack; it is nudged until the volume
/// that the crack has opened, V_c, is the volume injected, V_f:
///
///   dP = alpha (V_f - V_c) / V_t        once per mechanical step
///
/// Two rules say when a fluid step ends:
///   the paper's   |V_f - V_c| <= 1 % of V_f, or ten mechanical steps;
///   equilibrium   |V_f - V_c| <= 0.1 % of V_f *and* the largest unbalanced force below 1e-3 of
///                 the mean contact force. Matched volume alone is not equilibrium.
/// What is unmet carries over to the next step. Where steps to equilibrium oscillate, alpha is
/// lowered until they converge again. A dry joint that the crack reaches has to be filled first; if
/// that takes more than there is, the pressure is zero until enough has been injected.
#pragma once

#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include <hfdem/base/fields.hpp>
#include <hfdem/base/pack.hpp>
#include <hfdem/state/network.hpp>
#include <hfdem/state/step.hpp>
#include <hfdem/state/volume_balance.hpp>

namespace hfdem {

/// A crack that keeps its fluid.
struct NoLoss {
  static constexpr double slope = 0;  ///< how the loss grows with pressure, m2/Pa
  /// Lost so far at a pressure, m2.
  double operator()(double /*pressure*/) const { return 0; }
};

/// A `PressureScheme`: one pressure in the whole crack.
class UniformPressure {
 public:
  /// Gain and tolerances.
  struct Params {
    double fluid_dt = 1e-4;
    double alpha = 0.2e6;
    double max_pressure_step = 0.2e6;
    bool equilibrium = false;
    std::optional<int> max_mechanical_steps{};  ///< 10 by the paper's rule, 1000 at equilibrium
    std::optional<double> volume_tolerance{};   ///< 1e-2 by the paper's rule, 1e-3 at equilibrium
    double unbalanced_tolerance = 1e-3;

    static constexpr auto fields() {
      using P = Params;
      return std::tuple{
          Field{"fluid_dt", &P::fluid_dt, "s", positive, "fluid time step"},
          Field{"alpha", &P::alpha, "Pa", positive,
                "pressure change per relative volume difference (Eq. 1)"},
          Field{"max_pressure_step", &P::max_pressure_step, "Pa", positive,
                "largest pressure change in one mechanical step"},
          Field{"equilibrium", &P::equilibrium, "", any_number,
                "end a fluid step at equilibrium instead of by the paper's rule"},
          Field{"max_mechanical_steps", &P::max_mechanical_steps, "", Range{1},
                "mechanical steps after which a fluid step ends in any case"},
          Field{"volume_tolerance", &P::volume_tolerance, "", Range{0, 1, true},
                "largest |V_f - V_c| / V_f at the end of a fluid step"},
          Field{"unbalanced_tolerance", &P::unbalanced_tolerance, "", positive,
                "largest resultant on a disc over the mean contact force at equilibrium"}};
    }

    /// With the rule's own values where none are given.
    Params resolved() const {
      Params p = *this;
      if (!p.max_mechanical_steps) p.max_mechanical_steps = equilibrium ? 1000 : 10;
      if (!p.volume_tolerance) p.volume_tolerance = equilibrium ? 1e-3 : 1e-2;
      return p;
    }
  };
  static constexpr bool holds_fluid = true;  ///< needs a crack to enter

  /// @param params validated
  explicit UniformPressure(const Params& params) : params_(params.resolved()) {}

  /// Fluid time of a step, s: the same for every step.
  double fluid_dt(double) const { return params_.fluid_dt; }

  /// Adds the injected volume and matches it: dP, one mechanical step, again until the rule is met.
  /// @param network to which the pressure is given
  /// @param injected so far
  /// @param relax makes one mechanical step
  /// @param loss by the end of the step as a function of pressure, m2, and its `slope`
  /// @throws RunStopped if the crack opens far more than was injected: no pressure in the allowed
  ///   range holds it any more
  template <class Relax, class Loss = NoLoss>
  FluidStep advance(Network& network, const Injected& injected, Relax&& relax,
                    const Loss& loss = {}) {
    const auto left = [&] {
      return injected.total - loss(network.pressure(network.injection_domain()));
    };
    FluidStep step;
    do {
      const bool was_too_much = std::exchange(too_much_, network.crack_volume() > left());
      if (params_.equilibrium && too_much_ != was_too_much && ++turns_ > usual_turns)
        gain_ = max(least_gain, gain_ / 2);
      raise_pressure(network, left(), loss.slope);
      const Relaxed relaxed = relax();
      ++step.mechanical_steps;
      step.unbalanced_ratio = relaxed.unbalanced_ratio;
      give_way(network, left(), relaxed.joined_volume);
      if (has_opened(network, 10 * injected.total)) stop_runaway(network, injected.total);
      const double wanted = injected.total > 0 ? injected.total : network.rest_volume();
      step.volume_error = std::abs(left() - network.crack_volume()) / wanted;
      const bool matched = step.volume_error <= *params_.volume_tolerance;
      step.converged = params_.equilibrium
                           ? (matched || is_half_empty(network, left())) &&
                                 relaxed.unbalanced_ratio < params_.unbalanced_tolerance
                           : matched;
    } while (!step.converged && step.mechanical_steps < *params_.max_mechanical_steps);
    running_away_ = has_opened(network, 2 * injected.total) ? running_away_ + 1 : 0;
    if (running_away_ > patience) stop_runaway(network, injected.total);
    if (step.converged) turns_ = 0, gain_ = min(1.0, 1.25 * gain_);
    // What turned wet in the last mechanical step has the pressure, too.
    fill(network, network.pressure(network.injection_domain()));
    return step;
  }

  /// Where the fluid is.
  /// @param network with widths and pressures
  /// @param injected so far, m2
  VolumeBalance balance(const Network& network, double injected) const {
    return {.injected = injected,
            .initial = network.filled_volume(),
            .stored = network.total_volume(),
            .unmet = injected - network.crack_volume()};
  }

  /// What the control remembers; the pressure is the network's.
  void exchange(auto& archive) { archive(gain_, turns_, too_much_, running_away_); }

 private:
  void raise_pressure(Network& network, double injected, double loss_slope) const {
    const double gain = gain_ * params_.alpha;
    const double volume = max(network.total_volume(), network.rest_volume()) + gain * loss_slope;
    const double wanted = gain * (injected - network.crack_volume()) / volume;
    const double change = clamp(wanted, -params_.max_pressure_step, params_.max_pressure_step);
    fill(network, max(0.0, network.pressure(network.injection_domain()) + change));
  }

  /// What a dry joint takes is missing in the crack at once. Pressure falls by as much of itself as
  /// volume is taken, at least as far as in an elastic crack: Eq. 1 then raises it to the match.
  /// From above it would first open the joint with fluid that there is not.
  static void give_way(Network& network, double injected, double joined) {
    if (joined > 0)
      fill(network, network.pressure(network.injection_domain()) *
                        max(0.0, 1 - joined / max(injected, joined)));
  }

  static void fill(Network& network, double pressure) {
    for (const Index d : network.wet_domains()) network.set_pressure(d, pressure);
  }

  /// Whether there is too little fluid to fill the crack even without pressure, as after it has
  /// reached a dry joint: then no pressure matches the volumes until more is injected.
  static bool is_half_empty(const Network& network, double injected) {
    return network.pressure(network.injection_domain()) <= 0 && network.crack_volume() > injected;
  }

  /// Whether the crack holds more than so much fluid could fill, m2.
  static bool has_opened(const Network& network, double volume) {
    return network.crack_volume() > volume + network.rest_volume();
  }
  [[noreturn]] static void stop_runaway(const Network& network, double injected) {
    throw RunStopped("the crack ran away from its fluid: it has opened " +
                     in_words(network.crack_volume()) + " m2 while " + in_words(injected) +
                     " m2 were injected. Either the specimen is splitting, or scheme.alpha is "
                     "too large or too small for it");
  }

  /// Between too much and too little, while a crack advances; more are an oscillation that alpha
  /// feeds, as where soft joints let the rock answer slowly.
  static constexpr int usual_turns = 12;
  static constexpr double least_gain = 1.0 / 16;
  /// Fluid steps that the pressure is given to catch a crack that breaks through and holds more
  /// than twice what was injected.
  static constexpr int patience = 10;

  Params params_;
  double gain_ = 1;        ///< part of alpha that is in use
  int turns_ = 0;          ///< since the last converged step
  bool too_much_ = false;  ///< whether the crack held more than was injected
  int running_away_ = 0;   ///< fluid steps in a row at whose end it held far more
};

}  // namespace hfdem
