/// @file
/// What a rock test comes to: its curve, its strength and the bonds that broke in it.
#pragma once

#include <vector>

#include <hfdem/base/vec2.hpp>
#include <hfdem/state/contact.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem::measure {

/// What is read at one moment; stress and strain are positive in the direction of the test.
struct LoadReading {
  double strain;    ///< of the length between the ends
  double stress;    ///< mean of both ends, Pa
  Vec2 shortening;  ///< mean strains of the free grains since loading began; negative in tension
};

/// A bond that broke in a test.
struct TestBreak {
  double strain;            ///< at which it broke; 0 under the confinement alone
  Mode mode;                ///< how
  ContactGeometry contact;  ///< between which discs
};

/// A test that has been made.
struct RockTest {
  double confinement = 0;            ///< Pa
  double strength = 0;               ///< largest stress that an end has carried, Pa
  double strain_at_strength = 0;     ///< -
  long steps = 0;                    ///< mechanical ones, settling included
  std::vector<LoadReading> curve{};  ///< at even strains
  std::vector<TestBreak> breaks{};   ///< in order
  Specimen specimen{};               ///< before the test
  std::vector<Vec2> displacement{};  ///< of the discs at the end, m

  /// All of it.
  void exchange(auto& archive) {
    archive(confinement, strength, strain_at_strength, steps, curve, breaks, specimen,
            displacement);
  }
};

}  // namespace hfdem::measure
