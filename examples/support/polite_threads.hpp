/// @file
/// Threads that sleep when they have to wait long.
#pragma once

#include <cstdlib>
#include <unistd.h>

namespace hfdem::support {

/// By default a waiting OpenMP thread spins for many milliseconds; on a machine with other work it
/// keeps the very thread that it waits for from running, and a run becomes a hundred times slower.
/// One that sleeps at once is woken late in every mechanical step, which takes a tenth of a
/// millisecond. These spin about as long as such a step takes, then sleep. OpenMP reads its
/// settings before `main`, so the program starts itself anew with the polite ones, unless the user
/// has chosen. Call before anything else.
inline void let_waiting_threads_sleep(int threads, char** argv) {
  if (threads < 2 || std::getenv("OMP_WAIT_POLICY") != nullptr ||
      std::getenv("GOMP_SPINCOUNT") != nullptr)
    return;
  setenv("OMP_WAIT_POLICY", "passive", 1);
  setenv("GOMP_SPINCOUNT", "3000", 1);  // g++'s threads; clang's know the other setting alone
  execv("/proc/self/exe", argv);
  // Where that is not to be had, the run is only slower.
}

}  // namespace hfdem::support
