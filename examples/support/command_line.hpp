/// @file
/// The options that every program of a run shares.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "support/output_folder.hpp"
#include "support/settings.hpp"

namespace hfdem::support {

/// What a program's exit status says.
enum ExitStatus { success = 0, output_failed = 1, bad_input = 2, run_stopped = 3 };

struct CommandLine {
  std::string out, config;
  std::vector<std::string> assignments;
  int threads = 1;
  bool quick = false, quiet = false;

  void add_to(CLI::App& app) {
    app.add_option("--out", out, "folder for the results (made if missing)")->required();
    app.add_option("--config", config, "parameter file (TOML); see DIR/config.toml of any run");
    app.add_option("--set", assignments, "set one parameter: section.key=value (repeatable)")
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    app.add_option("--threads", threads, "threads; the results do not depend on it")
        ->check(CLI::Range(1, 1024));
    app.add_flag("--quick", quick, "a small specimen and a short run, in about a second");
    app.add_flag("--quiet", quiet, "print nothing but errors");
  }

  /// Applies the file, then the assignments, and checks the result.
  /// @throws InvalidParameter naming what is wrong and where
  template <class Config>
  void configure(Config& parameters) const {
    if (!config.empty())
      for (const Setting& s : read_toml(config)) apply(parameters, s);
    for (const std::string& a : assignments) apply(parameters, read_assignment(a));
    validate_all(parameters);
  }
};

/// Runs a program's body and turns what it throws into a sentence and an exit status.
template <class Body>
int guarded(const char* program, const CLI::App& app, Body&& body) {
  try {
    return body();
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? success : bad_input;
  } catch (const InvalidParameter& e) {
    std::fprintf(stderr, "%s: %s\n", program, e.what());
    return bad_input;
  } catch (const OutputFailed& e) {
    std::fprintf(stderr, "%s: %s\n", program, e.what());
    return output_failed;
  } catch (const RunStopped& e) {
    std::fprintf(stderr, "%s: %s\n", program, e.what());
    return run_stopped;
  }
}

}  // namespace hfdem::support
