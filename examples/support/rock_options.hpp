/// @file
/// The options that all programs of random rock share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "support/command_line.hpp"

namespace hfdem::support {

struct RockOptions {
  CommandLine common;
  std::string which, preset, specimen, toughness;
  std::optional<int> seed;
  int seeds = 1;

  /// @param cases of the paper's Table 4, the default first
  template <class Cases>
  void add_to(CLI::App& app, const Cases& cases) {
    common.add_to(app);
    app.add_option("--case", which,
                   "a case of the paper's Table 4 (default " + std::string(cases.front()) + ")")
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
    config.simulator.scheme = config.simulator.scheme.resolved();
    return config;
  }

  /// The file that holds the discs, empty if they are to be packed; a run that goes on has its own.
  std::string specimen_file() const {
    return common.resume.empty() || seeds > 1 ? specimen : common.resume + "/specimen.txt";
  }
};

}  // namespace hfdem::support
