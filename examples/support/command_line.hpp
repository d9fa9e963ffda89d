/// @file
/// The options that every program of a run shares.
#pragma once

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "support/output_folder.hpp"
#include "support/settings.hpp"

namespace hfdem::support {

/// What a program's exit status says.
enum ExitStatus {
  success = 0,
  output_failed = 1,
  bad_input = 2,
  run_stopped = 3,
  asked_to_stop = 4
};

/// The end of a program that was asked to stop and has saved; the message says how to go on.
struct Interrupted : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Where a run's checkpoint is.
inline std::filesystem::path checkpoint_file(const std::filesystem::path& folder) {
  return folder / "checkpoint";
}

struct CommandLine {
  std::string out, config, resume;
  std::vector<std::string> assignments;
  int threads = 1;
  double checkpoint = 60;
  bool quick = false, quiet = false, overwrite = false;

  void add_to(CLI::App& app) {
    auto* go_on = app.add_option("--resume", resume,
                                 "go on with the unfinished run in this folder, instead of --out");
    go_on->excludes(app.add_option("--out", out, "folder for the results (made if missing)"),
                    app.add_option("--config", config,
                                   "parameter file (TOML); see DIR/config.toml of any run"));
    app.add_option("--set", assignments, "set one parameter: section.key=value (repeatable)")
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->excludes(go_on);
    app.add_option("--threads", threads, "threads; the results do not depend on it")
        ->check(CLI::Range(1, 1024));
    app.add_option("--checkpoint", checkpoint,
                   "seconds between two saves of the unfinished run, for --resume; default 60")
        ->check(CLI::NonNegativeNumber);
    app.add_flag("--overwrite", overwrite, "give up an unfinished run in the folder")
        ->excludes(go_on);
    app.add_flag("--quick", quick, "a small specimen and a short run, in about a second")
        ->excludes(go_on);
    app.add_flag("--quiet", quiet, "print nothing but errors");
    app.callback([this] { find_run(); });
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

 private:
  /// A run that goes on does so where it is, with its own parameters.
  void find_run() {
    if (resume.empty()) {
      if (out.empty()) throw CLI::RequiredError("--out");
      return;
    }
    out = resume;
    config = (std::filesystem::path(resume) / "config.toml").string();
    if (!std::filesystem::exists(checkpoint_file(resume)))
      throw InvalidParameter("there is nothing to resume in " + resume +
                             ": its run is complete, or had not begun; it has no checkpoint");
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
  } catch (const Interrupted& e) {
    std::fprintf(stderr, "%s: %s\n", program, e.what());
    return asked_to_stop;
  } catch (const OutputFailed& e) {
    std::fprintf(stderr, "%s: %s\n", program, e.what());
    return output_failed;
  } catch (const RunStopped& e) {
    std::fprintf(stderr, "%s: %s\n", program, e.what());
    return run_stopped;
  }
}

}  // namespace hfdem::support
