/// @file
/// Toughness of a rock from the pressure of a crack that runs through it.
///
/// Under slow injection the crack waits until the pressure breaks the bonds at a tip, and runs
/// until it has lost that pressure: K at a break says how strong that place is, K after it how far
/// the tip overshot. The toughness that governs the growth is their mean over all fluid steps, that
/// is, over equal parts of the injected volume,
///   K = mean of (P - S) F_K(2a) sqrt(pi a),
/// with P the pressure at the injection, S the stress that closes the crack, 2a the distance of the
/// tips along the crack's direction, and the factor F_K of a central crack in the finite plate.
#pragma once

#include <cmath>
#include <cstddef>
#include <tuple>
#include <vector>

#include <hfdem/base/fields.hpp>
#include <hfdem/measure/crack.hpp>
#include <hfdem/state/step.hpp>

namespace hfdem::measure {

/// The lengths between which a crack counts as running, over the width of the plate: long enough to
/// have forgotten the slit it began as, and far enough from the rim.
struct RunningRange {
  double from = 0.2;
  double to = 0.6;

  static constexpr auto fields() {
    using P = RunningRange;
    return std::tuple{
        Field{"from", &P::from, "", Range{0, 0.9, true}, "length from which the crack counts"},
        Field{"to", &P::to, "", Range{0, 0.9, true}, "length up to which it counts"}};
  }

  /// Checks that it is no empty range.
  /// @throws InvalidParameter naming the field
  void check() const {
    validate(*this, "running");
    if (!(to > from))
      refuse("running", "to", to_text(to), "greater than running.from, which is " + to_text(from));
  }
};

/// A crack under injection after one fluid step.
struct CrackInstant {
  double time;              ///< s
  double tip_up, tip_down;  ///< distances of the tips from the injection, m
  double net_pressure;      ///< at the injection, above the in-situ stress across the crack, Pa
  double volume;            ///< that it has opened, m2

  double full_length() const { return tip_up + tip_down; }  ///< m
};

/// An observer that remembers every fluid step.
class RunningCrack {
 public:
  /// @param in_situ stress across the crack, Pa
  explicit RunningCrack(double in_situ) : in_situ_(in_situ) {}

  /// Heard after every fluid step.
  template <class Sim>
  void fluid_step(const Sim& sim, const FluidStep& step) {
    const CrackShape shape = crack_shape(sim);
    instants_.push_back({sim.time(), shape.tip_up, shape.tip_down,
                         sim.injection_pressure() - in_situ_, sim.network().crack_volume()});
    unconverged_ += step.converged ? 0 : 1;
  }

  const std::vector<CrackInstant>& instants() const { return instants_; }  ///< in their order
  long unconverged() const { return unconverged_; }  ///< fluid steps that ended too early

 private:
  double in_situ_;
  long unconverged_ = 0;
  std::vector<CrackInstant> instants_{};
};

/// What a running crack says.
struct RunningToughness {
  double K = 0;           ///< mean, Pa sqrt(m)
  double deviation = 0;   ///< standard, of single fluid steps, Pa sqrt(m)
  std::size_t steps = 0;  ///< fluid steps that counted
};

/// The mean K over the fluid steps whose length is in the range.
/// @param instants of equal injected volumes
/// @param plate gives `width()` and `stress_intensity(net_pressure, full_length)`, e.g.
/// `CrackedPlate`
/// @param range of lengths
/// @param closing_excess by which the stress that closes the crack is above the in-situ stress, Pa
/// @returns no steps if the crack was never in the range
template <class Plate>
RunningToughness running_toughness(const std::vector<CrackInstant>& instants, const Plate& plate,
                                   const RunningRange& range, double closing_excess = 0) {
  RunningToughness toughness;
  std::vector<double> K;
  for (const CrackInstant& now : instants) {
    const double length = now.full_length();
    if (length < range.from * plate.width() || length > range.to * plate.width()) continue;
    K.push_back(plate.stress_intensity(now.net_pressure - closing_excess, length));
  }
  toughness.steps = K.size();
  const auto count = static_cast<double>(K.size());
  for (const double k : K) toughness.K += k / count;
  for (const double k : K) toughness.deviation += (k - toughness.K) * (k - toughness.K);
  if (K.size() > 1) toughness.deviation = std::sqrt(toughness.deviation / (count - 1));
  return toughness;
}

}  // namespace hfdem::measure
