/// @file
/// Everything that rock tests write.
#pragma once

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

#include <hfdem/observe/history.hpp>
#include <hfdem/observe/report.hpp>

#include "support/output_folder.hpp"
#include "support/rock_tests_figures.hpp"
#include "support/run_report.hpp"
#include "support/summary.hpp"

namespace hfdem::support {

class RockTestsResults {
 public:
  /// What a run writes at its end.
  static constexpr std::initializer_list<const char*> files{
      "report.html", "summary.json",    "seeds.csv",   "curves.csv",  "breaks.csv",
      "cracks.svg",  "compression.svg", "tension.svg", "envelope.svg"};

  /// @param specimens one or more, all tests made
  RockTestsResults(const RockTestsConfig& config, const std::vector<SpecimenTests>& specimens,
                   const Manifest& manifest, double wall)
      : config_(config),
        specimens_(specimens),
        properties_(properties(specimens)),
        manifest_(manifest),
        wall_(wall) {}

  /// @throws OutputFailed if a file cannot be written
  void write(const OutputFolder& folder) const {
    write_seeds(folder);
    write_tests(folder);
    const RockTestsFigures figures(config_, specimens_);
    folder.write("compression.svg", svg(figures.compression()));
    folder.write("tension.svg", svg(figures.tension()));
    folder.write("envelope.svg", svg(figures.envelope()));
    folder.write("cracks.svg", svg(figures.cracks()));
    folder.write("summary.json", summary().json());
    folder.write("report.html", report(figures));
  }

  /// The answer in a few lines for a terminal.
  std::string text() const {
    std::string text = "                                     mean   95 % +-      paper\n";
    for (const RockProperty& p : properties_) {
      const measure::SampleMean m = p.mean();
      const double factor = scale(p);
      char line[120];
      std::snprintf(line, sizeof line, "%-32s %8.3f  %8s  %9s %s\n", p.name.c_str(),
                    m.mean / factor, plain_number(m.ci95 / factor, 3).c_str(),
                    plain_number(p.paper / factor, 2).c_str(),
                    said(p.mean().mean, p.unit).unit == "°" ? "deg" : unit(p).c_str());
      text += line;
    }
    return text + "from " + std::to_string(specimens_.size()) + " specimens\n";
  }

 private:
  // ---- numbers ----------------------------------------------------------------------------------

  static std::string unit(const RockProperty& p) { return said(p.mean().mean, p.unit).unit; }
  /// Of the unit that the numbers are said in.
  static double scale(const RockProperty& p) {
    const std::string said_unit = unit(p);
    return said_unit == "GPa" ? 1e9 : said_unit == "MPa" ? 1e6 : 1;
  }
  static std::string plain_number(double value, int decimals) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return std::isfinite(value) ? text : "-";
  }

  Summary summary() const {
    Summary s;
    s.set("specimens", static_cast<long>(specimens_.size()));
    for (const RockProperty& p : properties_) {
      s.set(p.key, p.mean().mean);
      s.set(p.key + "_ci95", p.mean().ci95);
    }
    s.set("paper/holds_for",
          "the default micro-parameters; the size of its specimens is not given");
    for (const RockProperty& p : properties_)
      if (std::isfinite(p.paper)) s.compare("paper/" + p.key, p.mean().mean, p.paper);
    long steps = 0;
    for (std::size_t k = 0; k < specimens_.size(); ++k) {
      const std::string at = "seeds/" + std::to_string(k) + "/";
      s.set(at + "seed", specimens_[k].seed);
      for (const RockProperty& p : properties_) s.set(at + p.key, p.values[k]);
      for_each_test(specimens_[k], [&](const auto&, const auto& test) { steps += test.steps; });
    }
    s.set("mechanical_steps", steps);
    s.set("wall_s", wall_);
    s.set("threads", manifest_.threads);
    return s;
  }

  /// Calls `f(name, test)` for every test of a specimen.
  template <class F>
  static void for_each_test(const SpecimenTests& s, F&& f) {
    for (const measure::RockTest& t : s.compression) f(std::string("compression"), t);
    f(std::string("tension"), s.tension);
    f(std::string("brazilian"), s.brazilian);
  }

  // ---- tables -----------------------------------------------------------------------------------

  void write_seeds(const OutputFolder& folder) const {
    std::ofstream file = folder.open("seeds.csv");
    file << "seed";
    for (const RockProperty& p : properties_) file << ',' << p.key;
    for (const auto& t : specimens_.front().compression)
      file << ",strength_at_" << to_text(t.confinement) << "_Pa";
    file << '\n';
    for (std::size_t k = 0; k < specimens_.size(); ++k) {
      file << specimens_[k].seed;
      for (const RockProperty& p : properties_) file << ',' << to_text(p.values[k]);
      for (const auto& t : specimens_[k].compression) file << ',' << to_text(t.strength);
      file << '\n';
    }
    folder.close(file, "seeds.csv");
  }

  void write_tests(const OutputFolder& folder) const {
    std::ofstream curves = folder.open("curves.csv"), breaks = folder.open("breaks.csv");
    curves << "seed,test,confinement_Pa,strain,stress_Pa,grain_strain_x,grain_strain_y\n";
    breaks << "seed,test,confinement_Pa,strain,x_m,y_m,length_m,mode\n";
    for (const SpecimenTests& s : specimens_)
      for_each_test(s, [&](const std::string& name, const measure::RockTest& test) {
        const std::string start =
            std::to_string(s.seed) + ',' + name + ',' + to_text(test.confinement) + ',';
        for (const auto& r : test.curve) {
          curves << start;
          observe::write_row(curves, {r.strain, r.stress, r.shortening.x, r.shortening.y});
        }
        for (const auto& b : test.breaks) {
          const auto [first, second] = b.contact.bodies;
          const auto& radius = test.specimen.radius;
          const auto& f = b.contact.frame;
          const Vec2 at = test.specimen.centre[first] +
                          (f.arm_mean - f.arm_half_difference) * Vec2{f.normal_x, f.normal_y};
          char row[120];
          std::snprintf(row, sizeof row, "%.10g,%.10g,%.10g,%.10g,", b.strain, at.x, at.y,
                        2 * std::fmin(radius[first], radius[second]));
          breaks << start << row << observe::name(b.mode) << '\n';
        }
      });
    folder.close(curves, "curves.csv");
    folder.close(breaks, "breaks.csv");
  }

  // ---- report -----------------------------------------------------------------------------------

  static std::string words(const RockProperty& p, double value) {
    const int decimals = p.unit == "Pa" ? (scale(p) == 1e9 ? 1 : 2) : p.unit == "deg" ? 1 : 3;
    return observe::fixed(value / scale(p), decimals, unit(p));
  }

  observe::KeyNumber key_number(std::size_t k) const {
    const RockProperty& p = properties_[k];
    const double ci95 = p.mean().ci95;
    return {
        p.name, words(p, p.mean().mean),
        (std::isfinite(ci95) ? "± " + words(p, ci95) + "\n" : "") + "paper " + words(p, p.paper)};
  }

  observe::Table comparison() const {
    observe::Table table{.header = {"", "mean", "95 % interval", "paper", "difference"}};
    for (const RockProperty& p : properties_)
      table.rows.push_back({p.name, words(p, p.mean().mean), "± " + words(p, p.mean().ci95),
                            words(p, p.paper), difference(p.mean().mean, p.paper)});
    return table;
  }

  observe::Table each_specimen() const {
    observe::Table table{.header = {"seed"}};
    for (const RockProperty& p : properties_) table.header.push_back(p.name);
    for (std::size_t k = 0; k < specimens_.size(); ++k) {
      table.rows.push_back({std::to_string(specimens_[k].seed)});
      for (const RockProperty& p : properties_) table.rows.back().push_back(words(p, p.values[k]));
    }
    return table;
  }

  std::string report(const RockTestsFigures& figures) const {
    observe::Report page;
    page.title = "The rock that these micro-parameters make";
    page.program = "hfdem " + manifest_.version + ", program " + manifest_.program;
    page.lead = "Compression, direct tension and the Brazilian test. " +
                described(config_, specimens_.size());
    page.numbers({key_number(0), key_number(2), key_number(3), key_number(4)});
    page.figure(figures.cracks());
    page.section("Comparison");
    page.table(comparison());
    page.text(
        "Means over the specimens; the interval is that of Student's t, and there is none for a "
        "single specimen. The paper's values are those of its Table 2, for the default "
        "micro-parameters; how large its specimens were, and how the envelope was fitted, it does "
        "not say.");
    page.section("Curves");
    page.figure(figures.compression());
    page.figure(figures.tension());
    page.figure(figures.envelope());
    page.section("How the numbers were found");
    page.text(
        "Young's modulus and Poisson's ratio are slopes between 10 and 40 % of the unconfined "
        "strength, with strains of the grains, not of the platens; raw values of the plane "
        "assembly, without a conversion from plane strain. A strength is the largest stress at the "
        "ends. Friction angle and cohesion are those of the straight line σ_{1} = q + K σ_{3} "
        "through all compressive tests of a specimen, the unconfined one included, by least "
        "squares: sin φ = (K − 1) / (K + 1), c = q / (2 K^{1/2}). Envelopes are curved, so both "
        "depend on the confinements.");
    page.text(
        "The Brazilian strength is the tension in the middle of an isotropic elastic plate under "
        "the same load on its two arcs (Hondros 1959); as grains carry less in tension than in "
        "compression, the assembly is not quite that plate.");
    page.section("Each specimen");
    page.table(each_specimen());
    page.facts({{"wall time", observe::fixed(wall_, 1, "s")}});
    add_parameters(page, config_, RockTestsConfig{});
    page.section("Files");
    page.files({{"summary.json", "the answer in numbers, with the paper's beside them"},
                {"seeds.csv", "the numbers of each specimen, and its strengths"},
                {"curves.csv", "strain and stress of every test"},
                {"breaks.csv", "strain, place, length and mode of every bond that broke"},
                {"config.toml", "every parameter; repeats the tests with --config"},
                {"cracks.svg", "the first figure above, for other documents"},
                {"compression.svg", "stress and strain in compression"},
                {"tension.svg", "stress and strain in tension"},
                {"envelope.svg", "strength against confinement"}});
    add_manifest(page, manifest_);
    return page.html();
  }

  const RockTestsConfig& config_;
  const std::vector<SpecimenTests>& specimens_;
  std::vector<RockProperty> properties_;
  const Manifest& manifest_;
  double wall_;
};

}  // namespace hfdem::support
