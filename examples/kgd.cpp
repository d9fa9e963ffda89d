// The paper's verification model (Section 3.2, Figs. 5 and 6): a crack driven through a square
// array of bonded discs by uniform pressure, or by a fluid that flows.
//
//   build/release/examples/kgd --out out/kgd
//
// You should see, after a few seconds, a crack of 0.80 m that is 77 um wide at the injection,
// beside the paper's 0.770 m and 72.4 um: open out/kgd/report.html. `--quick` runs a small array in
// less than a second; `--help` lists the options. With a fluid of 100 cp, which flows:
//
//   build/release/examples/kgd --scheme implicit --set fluid.viscosity=0.1 --out out/viscous
//
// You should see a crack of 0.480 m that is 140 um wide.
#include <array>
#include <cstdio>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "support/command_line.hpp"
#include "support/kgd_results.hpp"
#include "support/manifest.hpp"
#include "support/polite_threads.hpp"
#include "support/run_loop.hpp"
#include "support/schemes.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

void say_where(const CommandLine& options) {
  if (!options.quiet) std::printf("Open this in a browser: %s/report.html\n", options.out.c_str());
}

template <class Config>
int run(const CommandLine& options, const Config& config, const Manifest& manifest,
        const std::optional<MeasuredToughness>& toughness) {
  const OutputFolder folder(options.out);
  Checkpoint checkpoint(options, manifest, to_toml(config));
  if (!checkpoint.resumes())
    folder.discard({"report.html", "summary.json", "profile.csv", "cracks.csv", "specimen.svg",
                    "length.svg", "aperture.svg", "pressure.svg", "energy.csv"});
  folder.write("config.toml", to_toml(config));
  KgdResults<Config> results(folder, config, checkpoint.manifest(), toughness,
                             checkpoint.resumes());
  std::optional<typename Config::Sim> sim;
  try {
    make_or_resume(sim, checkpoint, square_array(config.specimen), config.simulator);
    sim->use_threads(options.threads);
    drive(*sim, config.run.end_time, results, checkpoint, options.quiet);
  } catch (const RunStopped& reason) {
    sim ? results.finish(*sim, reason.what()) : results.finish_unbegun(reason.what());
    checkpoint.discard();
    std::fprintf(stderr, "kgd: the run stopped: %s\n", reason.what());
    if (!options.quiet) std::printf("%s", results.text().c_str());
    say_where(options);
    return run_stopped;
  }
  results.finish(*sim, {});
  checkpoint.discard();
  if (!options.quiet) std::printf("%s", results.text().c_str());
  say_where(options);
  return success;
}

/// With a scheme, as the options ask for.
template <class Pressure>
int run(const CommandLine& options, const Manifest& manifest, const std::string& toughness) {
  using Config = KgdConfig<Pressure>;
  Config config = options.quick ? Config::quick() : Config{};
  options.configure(config);
  config.simulator.scheme = resolved(config.simulator.scheme);
  std::optional<MeasuredToughness> measured;
  if (!toughness.empty()) measured = read_toughness(toughness);
  return run(options, config, manifest, measured);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"A fluid-driven crack through a square array of bonded discs"};
  CommandLine options;
  options.add_to(app);
  SchemeChoice scheme;
  scheme.add_to(app, std::array{"uniform", "conventional", "implicit"});
  std::string toughness;
  app.add_option(
         "--toughness", toughness,
         "what slits measured (toughness.toml of the program toughness), to predict the run")
      ->check(CLI::ExistingFile)
      ->excludes(app.get_option("--resume"));
  return guarded("kgd", app, [&] {
    app.parse(argc, argv);
    let_waiting_threads_sleep(options.threads, argv);
    const Manifest made = manifest("kgd", argc, argv, options.threads);
    const std::string name = scheme.name(options, "uniform");
    if (name == "conventional") return run<ConventionalFlow<>>(options, made, toughness);
    if (name == "implicit") return run<ImplicitFlow<>>(options, made, toughness);
    return run<UniformPressure>(options, made, toughness);
  });
}
