/// @file
/// Sections of a program's parameter file that are not the simulator's own.
#pragma once

#include <tuple>

#include <hfdem/base/fields.hpp>

namespace hfdem::support {

/// How long a run is, and how often it writes.
struct RunOptions {
  double end_time = 0.9;
  double output_interval = 1e-4;
  double snapshot_interval = 0.1;
  bool energy = false;

  static constexpr auto fields() {
    using P = RunOptions;
    return std::tuple{Field{"end_time", &P::end_time, "s", positive, "injection time"},
                      Field{"output_interval", &P::output_interval, "s", positive,
                            "time between two rows of history.csv"},
                      Field{"snapshot_interval", &P::snapshot_interval, "s", positive,
                            "time between two steps of the files for ParaView"},
                      Field{"energy", &P::energy, "", any_number,
                            "keep the books of mechanical energy; several times as slow"}};
  }
};

/// The parameters of a scheme, with its rule's own values where none are given.
template <class SchemeParams>
SchemeParams resolved(const SchemeParams& p) {
  if constexpr (requires { p.resolved(); })
    return p.resolved();
  else
    return p;
}

}  // namespace hfdem::support
