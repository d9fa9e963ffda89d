/// @file
/// Rock that leaks (the paper's Section 5.1, case L1-S1): the rock of case 1-S1, whose intact
/// contacts conduct.
#pragma once

#include <array>
#include <string_view>

#include <hfdem/leakoff/matrix_flow.hpp>
#include <hfdem/pressure/implicit.hpp>
#include <hfdem/pressure/leaky_uniform.hpp>

#include "support/rock_model.hpp"

namespace hfdem::support {

/// The parameter file of rock that leaks.
/// @tparam Pressure scheme with `MatrixFlow`
template <class Pressure>
struct LeakyRock : RockRunSections<ScatteredParallelBond, Pressure>,
                   SectionTree<LeakyRock<Pressure>> {
  /// L2-S1 is not in the paper: its open question, carbon dioxide in the same rock.
  static constexpr std::array<std::string_view, 2> cases{"L1-S1", "L2-S1"};

  LeakyRock() { load_case(cases.front()); }

  /// Loads one of these cases, with the time of the paper's figures.
  void load_case(std::string_view name) {
    this->load_conditions(name);
    this->run.end_time = 1.5;
  }
};

/// The same rock without leak-off. @param leaky whose parameters it takes
template <class Pressure, class Leaky>
IntactRock<Pressure> tight_twin(const Leaky& leaky) {
  IntactRock<Pressure> tight;
  tight.specimen = leaky.specimen;
  tight.run = leaky.run;
  tight.readings = leaky.readings;
  auto& to = tight.simulator;
  const auto& from = leaky.simulator;
  to.contact = from.contact;
  to.aperture = from.aperture;
  to.channels = from.channels;
  to.boundary = from.boundary;
  to.in_situ = from.in_situ;
  to.crack = from.crack;
  to.injection = from.injection;
  to.fluid = from.fluid;
  to.mechanics = from.mechanics;
  to.scheme = from.scheme;
  return tight;
}

}  // namespace hfdem::support
