// What moves the result: one parameter at a time is changed in a crack through intact rock, over
// several seeds, and the changes stand in a table.
//
//   build/release/examples/sensitivity --out out/sensitivity --seeds 3
//
// You should see, after half an hour, that the moments in the bonds matter most and that friction
// and damping hardly do. `--vary section.key=value` (repeatable) studies parameters of your choice.
#include <cstdio>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "support/checkpoint.hpp"
#include "support/command_line.hpp"
#include "support/interrupts.hpp"
#include "support/manifest.hpp"
#include "support/polite_threads.hpp"
#include "support/progress.hpp"
#include "support/rock_figures.hpp"
#include "support/rock_recorder.hpp"
#include "support/sensitivity_results.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

/// Of one rock; not numbers if its run stopped, nothing if the program was asked to stop.
std::optional<std::vector<double>> readings_of(const IntactConfig& config, int threads,
                                               const std::vector<RockReading>& readings) {
  std::ostringstream history;
  RockRecorder recorder(config, history);
  std::optional<Rock> sim;
  bool whole = true;
  const RunEnd end = end_of(sim, [&] {
    sim.emplace(random_packing(config.specimen, threads), config.simulator);
    sim->use_threads(threads);
    recorder.begin();
    whole =
        sim->run_until(config.run.end_time, recorder, [](const Rock&) { return !interrupted(); });
  });
  if (!whole) return {};
  if (!end.stopped.empty()) return std::vector<double>(readings.size(), NAN);
  const RockOutcome outcome = recorder.outcome(*sim, end);
  std::vector<double> values;
  for (const RockReading& r : readings) values.push_back(r.read(outcome, recorder.growth()));
  return values;
}

IntactConfig varied(IntactConfig config, const Variation& variation) {
  for (const std::string& a : variation.assignments) apply(config, read_assignment(a));
  validate_all(config);
  config.simulator.scheme = config.simulator.scheme.resolved();
  return config;
}

std::string report(const IntactConfig& base, const SensitivityResults& results, int seeds,
                   const Manifest& made) {
  observe::Report page;
  page.title = "What moves the result";
  page.lead = "One parameter at a time, " + std::to_string(seeds) +
              " rocks each: " + described(base, base.specimen.grains.value_or(0));
  page.program = "hfdem " + made.version + ", program " + made.program;
  observe::Table table = results.table();
  table.caption =
      "First row: means. Below: mean changes, rock by rock, with the 95 % interval of Student's t. "
      "Tips, microcracks and tortuosity at 0.6 s, or when the crack reached the rim before.";
  page.table(table);
  add_origin(page, base,
             {{"table.md", "the table above, for documents"},
              {"runs.csv", "every reading of every run"},
              {"config.toml", "the parameters of the first row"}},
             made);
  return page.html();
}

int run(const CommandLine& options, const IntactConfig& base, std::vector<Variation> rows,
        int seeds, const Manifest& made) {
  // What is studied belongs to the run as its parameters do.
  std::string study = "\n[study]\nseeds = " + std::to_string(seeds),
              again = " --seeds " + std::to_string(seeds);
  for (const Variation& row : rows)
    for (const std::string& a : row.assignments) study += "\nvary " + a;
  Checkpoint checkpoint(options, made, to_toml(base) + study);
  const OutputFolder folder(options.out);
  folder.discard({"report.html", "table.md", "runs.csv"});
  folder.write("config.toml", to_toml(base));
  rows.insert(rows.begin(), {"base", {}});
  for (const Variation& row : rows) varied(base, row);  // refuses before any run
  const auto readings = sensitivity_readings();
  checkpoint.resumes() ? checkpoint.load(rows) : checkpoint.save(rows);
  ProgressLine progress(options.quiet);
  std::size_t done = 0;
  for (Variation& row : rows) {
    IntactConfig config = varied(base, row);
    for (int s = 0; s < seeds; ++s) {
      progress.show(static_cast<double>(done++) / (static_cast<double>(rows.size()) * seeds),
                    row.name);
      if (static_cast<std::size_t>(s) < row.readings.size()) continue;  // before it was resumed
      config.specimen.seed = base.specimen.seed + s;
      const auto values = readings_of(config, options.threads, readings);
      if (!values)
        checkpoint.interrupt("in the row \"" + row.name + "\"", again + " and the same --vary");
      row.readings.push_back(*values);
      checkpoint.save(rows);
    }
  }
  const SensitivityResults results(rows, readings);
  folder.write("table.md", results.markdown());
  folder.write("runs.csv", results.csv(base.specimen.seed));
  folder.write("report.html", report(base, results, seeds, checkpoint.manifest()));
  checkpoint.discard();
  if (!options.quiet)
    std::printf("%sOpen this in a browser: %s/report.html\n", results.markdown().c_str(),
                options.out.c_str());
  return success;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"What one parameter at a time does to a crack in intact rock"};
  CommandLine options;
  options.add_to(app);
  int seeds = 3;
  std::vector<std::string> chosen;
  app.add_option("--seeds", seeds, "rocks for each row, from specimen.seed on")
      ->check(CLI::Range(1, 1000));
  app.add_option("--vary", chosen, "section.key=value: a row of the table (repeatable)")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  return guarded("sensitivity", app, [&] {
    app.parse(argc, argv);
    let_waiting_threads_sleep(options.threads, argv);
    IntactConfig config;
    config.run.end_time = 0.6;
    config.readings = {.propagation_from = 0.3, .propagation_to = 0.6};
    if (options.quick) config.shrink();
    options.configure(config);
    config.simulator.scheme = config.simulator.scheme.resolved();
    std::vector<Variation> rows;
    for (const std::string& assignment : chosen) rows.push_back({assignment, {assignment}});
    return run(
        options, config, rows.empty() ? usual_variations() : rows, seeds,
        manifest("sensitivity", argc, argv, options.threads, std::to_string(config.specimen.seed)));
  });
}
