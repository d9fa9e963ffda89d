/// @file
/// A crack as it is on the mean over some time: it grows in steps of a disc, and an instant says
/// where on a step it is.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <hfdem/measure/crack.hpp>
#include <hfdem/state/step.hpp>
#include <hfdem/state/volume_balance.hpp>

namespace hfdem::support {

/// One place along the crack.
struct MeanPoint {
  double along = 0;         ///< from the injection, m
  double opening = 0;       ///< w - w0, m
  double net_pressure = 0;  ///< Pa
};

/// Means over a window of time.
struct CrackReading {
  double time = 0;                   ///< s
  double half_length = 0;            ///< m
  double opening = 0;                ///< w - w0 at the injection, m
  double net_pressure = 0;           ///< at the injection, Pa
  double least_pressure = INFINITY;  ///< of all wet domains and fluid steps of the window, Pa
  double lag = 0;                    ///< part of the crack at the least pressure
  double leaked = 0;                 ///< part of the injection that is in the rock
  std::vector<MeanPoint> profile{};  ///< of one wing, where it was broken all the time
  int off_plane = 0;                 ///< bonds that broke beside the crack's line, in all
  long unconverged = 0;              ///< fluid steps, in all
  long mechanical_steps = 0;         ///< in all
  std::string stopped{};             ///< why the run ended early; empty if it did not

  void exchange(auto& archive) {
    archive(time, half_length, opening, net_pressure, least_pressure, lag, leaked, profile,
            off_plane, unconverged, mechanical_steps, stopped);
  }
};

/// An observer of a crack that injection drives.
class CrackWatch {
 public:
  /// @param from begin of the window, s; it ends with the run
  /// @param closing in-situ stress across the crack, Pa
  /// @param floor least pressure of the fluid, Pa
  CrackWatch(double from, double closing, double floor)
      : from_(from), closing_(closing), floor_(floor) {}

  /// Heard after every fluid step.
  template <class Sim>
  void fluid_step(const Sim& sim, const FluidStep& step) {
    sums_.unconverged += step.converged ? 0 : 1;
    const double dt = sim.time() - before_;
    before_ = sim.time();
    if (before_ < from_) return;
    const auto shape = measure::crack_shape(sim);
    seconds_ += dt;
    sums_.time += dt * sim.time();
    sums_.half_length += dt * shape.full_length() / 2;
    sums_.opening += dt * shape.opening;
    sums_.net_pressure += dt * (sim.injection_pressure() - closing_);
    const VolumeBalance volumes = sim.volume_balance();
    sums_.leaked += dt * volumes.leaked / volumes.injected;
    const auto domains = sim.network().wet_domains();
    for (const Index d : domains) {
      const double pressure = sim.network().pressure(d);
      sums_.least_pressure = std::fmin(sums_.least_pressure, pressure);
      if (pressure <= floor_) sums_.lag += dt / static_cast<double>(domains.size());
    }
    for (const measure::CrackPoint& p : measure::crack_profile(sim)) {
      if (p.along < 0) continue;
      Place& place = places_[std::lround(p.along * 1e6)];
      place.seconds += dt;
      place.sum.along += dt * p.along;
      place.sum.opening += dt * p.opening;
      place.sum.net_pressure += dt * (p.pressure - closing_);
    }
  }

  /// What was seen. @param sim at the end of the run
  template <class Sim>
  CrackReading reading(const Sim& sim) const {
    CrackReading mean = sums_;
    for (double* sum : {&mean.time, &mean.half_length, &mean.opening, &mean.net_pressure, &mean.lag,
                        &mean.leaked})
      *sum /= seconds_;
    for (const auto& [micrometres, place] : places_)
      if (place.seconds > (1 - 1e-9) * seconds_)
        mean.profile.push_back({place.sum.along / seconds_, place.sum.opening / seconds_,
                                place.sum.net_pressure / seconds_});
    mean.off_plane = measure::broken_off_plane(sim);
    mean.mechanical_steps = sim.mechanical_steps();
    return mean;
  }

 private:
  struct Place {
    double seconds = 0;
    MeanPoint sum{};
  };

  double from_, closing_, floor_;
  double before_ = 0, seconds_ = 0;
  CrackReading sums_{};
  std::map<long, Place> places_{};  // by the distance from the injection, in micrometres
};

}  // namespace hfdem::support
