/// @file
/// Flow through the rock: intact contacts conduct, too, and the voids between the discs are pores.
///
/// Source: the paper's Section 5.1 (case L1-S1), its Eq. 5 with the aperture of Eq. 6. Each domain
/// of the rock is a pore, V the void that its discs leave. It holds `saturation` V at first, and
/// has a pressure P >= 0 once it is full, which pushes its discs. A channel between a pore and the
/// crack, or another pore, carries what the cubic law says at its contact's aperture. Pores do not
/// deform, and the rim of the specimen is sealed.
///
/// A domain that the crack reaches becomes part of the crack: it stores fluid in its wet channels,
/// and its void keeps what it holds. Dry voids beside a crack would otherwise swallow the fluid:
/// between the discs there is room for many times what a crack of this size opens.
///
/// At the end of a step, F being what a full pore of unit volume holds at a pressure,
///
///   held + dt (net inflow at P) = V F(P) where P > 0,  <= V F(0) where P = 0,
///
/// with the crack's pressures given; pores that are not full stay out of Newton's method.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/fields.hpp>
#include <hfdem/base/graph_system.hpp>
#include <hfdem/base/pack.hpp>
#include <hfdem/leakoff/pore_network.hpp>
#include <hfdem/state/leakoff.hpp>
#include <hfdem/state/network.hpp>

#include <Eigen/OrderingMethods>

namespace hfdem {

/// A `LeakoffLaw`: the paper's.
class MatrixFlow {
 public:
  /// The pores.
  struct Params {
    double saturation = 0;
    double least_porosity = 0.01;

    static constexpr auto fields() {
      using P = Params;
      return std::tuple{
          Field{"saturation", &P::saturation, "", Range{0, 1},
                "part of each pore that is full before injection, at no pressure"},
          Field{
              "least_porosity", &P::least_porosity, "", Range{0, 1, true},
              "least volume of a pore over the area of its domain: overlapping discs leave less"}};
    }
  };
  static constexpr bool leaks = true;                 ///< something is lost
  static constexpr bool conducts_when_intact = true;  ///< needs the widths of intact channels

  /// @param p validated parameters
  explicit MatrixFlow(const Params& p) : saturation_(p.saturation), pores_(p.least_porosity) {}

  /// Domains that have turned wet since the last fluid step are the crack's from now on.
  void join(Network& network) {
    if (gained_.empty()) {
      gained_.assign(network.geometry().centre.size(), 0);
      pressure_ = gained_;
    }
    const std::size_t before = pores_.crack_size();
    pores_.join(network);
    if (pores_.crack_size() == before) return;
    loss_.resize(pores_.crack_size(), 0);
    slope_.resize(pores_.crack_size(), 0);
    system_.forget_pattern();
  }

  /// What each wet domain loses in a fluid step.
  /// @param network for the widths of its channels
  /// @param fluid law of the fluid
  /// @param dt length of the step, s
  /// @param crack pressures of the wet domains, kept during the step
  /// @param euler forward: at the pores' present pressures; backward: at those of the step's end
  /// @throws RunStopped if the equations have no solution
  template <class Fluid>
  void find_loss(const Network& network, const Fluid& fluid, double dt, const CrackFluid& crack,
                 Euler euler) {
    dt_ = dt;
    euler_ = euler;
    crack_.assign(crack.pressure.begin(), crack.pressure.begin() + static_cast<long>(size()));
    if (euler == Euler::backward) {
      do find_pressures(network, fluid);
      while (follow_pressure(network));
    } else {
      start(network, fluid);
    }
    add_up_walls();
  }

  std::size_t size() const { return loss_.size(); }  ///< of the wet domains, those that lose fluid
  /// What a domain loses in the step, m2; exact at the pressure at which it was found.
  /// @param domain by the order in which it turned wet
  /// @param pressure in it, Pa
  double loss(std::size_t domain, double pressure) const {
    return loss_[domain] + slope_[domain] * (pressure - crack_[domain]);
  }
  /// How it grows with pressure, m2/Pa.
  double slope(std::size_t domain) const { return slope_[domain]; }

  /// The step is over: what flowed has flowed, and the pores have their pressures.
  /// @param network whose pores they are
  /// @param fluid law of the fluid
  /// @param crack pressures of the wet domains; going backward, those at which the loss was found
  /// @throws RunStopped if that takes more steps of the flow than anybody would wait for
  template <class Fluid>
  void commit(Network& network, const Fluid& fluid, const CrackFluid& crack) {
    if (euler_ == Euler::forward) {
      crack_.assign(crack.pressure.begin(), crack.pressure.begin() + static_cast<long>(size()));
      flow_forward(fluid);
    } else {
      move_fluid(1);
    }
    const auto domains = pores_.domains();
    for (std::size_t m = 0; m < domains.size(); ++m) {
      pressure_[domains[m]] = trial_[m];
      network.soak(domains[m], trial_[m]);
    }
    if (euler_ == Euler::forward) follow_pressure(network);
  }

  /// What the pores have gained, m2.
  double leaked() const {
    double volume = 0;
    for (const Index d : pores_.reached()) volume += gained_[d];
    return volume;
  }
  /// Which part of a pore is full. @param network whose pore it is @param domain of it
  double filling(const Network& network, Index domain) const {
    const double gained = gained_.empty() ? 0 : gained_[domain];
    return min(1.0, saturation_ + gained / pores_.room(network, domain));
  }

  /// What the pores hold, and which of them count.
  void exchange(auto& archive) { archive(pores_, gained_, pressure_, loss_, slope_); }

 private:
  /// Reaches out where pressure has come to the edge of the pores that count.
  bool follow_pressure(const Network& network) {
    double most = 0;
    for (const double p : crack_) most = max(most, p);
    for (const double p : trial_) most = max(most, p);
    constexpr double hardly_any = 1e-6;
    const bool extended =
        pores_.reach_beyond(network, [&](Index m) { return trial_[m] > hardly_any * most; });
    if (extended) system_.forget_pattern();
    return extended;
  }

  /// Starts from the pores' present pressures.
  template <class Fluid>
  void start(const Network& network, const Fluid& fluid) {
    trial_.clear();
    for (const Index d : pores_.domains()) trial_.push_back(pressure_[d]);
    find_conductances(network, fluid);
  }

  /// Volumes that flow in the step per pressure drop.
  template <class Fluid>
  void find_conductances(const Network& network, const Fluid& fluid) {
    const auto conductance = [&](Index channel, double a, double b) {
      const double length = network.geometry().channels[channel].length;
      return dt_ * fluid.conductance(network.width(channel), length, a - b, (a + b) / 2);
    };
    flow_.clear(), through_wall_.clear();
    for (const auto& [c, first, second] : pores_.inner())
      flow_.push_back(conductance(c, trial_[first], trial_[second]));
    for (const auto& [c, crack, pore] : pores_.walls())
      through_wall_.push_back(conductance(c, crack_[crack], trial_[pore]));
  }

  /// Calls f(pore, volume that it gains) for both ends of each inner channel and for each wall.
  template <class F>
  void for_each_gain(F&& f) const {
    const auto& inner = pores_.inner();
    for (std::size_t k = 0; k < inner.size(); ++k) {
      const double volume = flow_[k] * (trial_[inner[k].first] - trial_[inner[k].second]);
      f(inner[k].first, -volume);
      f(inner[k].second, volume);
    }
    const auto walls = pores_.walls();
    for (std::size_t k = 0; k < walls.size(); ++k)
      f(walls[k].pore, through_wall_[k] * (crack_[walls[k].crack] - trial_[walls[k].pore]));
  }

  template <class Fluid>
  void find_residual(const Fluid& fluid) {
    residual_.clear();
    const auto domains = pores_.domains();
    for (std::size_t m = 0; m < domains.size(); ++m)
      residual_.push_back(gained_[domains[m]] +
                          pores_.room()[m] * (saturation_ - fluid.filling(trial_[m])));
    for_each_gain([&](Index m, double volume) { residual_[m] += volume; });
  }
  bool is_full(std::size_t m) const { return trial_[m] > 0 || residual_[m] > 0; }

  /// The pores' pressures at the end of the step.
  template <class Fluid>
  void find_pressures(const Network& network, const Fluid& fluid) {
    start(network, fluid);
    find_residual(fluid);
    constexpr int most_iterations = 100;
    for (int k = 0; k < most_iterations; ++k) {
      full_.clear();
      for (std::size_t m = 0; m < trial_.size(); ++m) full_.push_back(is_full(m));
      make_newton_step(fluid);
      find_conductances(network, fluid);
      find_residual(fluid);
      if (is_solved()) return;
    }
  }

  template <class Fluid>
  void make_newton_step(const Fluid& fluid) {
    find_stiffness(fluid);
    const bool found = system_.factorise(pores_.inner(), {own_, flow_}, full_);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(trial_.size()));
    for (std::size_t m = 0; m < trial_.size(); ++m)
      if (full_[m]) right[system_.row(m)] = residual_[m];
    const Eigen::VectorXd change = system_.solve(right);
    double all = 0;  // keeps what is not a number; a maximum loses it
    for (std::size_t m = 0; m < trial_.size(); ++m) {
      all += change[system_.row(m)];
      trial_[m] = max(0.0, trial_[m] + change[system_.row(m)]);
    }
    if (!found || !std::isfinite(all))
      throw RunStopped(
          "the pressures in the rock have no solution: a width or a pressure is not a finite "
          "number");
  }

  /// Without the channels between pores.
  template <class Fluid>
  void find_stiffness(const Fluid& fluid) {
    own_.clear();
    for (std::size_t m = 0; m < trial_.size(); ++m)
      own_.push_back(pores_.room()[m] / fluid.modulus(trial_[m]));
    const auto walls = pores_.walls();
    for (std::size_t k = 0; k < walls.size(); ++k) own_[walls[k].pore] += through_wall_[k];
  }

  /// Whether the same pores are full as in the last step, and nothing is missing in them.
  bool is_solved() const {
    constexpr double precision = 1e-9;
    double missing = 0, moved = 0;
    bool same = true;
    for (std::size_t m = 0; m < trial_.size(); ++m) {
      same = same && is_full(m) == full_[m];
      if (is_full(m)) missing += std::abs(residual_[m]);
    }
    for_each_gain([&](Index, double volume) { moved += std::abs(volume); });
    return same && missing <= precision * moved;
  }

  /// What goes through the walls, and how that answers the crack's pressure: going backward, each
  /// pore does, too, its neighbours being as they are.
  void add_up_walls() {
    std::fill(loss_.begin(), loss_.end(), 0);
    std::fill(slope_.begin(), slope_.end(), 0);
    std::vector<double> stiffness;
    if (euler_ == Euler::backward) {
      stiffness = own_;
      for (std::size_t k = 0; k < flow_.size(); ++k)
        for (const Index m : {pores_.inner()[k].first, pores_.inner()[k].second})
          stiffness[m] += flow_[k];
    }
    const auto walls = pores_.walls();
    for (std::size_t k = 0; k < walls.size(); ++k) {
      const auto& [c, crack, pore] = walls[k];
      const double through = through_wall_[k];
      const bool answers = euler_ == Euler::backward && trial_[pore] > 0;
      loss_[crack] += through * (crack_[crack] - trial_[pore]);
      slope_[crack] += through * (answers ? 1 - through / stiffness[pore] : 1);
    }
  }

  /// Lets flow what flows in a part of the step.
  void move_fluid(double part) {
    const auto domains = pores_.domains();
    for_each_gain([&](Index m, double volume) { gained_[domains[m]] += part * volume; });
  }

  /// The whole step, in as many as explicit flow needs.
  template <class Fluid>
  void flow_forward(const Fluid& fluid) {
    find_stiffness(fluid);
    std::vector<double> leaving(trial_.size(), 0);
    for (std::size_t k = 0; k < flow_.size(); ++k) {
      leaving[pores_.inner()[k].first] += flow_[k];
      leaving[pores_.inner()[k].second] += flow_[k];
    }
    double wanted = 1;
    const auto room = pores_.room();
    for (std::size_t m = 0; m < trial_.size(); ++m) {
      const double filling = room[m] / fluid.modulus(trial_[m]);
      constexpr double limit_fraction = 0.8;
      wanted = max(wanted, (leaving[m] + own_[m] - filling) / (limit_fraction * filling));
    }
    constexpr double far_too_many = 1e6;
    if (!(wanted < far_too_many))
      throw RunStopped("explicit flow through the rock would take " + in_words(wanted) +
                       " steps in a fluid step: an intact channel is too wide, or its fluid too "
                       "thin; implicit flow takes one");
    const double part = 1 / std::ceil(wanted);
    std::fill(loss_.begin(), loss_.end(), 0);
    const auto domains = pores_.domains();
    const auto walls = pores_.walls();
    for (int k = 0; k < static_cast<int>(std::ceil(wanted)); ++k) {
      move_fluid(part);
      for (std::size_t w = 0; w < walls.size(); ++w)
        loss_[walls[w].crack] +=
            part * through_wall_[w] * (crack_[walls[w].crack] - trial_[walls[w].pore]);
      for (std::size_t m = 0; m < trial_.size(); ++m)
        trial_[m] = max(0.0, fluid.pressure(saturation_ + gained_[domains[m]] / room[m]));
    }
  }

  double saturation_;
  PoreNetwork pores_;
  std::vector<double> gained_, pressure_;  // of each domain of the network, m2 and Pa
  std::vector<double> loss_, slope_;       // of each wet domain
  // ---- while a step is made ---------------------------------------------------------------------
  double dt_ = 0;
  Euler euler_ = Euler::backward;
  std::vector<double> crack_;                // pressure of each wet domain, Pa
  std::vector<double> trial_, residual_;     // of each pore: pressure, and what has no room
  std::vector<double> flow_, through_wall_;  // of each inner channel, and each wall: m2/Pa
  std::vector<double> own_;                  // of each pore, m2/Pa
  std::vector<bool> full_;                   // the pores that took part in the last step
  GraphSystem<Eigen::AMDOrdering<int>> system_;
};

}  // namespace hfdem
