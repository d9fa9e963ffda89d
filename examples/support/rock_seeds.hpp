/// @file
/// Several rocks of one kind: means over seeds, how well they are known, and all runs in one
/// figure.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <hfdem/measure/sample_mean.hpp>

#include "support/rock_prediction.hpp"
#include "support/rock_readings.hpp"
#include "support/rock_results.hpp"

namespace hfdem::support {

/// Gathers runs, then writes what they have in common.
template <class Config>
class RockSeeds {
 public:
  static constexpr std::array files{"report.html", "summary.json", "seeds.csv", "pressure.svg",
                                    "length.svg"};

  /// @param measured modulus and toughness to predict the runs with, if there are some
  /// @param fractures number of natural ones
  RockSeeds(const Config& config, const Manifest& manifest, std::optional<MeasuredRock> measured,
            std::size_t fractures)
      : config_(config),
        manifest_(manifest),
        measured_(std::move(measured)),
        readings_(rock_readings(config, fractures > 0)) {}

  void add(int seed, const RockResults<Config>& run) {
    if (run.stopped()) {
      stopped_.push_back(seed);
      return;
    }
    runs_.push_back({seed, run.growth().instants(), {}});
    for (const RockReading& r : readings_)
      runs_.back().values.push_back(r.read(run.outcome(), run.growth()));
  }

  /// What was measured, taken up from a checkpoint if the runs were.
  const std::optional<MeasuredRock>& measured() const { return measured_; }
  /// How many rocks are done, runs that stopped among them.
  int done() const { return static_cast<int>(runs_.size() + stopped_.size()); }

  /// What the runs have come to so far.
  void exchange(auto& archive) { archive(measured_, runs_, stopped_); }

  void write(const OutputFolder& folder) const {
    folder.write("seeds.csv", table());
    folder.write("pressure.svg", svg(pressure()));
    folder.write("length.svg", svg(length()));
    folder.write("summary.json", summary().json());
    folder.write("report.html", report());
  }

  /// The means in a few lines for a terminal.
  std::string text() const {
    std::string lines;
    for (std::size_t k = 0; k < readings_.size(); ++k) {
      const auto values = of(k);
      if (values.empty()) continue;
      const auto mean = measure::SampleMean::of(values);
      const double factor = readings_[k].unit == "Pa" ? 1e6 : 1;
      const bool microns = readings_[k].key.find("aperture") != std::string::npos;
      const auto said_as = [&](double v) {
        return std::isfinite(v) ? observe::fixed(v * (microns ? 1e6 : 1 / factor), 3) : "-";
      };
      char line[160];
      std::snprintf(line, sizeof line, "%-24s %8s +- %-7s %-4s (%zu of %zu rocks, median %s)\n",
                    readings_[k].name.c_str(), said_as(mean.mean).c_str(),
                    said_as(mean.ci95).c_str(),
                    microns      ? "um"
                    : factor > 1 ? "MPa"
                                 : readings_[k].unit.c_str(),
                    values.size(), runs_.size(), said_as(median(values)).c_str());
      lines += line;
    }
    return lines + "mean over the rocks whose crack is still inside, and its 95 % interval\n";
  }

 private:
  struct Run {
    int seed = 0;
    std::vector<observe::GrowthInstant> history{};
    std::vector<double> values{};  ///< one per reading

    void exchange(auto& archive) { archive(seed, history, values); }
  };

  /// The values that the runs have for one reading.
  std::vector<double> of(std::size_t reading) const {
    std::vector<double> values;
    for (const Run& r : runs_)
      if (std::isfinite(r.values[reading])) values.push_back(r.values[reading]);
    return values;
  }

  static double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
  }

  std::string table() const {
    std::string text = "seed";
    for (const RockReading& r : readings_) text += ',' + r.key;
    for (const Run& run : runs_) {
      text += '\n' + std::to_string(run.seed);
      for (const double v : run.values) text += ',' + (std::isfinite(v) ? to_text(v) : "");
    }
    return text + '\n';
  }

  Summary summary() const {
    Summary s;
    s.set("rocks", static_cast<long>(runs_.size()));
    s.set("first_seed", config_.specimen.seed);
    s.set("stopped", static_cast<long>(stopped_.size()));
    for (std::size_t k = 0; k < readings_.size(); ++k) {
      const auto values = of(k);
      if (values.empty()) continue;
      const auto mean = measure::SampleMean::of(values);
      const std::string& key = readings_[k].key;
      s.set(key, mean.mean);
      s.set(key + "_ci95", mean.ci95);
      s.set(key + "_median", median(values));
      s.set(key + "_count", static_cast<long>(values.size()));
      if (std::isfinite(readings_[k].paper))
        s.compare("paper/" + key, mean.mean, readings_[k].paper);
    }
    return s;
  }

  template <class F>
  observe::Chart bundle(const std::string& title, const std::string& y_label, F&& value) const {
    observe::Chart chart{.title = title,
                         .x_label = "injection time (s)",
                         .y_label = y_label,
                         .caption = "One line for each of " + std::to_string(runs_.size()) +
                                    " rocks; each ends where its crack reaches the rim.",
                         .conditions = conditions()};
    for (const Run& run : runs_) {
      observe::Series s{.colour = observe::okabe_ito::blue};
      for (const auto& i : run.history) s.x.push_back(i.time), s.y.push_back(value(i));
      chart.series.push_back(std::move(s));
    }
    return chart;
  }
  observe::Chart pressure() const {
    auto chart = bundle("Injection pressure", "pressure (MPa)",
                        [](const auto& i) { return i.pressure / 1e6; });
    predict(chart, [](const auto& crack) { return crack.pressure / 1e6; });
    return chart;
  }
  observe::Chart length() const {
    auto chart = bundle("Distance between the tips", "distance (m)",
                        [](const auto& i) { return i.tip_distance; });
    predict(chart, [](const auto& crack) { return crack.full_length; });
    const double published = paper_case(config_).tip_distance;
    if (std::isfinite(published)) chart.points = {{"paper", paper::Intact::time, published}};
    return chart;
  }
  template <class F>
  void predict(observe::Chart& chart, F&& value) const {
    double last = 0;
    for (const Run& run : runs_)
      if (!run.history.empty()) last = std::fmax(last, run.history.back().time);
    const bool published = std::isfinite(paper_case(config_).tip_distance);
    chart.x_range = observe::Range{0, std::fmax(last, published ? 1.53 : 0)};
    const auto prediction = prediction_of(measured_, config_);
    add_predicted(chart, prediction ? &*prediction : nullptr, value);
  }

  std::string conditions() const {
    return described(config_, config_.specimen.grains.value_or(0)) + " Seeds " +
           std::to_string(config_.specimen.seed) + " to " +
           std::to_string(runs_.empty() ? config_.specimen.seed : runs_.back().seed) + ".";
  }

  std::string report() const {
    observe::Report page;
    page.title = std::to_string(runs_.size()) + " rocks, one crack in each";
    page.lead = "Every seed is another specimen of the same rock: " + conditions();
    page.program = "hfdem " + manifest_.version + ", program " + manifest_.program;
    page.figure(length());
    page.figure(pressure());
    page.section("Means");
    const bool paper = std::any_of(readings_.begin(), readings_.end(),
                                   [](const RockReading& r) { return std::isfinite(r.paper); });
    observe::Table means{.caption =
                             "With the 95 % interval of Student's t, over the rocks whose "
                             "crack is still inside the specimen.",
                         .header = {"", "mean", "95 %", "median", "rocks"}};
    if (paper) means.header.push_back("paper");
    for (std::size_t k = 0; k < readings_.size(); ++k) {
      const auto values = of(k);
      if (values.empty()) continue;
      const auto mean = measure::SampleMean::of(values);
      const auto words = [&](double v) { return rounded(v, readings_[k].unit); };
      means.rows.push_back({readings_[k].name, words(mean.mean), "± " + words(mean.ci95),
                            words(median(values)), std::to_string(values.size())});
      if (paper) means.rows.back().push_back(words(readings_[k].paper));
    }
    page.table(means);
    for (const int seed : stopped_)
      page.text("The run of seed " + std::to_string(seed) + " stopped: see its own report.");
    page.section("Files");
    std::vector<observe::File> beside{
        {"seeds.csv", "every reading of every rock"},
        {"summary.json", "the means with their intervals"},
        {"config.toml", "every parameter; repeats the runs with --config and --seeds"}};
    for (const Run& run : runs_)
      beside.push_back(
          {"seed_" + std::to_string(run.seed) + "/report.html", "one rock's own report"});
    page.files(beside);
    add_manifest(page, manifest_);
    return page.html();
  }

  /// Three digits, in a unit of everyday size.
  static std::string rounded(double value, const std::string& unit) {
    if (!std::isfinite(value)) return "–";
    if (unit == "Pa") return observe::fixed(value / 1e6, 2, "MPa");
    if (unit == "m" && value < 1e-3) return observe::fixed(value * 1e6, 1, "µm");
    return unit.empty() ? observe::fixed(value, 2) : observe::fixed(value, 3, unit);
  }

  const Config config_;
  const Manifest& manifest_;
  std::optional<MeasuredRock> measured_;
  std::vector<RockReading> readings_;
  std::vector<Run> runs_;
  std::vector<int> stopped_;
};

}  // namespace hfdem::support
