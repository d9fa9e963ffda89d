/// @file
/// What a disc costs in a mechanical step as rocks grow, beside the paper's rock of 17,511 discs,
/// which takes turns with each of them; and how much memory that needs.
///
///   scaling [--discs N ...] [--rounds 5]
///
/// You should see a rock of ten million discs cost at most 6 times as much per disc as the paper's,
/// and fit into 8 GiB.
#include <algorithm>
#include <cstdio>
#include <sys/resource.h>
#include <vector>

#include <hfdem/contact/linear_parallel_bond.hpp>

#include <CLI/CLI.hpp>

#include "free_rock.hpp"
#include "side_by_side.hpp"
#include "support/polite_threads.hpp"
#include "tiled_specimens.hpp"

namespace {

using Rock = FreeRock<hfdem::LinearParallelBond>;

/// The most memory that the program has had so far, GiB.
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / (1024 * 1024);
}

void measure(Rock& paper, std::size_t discs, int rounds) {
  Rock rock(random_rock(discs));
  const auto steps_of = [](const Rock& r) {
    return std::max(1, static_cast<int>(2e6 / static_cast<double>(r.discs())));
  };
  const int steps = steps_of(rock), steps_of_paper = steps_of(paper);
  rock.steps(steps, 1);
  InTurns times;
  for (int k = 0; k < rounds; ++k)
    times.round([&] { rock.steps(steps, 1); }, [&] { rock.steps(steps, 2); },
                [&] { paper.steps(steps_of_paper, 1); }, [&] { paper.steps(steps_of_paper, 2); });
  const double work = static_cast<double>(rock.discs()) * steps;
  const double over = static_cast<double>(paper.discs()) * steps_of_paper / work;
  std::printf("| %zu | %zu | %.1f | %.1f | %.2f | %.2f | %.2f |\n", rock.discs(), rock.contacts(),
              1e9 * times.time(0) / work, 1e9 * times.time(1) / work, over * times.ratio(0, 2),
              over * times.ratio(1, 3), peak_memory());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Cost of a disc in a mechanical step against the number of discs"};
  std::vector<std::size_t> sizes{10000, 100000, 1000000, 10000000};
  int rounds = 5;
  app.add_option("--discs", sizes, "how many discs the rocks have");
  app.add_option("--rounds", rounds, "how often everything is timed");
  CLI11_PARSE(app, argc, argv);
  hfdem::support::let_waiting_threads_sleep(2, argv);
  Rock paper(random_rock(17511));
  paper.steps(100, 1);
  std::printf(
      "| discs | contacts | ns per disc and step | on 2 threads | over 17511 discs "
      "| on 2 threads | peak memory GiB |\n"
      "|---|---|---|---|---|---|---|\n");
  for (const std::size_t discs : sizes) measure(paper, discs, rounds);
}
