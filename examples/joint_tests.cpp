// Tests of a joint: random specimens that one smooth joint cuts from side to side are compressed
// under two confinements, and the stress at which it slips stands beside the law of Coulomb.
//
//   build/release/examples/joint_tests --out out/joint_tests
//
// You should see, within two minutes, residual strengths within 1 % of Coulomb's at 45, 60 and 70
// degrees, peaks within 3 % and stiffnesses per metre of joint within 2 % of the parameters.
#include <cstdio>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "support/command_line.hpp"
#include "support/joint_tests_results.hpp"
#include "support/manifest.hpp"
#include "support/polite_threads.hpp"
#include "support/progress.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

int run(const CommandLine& options, const JointTestsConfig& config, const Manifest& made) {
  const OutputFolder folder(options.out);
  folder.discard(JointTestsResults::files);
  folder.write("config.toml", to_toml(config));
  std::vector<JointTestResult> tests;
  ProgressLine progress(options.quiet);
  const auto all =
      static_cast<double>(config.angles.size() * config.confinements().size()) * config.study.seeds;
  for (const double angle : config.angles)
    for (const double confinement : config.confinements())
      for (int k = 0; k < config.study.seeds; ++k) {
        progress.show(static_cast<double>(tests.size()) / all,
                      "joint at " + to_text(angle) + " degrees");
        tests.push_back(
            joint_test(config, angle, confinement, config.specimen.seed + k, options.threads));
      }
  const JointTestsResults results(config, tests, made);
  results.write(folder);
  if (!options.quiet)
    std::printf("%sOpen this in a browser: %s/report.html\n", results.text().c_str(),
                options.out.c_str());
  return success;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Strength and stiffness of a joint through a random specimen"};
  CommandLine options;
  options.add_to(app);
  return guarded("joint_tests", app, [&] {
    app.parse(argc, argv);
    let_waiting_threads_sleep(options.threads, argv);
    JointTestsConfig config = options.quick ? JointTestsConfig::quick() : JointTestsConfig{};
    options.configure(config);
    return run(options, config,
               manifest("joint_tests", argc, argv, options.threads,
                        "from " + std::to_string(config.specimen.seed) + " on"));
  });
}
