/// @file
/// Cracks from the toughness vertex to the viscosity vertex: the arrays of discs, and what is
/// injected into them.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/leakoff/carter.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/pressure/implicit.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

#include "support/settings.hpp"
#include "support/toughness_model.hpp"

namespace hfdem::support {

using RegimeArray = Simulator<LinearParallelBond, HyperbolicAperture,
                              ImplicitFlow<NewtonianFluid, CarterLeakoff>, FixedPairs>;

/// What makes an array of discs tough: the strength of its contacts and the stress that closes
/// them. The stress along the crack is high, so that it grows straight: fluid that has just entered
/// pushes the discs apart along the crack, too.
struct RegimeRock {
  double tensile_strength = 0;
  double across = 0;
  double along = 0;
  double aperture = 0;

  static constexpr auto fields() {
    using P = RegimeRock;
    return std::tuple{
        Field{"tensile_strength", &P::tensile_strength, "Pa", positive, "of the bonds"},
        Field{"across", &P::across, "Pa", positive, "in-situ stress across the crack"},
        Field{"along", &P::along, "Pa", positive, "in-situ stress along the crack"},
        Field{"aperture", &P::aperture, "m", positive,
              "residual aperture w0; about as much as slits open less than a continuum's, so that "
              "a channel is as wide as the continuum's crack"}};
  }

  /// The array that slits test, and runs. Bonds fail in tension alone.
  Lattice lattice(int discs) const {
    return {{},
            {.columns = discs, .rows = discs},
            {.tensile_strength = tensile_strength, .cohesion = 200e6},
            {.w0 = aperture},
            {},
            {across, along}};
  }
};

enum class RockKind { tough, weak };

}  // namespace hfdem::support

namespace hfdem {
template <>
inline constexpr std::array<std::string_view, 2> names_of<support::RockKind>{"tough", "weak"};
}  // namespace hfdem

namespace hfdem::support {

/// One crack.
struct RegimeCase {
  RockKind rock = RockKind::tough;
  int discs = 0;
  double viscosity = 0;
  double rate = 0;
  double time = 0;
  double pressure_floor = 0;
  double leakoff = 0;
  double fluid_dt = 1e-3;

  static constexpr auto fields() {
    using P = RegimeCase;
    return std::tuple{
        Field{"rock", &P::rock, "", any_number, "the array's contacts"},
        Field{"discs", &P::discs, "", Range{20, 1000}, "along each side"},
        Field{"viscosity", &P::viscosity, "Pa s", positive, "of the fluid"},
        Field{"rate", &P::rate, "m2/s", positive, "total injection rate"},
        Field{"time", &P::time, "s", positive, "of injection, around which the crack is compared"},
        Field{"pressure_floor", &P::pressure_floor, "Pa", any_number,
              "least pressure of the fluid: suction that the bonds beside it bear"},
        Field{"leakoff", &P::leakoff, "m/s^0.5", non_negative, "Carter's coefficient C_L"},
        Field{"fluid_dt", &P::fluid_dt, "s", positive,
              "longest fluid time step: in one of them, walls that have just turned wet must not "
              "lose many times what is between them"}};
  }
};

/// When a fluid step ends, as in `ImplicitFlow`.
struct RegimeSteps {
  double unbalanced_tolerance = 1e-3;

  static constexpr auto fields() {
    using P = RegimeSteps;
    return std::tuple{
        Field{"unbalanced_tolerance", &P::unbalanced_tolerance, "", positive,
              "largest resultant on a disc over the mean contact force at equilibrium"}};
  }
};

/// How much is studied, and how it is read.
struct RegimesStudy {
  int cracks = 9;
  double window = 0.1;
  int slit_discs = 60;

  static constexpr auto fields() {
    using P = RegimesStudy;
    return std::tuple{
        Field{"cracks", &P::cracks, "", Range{1, 9}, "how many, from the toughness vertex on"},
        Field{"window", &P::window, "", Range{0.01, 0.5},
              "half the time over which means are taken, over the time itself"},
        Field{"slit_discs", &P::slit_discs, "", Range{20, 1000},
              "along each side of the arrays with slits"}};
  }
};

/// The parameter file's sections.
struct RegimesConfig : SectionTree<RegimesConfig> {
  /// The strength of the one gives wide cracks; the other breaks at little more than the stress
  /// that closes it, which leaves the fluid room for suction at the tips.
  RegimeRock tough{.tensile_strength = 20e6, .across = 5e6, .along = 150e6, .aperture = 3.5e-6};
  RegimeRock weak{.tensile_strength = 2.4e6, .across = 20e6, .along = 150e6, .aperture = 8e-6};
  RegimeSteps steps;
  measure::SlitSeries slits{.shortest = 8, .longest = 24, .count = 2, .accuracy = 2e-3};
  RegimesStudy study;
  /// From the toughness vertex to the viscosity vertex, then with leak-off. Where the walls at the
  /// tips take all fluid that comes, suction that no fluid bears would hold the crack shut.
  std::array<RegimeCase, 9> cracks{
      RegimeCase{RockKind::tough, 120, 1e-4, 1e-4, 0.35, -45e6},
      RegimeCase{RockKind::tough, 100, 1e-3, 1e-4, 0.25, -45e6},
      RegimeCase{RockKind::tough, 100, 1e-2, 2e-4, 0.12, -45e6},
      RegimeCase{RockKind::tough, 120, 0.1, 3e-4, 0.16, -45e6},
      RegimeCase{RockKind::weak, 200, 0.2, 6e-4, 0.4, -16e6},
      RegimeCase{RockKind::tough, 100, 1e-4, 3e-4, 0.3, -45e6, 1.2e-4},
      RegimeCase{RockKind::tough, 200, 1e-4, 1.03e-4, 21.6, -45e6, 1.83e-4, 1e-2},
      RegimeCase{RockKind::weak, 200, 1e-3, 3.667e-3, 0.08175, -16e6, 2.75e-4, 2e-4},
      RegimeCase{RockKind::weak, 200, 1e-3, 3.667e-3, 0.8166, 0, 1.275e-3, 4e-4}};

  /// Of the cracks, as sections and files have them.
  static constexpr std::array<std::string_view, 9> names{
      "toughness_vertex",         "toughness_edge",         "middle",
      "viscosity_edge",           "viscosity_vertex",       "leakoff_toughness_edge",
      "leakoff_toughness_vertex", "leakoff_viscosity_edge", "leakoff_viscosity_vertex"};

  /// Two cracks on the edge, while they are short.
  void shrink() {
    study.cracks = 2;
    study.slit_discs = 40;
    slits = {.shortest = 6, .longest = 14, .count = 2, .accuracy = 1e-2};
    cracks[0] = {RockKind::tough, 40, 1e-3, 2e-4, 0.02, -45e6};
    cracks[1] = {RockKind::tough, 40, 1e-2, 2e-4, 0.02, -45e6};
  }

  const RegimeRock& rock(RockKind kind) const { return kind == RockKind::tough ? tough : weak; }

  std::size_t cracks_run() const { return static_cast<std::size_t>(study.cracks); }

  /// The rocks that are studied.
  std::vector<RockKind> rocks() const {
    std::vector<RockKind> all;
    for (std::size_t k = 0; k < cracks_run(); ++k)
      if (std::find(all.begin(), all.end(), cracks[k].rock) == all.end())
        all.push_back(cracks[k].rock);
    return all;
  }

  /// The slits of a rock: equilibrium as tight as their pressures need.
  ToughnessConfig slits_of(RockKind kind) const {
    return {{},
            rock(kind).lattice(study.slit_discs),
            {},
            {.unbalanced_tolerance = 3e-6, .max_mechanical_steps = 100000},
            slits};
  }

  /// What a crack runs through, and with what.
  RegimeArray::Params params(const RegimeCase& crack) const {
    const Lattice l = rock(crack.rock).lattice(crack.discs);
    return {.contact = l.contact,
            .aperture = l.aperture,
            .boundary = l.boundary,
            .in_situ = l.in_situ,
            .injection = {.rate = crack.rate},
            .fluid = {.viscosity = crack.viscosity},
            .leakoff = {.coefficient = crack.leakoff},
            .scheme = {.fluid_dt = crack.fluid_dt,
                       .unbalanced_tolerance = steps.unbalanced_tolerance,
                       .pressure_floor = crack.pressure_floor}};
  }

  template <class Self, class F>
  static void visit(Self& self, F& f) {
    f("tough", self.tough);
    f("weak", self.weak);
    f("steps", self.steps);
    f("slits", self.slits);
    f("study", self.study);
    for (std::size_t k = 0; k < names.size(); ++k) f(names[k], self.cracks[k]);
  }
};

}  // namespace hfdem::support
