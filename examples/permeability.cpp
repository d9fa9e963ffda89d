// How permeable the paper's rock is: random specimens under its in-situ stress, steady flow along
// both axes through channels as wide as their contacts are pressed.
//
//   build/release/examples/permeability --seeds 5 --out out/permeability
//
// You should see, within a minute, means with their 95 % intervals: 5e-16 m2, half a
// millidarcy. `--quick` takes a tenth of the area; `--set in_situ.xx=0` another stress.
#include <cstdio>
#include <string>
#include <vector>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/measure/permeability.hpp>
#include <hfdem/measure/sample_mean.hpp>
#include <hfdem/neighbours/kd_tree.hpp>
#include <hfdem/pressure/dry.hpp>
#include <hfdem/setup/random_packing.hpp>
#include <hfdem/simulator.hpp>

#include <CLI/CLI.hpp>

#include "support/command_line.hpp"
#include "support/output_folder.hpp"
#include "support/polite_threads.hpp"
#include "support/settings.hpp"
#include "support/summary.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

struct PermeabilityConfig : SectionTree<PermeabilityConfig> {
  using Sim = Simulator<LinearParallelBond, HyperbolicAperture, Dry, KdTree>;

  RandomPacking specimen{.grains = 17511};
  Sim::Params simulator{.in_situ = {.xx = 10e6, .yy = 12e6}};

  template <class Self, class F>
  static void visit(Self& self, F& f) {
    f("specimen", self.specimen);
    hfdem::for_each_section(self.simulator, f);
  }
};

int run(const CommandLine& options, PermeabilityConfig config, int seeds) {
  const OutputFolder folder(options.out);
  folder.discard({"permeability.csv", "summary.json"});
  folder.write("config.toml", to_toml(config));
  std::string table = "seed,along_x_m2,along_y_m2\n";
  std::vector<double> x, y;
  const HyperbolicAperture law(config.simulator.aperture);
  for (int k = 0; k < seeds; ++k, ++config.specimen.seed) {
    PermeabilityConfig::Sim sim(random_packing(config.specimen, options.threads), config.simulator);
    const auto rock = measure::permeability(sim, law);
    x.push_back(rock.along_x), y.push_back(rock.along_y);
    table += std::to_string(config.specimen.seed) + ',' + to_text(rock.along_x) + ',' +
             to_text(rock.along_y) + '\n';
    if (!options.quiet)
      std::printf("seed %d: %.3e m2 along x, %.3e m2 along y\n", config.specimen.seed, rock.along_x,
                  rock.along_y);
  }
  Summary summary;
  summary.set("rocks", seeds);
  const auto say = [&](const std::string& name, const std::vector<double>& values) {
    const auto mean = measure::SampleMean::of(values);
    summary.set(name + "/mean_m2", mean.mean);
    summary.set(name + "/ci95_m2", mean.ci95);
    if (!options.quiet && seeds > 1)
      std::printf("%s: %.3e +- %.1e m2 (mean of %d rocks, 95 %% interval)\n", name.c_str(),
                  mean.mean, mean.ci95, seeds);
  };
  say("along_x", x);
  say("along_y", y);
  folder.write("permeability.csv", table);
  folder.write("summary.json", summary.json());
  return success;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Permeability of random rock whose intact contacts conduct"};
  CommandLine options;
  options.add_to(app);
  int seeds = 1;
  app.add_option("--seeds", seeds, "how many rocks, from specimen.seed on")
      ->check(CLI::Range(1, 10000));
  return guarded("permeability", app, [&] {
    app.parse(argc, argv);
    let_waiting_threads_sleep(options.threads, argv);
    PermeabilityConfig config;
    if (options.quick) {
      config.specimen.width = config.specimen.height = 0.32;
      config.specimen.grains = 1800;
    }
    options.configure(config);
    return run(options, config, seeds);
  });
}
