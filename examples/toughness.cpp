// The modulus and the toughness of the verification model's lattice, measured instead of fitted:
// slits of several lengths are held open by a given pressure until the first bond reaches its
// strength.
//
//   build/release/examples/toughness --out out/toughness
//
// You should see, after about a minute, E' = 25.8 GPa, which is 0.76 of Young's modulus, and a
// toughness that grows with the net pressure from 1.68 to 1.84 MPa sqrt(m). The file toughness.toml
// is what `kgd --toughness` reads.
//
//   build/release/examples/toughness --rock random --seeds 10 --out out/random
//
// does the same for random packings, where the toughness is that of cracks that run: about a minute
// for each seed.
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "support/checkpoint.hpp"
#include "support/command_line.hpp"
#include "support/manifest.hpp"
#include "support/plate_of_lattice.hpp"
#include "support/polite_threads.hpp"
#include "support/progress.hpp"
#include "support/random_toughness_results.hpp"
#include "support/toughness_results.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

/// Tests the slits that are not among `tests` yet.
/// @throws Interrupted between two slits if the program was asked to stop
void test_slits(const ToughnessConfig& config, const CommandLine& options, Checkpoint& checkpoint,
                std::vector<measure::SlitTest>& tests, const Stopwatch& watch) {
  const Lattice& lattice = config.lattice;
  if (lattice.in_situ.xx == 0 && lattice.in_situ.yy == 0)
    refuse("in_situ", "xx", "0 Pa, and in_situ.yy too,",
           "greater than 0: equilibrium is judged by the forces that the in-situ stress makes");
  const std::vector<int> lengths = config.slits.contacts();
  const bool upright = crack_direction(lattice.in_situ).y != 0;
  const int most = (upright ? lattice.specimen.rows : lattice.specimen.columns) * 9 / 10;
  if (lengths.back() > most)
    refuse("slits", "longest", std::to_string(config.slits.longest),
           "at most " + std::to_string(most) + ": a slit needs rock ahead of its tips");
  ProgressLine progress(options.quiet);
  while (tests.size() < lengths.size()) {
    tests.push_back(next_slit_test(config, tests, options.threads));
    progress.show(static_cast<double>(tests.size()) / static_cast<double>(lengths.size()),
                  "slit of " + in_words(2 * tests.back().half_length) + " m");
    checkpoint.save(tests, watch);
    if (interrupted())
      checkpoint.interrupt("after slit " + std::to_string(tests.size()) + " of " +
                           std::to_string(lengths.size()));
  }
}

void say_where(const CommandLine& options, const std::string& text) {
  if (!options.quiet)
    std::printf("%sOpen this in a browser: %s/report.html\n", text.c_str(), options.out.c_str());
}

/// Writes the parameters, then what `measure(folder, checkpoint, watch)` says.
/// @param state what the tests have come to so far: empty, or taken up from the checkpoint
template <class Config, class State, class Measure>
int run(const CommandLine& options, const Config& config, const Manifest& manifest, State& state,
        Measure&& measure) {
  const OutputFolder folder(options.out);
  Checkpoint checkpoint(options, manifest, to_toml(config));
  folder.discard({"report.html", "summary.json", "toughness.toml", "slits.csv", "growth.csv",
                  "toughness.svg", "opening.svg", "pressure.svg", "length.svg"});
  folder.write("config.toml", to_toml(config));
  Stopwatch watch;
  if (checkpoint.resumes()) checkpoint.load(state, watch);
  int status = success;
  try {
    measure(folder, checkpoint, watch);
  } catch (const RunStopped& reason) {
    std::fprintf(stderr, "toughness: the run stopped: %s\n", reason.what());
    status = run_stopped;
  } catch (const InvalidParameter&) {
    checkpoint.discard();  // such parameters say nothing: there is nothing to go on with
    throw;
  }
  checkpoint.discard();
  return status;
}

int run_square(const CommandLine& options, const ToughnessConfig& config,
               const Manifest& manifest) {
  std::vector<measure::SlitTest> tests;
  return run(options, config, manifest, tests,
             [&](const OutputFolder& folder, Checkpoint& checkpoint, const Stopwatch& watch) {
               test_slits(config, options, checkpoint, tests, watch);
               const Lattice& l = config.lattice;
               const analytic::LatticeFracture rock = square_lattice(l);
               const analytic::CrackedPlate plate =
                   plate_of(l.specimen, l.boundary, l.in_situ, rock);
               const auto test = measure::toughness_test(tests, plate, rock);
               validate(test.rock, "toughness");
               const ToughnessResults results(config, test, checkpoint.manifest(), watch.seconds());
               results.write(folder);
               say_where(options, results.text());
             });
}

int run_random(const CommandLine& options, const RandomToughnessConfig& config,
               const Manifest& manifest) {
  RandomToughnessStudy study(config, options.threads);
  return run(options, config, manifest, study,
             [&](const OutputFolder& folder, Checkpoint& checkpoint, const Stopwatch& watch) {
               ProgressLine progress(options.quiet);
               while (!study.complete()) {
                 study.test_next(progress);
                 checkpoint.save(study, watch);
                 if (interrupted())
                   checkpoint.interrupt(
                       "after the rock of seed " + std::to_string(study.seeds().back().seed),
                       " --rock random");
               }
               const RandomToughnessResults results(config, study, checkpoint.manifest(),
                                                    watch.seconds());
               results.write(folder);
               say_where(options, results.text());
             });
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The modulus and toughness of a square array or of random packings of bonded discs"};
  CommandLine options;
  options.add_to(app);
  std::string rock = "square";
  app.add_option("--rock", rock,
                 "square: slits in a square array; random: slits and running cracks")
      ->check(CLI::IsMember({"square", "random"}));
  std::optional<int> seed, seeds;
  app.add_option("--seed", seed, "of the first random packing: specimen.seed");
  app.add_option("--seeds", seeds, "how many random packings: study.seeds");
  return guarded("toughness", app, [&] {
    app.parse(argc, argv);
    let_waiting_threads_sleep(options.threads, argv);
    if (rock == "square") {
      if (seed || seeds)
        throw InvalidParameter("--seed and --seeds are for --rock random: a square array has none");
      ToughnessConfig config = options.quick ? ToughnessConfig::quick() : ToughnessConfig{};
      options.configure(config);
      return run_square(options, config, manifest("toughness", argc, argv, options.threads));
    }
    RandomToughnessConfig config =
        options.quick ? RandomToughnessConfig::quick() : RandomToughnessConfig{};
    options.configure(config);
    if (seed) config.rock.specimen.seed = *seed;
    if (seeds) config.study.seeds = *seeds;
    config.check();
    config.scheme = config.scheme.resolved();
    const int first = config.rock.specimen.seed, last = first + config.study.seeds - 1;
    return run_random(options, config,
                      manifest("toughness", argc, argv, options.threads,
                               std::to_string(first) + " to " + std::to_string(last)));
  });
}
