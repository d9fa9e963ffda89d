/// @file
/// The figures of a study of random rock.
#pragma once

#include <cmath>
#include <string>

#include <hfdem/observe/chart.hpp>

#include "support/random_toughness_study.hpp"

namespace hfdem::support {

/// Draws what it refers to, which must outlive it.
class RandomToughnessFigures {
 public:
  RandomToughnessFigures(const RandomToughnessConfig& config, const RandomToughnessStudy& study,
                         const analytic::RockFracture& rock, const GrowthPrediction& growth)
      : config_(config), study_(study), rock_(rock), growth_(growth) {}

  observe::Chart pressure() const {
    observe::Chart chart{
        .title = "Pressure of a running crack",
        .x_label = "tip distance (m)",
        .y_label = "net pressure above the in-situ stress (MPa)",
        .caption =
            "One line per seed: the mean pressure at each length that the crack had. Dashed: "
            "the pressure at which a central crack in the finite plate has the mean "
            "toughness, and 20 % more or less of it.",
        .conditions = conditions()};
    const double width = study_.seeds().front().plate.width();
    for (const SeedResult& s : study_.seeds()) {
      observe::Series line{.colour = pale};
      std::size_t steps = 0;
      for (const measure::CrackInstant& now : s.crack) {
        const double p = now.net_pressure / 1e6;
        if (!line.x.empty() && line.x.back() == now.full_length()) {
          line.y.back() += (p - line.y.back()) / static_cast<double>(++steps);
        } else {
          line.x.push_back(now.full_length()), line.y.push_back(p), steps = 1;
        }
      }
      chart.series.push_back(line);
    }
    for (const double part : {0.8, 1.0, 1.2}) {
      const double K = part * rock_.K_IC_above_in_situ;
      observe::Series curve{.name = observe::fixed(K / 1e6, 2, "MPa·m^{1/2}"),
                            .style = observe::Series::Style::dashed};
      for (double r = 0.1; r < 0.901; r += 0.02)
        curve.x.push_back(r * width),
            curve.y.push_back(study_.seeds().front().plate.pressure_at(K, r * width) / 1e6);
      chart.series.push_back(curve);
    }
    return chart;
  }

  observe::Chart opening() const {
    observe::Chart chart{
        .title = "Opening of the slits",
        .x_label = "net pressure above the in-situ stress (MPa)",
        .y_label = "mean opening near the middle (µm)",
        .caption =
            "Lines: mean over the seeds, of slits whose bonds do not break. Dashed: a slit "
            "in the elastic plate with the mean E' that closes at the mean closing "
            "pressure.",
        .conditions = conditions()};
    const auto& first = study_.seeds().front().slits.readings;
    for (std::size_t k = 0; k < first.size(); ++k) {
      double length = 0;
      observe::Series line, plate{.style = observe::Series::Style::dashed};
      for (const SeedResult& s : study_.seeds())
        length +=
            2 * s.slits.readings[k].slit.half_length / static_cast<double>(study_.seeds().size());
      line.name = observe::fixed(length, 2, "m");
      for (std::size_t j = 0; j < first[k].slit.states.size(); ++j) {
        const double p = first[k].slit.states[j].net_pressure;
        const measure::SampleMean opening =
            study_.mean([&](const auto& s) { return s.slits.readings[k].slit.states[j].opening; });
        line.x.push_back(p / 1e6), line.y.push_back(opening.mean * 1e6);
        const double reach = std::fmin(2 * config_.study.opening_reach / length, 1.0);
        const double width = 2 * length * study_.seeds().front().plate.factors(length).width *
                             measure::mean_of_ellipse(reach);
        plate.x.push_back(p / 1e6);
        plate.y.push_back((p - rock_.closing_excess) * width / rock_.E_prime * 1e6);
      }
      chart.series.push_back(line);
      plate.colour = observe::drawing::ink;
      chart.series.push_back(plate);
    }
    return chart;
  }

  observe::Chart length() const {
    observe::Chart chart{.title = "Predicted growth beside the running cracks",
                         .x_label = "injection time (s)",
                         .y_label = "tip distance (m)",
                         .caption =
                             "One line per seed. Dotted: growth of a central crack in the "
                             "finite plate at K_{IC}, until it splits the plate.",
                         .conditions = conditions()};
    for (const SeedResult& s : study_.seeds()) {
      observe::Series line{.colour = pale};
      for (const measure::CrackInstant& now : s.crack) {
        if (!line.y.empty() && line.y.back() == now.full_length()) continue;
        if (!line.y.empty()) line.x.push_back(now.time), line.y.push_back(line.y.back());
        line.x.push_back(now.time), line.y.push_back(now.full_length());
      }
      line.x.push_back(s.crack.back().time), line.y.push_back(line.y.back());
      chart.series.push_back(line);
    }
    observe::Series predicted{.name = "predicted", .style = observe::Series::Style::dotted};
    for (int k = 1; k < 100; ++k)
      if (const auto crack = growth_.at(k * growth_.splitting_time() / 100))
        predicted.x.push_back(k * growth_.splitting_time() / 100),
            predicted.y.push_back(crack->full_length);
    chart.series.push_back(predicted);
    return chart;
  }

  std::string conditions() const {
    const RandomRock& r = config_.rock;
    return std::to_string(study_.seeds().size()) + " random packings of " +
           in_words(r.specimen.width) + " x " + in_words(r.specimen.height) + " m, radii of " +
           in_words(r.specimen.radius_min * 1e3) + " to " + in_words(r.specimen.radius_max * 1e3) +
           " mm, under " + in_words(r.in_situ.xx / 1e6) + " MPa (x) and " +
           in_words(r.in_situ.yy / 1e6) + " MPa (y).";
  }

 private:
  static constexpr observe::Colour pale{170, 180, 190};

  const RandomToughnessConfig& config_;
  const RandomToughnessStudy& study_;
  const analytic::RockFracture& rock_;
  const GrowthPrediction& growth_;
};

}  // namespace hfdem::support
