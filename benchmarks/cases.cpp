/// @file
/// The nine cases of the paper's Table 4 as a user runs them, with all files written, and where the
/// time goes: mechanics (what a scheme calls a relaxation: contacts, motion, widths), fluid (the
/// rest of the fluid steps), output, and set-up (packing, bonding, flow network, settling).
///
///   cases [--case 2-S1 ...] [--rule equilibrium|paper] [--threads 1]
///
/// You should see mechanics take most of every run, and set-up less than a tenth.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <hfdem/leakoff/matrix_flow.hpp>
#include <hfdem/pressure/implicit.hpp>
#include <hfdem/pressure/uniform.hpp>

#include <CLI/CLI.hpp>

#include "side_by_side.hpp"
#include "support/fractured_model.hpp"
#include "support/leaky_model.hpp"
#include "support/manifest.hpp"
#include "support/natural_fractures.hpp"
#include "support/rock_results.hpp"
#include "support/run_loop.hpp"

namespace {

using namespace hfdem;
using namespace hfdem::support;

/// Seconds that a run has spent where.
struct Shares {
  double set_up = 0, mechanics = 0, steps = 0, output = 0;

  double fluid() const { return std::fmax(0, steps - mechanics); }
  double whole() const { return set_up + steps + output; }
};
Shares shares;

/// A scheme with a clock around its fluid steps, and around what it wants of the mechanics.
template <class Scheme>
class Timed : public Scheme {
 public:
  using Scheme::Scheme;

  template <class Relax>
  FluidStep advance(Network& network, const Injected& injected, Relax&& relax) {
    FluidStep result{};
    shares.steps += seconds([&] {
      result = Scheme::advance(network, injected, [&] {
        Relaxed relaxed{};
        shares.mechanics += seconds([&] { relaxed = relax(); });
        return relaxed;
      });
    });
    return result;
  }
};

/// Results with a clock around what they hear.
template <class Results>
struct TimedResults {
  Results& results;

  template <class Sim>
  void fluid_step(const Sim& sim, const FluidStep& step) {
    shares.output += seconds([&] { results.fluid_step(sim, step); });
  }
};

struct Options {
  std::vector<std::string> cases{"1-S1",  "1-S2",  "2-S1",  "2-S2", "N1-S1",
                                 "N1-S2", "N2-S1", "N2-S2", "L1-S1"};
  std::string rule = "equilibrium";
  bool quick = false;
  int threads = 1;
};

template <class Config>
void run(const std::string& name, const Options& options) {
  Config config;
  config.load_case(name);
  if (options.quick) config.shrink();
  if constexpr (knows_one_pressure<SchemeOf<typename Config::Sim>>)
    if (options.rule == "paper") config.simulator.scheme = {.fluid_dt = 1e-3};
  shares = {};
  const auto folder = std::filesystem::temp_directory_path() / ("hfdem_cases_" + name);
  std::filesystem::remove_all(folder);
  const Vec2 box{config.specimen.width, config.specimen.height};
  NamedFractures fractures;
  if constexpr (requires { config.fractures; })
    fractures.fractures = drawn(config.fractures, box, 0.5 * box);
  std::optional<typename Config::Sim> sim;
  shares.set_up = seconds([&] {
    Specimen rock = random_packing(config.specimen, options.threads);
    put_into(rock, fractures);
    sim.emplace(rock, config.simulator);
    sim->use_threads(options.threads);
  });
  const OutputFolder out(folder);
  const Manifest none{};  // results keep a reference
  RockResults<Config> results(out, config, none, {}, fractures.fractures.size(), false);
  shares.output += seconds([&] { results.begin(*sim); });
  TimedResults<RockResults<Config>> observer{results};
  const RunEnd end = end_of(sim, [&] { sim->run_until(config.run.end_time, observer); });
  shares.output += seconds([&] { results.finish(*sim, end); });
  const auto percent = [&](double part) { return 100 * part / shares.whole(); };
  std::printf("| %s | %.2f s | %.1f s | %ld | %ld | %.0f %% | %.0f %% | %.0f %% | %.0f %% |\n",
              name.c_str(), sim->time(), shares.whole(), sim->fluid_steps(),
              sim->mechanical_steps(), percent(shares.mechanics), percent(shares.fluid()),
              percent(shares.output), percent(shares.set_up));
  std::fflush(stdout);
  sim.reset();
  std::filesystem::remove_all(folder);
}

/// As the programs compose it: the number before the dash is the fluid's, N has natural fractures,
/// L leaks.
void run(const std::string& name, const Options& options) {
  using Slick = Timed<UniformPressure>;
  using Viscous = Timed<ImplicitFlow<>>;
  const bool viscous = name.find('1') < name.find('-');
  if (name.front() == 'L')
    run<LeakyRock<Timed<ImplicitFlow<NewtonianFluid, MatrixFlow>>>>(name, options);
  else if (name.front() == 'N')
    viscous ? run<FracturedRock<Viscous>>(name, options) : run<FracturedRock<Slick>>(name, options);
  else
    viscous ? run<IntactRock<Viscous>>(name, options) : run<IntactRock<Slick>>(name, options);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The paper's nine cases, and where their time goes"};
  Options options;
  app.add_option("--case", options.cases, "cases of the paper's Table 4")
      ->check(CLI::IsMember(options.cases));
  app.add_option("--rule", options.rule, "when fluid steps of uniform pressure end")
      ->check(CLI::IsMember({"equilibrium", "paper"}));
  app.add_option("--threads", options.threads, "number of threads");
  app.add_flag("--quick", options.quick, "a tenth of the area");
  CLI11_PARSE(app, argc, argv);
  std::printf(
      "| case | injected until | whole run | fluid steps | mechanical steps | mechanics | fluid | "
      "output | set-up |\n|---|---|---|---|---|---|---|---|---|\n");
  const double whole = seconds([&] {
    for (const std::string& name : options.cases) run(name, options);
  });
  std::printf("together %.1f s\n", whole);
}
