/// @file
/// The options that all programs of random rock share.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "support/command_line.hpp"
#include "support/run_options.hpp"
#include "support/schemes.hpp"

namespace hfdem::support {

struct RockOptions {
  CommandLine common;
  std::string which, preset, specimen, toughness;
  std::optional<int> seed;
  int seeds = 1;
  SchemeChoice scheme;

  /// @tparam Viscous the parameter file with a fluid that flows, which knows all cases
  /// @tparam Slick the one with uniform pressure, the usual one
  template <class Viscous, class Slick>
  void add_to(CLI::App& app) {
    constexpr auto& cases = Viscous::cases;
    common.add_to(app);
    scheme.add_to(app, std::array{"uniform", "implicit"});
    app.add_option(
           "--case", which,
           "a case of the paper's Table 4 (default " + std::string(Slick::cases.front()) + ")")
        ->check(CLI::IsMember(cases))
        ->excludes("--resume")
        ->excludes("--config");
    app.add_option("--preset", preset,
                   "paper: choices found by trial that land on the numbers that the paper prints")
        ->check(CLI::IsMember({"paper"}))
        ->excludes("--resume")
        ->excludes("--config");
    app.add_option("--seed", seed, "of the random specimen: every seed is another rock")
        ->excludes("--resume");
    app.add_option("--seeds", seeds, "how many rocks, from --seed on: means and 95 % intervals")
        ->check(CLI::Range(1, 10000));
    app.add_option("--specimen", specimen, "file with the discs, instead of a random specimen")
        ->check(CLI::ExistingFile)
        ->excludes("--seeds")
        ->excludes("--seed")
        ->excludes("--resume");
    app.add_option(
           "--toughness", toughness,
           "what slits and running cracks measured (toughness.toml of toughness --rock random), "
           "to predict the run")
        ->check(CLI::ExistingFile)
        ->excludes("--resume");
  }

  /// Whether the run is to have a fluid that flows: as is asked for, or as the case has it.
  template <class Slick>
  bool flows() const {
    const auto& cases = Slick::cases;
    const bool viscous =
        !which.empty() && std::find(cases.begin(), cases.end(), which) == cases.end();
    const bool chosen = scheme.name(common, viscous ? "implicit" : "uniform") == "implicit";
    if (viscous && !chosen)
      throw InvalidParameter("--case " + which +
                             " has a viscous fluid, which --scheme uniform does not know: it must "
                             "be implicit");
    return chosen;
  }

  /// The parameters that the options ask for.
  /// @throws InvalidParameter naming what is wrong and where
  template <class Config>
  Config configured() const {
    Config config;
    if (common.quick) config.shrink();
    if (!which.empty()) config.load_case(which);
    if (!preset.empty()) config.load_paper_preset();
    common.configure(config);
    if (seed) config.specimen.seed = *seed;
    validate_all(config);
    config.simulator.scheme = resolved(config.simulator.scheme);
    return config;
  }

  /// The file that holds the discs, empty if they are to be packed; a run that goes on has its own.
  std::string specimen_file() const {
    return common.resume.empty() || seeds > 1 ? specimen : common.resume + "/specimen.txt";
  }
};

}  // namespace hfdem::support
