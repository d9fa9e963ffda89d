/// @file
/// What a change of one parameter does to a crack in intact rock: paired differences over seeds.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <hfdem/measure/sample_mean.hpp>

#include "support/rock_readings.hpp"

namespace hfdem::support {

/// A row of the study: settings of a parameter file, and what came of them.
struct Variation {
  std::string name;                             ///< in words
  std::vector<std::string> assignments;         ///< section.key=value; none for the base
  std::vector<std::vector<double>> readings{};  ///< per seed, one per reading; NAN if stopped

  void exchange(auto& archive) { archive(name, assignments, readings); }
};

/// The parameters that a user may doubt, one at a time.
inline std::vector<Variation> usual_variations() {
  return {{"moments do not count", {"contact.moment_factor=0"}},
          {"moments count half", {"contact.moment_factor=0.5"}},
          {"channels as long as bonds", {"channels.length=bond"}},
          {"frozen platens", {"boundary.kind=frozen"}},
          {"dead loads", {"boundary.kind=dead_loads"}},
          {"bonds up to a gap of 0.5 %", {"specimen.bonding_gap=0.005"}},
          {"bonds up to a gap of 5 %", {"specimen.bonding_gap=0.05"}},
          {"preset crack of 16 mm", {"crack.length=0.016"}},
          {"preset crack of 48 mm", {"crack.length=0.048"}},
          {"strengths scatter by 40 %", {"contact.weibull_modulus=2.7"}},
          {"friction 0.25", {"contact.friction=0.25"}},
          {"damping 0.3", {"mechanics.damping=0.3"}},
          {"residual aperture 3 µm", {"aperture.w0=3e-6"}},
          {"fluid steps of 0.1 ms", {"scheme.fluid_dt=1e-4"}},
          {"fluid steps of 5 ms", {"scheme.fluid_dt=5e-3"}},
          {"the paper's rule",
           {"scheme.equilibrium=false", "scheme.max_mechanical_steps=10",
            "scheme.volume_tolerance=0.01"}}};
}

/// The readings of the study.
inline std::vector<RockReading> sensitivity_readings() {
  using observe::GrowthInstant;
  const auto last = [](double time, double GrowthInstant::*value) {
    return [time, value](const RockOutcome& o, const observe::Growth& growth) {
      const auto* then = growth.at(time);
      return then == nullptr || o.end.time < time ? o.end.*value : then->*value;
    };
  };
  return {{"breakdown_pressure_Pa", "breakdown (MPa)", "Pa",
           [](const auto& o, const auto&) { return o.breakdown; }},
          {"propagation_pressure_Pa", "propagation (MPa)", "Pa",
           [](const auto& o, const auto&) { return o.propagation; }},
          {"tip_distance_m", "tips (m)", "m", last(0.6, &GrowthInstant::tip_distance)},
          {"total_length_m", "microcracks (m)", "m", last(0.6, &GrowthInstant::total_length)},
          {"tortuosity", "tortuosity", "", last(0.6, &GrowthInstant::tortuosity)}};
}

/// The table of a study; its first row is the base.
class SensitivityResults {
 public:
  SensitivityResults(const std::vector<Variation>& rows, const std::vector<RockReading>& readings)
      : rows_(rows), readings_(readings) {}

  /// Means of the base and mean changes of every variation, with 95 % intervals; in MPa and m.
  observe::Table table() const {
    observe::Table table{.header = {""}};
    for (const RockReading& r : readings_) table.header.push_back(r.name);
    for (const Variation& row : rows_) {
      std::vector<std::string> cells{row.name};
      for (std::size_t k = 0; k < readings_.size(); ++k) cells.push_back(cell(row, k));
      table.rows.push_back(cells);
    }
    return table;
  }

  /// The same for a document in Markdown.
  std::string markdown() const {
    const observe::Table all = table();
    std::string text = line(all.header) + line(std::vector<std::string>(all.header.size(), "---"));
    for (const auto& row : all.rows) text += line(row);
    return text;
  }

  /// Every reading of every run.
  std::string csv(int first_seed) const {
    std::string text = "variation,seed";
    for (const RockReading& r : readings_) text += ',' + r.key;
    for (const Variation& row : rows_)
      for (std::size_t s = 0; s < row.readings.size(); ++s) {
        text += '\n' + row.name + ',' + std::to_string(first_seed + static_cast<int>(s));
        for (const double v : row.readings[s]) text += ',' + (std::isfinite(v) ? to_text(v) : "");
      }
    return text + '\n';
  }

 private:
  static std::string line(const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& c : cells) text += ' ' + c + " |";
    return text + '\n';
  }

  /// Of the same seeds in both rows: what all rocks share cancels.
  std::string cell(const Variation& row, std::size_t reading) const {
    const bool base = &row == &rows_.front();
    std::vector<double> values;
    for (std::size_t s = 0; s < row.readings.size(); ++s) {
      const double before = base ? 0 : rows_.front().readings[s][reading];
      const double value = row.readings[s][reading] - before;
      if (std::isfinite(value)) values.push_back(value);
    }
    if (values.empty()) return "–";
    const auto mean = measure::SampleMean::of(values);
    const bool pressure = readings_[reading].unit == "Pa";
    const auto words = [&](double v) {
      return observe::fixed(pressure ? v / 1e6 : v, pressure ? 2 : 3);
    };
    return (!base && mean.mean >= 0 ? "+" : "") + words(mean.mean) +
           (std::isfinite(mean.ci95) ? " ± " + words(mean.ci95) : "") +
           (values.size() < row.readings.size() ? " (" + std::to_string(values.size()) + " of " +
                                                      std::to_string(row.readings.size()) + ")"
                                                : "");
  }

  const std::vector<Variation>& rows_;
  const std::vector<RockReading>& readings_;
};

}  // namespace hfdem::support
