/// @file
/// Everything that a study of regimes writes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/regime_map.hpp>
#include <hfdem/observe/report.hpp>

#include "support/output_folder.hpp"
#include "support/regimes_points.hpp"
#include "support/summary.hpp"

namespace hfdem::support {

class RegimesResults {
 public:
  static constexpr std::initializer_list<const char*> files{"report.html",
                                                            "summary.json",
                                                            "points.csv",
                                                            "profiles.csv",
                                                            "map.svg",
                                                            "toughness_vertex_opening.svg",
                                                            "toughness_vertex_pressure.svg",
                                                            "toughness_edge_opening.svg",
                                                            "toughness_edge_pressure.svg",
                                                            "middle_opening.svg",
                                                            "middle_pressure.svg",
                                                            "viscosity_edge_opening.svg",
                                                            "viscosity_edge_pressure.svg",
                                                            "viscosity_vertex_opening.svg",
                                                            "viscosity_vertex_pressure.svg"};

  /// @param rocks as their slits say, in the order of `config.rocks()`
  /// @param cracks that were run, in their order
  RegimesResults(const RegimesConfig& config, const std::vector<analytic::LatticeFracture>& rocks,
                 const std::vector<CrackReading>& cracks, const Manifest& manifest, double wall)
      : config_(config), rocks_(rocks), manifest_(manifest), wall_(wall) {
    const auto kinds = config.rocks();
    for (std::size_t k = 0; k < cracks.size(); ++k) {
      const auto kind = std::find(kinds.begin(), kinds.end(), config.cracks[k].rock);
      const auto number = static_cast<std::size_t>(kind - kinds.begin());
      points_.push_back(regime_point(config, k, rocks[number], cracks[k]));
    }
  }

  /// Whether every run came to its end.
  bool complete() const {
    return std::ranges::all_of(points_, [](const auto& p) { return p.ours.stopped.empty(); });
  }

  /// @throws OutputFailed if a file cannot be written
  void write(const OutputFolder& folder) const {
    folder.write("points.csv", points_csv());
    folder.write("profiles.csv", profiles_csv());
    folder.write("map.svg", svg(map()));
    for (const RegimePoint* p : run()) {
      folder.write(p->key + "_opening.svg", svg(opening_chart(*p)));
      folder.write(p->key + "_pressure.svg", svg(pressure_chart(*p)));
    }
    folder.write("summary.json", summary().json());
    folder.write("report.html", report());
  }

  /// The table for a terminal.
  std::string text() const {
    std::string text =
        "                    K_m   half-length    KGD            opening     KGD            "
        "net p   KGD     2a/W   f_w    f_K\n";
    for (const RegimePoint& p : points_) {
      char line[240];
      if (!p.ours.stopped.empty())
        std::snprintf(line, sizeof line, "%-17s stopped: %.180s\n", p.name.c_str(),
                      p.ours.stopped.c_str());
      else
        std::snprintf(line, sizeof line,
                      "%-17s %5.2f   %.3f m       %.3f m %+5.1f %%   %5.1f um  %5.1f um %+5.1f %%  "
                      "%5.2f   %5.2f   %.3f  %.3f  %.3f%s\n",
                      p.name.c_str(), p.reference.K_m(), p.ours.half_length, p.kgd_half_length(),
                      percent(p.ours.half_length, p.kgd_half_length()), p.opening() * 1e6,
                      p.kgd_opening() * 1e6, percent(p.opening(), p.kgd_opening()),
                      p.ours.net_pressure / 1e6, p.reference.fracture.net_pressure / 1e6,
                      p.length_to_width, p.plate.width, p.plate.toughness, p.holds() ? "" : "  !");
      text += line;
    }
    return text;
  }

 private:
  static double percent(double ours, double reference) { return 100 * (ours / reference - 1); }

  /// The cracks that came to their end.
  std::vector<const RegimePoint*> run() const {
    std::vector<const RegimePoint*> all;
    for (const RegimePoint& p : points_)
      if (p.ours.stopped.empty()) all.push_back(&p);
    return all;
  }

  // ---- numbers ----------------------------------------------------------------------------------

  /// Calls `f(name, value)` for every number of a crack, SI.
  template <class F>
  static void for_each_number(const RegimePoint& p, F&& f) {
    f("K_m", p.reference.K_m());
    f("viscosity_Pa_s", p.crack.viscosity);
    f("rate_m2_per_s", p.crack.rate);
    f("time_s", p.ours.time);
    f("discs_per_side", double(p.crack.discs));
    f("half_length_m", p.ours.half_length);
    f("kgd_half_length_m", p.kgd_half_length());
    f("opening_m", p.ours.opening);
    f("opening_offset_m", p.rock.opening_offset);
    f("kgd_opening_m", p.kgd_opening());
    f("net_pressure_Pa", p.ours.net_pressure);
    f("kgd_net_pressure_Pa", p.reference.fracture.net_pressure);
    f("E_prime_Pa", p.rock.E_prime);
    f("K_IC_Pa_sqrt_m", p.reference.problem.K_IC);
    f("tip_pressure_Pa", p.reference.toughness_pressure);
    f("length_to_width", p.length_to_width);
    f("plate_width_factor", p.plate.width);
    f("plate_toughness_factor", p.plate.toughness);
    f("least_pressure_Pa", p.ours.least_pressure);
    f("fluid_lag", p.ours.lag);
    f("breaks_off_plane", double(p.ours.off_plane));
    f("unconverged_fluid_steps", double(p.ours.unconverged));
    f("mechanical_steps", double(p.ours.mechanical_steps));
    f("mean_pressure_toughness/K_m", p.mean_toughness.K_m());
    f("mean_pressure_toughness/half_length_m", p.mean_toughness.fracture.half_length);
    f("mean_pressure_toughness/opening_m", p.mean_toughness.fracture.width);
  }

  std::string points_csv() const {
    std::string text;
    for (const RegimePoint* p : run()) {
      std::string header = "crack", row = p->key;
      for_each_number(*p, [&](const std::string& name, double value) {
        header += ',' + name;
        row += ',' + to_text(value);
      });
      if (text.empty()) text = header + '\n';
      text += row + '\n';
    }
    return text;
  }

  std::string profiles_csv() const {
    std::string text =
        "crack,along_m,opening_m,net_pressure_Pa,kgd_opening_m,kgd_net_pressure_Pa\n";
    for (const RegimePoint* p : run())
      for (const MeanPoint& m : p->ours.profile) {
        const double beyond = p->reference.fracture.net_pressure_at(m.along);
        text +=
            p->key + ',' + to_text(m.along) + ',' + to_text(m.opening) + ',' +
            to_text(m.net_pressure) + ',' +
            to_text(m.along < p->kgd_half_length() ? p->reference.fracture.width_at(m.along) : 0) +
            ',' + (std::isfinite(beyond) ? to_text(beyond) : "") + '\n';
      }
    return text;
  }

  Summary summary() const {
    Summary s;
    for (const RegimePoint& p : points_) {
      const std::string at = "cracks/" + p.key + "/";
      s.set(at + "stopped", p.ours.stopped);
      if (!p.ours.stopped.empty()) continue;
      for_each_number(p, [&](const std::string& name, double value) { s.set(at + name, value); });
      s.compare(at + "half_length", p.ours.half_length, p.kgd_half_length());
      s.compare(at + "opening", p.opening(), p.kgd_opening());
      s.compare(at + "net_pressure", p.ours.net_pressure, p.reference.fracture.net_pressure);
      s.set(at + "length_holds", p.length_holds());
      s.set(at + "opening_holds", p.opening_holds());
    }
    const auto kinds = config_.rocks();
    for (std::size_t r = 0; r < rocks_.size(); ++r) {
      const std::string at = "rocks/" + rock_name(kinds[r]) + "/";
      for_each_field<analytic::LatticeFracture>([&](const auto& field) {
        s.set(at + std::string(field.name), rocks_[r].*(field.member));
      });
    }
    s.set("wall_s", wall_);
    s.set("threads", manifest_.threads);
    return s;
  }

  static std::string rock_name(RockKind kind) {
    return std::string(names_of<RockKind>[static_cast<std::size_t>(kind)]);
  }

  // ---- pictures ---------------------------------------------------------------------------------

  static std::string verdict(const RegimePoint& p) {
    return "length " + difference(p.ours.half_length, p.kgd_half_length()) + ", opening " +
           difference(p.opening(), p.kgd_opening());
  }

  observe::RegimeMap map() const {
    observe::RegimeMap map{
        .title = "From toughness to viscosity",
        .caption =
            "Each ring is a crack through an array of discs. Below its name stands how far "
            "its length and its opening at the injection are from the general solution for "
            "the modulus and the toughness of slits.",
        .conditions = conditions()};
    for (const RegimePoint* p : run())
      map.points.push_back({p->name, p->reference.problem, verdict(*p)});
    return map;
  }

  std::string conditions() const {
    const RegimeRock& p = config_.tough;
    return "Square arrays of discs of radius 5 mm, no leak-off; contacts of " +
           in_words(p.tensile_strength / 1e6) + " MPa under " + in_words(p.across / 1e6) +
           " MPa, and of " + in_words(config_.weak.tensile_strength / 1e6) + " MPa under " +
           in_words(config_.weak.across / 1e6) + " MPa.";
  }

  static std::string said_crack(const RegimePoint& p) {
    return in_words(p.crack.viscosity * 1e3) + " cp, " + in_words(p.crack.rate * 1e4) +
           " × 10^{-4} m²/s, " + in_words(p.crack.time) + " s; " + std::to_string(p.crack.discs) +
           " x " + std::to_string(p.crack.discs) + " discs; K_{m} " +
           observe::fixed(p.reference.K_m(), 2) + ".";
  }

  /// Ours and KGD's along one wing.
  template <class Ours, class Kgd>
  static observe::Chart profile_chart(const RegimePoint& p, const std::string& title,
                                      const std::string& unit, Ours&& ours, Kgd&& kgd) {
    observe::Chart chart{.title = title + ": " + p.name,
                         .x_label = "distance from the injection (m)",
                         .y_label = unit,
                         .caption =
                             "Means over the window of time; where the crack was broken all "
                             "that time.",
                         .conditions = said_crack(p)};
    observe::Series lattice{.name = "discs", .style = observe::Series::Style::markers};
    for (const MeanPoint& m : p.ours.profile)
      lattice.x.push_back(m.along), lattice.y.push_back(ours(m));
    observe::Series general{.name = "KGD", .colour = observe::okabe_ito::black};
    constexpr int points = 200;
    for (int k = 0; k <= points; ++k) {
      const double part = 1 - static_cast<double>(k) / points;
      const double x = p.kgd_half_length() * (1 - part * part);
      if (const double y = kgd(x); std::isfinite(y)) general.x.push_back(x), general.y.push_back(y);
    }
    chart.series = {general, lattice};
    return chart;
  }

  static observe::Chart opening_chart(const RegimePoint& p) {
    return profile_chart(
        p, "Opening", "opening (µm)",
        [&](const MeanPoint& m) { return (m.opening + p.rock.opening_offset) * 1e6; },
        [&](double x) { return p.reference.fracture.width_at(x) * 1e6; });
  }

  static observe::Chart pressure_chart(const RegimePoint& p) {
    double least = 0;
    for (const MeanPoint& m : p.ours.profile) least = std::fmin(least, m.net_pressure);
    return profile_chart(
        p, "Net pressure", "net pressure (MPa)",
        [&](const MeanPoint& m) { return m.net_pressure / 1e6; },
        [&](double x) {
          const double pressure = p.reference.fracture.net_pressure_at(x);
          return pressure < 1.2 * least - 1e6 ? NAN : pressure / 1e6;
        });
  }

  // ---- the page ---------------------------------------------------------------------------------

  observe::Table table() const {
    observe::Table t{
        .caption =
            "Means over the window of time. The opening is w - w_{0} plus the offset of the "
            "slits. f_{w} and f_{K} are what the finite plate does to opening and stress "
            "intensity.",
        .header = {"crack", "K_{m}", "half-length", "KGD", "", "opening", "KGD", "", "net pressure",
                   "KGD", "2a/W", "f_{w}", "f_{K}"}};
    for (const RegimePoint* p : run())
      t.rows.push_back(
          {p->name, observe::fixed(p->reference.K_m(), 2), metres(p->ours.half_length),
           metres(p->kgd_half_length()), difference(p->ours.half_length, p->kgd_half_length()),
           micrometres(p->opening()), micrometres(p->kgd_opening()),
           difference(p->opening(), p->kgd_opening()), megapascals(p->ours.net_pressure),
           megapascals(p->reference.fracture.net_pressure), observe::fixed(p->length_to_width, 3),
           observe::fixed(p->plate.width, 3), observe::fixed(p->plate.toughness, 3)});
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
    for (const RegimePoint* p : run())
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
    for (const RegimePoint* p : run())
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

  std::string report() const {
    observe::Report page;
    page.title = "From toughness to viscosity";
    page.lead =
        "Fluids of several viscosities drive cracks through square arrays of bonded discs, "
        "beside the KGD fracture without any fit. " +
        conditions();
    page.program = "hfdem " + manifest_.version + ", program " + manifest_.program;
    for (const RegimePoint& p : points_)
      if (!p.ours.stopped.empty()) page.stopped += p.name + ": " + p.ours.stopped + ". ";
    const auto good = std::ranges::count_if(points_, [](const auto& p) { return p.holds(); });
    page.text(std::to_string(good) + " of " + std::to_string(points_.size()) +
              " cracks have a half-length within a disc or 5 % of the reference, an opening "
              "within 8 %.");
    page.figure(map());
    page.table(table());
    page.section("Along the cracks");
    const auto cracks = run();
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
    for (const RegimePoint* p : run()) {
      written.push_back({p->key + "_opening.svg", "the opening of the " + p->name});
      written.push_back({p->key + "_pressure.svg", "its pressure"});
    }
    page.files(written);
    add_manifest(page, manifest_);
    return page.html();
  }

  const RegimesConfig& config_;
  const std::vector<analytic::LatticeFracture>& rocks_;
  const Manifest& manifest_;
  double wall_;
  std::vector<RegimePoint> points_;
};

}  // namespace hfdem::support
