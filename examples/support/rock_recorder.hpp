/// @file
/// What is read from a run in random rock while it goes on.
#pragma once

#include <cmath>
#include <optional>
#include <ostream>
#include <string>

#include <hfdem/observe/growth.hpp>

#include "support/progress.hpp"
#include "support/rock_outcome.hpp"

namespace hfdem::support {

/// How a run ended.
struct RunEnd {
  std::string stopped{};  ///< why before its time; empty if it did not
  bool at_rim = false;    ///< because the crack reached the rim: no failure
};

/// Carries a run through whatever may end it; a crack that reaches the rim is no failure, unless it
/// was there from the beginning.
/// @param sim what `run` makes
template <class Sim, class Run>
RunEnd end_of(const std::optional<Sim>& sim, Run&& run) {
  try {
    run();
  } catch (const ReachedRim& reason) {
    if (sim) return {.at_rim = true};
    return {.stopped = reason.what()};
  } catch (const RunStopped& reason) {
    return {.stopped = reason.what()};
  }
  return {};
}

/// An observer of a run.
template <class Config>
class RockRecorder {
 public:
  /// @param history written row by row; must outlive the recorder
  RockRecorder(const Config& config, std::ostream& history)
      : config_(config), growth_(history, config.run.output_interval, config.closing_stress()) {}

  /// Call once the specimen has settled.
  void begin() { watch_ = Stopwatch(); }

  template <class Sim>
  void fluid_step(const Sim& sim, const FluidStep& step) {
    growth_.fluid_step(sim, step);
    if (sim.time() >= config_.readings.breakdown_from)
      peak_pressure_ = std::fmax(peak_pressure_, sim.injection_pressure());
    unconverged_ += step.converged ? 0 : 1;
    balance_error_ = std::fmax(balance_error_, sim.volume_balance().relative_error());
  }

  /// What the run has come to so far.
  void exchange(auto& archive) {
    archive(growth_, peak_pressure_, unconverged_, balance_error_, watch_);
  }

  /// @param how the run ended
  template <class Sim>
  RockOutcome outcome(const Sim& sim, const RunEnd& how) const {
    const auto microcracks = measure::microcracks(sim);
    const auto in_joint = [](const measure::Microcrack& m) { return m.in_joint; };
    RockOutcome o{.end = observe::growth_instant(sim),
                  .crack = measure::crack_path(microcracks, measure::crack_origin(sim)),
                  .count = measure::count(microcracks),
                  .in_joints = measure::count(microcracks, in_joint),
                  .first_break = first_break_pressure(sim),
                  .breakdown = peak_pressure_,
                  .propagation = growth_.mean_pressure(config_.readings.propagation_from,
                                                       config_.readings.propagation_to),
                  .run = {how.stopped, unconverged_, watch_.seconds()}};
    // A break within a fluid step may see more pressure than its end.
    for (const BondBreak& b : sim.breaks())
      if (b.time >= config_.readings.breakdown_from)
        o.breakdown = std::fmax(o.breakdown, b.pressure);
    o.pressure_drop = pressure_drop(sim);
    o.balance_error = balance_error_;
    if (how.at_rim) o.rim_time = sim.time();
    return o;
  }

  const observe::Growth& growth() const { return growth_; }

 private:
  /// How far the mean pressure of the crack is below that of the injection, Pa.
  template <class Sim>
  static double pressure_drop(const Sim& sim) {
    const Network& network = sim.network();
    const auto wet = network.wet_domains();
    double sum = 0;
    for (const Index d : wet) sum += sim.injection_pressure() - network.pressure(d);
    return sum / static_cast<double>(wet.size());
  }

  const Config& config_;
  observe::Growth growth_;
  double peak_pressure_ = 0, balance_error_ = 0;
  long unconverged_ = 0;
  Stopwatch watch_;
};

}  // namespace hfdem::support
