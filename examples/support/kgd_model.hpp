/// @file
/// The paper's verification model: a crack driven through a square array by uniform pressure.
#pragma once

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

#include "support/run_options.hpp"
#include "support/settings.hpp"

namespace hfdem::support {

/// The parameter file's sections.
/// @tparam Pressure scheme
template <class Pressure>
struct KgdConfig : SectionTree<KgdConfig<Pressure>> {
  using Sim = Simulator<LinearParallelBond, HyperbolicAperture, Pressure, FixedPairs>;

  SquareArray specimen;
  typename Sim::Params simulator;
  RunOptions run;

  /// A 40 x 40 array, until its crack is as long for its size as the default one's.
  static KgdConfig quick() {
    KgdConfig config;
    config.specimen.columns = config.specimen.rows = 40;
    config.run.end_time = 0.2;
    return config;
  }

  template <class Self, class F>
  static void visit(Self& self, F& f) {
    f("specimen", self.specimen);
    hfdem::for_each_section(self.simulator, f);
    f("run", self.run);
  }
};

}  // namespace hfdem::support
