/// @file
/// The paper's rock: a crack driven through a random specimen by uniform pressure (its Section 4.1,
/// cases 2-S1 and 2-S2 of its Table 4).
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/contact/scattered_parallel_bond.hpp>
#include <hfdem/neighbours/kd_tree.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/setup/random_packing.hpp>
#include <hfdem/simulator.hpp>

#include "support/run_options.hpp"
#include "support/settings.hpp"

namespace hfdem::support {

using Rock = Simulator<ScatteredParallelBond, HyperbolicAperture, UniformPressure, KdTree>;

/// When the propagation pressure is read.
struct Readings {
  double propagation_from = 0.4;
  double propagation_to = 0.6;

  static constexpr auto fields() {
    using P = Readings;
    return std::tuple{
        Field{"propagation_from", &P::propagation_from, "s", non_negative,
              "the propagation pressure is the mean injection pressure from this time on"},
        Field{"propagation_to", &P::propagation_to, "s", positive, "and up to this time"}};
  }
};

/// The sections that all programs of random rock share; the defaults are the paper's rock under the
/// stresses of its cases S1.
/// @tparam Simulated the simulator
template <class Simulated>
struct RockRunSections {
  using Sim = Simulated;

  RandomPacking specimen{.grains = 17511};
  typename Sim::Params simulator{.crack = {.length = 0.032},
                                 .mechanics = {.settle_tolerance = 5e-4},
                                 .scheme = {.fluid_dt = 1e-3,
                                            .equilibrium = true,
                                            .max_mechanical_steps = 500,
                                            .unbalanced_tolerance = 5e-3}};
  RunOptions run{.end_time = 1.5, .output_interval = 1e-3};
  Readings readings;

  /// A set of choices, found by trial, that lands on the numbers that the paper prints.
  void load_paper_preset() {
    simulator.channels.length = ChannelLength::bond;
    simulator.boundary.kind = BoundaryKind::dead_loads;
    simulator.scheme = {.fluid_dt = 1e-3};
  }

  /// A tenth of the area, until the crack is as long for its size.
  void shrink() {
    specimen.width = specimen.height = 0.32;
    specimen.grains = 1800;
    run.end_time = 0.15;
    readings = {.propagation_from = 0.05, .propagation_to = 0.15};
  }

  /// The stress that holds the crack closed, Pa.
  double closing_stress() const { return std::fmin(simulator.in_situ.xx, simulator.in_situ.yy); }

  // Whether a run may stand beside the paper's numbers for a case; a program says so of its own.
  bool is_paper_case_S1() const { return false; }     ///< 2-S1
  bool is_paper_case_N2_S2() const { return false; }  ///< N2-S2

  template <class Self, class F>
  static void visit(Self& self, F& f) {
    f("specimen", self.specimen);
    hfdem::for_each_section(self.simulator, f);
    f("run", self.run);
    f("readings", self.readings);
  }
};

/// Whether a run is in the rock and under the stresses of a case; seed, scheme and mechanics are
/// free.
template <class Config>
bool is_case(Config mine, const Config& paper) {
  mine.specimen.seed = paper.specimen.seed;
  mine.run = paper.run;
  mine.readings = paper.readings;
  mine.simulator.scheme = paper.simulator.scheme;
  mine.simulator.mechanics = paper.simulator.mechanics;
  mine.simulator.channels = paper.simulator.channels;
  mine.simulator.boundary = paper.simulator.boundary;
  return to_toml(mine) == to_toml(paper);
}

/// The parameter file of intact rock; the defaults are case 2-S1.
struct IntactConfig : RockRunSections<Rock>, SectionTree<IntactConfig> {
  static constexpr std::array<std::string_view, 2> cases{"2-S1", "2-S2"};

  /// Loads a case of the paper's Table 4, with the time of its figures.
  void load_case(std::string_view name) {
    const bool second = name == cases[1];
    simulator.in_situ = {.xx = 10e6, .yy = second ? 15e6 : 12e6};
    run.end_time = second ? 0.9 : 1.5;
  }

  bool is_paper_case_S1() const { return is_case(*this, {}); }
};

}  // namespace hfdem::support
