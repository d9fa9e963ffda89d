// Specimens with natural fractures, put in by hand: every pair of discs is tried.
#pragma once

#include <algorithm>
#include <initializer_list>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/contact/jointed.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>
#include <hfdem/state/specimen.hpp>

namespace test {

using JointedRock = hfdem::Jointed<hfdem::LinearParallelBond, hfdem::SmoothJoint>;
template <class Pressure>
using Fractured =
    hfdem::Simulator<JointedRock, hfdem::HyperbolicAperture, Pressure, hfdem::FixedPairs>;

/// Puts a fracture between all discs whose centres it parts and whose surfaces are no farther apart
/// than `reach`, m.
inline void add_fracture(hfdem::Specimen& s, hfdem::Vec2 from, hfdem::Vec2 to, double reach) {
  const hfdem::NaturalFracture f{from, to};
  const auto number = static_cast<hfdem::Index>(s.joints.fractures.size());
  s.joints.fractures.push_back(f);
  const auto height = [&](hfdem::Index i) { return dot(s.centre[i] - from, f.normal()); };
  for (hfdem::Index i = 0; i < s.size(); ++i)
    for (hfdem::Index j = i + 1; j < s.size(); ++j) {
      if (s.gap({i, j}) > reach || (height(i) < 0) == (height(j) < 0)) continue;
      const double share = height(i) / (height(i) - height(j));
      const hfdem::Vec2 at = s.centre[i] + share * (s.centre[j] - s.centre[i]);
      const double along = dot(at - from, f.direction());
      if (along < 0 || along > f.length()) continue;
      s.joints.pairs.push_back(
          {{i, j}, number, along, height(j) > height(i) ? f.normal() : -f.normal()});
    }
  std::sort(s.joints.pairs.begin(), s.joints.pairs.end(),
            [](const auto& p, const auto& q) { return p.bodies < q.bodies; });
}

/// A disc under a fracture that lies lower than its neighbours, and so has no bond across.
struct Sunk {
  hfdem::Index column;
  double by;  // m
};

/// A square array of 16 by 16 discs with a fracture across the way of a vertical crack that starts
/// in the middle.
inline hfdem::Specimen fractured_square(std::initializer_list<Sunk> sunk = {}) {
  constexpr double radius = 5e-3;
  hfdem::Specimen s = hfdem::square_array(16, 16, radius);
  s.bonding_gap = 1e-6;  // a disc that has sunk keeps its bonds on both sides
  for (const Sunk& disc : sunk) s.centre[11 * 16 + disc.column].y -= disc.by;
  add_fracture(s, {0.03, 0.12}, {0.13, 0.12}, 1e-3);
  return s;
}

/// Weak enough to break and slide as the crack comes near.
inline constexpr hfdem::SmoothJoint::Params weak_joint{
    .tensile_strength = 0, .cohesion = 1e4, .friction = 0.02, .dilation_angle = 1, .w0 = 2e-5};

}  // namespace test
