// A crack through intact rock (the paper's Section 4.1): 17,500 bonded discs of random size and
// place, fractured by carbon dioxide, whose pressure is uniform (cases 2-S1, 2-S2), or by a viscous
// fluid (cases 1-S1, 1-S2).
//
//   build/release/examples/intact --case 2-S1 --out out/intact
//
// You should see, within a minute, a rough crack that leaves the specimen after a second or so:
// open out/intact/report.html. `--quick` runs a tenth of the area in some seconds; `--seed` takes
// another rock; `--help` lists the options.
#include <CLI/CLI.hpp>

#include "support/polite_threads.hpp"
#include "support/rock_program.hpp"

using namespace hfdem::support;

int main(int argc, char** argv) {
  CLI::App app{"A fluid-driven crack through intact rock: bonded discs of random size and place"};
  RockOptions options;
  using Viscous = IntactRock<hfdem::ImplicitFlow<>>;
  options.add_to<Viscous, IntactConfig>(app);
  return guarded("intact", app, [&] {
    app.parse(argc, argv);
    let_waiting_threads_sleep(options.common.threads, argv);
    if (options.flows<IntactConfig>())
      return RockProgram("intact", options, options.configured<Viscous>()).run(argc, argv);
    return RockProgram("intact", options, options.configured<IntactConfig>()).run(argc, argv);
  });
}
