/// @file
/// Progress on a terminal, with an estimate of the time left.
#pragma once

#include <chrono>
#include <cstdio>
#include <unistd.h>

namespace hfdem::support {

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// An observer that rewrites one line on standard error, five times a second, if that is a
/// terminal.
class Progress {
 public:
  Progress(double end_time, bool quiet) : end_(end_time), shown_(!quiet && isatty(2) == 1) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { clear(); }

  template <class Sim>
  void operator()(const Sim& sim) {
    if (!shown_ || watch_.seconds() < next_) return;
    next_ = watch_.seconds() + 0.2;
    const double done = sim.time() / end_;
    std::fprintf(stderr, "\r  t = %.3f of %.3g s  %3.0f %%  about %.0f s left   ", sim.time(), end_,
                 100 * done, watch_.seconds() * (1 - done) / done);
    written_ = true;
  }

  void clear() {
    if (written_) std::fprintf(stderr, "\r%60s\r", "");
    written_ = false;
  }

 private:
  double end_, next_ = 0.5;
  bool shown_, written_ = false;
  Stopwatch watch_;
};

}  // namespace hfdem::support
