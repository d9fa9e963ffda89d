/// @file
/// The numbers that studies over several rocks read from each of them.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <hfdem/observe/growth.hpp>

#include "support/paper.hpp"
#include "support/rock_outcome.hpp"

namespace hfdem::support {

/// A number that is read from every run.
struct RockReading {
  std::string key, name, unit;  ///< in summary.json; in words; SI
  std::function<double(const RockOutcome&, const observe::Growth&)> read;
  double paper = NAN;  ///< where the run may stand beside it
};

/// At a time, if the crack was still inside the specimen then.
template <class F>
auto inside_at(double time, F&& value) {
  return [time, value](const RockOutcome& o, const observe::Growth& growth) {
    const auto* then = growth.at(time);
    return then == nullptr || o.end.time * (1 + 1e-9) < time ? NAN : value(*then);
  };
}

/// A microcrack count of the end, as a reading.
template <class F>
RockReading count_reading(const std::string& key, const std::string& name, F&& count,
                          double paper = NAN) {
  return {"microcracks/" + key, name, "",
          [count](const RockOutcome& o, const auto&) { return static_cast<double>(count(o)); },
          paper};
}

/// Table 5 of the paper.
inline std::vector<RockReading> joint_readings(const paper::Case& paper) {
  return {count_reading("rock", "microcracks in rock",
                        [](const RockOutcome& o) {
                          return o.count.total() - o.preset() - o.in_joints.total();
                        }),
          count_reading(
              "joints", "microcracks in joints",
              [](const RockOutcome& o) { return o.in_joints.total(); }, paper.joint_microcracks),
          count_reading(
              "connected_joints", "of which connected",
              [](const RockOutcome& o) { return o.in_joints.connected.total(); },
              paper.connected_microcracks)};
}

/// What is read of every run; not a number where a run has none.
template <class Config>
std::vector<RockReading> rock_readings(const Config& config, bool with_joints) {
  const paper::Case paper = paper_case(config);
  std::vector<RockReading> all{
      {"first_break_pressure_Pa", "first break", "Pa",
       [](const auto& o, const auto&) { return o.first_break; }},
      {"breakdown_pressure_Pa", "breakdown", "Pa",
       [](const auto& o, const auto&) { return o.breakdown; }, paper.breakdown},
      {"propagation_pressure_Pa", "propagation", "Pa",
       [](const auto& o, const auto&) { return o.propagation; }},
      {"pressure_drop_Pa", "pressure drop at the end", "Pa",
       [](const auto& o, const auto&) { return o.pressure_drop; }},
      {"reached_rim_at_s", "reached the rim", "s",
       [](const auto& o, const auto&) { return o.rim_time.value_or(NAN); }}};
  for (const double time : {0.3, 0.6, 0.9, 1.5}) {
    const bool published = time == paper::Intact::time;
    const std::string at = to_text(time) + "_s/", when = " at " + to_text(time) + " s";
    const auto add = [&](const std::string& key, const std::string& name, const std::string& unit,
                         double observe::GrowthInstant::*value, double printed) {
      all.push_back({at + key, name + when, unit,
                     inside_at(time, [value](const auto& i) { return i.*value; }),
                     published ? printed : NAN});
    };
    using observe::GrowthInstant;
    add("tip_distance_m", "tips", "m", &GrowthInstant::tip_distance, paper.tip_distance);
    add("connected_length_m", "microcracks", "m", &GrowthInstant::connected_length,
        paper.total_length);
    add("tortuosity", "tortuosity", "", &GrowthInstant::tortuosity, paper.tortuosity);
    add("asymmetry", "asymmetry", "", &GrowthInstant::asymmetry, NAN);
    add("mean_aperture_m", "aperture", "m", &GrowthInstant::aperture, paper.aperture);
  }
  if (with_joints)
    for (const RockReading& r : joint_readings(paper)) all.push_back(r);
  return all;
}

}  // namespace hfdem::support
