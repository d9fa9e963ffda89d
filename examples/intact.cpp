// Carbon dioxide in intact rock (the paper's Section 4.1): a crack driven by uniform pressure
// through 17,500 bonded discs of random size and place.
//
//   build/release/examples/intact --case 2-S1 --out out/intact
//
// You should see, within a minute, a rough crack that leaves the specimen after a second or so:
// open out/intact/report.html. `--quick` runs a tenth of the area in some seconds; `--seed` takes
// another rock; `--help` lists the options.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "support/command_line.hpp"
#include "support/intact_results.hpp"
#include "support/intact_seeds.hpp"
#include "support/manifest.hpp"
#include "support/polite_threads.hpp"
#include "support/run_loop.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

/// One rock, from its begin or from its checkpoint. What ended the run early is said in its
/// outcome.
std::unique_ptr<IntactResults> run(const OutputFolder& folder, const IntactConfig& config,
                                   const Specimen& specimen, const CommandLine& options,
                                   const std::optional<MeasuredRock>& measured,
                                   Checkpoint& checkpoint) {
  if (!checkpoint.resumes())
    folder.discard({"report.html", "summary.json", "profile.csv", "cracks.csv", "fracture.svg",
                    "aperture_map.svg", "pressure_map.svg", "stress.svg", "pressure.svg",
                    "tips.svg", "length.svg", "aperture.svg", "energy.csv"});
  folder.write("config.toml", to_toml(config));
  auto results = std::make_unique<IntactResults>(folder, config, checkpoint.manifest(), measured,
                                                 checkpoint.resumes());
  std::optional<Rock> sim;
  const RunEnd end = end_of(sim, [&] {
    make_or_resume(sim, checkpoint, specimen, config.simulator);
    sim->use_threads(options.threads);
    drive(*sim, config.run.end_time, *results, checkpoint, options.quiet);
  });
  sim ? results->finish(*sim, end) : results->finish_unbegun(end.stopped);
  checkpoint.discard();
  if (!end.stopped.empty())
    std::fprintf(stderr, "intact: the run stopped: %s\n", end.stopped.c_str());
  if (!options.quiet && sim) std::printf("%s", results->text(*sim).c_str());
  return results;
}

int run_one(const CommandLine& options, const IntactConfig& config,
            const std::string& specimen_file, const std::optional<MeasuredRock>& measured,
            const Manifest& manifest) {
  Checkpoint checkpoint(options, manifest, to_toml(config));
  const std::string file = checkpoint.resumes() ? options.out + "/specimen.txt" : specimen_file;
  const Specimen specimen =
      file.empty() ? random_packing(config.specimen, options.threads) : load_specimen(file);
  const OutputFolder folder(options.out);
  const auto results = run(folder, config, specimen, options, measured, checkpoint);
  if (!options.quiet) std::printf("Open this in a browser: %s/report.html\n", options.out.c_str());
  return results->stopped() ? run_stopped : success;
}

int run_seeds(const CommandLine& options, IntactConfig config, int seeds,
              const std::optional<MeasuredRock>& measured, const Manifest& manifest) {
  const std::string wanted = std::to_string(seeds);
  Checkpoint checkpoint(options, manifest, to_toml(config) + "\n[study]\nseeds = " + wanted);
  const OutputFolder folder(options.out);
  folder.discard(IntactSeeds::files);
  folder.write("config.toml", to_toml(config));
  IntactSeeds all(config, checkpoint.manifest(), measured);
  checkpoint.resumes() ? checkpoint.load(all) : checkpoint.save(all);
  const int first = config.specimen.seed;
  const auto folder_of = [&](int seed) { return options.out + "/seed_" + std::to_string(seed); };
  // What an earlier study left unfinished is no part of this one.
  if (!checkpoint.resumes())
    for (int k = 0; k < seeds; ++k) std::filesystem::remove(checkpoint_file(folder_of(first + k)));
  for (int k = all.done(); k < seeds; ++k) {
    config.specimen.seed = first + k;
    if (!options.quiet) std::printf("seed %d (%d of %d)\n", config.specimen.seed, k + 1, seeds);
    CommandLine of_seed = options;
    of_seed.out = folder_of(config.specimen.seed);
    const bool begun = std::filesystem::exists(checkpoint_file(of_seed.out));
    of_seed.resume = begun && checkpoint.resumes() ? of_seed.out : "";
    try {
      Checkpoint inner(of_seed, manifest, to_toml(config));
      const OutputFolder inner_folder(of_seed.out);
      const auto results =
          run(inner_folder, config, random_packing(config.specimen, options.threads), of_seed,
              all.measured(), inner);
      all.add(config.specimen.seed, *results);
    } catch (const Interrupted&) {
      checkpoint.interrupt("in the rock of seed " + std::to_string(config.specimen.seed),
                           " --seeds " + wanted);
    }
    checkpoint.save(all);
  }
  all.write(folder);
  checkpoint.discard();
  if (!options.quiet)
    std::printf("%sOpen this in a browser: %s/report.html\n", all.text().c_str(),
                options.out.c_str());
  return success;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"A fluid-driven crack through intact rock: bonded discs of random size and place"};
  CommandLine options;
  options.add_to(app);
  std::string which, preset, specimen, toughness;
  std::optional<int> seed;
  int seeds = 1;
  app.add_option("--case", which, "a case of the paper's Table 4 (default 2-S1)")
      ->check(CLI::IsMember(IntactConfig::cases))
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
  return guarded("intact", app, [&] {
    app.parse(argc, argv);
    let_waiting_threads_sleep(options.threads, argv);
    IntactConfig config;
    if (options.quick) config.shrink();
    if (!which.empty()) config.load_case(which);
    if (!preset.empty()) config.load_paper_preset();
    options.configure(config);
    if (seed) config.specimen.seed = *seed;
    validate_all(config);
    config.simulator.scheme = config.simulator.scheme.resolved();
    std::optional<MeasuredRock> measured;
    if (!toughness.empty()) measured = read_rock(toughness);
    static_cast<void>(prediction_of(measured, config));  // refuses before any run
    // A checkpoint of several rocks is none of a single one.
    const Manifest made =
        manifest(seeds > 1 ? "intact --seeds" : "intact", argc, argv, options.threads,
                 specimen.empty() ? std::to_string(config.specimen.seed)
                                  : "none: the specimen is from a file");
    return seeds > 1 ? run_seeds(options, config, seeds, measured, made)
                     : run_one(options, config, specimen, measured, made);
  });
}
