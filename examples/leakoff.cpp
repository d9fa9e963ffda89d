// A crack through rock that leaks (the paper's Section 5.1, Fig. 17): intact contacts conduct, and
// the voids between the discs are pores. Three runs of one rock: without leak-off (case 1-S1), with
// dry pores (case L1-S1) and with saturated ones.
//
//   build/release/examples/leakoff --case L1-S1 --out out/leakoff
//
// You should see, within some minutes, the three cracks beside each other: open
// out/leakoff/report.html. `--fluid sc-co2` answers what the paper leaves open; `--quick` runs a
// tenth of the area in some seconds; `--seeds 5` gives means and intervals; `--help` lists the
// options.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "support/leakoff_comparison.hpp"
#include "support/leaky_model.hpp"
#include "support/polite_threads.hpp"
#include "support/rock_program.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

using Arguments = std::pair<int, char**>;

/// One rock after the other, each in a folder of its own.
template <class Tight, class Leaky>
class LeakoffStudy {
 public:
  LeakoffStudy(const RockOptions& options, LeakyRock<Leaky> config)
      : options_(options), config_(std::move(config)) {}

  int run(int argc, char** argv) {
    const CommandLine& common = options_.common;
    const bool dry = config_.simulator.leakoff.saturation < 1;
    std::vector<LeakoffPart> parts{{"without", "without leak-off", false}};
    if (dry) parts.push_back({"unsaturated", said_saturation()});
    parts.push_back({"saturated", "saturated pores"});
    const Manifest made = manifest(options_.seeds > 1 ? "leakoff --seeds" : "leakoff", argc, argv,
                                   common.threads, std::to_string(config_.specimen.seed));
    Checkpoint checkpoint(common, made, to_toml(config_) + std::to_string(options_.seeds));
    const OutputFolder folder(common.out);
    folder.discard(LeakoffComparison::files);
    folder.write("config.toml", to_toml(config_));
    int done = 0;
    checkpoint.resumes() ? checkpoint.load(done) : checkpoint.save(done);
    // What an earlier study left unfinished is no part of this one.
    if (!checkpoint.resumes())
      for (const LeakoffPart& part : parts)
        std::filesystem::remove(checkpoint_file(common.out + "/" + part.folder));
    int status = success;
    for (; done < static_cast<int>(parts.size()); checkpoint.save(++done)) {
      const LeakoffPart& part = parts[static_cast<std::size_t>(done)];
      if (!common.quiet) std::printf("%s\n", part.name.c_str());
      RockOptions of_part = options_;
      of_part.common.out = common.out + "/" + part.folder;
      const bool begun = std::filesystem::exists(checkpoint_file(of_part.common.out));
      of_part.common.resume = begun && checkpoint.resumes() ? of_part.common.out : "";
      try {
        status = std::max(status, run_part(part, of_part, {argc, argv}));
      } catch (const Interrupted&) {
        checkpoint.interrupt(part.name, options_.seeds > 1
                                            ? " --seeds " + std::to_string(options_.seeds)
                                            : std::string());
      }
    }
    const std::string first =
        common.out + "/without" +
        (options_.seeds > 1 ? "/seed_" + std::to_string(config_.specimen.seed) : std::string());
    const auto discs = static_cast<long>(load_specimen(first + "/specimen.txt").size());
    const LeakoffComparison comparison(folder, parts, config_.specimen.seed, options_.seeds,
                                       described(config_, discs));
    comparison.write(checkpoint.manifest());
    checkpoint.discard();
    if (!common.quiet)
      std::printf("%sOpen this in a browser: %s/report.html\n", comparison.text().c_str(),
                  common.out.c_str());
    return status;
  }

 private:
  std::string said_saturation() const {
    const double s = config_.simulator.leakoff.saturation;
    return s == 0 ? "dry pores" : "pores " + in_words(100 * s) + " % full";
  }

  int run_part(const LeakoffPart& part, const RockOptions& options, Arguments a) const {
    if (!part.leaks)
      return RockProgram("leakoff", options, tight_twin<Tight>(config_)).run(a.first, a.second);
    LeakyRock<Leaky> config = config_;
    if (part.folder == "saturated") config.simulator.leakoff.saturation = 1;
    return RockProgram("leakoff", options, config).run(a.first, a.second);
  }

  const RockOptions& options_;
  LeakyRock<Leaky> config_;
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"A fluid-driven crack through rock that leaks, beside the same without leak-off"};
  RockOptions options;
  using Flowing = LeakyRock<ImplicitFlow<NewtonianFluid, MatrixFlow>>;
  using Uniform = LeakyRock<LeakyUniformPressure<MatrixFlow>>;
  options.add_to<Flowing, Flowing>(app);
  std::string fluid;
  app.add_option("--fluid", fluid,
                 "viscous (100 cp, case L1-S1) or sc-co2 (carbon dioxide, case L2-S1)")
      ->check(CLI::IsMember({"viscous", "sc-co2"}))
      ->excludes("--case")
      ->excludes("--resume")
      ->excludes("--config");
  return guarded("leakoff", app, [&] {
    app.parse(argc, argv);
    let_waiting_threads_sleep(options.common.threads, argv);
    if (!fluid.empty()) options.which = fluid == "viscous" ? "L1-S1" : "L2-S1";
    if (options.scheme.name(options.common, "implicit") == "implicit")
      return LeakoffStudy<ImplicitFlow<>, ImplicitFlow<NewtonianFluid, MatrixFlow>>(
                 options, options.configured<Flowing>())
          .run(argc, argv);
    return LeakoffStudy<UniformPressure, LeakyUniformPressure<MatrixFlow>>(
               options, options.configured<Uniform>())
        .run(argc, argv);
  });
}
