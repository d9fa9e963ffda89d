/// @file
/// What a run says of its prediction: in summary.json, on the terminal and in the report.
#pragma once

#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include <hfdem/observe/report.hpp>

#include "support/prediction.hpp"
#include "support/run_report.hpp"
#include "support/summary.hpp"

namespace hfdem::support {

/// A run and its predictions at one time.
class PredictionResults {
 public:
  using Crack = analytic::LatticeCrack;

  PredictionResults(const Prediction& prediction, double time, const Crack& run)
      : prediction_(prediction),
        run_(run),
        specimen_(prediction.in_specimen(time)),
        plane_(prediction.in_plane(time)),
        problem_(prediction.problem(time)) {}

  /// Step by step in the specimen; nothing once it has split.
  const std::optional<Crack>& in_specimen() const { return specimen_; }

  void summarise(Summary& s) const {
    s.set("toughness/E_prime_Pa", problem_.E_prime);
    s.set("toughness/K_IC_Pa_sqrt_m", problem_.K_IC);
    s.set("toughness/tau", analytic::dimensionless_time(problem_));
    s.set("toughness/K_m", analytic::dimensionless_toughness(problem_));
    s.set("toughness/regime", regime());
    s.set("toughness/same_lattice", prediction_.differences().empty());
    s.set("toughness/specimen_split", !specimen_);
    if (specimen_) compare(s, "toughness/in_specimen", *specimen_);
    if (plane_) compare(s, "toughness/in_infinite_plane", *plane_);
  }

  /// Some lines for a terminal.
  std::string text() const {
    char text[600];
    std::snprintf(text, sizeof text,
                  "K_m = %.2f, tau = %.3g: %s regime (E' = %.2f GPa, K_IC = %.3f MPa sqrt(m))\n",
                  analytic::dimensionless_toughness(problem_),
                  analytic::dimensionless_time(problem_), regime().c_str(), problem_.E_prime / 1e9,
                  problem_.K_IC / 1e6);
    std::string lines = text;
    const auto line = [&](const char* name, const Crack& c) {
      std::snprintf(text, sizeof text, "%-24s %.3f m   %5.1f um (w - w0)   %6.3f MPa net\n", name,
                    c.full_length, c.opening * 1e6, c.net_pressure / 1e6);
      lines += text;
    };
    line("this run", run_);
    if (specimen_)
      line("predicted from slits", *specimen_);
    else
      lines += "predicted from slits     the specimen has split\n";
    if (plane_)
      line("KGD with these numbers", *plane_);
    else
      lines += "KGD with these numbers   too short to grow steadily\n";
    for (const std::string& d : prediction_.differences()) lines += "beware: " + d + "\n";
    return lines;
  }

  /// @param equilibrium whether the run's fluid steps end at equilibrium
  void add_to(observe::Report& page, bool equilibrium) const {
    using observe::fixed;
    page.section("Prediction from measured toughness");
    page.text(
        "Slits held open by a given pressure gave the modulus and the toughness of this lattice; "
        "from them alone, with nothing fitted to a run, follows the growth of the crack in a plate "
        "of this size, one contact at each tip at a time. The infinite plane is the usual KGD "
        "solution with the same numbers: lengths and openings hardly see the sides of the "
        "specimen, "
        "the net pressure does.");
    if (!prediction_.differences().empty()) {
      std::string words = "Beware: the slits were of another lattice.";
      for (const std::string& d : prediction_.differences()) words += "\n" + d + ".";
      page.text(words);
    }
    observe::Table table{.header = {"", "hfdem", "in the specimen", "difference",
                                    "in an infinite plane", "difference"}};
    const auto row = [&](const std::string& name, double Crack::*value, double unit, int decimals,
                         std::string_view words) {
      const auto said = [&](const std::optional<Crack>& c) {
        return fixed(c ? (*c).*value / unit : NAN, decimals, words);
      };
      // A crack that is still closed has no net pressure to compare.
      const auto beside = [&](const std::optional<Crack>& c) {
        return difference(run_.opening > 0 ? run_.*value : NAN, c ? (*c).*value : NAN);
      };
      table.rows.push_back(
          {name, said(run_), said(specimen_), beside(specimen_), said(plane_), beside(plane_)});
    };
    row("crack length", &Crack::full_length, 1, 3, "m");
    row("opening at the injection, w − w_{0}", &Crack::opening, 1e-6, 1, "µm");
    row("net pressure", &Crack::net_pressure, 1e6, 3, "MPa");
    page.table(table);
    if (!equilibrium)
      page.text(
          "This run's fluid steps end by the paper's rule, which leaves the walls of the crack "
          "in motion and the pressure ahead of equilibrium; with scheme.equilibrium = true "
          "that part of the difference goes.");
    if (!specimen_) page.text("By this time the prediction has split the specimen.");
    page.facts(
        {{"dimensionless toughness K_{m}", fixed(analytic::dimensionless_toughness(problem_), 2)},
         {"dimensionless time τ", fixed(analytic::dimensionless_time(problem_), 3)},
         {"regime", regime()},
         {"E'", fixed(problem_.E_prime / 1e9, 2, "GPa")},
         {"K_{IC} at the net pressure of the infinite plane",
          fixed(problem_.K_IC / 1e6, 3, "MPa·m^{1/2}")}});
  }

 private:
  std::string regime() const {
    return std::string(
        names_of<analytic::KgdRegime>[static_cast<std::size_t>(analytic::regime(problem_))]);
  }

  void compare(Summary& s, const std::string& path, const Crack& reference) const {
    s.compare(path + "/full_length_m", run_.full_length, reference.full_length);
    s.compare(path + "/opening_at_injection_m", run_.opening, reference.opening);
    s.compare(path + "/net_pressure_Pa", run_.net_pressure, reference.net_pressure);
  }

  const Prediction& prediction_;
  Crack run_;
  std::optional<Crack> specimen_, plane_;
  analytic::KgdProblem problem_;
};

}  // namespace hfdem::support
