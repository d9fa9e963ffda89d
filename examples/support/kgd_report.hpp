/// @file
/// The report of a run of the verification model.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <hfdem/measure/crack.hpp>
#include <hfdem/measure/elastic_moduli.hpp>
#include <hfdem/observe/report.hpp>

#include "support/energy_record.hpp"
#include "support/kgd_figures.hpp"
#include "support/prediction_results.hpp"
#include "support/run_report.hpp"
#include "support/schemes.hpp"

namespace hfdem::support {

/// What a run came to, SI.
struct KgdOutcome {
  measure::CrackShape shape;
  analytic::KgdFracture kgd;  ///< of the same time, with the paper's E' and K_IC
  double far_field;           ///< in-situ stress across the crack
  double peak_pressure;
  measure::ElasticModuli moduli;
  RunRecord run;
  std::optional<PredictionResults> predicted;  ///< if slits were tested
  std::string left_out;                        ///< viscosity, in a sentence, where it would matter
};

template <class Config>
class KgdReport {
 public:
  using Sim = typename Config::Sim;

  KgdReport(const Config& config, const Manifest& manifest) : config_(config), manifest_(manifest) {
    page_.program = "hfdem " + manifest.version + ", program " + manifest.program;
    page_.lead = "A crack driven by " + std::string(words_of(config.simulator.scheme).driven_by) +
                 " through a square array of bonded discs: " + described(config);
  }

  /// The page of a run, whatever ended it.
  /// @param energy where the work went; null if no books were kept
  std::string html(const Sim& sim, const KgdOutcome& o, const KgdFigures<Config>& figures,
                   const EnergyRecord<Sim>* energy) {
    page_.title = "A crack of " + observe::fixed(o.shape.full_length(), 3, "m") + " after " +
                  observe::fixed(sim.time(), 3, "s");
    if (!o.run.stopped.empty())
      page_.stopped = "At " + observe::fixed(sim.time(), 4, "s") + " of " +
                      said(config_.run.end_time, "s").both() + ": " + o.run.stopped +
                      ". What follows is the state at that moment.";
    add_answer(sim, o);
    page_.figure(figures.specimen(sim));
    page_.section("Growth of the crack");
    page_.figure(figures.length());
    page_.figure(figures.aperture());
    page_.figure(figures.pressure());
    if (o.predicted)
      o.predicted->add_to(page_, words_of(config_.simulator.scheme).rule == "equilibrium");
    add_comparison(sim, o);
    add_numbers(sim, o);
    if (energy) energy->add_to(page_, sim, described(config_));
    add_run(page_, sim, o.run, manifest_);
    add_origin(page_, config_,
               {{"summary.json", "the answer in numbers, with the references beside them"},
                {"history.csv", "pressures, length, tips, aperture and volumes over time"},
                {"profile.csv", "aperture, opening and pressure along the crack at the end"},
                {"cracks.csv", "time, place, length and mode of every bond that broke"},
                {"paraview/particles.pvd", "discs over time, for ParaView: displacement, stress"},
                {"paraview/contacts.pvd", "contacts over time: force, moment, state"},
                {"paraview/cracks.pvd", "broken contacts over time: aperture, pressure"},
                {"config.toml", "every parameter; repeats the run with --config"},
                {"specimen.svg", "the first figure above, for other documents"},
                {"length.svg", "length over time"},
                {"aperture.svg", "aperture over time"},
                {"pressure.svg", "injection pressure over time"}},
               manifest_);
    return page_.html();
  }

  /// The page of a run that could not begin.
  std::string html(const std::string& reason) {
    return unbegun_page(page_, config_, reason, manifest_);
  }

 private:
  static std::string millilitres(double v) {
    return observe::fixed(v * 1e6, 2, "mL") + " per metre of thickness";
  }

  void add_answer(const Sim& sim, const KgdOutcome& o) {
    using paper::Verification;
    const bool paper = at_paper_time(config_, sim.time());
    const double net = sim.injection_pressure() - o.far_field;
    // What slits predict, if they were tested, is the better reference.
    std::string name = "KGD ";
    double length = o.kgd.full_length(), aperture = o.kgd.width, pressure = o.kgd.net_pressure;
    if (o.predicted && o.predicted->in_specimen()) {
      const analytic::LatticeCrack& slits = *o.predicted->in_specimen();
      name = "predicted ";
      length = slits.full_length;
      aperture = slits.opening + config_.simulator.aperture.w0;
      pressure = slits.net_pressure;
    }
    const auto beside = [&](const std::string& published, const std::string& reference) {
      return (paper ? "paper " + published + "\n" : "") + name + reference;
    };
    page_.numbers({{"crack length", metres(o.shape.full_length()),
                    beside(metres(Verification::full_length), metres(length))},
                   {"aperture at the injection", micrometres(o.shape.aperture),
                    beside(micrometres(Verification::aperture), micrometres(aperture))},
                   {"injection pressure", megapascals(sim.injection_pressure()),
                    "net " + megapascals(net) + "\n" + name + "net " + megapascals(pressure)},
                   {"injection time", observe::fixed(sim.time(), 3, "s"),
                    "of " + said(config_.run.end_time, "s").both()}});
  }

  void add_comparison(const Sim& sim, const KgdOutcome& o) {
    using paper::Verification;
    const bool paper = at_paper_time(config_, sim.time());
    page_.section("Comparison");
    observe::Table table;
    table.header = {"", "hfdem", "KGD, the paper's K_{IC}", "difference"};
    if (paper) table.header.insert(table.header.begin() + 2, {"paper", "difference"});
    const auto row = [&](const std::string& name, double ours, double kgd, double published,
                         auto&& words) {
      std::vector<std::string> cells{name, words(ours), words(kgd), difference(ours, kgd)};
      if (paper)
        cells.insert(
            cells.begin() + 2,
            {words(published), std::isnan(published) ? "\u2013" : difference(ours, published)});
      table.rows.push_back(cells);
    };
    row("crack length", o.shape.full_length(), o.kgd.full_length(), Verification::full_length,
        metres);
    row("aperture at the injection, w", o.shape.aperture, o.kgd.width, Verification::aperture,
        micrometres);
    row("of which opened, w − w_{0}", o.shape.opening, o.kgd.width, NAN, micrometres);
    row("net pressure", sim.injection_pressure() - o.far_field, o.kgd.net_pressure, NAN,
        megapascals);
    page_.table(table);
    page_.text("KGD is the " + std::string(flows<Sim> ? "" : "toughness-dominated ") +
               "fracture in an infinite plane, for E' = " +
               said(Verification::E_prime, "Pa").both() + " and K_{IC} = " +
               in_words(Verification::K_IC / 1e6) +
               " MPa·m^{1/2}, which the paper fitted to the length of its own crack." +
               (flows<Sim> ? ""
                           : " That lengths and widths agree with it is therefore a weak "
                             "statement."));
    if (!o.left_out.empty()) page_.text(o.left_out);
    page_.text(paper ? "The paper prints " + metres(Verification::kgd_full_length) + " and " +
                           micrometres(Verification::kgd_aperture) + " for the KGD solution."
                     : "The paper's own results hold for its specimen at 0.9 s, not for this run.");
  }

  void add_numbers(const Sim& sim, const KgdOutcome& o) {
    page_.section("The crack in numbers");
    page_.facts(
        {{"tips",
          metres(o.shape.tip_up) + " and " + metres(o.shape.tip_down) + " from the injection"},
         {"pressure at the first break", megapascals(first_break_pressure(sim))},
         {"peak pressure", megapascals(o.peak_pressure)},
         {"injected", millilitres(sim.injected_volume())},
         {"held by the crack", millilitres(sim.network().crack_volume())},
         {"broken bonds", said(static_cast<long>(sim.breaks().size()))},
         {"of these off the crack's plane", said(measure::broken_off_plane(sim))},
         {"contacts of the preset crack", said(static_cast<long>(sim.preset_contacts().size()))},
         {"Young's modulus of the specimen", observe::fixed(o.moduli.young / 1e9, 2, "GPa")},
         {"Poisson's ratio of the specimen", observe::fixed(o.moduli.poisson, 3)},
         {"a fluid step ends", std::string(words_of(config_.simulator.scheme).ends)}});
  }

  const Config& config_;
  const Manifest& manifest_;
  observe::Report page_;
};

}  // namespace hfdem::support
