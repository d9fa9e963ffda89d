// The modulus and the toughness of the verification model's lattice, measured instead of fitted:
// slits of several lengths are held open by a given pressure until the first bond reaches its
// strength.
//
//   build/release/examples/toughness --out out/toughness
//
// You should see, after about a minute, E' = 25.8 GPa, which is 0.76 of Young's modulus, and a
// toughness that grows with the net pressure from 1.68 to 1.84 MPa sqrt(m). The file toughness.toml
// is what `kgd --toughness` reads.
#include <cmath>
#include <cstdio>

#include <CLI/CLI.hpp>

#include "support/checkpoint.hpp"
#include "support/command_line.hpp"
#include "support/manifest.hpp"
#include "support/plate_of_lattice.hpp"
#include "support/polite_threads.hpp"
#include "support/progress.hpp"
#include "support/toughness_results.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

/// Tests the slits that are not among `tests` yet.
/// @throws Interrupted between two slits if the program was asked to stop
void test_slits(const ToughnessConfig& config, const CommandLine& options, Checkpoint& checkpoint,
                std::vector<measure::SlitTest>& tests, const Stopwatch& watch) {
  const Lattice& lattice = config.lattice;
  const double closing = std::fmin(lattice.in_situ.xx, lattice.in_situ.yy);
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
    LatticeSlit slit(square_array(lattice.specimen),
                     {.contact = lattice.contact,
                      .aperture = lattice.aperture,
                      .boundary = lattice.boundary,
                      .in_situ = lattice.in_situ,
                      .mechanics = config.mechanics,
                      .scheme = config.scheme},
                     lengths[tests.size()]);
    slit.use_threads(options.threads);
    // Well below the first break; a longer slit breaks at less pressure, about as 1 / sqrt(a).
    const double start = tests.empty()
                             ? 0.1 * std::fmax(closing, 1e6)
                             : 0.8 * tests.back().net_pressure_at_break *
                                   std::sqrt(tests.back().half_length / slit.half_length());
    tests.push_back(slit.test(start, config.slits.accuracy));
    progress.show(static_cast<double>(tests.size()) / static_cast<double>(lengths.size()),
                  "slit of " + in_words(2 * slit.half_length()) + " m");
    checkpoint.save(tests, watch);
    if (interrupted())
      checkpoint.interrupt("after slit " + std::to_string(tests.size()) + " of " +
                           std::to_string(lengths.size()));
  }
}

int run(const CommandLine& options, const ToughnessConfig& config, const Manifest& manifest) {
  const OutputFolder folder(options.out);
  Checkpoint checkpoint(options, manifest, to_toml(config));
  folder.discard({"report.html", "summary.json", "toughness.toml", "slits.csv", "toughness.svg",
                  "opening.svg"});
  folder.write("config.toml", to_toml(config));
  try {
    Stopwatch watch;
    std::vector<measure::SlitTest> tests;
    if (checkpoint.resumes()) checkpoint.load(tests, watch);
    test_slits(config, options, checkpoint, tests, watch);
    const Lattice& l = config.lattice;
    const analytic::LatticeFracture rock = square_lattice(l);
    const analytic::CrackedPlate plate = plate_of(l.specimen, l.boundary, l.in_situ, rock);
    const auto test = measure::toughness_test(tests, plate, rock);
    validate(test.rock, "toughness");
    const ToughnessResults results(config, test, checkpoint.manifest(), watch.seconds());
    results.write(folder);
    checkpoint.discard();
    if (!options.quiet)
      std::printf("%sOpen this in a browser: %s/report.html\n", results.text().c_str(),
                  options.out.c_str());
    return success;
  } catch (const RunStopped& reason) {
    checkpoint.discard();
    std::fprintf(stderr, "toughness: the run stopped: %s\n", reason.what());
    return run_stopped;
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The modulus and toughness of a square array of bonded discs, by slit tests"};
  CommandLine options;
  options.add_to(app);
  return guarded("toughness", app, [&] {
    app.parse(argc, argv);
    let_waiting_threads_sleep(options.threads, argv);
    ToughnessConfig config = options.quick ? ToughnessConfig::quick() : ToughnessConfig{};
    options.configure(config);
    return run(options, config, manifest("toughness", argc, argv, options.threads));
  });
}
