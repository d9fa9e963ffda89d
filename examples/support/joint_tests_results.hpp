/// @file
/// Everything that tests of joints write.
#pragma once

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <string>
#include <vector>

#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/history.hpp>
#include <hfdem/observe/report.hpp>

#include "support/joint_tests_model.hpp"
#include "support/output_folder.hpp"
#include "support/run_report.hpp"
#include "support/summary.hpp"

namespace hfdem::support {

class JointTestsResults {
 public:
  /// What a run writes at its end.
  static constexpr std::initializer_list<const char*> files{
      "report.html", "summary.json", "tests.csv", "curves.csv", "strength.svg", "slip.svg"};

  JointTestsResults(const JointTestsConfig& config, const std::vector<JointTestResult>& tests,
                    const Manifest& manifest)
      : config_(config), tests_(tests), manifest_(manifest) {}

  /// @throws OutputFailed if a file cannot be written
  void write(const OutputFolder& folder) const {
    std::ofstream table = folder.open("tests.csv"), curves = folder.open("curves.csv");
    table << "angle_deg,confinement_Pa,seed,peak_Pa,peak_over_coulomb,residual_Pa,"
             "residual_over_coulomb,normal_stiffness_Pa_per_m,shear_stiffness_Pa_per_m\n";
    curves << "angle_deg,confinement_Pa,seed,strain,stress_Pa,closure_m,shear_m\n";
    for (const JointTestResult& t : tests_) {
      observe::write_row(
          table,
          {t.angle, t.confinement, double(t.seed), t.peak, t.peak / t.coulomb_peak, t.residual,
           t.residual / t.coulomb_residual, t.normal_stiffness, t.shear_stiffness});
      for (const auto& r : t.readings)
        observe::write_row(curves, {t.angle, t.confinement, double(t.seed), r.strain, r.stress,
                                    r.closure, r.shear});
    }
    folder.close(table, "tests.csv");
    folder.close(curves, "curves.csv");
    folder.write("strength.svg", svg(strength()));
    folder.write("slip.svg", svg(slip()));
    folder.write("summary.json", summary().json());
    folder.write("report.html", report());
  }

  /// The answer in a few lines for a terminal.
  std::string text() const {
    std::string lines =
        "angle  confinement  seed   peak/Coulomb  residual/Coulomb   k_n        k_s (GPa/m)\n";
    for (const JointTestResult& t : tests_) {
      char line[120];
      std::snprintf(
          line, sizeof line, "%4.0f   %5.1f MPa   %6d   %8.3f      %8.3f      %8.2f   %8.2f\n",
          t.angle, t.confinement / 1e6, t.seed, t.peak / t.coulomb_peak,
          t.residual / t.coulomb_residual, t.normal_stiffness / 1e9, t.shear_stiffness / 1e9);
      lines += line;
    }
    return lines;
  }

 private:
  /// The largest distance from 1 of a ratio, over all tests.
  template <class F>
  double worst(F&& ratio) const {
    double most = 0;
    for (const JointTestResult& t : tests_) most = std::fmax(most, std::abs(ratio(t) - 1));
    return most;
  }
  double worst_peak() const {
    return worst([](const auto& t) { return t.peak / t.coulomb_peak; });
  }
  double worst_residual() const {
    return worst([](const auto& t) { return t.residual / t.coulomb_residual; });
  }
  double worst_normal() const {
    return worst(
        [&](const auto& t) { return t.normal_stiffness / config_.joints.normal_stiffness; });
  }
  double worst_shear() const {
    return worst([&](const auto& t) { return t.shear_stiffness / config_.joints.shear_stiffness; });
  }

  Summary summary() const {
    Summary s;
    s.set("tests", static_cast<long>(tests_.size()));
    s.set("worst/peak", worst_peak());
    s.set("worst/residual", worst_residual());
    s.set("worst/normal_stiffness", worst_normal());
    s.set("worst/shear_stiffness", worst_shear());
    return s;
  }

  std::string conditions() const {
    return "Random specimens " + in_words(config_.specimen.width) +
           " m wide of rock that does not break, one joint from side to side; friction " +
           in_words(config_.joints.friction) + ", cohesion " +
           in_words(config_.joints.cohesion / 1e6) + " MPa; strained at " +
           in_words(config_.load_frame.strain_rate) + " per second.";
  }

  observe::Chart strength() const {
    observe::Chart chart{
        .title = "Strength of a specimen with a joint",
        .x_label = "angle of the joint to the minor stress (°)",
        .y_label = "axial stress while the joint slips (MPa)",
        .caption =
            "Lines: the law of Coulomb on a plane of weakness (Jaeger 1960). Rings: the "
            "specimens.",
        .conditions = conditions()};
    const double friction = config_.joints.friction;
    for (const double confinement : config_.confinements()) {
      observe::Series line{.name = in_words(confinement / 1e6) + " MPa",
                           .colour = chart.series.empty() ? observe::okabe_ito::blue
                                                          : observe::okabe_ito::vermillion};
      observe::Series marks{.style = observe::Series::Style::markers, .colour = line.colour};
      for (double angle = 38; angle <= 80; angle += 0.5) {
        line.x.push_back(angle);
        line.y.push_back(analytic::joint_strength(angle, friction, 0, confinement) / 1e6);
      }
      for (const JointTestResult& t : tests_)
        if (t.confinement == confinement)
          marks.x.push_back(t.angle), marks.y.push_back(t.residual / 1e6);
      chart.series.push_back(std::move(line));
      chart.series.push_back(std::move(marks));
    }
    return chart;
  }

  observe::Chart slip() const {
    observe::Chart chart{.title = "How the joint slips",
                         .x_label = "shear displacement of the joint (mm)",
                         .y_label = "axial stress over the residual strength by Coulomb",
                         .caption =
                             "One line for each test: elastic, a peak where the joint's bonds "
                             "break, then the residual strength.",
                         .conditions = conditions()};
    for (const JointTestResult& t : tests_) {
      observe::Series s{.colour = t.confinement == config_.study.low_confinement
                                      ? observe::okabe_ito::blue
                                      : observe::okabe_ito::vermillion};
      for (const auto& r : t.readings)
        s.x.push_back(1e3 * r.shear), s.y.push_back(r.stress / t.coulomb_residual);
      chart.series.push_back(std::move(s));
    }
    return chart;
  }

  std::string report() const {
    const auto per_cent = [](double v) { return observe::fixed(100 * v, 1, "%"); };
    observe::Report page;
    page.title = "A joint slips as Coulomb says, to " + per_cent(worst_residual());
    page.lead = conditions();
    page.program = "hfdem " + manifest_.version + ", program " + manifest_.program;
    page.numbers({{"residual strength", per_cent(worst_residual()), "largest deviation"},
                  {"peak strength", per_cent(worst_peak()), "largest deviation"},
                  {"normal stiffness", per_cent(worst_normal()), "largest deviation"},
                  {"shear stiffness", per_cent(worst_shear()), "largest deviation"}});
    page.figure(strength());
    page.figure(slip());
    page.section("Tests");
    observe::Table table{.caption = "Strengths over those of the law of Coulomb.",
                         .header = {"angle", "confinement", "seed", "peak", "residual",
                                    "k_{n} (GPa/m)", "k_{s} (GPa/m)"}};
    for (const JointTestResult& t : tests_)
      table.rows.push_back({observe::fixed(t.angle, 0, "°"), megapascals(t.confinement),
                            std::to_string(t.seed), observe::fixed(t.peak / t.coulomb_peak, 3),
                            observe::fixed(t.residual / t.coulomb_residual, 3),
                            observe::fixed(t.normal_stiffness / 1e9, 2),
                            observe::fixed(t.shear_stiffness / 1e9, 2)});
    page.table(table);
    add_parameters(page, config_, JointTestsConfig{});
    page.section("Files");
    page.files({{"tests.csv", "strengths and stiffnesses of every test"},
                {"curves.csv", "stress, closure and shear displacement of every test"},
                {"summary.json", "the largest deviations"},
                {"config.toml", "every parameter; repeats the tests with --config"},
                {"strength.svg", "strength over angle"},
                {"slip.svg", "stress over shear displacement"}});
    add_manifest(page, manifest_);
    return page.html();
  }

  const JointTestsConfig& config_;
  const std::vector<JointTestResult>& tests_;
  const Manifest& manifest_;
};

}  // namespace hfdem::support
