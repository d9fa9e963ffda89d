/// @file
/// What a crack loses into the rock: leakoff.csv over time, pores.csv at the end, their part of the
/// summary and of the report (the paper's Fig. 17b).
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include <hfdem/measure/microcracks.hpp>
#include <hfdem/measure/pores.hpp>
#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/history.hpp>
#include <hfdem/observe/interval.hpp>
#include <hfdem/observe/pore_map.hpp>
#include <hfdem/observe/report.hpp>

#include "support/growing_file.hpp"
#include "support/output_folder.hpp"
#include "support/run_report.hpp"
#include "support/schemes.hpp"
#include "support/summary.hpp"

namespace hfdem::support {

/// An observer that measures every so often where the injected fluid is.
template <class Sim>
class LeakRecord {
 public:
  /// @param interval s; a row follows the first fluid step at or after each multiple of it
  /// @param resumes whether the run goes on with what is in the folder
  LeakRecord(const OutputFolder& folder, double interval, bool resumes)
      : folder_(folder), interval_(interval), file_(folder, "leakoff.csv", resumes) {
    if (resumes) return;
    file_.out() << "time_s,injected_m2,leaked_m2,efficiency,injection_pressure_Pa\n";
  }

  void fluid_step(const Sim& sim) {
    if (!interval_.is_due(sim.time())) return;
    interval_.wait_from(sim.time());
    const VolumeBalance b = sim.volume_balance();
    rows_.push_back({sim.time(), b.injected, b.leaked});
    observe::write_row(file_.out(), {sim.time(), b.injected, b.leaked, rows_.back().efficiency(),
                                     sim.injection_pressure()});
  }

  /// @throws OutputFailed if anything written was lost
  void close() { file_.close(); }

  /// What the run has come to so far.
  void exchange(auto& archive) { archive(interval_, file_, rows_); }

  /// Writes what there is at the end.
  void finish(const Sim& sim, const std::string& conditions) {
    close();
    folder_.write("leaked.svg", svg(volumes(conditions)));
    folder_.write("efficiency.svg", svg(efficiency(conditions)));
    if constexpr (has_pores) {
      folder_.write("pores.csv", table(sim));
      folder_.write("pores.svg", svg(map(sim, conditions)));
    }
  }

  void summarise(Summary& s, const Sim& sim) const {
    const VolumeBalance b = sim.volume_balance();
    s.set("leakoff/leaked_m2", b.leaked);
    s.set("leakoff/efficiency", 1 - b.leaked / b.injected);
    if constexpr (has_pores) {
      double highest = 0;
      long full = 0, entered = 0;
      for (const measure::Pore& pore : measure::pores(sim)) {
        if (pore.in_crack) continue;
        highest = std::fmax(highest, pore.pressure);
        full += pore.pressure > 0;
        entered += pore.filling > sim.params().leakoff.saturation;
      }
      s.set("leakoff/saturation", sim.params().leakoff.saturation);
      s.set("leakoff/highest_pore_pressure_Pa", highest);
      s.set("leakoff/pores_with_pressure", full);
      s.set("leakoff/pores_that_gained", entered);
    }
  }

  void add_to(observe::Report& page, const Sim& sim, const std::string& conditions) const {
    page.section("Leak-off");
    if constexpr (has_pores) page.figure(map(sim, conditions));
    page.figure(volumes(conditions));
    page.figure(efficiency(conditions));
  }

  /// For the report's list of files.
  static std::vector<observe::File> said_files() {
    std::vector<observe::File> files{
        {"leakoff.csv", "injected and leaked volume and efficiency over time"},
        {"leaked.svg", "where the injected fluid is, over time"},
        {"efficiency.svg", "the part that is in the crack"}};
    if constexpr (has_pores) {
      files.push_back({"pores.csv", "pressure and filling of every pore at the end"});
      files.push_back({"pores.svg", "pore pressure around the crack"});
      files.push_back({"paraview/pores.pvd", "pores over time: pressure, filling"});
    }
    return files;
  }

 private:
  struct Row {
    double time = 0, injected = 0, leaked = 0;
    double efficiency() const { return injected > 0 ? 1 - leaked / injected : 1; }
    void exchange(auto& archive) { archive(time, injected, leaked); }
  };
  static constexpr bool has_pores = seeps<Sim>;

  static std::string table(const Sim& sim) {
    std::ostringstream out;
    out << "domain,x_m,y_m,pressure_Pa,filling,in_crack\n";
    for (const measure::Pore& p : measure::pores(sim))
      observe::write_row(out, {double(p.domain), p.centre.x, p.centre.y, p.pressure, p.filling,
                               double(p.in_crack)});
    return out.str();
  }

  static observe::PoreMap map(const Sim& sim, const std::string& conditions) {
    const double saturation = sim.params().leakoff.saturation;
    return {
        .pores = measure::pores(sim),
        .microcracks = measure::microcracks(sim),
        .saturation = saturation,
        .injection = measure::injection_point(sim),
        .width = sim.specimen().width,
        .height = sim.specimen().height,
        .title = "Pore pressure at t = " + observe::fixed(sim.time(), 3, "s"),
        .caption = std::string(saturation < 1 ? "Colour: pores that are full and have a pressure. "
                                                "Grey-blue: pores that fluid has entered. "
                                              : "All pores were full: pressure spreads. ") +
                   "Pores below 2 % of the highest pressure have no colour of their own.",
        .conditions = conditions};
  }

  observe::Chart volumes(const std::string& conditions) const {
    observe::Chart chart{.title = "Where the injected fluid is",
                         .x_label = "injection time (s)",
                         .y_label = "volume (mL per m)",
                         .caption = "What is not in the rock is in the crack.",
                         .conditions = conditions};
    chart.series = {line("injected", [](const Row& r) { return r.injected * 1e6; }),
                    line("in the rock", [](const Row& r) { return r.leaked * 1e6; })};
    return chart;
  }

  observe::Chart efficiency(const std::string& conditions) const {
    observe::Chart chart{.title = "Efficiency",
                         .x_label = "injection time (s)",
                         .y_label = "in the crack over injected",
                         .caption =
                             "A crack that is pressed shut gives off some of the fluid that "
                             "filled it before injection: efficiency may begin below zero.",
                         .conditions = conditions,
                         .y_range = observe::Range{0, 1}};
    chart.series = {line("hfdem", [](const Row& r) { return r.efficiency(); })};
    return chart;
  }

  template <class F>
  observe::Series line(const std::string& name, F&& value) const {
    observe::Series s{.name = name};
    for (const Row& r : rows_) s.x.push_back(r.time), s.y.push_back(value(r));
    return s;
  }

  const OutputFolder& folder_;
  observe::Interval interval_;
  GrowingFile file_;
  std::vector<Row> rows_;
};

}  // namespace hfdem::support
