/// @file
/// Progress on a terminal, with an estimate of the time left.
#pragma once

#include <chrono>
#include <cstdio>
#include <string>
#include <unistd.h>

namespace hfdem::support {

class Stopwatch {
 public:
  double seconds() const {
    return before_ +
           std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  /// The time so far: that of a resumed run goes on.
  template <class Archive>
  void exchange(Archive& archive) {
    double so_far = seconds();
    archive(so_far);
    if constexpr (Archive::loads) {
      before_ = so_far;
      start_ = std::chrono::steady_clock::now();
    }
  }

 private:
  double before_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// One line on standard error, rewritten at most five times a second, if that is a terminal.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet) : shown_(!quiet && isatty(2) == 1) {}
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() {
    if (written_) std::fprintf(stderr, "\r%60s\r", "");
  }

  /// @param done part of the whole, 0 to 1
  void show(double done, const std::string& where) {
    if (begun_ < 0) begun_ = done;  // a resumed run has a part behind it
    if (!shown_ || watch_.seconds() < next_) return;
    next_ = watch_.seconds() + 0.2;
    std::fprintf(stderr, "\r  %s  %3.0f %%", where.c_str(), 100 * done);
    if (done > begun_)
      std::fprintf(stderr, "  about %.0f s left   ",
                   watch_.seconds() * (1 - done) / (done - begun_));
    written_ = true;
  }

 private:
  double next_ = 0.5, begun_ = -1;
  bool shown_, written_ = false;
  Stopwatch watch_;
};

/// An observer of a run.
class Progress {
 public:
  Progress(double end_time, bool quiet) : end_(end_time), line_(quiet) {}

  template <class Sim>
  void operator()(const Sim& sim) {
    char where[64];
    std::snprintf(where, sizeof where, "t = %.3f of %.3g s", sim.time(), end_);
    line_.show(sim.time() / end_, where);
  }

 private:
  double end_;
  ProgressLine line_;
};

}  // namespace hfdem::support
