// A crack through fractured rock (the paper's Section 4.2): 17,500 bonded discs with 18 natural
// fractures among them, and carbon dioxide, whose pressure is uniform (cases N2-S1, N2-S2), or a
// viscous fluid (cases N1-S1, N1-S2).
//
//   build/release/examples/fractured --case N2-S2 --out out/fractured
//
// You should see, within a minute or two, a crack that meets natural fractures, follows some of
// them and leaves others behind: open out/fractured/report.html. `--quick` runs a tenth of the area
// in some seconds; `--fractures` takes fractures of your own; `--help` lists the options.
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "support/fracture_input.hpp"
#include "support/fractured_model.hpp"
#include "support/polite_threads.hpp"
#include "support/rock_program.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

/// From the file, if there is one, or drawn; for a run that goes on, those that it has.
template <class Config>
NamedFractures natural_fractures(const RockOptions& options, const std::string& file,
                                 const Config& config) {
  Vec2 box{config.specimen.width, config.specimen.height};
  if (const std::string discs = options.specimen_file(); !discs.empty()) {
    const Specimen given = load_specimen(discs);
    box = {given.width, given.height};
  }
  const Vec2 injection = config.simulator.injection.position.value_or(0.5 * box);
  NamedFractures fractures;
  if (!options.common.resume.empty())
    fractures = read_fractures(options.common.resume + "/" + fracture_table);
  else if (!file.empty())
    fractures = read_fractures(file);
  else
    fractures.fractures = drawn(config.fractures, box, injection);
  const Vec2 wing =
      config.simulator.crack.length.value_or(0) / 2 * crack_direction(config.simulator.in_situ);
  const double largest_disc = 2 * config.specimen.radius_max;
  check(fractures, box, {injection - wing, injection + wing}, largest_disc);
  return fractures;
}

struct FractureOptions {
  std::string file;
  std::optional<int> seed;
};

template <class Config>
int run(const RockOptions& options, const FractureOptions& wanted, int argc, char** argv) {
  auto config = options.configured<Config>();
  if (wanted.seed) config.fractures.seed = *wanted.seed;
  return RockProgram("fractured", options, config, natural_fractures(options, wanted.file, config))
      .run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"A fluid-driven crack through rock with natural fractures"};
  RockOptions options;
  using Viscous = FracturedRock<ImplicitFlow<>>;
  using Slick = FracturedRock<UniformPressure>;
  options.add_to<Viscous, Slick>(app);
  FractureOptions fractures;
  app.add_option("--fractures", fractures.file,
                 "file with the natural fractures (.csv or .toml), instead of section [fractures]")
      ->check(CLI::ExistingFile)
      ->excludes("--resume");
  app.add_option("--random-fractures", fractures.seed,
                 "draw other fractures: every number is another set (fractures.seed)")
      ->excludes("--fractures")
      ->excludes("--resume");
  return guarded("fractured", app, [&] {
    app.parse(argc, argv);
    let_waiting_threads_sleep(options.common.threads, argv);
    return options.flows<Slick>() ? run<Viscous>(options, fractures, argc, argv)
                                  : run<Slick>(options, fractures, argc, argv);
  });
}
