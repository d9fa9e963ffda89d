/// @file
/// The whole mechanical step, without fluid: contact loop, gather, motion and platens, beside (a)
/// the same arithmetic written by hand, and (b) what the machine's memory allows, a triad over as
/// many bytes as the step has data, all in turns within one run. Discs move freely under 10 and 12
/// MPa; all are bonded.
///
///   mechanics [--discs N ...] [--rounds 15]
///
/// You should see, at 17,511 discs, at most 1.1 times the loop written by hand, two threads at
/// least 1.7 times as fast as one where both have a core to themselves, and at a million discs at
/// least 40 % of what memory allows. With 500 discs everything is in the second-level cache: what
/// is left there is arithmetic.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include <hfdem/contact/incremental_parallel_bond.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>

#include <CLI/CLI.hpp>

#include "by_hand.hpp"
#include "free_rock.hpp"
#include "side_by_side.hpp"
#include "support/polite_threads.hpp"
#include "tiled_specimens.hpp"
#include "triad.hpp"

namespace {

using namespace hfdem;

void measure(const std::string& name, const Specimen& specimen, int rounds) {
  FreeRock<LinearParallelBond> total(specimen);
  FreeRock<IncrementalParallelBond> incremental(specimen);
  ContactsByHand contacts(total.body().contacts(), {});
  DiscsByHand discs(total.body().discs(), total.body().geometry(), total.body().dt(), 0.7);
  const DiscsByHand start = discs;
  std::vector<Pack> rows(1 + total.body().contacts().padded_size(), Pack{});
  const double bytes = total.traffic();
  Triad triad(static_cast<std::size_t>(bytes));
  const auto count = static_cast<double>(total.body().contacts().size());
  const int steps = std::max(1, static_cast<int>(5e6 / count));
  const auto repeat = [&](auto&& work) {
    for (int k = 0; k < steps; ++k) work();
  };
  total.steps(200 + steps, 1);
  incremental.steps(200 + steps, 1);
  InTurns times;
  for (int k = 0; k < rounds; ++k) {
    discs = start;  // at rest their velocities would become numbers that processors are slow at
    times.round([&] { total.steps(steps, 1); }, [&] { total.steps(steps, 2); },
                [&] {
                  repeat([&] {
                    contacts.evaluate(discs.displacement.data(), rows.data() + 1);
                    discs.step(rows.data());
                  });
                },
                [&] { repeat([&] { triad.run(1); }); }, [&] { repeat([&] { triad.run(2); }); },
                [&] { incremental.steps(steps, 1); });
  }
  const double particles = static_cast<double>(specimen.size()) * steps;
  const auto per_contact = [&](std::size_t work) {
    return 1e9 * times.time(work) / (steps * count);
  };
  const double limit = bytes / triad.bytes();
  std::printf(
      "| %s | %zu | %zu | %.2f | %.2f | %.1f | %.1f | %.2f | %.2f | %.2f "
      "| %.0f %% | %.0f %% | %.2f | %.2f |\n",
      name.c_str(), specimen.size(), total.body().contacts().size(), per_contact(0), per_contact(1),
      particles / times.time(0) * 1e-6, particles / times.time(1) * 1e-6, times.ratio(0, 1),
      per_contact(2), times.ratio(0, 2), 100 * limit * times.ratio(3, 0),
      100 * limit * times.ratio(4, 1), times.ratio(3, 4), per_contact(5));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"The mechanical step beside a loop by hand and the memory of this machine"};
  std::vector<std::size_t> sizes{500, 10000, 17511, 100000, 1000000};
  int rounds = 15;
  app.add_option("--discs", sizes, "how many discs the specimens have");
  app.add_option("--rounds", rounds, "how often everything is timed");
  CLI11_PARSE(app, argc, argv);
  hfdem::support::let_waiting_threads_sleep(2, argv);
  std::printf(
      "| specimen | discs | contacts | ns per contact-step | on 2 threads "
      "| 1e6 particle-steps/s | on 2 threads | gain of 2 threads | by hand ns | over by hand "
      "| of the triad | of the triad on 2 threads | triad's gain of 2 threads "
      "| incremental form ns |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::size_t discs : sizes) {
    measure("square", square_rock(discs), rounds);
    measure("random", random_rock(discs), rounds);
  }
}
