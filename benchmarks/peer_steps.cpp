/// @file
/// hfdem's side of the comparison in peers/compare.py: the paper's rock is written to a file, or
/// the mechanical steps of a rock, of a file or the paper's, are timed.
///
///   peer_steps --make rock.txt [--discs 17511]
///   peer_steps [rock.txt] --steps 2000 [--threads 2]
///
/// You should see the number of contacts and the nanoseconds of a contact in a step, as JSON.
#include <cstdio>
#include <string>

#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/setup/specimen_file.hpp>

#include <CLI/CLI.hpp>

#include "free_rock.hpp"
#include "side_by_side.hpp"
#include "support/polite_threads.hpp"
#include "tiled_specimens.hpp"

int main(int argc, char** argv) {
  CLI::App app{"Makes a specimen file, or times the mechanical steps of one"};
  std::string file, made;
  std::size_t discs = 17511;
  int steps = 2000, threads = 1;
  app.add_option("specimen", file, "specimen file");
  app.add_option("--make", made, "writes the paper's rock to this file");
  app.add_option("--discs", discs, "how many discs it has");
  app.add_option("--steps", steps, "mechanical steps that are timed");
  app.add_option("--threads", threads, "number of threads");
  CLI11_PARSE(app, argc, argv);
  hfdem::support::let_waiting_threads_sleep(threads, argv);
  if (!made.empty()) {
    hfdem::save_specimen(made, random_rock(discs));
    return 0;
  }
  FreeRock<hfdem::LinearParallelBond> rock(file.empty() ? random_rock(discs)
                                                        : hfdem::load_specimen(file));
  rock.steps(steps / 10 + 1, threads);
  const double time = seconds([&] { rock.steps(steps, threads); });
  std::printf("{\"contacts\": %zu, \"ns_per_contact_step\": %.4f}\n", rock.contacts(),
              1e9 * time / (steps * static_cast<double>(rock.contacts())));
}
