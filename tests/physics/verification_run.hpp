// The default verification run, with what the tests ask of it.
#pragma once

#include <cmath>
#include <vector>

#include <hfdem/hfdem.hpp>

namespace test {

template <class Pressure>
using ArrayRun = hfdem::Simulator<hfdem::LinearParallelBond, hfdem::HyperbolicAperture, Pressure,
                                  hfdem::FixedPairs>;
using Kgd = ArrayRun<hfdem::UniformPressure>;

struct Sample {
  double time, length, opening, net_pressure;
};

/// The advance of both tips from `contacts` to `contacts + 2` broken ones.
struct Advance {
  int contacts;
  double time, net_pressure;
};

struct VerificationRun {
  std::vector<Sample> samples;
  std::vector<Advance> advances;
  hfdem::measure::CrackShape end;
  bool tips_always_equal = true;
  int off_plane = 0;
  long mechanical_steps = 0;

  /// Mean of a sampled quantity over t - 0.02 s to t + 0.02 s.
  double mean(double Sample::*value, double time) const {
    double sum = 0;
    int count = 0;
    for (const Sample& s : samples)
      if (std::abs(s.time - time) <= 0.02 + 1e-9) sum += s.*value, ++count;
    return sum / count;
  }
};

template <class Pressure = hfdem::UniformPressure>
VerificationRun inject(const typename ArrayRun<Pressure>::Params& params,
                       const hfdem::SquareArray& array, double end_time) {
  ArrayRun<Pressure> sim{hfdem::square_array(array), params};
  const double far_field = params.in_situ.xx;
  VerificationRun run;
  const auto look = [&](const ArrayRun<Pressure>& s) {
    const auto shape = hfdem::measure::crack_shape(s);
    run.samples.push_back(
        {s.time(), shape.full_length(), shape.opening, s.injection_pressure() - far_field});
    if (std::abs(shape.tip_up - shape.tip_down) > 1e-9) run.tips_always_equal = false;
  };
  sim.run_until(end_time, look);
  const auto breaks = sim.breaks();
  int contacts = static_cast<int>(sim.preset_contacts().size());
  for (std::size_t b = 0; b + 1 < breaks.size(); b += 2, contacts += 2)
    run.advances.push_back({contacts, breaks[b].time, breaks[b].pressure - far_field});
  run.end = hfdem::measure::crack_shape(sim);
  run.off_plane = hfdem::measure::broken_off_plane(sim);
  run.mechanical_steps = sim.mechanical_steps();
  return run;
}

inline VerificationRun verify(const hfdem::UniformPressure::Params& scheme, double end_time = 0.9) {
  return inject({.scheme = scheme}, {}, end_time);
}

/// Run once, used by several tests.
inline const VerificationRun& paper_rule() {
  static const VerificationRun run = verify({});
  return run;
}
inline const VerificationRun& equilibrium() {
  static const VerificationRun run = verify({.equilibrium = true});
  return run;
}

/// The largest relative deviation met, and where.
struct Worst {
  double deviation = 0, at = 0;
  void see(double ours, double truth, double where) {
    const double d = std::abs(ours - truth) / std::abs(truth);
    if (!(d <= deviation)) deviation = d, at = where;
  }
};

}  // namespace test
