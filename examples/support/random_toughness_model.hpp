/// @file
/// Modulus and toughness of random rock: parameters, and the file that hands their result on.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include <hfdem/analytic/rock_fracture.hpp>
#include <hfdem/measure/running_crack.hpp>
#include <hfdem/measure/slit_modulus.hpp>
#include <hfdem/setup/random_packing.hpp>

#include "support/growth_prediction.hpp"
#include "support/injected.hpp"
#include "support/toughness_model.hpp"

namespace hfdem::support {

using RandomRock = RockSections<RandomPacking>;

/// How many rocks are tested, and how long their cracks run.
struct SeedStudy {
  int seeds = 3;
  double end_time = 1.5;
  double compare_every = 0.3;
  double opening_reach = 30e-3;

  static constexpr auto fields() {
    using P = SeedStudy;
    return std::tuple{
        Field{"seeds", &P::seeds, "", Range{1, 1000}, "rocks, from specimen.seed on"},
        Field{"end_time", &P::end_time, "s", positive, "injection time of a running crack at most"},
        Field{"compare_every", &P::compare_every, "s", positive,
              "time between two comparisons of the running cracks with the predicted growth"},
        Field{"opening_reach", &P::opening_reach, "m", positive,
              "to both sides of the middle over which a slit's opening is a mean"}};
  }
};

/// The parameter file's sections.
struct RandomToughnessConfig : SectionTree<RandomToughnessConfig> {
  RandomRock rock;
  Mechanics mechanics;
  measure::HeldSlits slits;
  HeldPressure::Params held{.unbalanced_tolerance = 3e-5, .max_mechanical_steps = 100000};
  PresetCrack crack{.length = 0.1};
  Injection injection;
  UniformPressure::Params scheme{.fluid_dt = 1e-3,
                                 .equilibrium = true,
                                 .max_mechanical_steps = 500,
                                 .unbalanced_tolerance = 4e-3};
  measure::RunningRange running;
  SeedStudy study;

  /// Two small rocks.
  static RandomToughnessConfig quick() {
    RandomToughnessConfig config;
    config.rock.specimen.width = config.rock.specimen.height = 0.3;
    config.slits = {.shortest = 0.08,
                    .longest = 0.14,
                    .count = 2,
                    .lowest_pressure = 3e6,
                    .highest_pressure = 6e6,
                    .pressures = 2};
    config.crack.length = 0.04;
    config.scheme.fluid_dt = 2e-4;
    config.study = {.seeds = 2, .end_time = 0.3, .compare_every = 0.05};
    return config;
  }

  /// Checks every section, and what they have to do with each other.
  /// @throws InvalidParameter naming the field, its value and what is allowed
  void check() const {
    validate_all(*this);
    slits.check();
    running.check();
    check_predictable(injection);
    if (rock.in_situ.xx == 0 && rock.in_situ.yy == 0)
      refuse("in_situ", "xx", "0 Pa, and in_situ.yy too,",
             "greater than 0: equilibrium is judged by the forces that the in-situ stress makes");
    check_shape(plate_injection());
    const bool upright = crack_direction(rock.in_situ).y != 0;
    const double along = upright ? rock.specimen.height : rock.specimen.width, most = 0.9 * along;
    if (slits.longest > most)
      refuse("slits", "longest", to_text(slits.longest) + " m",
             "at most " + to_text(most) + " m: a slit needs rock ahead of its tips");
    if (crack.length && *crack.length >= running.from * along)
      refuse("crack", "length", to_text(*crack.length) + " m",
             "less than " + to_text(running.from * along) +
                 " m, running.from of the width: a crack that runs has grown");
    if (study.opening_reach > slits.shortest / 2)
      refuse("study", "opening_reach", to_text(study.opening_reach) + " m",
             "at most " + to_text(slits.shortest / 2) + " m, half of slits.shortest");
    if (study.seeds - 1 > std::numeric_limits<int>::max() - rock.specimen.seed)
      refuse("specimen", "seed", std::to_string(rock.specimen.seed),
             "small enough for study.seeds more");
  }

  /// The running cracks' plate and injection.
  PlateInjection plate_injection() const {
    return {.width = rock.specimen.width,
            .height = rock.specimen.height,
            .boundary = rock.boundary.kind,
            .in_situ = rock.in_situ,
            .rate = injection.rate,
            .preset_length = crack.length.value_or(0)};
  }

  template <class Self, class F>
  static void visit(Self& self, F& f) {
    self.rock.for_each_section(f);
    f("mechanics", self.mechanics);
    f("slits", self.slits);
    f("held", self.held);
    f("crack", self.crack);
    f("injection", self.injection);
    f("scheme", self.scheme);
    f("running", self.running);
    f("study", self.study);
  }
};

/// What a toughness file of random rock holds: the numbers, means over seeds, and the rock that
/// they belong to, with its first seed.
struct MeasuredRock : SectionTree<MeasuredRock> {
  analytic::RockFracture fracture;
  RandomRock rock;

  template <class Self, class F>
  static void visit(Self& self, F& f) {
    f("rock", self.fracture);
    self.rock.for_each_section(f);
  }
};

/// @throws InvalidParameter with the line if the file is not a whole toughness file of random rock
inline MeasuredRock read_rock(const std::string& path) { return read_measured<MeasuredRock>(path); }

}  // namespace hfdem::support
