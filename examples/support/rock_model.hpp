/// @file
/// The paper's rock: a crack driven through a random specimen (its Section 4.1), by uniform
/// pressure (cases 2-S1 and 2-S2 of its Table 4) or by a viscous fluid (cases 1-S1 and 1-S2).
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/contact/scattered_parallel_bond.hpp>
#include <hfdem/neighbours/kd_tree.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/setup/random_packing.hpp>
#include <hfdem/simulator.hpp>

#include "support/paper.hpp"
#include "support/run_options.hpp"
#include "support/settings.hpp"

namespace hfdem::support {

/// When pressures are read.
struct Readings {
  double breakdown_from = 0;
  double propagation_from = 0.4;
  double propagation_to = 0.6;

  static constexpr auto fields() {
    using P = Readings;
    return std::tuple{
        Field{"breakdown_from", &P::breakdown_from, "s", non_negative,
              "the breakdown pressure is the highest from this time on: once the pump has come to "
              "its rate"},
        Field{"propagation_from", &P::propagation_from, "s", non_negative,
              "the propagation pressure is the mean injection pressure from this time on"},
        Field{"propagation_to", &P::propagation_to, "s", positive, "and up to this time"}};
  }
};

/// Whether a scheme's parameters are those of uniform pressure, with leak-off or without.
template <class Pressure>
inline constexpr bool knows_one_pressure =
    std::is_same_v<typename Pressure::Params, UniformPressure::Params>;

/// The cases that a scheme can run, the usual one first.
/// @param slick those of carbon dioxide @param viscous those of a viscous fluid
template <class Pressure>
constexpr auto cases_of(std::array<std::string_view, 2> slick,
                        std::array<std::string_view, 2> viscous) {
  if constexpr (FlowScheme<Pressure>)
    return std::array{slick[0], slick[1], viscous[0], viscous[1]};
  else
    return slick;
}

/// A scheme's parameters for random rock.
template <class Pressure>
typename Pressure::Params rock_scheme() {
  if constexpr (knows_one_pressure<Pressure>)
    return {.fluid_dt = 1e-3,
            .equilibrium = true,
            .max_mechanical_steps = 500,
            .unbalanced_tolerance = 5e-3};
  else
    return {.fluid_dt = 2e-3, .unbalanced_tolerance = 5e-3};
}

/// The sections that all programs of random rock share; the defaults are the paper's rock under the
/// stresses of its cases S1.
/// @tparam Contact law between the discs
/// @tparam Pressure scheme
template <class Contact, class Pressure>
struct RockRunSections {
  using Sim = Simulator<Contact, HyperbolicAperture, Pressure, KdTree>;

  RandomPacking specimen{.grains = 17511};
  typename Sim::Params simulator{.crack = {.length = 0.032},
                                 .mechanics = {.settle_tolerance = 5e-4},
                                 .scheme = rock_scheme<Pressure>()};
  RunOptions run{.end_time = 1.5, .output_interval = 1e-3};
  Readings readings;

  /// Stresses and fluid of a case of Table 4: the name ends with those, and its number tells this.
  void load_conditions(std::string_view name) {
    const bool viscous = name.find('1') < name.find('-');
    simulator.in_situ = {.xx = 10e6, .yy = name.ends_with("S2") ? 15e6 : 12e6};
    simulator.fluid.viscosity = viscous ? 0.1 : 6e-5;
    // A viscous fluid finds no way at once through a crack that is pressed shut: at the full rate
    // it would burst the rock around the injection on all sides.
    simulator.injection.rise = viscous ? 0.05 : 0;
    readings.breakdown_from = simulator.injection.rise;
  }

  /// A set of choices, found by trial, that lands on the numbers that the paper prints.
  void load_paper_preset() {
    simulator.channels.length = ChannelLength::bond;
    simulator.boundary.kind = BoundaryKind::dead_loads;
    if constexpr (knows_one_pressure<Pressure>) simulator.scheme = {.fluid_dt = 1e-3};
  }

  /// A tenth of the area, until the crack is as long for its size.
  void shrink() {
    specimen.width = specimen.height = 0.32;
    specimen.grains = 1800;
    run.end_time = 0.15;
    readings.propagation_from = 0.05;
    readings.propagation_to = 0.15;
  }

  /// The stress that holds the crack closed, Pa.
  double closing_stress() const { return std::fmin(simulator.in_situ.xx, simulator.in_situ.yy); }

  template <class Self, class F>
  static void visit(Self& self, F& f) {
    f("specimen", self.specimen);
    hfdem::for_each_section(self.simulator, f);
    f("run", self.run);
    f("readings", self.readings);
  }
};

/// What is printed in the paper of the case that a run is; seed, scheme, mechanics and, as they are
/// not listed there, natural fractures are free.
template <class Config>
paper::Case paper_case(const Config& config) {
  for (const std::string_view name : Config::cases) {
    Config here = config, there;
    there.load_case(name);
    here.specimen.seed = there.specimen.seed;
    here.run = there.run;
    here.readings = there.readings;
    here.simulator.scheme = there.simulator.scheme;
    here.simulator.mechanics = there.simulator.mechanics;
    here.simulator.channels = there.simulator.channels;
    here.simulator.boundary = there.simulator.boundary;
    if constexpr (requires { here.fractures; }) here.fractures = there.fractures;
    if (to_toml(here) == to_toml(there)) return paper::of_case(name);
  }
  return {};
}

/// The parameter file of intact rock; the defaults are those of the first case.
/// @tparam Pressure scheme
template <class Pressure>
struct IntactRock : RockRunSections<ScatteredParallelBond, Pressure>,
                    SectionTree<IntactRock<Pressure>> {
  static constexpr auto cases = cases_of<Pressure>({"2-S1", "2-S2"}, {"1-S1", "1-S2"});

  IntactRock() { load_case(cases.front()); }

  /// Loads a case of the paper's Table 4, with the time of its figures.
  void load_case(std::string_view name) {
    this->load_conditions(name);
    this->run.end_time = name.ends_with("S2") ? 0.9 : 1.5;
  }
};
/// With the pressure that fills the whole crack.
using IntactConfig = IntactRock<UniformPressure>;
using Rock = IntactConfig::Sim;  ///< of these

}  // namespace hfdem::support
