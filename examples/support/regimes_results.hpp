/// @file
/// Everything that a study of regimes writes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

#include "support/output_folder.hpp"
#include "support/regimes_figures.hpp"
#include "support/regimes_points.hpp"
#include "support/regimes_report.hpp"
#include "support/summary.hpp"

namespace hfdem::support {

class RegimesResults {
 public:
  /// What is written, whichever cracks are run.
  static std::vector<std::string> files() {
    std::vector<std::string> all{"report.html", "summary.json", "points.csv", "profiles.csv",
                                 "map.svg"};
    for (const std::string_view name : RegimesConfig::names)
      for (const char* what : {"_opening.svg", "_pressure.svg"})
        all.push_back(std::string(name) + what);
    return all;
  }

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
    folder.write("map.svg", svg(regimes_map(config_, points_)));
    for (const RegimePoint* p : arrived(points_)) {
      folder.write(p->key + "_opening.svg", svg(opening_chart(*p)));
      folder.write(p->key + "_pressure.svg", svg(pressure_chart(*p)));
    }
    folder.write("summary.json", summary().json());
    folder.write("report.html", RegimesReport(config_, rocks_, points_, manifest_, wall_).html());
  }

  /// The table for a terminal.
  std::string text() const {
    std::string text =
        "                            K_m   half-length    KGD            opening     "
        "KGD            "
        "net p   KGD     2a/W   f_w    f_K    efficiency  KGD\n";
    for (const RegimePoint& p : points_) {
      char line[300];
      if (!p.ours.stopped.empty())
        std::snprintf(line, sizeof line, "%-25s stopped: %.180s\n", p.name.c_str(),
                      p.ours.stopped.c_str());
      else
        std::snprintf(line, sizeof line,
                      "%-25s %5.2f   %.3f m       %.3f m %+5.1f %%   %5.1f um  %5.1f um %+5.1f %%  "
                      "%5.2f   %5.2f   %.3f  %.3f  %.3f  %.4f  %.4f %+5.1f %%%s\n",
                      p.name.c_str(), p.reference.K_m(), p.ours.half_length, p.kgd_half_length(),
                      percent(p.ours.half_length, p.kgd_half_length()), p.opening() * 1e6,
                      p.kgd_opening() * 1e6, percent(p.opening(), p.kgd_opening()),
                      p.ours.net_pressure / 1e6, p.reference.fracture.net_pressure / 1e6,
                      p.length_to_width, p.plate.width, p.plate.toughness, p.efficiency(),
                      p.kgd_efficiency(), percent(p.efficiency(), p.kgd_efficiency()),
                      p.holds() ? "" : "  !");
      text += line;
    }
    return text;
  }

 private:
  static double percent(double ours, double reference) { return 100 * (ours / reference - 1); }

  /// Calls `f(name, value)` for every number of a crack, SI.
  template <class F>
  static void for_each_number(const RegimePoint& p, F&& f) {
    f("K_m", p.reference.K_m());
    f("viscosity_Pa_s", p.crack.viscosity);
    f("rate_m2_per_s", p.crack.rate);
    f("time_s", p.ours.time);
    f("leak_off_coefficient", p.crack.leakoff);
    f("tau", analytic::dimensionless_time(p.reference.problem));
    f("efficiency", p.efficiency());
    f("kgd_efficiency", p.kgd_efficiency());
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
    for (const RegimePoint* p : arrived(points_)) {
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
    for (const RegimePoint* p : arrived(points_))
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
      s.set(at + "efficiency_holds", p.efficiency_holds());
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

  const RegimesConfig& config_;
  const std::vector<analytic::LatticeFracture>& rocks_;
  const Manifest& manifest_;
  double wall_;
  std::vector<RegimePoint> points_;
};

}  // namespace hfdem::support
