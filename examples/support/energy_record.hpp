/// @file
/// Where the work of a run goes: energy.csv, its part of the summary and of the report.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <hfdem/measure/energy_ledger.hpp>
#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/history.hpp>
#include <hfdem/observe/interval.hpp>
#include <hfdem/observe/report.hpp>

#include "support/growing_file.hpp"
#include "support/output_folder.hpp"
#include "support/run_report.hpp"
#include "support/summary.hpp"

namespace hfdem::support {

/// An observer with a ledger of energy that writes its entries every so often.
template <class Sim>
class EnergyRecord {
 public:
  /// @param interval s; a row follows the first fluid step at or after each multiple of it
  /// @param resumes whether the run goes on with what is in the folder
  EnergyRecord(const OutputFolder& folder, double interval, bool resumes)
      : interval_(interval), file_(folder, "energy.csv", resumes) {
    if (resumes) return;
    file_.out()
        << "time_s,boundary_work_J_per_m,fluid_work_J_per_m,elastic_J_per_m,kinetic_J_per_m,"
           "friction_J_per_m,damping_J_per_m,breaks_J_per_m,switching_J_per_m,relative_error\n";
  }

  void mechanical_step(const Sim& sim) { ledger_.mechanical_step(sim); }

  void fluid_step(const Sim& sim) {
    if (!interval_.is_due(sim.time())) return;
    interval_.wait_from(sim.time());
    const auto& e = ledger_.entries();
    times_.push_back(sim.time());
    entries_.push_back(e);
    observe::write_row(
        file_.out(), {sim.time(), e.boundary, e.fluid, e.elastic, e.kinetic, e.friction, e.damping,
                      e.breaks, e.switching, ledger_.relative_error()});
  }

  /// @throws OutputFailed if anything written was lost
  void close() { file_.close(); }

  /// What the run has come to so far.
  void exchange(auto& archive) { archive(interval_, file_, ledger_, times_, entries_); }

  void summarise(Summary& s) const {
    const auto& e = ledger_.entries();
    s.set("energy_balance_relative_error", ledger_.worst_relative_error());
    s.set("energy/boundary_work_J_per_m", e.boundary);
    s.set("energy/fluid_work_J_per_m", e.fluid);
    s.set("energy/net_work_J_per_m", e.work());
    s.set("energy/spent_J_per_m", e.spent());
    s.set("energy/elastic_J_per_m", e.elastic);
    s.set("energy/kinetic_J_per_m", e.kinetic);
    s.set("energy/friction_J_per_m", e.friction);
    s.set("energy/damping_J_per_m", e.damping);
    s.set("energy/breaks_J_per_m", e.breaks);
    s.set("energy/switching_J_per_m", e.switching);
    s.set("energy/work_done_J_per_m", ledger_.work_done());
  }

  void add_to(observe::Report& page, const Sim& sim, const std::string& conditions) const {
    page.section("Where the work went");
    page.figure(chart(conditions));
    page.table(table(sim));
    page.text(
        "The file energy.csv has the entries over time. Each is computed on its own from forces, "
        "displacements and velocities. The worst that they left unaccounted in any mechanical step "
        "is " +
        detail::said_number(rounded(ledger_.worst_relative_error())) +
        " of the work done until then, the sizes of what boundary and fluid did in each "
        "mechanical step added up. Mechanical time is a relaxation: what waves would carry away "
        "from a break in a large body of rock, damping takes here.");
  }

 private:
  static double rounded(double v) {
    if (v == 0) return 0;
    const double unit = std::pow(10, std::floor(std::log10(v)) - 1);
    return std::round(v / unit) * unit;
  }

  observe::Chart chart(const std::string& conditions) const {
    observe::Chart chart{
        .title = "Work of boundary and fluid, and what became of it",
        .x_label = "injection time (s)",
        .y_label = "energy (J per metre of thickness)",
        .caption =
            "Net work is what the fluid did less what the boundary took back. A bond that breaks "
            "sets free what it stored itself; what the rock around it gives up becomes motion, "
            "and damping ends that.",
        .conditions = conditions};
    using Entries = measure::EnergyEntries;
    chart.series = {line("net work", [](const Entries& e) { return e.work(); }),
                    line("damping", [](const Entries& e) { return e.damping; }),
                    line("breaks", [](const Entries& e) { return e.breaks; }),
                    line("elastic", [](const Entries& e) { return e.elastic; }),
                    line("friction", [](const Entries& e) { return e.friction; })};
    return chart;
  }

  template <class F>
  observe::Series line(const std::string& name, F&& value) const {
    observe::Series s{.name = name, .x = times_};
    for (const auto& e : entries_) s.y.push_back(value(e));
    return s;
  }

  observe::Table table(const Sim& sim) const {
    const auto& e = ledger_.entries();
    observe::Table table{.header = {"", "J per m", "of what was spent"}};
    const auto row = [&](const std::string& name, double value, bool spent = false) {
      table.rows.push_back({name, observe::fixed(value, 3),
                            spent ? observe::fixed(100 * value / e.spent(), 2, "%") : ""});
    };
    row("work of the fluid", e.fluid);
    row(sim.loading().has_platens() ? "work of the platens" : "work of the dead loads", e.boundary);
    row("net work", e.work());
    row("stored in contacts", e.elastic);
    row("kinetic energy", e.kinetic);
    row("opening and closing within time steps", e.switching);
    row("spent", e.spent(), e.spent() > 0);
    row("by damping", e.damping, e.spent() > 0);
    row("by bonds that broke", e.breaks, e.spent() > 0);
    row("by friction", e.friction, e.spent() > 0);
    return table;
  }

  observe::Interval interval_;
  GrowingFile file_;
  measure::EnergyLedger<typename Sim::ContactPolicy> ledger_;
  std::vector<double> times_;
  std::vector<measure::EnergyEntries> entries_;
};

}  // namespace hfdem::support
