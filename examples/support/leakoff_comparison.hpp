/// @file
/// A crack in rock that leaks beside the same crack in rock that does not: the paper's Fig. 17a.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/report.hpp>

#include "support/csv_table.hpp"
#include "support/manifest.hpp"
#include "support/output_folder.hpp"
#include "support/run_report.hpp"
#include "support/seeds_table.hpp"

namespace hfdem::support {

/// A part of the study.
struct LeakoffPart {
  std::string folder;  ///< below that of the study
  std::string name;    ///< in figures and tables
  bool leaks = true;
};

/// Reads the parts' tables and writes the page about all of them.
class LeakoffComparison {
 public:
  static constexpr std::array files{"report.html", "pressure.svg", "length.svg", "leaked.svg",
                                    "comparison.csv"};

  /// @param parts the first of them without leak-off
  /// @param seeds number of rocks
  /// @param conditions of all of them, for captions
  LeakoffComparison(const OutputFolder& folder, std::vector<LeakoffPart> parts, int first_seed,
                    int seeds, std::string conditions)
      : folder_(folder),
        parts_(std::move(parts)),
        first_seed_(first_seed),
        seeds_(seeds),
        conditions_(std::move(conditions)) {}

  void write(const Manifest& made) const {
    observe::Report page;
    page.program = "hfdem " + made.version + ", program " + made.program;
    page.title = "A crack in rock that leaks";
    page.lead =
        "The same crack in rock whose intact contacts are closed, and in rock whose "
        "contacts conduct and whose pores hold fluid. " +
        (seeds_ > 1 ? "Figures: the first of " + std::to_string(seeds_) + " rocks. "
                    : std::string()) +
        conditions_;
    page.section("Over time");
    for (const auto& [file, chart] : charts()) {
      folder_.write(file, svg(chart));
      page.figure(chart);
    }
    if (seeds_ > 1) {
      page.section("Means");
      for (std::size_t k = 1; k < parts_.size(); ++k) page.table(table(parts_[k]));
      folder_.write("comparison.csv", csv());
    }
    page.section("Files");
    std::vector<observe::File> beside;
    for (const LeakoffPart& p : parts_)
      beside.push_back({p.folder + "/report.html", p.name + ": its own report"});
    for (const auto& [file, chart] : charts()) beside.push_back({file, chart.title});
    if (seeds_ > 1) beside.push_back({"comparison.csv", "the means and their changes"});
    page.files(beside);
    add_manifest(page, made);
    folder_.write("report.html", page.html());
  }

  /// The means in a few lines for a terminal.
  std::string text() const {
    std::string lines;
    if (seeds_ > 1)
      for (std::size_t k = 1; k < parts_.size(); ++k) {
        lines += parts_[k].name + " beside " + parts_[0].name + ":\n";
        for (const auto& row : table(parts_[k]).rows)
          lines += "  " + row[0] + ": " + row[1] + ", " + row[2] + "; change " + row[3] + " ± " +
                   row[4] + " (" + row[5] + " rocks): " + row[6] + "\n";
      }
    return lines;
  }

 private:
  /// A number of every run, and whether the paper has more or less of it with leak-off.
  struct Reading {
    std::string_view key, name, unit;
    double factor;
    int paper;
  };
  static constexpr std::array readings{
      Reading{"breakdown_pressure_Pa", "breakdown pressure", "MPa", 1e-6, -1},
      Reading{"propagation_pressure_Pa", "propagation pressure", "MPa", 1e-6, +1},
      Reading{"first_break_pressure_Pa", "first break", "MPa", 1e-6, -1},
      Reading{"0.3_s/tip_distance_m", "length at 0.3 s", "m", 1, 0},
      Reading{"0.6_s/tip_distance_m", "length at 0.6 s", "m", 1, 0},
      Reading{"0.9_s/tip_distance_m", "length at 0.9 s", "m", 1, 0},
      Reading{"0.6_s/mean_aperture_m", "width at 0.6 s", "µm", 1e6, 0},
      Reading{"0.6_s/tortuosity", "tortuosity at 0.6 s", "", 1, 0}};

  /// Of the first rock.
  std::string folder_of(const LeakoffPart& part) const {
    const std::string all = (folder_.path() / part.folder).string();
    return seeds_ > 1 ? all + "/seed_" + std::to_string(first_seed_) : all;
  }

  std::vector<std::pair<std::string, observe::Chart>> charts() const {
    const auto over_time = [&](const std::string& title, const std::string& label,
                               const std::string& caption) {
      return observe::Chart{.title = title,
                            .x_label = "injection time (s)",
                            .y_label = label,
                            .caption = caption,
                            .conditions = conditions_};
    };
    auto pressure = over_time("Injection pressure", "pressure (MPa)",
                              "The paper's Fig. 17a has leak-off lower the pressure at "
                              "breakdown and raise it afterwards.");
    auto length = over_time("Distance between the tips", "length (m)",
                            "What has leaked off no longer opens the crack.");
    auto leaked = over_time("Leaked volume", "volume (mL per m)",
                            "Into the pores of the rock; dashed: injected.");
    for (const LeakoffPart& p : parts_) {
      const CsvTable history(folder_of(p) + "/history.csv", "every run");
      add(pressure, p.name, history, "injection_pressure_Pa", 1e-6);
      add(length, p.name, history, "tip_distance_m", 1);
      if (!p.leaks) continue;
      const CsvTable leak(folder_of(p) + "/leakoff.csv", "a run with leak-off");
      add(leaked, p.name, leak, "leaked_m2", 1e6);
      if (&p == &parts_.back()) {
        add(leaked, "injected", leak, "injected_m2", 1e6);
        leaked.series.back().style = observe::Series::Style::dashed;
      }
    }
    return {{"pressure.svg", pressure}, {"length.svg", length}, {"leaked.svg", leaked}};
  }
  static void add(observe::Chart& chart, const std::string& name, const CsvTable& table,
                  std::string_view column, double factor) {
    observe::Series s{.name = name, .x = table.column("time_s")};
    for (const double v : table.column(column)) s.y.push_back(factor * v);
    chart.series.push_back(std::move(s));
  }

  SeedsTable seeds(const LeakoffPart& part) const {
    return SeedsTable((folder_.path() / part.folder / "seeds.csv").string());
  }

  observe::Table table(const LeakoffPart& part) const {
    observe::Table table{
        .caption = part.name + " beside " + parts_[0].name +
                   ", over the rocks in which both cracks are still inside. The interval is that "
                   "of Student's t, 95 %, of the change of each rock.",
        .header = {"", part.name, parts_[0].name, "change", "95 %", "rocks", ""}};
    const SeedsTable with = seeds(part), without = seeds(parts_[0]);
    for (const Reading& r : readings) {
      const PairedReading p = paired(with, without, r.key, r.factor);
      if (p.rocks == 0) continue;
      const auto words = [&](double v) {
        return observe::fixed(v, r.unit == "MPa" || r.unit == "µm" ? 1 : 3);
      };
      table.rows.push_back(
          {std::string(r.name) + (r.unit.empty() ? "" : ", ") + std::string(r.unit),
           words(p.first.mean), words(p.second.mean), words(p.change.mean), words(p.change.ci95),
           std::to_string(p.rocks), std::string(verdict(p.change, r.paper, "as in the paper"))});
    }
    return table;
  }

  std::string csv() const {
    std::string text = "part,reading,mean,mean_without,change,ci95,rocks\n";
    for (std::size_t k = 1; k < parts_.size(); ++k) {
      const SeedsTable with = seeds(parts_[k]), without = seeds(parts_[0]);
      for (const Reading& r : readings) {
        const PairedReading p = paired(with, without, r.key, 1);
        if (p.rocks == 0) continue;
        text += parts_[k].folder + ',' + std::string(r.key);
        for (const double v : {p.first.mean, p.second.mean, p.change.mean, p.change.ci95})
          text += ',' + to_text(v);
        text += ',' + std::to_string(p.rocks) + '\n';
      }
    }
    return text;
  }

  const OutputFolder& folder_;
  std::vector<LeakoffPart> parts_;
  int first_seed_, seeds_;
  std::string conditions_;
};

}  // namespace hfdem::support
