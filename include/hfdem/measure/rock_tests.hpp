/// @file
/// Rock tests of a bonded specimen: compression with or without confinement, direct tension, and
/// the Brazilian test.
///
/// Platens are rigid and smooth; grips are layers of discs that move as one. Both ends move at the
/// same constant speed. All values are those of the plane assembly: no plane strain is read into
/// them.
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
#include <hfdem/measure/slit_readings.hpp>
#include <hfdem/neighbours/cell_grid.hpp>
#include <hfdem/setup/brazilian_disc.hpp>
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
        if (has_failed(now, frame) || strain >= frame.largest_strain) return finished(frame);
      }
      move(false);
    }
  }

 private:
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

  RockTest finished(const LoadFrame& frame) {
    if (test_.strain_at_strength > 0.98 * frame.largest_strain)
      throw RunStopped("a specimen under " + in_words(test_.confinement) +
                       " Pa of confinement still carried more and more load at a strain of " +
                       in_words(frame.largest_strain) + " (load_frame.largest_strain)");
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

/// Compresses a specimen along y between platens; those at its sides hold the confinement, or are
/// taken away if there is none.
/// @throws RunStopped if it finds no equilibrium under the confinement, or does not fail
template <ContactLaw Contact>
RockTest compression(const Specimen& specimen, const Contact& law, double confinement,
                     const LoadFrame& frame, const Mechanics& mechanics) {
  detail::LoadedSpecimen<Contact> loaded(specimen, law, BoundaryKind::servo, mechanics);
  auto& rock = loaded.rock();
  if (confinement > 0) {
    loaded.confine(confinement, mechanics);
  } else {
    rock.withdraw(Side::left);
    rock.withdraw(Side::right);
  }
  const Vec2 strain = rock.uniform_shortening({0, 1});
  rock.shorten_at((frame.strain_rate / strain.y) * strain);
  for (const Side end : {Side::bottom, Side::top})
    rock.drive(end, frame.strain_rate * specimen.height / 2);
  return loaded.load(frame, [&] {
    return (Loading::compression(Side::bottom, rock.discs(), rock.forces()) +
            Loading::compression(Side::top, rock.discs(), rock.forces())) /
           (2 * specimen.width);
  });
}

/// Pulls a specimen along y by the layers that the grips hold.
/// @throws InvalidParameter if the grips take more than half of it, or hold nothing
/// @throws RunStopped if it does not fail
template <ContactLaw Contact>
RockTest direct_tension(const Specimen& specimen, const Contact& law, const LoadFrame& frame,
                        const Mechanics& mechanics) {
  const double top = specimen.height - frame.grip_depth;
  if (frame.grip_depth > specimen.height / 4)
    refuse("load_frame", "grip_depth", to_text(frame.grip_depth) + " m",
           "at most " + to_text(specimen.height / 4) + " m, a quarter of the specimen's height");
  std::vector<Index> below, above;
  double lowest = specimen.height, highest = 0;  // centres that move with the upper, the lower grip
  for (Index i = 0; i < specimen.size(); ++i) {
    const double y = specimen.centre[i].y;
    if (y < frame.grip_depth) below.push_back(i), highest = std::fmax(highest, y);
    if (y > top) above.push_back(i), lowest = std::fmin(lowest, y);
  }
  if (below.empty() || above.empty())
    refuse("load_frame", "grip_depth", to_text(frame.grip_depth) + " m",
           "more: the grips hold no disc");
  detail::LoadedSpecimen<Contact> loaded(specimen, law, BoundaryKind::dead_loads, mechanics);
  auto& rock = loaded.rock();
  const Vec2 strain = rock.uniform_shortening({0, 1});
  rock.shorten_at((-frame.strain_rate / strain.y) * strain);
  const double speed = frame.strain_rate * (lowest - highest) / 2;
  loaded.grip(below, -speed);
  loaded.grip(above, speed);
  const auto pull = [&rock](const std::vector<Index>& grip) {
    double force = 0;
    for (const Index i : grip) force += rock.forces().total(i)[1];
    return force;
  };
  return loaded.load(frame, [&] { return (pull(below) - pull(above)) / (2 * specimen.width); });
}

/// Presses on the flats of a round plate, which was made as `brazilian_disc` does.
/// @throws RunStopped if it does not fail
template <ContactLaw Contact>
RockTest brazilian(const Specimen& specimen, const BrazilianDisc& plate, const Contact& law,
                   const LoadFrame& frame, const Mechanics& mechanics) {
  detail::LoadedSpecimen<Contact> loaded(specimen, law, BoundaryKind::servo, mechanics);
  auto& rock = loaded.rock();
  rock.withdraw(Side::left);
  rock.withdraw(Side::right);
  for (const Side end : {Side::bottom, Side::top})
    rock.drive(end, frame.strain_rate * specimen.height / 2);
  return loaded.load(frame, [&] {
    return plate.tension((Loading::compression(Side::bottom, rock.discs(), rock.forces()) +
                          Loading::compression(Side::top, rock.discs(), rock.forces())) /
                         2);
  });
}

/// Young's modulus and Poisson's ratio from the grains' strains, by straight lines through the
/// readings before the peak whose load, less the confinement, is between two parts of its peak.
/// @param test along y
/// @param from part of the peak
/// @param to part of the peak
inline ElasticModuli elastic_moduli(const RockTest& test, double from = 0.1, double to = 0.4) {
  std::vector<Vec2> stress, across;
  for (const LoadReading& r : test.curve) {
    const double part = (r.stress - test.confinement) / (test.strength - test.confinement);
    if (r.strain > test.strain_at_strength || part < from || part > to) continue;
    stress.push_back({std::abs(r.shortening.y), r.stress});
    across.push_back({r.shortening.y, r.shortening.x});
  }
  return {Line::through(stress).slope, -Line::through(across).slope};
}

}  // namespace hfdem::measure
