/// @file
/// Compression of a specimen that a joint cuts from side to side: strength of the joint, and its
/// stiffness per metre.
///
/// The ends are pressed by smooth platens. The sides are loaded as by a fluid behind a membrane:
/// every disc of the rim carries the confining pressure on its part of the side, and where the
/// joint comes out, the parts of its two blocks end at its mouth. Rigid side platens would hinder
/// the two blocks; parts that straddle the mouth would press on the wrong block.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <hfdem/measure/load_frame.hpp>
#include <hfdem/measure/slit_readings.hpp>

namespace hfdem::measure {

/// What the joint does at one moment, as means over its length.
struct JointReading {
  double strain;   ///< between the ends
  double stress;   ///< mean of both ends, Pa
  double closure;  ///< approach of the two sides, m
  double shear;    ///< of one side along the other, m; positive as the load drives it
};

/// A test of a joint.
struct JointTest {
  double angle = 0;                      ///< of the joint to the minor stress, deg
  double length = 0;                     ///< of the joint, m
  RockTest test{};                       ///< strength, curve and breaks
  std::vector<JointReading> readings{};  ///< from the end of confinement on

  /// Mean stress of the ends over the last quarter of the test, Pa.
  double residual() const {
    double sum = 0, count = 0;
    for (const JointReading& r : readings)
      if (r.strain > 0.75 * readings.back().strain) sum += r.stress, ++count;
    return sum / count;
  }
  /// Normal stress on the joint that the loads of a reading make, Pa.
  double normal_stress(const JointReading& r) const {
    return confinement() + (r.stress - confinement()) * std::pow(std::cos(radians()), 2);
  }
  /// Shear stress on the joint that the loads of a reading make, Pa.
  double shear_stress(const JointReading& r) const {
    return 0.5 * (r.stress - confinement()) * std::sin(2 * radians());
  }
  /// Normal stress of the confinement over the closure that it made, Pa/m.
  double normal_stiffness() const { return confinement() / readings.front().closure; }
  /// Slope of shear stress over shear displacement up to a quarter of the strength, Pa/m.
  double shear_stiffness() const {
    std::vector<Vec2> points;
    for (const JointReading& r : readings) {
      if (r.stress - confinement() > 0.25 * (test.strength - confinement())) break;
      points.push_back({r.shear, shear_stress(r)});
    }
    return Line::through(points).slope;
  }

 private:
  double confinement() const { return test.confinement; }
  double radians() const { return angle * std::numbers::pi / 180; }
};

namespace detail {

/// Which discs hang together with a disc by bonds of the rock: on a joint from side to side, those
/// of its block. Centres do not say it, as discs may have changed sides.
template <class Rock>
std::vector<bool> block_of(const Rock& rock, Index disc) {
  std::vector<std::vector<Index>> beside(rock.specimen().size());
  for (const ContactGeometry& c : rock.geometry().first(rock.contacts().size())) {
    beside[c.bodies.first].push_back(c.bodies.second);
    beside[c.bodies.second].push_back(c.bodies.first);
  }
  std::vector<bool> in_block(beside.size(), false);
  for (std::vector<Index> front{disc}; !front.empty();) {
    const Index i = front.back();
    front.pop_back();
    if (in_block[i]) continue;
    in_block[i] = true;
    front.insert(front.end(), beside[i].begin(), beside[i].end());
  }
  return in_block;
}

/// The confining pressure on a side as forces on the discs of its rim, N per m.
/// @param rock with one joint from side to side
/// @param upper which discs are of the block above the joint
/// @param side left or right
/// @param pressure Pa
template <class Rock>
void press_side(Rock& rock, const std::vector<bool>& upper, Side side, double pressure) {
  const Specimen& s = rock.specimen();
  const NaturalFracture& joint = s.joints.fractures.front();
  const bool comes_from_here = (joint.from.x < joint.to.x) == (side == Side::left);
  const double mouth = comes_from_here ? joint.from.y : joint.to.y;
  std::vector<Index> rim;
  for (Index i = 0; i < s.size(); ++i)
    if (s.touches(i, side)) rim.push_back(i);
  const auto height = [&](Index i) { return s.centre[i].y; };
  std::sort(rim.begin(), rim.end(), [&](Index a, Index b) {
    return upper[a] == upper[b] ? height(a) < height(b) : upper[b];
  });
  double below = 0;
  for (std::size_t k = 0; k < rim.size(); ++k) {
    double above = s.height;
    if (k + 1 < rim.size())
      above =
          upper[rim[k]] == upper[rim[k + 1]] ? 0.5 * (height(rim[k]) + height(rim[k + 1])) : mouth;
    rock.push(rim[k], -(pressure * (above - below)) * outward(side));
    below = above;
  }
}

}  // namespace detail

/// Compresses a specimen along y that one joint cuts from its left to its right side.
/// @param specimen with one natural fracture
/// @param law with joints; of rock that does not break, if the joint alone is tested
/// @param confinement on the sides, Pa
/// @param frame says how fast and until which strain
/// @param mechanics of the specimen
/// @throws InvalidParameter if it has no joint or several
/// @throws RunStopped if it finds no equilibrium under the confinement
template <HasJoints Contact>
JointTest jointed_compression(const Specimen& specimen, const Contact& law, double confinement,
                              const LoadFrame& frame, const Mechanics& mechanics) {
  if (specimen.joints.fractures.size() != 1)
    refuse("specimen", "joints", std::to_string(specimen.joints.fractures.size()) + " fractures",
           "one, from side to side");
  const NaturalFracture& joint = specimen.joints.fractures.front();
  const Vec2 direction = joint.direction();
  JointTest result{
      .angle = std::atan2(std::abs(direction.y), std::abs(direction.x)) * 180 / std::numbers::pi,
      .length = joint.length()};
  detail::LoadedSpecimen<Contact> loaded(specimen, law, BoundaryKind::servo, mechanics);
  auto& rock = loaded.rock();
  const auto highest = std::ranges::max_element(specimen.centre, {}, &Vec2::y);
  const auto upper = detail::block_of(rock, static_cast<Index>(highest - specimen.centre.begin()));
  for (const Side side : {Side::left, Side::right}) {
    rock.withdraw(side);
    detail::press_side(rock, upper, side, confinement);
  }
  loaded.confine(confinement, mechanics);

  rock.shorten_at({0, frame.strain_rate});
  for (const Side end : {Side::bottom, Side::top})
    rock.drive(end, frame.strain_rate * specimen.height / 2);
  const auto& place = rock.discs().displacement;
  const auto shortening = [&] {
    return (place[rock.discs().platen(Side::bottom)][1] -
            place[rock.discs().platen(Side::top)][1]) /
           specimen.height;
  };
  const double before = shortening();
  // A joint that rises to the right lets the upper block slide to the left, along its tangent.
  const double sense = direction.x * direction.y > 0 ? 1 : -1;
  result.test = loaded.load_to_the_end(frame, [&] {
    const double stress = (Loading::compression(Side::bottom, rock.discs(), rock.forces()) +
                           Loading::compression(Side::top, rock.discs(), rock.forces())) /
                          (2 * specimen.width);
    JointReading now{shortening() - before, stress, 0, 0};
    const auto& joints = rock.joints();
    for (std::size_t k = 0; k < joints.size(); ++k) {
      const auto motion = joints.contacts().motion(k, place);
      const double share = joints.piece(k).length() / result.length;
      now.closure -= share * motion.opening;
      now.shear += sense * share * motion.shear;
    }
    result.readings.push_back(now);
    return stress;
  });
  return result;
}

}  // namespace hfdem::measure
