/// @file
/// The map of what becomes of cracks at joints.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

#include <hfdem/analytic/joint_crossing.hpp>
#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/report.hpp>

#include "support/crossing_model.hpp"
#include "support/output_folder.hpp"
#include "support/paper.hpp"
#include "support/run_report.hpp"
#include "support/summary.hpp"

namespace hfdem::support {

/// One rock.
struct EncounterOfRock {
  double angle = 0, stress = 0;  ///< deg; Pa along the crack
  int seed = 0;
  Encounter encounter{};
  double time = 0;       ///< of the end, s
  bool stopped = false;  ///< the run stopped before its end, and says nothing
};

class CrossingResults {
 public:
  static constexpr std::initializer_list<const char*> files{"report.html", "summary.json",
                                                            "encounters.csv", "map.svg"};

  CrossingResults(const CrossingConfig& config, const std::vector<EncounterOfRock>& rocks,
                  const Manifest& manifest)
      : config_(config), rocks_(rocks), manifest_(manifest) {}

  /// @throws OutputFailed if a file cannot be written
  void write(const OutputFolder& folder) const {
    std::string table = "angle_deg,stress_along_Pa,stress_across_Pa,seed,encounter,time_s\n";
    for (const EncounterOfRock& r : rocks_)
      table += to_text(r.angle) + ',' + to_text(r.stress) + ',' +
               to_text(config_.simulator.in_situ.xx) + ',' + std::to_string(r.seed) + ',' +
               (r.stopped ? "stopped" : std::string(name(r))) + ',' + to_text(r.time) + '\n';
    folder.write("encounters.csv", table);
    folder.write("map.svg", svg(map()));
    folder.write("summary.json", summary().json());
    folder.write("report.html", report());
  }

  /// The map in letters for a terminal.
  std::string text() const {
    std::string lines =
        "stress along the crack; A arrested, O offset, X crossing, one for each rock\n";
    const std::vector<double> stresses = config_.stresses();
    for (std::size_t s = stresses.size(); s-- > 0;) {
      char begin[32];
      std::snprintf(begin, sizeof begin, "%5.1f MPa ", stresses[s] / 1e6);
      lines += begin;
      for (const double angle : config_.angles()) lines += "  " + letters(angle, stresses[s]);
      lines += '\n';
    }
    lines += "          ";
    for (const double angle : config_.angles()) {
      std::string head = observe::fixed(angle, 0) + " deg";
      head.resize(static_cast<std::size_t>(config_.study.seeds) + 2, ' ');
      lines += head;
    }
    return lines + '\n';
  }

 private:
  static std::string_view name(const EncounterOfRock& r) {
    return encounter_names[static_cast<std::size_t>(r.encounter)];
  }
  std::string letters(double angle, double stress) const {
    std::string out;
    for (const EncounterOfRock& r : rocks_)
      if (r.angle == angle && r.stress == stress)
        out += r.stopped ? '-' : "AOX"[static_cast<std::size_t>(r.encounter)];
    return out;
  }

  /// What Gu and Weng's criterion says for the measured tensile strength of such rock.
  double threshold(double angle) const {
    const auto& joint = config_.simulator.joints;
    return analytic::JointCrossing{.angle = angle,
                                   .stress_across = config_.simulator.in_situ.xx,
                                   .tensile_strength = paper::Rock::tensile_strength,
                                   .friction = joint.friction,
                                   .cohesion = joint.cohesion}
        .least_stress_along();
  }

  Summary summary() const {
    Summary s;
    s.set("rocks", static_cast<long>(rocks_.size()));
    for (const std::string_view kind : encounter_names)
      s.set(std::string(kind), static_cast<long>(std::ranges::count_if(rocks_, [&](const auto& r) {
              return !r.stopped && name(r) == kind;
            })));
    for (const double angle : config_.angles())
      s.set("criterion/" + to_text(angle) + "_deg/least_stress_along_Pa",
            threshold(angle) < 1e9 ? threshold(angle) : NAN);
    return s;
  }

  std::string conditions() const {
    return "Random specimens of " + in_words(config_.specimen.width) + " m; joints of " +
           in_words(config_.study.length) + " m, " + in_words(config_.study.distance) +
           " m from the injection; " + in_words(config_.simulator.in_situ.xx / 1e6) +
           " MPa across the crack; friction " + in_words(config_.simulator.joints.friction) + ", " +
           std::string(names_of<JointContent>[static_cast<std::size_t>(
               config_.simulator.joints.initially)]) +
           "; " + std::to_string(config_.study.seeds) + " rocks each.";
  }

  observe::Chart map() const {
    observe::Chart chart{
        .title = "A crack at a joint",
        .x_label = "angle between crack and joint (°)",
        .y_label = "in-situ stress along the crack (MPa)",
        .caption =
            "Each mark is a rock. Line: above it, the criterion of Gu and Weng (2010) lets "
            "the crack cross.",
        .conditions = conditions(),
        .x_range = observe::Range{20, 100},
        .y_range = observe::Range{8, 28}};
    constexpr std::array colours{observe::okabe_ito::vermillion, observe::okabe_ito::orange,
                                 observe::okabe_ito::blue};
    for (std::size_t kind = 0; kind < encounter_names.size(); ++kind) {
      observe::Series marks{.name = std::string(encounter_names[kind]),
                            .style = observe::Series::Style::markers,
                            .colour = colours[kind]};
      for (const EncounterOfRock& r : rocks_) {
        if (r.stopped || static_cast<std::size_t>(r.encounter) != kind) continue;
        const int place = r.seed - config_.specimen.seed;  // side by side
        marks.x.push_back(r.angle + 2.0 * (place - 0.5 * (config_.study.seeds - 1)));
        marks.y.push_back(r.stress / 1e6);
      }
      if (!marks.x.empty()) chart.series.push_back(std::move(marks));
    }
    observe::Series line{.name = "Gu and Weng", .colour = observe::okabe_ito::black};
    for (double angle = 60; angle <= 90; angle += 0.5)
      if (const double stress = threshold(angle) / 1e6; stress < 28)
        line.x.push_back(angle), line.y.push_back(stress);
    chart.series.push_back(std::move(line));
    return chart;
  }

  std::string report() const {
    observe::Report page;
    page.title = "Arrested, offset or crossing";
    page.lead = "A fluid-driven crack meets a joint. " + conditions();
    page.program = "hfdem " + manifest_.version + ", program " + manifest_.program;
    page.figure(map());
    page.text(
        "Crossing: the crack goes on within " + in_words(config_.study.offset * 1e3) +
        " mm of where it met the joint. Offset: it leaves the joint farther away, or at its end. "
        "Arrested: after " +
        in_words(config_.study.end_time) +
        " s, or when the other wing reaches the rim, it has not left it.");
    page.section("Encounters");
    observe::Table table{.caption = "A arrested, O offset, X crossing; one letter for each rock.",
                         .header = {"stress along the crack"}};
    for (const double angle : config_.angles())
      table.header.push_back(observe::fixed(angle, 0, "°"));
    const std::vector<double> stresses = config_.stresses();
    for (std::size_t s = stresses.size(); s-- > 0;) {
      table.rows.push_back({megapascals(stresses[s])});
      for (const double angle : config_.angles())
        table.rows.back().push_back(letters(angle, stresses[s]));
    }
    page.table(table);
    add_parameters(page, config_, CrossingConfig{});
    page.section("Files");
    page.files({{"encounters.csv", "what became of every crack"},
                {"map.svg", "the map"},
                {"summary.json", "how many of each, and the criterion"},
                {"config.toml", "every parameter; repeats the study with --config"}});
    add_manifest(page, manifest_);
    return page.html();
  }

  const CrossingConfig& config_;
  const std::vector<EncounterOfRock>& rocks_;
  const Manifest& manifest_;
};

}  // namespace hfdem::support
