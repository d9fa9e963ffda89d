// Strength of a joint and crossing of a joint, beside Mohr's circle and a quadratic equation.
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <hfdem/analytic/joint_crossing.hpp>
#include <hfdem/analytic/joint_strength.hpp>
#include <hfdem/base/vec2.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

namespace {

using hfdem::Vec2;
using hfdem::analytic::joint_strength;
using hfdem::analytic::JointCrossing;
using test::near;

constexpr double infinity = std::numeric_limits<double>::infinity();

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// By how much the shear stress on a plane is over Coulomb's strength; tension positive.
double excess(double xx, double yy, double xy, double plane, double friction, double cohesion) {
  const Vec2 along{std::cos(plane), std::sin(plane)}, normal = left_of(along);
  const Vec2 traction{xx * normal.x + xy * normal.y, xy * normal.x + yy * normal.y};
  return std::abs(dot(traction, along)) - (cohesion - friction * dot(traction, normal));
}

/// The major stress at which a joint slips, by halving; infinity above 1e12 Pa.
double strength_by_halving(double angle, double friction, double cohesion, double confinement) {
  const auto slips = [&](double major) {
    return excess(-confinement, -major, 0, radians(angle), friction, cohesion) > 0;
  };
  double low = confinement, high = 1e12;
  if (!slips(high)) return infinity;
  for (int k = 0; k < 100; ++k) (slips((low + high) / 2) ? high : low) = (low + high) / 2;
  return high;
}

/// By how much a joint beside a crack's tip, on one side of it, is over its strength where the
/// largest principal stress just reaches the rock's. With the tip's field K, the polar angle t,
/// c = cos t/2, s = sin t/2, s' = sin 3t/2, and S, D half of sum and difference of the in-situ
/// stresses, that stress being T is
///   K^2 c^4 - 2 K c (T + S + D s s') + (T + S)^2 - D^2 = 0.
double excess_beside_tip(const JointCrossing& j, double t) {
  const double c = std::cos(t / 2), s = std::sin(t / 2), s3 = std::sin(1.5 * t);
  const double S = (j.stress_along + j.stress_across) / 2;
  const double D = (j.stress_along - j.stress_across) / 2;
  const double T = j.tensile_strength;
  const double half = c * (T + S + D * s * s3), last = (T + S) * (T + S) - D * D;
  const double K = last / (half + std::sqrt(half * half - std::pow(c, 4) * last));
  return excess(-j.stress_along + K * c * (1 - s * s3), -j.stress_across + K * c * (1 + s * s3),
                K * s * c * std::cos(1.5 * t), t, j.friction, j.cohesion);
}

double worst_excess(JointCrossing j, double stress_along) {
  j.stress_along = stress_along;
  const double t = radians(j.angle);
  return std::fmax(excess_beside_tip(j, t), excess_beside_tip(j, t - std::numbers::pi));
}

}  // namespace

TEST_CASE("a joint slips where Mohr's circle reaches Coulomb's line on its plane") {
  for (const double angle : {35.0, 45.0, 60.0, 70.0, 85.0})
    for (const double friction : {0.0, 0.3, 0.5, 0.65})
      for (const double cohesion : {0.0, 0.1e6, 3e6})
        for (const double confinement : {0.5e6, 15e6}) {
          CAPTURE(angle);
          CAPTURE(friction);
          CHECK(joint_strength(angle, friction, cohesion, confinement) ==
                near(strength_by_halving(angle, friction, cohesion, confinement), 1e-9));
        }
  CHECK(joint_strength(45, 0.5, 0, 5e6) == near(15e6));
}

TEST_CASE("a joint too flat or along the load does not slip at all") {
  const double limit = std::atan(0.5) * 180 / std::numbers::pi;
  for (const double angle : {1.0, 20.0, limit - 1e-6, limit, 90.0}) {
    CAPTURE(angle);
    CHECK(joint_strength(angle, 0.5, 1e6, 5e6) == infinity);
  }
  CHECK(joint_strength(limit + 0.01, 0.5, 1e6, 5e6) < 1e12);
  CHECK(joint_strength(89.9, 0.5, 1e6, 5e6) < 1e12);
}

TEST_CASE("a crack crosses a joint from the stress on that the quadratic equation says") {
  for (const double angle : {90.0, 80.0, 75.0})
    for (const double friction : {0.4, 0.6, 0.9})
      for (const double cohesion : {0.0, 1e6}) {
        CAPTURE(angle);
        CAPTURE(friction);
        CAPTURE(cohesion);
        const JointCrossing joint{.angle = angle, .friction = friction, .cohesion = cohesion};
        const double least = joint.least_stress_along();
        REQUIRE(least < 0.99e9);
        if (least > 1.0001 * joint.stress_across) {
          CHECK(worst_excess(joint, 0.9999 * least) > 0);
          CHECK(std::abs(worst_excess(joint, least)) < 1e-9 * least);
        }
        CHECK(worst_excess(joint, 1.0001 * least) < 0);
      }
}

TEST_CASE("a joint across the crack is crossed about where Renshaw and Pollard say") {
  // Theirs asks for the stress along the joint to reach the strength, not the principal stress,
  // which does so earlier: (0.35 + 0.35 / mu) / 1.06 (T + stress across).
  for (const double friction : {0.2, 0.4, 0.6}) {
    CAPTURE(friction);
    const JointCrossing joint{.stress_across = 5e6, .friction = friction};
    const double theirs = (0.35 + 0.35 / friction) / 1.06 * (5e6 + joint.tensile_strength);
    CHECK(joint.least_stress_along() < 1.02 * theirs);
    CHECK(joint.least_stress_along() > 0.8 * theirs);
  }
}

TEST_CASE("more friction, cohesion or stress along the crack lets it cross; less angle does not") {
  double before = 1e9;
  for (const double friction : {0.3, 0.5, 0.7, 0.9}) {
    const double least = JointCrossing{.angle = 80, .friction = friction}.least_stress_along();
    CHECK(least < before);
    before = least;
  }
  before = 1e9;
  for (const double cohesion : {0.0, 0.5e6, 1e6, 2e6}) {
    const double least = JointCrossing{.angle = 75, .cohesion = cohesion}.least_stress_along();
    CHECK(least < before);
    before = least;
  }
  before = 0;
  for (const double angle : {90.0, 85.0, 80.0, 75.0, 70.0}) {
    const double least = JointCrossing{.angle = angle}.least_stress_along();
    CHECK(least > before);
    before = least;
    // The same joint in the mirror.
    CHECK(JointCrossing{.angle = 180 - angle}.least_stress_along() == near(least, 1e-9));
  }
  CHECK(JointCrossing{.friction = 0}.least_stress_along() == 1e9);
  const JointCrossing glued{.angle = 60, .cohesion = 1e9};
  CHECK(glued.crosses());
  CHECK(glued.least_stress_along() == near(glued.stress_across, 1e-9));
}
