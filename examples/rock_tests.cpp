// What the micro-parameters make of the random specimen as a rock: unconfined, biaxial, tensile and
// Brazilian tests, with the paper's values beside them (its Table 2).
//
//   build/release/examples/rock_tests --out out/rock --threads 2
//
// You should see, after some minutes, E = 30 GPa beside the paper's 29.1, and a tensile strength of
// 4.8 MPa beside 4.8: open out/rock/report.html. `--seeds 10 --seed 1` says how many specimens and
// from which seed on; `--quick` tests a small one in seconds.
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <hfdem/base/parallel.hpp>

#include <CLI/CLI.hpp>

#include "support/checkpoint.hpp"
#include "support/command_line.hpp"
#include "support/interrupts.hpp"
#include "support/manifest.hpp"
#include "support/polite_threads.hpp"
#include "support/progress.hpp"
#include "support/rock_tests_results.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

/// Test `which` of a specimen, as `SpecimenTests` numbers them.
template <class Contact>
measure::RockTest run_test(const RockTestsConfig& config, int specimen, std::size_t which) {
  ScatteredParallelBond::Params micro = config.contact;
  micro.strength_seed += specimen;
  const Contact law(micro);
  const RandomPacking packing = config.packing(specimen);
  const auto& [frame, mechanics] = std::tie(config.load_frame, config.mechanics);
  if (which == 0) return measure::direct_tension(random_packing(packing), law, frame, mechanics);
  if (which == 1)
    return measure::brazilian(brazilian_disc(config.brazilian, packing), config.brazilian, law,
                              frame, mechanics);
  return measure::compression(random_packing(packing), law,
                              config.study.confinement(static_cast<int>(which) - 2), frame,
                              mechanics);
}

/// What the tests have come to so far.
struct TestsSoFar {
  std::vector<SpecimenTests> specimens{};
  std::vector<bool> done{};  ///< specimen by specimen
  Stopwatch watch{};

  explicit TestsSoFar(const RockTestsConfig& config)
      : specimens(static_cast<std::size_t>(config.study.seeds)),
        done(specimens.size() * each(config)) {
    for (std::size_t k = 0; k < specimens.size(); ++k) {
      specimens[k].seed = config.specimen.seed + static_cast<int>(k);
      specimens[k].compression.resize(each(config) - 2);
    }
  }

  /// Tests of one specimen.
  static std::size_t each(const RockTestsConfig& config) {
    return static_cast<std::size_t>(3 + config.study.confinements);
  }

  void exchange(auto& archive) { archive(specimens, done, watch); }
};

/// Makes all tests that are not done; each result is that of its specimen alone.
/// @throws InvalidParameter if the specimens, or the first of their tests, cannot be as wanted
/// @throws Interrupted if the program was asked to stop: it has saved then
template <class Contact>
void run_tests(const RockTestsConfig& config, int threads, bool quiet, Checkpoint& checkpoint,
               TestsSoFar& tests) {
  ProgressLine progress(quiet);
  std::mutex one_at_a_time;
  std::optional<InvalidParameter> refused;
  std::exception_ptr unsaved;
  std::atomic<bool> useless = false;
  for_tasks(tests.done.size(), threads, [&](std::size_t task) {
    if (useless || interrupted()) return;
    const std::size_t specimen = task / TestsSoFar::each(config);
    const std::size_t which = task % TestsSoFar::each(config);
    {
      const std::lock_guard lock(one_at_a_time);
      if (tests.done[task]) return;
    }
    measure::RockTest result;
    std::string stopped;
    try {
      result = run_test<Contact>(config, static_cast<int>(specimen), which);
    } catch (const RunStopped& reason) {
      stopped = reason.what();
    } catch (const InvalidParameter& reason) {
      const std::lock_guard lock(one_at_a_time);
      refused = reason;
      useless = true;
      return;
    }
    const std::lock_guard lock(one_at_a_time);
    tests.specimens[specimen].test(which) = std::move(result);
    if (!stopped.empty()) tests.specimens[specimen].stopped = stopped;
    tests.done[task] = true;
    try {
      if (checkpoint.is_due()) checkpoint.save(tests);
    } catch (const OutputFailed&) {  // must not leave the parallel loop
      unsaved = std::current_exception();
      useless = true;
    }
    const auto done = static_cast<double>(std::count(tests.done.begin(), tests.done.end(), true));
    progress.show(done / static_cast<double>(tests.done.size()),
                  in_words(done) + " of " + std::to_string(tests.done.size()) + " tests");
  });
  if (refused) throw *refused;
  if (unsaved) std::rethrow_exception(unsaved);
  if (!interrupted()) return;
  checkpoint.save(tests);
  checkpoint.interrupt("between two tests");
}

/// @throws InvalidParameter if the last seed would be none
void check_seeds(const RockTestsConfig& config) {
  const int largest = std::numeric_limits<int>::max() - config.study.seeds;
  const auto check = [largest](const char* section, const char* field, int seed) {
    if (seed > largest)
      refuse(section, field, std::to_string(seed),
             "at most " + std::to_string(largest) + ", as study.seeds follow");
  };
  check("specimen", "seed", config.specimen.seed);
  check("contact", "strength_seed", config.contact.strength_seed);
}

int run(const CommandLine& options, const RockTestsConfig& config, const Manifest& manifest) {
  Checkpoint checkpoint(options, manifest, to_toml(config));
  const OutputFolder folder(options.out);
  folder.discard(RockTestsResults::files);
  folder.write("config.toml", to_toml(config));
  TestsSoFar tests(config);
  if (checkpoint.resumes()) checkpoint.load(tests);
  config.contact.weibull_modulus
      ? run_tests<ScatteredParallelBond>(config, options.threads, options.quiet, checkpoint, tests)
      : run_tests<LinearParallelBond>(config, options.threads, options.quiet, checkpoint, tests);
  bool stopped = false;
  std::vector<SpecimenTests> whole;
  for (const SpecimenTests& s : tests.specimens) {
    if (s.stopped.empty()) {
      whole.push_back(s);
      continue;
    }
    stopped = true;
    std::fprintf(stderr, "rock_tests: the specimen of seed %d is left out: %s\n", s.seed,
                 s.stopped.c_str());
  }
  if (whole.empty()) {
    checkpoint.discard();
    return run_stopped;
  }
  const RockTestsResults results(config, whole, checkpoint.manifest(), tests.watch.seconds());
  results.write(folder);
  checkpoint.discard();
  if (!options.quiet)
    std::printf("%sOpen this in a browser: %s/report.html\n", results.text().c_str(),
                options.out.c_str());
  return stopped ? run_stopped : success;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Rock tests on random specimens: moduli and strengths"};
  CommandLine options;
  options.add_to(app);
  std::optional<int> seed, seeds;
  app.add_option("--seed", seed, "the first specimen's (specimen.seed)");
  app.add_option("--seeds", seeds, "how many specimens are tested (study.seeds)");
  return guarded("rock_tests", app, [&] {
    app.parse(argc, argv);
    let_waiting_threads_sleep(options.threads, argv);
    RockTestsConfig config = options.quick ? RockTestsConfig::quick() : RockTestsConfig{};
    options.configure(config);
    config.specimen.seed = seed.value_or(config.specimen.seed);
    config.study.seeds = seeds.value_or(config.study.seeds);
    validate_all(config);
    check_seeds(config);
    const int last = config.specimen.seed + config.study.seeds - 1;
    return run(options, config,
               manifest("rock_tests", argc, argv, options.threads,
                        std::to_string(config.specimen.seed) + " to " + std::to_string(last)));
  });
}
