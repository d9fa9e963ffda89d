/// @file
/// The figures of a run in random rock: the paper's Figs. 7 to 15 and 18.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <hfdem/measure/measurement_circle.hpp>
#include <hfdem/measure/particle_stress.hpp>
#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/fracture_map.hpp>
#include <hfdem/observe/growth.hpp>
#include <hfdem/observe/html.hpp>
#include <hfdem/observe/stress_map.hpp>

#include "support/growth_prediction.hpp"
#include "support/injected.hpp"
#include "support/paper.hpp"
#include "support/rock_model.hpp"
#include "support/schemes.hpp"

namespace hfdem::support {

/// What a run was, in one sentence for captions.
template <class Config>
std::string described(const Config& c, long discs) {
  const auto& p = c.simulator;
  return std::to_string(discs) + " discs of radius " + in_words(c.specimen.radius_min * 1e3) +
         " to " + in_words(c.specimen.radius_max * 1e3) + " mm (seed " +
         std::to_string(c.specimen.seed) + ") under " + in_words(p.in_situ.xx / 1e6) +
         " MPa (x) and " + in_words(p.in_situ.yy / 1e6) + " MPa (y), " +
         described(p.injection, said_fluid<typename Config::Sim>(p)) + ", fluid steps of " +
         in_words(p.scheme.fluid_dt * 1e3) + " ms " + std::string(words_of(p.scheme).steps) + ".";
}

/// The KGD fracture with the E' and K_IC with which the paper computed it for its rock, and this
/// run's rate: the toughness vertex as there, or the general solution where viscosity matters.
template <class Config>
analytic::KgdFracture paper_kgd(const Config& c, double time) {
  return reference_kgd<typename Config::Sim>(c.simulator, paper::Intact::E_prime,
                                             paper::Intact::K_IC, time);
}

/// Below the other lines: growth in the finite plate, as modulus and toughness of the rock say.
template <class F>
void add_predicted(observe::Chart& chart, const GrowthPrediction* prediction, F&& value) {
  if (prediction == nullptr || !chart.x_range) return;
  observe::Series s{.name = "predicted, finite plate",
                    .style = observe::Series::Style::dotted,
                    .colour = observe::okabe_ito::vermillion};
  constexpr int points = 500;
  for (int k = 1; k <= points; ++k) {
    const double time = chart.x_range->high * k / points;
    const auto crack = prediction->at(time);
    if (!crack) break;
    s.x.push_back(time);
    s.y.push_back(value(*crack));
  }
  chart.series.insert(chart.series.begin(), std::move(s));
  chart.caption +=
      " Predicted: growth in the finite plate, with the modulus and toughness of the file that was "
      "given.";
}

template <class Config>
class RockFigures {
 public:
  using Sim = typename Config::Sim;
  using Instants = std::vector<observe::GrowthInstant>;

  /// @param prediction to draw beside the run; null if there is none
  RockFigures(const Config& config, const Sim& sim, const Instants& history,
              const GrowthPrediction* prediction)
      : config_(config),
        sim_(sim),
        history_(history),
        prediction_(prediction),
        conditions_(described(config, static_cast<long>(sim.discs().size()))),
        at_time_(" at t = " + observe::fixed(sim.time(), 3, "s")) {}

  /// Fig. 7.
  observe::FractureMap fracture() const {
    auto map = crack("The fracture" + at_time_);
    map.grains = &sim_.specimen();
    map.caption = "The whole specimen beside a close view of the crack.";
    return map;
  }
  /// Figs. 8b, 9b.
  observe::FractureMap apertures() const {
    auto map = crack("Aperture along the crack" + at_time_);
    map.values = observe::apertures(map.microcracks);
    map.caption = "Colour and thickness show the aperture.";
    return map;
  }
  /// Figs. 8a, 9a.
  observe::FractureMap net_pressures() const {
    auto map = crack("Net pressure in the crack" + at_time_);
    map.values = observe::net_pressures(map.microcracks, config_.closing_stress());
    map.caption = flows<Sim> ? "The pressure falls towards the tips: flow spends it."
                             : "One pressure fills the crack: viscosity spends nothing.";
    return map;
  }
  /// Fig. 18.
  observe::StressMap stress() const {
    return {
        .field = measure::stress_field(sim_.specimen(), measure::particle_stress(sim_), circles()),
        .microcracks = measure::microcracks(sim_),
        .injection = measure::injection_point(sim_),
        .title = "Minimum principal stress" + at_time_,
        .caption = "Means over measurement circles of radius " + in_words(circles().radius * 1e3) +
                   " mm. The crack presses the rock beside it and pulls ahead of its tips.",
        .conditions = conditions_};
  }

  /// Figs. 10a, 11a.
  observe::Chart pressure() const {
    auto chart = over_time("Injection pressure", "pressure (MPa)");
    chart.caption =
        "The pressure peaks at breakdown, then falls towards the stress that closes the crack; "
        "each tooth is an advance of the crack.";
    const double closing = config_.closing_stress() / 1e6;
    chart.series = {series("hfdem", [](const auto& i) { return i.pressure / 1e6; }),
                    {.name = "closure stress",
                     .x = {0, end_time()},
                     .y = {closing, closing},
                     .style = observe::Series::Style::dashed,
                     .colour = observe::okabe_ito::black}};
    add_predicted(chart, prediction_, [](const auto& crack) { return crack.pressure / 1e6; });
    return chart;
  }
  /// Figs. 10b, 11b.
  observe::Chart tips() const {
    auto chart = over_time("The two tips", "tip along the crack's direction (m)");
    chart.caption =
        "Distance of both tips from the injection. Plateaus: a wing is held up by the grains "
        "ahead of it.";
    chart.series = {series("upper tip", [](const auto& i) { return i.tip_up; }),
                    series("lower tip", [](const auto& i) { return -i.tip_down; })};
    chart.series[1].colour = observe::okabe_ito::vermillion;
    return chart;
  }
  /// Fig. 12b.
  observe::Chart length() const {
    auto chart = over_time("Length of the crack", "length (m)");
    chart.caption =
        "Along the path from tip to tip, with all branches, and straight from tip to "
        "tip. " +
        reference();
    chart.series = {
        series("all connected microcracks", [](const auto& i) { return i.connected_length; }),
        series("from tip to tip", [](const auto& i) { return i.tip_distance; }),
        kgd([](const auto& f) { return f.full_length(); })};
    chart.series[0].colour = observe::okabe_ito::sky_blue;
    add_predicted(chart, prediction_, [](const auto& crack) { return crack.full_length; });
    add_paper(chart, "paper, microcracks", paper_.total_length);
    add_paper(chart, "paper, tip to tip", paper_.tip_distance);
    return chart;
  }
  /// Fig. 12a.
  observe::Chart aperture() const {
    auto chart = over_time("Aperture at the injection", "aperture (µm)");
    chart.caption = "Mean over 30 mm of crack to both sides of the injection. " + reference();
    chart.series = {series("hfdem", [](const auto& i) { return i.aperture * 1e6; }),
                    kgd([](const auto& f) { return f.width * 1e6; })};
    const double w0 = config_.simulator.aperture.w0;
    add_predicted(chart, prediction_, [w0](const auto& c) { return (c.opening + w0) * 1e6; });
    add_paper(chart, "paper (numerical)", paper_.aperture * 1e6);
    return chart;
  }

 private:
  observe::FractureMap crack(const std::string& title) const {
    observe::FractureMap map{.microcracks = measure::microcracks(sim_),
                             .origin = measure::crack_origin(sim_),
                             .width = sim_.specimen().width,
                             .height = sim_.specimen().height,
                             .natural = sim_.specimen().joints.fractures,
                             .title = title,
                             .conditions = conditions_};
    map.crack = measure::crack_path(map.microcracks, map.origin);
    return map;
  }

  /// Wide enough that each holds some grains, whatever their size.
  measure::CircleGrid circles() const {
    const double largest = config_.specimen.radius_max;
    return {.spacing = 2 * largest, .radius = 3 * largest};
  }

  observe::Chart over_time(const std::string& title, const std::string& y_label) const {
    return {.title = title,
            .x_label = "injection time (s)",
            .y_label = y_label,
            .conditions = conditions_,
            .x_range = observe::Range{0, end_time()}};
  }

  double end_time() const { return history_.empty() ? 0 : history_.back().time; }

  template <class F>
  observe::Series series(const std::string& name, F&& value) const {
    observe::Series s{.name = name, .colour = observe::okabe_ito::blue};
    for (const auto& i : history_) s.x.push_back(i.time), s.y.push_back(value(i));
    return s;
  }

  template <class F>
  observe::Series kgd(F&& value) const {
    observe::Series s{.name = "KGD, infinite plane",
                      .style = observe::Series::Style::dashed,
                      .colour = observe::okabe_ito::orange};
    constexpr int points = 200;
    for (int k = 1; k <= points; ++k) {
      s.x.push_back(end_time() * k / points);
      s.y.push_back(value(paper_kgd(config_, s.x.back())));
    }
    return s;
  }

  void add_paper(observe::Chart& chart, const std::string& name, double value) const {
    if (std::isfinite(value) && end_time() > 0.5 * paper::Intact::time) {
      chart.points.push_back({name, paper::Intact::time, value});
      chart.x_range->high = std::fmax(end_time(), 1.02 * paper::Intact::time);
    }
  }

  static std::string reference() {
    return std::string(flows<Sim> ? "KGD: general solution" : "KGD: toughness vertex") +
           " with the paper's E' = " + in_words(paper::Intact::E_prime / 1e9) +
           " GPa and K_{IC} = " + in_words(paper::Intact::K_IC / 1e6) + " MPa·m^{1/2}.";
  }

  const Config& config_;
  const Sim& sim_;
  const Instants& history_;
  const GrowthPrediction* prediction_;
  std::string conditions_, at_time_;
  paper::Case paper_ = paper_case(config_);
};

}  // namespace hfdem::support
