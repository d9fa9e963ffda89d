/// @file
/// Rock tests of a bonded specimen: compression with or without confinement, direct tension, and
/// the Brazilian test.
///
/// Platens are rigid and smooth; grips are layers of discs that move as one. Both ends move at the
/// same constant speed. All values are those of the plane assembly: no plane strain is read into
/// them.
#pragma once

#include <cmath>
#include <vector>

#include <hfdem/measure/load_frame.hpp>
#include <hfdem/measure/slit_readings.hpp>
#include <hfdem/setup/brazilian_disc.hpp>

namespace hfdem::measure {

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
