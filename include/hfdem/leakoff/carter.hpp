/// @file
/// Carter's leak-off: the rock takes fluid from the walls of the crack at a rate that falls with
/// the square root of time since they turned wet, whatever the pressure.
///
/// Source: G. C. Howard, C. R. Fast, "Optimum fluid characteristics for fracture extension",
/// Drill. Prod. Pract. (1957) 261-270, appendix by E. D. Carter. A channel of length l_p, wet since
/// t0, loses through both faces
///
///   C' l_p / (t - t0)^(1/2)  per second,   2 C' l_p [(t + dt - t0)^(1/2) - (t - t0)^(1/2)]  in dt,
///
/// C' = 2 C_L; half of it is taken from either end, and never more than a domain holds when the
/// step is over. Flow in the rock is that of one dimension, at right angles to the crack: no pore
/// pressure, no interaction.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

#include <hfdem/base/fields.hpp>
#include <hfdem/state/leakoff.hpp>
#include <hfdem/state/network.hpp>

namespace hfdem {

/// A `LeakoffLaw`: Carter's.
class CarterLeakoff {
 public:
  /// How much is lost.
  struct Params {
    double coefficient = 1e-5;

    static constexpr auto fields() {
      return std::tuple{Field{"coefficient", &Params::coefficient, "m/s^0.5", non_negative,
                              "Carter's leak-off coefficient C_L of one face"}};
    }
  };
  static constexpr bool leaks = true;  ///< something is lost

  /// @param p validated parameters
  explicit CarterLeakoff(const Params& p) : both_faces_(2 * p.coefficient) {}

  /// Walls that have turned wet since the last fluid step count from now on.
  void join(Network& network) {
    wet_since_.resize(network.wet_channels().size(), time_);
    if (place_.empty()) place_.assign(network.geometry().centre.size(), nothing);
    const auto domains = network.wet_domains();
    for (std::size_t d = loss_.size(); d < domains.size(); ++d)
      place_[domains[d]] = static_cast<Index>(d);
    loss_.resize(domains.size(), 0);
  }

  /// What each wet domain loses in a fluid step.
  /// @param network for its wet channels
  /// @param dt length of the step, s
  template <class Fluid>
  void find_loss(const Network& network, const Fluid&, double dt, const CrackFluid&, Euler) {
    dt_ = dt;
    std::fill(loss_.begin(), loss_.end(), 0);
    const auto wet = network.wet_channels();
    for (std::size_t k = 0; k < wet_since_.size(); ++k) {
      const auto& [ends, length] = network.geometry().channels[wet[k]];
      const double since = time_ - wet_since_[k];
      const double loss = 2 * both_faces_ * length * (std::sqrt(since + dt) - std::sqrt(since)) / 2;
      for (const Index end : ends)
        if (end != nothing) loss_[place_[end]] += loss;
    }
  }

  std::size_t size() const { return loss_.size(); }  ///< of the wet domains, those that lose fluid
  /// What a domain loses in the step, m2, at any pressure.
  double loss(std::size_t domain, double /*pressure*/) const { return loss_[domain]; }
  /// How it grows with pressure, m2/Pa.
  double slope(std::size_t) const { return 0; }
  /// The step is over.
  /// @param crack what the wet domains hold, this step's loss included
  template <class Fluid>
  void commit(Network&, const Fluid&, const CrackFluid& crack) {
    for (std::size_t d = 0; d < loss_.size(); ++d) {
      loss_[d] = std::clamp(crack.stored[d], 0.0, loss_[d]);
      leaked_ += loss_[d];
    }
    time_ += dt_;
  }
  double leaked() const { return leaked_; }  ///< so far, m2

  /// Since when walls are wet, and what they have lost.
  void exchange(auto& archive) { archive(place_, wet_since_, loss_, leaked_, time_, dt_); }

 private:
  double both_faces_;              // C', m/s^0.5
  std::vector<Index> place_;       // of each domain of the network among the wet ones
  std::vector<double> wet_since_;  // of each wet channel, s
  std::vector<double> loss_;       // of each wet domain in this step, m2
  double leaked_ = 0, time_ = 0, dt_ = 0;
};

}  // namespace hfdem
