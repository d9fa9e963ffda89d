/// @file
/// Rock tests on random specimens, one set of tests for each seed.
#pragma once

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

#include <hfdem/contact/scattered_parallel_bond.hpp>
#include <hfdem/measure/mohr_coulomb.hpp>
#include <hfdem/measure/rock_tests.hpp>
#include <hfdem/measure/sample_mean.hpp>
#include <hfdem/setup/brazilian_disc.hpp>

#include "support/paper.hpp"
#include "support/settings.hpp"

namespace hfdem::support {

/// How many specimens are tested, and under which confinements.
struct RockStudy {
  int seeds = 4;
  int confinements = 2;
  double largest_confinement = 10e6;

  static constexpr auto fields() {
    using P = RockStudy;
    return std::tuple{Field{"seeds", &P::seeds, "", Range{1, 1000},
                            "specimens, numbered from specimen.seed on; each is another rock"},
                      Field{"confinements", &P::confinements, "", Range{1, 20},
                            "biaxial tests of each, beside the unconfined one"},
                      Field{"largest_confinement", &P::largest_confinement, "Pa", positive,
                            "of the biaxial tests; the others divide the way to it evenly"}};
  }

  /// Of test k; 0 is the unconfined one.
  double confinement(int k) const { return largest_confinement * k / confinements; }
};

/// The parameter file's sections.
struct RockTestsConfig : SectionTree<RockTestsConfig> {
  RandomPacking specimen{.width = 0.3, .height = 0.6};
  BrazilianDisc brazilian;
  ScatteredParallelBond::Params contact;
  measure::LoadFrame load_frame;
  RockStudy study;
  Mechanics mechanics;

  /// One small specimen, loaded faster.
  static RockTestsConfig quick() {
    RockTestsConfig config;
    config.specimen.width = 0.1;
    config.specimen.height = 0.2;
    config.brazilian.diameter = 0.2;
    config.load_frame = {.strain_rate = 0.2, .grip_depth = 0.01};
    config.study.seeds = 1;
    return config;
  }

  template <class Self, class F>
  static void visit(Self& self, F& f) {
    f("specimen", self.specimen);
    f("brazilian", self.brazilian);
    f("contact", self.contact);
    f("load_frame", self.load_frame);
    f("study", self.study);
    f("mechanics", self.mechanics);
  }

  /// Of specimen k.
  RandomPacking packing(int k) const {
    RandomPacking p = specimen;
    p.seed += k;
    return p;
  }
};

/// All tests of one specimen.
struct SpecimenTests {
  int seed = 0;
  std::vector<measure::RockTest> compression{};  ///< first the unconfined one
  measure::RockTest tension{}, brazilian{};
  std::string stopped{};  ///< why a test came to no result; empty if all did

  /// First direct tension, then the Brazilian test, then the compressions.
  measure::RockTest& test(std::size_t which) {
    return which == 0 ? tension : which == 1 ? brazilian : compression[which - 2];
  }

  void exchange(auto& archive) { archive(seed, compression, tension, brazilian, stopped); }
};

/// One of the numbers that describe a rock.
struct RockProperty {
  std::string key, name;         ///< for the summary; for people
  double paper;                  ///< not a number if the paper does not have it
  std::string_view unit;         ///< of the numbers
  std::vector<double> values{};  ///< of each specimen
  measure::SampleMean mean() const { return measure::SampleMean::of(values); }
};

/// The straight envelope through some of the specimens.
inline measure::MohrCoulomb envelope(std::span<const SpecimenTests> specimens) {
  std::vector<Vec2> strengths;
  for (const SpecimenTests& s : specimens)
    for (const measure::RockTest& t : s.compression)
      strengths.push_back({t.confinement, t.strength});
  return measure::MohrCoulomb::through(strengths);
}

inline std::vector<RockProperty> properties(std::span<const SpecimenTests> specimens) {
  using paper::Rock;
  RockProperty E{"E_Pa", "Young's modulus", Rock::E, "Pa"};
  RockProperty nu{"poisson_ratio", "Poisson's ratio", Rock::poisson_ratio, ""};
  RockProperty ucs{"ucs_Pa", "unconfined compressive strength", Rock::ucs, "Pa"};
  RockProperty tensile{"tensile_strength_Pa", "tensile strength", Rock::tensile_strength, "Pa"};
  RockProperty phi{"friction_angle_deg", "friction angle", Rock::friction_angle, "deg"};
  RockProperty c{"cohesion_Pa", "cohesion", Rock::cohesion, "Pa"};
  RockProperty split{"brazilian_strength_Pa", "Brazilian strength", NAN, "Pa"};
  for (const SpecimenTests& s : specimens) {
    const auto [young, poisson] = measure::elastic_moduli(s.compression.front());
    const auto coulomb = envelope({&s, 1});
    E.values.push_back(young);
    nu.values.push_back(poisson);
    ucs.values.push_back(s.compression.front().strength);
    tensile.values.push_back(s.tension.strength);
    phi.values.push_back(coulomb.friction_angle);
    c.values.push_back(coulomb.cohesion);
    split.values.push_back(s.brazilian.strength);
  }
  return {E, nu, ucs, tensile, phi, c, split};
}

}  // namespace hfdem::support
