/// @file
/// A program that drives a crack through random rock: one rock, or several for their means.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/manifest.hpp"
#include "support/natural_fractures.hpp"
#include "support/rock_options.hpp"
#include "support/rock_results.hpp"
#include "support/rock_seeds.hpp"
#include "support/run_loop.hpp"

namespace hfdem::support {

/// @tparam Config the parameter file, from `RockRunSections`
template <class Config>
class RockProgram {
 public:
  using Sim = typename Config::Sim;

  /// @param name of the program
  /// @param options as read
  /// @param config as they ask for
  /// @param fractures natural ones, the same in every rock
  /// @throws InvalidParameter if a prediction is asked for that cannot be made
  RockProgram(std::string name, const RockOptions& options, Config config,
              NamedFractures fractures = {})
      : name_(std::move(name)),
        options_(options),
        config_(std::move(config)),
        fractures_(std::move(fractures)) {
    if (!options.toughness.empty()) measured_ = read_rock(options.toughness);
    static_cast<void>(prediction_of(measured_, config_));  // refuses before any run
  }

  /// @returns the exit status
  int run(int argc, const char* const* argv) {
    // A checkpoint of several rocks is none of a single one.
    const bool several = options_.seeds > 1;
    manifest_ = manifest(several ? name_ + " --seeds" : name_, argc, argv, common().threads,
                         options_.specimen.empty() ? std::to_string(config_.specimen.seed)
                                                   : "none: the specimen is from a file");
    return several ? run_seeds() : run_one();
  }

 private:
  using Results = RockResults<Config>;

  const CommandLine& common() const { return options_.common; }

  /// What a run that goes on must have in common with its beginning.
  std::string identity(const Config& config) const {
    return to_toml(config) + in_lines(fractures_.fractures);
  }

  /// Of random discs, or of those in a file.
  Specimen specimen(const Config& config, const std::string& file) const {
    Specimen s =
        file.empty() ? random_packing(config.specimen, common().threads) : load_specimen(file);
    put_into(s, fractures_);
    return s;
  }

  void write_input(const OutputFolder& folder, const Config& config) const {
    folder.write("config.toml", to_toml(config));
    if (!fractures_.fractures.empty()) save(folder.path() / fracture_table, fractures_.fractures);
  }

  /// One rock, from its begin or from its checkpoint. What ended the run early is said in its
  /// outcome.
  std::unique_ptr<Results> run_rock(const CommandLine& options, const Config& config,
                                    const Specimen& specimen,
                                    const std::optional<MeasuredRock>& measured,
                                    Checkpoint& checkpoint) {
    const OutputFolder folder(options.out);
    if (!checkpoint.resumes()) folder.discard(Results::files);
    write_input(folder, config);
    auto results =
        std::make_unique<Results>(folder, config, checkpoint.manifest(), measured,
                                  specimen.joints.fractures.size(), checkpoint.resumes());
    std::optional<Sim> sim;
    const RunEnd end = end_of(sim, [&] {
      make_or_resume(sim, checkpoint, specimen, config.simulator);
      sim->use_threads(options.threads);
      drive(*sim, config.run.end_time, *results, checkpoint, options.quiet);
    });
    sim ? results->finish(*sim, end) : results->finish_unbegun(end.stopped);
    checkpoint.discard();
    if (!end.stopped.empty())
      std::fprintf(stderr, "%s: the run stopped: %s\n", name_.c_str(), end.stopped.c_str());
    if (!options.quiet && sim) std::printf("%s", results->text(*sim).c_str());
    return results;
  }

  int run_one() {
    Checkpoint checkpoint(common(), manifest_, identity(config_));
    const Specimen rock = specimen(config_, options_.specimen_file());
    const auto results = run_rock(common(), config_, rock, measured_, checkpoint);
    say_where();
    return results->stopped() ? run_stopped : success;
  }

  int run_seeds() {
    const std::string wanted = std::to_string(options_.seeds);
    Checkpoint checkpoint(common(), manifest_, identity(config_) + "\n[study]\nseeds = " + wanted);
    const OutputFolder folder(common().out);
    folder.discard(RockSeeds<Config>::files);
    write_input(folder, config_);
    RockSeeds<Config> all(config_, checkpoint.manifest(), measured_, fractures_.fractures.size());
    checkpoint.resumes() ? checkpoint.load(all) : checkpoint.save(all);
    const int first = config_.specimen.seed;
    const auto folder_of = [&](int seed) { return common().out + "/seed_" + std::to_string(seed); };
    // What an earlier study left unfinished is no part of this one.
    if (!checkpoint.resumes())
      for (int k = 0; k < options_.seeds; ++k)
        std::filesystem::remove(checkpoint_file(folder_of(first + k)));
    for (int k = all.done(); k < options_.seeds; ++k) {
      Config config = config_;
      const int seed = config.specimen.seed = first + k;
      if (!common().quiet) std::printf("seed %d (%d of %d)\n", seed, k + 1, options_.seeds);
      CommandLine of_seed = common();
      of_seed.out = folder_of(seed);
      const bool begun = std::filesystem::exists(checkpoint_file(of_seed.out));
      of_seed.resume = begun && checkpoint.resumes() ? of_seed.out : "";
      try {
        Checkpoint inner(of_seed, manifest_, identity(config));
        all.add(seed, *run_rock(of_seed, config, specimen(config, ""), all.measured(), inner));
      } catch (const Interrupted&) {
        checkpoint.interrupt("in the rock of seed " + std::to_string(seed), " --seeds " + wanted);
      }
      checkpoint.save(all);
    }
    all.write(folder);
    checkpoint.discard();
    if (!common().quiet) std::printf("%s", all.text().c_str());
    say_where();
    return success;
  }

  void say_where() const {
    if (!common().quiet)
      std::printf("Open this in a browser: %s/report.html\n", common().out.c_str());
  }

  std::string name_;
  const RockOptions& options_;
  const Config config_;
  NamedFractures fractures_;
  std::optional<MeasuredRock> measured_;
  Manifest manifest_;
};

}  // namespace hfdem::support
