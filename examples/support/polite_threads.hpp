/// @file
/// Threads that sleep while they wait.
#pragma once

#include <cstdlib>
#include <unistd.h>

namespace hfdem::support {

/// By default a waiting OpenMP thread spins for milliseconds; on a machine with other work it keeps
/// the very thread that it waits for from running, and a run becomes a hundred times slower. OpenMP
/// reads its settings before `main`, so the program starts itself anew with the polite one, unless
/// the user has chosen. Call before anything else.
inline void let_waiting_threads_sleep(int threads, char** argv) {
  if (threads < 2 || std::getenv("OMP_WAIT_POLICY") != nullptr) return;
  setenv("OMP_WAIT_POLICY", "passive", 1);
  execv("/proc/self/exe", argv);
  // Where that is not to be had, the run is only slower.
}

}  // namespace hfdem::support
