// Carbon dioxide in intact rock (the paper's Section 4.1): a crack driven by uniform pressure
// through 17,500 bonded discs of random size and place.
//
//   build/release/examples/intact --case 2-S1 --out out/intact
//
// You should see, within a minute, a rough crack that leaves the specimen after a second or so:
// open out/intact/report.html. `--quick` runs a tenth of the area in some seconds; `--seed` takes
// another rock; `--help` lists the options.
#include <cstdio>
#include <optional>

#include <CLI/CLI.hpp>

#include "support/command_line.hpp"
#include "support/intact_results.hpp"
#include "support/manifest.hpp"
#include "support/polite_threads.hpp"
#include "support/progress.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

int run(const CommandLine& options, const IntactConfig& config, const std::string& specimen_file,
        const Manifest& manifest) {
  const Specimen specimen = specimen_file.empty() ? random_packing(config.specimen, options.threads)
                                                  : load_specimen(specimen_file);
  const OutputFolder folder(options.out);
  folder.discard({"report.html", "summary.json", "profile.csv", "cracks.csv", "specimen.txt",
                  "fracture.svg", "aperture_map.svg", "pressure_map.svg", "stress.svg",
                  "pressure.svg", "tips.svg", "length.svg", "aperture.svg"});
  folder.write("config.toml", to_toml(config));
  IntactResults results(folder, config, manifest);
  std::optional<Rock> sim;
  std::string stopped;
  try {
    sim.emplace(specimen, config.simulator);
    sim->use_threads(options.threads);
    results.begin(*sim);
    sim->run_until(config.run.end_time, results, Progress(config.run.end_time, options.quiet));
  } catch (const ReachedRim&) {
    results.reached_rim(*sim);
  } catch (const RunStopped& reason) {
    stopped = reason.what();
  }
  sim ? results.finish(*sim, stopped) : results.finish_unbegun(stopped);
  if (!stopped.empty()) std::fprintf(stderr, "intact: the run stopped: %s\n", stopped.c_str());
  if (!options.quiet && sim) std::printf("%s", results.text(*sim).c_str());
  if (!options.quiet) std::printf("Open this in a browser: %s/report.html\n", options.out.c_str());
  return stopped.empty() ? success : run_stopped;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"A fluid-driven crack through intact rock: bonded discs of random size and place"};
  CommandLine options;
  options.add_to(app);
  std::string which, preset, specimen;
  std::optional<int> seed;
  app.add_option("--case", which, "a case of the paper's Table 4 (default 2-S1)")
      ->check(CLI::IsMember(IntactConfig::cases));
  app.add_option("--preset", preset,
                 "paper: choices found by trial that land on the numbers that the paper prints")
      ->check(CLI::IsMember({"paper"}));
  app.add_option("--seed", seed, "of the random specimen: every seed is another rock");
  app.add_option("--specimen", specimen, "file with the discs, instead of a random specimen")
      ->check(CLI::ExistingFile);
  return guarded("intact", app, [&] {
    app.parse(argc, argv);
    let_waiting_threads_sleep(options.threads, argv);
    IntactConfig config;
    if (options.quick) config.shrink();
    if (!which.empty()) config.load_case(which);
    if (!preset.empty()) config.load_paper_preset();
    if (seed) config.specimen.seed = *seed;
    options.configure(config);
    config.simulator.scheme = config.simulator.scheme.resolved();
    return run(
        options, config, specimen,
        manifest("intact", argc, argv, options.threads, std::to_string(config.specimen.seed)));
  });
}
