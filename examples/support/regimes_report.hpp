/// @file
/// The report of a study of regimes.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <hfdem/analytic/lattice_fracture.hpp>
#include <hfdem/observe/report.hpp>

#include "support/regimes_figures.hpp"
#include "support/regimes_points.hpp"
#include "support/run_report.hpp"

namespace hfdem::support {

class RegimesReport {
 public:
  /// @param rocks as their slits say, in the order of `config.rocks()`
  /// @param wall time of the study, s
  RegimesReport(const RegimesConfig& config, const std::vector<analytic::LatticeFracture>& rocks,
                const std::vector<RegimePoint>& points, const Manifest& manifest, double wall)
      : config_(config), rocks_(rocks), points_(points), manifest_(manifest), wall_(wall) {}

  std::string html() const {
    observe::Report page;
    page.title = "From toughness to viscosity, from storage to leak-off";
    page.lead =
        "Fluids of several viscosities drive cracks through square arrays of bonded discs, "
        "beside the KGD fracture without any fit. " +
        said_rocks(config_);
    page.program = "hfdem " + manifest_.version + ", program " + manifest_.program;
    for (const RegimePoint& p : points_)
      if (!p.ours.stopped.empty()) page.stopped += p.name + ": " + p.ours.stopped + ". ";
    const auto good = std::ranges::count_if(points_, [](const auto& p) { return p.holds(); });
    page.text(std::to_string(good) + " of " + std::to_string(points_.size()) +
              " cracks have a half-length within a disc or 5 % of the reference, an opening "
              "within 8 %; with leak-off a half-length, an opening and an efficiency within 8 %.");
    page.figure(regimes_map(config_, points_));
    page.table(table());
    page.section("Along the cracks");
    const auto cracks = arrived(points_);
    for (std::size_t k = cracks.size(); k-- > 0;) {
      page.figure(opening_chart(*cracks[k]));
      page.figure(pressure_chart(*cracks[k]));
    }
    page.section("What is compared");
    page.text(
        "Modulus, toughness and offsets are those of slits in arrays of the same contacts under "
        "the same stress. A row of contacts opens less than a crack in a continuum, so the "
        "continuum's crack holds more: the reference is that of the injected volume and the "
        "length times the mean offset. Lengths are those of broken contacts, n R for a wing.");
    page.table(rock_table());
    page.text(
        "Toughness grows with the net pressure beside the contact that breaks. In a slit that is "
        "the same everywhere; in a viscous fluid it falls towards the tip, below the in-situ "
        "stress: pressure has no bound in the references, which have no fluid lag.");
    page.table(toughness_table());
    page.section("How the runs went");
    page.text(
        "Suction has a floor that bonds beside the fluid bear; without one, no pressure is found "
        "while the injection begins in a closed crack. The lag is the part of the crack at the "
        "floor, on the mean over the window: fluid comes that low just after a break.");
    page.table(run_table());
    page.facts({{"wall time", observe::fixed(wall_, 1, "s")}});
    add_parameters(page, config_, RegimesConfig{});
    page.section("Files");
    std::vector<observe::File> written{{"points.csv", "the numbers of each crack"},
                                       {"profiles.csv", "opening and pressure along each crack"},
                                       {"summary.json", "all numbers, and those of the slits"},
                                       {"map.svg", "the map"},
                                       {"config.toml",
                                        "every parameter; repeats the study with "
                                        "--config"}};
    for (const RegimePoint* p : arrived(points_)) {
      written.push_back({p->key + "_opening.svg", "the opening of the " + p->name});
      written.push_back({p->key + "_pressure.svg", "its pressure"});
    }
    page.files(written);
    add_manifest(page, manifest_);
    return page.html();
  }

 private:
  observe::Table table() const {
    observe::Table t{
        .caption =
            "Means over the window of time. The opening is w - w_{0} plus the offset of the "
            "slits. f_{w} and f_{K} are what the finite plate does to opening and stress "
            "intensity.",
        .header = {"crack", "K_{m}", "half-length", "KGD", "", "opening", "KGD", "", "net pressure",
                   "KGD", "2a/W", "f_{w}", "f_{K}", "efficiency", "KGD", ""}};
    for (const RegimePoint* p : arrived(points_))
      t.rows.push_back(
          {p->name, observe::fixed(p->reference.K_m(), 2), metres(p->ours.half_length),
           metres(p->kgd_half_length()), difference(p->ours.half_length, p->kgd_half_length()),
           micrometres(p->opening()), micrometres(p->kgd_opening()),
           difference(p->opening(), p->kgd_opening()), megapascals(p->ours.net_pressure),
           megapascals(p->reference.fracture.net_pressure), observe::fixed(p->length_to_width, 3),
           observe::fixed(p->plate.width, 3), observe::fixed(p->plate.toughness, 3),
           observe::fixed(p->efficiency(), 4), observe::fixed(p->kgd_efficiency(), 4),
           difference(p->efficiency(), p->kgd_efficiency())});
    return t;
  }

  observe::Table toughness_table() const {
    observe::Table t{
        .caption =
            "The toughness of the reference: taken at the mean net pressure over the last "
            "disc before the tip, and what the reference were if it was taken at the mean "
            "pressure of the whole crack.",
        .header = {"crack", "pressure at the tip", "K_{IC}", "K_{m}", "K_{m} by the mean pressure",
                   "length", "opening"}};
    for (const RegimePoint* p : arrived(points_))
      t.rows.push_back({p->name, megapascals(p->reference.toughness_pressure),
                        observe::fixed(p->reference.problem.K_IC / 1e6, 2, "MPa·m^{1/2}"),
                        observe::fixed(p->reference.K_m(), 2),
                        observe::fixed(p->mean_toughness.K_m(), 2),
                        difference(p->mean_toughness.fracture.half_length, p->kgd_half_length()),
                        difference(p->mean_toughness.fracture.width, p->kgd_opening())});
    return t;
  }

  observe::Table run_table() const {
    observe::Table t{.header = {"crack", "time", "least pressure", "lag",
                                "bonds broken off the line", "unconverged fluid steps",
                                "mechanical steps"}};
    for (const RegimePoint* p : arrived(points_))
      t.rows.push_back(
          {p->name, observe::fixed(p->ours.time, 3, "s"), megapascals(p->ours.least_pressure),
           observe::fixed(100 * p->ours.lag, 2, "%"), std::to_string(p->ours.off_plane),
           said(p->ours.unconverged), said(p->ours.mechanical_steps)});
    return t;
  }

  observe::Table rock_table() const {
    observe::Table t{.header = {"array", "E'", "K_{IC} without pressure", "more per net pressure",
                                "opens less by", "mean opening less by"}};
    const auto kinds = config_.rocks();
    for (std::size_t r = 0; r < rocks_.size(); ++r) {
      const auto& rock = rocks_[r];
      t.rows.push_back({rock_name(kinds[r]), observe::fixed(rock.E_prime / 1e9, 2, "GPa"),
                        observe::fixed(rock.K_IC / 1e6, 3, "MPa·m^{1/2}"),
                        observe::fixed(rock.K_IC_per_pressure, 4, "m^{1/2}"),
                        observe::fixed(rock.opening_offset * 1e6, 2, "µm"),
                        observe::fixed(rock.volume_offset * 1e6, 2, "µm")});
    }
    return t;
  }

  const RegimesConfig& config_;
  const std::vector<analytic::LatticeFracture>& rocks_;
  const std::vector<RegimePoint>& points_;
  const Manifest& manifest_;
  double wall_;
};

}  // namespace hfdem::support
