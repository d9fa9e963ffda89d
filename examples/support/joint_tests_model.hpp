/// @file
/// Tests of one joint through a random specimen, at several angles and confinements.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include <hfdem/analytic/joint_strength.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/contact/unbreakable.hpp>
#include <hfdem/measure/joint_test.hpp>
#include <hfdem/setup/joints.hpp>
#include <hfdem/setup/random_packing.hpp>

#include "support/settings.hpp"

namespace hfdem::support {

/// The joint breaks and slips, the rock does not break.
using JointedRock = Jointed<Unbreakable<LinearParallelBond>, SmoothJoint>;

/// How many specimens are tested, and under which confinements.
struct JointStudy {
  int seeds = 3;
  double low_confinement = 5e6;
  double high_confinement = 15e6;
  double rock_above = 0.06;

  static constexpr auto fields() {
    using P = JointStudy;
    return std::tuple{
        Field{"seeds", &P::seeds, "", Range{1, 1000},
              "specimens of each angle, numbered from specimen.seed on"},
        Field{"low_confinement", &P::low_confinement, "Pa", positive, "of the first tests"},
        Field{"high_confinement", &P::high_confinement, "Pa", positive, "of the second tests"},
        Field{"rock_above", &P::rock_above, "m", positive,
              "height of rock above the joint's upper mouth and below its lower one"}};
  }
};

/// The parameter file's sections; the specimen's height follows from the joint's angle.
struct JointTestsConfig : SectionTree<JointTestsConfig> {
  RandomPacking specimen{.width = 0.15};
  LinearParallelBond::Params contact;
  SmoothJoint::Params joints;
  measure::LoadFrame load_frame{.largest_strain = 0.005};
  JointStudy study;
  Mechanics mechanics;

  static constexpr std::array angles{45.0, 60.0, 70.0};  ///< to the minor stress, deg

  /// One narrow specimen of each angle, loaded faster.
  static JointTestsConfig quick() {
    JointTestsConfig config;
    config.specimen.width = 0.1;
    config.load_frame.strain_rate = 0.2;
    config.load_frame.largest_strain = 0.003;
    config.study.seeds = 1;
    return config;
  }

  std::array<double, 2> confinements() const {
    return {study.low_confinement, study.high_confinement};
  }

  /// With one joint from the lower left to the upper right.
  Specimen jointed(double angle, int seed, int threads) const {
    RandomPacking packing = specimen;
    const double rise = packing.width * std::tan(angle * std::numbers::pi / 180);
    packing.height = rise + 2 * study.rock_above;
    packing.seed = seed;
    Specimen rock = random_packing(packing, threads);
    insert_joints(rock, {{{0, study.rock_above}, {packing.width, study.rock_above + rise}}});
    return rock;
  }

  template <class Self, class F>
  static void visit(Self& self, F& f) {
    f("specimen", self.specimen);
    f("contact", self.contact);
    f("joints", self.joints);
    f("load_frame", self.load_frame);
    f("study", self.study);
    f("mechanics", self.mechanics);
  }
};

/// What one test came to, beside what it should.
struct JointTestResult {
  int seed = 0;
  double angle = 0, confinement = 0;  ///< deg, Pa
  double peak = 0, residual = 0;      ///< stress of the ends, Pa
  double coulomb_peak = 0, coulomb_residual = 0;
  double normal_stiffness = 0, shear_stiffness = 0;  ///< per metre of joint, Pa/m
  std::vector<measure::JointReading> readings{};
};

/// Makes one test.
/// @throws RunStopped if the specimen finds no equilibrium under the confinement
inline JointTestResult joint_test(const JointTestsConfig& c, double angle, double confinement,
                                  int seed, int threads) {
  const auto test = measure::jointed_compression(c.jointed(angle, seed, threads),
                                                 JointedRock(c.contact, c.joints), confinement,
                                                 c.load_frame, c.mechanics);
  const auto coulomb = [&](double cohesion) {
    return analytic::joint_strength(angle, c.joints.friction, cohesion, confinement);
  };
  return {.seed = seed,
          .angle = angle,
          .confinement = confinement,
          .peak = test.test.strength,
          .residual = test.residual(),
          .coulomb_peak = coulomb(c.joints.cohesion),
          .coulomb_residual = coulomb(0),
          .normal_stiffness = test.normal_stiffness(),
          .shear_stiffness = test.shear_stiffness(),
          .readings = test.readings};
}

}  // namespace hfdem::support
