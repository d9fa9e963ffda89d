/// @file
/// The figures of rock tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/crack_map.hpp>
#include <hfdem/observe/html.hpp>

#include "support/rock_tests_model.hpp"

namespace hfdem::support {

/// What was tested, in one sentence for captions.
inline std::string described(const RockTestsConfig& c, std::size_t specimens) {
  return (specimens == 1 ? "One random specimen"
                         : std::to_string(specimens) + " random specimens") +
         " of " + in_words(c.specimen.width) + " m × " + in_words(c.specimen.height) +
         " m, radii " + in_words(c.specimen.radius_min * 1e3) + " to " +
         in_words(c.specimen.radius_max * 1e3) + " mm, strained at " +
         in_words(c.load_frame.strain_rate) + " per second.";
}

/// "unconfined" or "5 MPa".
inline std::string confinement_name(double confinement) {
  return confinement == 0 ? "unconfined" : in_words(confinement / 1e6) + " MPa";
}

class RockTestsFigures {
 public:
  RockTestsFigures(const RockTestsConfig& config, std::span<const SpecimenTests> specimens)
      : config_(config), specimens_(specimens) {}

  observe::Chart compression() const {
    observe::Chart chart{.title = "Compression",
                         .x_label = "axial strain (‰)",
                         .y_label = "axial stress (MPa)",
                         .caption =
                             "Each line is a specimen; those of one colour were under the "
                             "same confinement. " +
                             ring_words(),
                         .conditions = conditions()};
    for (std::size_t k = 0; k < specimens_.front().compression.size(); ++k)
      add_curves(
          chart, confinement_name(specimens_.front().compression[k].confinement),
          k, [k](const SpecimenTests& s) -> const auto& { return s.compression[k]; });
    const measure::RockTest& first = specimens_.front().compression.front();
    chart.points = {{"paper, unconfined " + observe::fixed(paper::Rock::ucs / 1e6, 1, "MPa"),
                     1e3 * first.strain_at_strength, paper::Rock::ucs / 1e6}};
    return chart;
  }

  observe::Chart tension() const {
    observe::Chart chart{.title = "Tension",
                         .x_label = "strain between the ends (‰)",
                         .y_label = "tensile stress (MPa)",
                         .caption =
                             "Direct tension between grips, and the Brazilian test, whose "
                             "stress is that in the middle of an elastic plate. " +
                             ring_words(),
                         .conditions = conditions()};
    add_curves(
        chart, "direct tension", 0,
        [](const SpecimenTests& s) -> const auto& { return s.tension; });
    add_curves(
        chart, "Brazilian test", 1,
        [](const SpecimenTests& s) -> const auto& { return s.brazilian; });
    const double strength = paper::Rock::tensile_strength / 1e6;
    chart.points = {{"paper " + observe::fixed(strength, 1, "MPa"),
                     1e3 * specimens_.front().tension.strain_at_strength, strength}};
    return chart;
  }

  observe::Chart envelope() const {
    const auto coulomb = support::envelope(specimens_);
    observe::Chart chart{.title = "Strength under confinement",
                         .x_label = "confinement σ_{3} (MPa)",
                         .y_label = "strength σ_{1} (MPa)",
                         .caption =
                             "Each dot is a test; the line is the least-squares fit "
                             "to all of them, the unconfined ones included: φ = " +
                             observe::fixed(coulomb.friction_angle, 1, "°") +
                             ", c = " + observe::fixed(coulomb.cohesion / 1e6, 2, "MPa") + ".",
                         .conditions = conditions()};
    observe::Series dots{.name = "tests", .style = observe::Series::Style::markers};
    for (const SpecimenTests& s : specimens_)
      for (const auto& t : s.compression)
        dots.x.push_back(t.confinement / 1e6), dots.y.push_back(t.strength / 1e6);
    observe::Series fit{.name = "fit"};
    observe::Series published{.name = "paper, φ and c", .style = observe::Series::Style::dashed};
    const double sine = std::sin(paper::Rock::friction_angle * std::numbers::pi / 180);
    const double slope = (1 + sine) / (1 - sine);
    for (const double sigma_3 : {0.0, config_.study.largest_confinement}) {
      fit.x.push_back(sigma_3 / 1e6);
      published.x.push_back(sigma_3 / 1e6);
      fit.y.push_back((coulomb.envelope.intercept + coulomb.envelope.slope * sigma_3) / 1e6);
      published.y.push_back((2 * paper::Rock::cohesion * std::sqrt(slope) + slope * sigma_3) / 1e6);
    }
    chart.series = {dots, fit, published};
    return chart;
  }

  /// Of the first specimen.
  observe::CrackMap cracks() const {
    const SpecimenTests& s = specimens_.front();
    observe::CrackMap map{.title = "Broken bonds at the end of each test",
                          .caption = "The specimen of seed " + std::to_string(s.seed) +
                                     ". A test ends when its load has fallen to " +
                                     in_words(100 * config_.load_frame.end_below) +
                                     " % of its peak, or at a strain of " +
                                     in_words(100 * config_.load_frame.largest_strain) + " %.",
                          .conditions = conditions()};
    const auto add = [&map](const std::string& name, const measure::RockTest& test) {
      map.specimens.push_back({name + ": " + observe::fixed(test.strength / 1e6, 1, "MPa"), &test});
    };
    for (const auto& t : s.compression)
      add(t.confinement == 0 ? "unconfined" : "under " + confinement_name(t.confinement), t);
    add("direct tension", s.tension);
    add("Brazilian test", s.brazilian);
    return map;
  }

 private:
  std::string conditions() const { return described(config_, specimens_.size()); }
  static std::string ring_words() { return "The ring is the strength that the paper gives."; }

  /// Each specimen's curve in one colour; one of them has the name.
  template <class Which>
  void add_curves(observe::Chart& chart, const std::string& name, std::size_t colour,
                  Which&& which) const {
    for (const SpecimenTests& s : specimens_) {
      observe::Series line{.name = &s == &specimens_.front() ? name : "",
                           .colour = observe::palette[colour % observe::palette.size()]};
      for (const measure::LoadReading& r : which(s).curve)
        line.x.push_back(1e3 * r.strain), line.y.push_back(r.stress / 1e6);
      chart.series.push_back(line);
    }
  }

  const RockTestsConfig& config_;
  std::span<const SpecimenTests> specimens_;
};

}  // namespace hfdem::support
