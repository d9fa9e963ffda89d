/// @file
/// Everything that a run of the verification model writes.
#pragma once

#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <utility>

#include <hfdem/observe/history.hpp>
#include <hfdem/observe/paraview.hpp>

#include "support/energy_record.hpp"
#include "support/growing_file.hpp"
#include "support/kgd_report.hpp"
#include "support/output_folder.hpp"
#include "support/progress.hpp"
#include "support/summary.hpp"

namespace hfdem::support {

/// An observer of the run: history and breaks as they come, the rest at the end. Whatever ends the
/// run, what was written stays.
template <class Config>
class KgdResults {
 public:
  using Sim = typename Config::Sim;

  /// @param measured toughness to predict the run with, if there is some
  /// @param resumes whether the run goes on with what is in the folder
  KgdResults(const OutputFolder& folder, const Config& config, const Manifest& manifest,
             std::optional<MeasuredToughness> measured, bool resumes)
      : folder_(folder),
        config_(config),
        manifest_(manifest),
        measured_(std::move(measured)),
        far_field_(std::fmin(config.simulator.in_situ.xx, config.simulator.in_situ.yy)),
        history_file_(folder, "history.csv", resumes),
        history_(history_file_.out(), config.run.output_interval, far_field_),
        paraview_(folder.path() / "paraview", config.run.snapshot_interval) {
    if (config.run.energy) energy_.emplace(folder, config.run.output_interval, resumes);
  }

  /// Call once the specimen has settled; not for a run that is resumed.
  void begin(const Sim& sim) {
    moduli_ = moduli(sim);
    paraview_.write(sim);
    watch_ = Stopwatch();
  }

  void mechanical_step(const Sim& sim) {
    if (energy_) energy_->mechanical_step(sim);
  }
  /// Only the books of energy do.
  bool wants_mechanical_steps() const { return energy_.has_value(); }

  void fluid_step(const Sim& sim, const FluidStep& step) {
    if (energy_) energy_->fluid_step(sim);
    history_.fluid_step(sim, step);
    paraview_.fluid_step(sim, step);
    see_pressure(sim.injection_pressure());
    unconverged_ += step.converged ? 0 : 1;
    flow_steps_ += step.flow_steps;
    balance_error_ = std::fmax(balance_error_, sim.volume_balance().relative_error());
  }

  void bond_break(const Sim&, const BondBreak& b) { see_pressure(b.pressure); }

  /// What the run has come to so far.
  void exchange(auto& archive) {
    archive(measured_, history_file_, history_, paraview_, moduli_.young, moduli_.poisson,
            unconverged_, flow_steps_, balance_error_, peak_pressure_, watch_);
    if (energy_) archive(*energy_);
  }

  /// @param stopped why the run ended before its time; empty if it did not
  void finish(const Sim& sim, const std::string& stopped) {
    predict(sim);
    const KgdOutcome outcome{measure::crack_shape(sim),
                             paper_kgd(config_, sim.time()),
                             far_field_,
                             peak_pressure_,
                             moduli_,
                             {stopped, unconverged_, watch_.seconds()},
                             predicted(sim),
                             viscosity_left_out(config_, sim.time())};
    paraview_.write(sim);
    history_file_.close();
    if (energy_) energy_->close();
    std::ofstream profile = folder_.open("profile.csv"), cracks = folder_.open("cracks.csv");
    observe::write_profile(profile, sim);
    observe::write_cracks(cracks, sim);
    folder_.close(profile, "profile.csv");
    folder_.close(cracks, "cracks.csv");
    const KgdFigures<Config> figures(config_, history_.instants(),
                                     prediction_ ? &*prediction_ : nullptr);
    folder_.write("aperture.svg", svg(figures.aperture()));
    folder_.write("length.svg", svg(figures.length()));
    folder_.write("pressure.svg", svg(figures.pressure()));
    folder_.write("specimen.svg", svg(figures.specimen(sim)));
    folder_.write("summary.json", summarise(sim, outcome).json());
    folder_.write("report.html",
                  KgdReport<Config>(config_, manifest_).html(sim, outcome, figures, energy()));
    text_ = describe(sim, outcome);
    if (outcome.predicted) text_ += outcome.predicted->text();
    if (!no_prediction_.empty()) text_ += "no prediction from slits: " + no_prediction_ + "\n";
  }

  /// @param reason why the specimen could not even settle
  void finish_unbegun(const std::string& reason) {
    history_file_.close();
    if (energy_) energy_->close();
    folder_.write("report.html", KgdReport<Config>(config_, manifest_).html(reason));
  }

  /// The answer in a few lines for a terminal.
  const std::string& text() const { return text_; }

 private:
  const EnergyRecord<Sim>* energy() const { return energy_ ? &*energy_ : nullptr; }

  void see_pressure(double pressure) { peak_pressure_ = std::fmax(peak_pressure_, pressure); }

  measure::ElasticModuli moduli(const Sim& sim) const {
    try {
      return measure::elastic_moduli<typename Sim::ContactPolicy, typename Sim::NeighbourPolicy>(
          sim.specimen(), sim.params().contact, sim.params().in_situ, sim.params().mechanics,
          manifest_.threads);
    } catch (const RunStopped&) {
      return {NAN, NAN};  // stresses that break the intact specimen: no elastic answer
    }
  }

  void predict(const Sim& sim) {
    try {
      if (measured_)
        prediction_.emplace(*measured_, config_, static_cast<int>(sim.preset_contacts().size()));
    } catch (const InvalidParameter& e) {
      no_prediction_ = e.what();  // no reason not to show the run
    }
  }

  std::optional<PredictionResults> predicted(const Sim& sim) const {
    if (!prediction_ || sim.time() == 0) return {};
    const auto shape = measure::crack_shape(sim);
    return PredictionResults(
        *prediction_, sim.time(),
        {shape.full_length(), shape.opening, sim.injection_pressure() - far_field_});
  }

  Summary summarise(const Sim& sim, const KgdOutcome& outcome) const {
    const auto& [shape, kgd, far_field, peak_pressure, moduli, run, predicted, left_out] = outcome;
    const long steps = sim.mechanical_steps();
    Summary s;
    s.set("time_s", sim.time());
    s.set("full_length_m", shape.full_length());
    s.set("tip_up_m", shape.tip_up);
    s.set("tip_down_m", shape.tip_down);
    s.set("aperture_at_injection_m", shape.aperture);
    s.set("opening_at_injection_m", shape.opening);
    s.set("injection_pressure_Pa", sim.injection_pressure());
    s.set("net_pressure_Pa", sim.injection_pressure() - far_field);
    s.set("first_break_pressure_Pa", first_break_pressure(sim));
    s.set("peak_pressure_Pa", peak_pressure);
    s.set("fluid_volume_m2", sim.injected_volume());
    s.set("crack_volume_m2", sim.network().crack_volume());
    s.set("broken_bonds", static_cast<long>(sim.breaks().size()));
    s.set("broken_bonds_off_plane", measure::broken_off_plane(sim));
    s.set("preset_contacts", static_cast<long>(sim.preset_contacts().size()));
    s.set("E_Pa", moduli.young);
    s.set("poisson_ratio", moduli.poisson);
    s.set("rule", std::string(words_of(config_.simulator.scheme).rule));
    s.set("scheme", std::string(words_of(config_.simulator.scheme).name));
    s.set("viscosity_Pa_s", config_.simulator.fluid.viscosity);
    s.set("fluid_balance_relative_error", balance_error_);
    s.set("fluid_steps", sim.fluid_steps());
    s.set("unconverged_fluid_steps", run.unconverged);
    if constexpr (flows<Sim>) s.set("flow_steps", flow_steps_);
    if constexpr (requires { sim.pressure_scheme().flow_limit(); }) {
      const Index channel = sim.pressure_scheme().limiting_channel();
      s.set("flow_limit/time_step_s", sim.pressure_scheme().flow_limit());
      if (channel != nothing) {
        s.set("flow_limit/channel", static_cast<long>(channel));
        s.set("flow_limit/x_m", sim.contact_point(channel).x);
        s.set("flow_limit/y_m", sim.contact_point(channel).y);
      }
    }
    s.set("mechanical_steps", steps);
    s.set("settling_steps", sim.settling_steps());
    s.set("mechanical_dt_s", sim.mechanical_dt());
    s.set("wall_s", run.wall);
    s.set("particle_steps_per_s",
          static_cast<double>(sim.discs().size()) * static_cast<double>(steps) / run.wall);
    s.set("threads", manifest_.threads);
    if (!run.stopped.empty()) s.set("stopped", run.stopped);

    s.set("paper/holds_for", "the default parameters at t = 0.9 s");
    s.compare("paper/full_length_m", shape.full_length(), paper::Verification::full_length);
    s.compare("paper/aperture_at_injection_m", shape.aperture, paper::Verification::aperture);
    s.set("kgd/E_prime_Pa", paper::Verification::E_prime);
    s.set("kgd/K_IC_Pa_sqrt_m", paper::Verification::K_IC);
    s.compare("kgd/full_length_m", shape.full_length(), kgd.full_length());
    s.compare("kgd/aperture_at_injection_m", shape.aperture, kgd.width);
    s.compare("kgd/opening_at_injection_m", shape.opening, kgd.width);
    s.compare("kgd/net_pressure_Pa", sim.injection_pressure() - far_field, kgd.net_pressure);
    s.set("kgd/full_length_printed_in_paper_m", paper::Verification::kgd_full_length);
    s.set("kgd/aperture_printed_in_paper_m", paper::Verification::kgd_aperture);
    if (predicted) predicted->summarise(s);
    if (energy_) energy_->summarise(s);
    if (!no_prediction_.empty()) s.set("toughness/no_prediction", no_prediction_);
    return s;
  }

  std::string describe(const Sim& sim, const KgdOutcome& outcome) const {
    const auto& [shape, kgd, far_field, peak_pressure, moduli, run, predicted, left_out] = outcome;
    const double net = sim.injection_pressure() - far_field;
    char text[800];
    std::snprintf(text, sizeof text,
                  "t = %.3g s            hfdem      KGD, the paper's K_IC\n"
                  "crack length     %9.3f m   %9.3f m\n"
                  "aperture         %9.1f um  %9.1f um   (w - w0: %.1f um)\n"
                  "injection        %9.2f MPa, %.2f MPa above the stress across the crack\n"
                  "%ld fluid steps, %ld mechanical steps, %.1f s\n",
                  sim.time(), shape.full_length(), kgd.full_length(), shape.aperture * 1e6,
                  kgd.width * 1e6, shape.opening * 1e6, sim.injection_pressure() / 1e6, net / 1e6,
                  sim.fluid_steps(), sim.mechanical_steps(), run.wall);
    std::string lines = text;
    if (at_paper_time(config_, sim.time())) {
      std::snprintf(text, sizeof text, "the paper        %9.3f m, %.1f um\n",
                    paper::Verification::full_length, paper::Verification::aperture * 1e6);
      lines += text;
    }
    return left_out.empty() ? lines : lines + left_out + "\n";
  }

  const OutputFolder& folder_;
  const Config& config_;
  const Manifest& manifest_;
  std::optional<MeasuredToughness> measured_;
  std::optional<Prediction> prediction_;
  std::string no_prediction_;
  double far_field_;
  GrowingFile history_file_;
  observe::History history_;
  observe::ParaView paraview_;
  std::optional<EnergyRecord<Sim>> energy_;  // if the books are kept
  measure::ElasticModuli moduli_{};
  long unconverged_ = 0, flow_steps_ = 0;
  double peak_pressure_ = 0, balance_error_ = 0;
  Stopwatch watch_;
  std::string text_;
};

}  // namespace hfdem::support
