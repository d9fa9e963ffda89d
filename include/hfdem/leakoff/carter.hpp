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
/// step is over. The rate is the smaller the deeper the fluid has come, V dV = 2 C'^2 l_p^2 dt for
/// what a channel has lost, V; so we count V instead of time, and a wall that found too little
/// fluid, as at the tip of a crack that grows fast, goes on taking it the faster. Flow in the rock
/// is that of one dimension, at right angles to the crack: no pore pressure, no interaction.
#pragma once

#include <algorithm>
#include <array>
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

  /// The walls of channels that have turned wet since the last fluid step have lost nothing yet.
  void join(Network& network) {
    lost_.resize(network.wet_channels().size(), {0, 0});
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
    for_ends(network, [&](std::size_t domain, double lost, double length) {
      loss_[domain] += further(lost, length);
    });
  }

  std::size_t size() const { return loss_.size(); }  ///< of the wet domains, those that lose fluid
  /// What a domain loses in the step, m2, at any pressure.
  double loss(std::size_t domain, double /*pressure*/) const { return loss_[domain]; }
  /// How it grows with pressure, m2/Pa.
  double slope(std::size_t) const { return 0; }
  /// The step is over.
  /// @param network as it was for `find_loss`
  /// @param crack what the wet domains hold, this step's loss included
  template <class Fluid>
  void commit(Network& network, const Fluid&, const CrackFluid& crack) {
    for_ends(network, [&](std::size_t domain, double& lost, double length) {
      const double wanted = loss_[domain];
      const double part = wanted > 0 ? std::clamp(crack.stored[domain] / wanted, 0.0, 1.0) : 1;
      lost += part * further(lost, length);
    });
    for (std::size_t d = 0; d < loss_.size(); ++d) {
      loss_[d] = std::clamp(crack.stored[d], 0.0, loss_[d]);
      leaked_ += loss_[d];
    }
  }
  double leaked() const { return leaked_; }  ///< so far, m2

  /// What every wall has lost.
  void exchange(auto& archive) { archive(place_, lost_, loss_, leaked_, dt_); }

 private:
  /// Calls `f(wet domain, what it has lost through this channel, the channel's length)`.
  template <class F>
  void for_ends(const Network& network, F&& f) {
    const auto wet = network.wet_channels();
    for (std::size_t k = 0; k < lost_.size(); ++k) {
      const auto& [ends, length] = network.geometry().channels[wet[k]];
      for (std::size_t e = 0; e < 2; ++e)
        if (ends[e] != nothing) f(place_[ends[e]], lost_[k][e], length);
    }
  }

  /// What one end of a channel loses in the step if there is enough, m2: of either end,
  /// V^2 = (C' l_p)^2 (t - t0).
  double further(double lost, double length) const {
    const double squares = both_faces_ * length * both_faces_ * length * dt_;
    return squares > 0 ? squares / (std::sqrt(lost * lost + squares) + lost) : 0;
  }

  double both_faces_;                        // C', m/s^0.5
  std::vector<Index> place_;                 // of each domain of the network among the wet ones
  std::vector<std::array<double, 2>> lost_;  // of each wet channel, from its two ends, m2
  std::vector<double> loss_;                 // of each wet domain in this step, m2
  double leaked_ = 0, dt_ = 0;
};

}  // namespace hfdem
