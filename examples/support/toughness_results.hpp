/// @file
/// Everything that a series of slit tests writes.
#pragma once

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/history.hpp>
#include <hfdem/observe/report.hpp>

#include "support/output_folder.hpp"
#include "support/run_report.hpp"
#include "support/summary.hpp"
#include "support/toughness_model.hpp"

namespace hfdem::support {

class ToughnessResults {
 public:
  ToughnessResults(const ToughnessConfig& config, const measure::ToughnessTest& test,
                   const Manifest& manifest, double wall)
      : config_(config), test_(test), manifest_(manifest), wall_(wall) {}

  /// @throws OutputFailed if a file cannot be written
  void write(const OutputFolder& folder) const {
    folder.write("toughness.toml", to_toml(MeasuredToughness{{}, test_.rock, config_.lattice}));
    std::ofstream slits = folder.open("slits.csv");
    slits << "contacts,full_length_m,net_pressure_Pa,opening_m,volume_m2,breaks\n";
    for (const auto& [slit, E_prime, K_IC] : test_.readings)
      for (const measure::SlitState& s : slit.states)
        observe::write_row(
            slits, {static_cast<double>(slit.contacts), 2 * slit.half_length, s.net_pressure,
                    s.opening, s.volume, s.net_pressure == slit.net_pressure_at_break ? 1.0 : 0.0});
    folder.close(slits, "slits.csv");
    folder.write("toughness.svg", svg(toughness_chart()));
    folder.write("opening.svg", svg(opening_chart()));
    folder.write("summary.json", summary().json());
    folder.write("report.html", report());
  }

  /// The answer in a few lines for a terminal.
  std::string text() const {
    std::string text = "length      first break   E'          K_IC\n";
    char line[160];
    for (const auto& [slit, E_prime, K_IC] : test_.readings) {
      std::snprintf(line, sizeof line, "%.3f m     %6.3f MPa    %5.2f GPa   %5.3f MPa sqrt(m)\n",
                    2 * slit.half_length, slit.net_pressure_at_break / 1e6, E_prime / 1e9,
                    K_IC / 1e6);
      text += line;
    }
    const auto& rock = test_.rock;
    std::snprintf(line, sizeof line, "E' = %.2f GPa, %.3f E;  K_IC = %.3f + %.4f p (MPa, m)\n",
                  rock.E_prime / 1e9, rock.E_prime / rock.E, rock.K_IC / 1e6,
                  rock.K_IC_per_pressure);
    return text + line + doubt();
  }

 private:
  Summary summary() const {
    const auto& rock = test_.rock;
    Summary s;
    s.set("E_Pa", rock.E);
    s.set("poisson_ratio", rock.poisson_ratio);
    s.set("shear_modulus_Pa", rock.shear_modulus);
    s.set("E_prime_Pa", rock.E_prime);
    s.set("E_prime_spread", test_.E_prime_spread);
    s.set("E_prime_from_volume_Pa", test_.E_prime_from_volume);
    s.set("E_prime_over_E", rock.E_prime / rock.E);
    s.set("K_IC_Pa_sqrt_m", rock.K_IC);
    s.set("K_IC_per_pressure_sqrt_m", rock.K_IC_per_pressure);
    s.set("opening_offset_m", rock.opening_offset);
    s.set("volume_offset_m", rock.volume_offset);
    s.set("overhang_m", rock.overhang);
    for (std::size_t k = 0; k < test_.readings.size(); ++k) {
      const auto& [slit, E_prime, K_IC] = test_.readings[k];
      const std::string at = "slits/" + std::to_string(k) + "/";
      s.set(at + "contacts", slit.contacts);
      s.set(at + "full_length_m", 2 * slit.half_length);
      s.set(at + "net_pressure_at_first_break_Pa", slit.net_pressure_at_break);
      s.set(at + "E_prime_Pa", E_prime);
      s.set(at + "K_IC_Pa_sqrt_m", K_IC);
      s.set(at + "opening_offset_m", -slit.opening.intercept);
    }
    s.set("wall_s", wall_);
    s.set("threads", manifest_.threads);
    return s;
  }

  /// What makes the numbers doubtful; empty if nothing does.
  std::string doubt() const {
    if (test_.E_prime_spread < 0.05) return "";
    return "Beware: E' of the slits differs by " + observe::fixed(100 * test_.E_prime_spread, 0) +
           " %, so this specimen is no elastic plate: where the in-situ stress is low, contacts "
           "open "
           "around the tips and only bonds carry.\n";
  }

  observe::Chart toughness_chart() const {
    observe::Chart chart{
        .title = "Toughness is not one number",
        .x_label = "net pressure at the first break (MPa)",
        .y_label = "K_{IC} (MPa·m^{1/2})",
        .caption =
            "Each ring is a slit, the shortest on the right: what breaks is a contact of a "
            "given strength, so the stress intensity at that moment grows with the pressure "
            "that it takes.",
        .conditions = conditions()};
    observe::Series fit{.name = "straight line", .style = observe::Series::Style::dashed};
    double highest = 0;
    for (const auto& [slit, E_prime, K_IC] : test_.readings) {
      chart.points.push_back({observe::fixed(2 * slit.half_length, 2, "m"),
                              slit.net_pressure_at_break / 1e6, K_IC / 1e6});
      highest = std::fmax(highest, slit.net_pressure_at_break);
    }
    for (const double p : {0.0, 1.1 * highest})
      fit.x.push_back(p / 1e6), fit.y.push_back(test_.rock.toughness(p) / 1e6);
    chart.series = {fit};
    return chart;
  }

  observe::Chart opening_chart() const {
    observe::Chart chart{.title = "Opening of the slits",
                         .x_label = "net pressure (MPa)",
                         .y_label = "opening in the middle (µm)",
                         .caption =
                             "Up to the first break, at the end of each line. The slope is "
                             "the modulus E' with which the lattice opens, the finite plate "
                             "taken into account.",
                         .conditions = conditions()};
    for (const auto& [slit, E_prime, K_IC] : test_.readings) {
      observe::Series line{.name = observe::fixed(2 * slit.half_length, 2, "m")};
      for (const measure::SlitState& s : slit.states)
        line.x.push_back(s.net_pressure / 1e6), line.y.push_back(s.opening * 1e6);
      chart.series.push_back(line);
    }
    return chart;
  }

  std::string conditions() const {
    const auto& l = config_.lattice;
    return std::to_string(l.specimen.columns) + " x " + std::to_string(l.specimen.rows) +
           " discs of radius " + in_words(l.specimen.radius * 1e3) + " mm under " +
           in_words(l.in_situ.xx / 1e6) + " MPa (x) and " + in_words(l.in_situ.yy / 1e6) +
           " MPa (y).";
  }

  static std::string toughness_words(double K, int decimals = 3) {
    return observe::fixed(K / 1e6, decimals, "MPa·m^{1/2}");
  }

  std::string report() const {
    using observe::fixed;
    const auto& rock = test_.rock;
    observe::Report page;
    page.title = "Toughness and modulus, measured with slits";
    page.program = "hfdem " + manifest_.version + ", program " + manifest_.program;
    page.lead = "Straight slits of " + std::to_string(test_.readings.size()) +
                " lengths, held open by a given pressure: " + conditions();
    page.numbers(
        {{"modulus E'", fixed(rock.E_prime / 1e9, 2, "GPa"),
          fixed(rock.E_prime / rock.E, 3) + " of E, " + fixed(rock.E / 1e9, 2, "GPa")},
         {"K_{IC} of the longest slit", toughness_words(test_.readings.back().K_IC),
          "at " + fixed(test_.readings.back().slit.net_pressure_at_break / 1e6, 2, "MPa")},
         {"K_{IC} of the shortest slit", toughness_words(test_.readings.front().K_IC),
          "at " + fixed(test_.readings.front().slit.net_pressure_at_break / 1e6, 2, "MPa")}});
    if (!doubt().empty()) page.text(doubt());
    page.figure(toughness_chart());
    page.section("Why K_{IC} is not one number");
    page.text(
        "In an elastic plane the stress ahead of a crack is infinite, and its intensity K "
        "alone decides. Here a contact of finite size breaks when its bond reaches its "
        "strength. The stress at that contact has parts beside the singular one: the "
        "pressure itself and the in-situ stress, which press on the contact too. So K at the "
        "moment of breaking depends on the net pressure, on the in-situ stress, on the size "
        "of the discs and on the strength; a value holds for the lattice it was measured "
        "on. Over these slits a straight line says it: K_{IC} = " +
        toughness_words(rock.K_IC) + " + " + fixed(rock.K_IC_per_pressure, 4, "m^{1/2}") +
        " × net pressure.");
    page.section("The slits");
    page.figure(opening_chart());
    page.table(slit_table());
    page.facts(
        {{"E' from the volumes", fixed(test_.E_prime_from_volume / 1e9, 2, "GPa")},
         {"shear modulus", fixed(rock.shear_modulus / 1e9, 2, "GPa")},
         {"opening less than a continuum's by", fixed(rock.opening_offset * 1e6, 2, "µm")},
         {"mean opening less by", fixed(rock.volume_offset * 1e6, 2, "µm")},
         {"for its volume a slit is longer at each tip by", fixed(rock.overhang * 1e3, 2, "mm")},
         {"wall time", fixed(wall_, 1, "s")}});
    page.text(
        "The offsets are what a row of discs has and a continuum has not: contacts that the "
        "in-situ stress had closed, and flow domains beyond the tips whose pressure opens "
        "the slit a little more.");
    add_parameters(page, config_, ToughnessConfig{});
    page.section("Files");
    page.files({{"toughness.toml", "the result, for kgd --toughness"},
                {"slits.csv", "opening and volume of each slit at each pressure"},
                {"summary.json", "the answer in numbers"},
                {"config.toml", "every parameter; repeats the tests with --config"},
                {"toughness.svg", "the first figure above, for other documents"},
                {"opening.svg", "opening against pressure"}});
    add_manifest(page, manifest_);
    return page.html();
  }

  observe::Table slit_table() const {
    using observe::fixed;
    observe::Table table{.header = {"length", "contacts", "net pressure at first break", "E'",
                                    "K_{IC}", "opening offset"}};
    for (const auto& [slit, E_prime, K_IC] : test_.readings)
      table.rows.push_back({fixed(2 * slit.half_length, 2, "m"), std::to_string(slit.contacts),
                            fixed(slit.net_pressure_at_break / 1e6, 3, "MPa"),
                            fixed(E_prime / 1e9, 2, "GPa"), toughness_words(K_IC),
                            fixed(-slit.opening.intercept * 1e6, 2, "µm")});
    return table;
  }

  const ToughnessConfig& config_;
  const measure::ToughnessTest& test_;
  const Manifest& manifest_;
  double wall_;
};

}  // namespace hfdem::support
