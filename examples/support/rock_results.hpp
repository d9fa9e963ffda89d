/// @file
/// Everything that a run in random rock writes.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <string>

#include <hfdem/observe/growth.hpp>
#include <hfdem/observe/paraview.hpp>
#include <hfdem/setup/specimen_file.hpp>

#include "support/energy_record.hpp"
#include "support/growing_file.hpp"
#include "support/joint_record.hpp"
#include "support/leak_record.hpp"
#include "support/output_folder.hpp"
#include "support/progress.hpp"
#include "support/rock_prediction.hpp"
#include "support/rock_recorder.hpp"
#include "support/rock_report.hpp"

namespace hfdem::support {

/// An observer of the run: history and breaks as they come, the rest at the end. Whatever ends the
/// run, what was written stays.
template <class Config>
class RockResults {
 public:
  using Sim = typename Config::Sim;

  /// What is written at the end.
  static constexpr std::array files{
      "report.html",       "summary.json",          "profile.csv", "cracks.csv",     "fracture.svg",
      "aperture_map.svg",  "pressure_map.svg",      "stress.svg",  "pressure.svg",   "tips.svg",
      "length.svg",        "aperture.svg",          "energy.csv",  "joints.csv",     "joints.svg",
      "joint_lengths.svg", "natural_fractures.csv", "leaked.svg",  "efficiency.svg", "pores.csv",
      "pores.svg"};

  /// @param measured modulus and toughness to predict the run with, if there are some
  /// @param fractures number of natural ones
  /// @param resumes whether the run goes on with what is in the folder
  RockResults(const OutputFolder& folder, const Config& config, const Manifest& manifest,
              const std::optional<MeasuredRock>& measured, std::size_t fractures, bool resumes)
      : folder_(folder),
        config_(config),
        manifest_(manifest),
        measured_(measured),
        history_file_(folder, "history.csv", resumes),
        recorder_(config, history_file_.out()),
        paraview_(folder.path() / "paraview", config.run.snapshot_interval) {
    if (config.run.energy) energy_.emplace(folder, config.run.output_interval, resumes);
    if (fractures > 0) joints_.emplace(folder, config.run.output_interval, resumes);
    if (leaks<Sim>) leak_.emplace(folder, config.run.output_interval, resumes);
  }

  /// Call once the specimen has settled; not for a run that is resumed.
  void begin(const Sim& sim) {
    save_specimen((folder_.path() / "specimen.txt").string(), sim.specimen());
    paraview_.write(sim);
    recorder_.begin();
  }

  void mechanical_step(const Sim& sim) {
    if (energy_) energy_->mechanical_step(sim);
  }
  /// Only the books of energy do.
  bool wants_mechanical_steps() const { return energy_.has_value(); }

  void fluid_step(const Sim& sim, const FluidStep& step) {
    if (energy_) energy_->fluid_step(sim);
    if (joints_) joints_->fluid_step(sim);
    if (leak_) leak_->fluid_step(sim);
    recorder_.fluid_step(sim, step);
    paraview_.fluid_step(sim, step);
  }

  /// What the run has come to so far.
  void exchange(auto& archive) {
    archive(measured_, history_file_, recorder_, paraview_);
    if (energy_) archive(*energy_);
    if (joints_) archive(*joints_);
    if (leak_) archive(*leak_);
  }

  /// @param how the run ended
  void finish(const Sim& sim, const RunEnd& how) {
    outcome_ = recorder_.outcome(sim, how);
    outcome_.moduli = moduli(sim);
    paraview_.write(sim);
    history_file_.close();
    if (energy_) energy_->close();
    const std::string conditions = described(config_, static_cast<long>(sim.discs().size()));
    if (joints_) joints_->finish(sim, conditions);
    if (leak_) leak_->finish(sim, conditions);
    folder_.write("profile.csv", profile(sim));
    std::ostringstream cracks;
    observe::write_cracks(cracks, sim);
    folder_.write("cracks.csv", cracks.str());
    const auto prediction = prediction_of(measured_, config_);
    const RockFigures<Config> figures(config_, sim, growth().instants(),
                                      prediction ? &*prediction : nullptr);
    folder_.write("fracture.svg", svg(figures.fracture()));
    folder_.write("aperture_map.svg", svg(figures.apertures()));
    folder_.write("pressure_map.svg", svg(figures.net_pressures()));
    folder_.write("stress.svg", svg(figures.stress()));
    folder_.write("pressure.svg", svg(figures.pressure()));
    folder_.write("tips.svg", svg(figures.tips()));
    folder_.write("length.svg", svg(figures.length()));
    folder_.write("aperture.svg", svg(figures.aperture()));
    folder_.write("summary.json", summary(sim).json());
    folder_.write("report.html",
                  RockReport<Config>(config_, manifest_)
                      .html(sim, outcome_, figures, energy_ ? &*energy_ : nullptr,
                            joints_ ? &*joints_ : nullptr, leak_ ? &*leak_ : nullptr));
  }

  /// @param reason why the specimen could not even settle
  void finish_unbegun(const std::string& reason) {
    outcome_.run.stopped = reason;
    history_file_.close();
    if (energy_) energy_->close();
    if (joints_) joints_->close();
    if (leak_) leak_->close();
    folder_.write("report.html", RockReport<Config>(config_, manifest_).html(reason));
  }

  bool stopped() const { return !outcome_.run.stopped.empty(); }
  const RockOutcome& outcome() const { return outcome_; }
  const observe::Growth& growth() const { return recorder_.growth(); }

  /// The answer in a few lines for a terminal.
  std::string text(const Sim& sim) const {
    const auto& o = outcome_;
    char text[800];
    std::snprintf(text, sizeof text,
                  "t = %.3f s%s\n"
                  "breakdown        %8.2f MPa   (first break %.2f MPa)\n"
                  "propagation      %8.2f MPa   (mean from %.2f to %.2f s)\n"
                  "tips             %8.3f m apart, asymmetry %.2f\n"
                  "microcracks      %8.3f m, of which %.3f m connected: tortuosity %.2f\n"
                  "%ld fluid steps, %ld mechanical steps, %.1f s\n",
                  o.end.time, o.rim_time ? ": the crack has reached the rim" : "",
                  o.breakdown / 1e6, o.first_break / 1e6, o.propagation / 1e6,
                  config_.readings.propagation_from, config_.readings.propagation_to,
                  o.end.tip_distance, o.end.asymmetry, o.end.total_length, o.end.connected_length,
                  o.end.tortuosity, sim.fluid_steps(), sim.mechanical_steps(), o.run.wall);
    return text;
  }

 private:
  /// Of the rock between its natural fractures.
  measure::ElasticModuli moduli(const Sim& sim) const {
    Specimen rock = sim.specimen();
    rock.joints = {};
    try {
      return measure::elastic_moduli<typename Sim::ContactPolicy, typename Sim::NeighbourPolicy>(
          rock, sim.params().contact, {0, 0}, sim.params().mechanics, manifest_.threads);
    } catch (const RunStopped&) {
      return {NAN, NAN};
    }
  }

  std::string profile(const Sim& sim) const {
    const auto microcracks = measure::microcracks(sim);
    std::ostringstream out;
    out << "along_path_m,along_crack_m,x_m,y_m,length_m,aperture_m,opening_m,net_pressure_Pa\n";
    for (const auto& p :
         measure::path_profile(microcracks, outcome_.crack, config_.closing_stress()))
      observe::write_row(out, {p.arc, p.along, p.position.x, p.position.y, p.length, p.aperture,
                               p.opening, p.net_pressure});
    return out.str();
  }

  Summary summary(const Sim& sim) const {
    Summary s;
    summarise(s, config_, sim, outcome_, growth());
    s.set("threads", manifest_.threads);
    if (energy_) energy_->summarise(s);
    if (joints_) joints_->summarise(s, sim, paper_case(config_));
    if (leak_) leak_->summarise(s, sim);
    if (const auto prediction = prediction_of(measured_, config_))
      summarise(s, *prediction, same_rock(*measured_, config_), outcome_.end);
    const auto kgd = paper_kgd(config_, outcome_.end.time);
    s.set("kgd/E_prime_Pa", paper::Intact::E_prime);
    s.set("kgd/K_IC_Pa_sqrt_m", paper::Intact::K_IC);
    s.compare("kgd/full_length_m", outcome_.end.tip_distance, kgd.full_length());
    s.compare("kgd/aperture_at_injection_m", outcome_.end.aperture, kgd.width);
    s.compare("kgd/net_pressure_Pa", outcome_.end.pressure - config_.closing_stress(),
              kgd.net_pressure);
    if (const double published = paper_case(config_).breakdown; std::isfinite(published))
      s.compare("paper/breakdown_pressure_Pa", outcome_.breakdown, published);
    return s;
  }

  const OutputFolder& folder_;
  const Config& config_;
  const Manifest& manifest_;
  std::optional<MeasuredRock> measured_;
  GrowingFile history_file_;
  RockRecorder<Config> recorder_;
  observe::ParaView paraview_;
  std::optional<EnergyRecord<Sim>> energy_;  // if the books are kept
  std::optional<JointRecord<Sim>> joints_;   // if there are natural fractures
  std::optional<LeakRecord<Sim>> leak_;      // if the crack loses fluid
  RockOutcome outcome_;
};

}  // namespace hfdem::support
