/// @file
/// Everything that a study of random rock writes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <hfdem/observe/history.hpp>
#include <hfdem/observe/report.hpp>

#include "support/output_folder.hpp"
#include "support/random_toughness_figures.hpp"
#include "support/run_report.hpp"
#include "support/summary.hpp"

namespace hfdem::support {

class RandomToughnessResults {
 public:
  RandomToughnessResults(const RandomToughnessConfig& config, const RandomToughnessStudy& study,
                         const Manifest& manifest, double wall)
      : config_(config),
        study_(study),
        manifest_(manifest),
        wall_(wall),
        rock_(study.rock()),
        growth_(rock_, config.plate_injection()),
        figures_(config, study, rock_, growth_),
        E_prime_(study.mean([](const auto& s) { return s.slits.E_prime; })),
        K_(study.mean([](const auto& s) { return s.above_closing.K; })),
        K_in_situ_(study.mean([](const auto& s) { return s.above_in_situ.K; })) {
    validate(rock_, "rock");
    for (double t = every(); t < std::fmin(growth_.splitting_time(), config.study.end_time);
         t += every())
      compared_.push_back(compare(t));
  }

  /// @throws OutputFailed if a file cannot be written
  void write(const OutputFolder& folder) const {
    folder.write("toughness.toml", to_toml(MeasuredRock{{}, rock_, config_.rock}));
    write_slits(folder);
    write_growth(folder);
    folder.write("pressure.svg", svg(figures_.pressure()));
    folder.write("opening.svg", svg(figures_.opening()));
    folder.write("length.svg", svg(figures_.length()));
    folder.write("summary.json", summary().json());
    folder.write("report.html", report());
  }

  /// The answer in a few lines for a terminal.
  std::string text() const {
    std::string text =
        "seed    E'          closes at    K above in situ    K above closing    run ended\n";
    char line[400];
    for (const SeedResult& s : study_.seeds()) {
      std::snprintf(line, sizeof line,
                    "%-6d  %5.2f GPa   %6.3f MPa   %5.3f MPa sqrt(m)  %5.3f MPa sqrt(m)  %s\n",
                    s.seed, s.slits.E_prime / 1e9, (in_situ() + s.slits.closing_excess) / 1e6,
                    s.above_in_situ.K / 1e6, s.above_closing.K / 1e6, s.ended.c_str());
      text += line;
    }
    text += "E' = " + with_interval(E_prime_, 1e9, 2, "GPa") + "\n";
    text += "K of a running crack = " + with_interval(K_in_situ_, 1e6, 3, "MPa sqrt(m)") +
            " above the in-situ stress,\n                       " +
            with_interval(K_, 1e6, 3, "MPa sqrt(m)") + " above the closing pressure\n";
    text += "predicted growth          runs\n";
    for (const Comparison& c : compared_) {
      std::snprintf(line, sizeof line, "t = %-5.3g s   %.3f m      %s m, of %zu of %zu cracks\n",
                    c.time, c.predicted.full_length, observe::fixed(c.length.mean, 3).c_str(),
                    c.length.samples, study_.seeds().size());
      text += line;
    }
    std::snprintf(line, sizeof line, "the plate splits at %.3f s, from %.3f m\n",
                  growth_.splitting_time(), growth_.splitting_length());
    return text + line;
  }

 private:
  /// The running cracks and the prediction at one time.
  struct Comparison {
    double time;
    GrowthPrediction::Crack predicted;
    measure::SampleMean length, pressure;  ///< of the cracks that run still
  };

  double every() const { return config_.study.compare_every; }
  double in_situ() const { return std::fmin(config_.rock.in_situ.xx, config_.rock.in_situ.yy); }

  Comparison compare(double time) const {
    std::vector<double> lengths, pressures;
    for (const SeedResult& s : study_.seeds()) {
      if (s.crack.empty() || s.crack.back().time < time) continue;
      const auto now = std::find_if(s.crack.begin(), s.crack.end(), [&](const auto& instant) {
        return instant.time > time - 1e-9 * time;
      });
      lengths.push_back(now->full_length());
      pressures.push_back(in_situ() + now->net_pressure);
    }
    return {time, *growth_.at(time), measure::SampleMean::of(lengths),
            measure::SampleMean::of(pressures)};
  }

  static std::string with_interval(const measure::SampleMean& m, double unit, int decimals,
                                   const char* name) {
    char text[160];
    if (m.samples < 2)
      std::snprintf(text, sizeof text, "%.*f %s (one seed: no interval)", decimals, m.mean / unit,
                    name);
    else
      std::snprintf(text, sizeof text,
                    "%.*f +- %.*f %s (95 %% interval of the mean; one rock deviates by %.*f)",
                    decimals, m.mean / unit, decimals, m.ci95 / unit, name, decimals,
                    m.deviation / unit);
    return text;
  }

  void write_slits(const OutputFolder& folder) const {
    std::ofstream file = folder.open("slits.csv");
    file << "seed,contacts,full_length_m,net_pressure_Pa,opening_m,volume_m2\n";
    for (const SeedResult& s : study_.seeds())
      for (const auto& reading : s.slits.readings)
        for (const measure::SlitState& state : reading.slit.states)
          observe::write_row(
              file,
              {static_cast<double>(s.seed), static_cast<double>(reading.slit.contacts),
               2 * reading.slit.half_length, state.net_pressure, state.opening, state.volume});
    folder.close(file, "slits.csv");
  }

  void write_growth(const OutputFolder& folder) const {
    std::ofstream file = folder.open("growth.csv");
    file << "seed,time_s,full_length_m,tip_up_m,tip_down_m,net_pressure_Pa,crack_volume_m2\n";
    for (const SeedResult& s : study_.seeds())
      for (const measure::CrackInstant& c : s.crack)
        observe::write_row(file, {static_cast<double>(s.seed), c.time, c.full_length(), c.tip_up,
                                  c.tip_down, c.net_pressure, c.volume});
    folder.close(file, "growth.csv");
  }

  static void set(Summary& s, const std::string& name, const measure::SampleMean& m,
                  const std::string& unit) {
    const std::string in = unit.empty() ? "" : "_" + unit;
    s.set(name + "/mean" + in, m.mean);
    s.set(name + "/standard_deviation" + in, m.deviation);
    s.set(name + "/interval_95" + in, m.ci95);
    s.set(name + "/seeds", static_cast<long>(m.samples));
  }

  Summary summary() const {
    Summary s;
    set(s, "E_prime", E_prime_, "Pa");
    set(s, "E_prime_from_opening",
        study_.mean([](const auto& r) { return r.slits.E_prime_from_opening; }), "Pa");
    set(s, "K_IC", K_, "Pa_sqrt_m");
    set(s, "K_IC_above_in_situ", K_in_situ_, "Pa_sqrt_m");
    set(s, "closing_excess", closing(), "Pa");
    set(s, "E", young(), "Pa");
    set(s, "poisson_ratio", study_.mean([](const auto& r) { return r.moduli.poisson; }), "");
    for (std::size_t k = 0; k < study_.seeds().size(); ++k) {
      const SeedResult& r = study_.seeds()[k];
      const std::string at = "seeds/" + std::to_string(k) + "/";
      s.set(at + "seed", r.seed);
      s.set(at + "discs", static_cast<long>(r.discs));
      s.set(at + "E_Pa", r.moduli.young);
      s.set(at + "poisson_ratio", r.moduli.poisson);
      s.set(at + "E_prime_Pa", r.slits.E_prime);
      s.set(at + "E_prime_from_opening_Pa", r.slits.E_prime_from_opening);
      s.set(at + "E_prime_spread", r.slits.E_prime_spread);
      s.set(at + "closing_excess_Pa", r.slits.closing_excess);
      s.set(at + "K_IC_Pa_sqrt_m", r.above_closing.K);
      s.set(at + "K_IC_above_in_situ_Pa_sqrt_m", r.above_in_situ.K);
      s.set(at + "K_deviation_of_steps_Pa_sqrt_m", r.above_in_situ.deviation);
      s.set(at + "running_steps", static_cast<long>(r.above_in_situ.steps));
      s.set(at + "end_time_s", r.crack.back().time);
      s.set(at + "ended", r.ended);
      s.set(at + "unconverged_fluid_steps", r.unconverged);
      s.set(at + "mechanical_steps", r.mechanical_steps);
    }
    for (std::size_t k = 0; k < compared_.size(); ++k) {
      const Comparison& c = compared_[k];
      const std::string at = "growth/" + std::to_string(k) + "/";
      s.set(at + "time_s", c.time);
      s.set(at + "predicted_full_length_m", c.predicted.full_length);
      s.set(at + "predicted_opening_m", c.predicted.opening);
      s.set(at + "predicted_pressure_Pa", c.predicted.pressure);
      set(s, at + "full_length", c.length, "m");
      set(s, at + "pressure", c.pressure, "Pa");
    }
    s.set("splitting/time_s", growth_.splitting_time());
    s.set("splitting/full_length_m", growth_.splitting_length());
    s.set("wall_s", wall_);
    s.set("threads", manifest_.threads);
    return s;
  }

  measure::SampleMean young() const {
    return study_.mean([](const auto& r) { return r.moduli.young; });
  }
  measure::SampleMean closing() const {
    return study_.mean([](const auto& r) { return r.slits.closing_excess; });
  }

  static std::string said(const measure::SampleMean& m, double unit, int decimals,
                          const char* name) {
    using observe::fixed;
    const std::string mean = fixed(m.mean / unit, decimals);
    return m.samples < 2 ? fixed(m.mean / unit, decimals, name)
                         : mean + " ± " + fixed(m.ci95 / unit, decimals, name);
  }

  std::string report() const {
    using observe::fixed;
    constexpr auto K_unit = "MPa·m^{1/2}";
    observe::Report page;
    page.title = "Toughness and modulus of random rock";
    page.program = "hfdem " + manifest_.version + ", program " + manifest_.program;
    page.lead = "Slits held open, and cracks that run: " + figures_.conditions();
    page.numbers({{"modulus E'", said(E_prime_, 1e9, 2, "GPa"),
                   "in compression " + said(young(), 1e9, 2, "GPa")},
                  {"K_{IC}, above the in-situ stress", said(K_in_situ_, 1e6, 2, K_unit)},
                  {"K_{IC}, above the closing pressure", said(K_, 1e6, 2, K_unit),
                   "which is " + fixed((in_situ() + rock_.closing_excess) / 1e6, 2, "MPa")}});
    page.text("± is the 95 % interval of the mean over the seeds.");
    page.figure(figures_.pressure());
    page.section("Why a running crack");
    page.text(
        "Where a slit is cut, its tips lie at bonds that chance has chosen, and the first of them "
        "breaks early: that pressure is no toughness. A crack that runs meets weak places and "
        "strong ones. Its toughness here is the mean of K over the fluid steps whose length is " +
        fixed(config_.running.from, 2) + " to " + fixed(config_.running.to, 2) +
        " of the width: K = net pressure × F_{K} × (πa)^{1/2}, with half the tip distance for a "
        "and the factor F_{K} of a central crack in the finite plate.");
    page.text(
        "A slit along contacts is rough, and closes before the pressure has come down to the "
        "in-situ stress: so say the straight lines through its volumes. What drives the growth is "
        "the pressure above that.");
    page.section("Growth in the finite plate");
    page.figure(figures_.length());
    page.table(growth_table());
    page.text("By the prediction a crack of " + fixed(growth_.splitting_length(), 2, "m") +
              " splits the plate, at " + fixed(growth_.splitting_time(), 2, "s") + ".");
    page.section("The slits");
    page.figure(figures_.opening());
    page.section("The seeds");
    page.table(seed_table());
    page.facts({{"E' from the openings near the middle",
                 said(study_.mean([](const auto& s) { return s.slits.E_prime_from_opening; }), 1e9,
                      2, "GPa")},
                {"Young's modulus in compression", said(young(), 1e9, 2, "GPa")},
                {"Poisson's ratio", fixed(rock_.poisson_ratio, 3)},
                {"closing pressure above the in-situ stress", said(closing(), 1e6, 2, "MPa")},
                {"wall time", fixed(wall_, 1, "s")}});
    add_parameters(page, config_, RandomToughnessConfig{});
    page.section("Files");
    page.files({{"toughness.toml", "the result, for programs that predict a run"},
                {"slits.csv", "opening and volume of each slit at each pressure"},
                {"growth.csv", "tips, pressure and volume of each crack after each fluid step"},
                {"summary.json", "the answer in numbers"},
                {"config.toml", "every parameter; repeats the tests with --rock random --config"},
                {"pressure.svg", "the first figure above, for other documents"},
                {"length.svg", "growth of the cracks and its prediction"},
                {"opening.svg", "opening of the slits against pressure"}});
    add_manifest(page, manifest_);
    return page.html();
  }

  observe::Table growth_table() const {
    using observe::fixed;
    observe::Table table{.header = {"time", "predicted length", "length of the cracks",
                                    "predicted pressure", "pressure of the cracks", "cracks"}};
    for (const Comparison& c : compared_)
      table.rows.push_back({fixed(c.time, 2, "s"), fixed(c.predicted.full_length, 3, "m"),
                            c.length.samples > 0 ? said(c.length, 1, 3, "m") : "–",
                            fixed(c.predicted.pressure / 1e6, 2, "MPa"),
                            c.pressure.samples > 0 ? said(c.pressure, 1e6, 2, "MPa") : "–",
                            std::to_string(c.length.samples)});
    return table;
  }

  observe::Table seed_table() const {
    using observe::fixed;
    observe::Table table{.header = {"seed", "discs", "E'", "closes at", "K above in situ",
                                    "K above closing", "run ended"}};
    for (const SeedResult& s : study_.seeds())
      table.rows.push_back({std::to_string(s.seed), std::to_string(s.discs),
                            fixed(s.slits.E_prime / 1e9, 2, "GPa"),
                            fixed((in_situ() + s.slits.closing_excess) / 1e6, 2, "MPa"),
                            fixed(s.above_in_situ.K / 1e6, 3, "MPa·m^{1/2}"),
                            fixed(s.above_closing.K / 1e6, 3, "MPa·m^{1/2}"), s.ended});
    return table;
  }

  const RandomToughnessConfig& config_;
  const RandomToughnessStudy& study_;
  const Manifest& manifest_;
  double wall_;
  analytic::RockFracture rock_;
  GrowthPrediction growth_;
  RandomToughnessFigures figures_;
  measure::SampleMean E_prime_, K_, K_in_situ_;
  std::vector<Comparison> compared_{};
};

}  // namespace hfdem::support
