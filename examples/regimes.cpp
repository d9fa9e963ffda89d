// From the toughness vertex to the viscosity vertex, and from storage to leak-off (the paper's
// Fig. 4): cracks that fluids of several viscosities drive through square arrays, some of them with
// Carter's leak-off, beside the KGD fracture of the modulus and the toughness that slits in the
// same arrays have.
//
//   build/release/examples/regimes --out out/regimes
//
// You should see, after some minutes, nine cracks in all four regimes whose half-lengths are within
// a disc or 5 % of the reference (8 % with leak-off), and whose openings and efficiencies are
// within 8 %: open out/regimes/report.html.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "support/checkpoint.hpp"
#include "support/command_line.hpp"
#include "support/interrupts.hpp"
#include "support/manifest.hpp"
#include "support/polite_threads.hpp"
#include "support/progress.hpp"
#include "support/regimes_results.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

/// The study as far as it is done.
struct Study {
  std::vector<std::vector<measure::SlitTest>> slits;  ///< of each rock
  std::vector<CrackReading> cracks;

  void exchange(auto& archive) { archive(slits, cracks); }
};

/// What is left of the work, roughly: both the discs and the steps that they need grow with the
/// sides.
class Work {
 public:
  Work(const RegimesConfig& config, bool quiet)
      : config_(config),
        all_(slits_of(config.rocks().size()) + cracks_of(config.cracks_run())),
        line_(quiet) {}

  void show(const Study& study, double part, const std::string& where) {
    double done = cracks_of(study.cracks.size()) +
                  part * (cracks_of(study.cracks.size() + 1) - cracks_of(study.cracks.size()));
    for (const auto& tests : study.slits)
      done += slits_of(1) * static_cast<double>(tests.size()) / config_.slits.count;
    line_.show(done / all_, where);
  }

 private:
  double slits_of(std::size_t rocks) const {
    constexpr double a_slit = 4;  // takes as long as so many cracks
    return a_slit * static_cast<double>(rocks) * config_.slits.count *
           std::pow(config_.study.slit_discs, 3);
  }
  double cracks_of(std::size_t number) const {
    double sum = 0;
    for (std::size_t k = 0; k < std::min(number, config_.cracks_run()); ++k)
      sum += std::pow(config_.cracks[k].discs, 3);
    return sum;
  }

  const RegimesConfig& config_;
  double all_;
  ProgressLine line_;
};

/// Nothing if the program was asked to stop.
/// @param progress is told which part of the run is done
template <class Progress>
std::optional<CrackReading> crack(const RegimesConfig& config, const RegimeCase& c, int threads,
                                  Progress&& progress) {
  const double begin = (1 - config.study.window) * c.time;
  const double end = (1 + config.study.window) * c.time;
  const RegimeRock& rock = config.rock(c.rock);
  CrackWatch watch(begin, rock.across, c.pressure_floor);
  try {
    RegimeArray sim(square_array(rock.lattice(c.discs).specimen), config.params(c));
    sim.use_threads(threads);
    const bool ended = sim.run_until(end, watch, [&](const RegimeArray& now) {
      progress(now.time() / end);
      return !interrupted();
    });
    if (!ended) return {};
    return watch.reading(sim);
  } catch (const RunStopped& reason) {
    return CrackReading{.stopped = reason.what()};
  }
}

/// Does what is not done yet.
/// @throws Interrupted if the program was asked to stop
void complete(Study& study, const RegimesConfig& config, const CommandLine& options,
              Checkpoint& checkpoint, const Stopwatch& watch) {
  Work work(config, options.quiet);
  const auto rocks = config.rocks();
  study.slits.resize(rocks.size());
  for (std::size_t r = 0; r < rocks.size(); ++r) {
    auto& tests = study.slits[r];
    while (tests.size() < static_cast<std::size_t>(config.slits.count)) {
      work.show(study, 0, "slits");
      tests.push_back(next_slit_test(config.slits_of(rocks[r]), tests, options.threads));
      checkpoint.save(study, watch);
      if (interrupted()) checkpoint.interrupt("after a slit");
    }
  }
  while (study.cracks.size() < config.cracks_run()) {
    const std::string name(RegimesConfig::names[study.cracks.size()]);
    const auto reading = crack(config, config.cracks[study.cracks.size()], options.threads,
                               [&](double part) { work.show(study, part, name); });
    if (!reading) checkpoint.interrupt("in the run " + name);
    study.cracks.push_back(*reading);
    checkpoint.save(study, watch);
  }
}

int run(const CommandLine& options, const RegimesConfig& config, const Manifest& made) {
  Checkpoint checkpoint(options, made, to_toml(config));
  const OutputFolder folder(options.out);
  folder.discard(RegimesResults::files());
  folder.write("config.toml", to_toml(config));
  Study study;
  Stopwatch watch;
  checkpoint.resumes() ? checkpoint.load(study, watch) : checkpoint.save(study, watch);
  complete(study, config, options, checkpoint, watch);
  std::vector<analytic::LatticeFracture> rocks;
  for (std::size_t r = 0; r < study.slits.size(); ++r)
    rocks.push_back(fracture_of(config.slits_of(config.rocks()[r]), study.slits[r]));
  const RegimesResults results(config, rocks, study.cracks, checkpoint.manifest(), watch.seconds());
  results.write(folder);
  checkpoint.discard();
  if (!options.quiet)
    std::printf("%sOpen this in a browser: %s/report.html\n", results.text().c_str(),
                options.out.c_str());
  return results.complete() ? success : run_stopped;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Cracks from the toughness vertex to the viscosity vertex, beside the KGD fracture"};
  CommandLine options;
  options.add_to(app);
  return guarded("regimes", app, [&] {
    app.parse(argc, argv);
    let_waiting_threads_sleep(options.threads, argv);
    RegimesConfig config;
    if (options.quick) config.shrink();
    options.configure(config);
    return run(options, config, manifest("regimes", argc, argv, options.threads));
  });
}
