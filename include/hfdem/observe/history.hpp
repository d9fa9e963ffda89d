/// @file
/// Tables that Python and a spreadsheet open: histories, profiles and broken bonds as CSV.
#pragma once

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <hfdem/measure/crack.hpp>
#include <hfdem/observe/interval.hpp>
#include <hfdem/state/contact.hpp>
#include <hfdem/state/step.hpp>

namespace hfdem::observe {

/// Writes one row of numbers with ten significant digits.
inline void write_row(std::ostream& out, std::initializer_list<double> values) {
  std::string row;
  for (const double v : values) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", v);
    if (!row.empty()) row += ',';
    row += text;
  }
  out << row << '\n';
}

/// What a history remembers of one instant, SI.
struct Instant {
  double time, pressure, net_pressure;  ///< s, Pa, Pa; at the injection
  measure::CrackShape crack;            ///< tips and aperture
  double fluid_volume, crack_volume;    ///< injected, V_f, and opened, V_c, m2
};

/// An observer that writes a row every `interval` seconds of simulated time, and remembers it.
class History {
 public:
  /// @param out must outlive the history
  /// @param interval s; a row follows the first fluid step at or after each multiple of it
  /// @param far_field in-situ stress across the crack, Pa: net pressure is measured from it
  History(std::ostream& out, double interval, double far_field)
      : out_(out), interval_(interval), far_field_(far_field) {
    out_ << "time_s,injection_pressure_Pa,net_pressure_Pa,full_length_m,tip_up_m,tip_down_m,"
            "aperture_at_injection_m,opening_at_injection_m,fluid_volume_m2,crack_volume_m2,"
            "broken_bonds,mechanical_steps,converged\n";
  }

  /// Heard after every fluid step.
  template <class Sim>
  void fluid_step(const Sim& sim, const FluidStep& step) {
    if (!interval_.is_due(sim.time())) return;
    interval_.wait_from(sim.time());
    const double pressure = sim.injection_pressure();
    instants_.push_back({sim.time(), pressure, pressure - far_field_, measure::crack_shape(sim),
                         sim.injected_volume(), sim.network().crack_volume()});
    const Instant& now = instants_.back();
    write_row(out_, {now.time, now.pressure, now.net_pressure, now.crack.full_length(),
                     now.crack.tip_up, now.crack.tip_down, now.crack.aperture, now.crack.opening,
                     now.fluid_volume, now.crack_volume, static_cast<double>(sim.breaks().size()),
                     static_cast<double>(sim.mechanical_steps()), step.converged ? 1.0 : 0.0});
  }

  /// What was written; the stream itself must be taken up by its owner.
  void exchange(auto& archive) { archive(interval_, instants_); }

  /// The rows written so far.
  const std::vector<Instant>& instants() const { return instants_; }

 private:
  std::ostream& out_;
  Interval interval_;
  double far_field_;
  std::vector<Instant> instants_;
};

/// The crack from tip to tip at this instant.
template <class Sim>
void write_profile(std::ostream& out, const Sim& sim) {
  out << "along_crack_m,x_m,y_m,aperture_m,opening_m,pressure_Pa\n";
  for (const auto& p : measure::crack_profile(sim))
    write_row(out, {p.along, p.position.x, p.position.y, p.aperture, p.opening, p.pressure});
}

/// A mode of failure in a table: `tension` or `shear`.
constexpr std::string_view name(Mode mode) { return mode == Mode::tension ? "tension" : "shear"; }

/// Every bond that broke during the run (the preset crack is not among them), in order.
template <class Sim>
void write_cracks(std::ostream& out, const Sim& sim) {
  out << "time_s,x_m,y_m,length_m,mode,injection_pressure_Pa,place\n";
  for (const auto& b : sim.breaks()) {
    const auto [from, to] = measure::facet(sim, b.contact);
    const Vec2 at = sim.contact_point(b.contact);
    char text[160];
    std::snprintf(text, sizeof text, "%.10g,%.10g,%.10g,%.10g,%s,%.10g,%s\n", b.time, at.x, at.y,
                  norm(to - from), std::string(name(b.mode)).c_str(), b.pressure,
                  sim.is_joint(b.contact) ? "joint" : "rock");
    out << text;
  }
}

}  // namespace hfdem::observe
