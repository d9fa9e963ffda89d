// A crack meets a joint: a map of arrest, offset and crossing over the angle between them and the
// in-situ stress along the crack.
//
//   build/release/examples/crossing --threads 2 --out out/crossing
//
// You should see, after some minutes, cracks cross where they meet the joint at a right angle under
// a high stress, and turn into the joint where the angle or the stress is low; the criterion of Gu
// and Weng (2010) is drawn beside them.
#include <cstdio>
#include <optional>
#include <vector>

#include <CLI/CLI.hpp>

#include "support/checkpoint.hpp"
#include "support/command_line.hpp"
#include "support/crossing_results.hpp"
#include "support/interrupts.hpp"
#include "support/manifest.hpp"
#include "support/polite_threads.hpp"
#include "support/progress.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

/// Nothing if the program was asked to stop.
std::optional<EncounterOfRock> encounter(const CrossingConfig& config, double angle, double stress,
                                         int seed, int threads) {
  EncounterOfRock rock{.angle = angle, .stress = stress, .seed = seed};
  CrossingRock::Params params = config.simulator;
  params.in_situ.yy = stress;
  EncounterWatch watch(config.study);
  try {
    CrossingRock sim(config.rock(angle, seed, threads), params);
    sim.use_threads(threads);
    bool asked_to_stop = false;
    const auto go_on = [&](const CrossingRock&) { return !(asked_to_stop = interrupted()); };
    try {
      sim.run_until(config.study.end_time, watch, go_on);
    } catch (const ReachedRim&) {  // the other wing got away
    }
    if (asked_to_stop) return {};
    rock.time = sim.time();
    rock.encounter = watch.result();
  } catch (const RunStopped& reason) {
    std::fprintf(stderr, "crossing: the run at %g degrees, %g MPa, seed %d stopped: %s\n", angle,
                 stress / 1e6, seed, reason.what());
    rock.stopped = true;
  }
  return rock;
}

int run(const CommandLine& options, const CrossingConfig& config, const Manifest& made) {
  Checkpoint checkpoint(options, made, to_toml(config));
  const OutputFolder folder(options.out);
  folder.discard(CrossingResults::files);
  folder.write("config.toml", to_toml(config));
  std::vector<EncounterOfRock> rocks;
  checkpoint.resumes() ? checkpoint.load(rocks) : checkpoint.save(rocks);
  ProgressLine progress(options.quiet);
  const auto all =
      static_cast<double>(config.angles().size() * config.stresses().size()) * config.study.seeds;
  std::size_t number = 0;
  for (const double angle : config.angles())
    for (const double stress : config.stresses())
      for (int k = 0; k < config.study.seeds; ++k) {
        if (number++ < rocks.size()) continue;  // before it was resumed
        progress.show(static_cast<double>(rocks.size()) / all,
                      to_text(angle) + " degrees, " + in_words(stress / 1e6) + " MPa");
        const auto rock =
            encounter(config, angle, stress, config.specimen.seed + k, options.threads);
        if (!rock) checkpoint.interrupt("at " + to_text(angle) + " degrees");
        rocks.push_back(*rock);
        checkpoint.save(rocks);
      }
  const CrossingResults results(config, rocks, checkpoint.manifest());
  results.write(folder);
  checkpoint.discard();
  if (!options.quiet)
    std::printf("%sOpen this in a browser: %s/report.html\n", results.text().c_str(),
                options.out.c_str());
  return success;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"A fluid-driven crack at a joint: arrested, offset or crossing"};
  CommandLine options;
  options.add_to(app);
  return guarded("crossing", app, [&] {
    app.parse(argc, argv);
    let_waiting_threads_sleep(options.threads, argv);
    CrossingConfig config;
    if (options.quick) config.shrink();
    options.configure(config);
    config.simulator.scheme = config.simulator.scheme.resolved();
    return run(options, config,
               manifest("crossing", argc, argv, options.threads,
                        "from " + std::to_string(config.specimen.seed) + " on"));
  });
}
