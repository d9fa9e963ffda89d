/// @file
/// The load frame that rock tests share: rigid smooth platens or grips that move at constant speed,
/// confinement before, and readings until the specimen has failed.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <hfdem/assembly.hpp>
#include <hfdem/measure/mean_strain.hpp>
#include <hfdem/measure/rock_test.hpp>
#include <hfdem/neighbours/cell_grid.hpp>
#include <hfdem/simulator_params.hpp>

namespace hfdem::measure {

/// How a specimen is loaded, and until when.
struct LoadFrame {
  double strain_rate = 0.05;
  double largest_strain = 0.004;
  double end_below = 0.6;
  double grip_depth = 0.02;

  static constexpr auto fields() {
    using P = LoadFrame;
    return std::tuple{
        Field{"strain_rate", &P::strain_rate, "1/s", Range{1e-4, 1},
              "speed of the two ends towards or from each other over the length between them"},
        Field{"largest_strain", &P::largest_strain, "", Range{1e-5, 0.05},
              "at which a test ends at the latest"},
        Field{"end_below", &P::end_below, "", Range{0, 1, true, true},
              "a test ends when the load, less the confinement, falls below this part of its peak"},
        Field{"grip_depth", &P::grip_depth, "m", positive,
              "of the layer of discs that each grip holds in direct tension"}};
  }
};

namespace detail {

/// One specimen in the load frame.
template <ContactLaw Contact>
class LoadedSpecimen {
 public:
  LoadedSpecimen(const Specimen& specimen, const Contact& law, BoundaryKind ends,
                 const Mechanics& mechanics)
      : rock_(specimen, bonded_contacts<CellGrid>(specimen), law, {.kind = ends}, mechanics.damping,
              mechanics.step_fraction),
        free_(specimen.size()) {
    std::iota(free_.begin(), free_.end(), Index{0});
  }

  /// To be set up before a test.
  Assembly<Contact>& rock() { return rock_; }

  /// Moves some discs as one, m/s along y.
  void grip(const std::vector<Index>& discs, double velocity) {
    for (const Index i : discs) rock_.drive(i, {0, velocity});
    std::erase_if(free_,
                  [&](Index i) { return std::binary_search(discs.begin(), discs.end(), i); });
  }

  /// Lets the confinement settle.
  /// @throws RunStopped if it finds no equilibrium
  void confine(double stress, const Mechanics& mechanics) {
    test_.confinement = stress;
    rock_.set_stress({stress, stress});
    constexpr int between_checks = 20;
    for (int steps = 0; steps < mechanics.max_settle_steps; steps += between_checks) {
      double resultant = 0;
      for (int k = 0; k < between_checks; ++k) {
        find_forces(0);
        resultant = move(true);
      }
      if (std::fmax(resultant / rock_.mean_contact_force(), rock_.worst_platen_error()) <
          mechanics.settle_tolerance)
        return;
    }
    throw RunStopped("a specimen found no equilibrium under " + in_words(stress) + " Pa in " +
                     std::to_string(mechanics.max_settle_steps) +
                     " mechanical steps (mechanics.max_settle_steps)");
  }

  /// Steps until the specimen has failed.
  /// @param frame says when it has
  /// @param stress of the two ends, Pa
  /// @throws RunStopped if it does not fail
  template <class Stress>
  RockTest load(const LoadFrame& frame, Stress&& stress) {
    run(frame, stress, true);
    if (test_.strain_at_strength > 0.98 * frame.largest_strain)
      throw RunStopped("a specimen under " + in_words(test_.confinement) +
                       " Pa of confinement still carried more and more load at a strain of " +
                       in_words(frame.largest_strain) + " (load_frame.largest_strain)");
    return finished();
  }

  /// Steps up to the largest strain, whether the specimen fails or not.
  template <class Stress>
  RockTest load_to_the_end(const LoadFrame& frame, Stress&& stress) {
    run(frame, stress, false);
    return finished();
  }

 private:
  template <class Stress>
  void run(const LoadFrame& frame, Stress&& stress, bool until_failure) {
    constexpr int between_checks = 20;
    constexpr double between_readings = 5e-6;  // of strain
    const double strain_per_step = frame.strain_rate * rock_.dt();
    const Vec2 before = mean_shortening(rock_.discs(), free_);
    for (long step = 0; true; ++step) {
      const double strain = static_cast<double>(step) * strain_per_step;
      find_forces(strain);
      if (step % between_checks == 0) {
        const LoadReading now{strain, stress(), mean_shortening(rock_.discs(), free_) - before};
        if (now.stress > test_.strength)
          test_.strength = now.stress, test_.strain_at_strength = strain;
        if (test_.curve.empty() || strain >= test_.curve.back().strain + between_readings)
          test_.curve.push_back(now);
        if ((until_failure && has_failed(now, frame)) || strain >= frame.largest_strain) return;
      }
      move(false);
    }
  }

  void find_forces(double strain) {
    rock_.find_forces(1, [&](Index contact, Mode mode) {
      test_.breaks.push_back({strain, mode, rock_.geometry()[contact]});
    });
  }

  double move(bool settling) {
    const double resultant = rock_.move(settling, 1);
    ++test_.steps;
    if (!std::isfinite(resultant))
      throw RunStopped("a force is not a finite number: the mechanical step is unstable");
    return resultant;
  }

  /// Without a broken bond a fall of the load is a wave at the start.
  bool has_failed(const LoadReading& now, const LoadFrame& frame) const {
    return !test_.breaks.empty() &&
           now.stress - test_.confinement < frame.end_below * (test_.strength - test_.confinement);
  }

  RockTest finished() {
    test_.specimen = rock_.specimen();
    for (std::size_t i = 0; i < rock_.discs().size(); ++i)
      test_.displacement.push_back(
          {rock_.discs().displacement[i][0], rock_.discs().displacement[i][1]});
    return std::move(test_);
  }

  Assembly<Contact> rock_;
  std::vector<Index> free_;  ///< discs that no grip holds
  RockTest test_;
};

}  // namespace detail

}  // namespace hfdem::measure
