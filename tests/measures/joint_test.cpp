// Compression of random specimens that one joint cuts from side to side, beside the law of Coulomb.
#include <cmath>
#include <numbers>
#include <string>

#include <hfdem/analytic/joint_strength.hpp>
#include <hfdem/contact/jointed.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/contact/unbreakable.hpp>
#include <hfdem/measure/joint_test.hpp>
#include <hfdem/setup/joints.hpp>
#include <hfdem/setup/random_packing.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

namespace {

using namespace hfdem;
using test::near;
using Rock = Jointed<Unbreakable<LinearParallelBond>, SmoothJoint>;

const Rock law{LinearParallelBond::Params{}, SmoothJoint::Params{}};
constexpr double confinement = 5e6;

/// With a joint from its lower left to its upper right, or in the mirror.
Specimen jointed_rock(double angle, bool mirrored = false) {
  constexpr double width = 0.15, above = 0.06;
  const double rise = width * std::tan(angle * std::numbers::pi / 180);
  Specimen rock = random_packing({.width = width, .height = rise + 2 * above});
  const double low = above, high = above + rise;
  insert_joints(rock, {{{0, mirrored ? high : low}, {width, mirrored ? low : high}}});
  return rock;
}

measure::JointTest compressed(const Specimen& rock, double strain_rate, double largest_strain) {
  return measure::jointed_compression(
      rock, law, confinement, {.strain_rate = strain_rate, .largest_strain = largest_strain}, {});
}

double coulomb(double angle, double cohesion) {
  return analytic::joint_strength(angle, SmoothJoint::Params{}.friction, cohesion, confinement);
}

}  // namespace

TEST_CASE("a joint breaks and slips as Coulomb says, and is as stiff per metre as its law") {
  for (const double angle : {45.0, 60.0}) {
    CAPTURE(angle);
    const auto test = compressed(jointed_rock(angle), 0.05, 0.003);
    CHECK(test.angle == near(angle, 1e-9));
    CHECK(test.residual() == near(coulomb(angle, 0), 0.03));
    CHECK(test.test.strength == near(coulomb(angle, SmoothJoint::Params{}.cohesion), 0.06));
    CHECK(test.normal_stiffness() == near(120e9, 0.02));
    CHECK(test.shear_stiffness() == near(60e9, 0.02));
    const auto& end = test.readings.back();
    CHECK(end.shear > 1e-4);
    // What slides obeys friction.
    CHECK(test.shear_stress(end) == near(0.5 * test.normal_stress(end), 0.06));
  }
}

TEST_CASE("a joint that falls to the right slips like one that rises") {
  const auto test = compressed(jointed_rock(45, true), 0.2, 0.003);
  CHECK(test.angle == near(45, 1e-9));
  CHECK(test.residual() == near(coulomb(45, 0), 0.03));
  CHECK(test.normal_stiffness() == near(120e9, 0.02));
  CHECK(test.readings.back().shear > 1e-4);
}

TEST_CASE("a specimen with no joint or with two is refused") {
  Specimen rock = random_packing({.width = 0.05, .height = 0.1});
  const auto said = [&] {
    try {
      compressed(rock, 0.2, 0.001);
    } catch (const InvalidParameter& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  CHECK(said().find("specimen.joints = 0 fractures is not allowed: it must be one") == 0);
  insert_joints(rock, {{{0, 0.04}, {0.05, 0.05}}, {{0, 0.06}, {0.05, 0.07}}});
  CHECK(said().find("specimen.joints = 2 fractures is not allowed: it must be one") == 0);
}
