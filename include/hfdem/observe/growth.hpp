/// @file
/// How an irregular crack grows: pressure, tips, lengths and microcracks over time (the paper's
/// Figs. 10 and 11), as a table that Python and a spreadsheet open.
#pragma once

#include <algorithm>
#include <cmath>
#include <ostream>
#include <vector>

#include <hfdem/measure/crack_path.hpp>
#include <hfdem/measure/microcracks.hpp>
#include <hfdem/measure/path_profile.hpp>
#include <hfdem/observe/history.hpp>
#include <hfdem/observe/interval.hpp>

namespace hfdem::observe {

/// What is remembered of one instant, SI.
struct GrowthInstant {
  double time, pressure;         ///< s, Pa; at the injection
  double tip_up, tip_down;       ///< reach of both tips along the crack's direction, m
  double tip_distance;           ///< L, m
  double path_length;            ///< of the path from tip to tip, m
  double connected_length;       ///< of all microcracks that hold fluid, L_0, m
  double total_length;           ///< of all microcracks, m
  double tortuosity, asymmetry;  ///< as in `measure::CrackPath`
  double aperture, opening;      ///< means over 30 mm of path to both sides, m
  double fluid_volume;           ///< injected, V_f, m2
  double crack_volume;           ///< opened, V_c, m2
  int connected, unconnected;    ///< microcracks, the preset crack among them
};

/// Measures a run at this instant.
template <class Sim>
GrowthInstant growth_instant(const Sim& sim) {
  const auto microcracks = measure::microcracks(sim);
  const auto crack = measure::crack_path(microcracks, measure::crack_origin(sim));
  const auto profile = measure::path_profile(microcracks, crack, 0);
  const auto mean = measure::mean_aperture(profile);
  const auto counts = measure::count(microcracks);
  return {.time = sim.time(),
          .pressure = sim.injection_pressure(),
          .tip_up = crack.up.reach,
          .tip_down = crack.down.reach,
          .tip_distance = crack.tip_distance(),
          .path_length = crack.path_length,
          .connected_length = crack.connected_length(),
          .total_length = counts.connected.length + counts.unconnected.length,
          .tortuosity = crack.tortuosity(),
          .asymmetry = crack.asymmetry(),
          .aperture = mean.aperture,
          .opening = mean.opening,
          .fluid_volume = sim.injected_volume(),
          .crack_volume = sim.network().crack_volume(),
          .connected = counts.connected.total(),
          .unconnected = counts.unconnected.total()};
}

/// An observer that writes a row every `interval` seconds of simulated time, and remembers it.
class Growth {
 public:
  /// @param out must outlive the observer
  /// @param interval s; a row follows the first fluid step at or after each multiple of it
  /// @param far_field in-situ stress across the crack, Pa: net pressure is measured from it
  Growth(std::ostream& out, double interval, double far_field)
      : out_(out), interval_(interval), far_field_(far_field) {
    out_ << "time_s,injection_pressure_Pa,net_pressure_Pa,tip_distance_m,tip_up_m,tip_down_m,"
            "crack_path_length_m,connected_length_m,total_length_m,tortuosity,asymmetry,"
            "mean_aperture_m,mean_opening_m,fluid_volume_m2,crack_volume_m2,"
            "connected_microcracks,unconnected_microcracks,mechanical_steps,converged\n";
  }

  /// Heard after every fluid step.
  template <class Sim>
  void fluid_step(const Sim& sim, const FluidStep& step) {
    if (!interval_.is_due(sim.time())) return;
    interval_.wait_from(sim.time());
    instants_.push_back(growth_instant(sim));
    const GrowthInstant& now = instants_.back();
    write_row(out_,
              {now.time, now.pressure, now.pressure - far_field_, now.tip_distance, now.tip_up,
               now.tip_down, now.path_length, now.connected_length, now.total_length,
               now.tortuosity, now.asymmetry, now.aperture, now.opening, now.fluid_volume,
               now.crack_volume, double(now.connected), double(now.unconnected),
               static_cast<double>(sim.mechanical_steps()), step.converged ? 1.0 : 0.0});
  }

  /// What was written; the stream itself must be taken up by its owner.
  void exchange(auto& archive) { archive(interval_, instants_); }

  /// The rows written so far.
  const std::vector<GrowthInstant>& instants() const { return instants_; }

  /// The last row at or before a time, s; none before the first.
  const GrowthInstant* at(double time) const {
    const auto after =
        std::upper_bound(instants_.begin(), instants_.end(), time * (1 + 1e-9),
                         [](double t, const GrowthInstant& instant) { return t < instant.time; });
    return after == instants_.begin() ? nullptr : &*(after - 1);
  }

  /// Mean injection pressure over the rows after `from` and up to `to`, s, Pa; not a number if
  /// there is none.
  double mean_pressure(double from, double to) const {
    double sum = 0;
    int count = 0;
    for (const GrowthInstant& i : instants_)
      if (i.time > from * (1 + 1e-9) && i.time <= to * (1 + 1e-9)) sum += i.pressure, ++count;
    return count > 0 ? sum / count : NAN;
  }

 private:
  std::ostream& out_;
  Interval interval_;
  double far_field_;
  std::vector<GrowthInstant> instants_;
};

}  // namespace hfdem::observe
