/// @file
/// A run from its begin, or from its checkpoint, to its end:
///
///     std::optional<Sim> sim;                        // outlives whatever stops the run
///     make_or_resume(sim, checkpoint, specimen, params);
///     drive(*sim, end_time, results, checkpoint, quiet);
#pragma once

#include <optional>

#include <hfdem/base/fields.hpp>

#include "support/checkpoint.hpp"
#include "support/interrupts.hpp"
#include "support/progress.hpp"

namespace hfdem::support {

/// Makes a simulator: settled, or as it was saved.
/// @throws as its constructors do
template <class Sim, class Specimen>
void make_or_resume(std::optional<Sim>& sim, Checkpoint& checkpoint, const Specimen& specimen,
                    const typename Sim::Params& params) {
  if (checkpoint.resumes())
    sim.emplace(specimen, params, checkpoint.saved());
  else
    sim.emplace(specimen, params);
}

/// Runs to the end, saving now and then.
/// @param results an observer with `begin(sim)`, for what it does before the first step of a run,
///   and `exchange(archive)`; it does not end the run
/// @throws Interrupted if the program was asked to stop: it has saved then
/// @throws RunStopped when the run cannot go on
template <class Sim, class Results>
void drive(Sim& sim, double end_time, Results& results, Checkpoint& checkpoint, bool quiet) {
  if (checkpoint.resumes()) {
    checkpoint.load(results);
  } else {
    results.begin(sim);
    checkpoint.save(sim, results);
  }
  const bool ended =
      sim.run_until(end_time, results, Progress(end_time, quiet), [&](const Sim& now) {
        const bool stop = interrupted();
        if (stop || checkpoint.is_due()) checkpoint.save(now, results);
        return !stop;
      });
  if (!ended) checkpoint.interrupt("at t = " + in_words(sim.time()) + " s");
}

}  // namespace hfdem::support
