/// @file
/// The figures of a run of the verification model.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <hfdem/measure/crack.hpp>
#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/history.hpp>
#include <hfdem/observe/specimen_picture.hpp>

#include "support/injected.hpp"
#include "support/kgd_model.hpp"
#include "support/paper.hpp"
#include "support/prediction.hpp"
#include "support/schemes.hpp"
#include "support/settings.hpp"

namespace hfdem::support {

/// What a run was, in one sentence for captions.
template <class Pressure>
std::string described(const KgdConfig<Pressure>& c) {
  const auto& p = c.simulator;
  return std::to_string(c.specimen.columns) + " × " + std::to_string(c.specimen.rows) +
         " discs of radius " + in_words(c.specimen.radius * 1e3) + " mm under " +
         in_words(p.in_situ.xx / 1e6) + " MPa (x) and " + in_words(p.in_situ.yy / 1e6) +
         " MPa (y), " + described(p.injection, said_fluid<typename KgdConfig<Pressure>::Sim>(p)) +
         ", fluid steps " + std::string(words_of(p.scheme).steps) + ".";
}

/// The KGD fracture with the E' and K_IC with which the paper computed it, and this run's rate: the
/// toughness vertex as there, or the general solution where the fluid's viscosity matters.
template <class Config>
analytic::KgdFracture paper_kgd(const Config& c, double time) {
  return reference_kgd<typename Config::Sim>(c.simulator, paper::Verification::E_prime,
                                             paper::Verification::K_IC, time);
}

/// What uniform pressure leaves out of a run, where that is much.
template <class Config>
std::string viscosity_left_out(const Config& c, double time) {
  return viscosity_left_out<typename Config::Sim>(c.simulator, paper::Verification::E_prime,
                                                  paper::Verification::K_IC, time);
}

/// Whether a run is of the paper's model; its rule and its mechanics are free.
template <class Pressure>
bool is_paper_model(KgdConfig<Pressure> config) {
  const KgdConfig<Pressure> paper;
  config.run = paper.run;
  config.simulator.scheme = paper.simulator.scheme;
  config.simulator.mechanics = paper.simulator.mechanics;
  return to_toml(config) == to_toml(paper);
}

/// Whether the paper's numbers hold for a run at this time.
template <class Pressure>
bool at_paper_time(const KgdConfig<Pressure>& config, double time) {
  return is_paper_model(config) && std::abs(time / paper::Verification::time - 1) < 1e-3;
}

template <class Config>
class KgdFigures {
 public:
  using Sim = typename Config::Sim;

  /// @param prediction to draw beside the run; null if there is none
  KgdFigures(const Config& config, const std::vector<observe::Instant>& history,
             const Prediction* prediction)
      : config_(config), history_(history), prediction_(prediction) {}

  /// Fig. 6a.
  observe::Chart aperture() const {
    observe::Chart chart{.title = "Aperture at the injection",
                         .x_label = "injection time (s)",
                         .y_label = "aperture (µm)",
                         .caption =
                             "The aperture grows with the crack and drops at each advance "
                             "of the tips. " +
                             reference(),
                         .conditions = described(config_),
                         .x_range = from_zero()};
    const double w0 = config_.simulator.aperture.w0;
    chart.series = {series("hfdem", [](const auto& i) { return i.crack.aperture * 1e6; }),
                    kgd(&analytic::LatticeCrack::opening, 1e6)};
    add_predicted(chart, [w0](const auto& state) { return (state.opening + w0) * 1e6; });
    add_paper(chart, paper::Verification::aperture * 1e6);
    return chart;
  }

  /// Fig. 6b.
  observe::Chart length() const {
    observe::Chart chart{.title = "Length of the crack",
                         .x_label = "injection time (s)",
                         .y_label = "distance between the tips (m)",
                         .caption =
                             "Each stair is one broken contact, a disc's diameter, at each "
                             "tip. " +
                             reference(),
                         .conditions = described(config_),
                         .x_range = from_zero()};
    chart.series = {series("hfdem", [](const auto& i) { return i.crack.full_length(); }),
                    kgd(&analytic::LatticeCrack::full_length, 1)};
    add_predicted(chart, [](const auto& state) { return state.full_length; });
    add_paper(chart, paper::Verification::full_length);
    return chart;
  }

  observe::Chart pressure() const {
    observe::Chart chart{.title = "Injection pressure",
                         .x_label = "injection time (s)",
                         .y_label = "pressure (MPa)",
                         .caption =
                             "The pressure peaks at breakdown, then falls towards the stress "
                             "that closes the crack; each tooth is one advance of the tips.",
                         .conditions = described(config_),
                         .x_range = from_zero()};
    const double closing = far_field() / 1e6;
    chart.series = {series("hfdem", [](const auto& i) { return i.pressure / 1e6; }),
                    {.name = "closure stress",
                     .x = {0, end_time()},
                     .y = {closing, closing},
                     .style = observe::Series::Style::dashed,
                     .colour = observe::okabe_ito::black}};
    add_predicted(chart,
                  [closing](const auto& state) { return closing + state.net_pressure / 1e6; });
    return chart;
  }

  /// Fig. 5a, b.
  observe::SpecimenPicture specimen(const Sim& sim) const {
    const Vec2 injection = measure::injection_point(sim);
    observe::SpecimenPicture picture{.radius = sim.discs().radius,
                                     .width = sim.specimen().width,
                                     .height = sim.specimen().height,
                                     .injection_x = injection.x,
                                     .injection_y = injection.y,
                                     .stress_x = config_.simulator.in_situ.xx,
                                     .stress_y = config_.simulator.in_situ.yy,
                                     .platens = sim.loading().has_platens(),
                                     .title = "The crack at t = " + in_words(sim.time()) + " s",
                                     .caption =
                                         "The whole specimen, and the discs around the "
                                         "injection.",
                                     .conditions = described(config_)};
    for (const Vec2& c : sim.discs().centre) picture.x.push_back(c.x), picture.y.push_back(c.y);
    for (const Index c : sim.network().wet_channels())
      picture.main_crack.push_back(segment(sim, c, sim.network().width(c)));
    for (const BondBreak& b : sim.breaks())
      if (!sim.network().is_wet(b.contact))
        picture.unconnected.push_back(segment(sim, b.contact, 0));
    return picture;
  }

 private:
  double far_field() const {
    return std::fmin(config_.simulator.in_situ.xx, config_.simulator.in_situ.yy);
  }

  double end_time() const { return history_.empty() ? 0 : history_.back().time; }
  observe::Range from_zero() const { return {0, end_time()}; }

  template <class F>
  observe::Series series(const std::string& name, F&& value) const {
    observe::Series s{.name = name, .colour = observe::okabe_ito::blue};
    for (const auto& i : history_) s.x.push_back(i.time), s.y.push_back(value(i));
    return s;
  }

  /// With measured toughness if there is some, otherwise with the paper's.
  observe::Series kgd(double analytic::LatticeCrack::*value, double factor) const {
    observe::Series s{.name = "KGD, infinite plane",
                      .style = observe::Series::Style::dashed,
                      .colour = observe::okabe_ito::orange};
    constexpr int points = 300;
    for (int k = 1; k <= points; ++k) {
      const double time = end_time() * k / points;
      const auto paper = paper_kgd(config_, time);
      const auto crack =
          prediction_ != nullptr
              ? prediction_->in_plane(time)
              : analytic::LatticeCrack{paper.full_length(), paper.width, paper.net_pressure};
      s.x.push_back(time);
      s.y.push_back(crack ? factor * (*crack).*value : NAN);
    }
    return s;
  }

  /// The staircase in the specimen, if slits were tested; below the run's own line.
  template <class F>
  void add_predicted(observe::Chart& chart, F&& value) const {
    if (prediction_ == nullptr) return;
    observe::Series s{.name = "predicted from slits",
                      .style = observe::Series::Style::dotted,
                      .colour = observe::okabe_ito::vermillion};
    constexpr int points = 2000;
    for (int k = 1; k <= points; ++k) {
      const auto state = prediction_->in_specimen(end_time() * k / points);
      if (!state) break;
      s.x.push_back(end_time() * k / points);
      s.y.push_back(value(*state));
    }
    chart.series.insert(chart.series.begin(), std::move(s));
    chart.caption +=
        " Predicted from slits: stepwise growth in this specimen, nothing fitted to "
        "a run.";
  }

  void add_paper(observe::Chart& chart, double value) const {
    const double time = std::fmin(paper::Verification::time, end_time());
    if (at_paper_time(config_, time)) chart.points = {{"paper (numerical)", time, value}};
  }

  std::string reference() const {
    if (prediction_ != nullptr)
      return "KGD: toughness vertex with E' and K_{IC} measured with slits.";
    return "KGD: toughness vertex with the paper's E' = " +
           in_words(paper::Verification::E_prime / 1e9) + " GPa and K_{IC} = " +
           in_words(paper::Verification::K_IC / 1e6) + " MPa·m^{1/2}.";
  }

  static observe::CrackSegment segment(const Sim& sim, Index contact, double aperture) {
    const auto [from, to] = measure::facet(sim, contact);
    return {from.x, from.y, to.x, to.y, aperture};
  }

  const Config& config_;
  const std::vector<observe::Instant>& history_;
  const Prediction* prediction_;
};

}  // namespace hfdem::support
