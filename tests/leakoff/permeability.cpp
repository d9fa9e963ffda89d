// The permeability of a lattice is that of its channels.
#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/measure/permeability.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/neighbours/kd_tree.hpp>
#include <hfdem/pressure/dry.hpp>
#include <hfdem/setup/random_packing.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

using namespace hfdem;
using test::near;

TEST_CASE("a square lattice lets fluid through as its channels do") {
  Simulator<LinearParallelBond, HyperbolicAperture, Dry, FixedPairs> sim(
      square_array(30, 20, 5e-3),
      {.in_situ = {10e6, 12e6}, .mechanics = {.settle_tolerance = 1e-9}});
  const HyperbolicAperture law({});
  const auto k = measure::permeability(sim, law);
  // Fluid that flows along x passes the contacts that y presses, and the other way round.
  const auto of = [&](double stress) {
    const double w = law.width(law.rest_width(), stress * 0.01, 0);
    return w * w * w / (12 * 0.01);
  };
  // The half squares at the rim hold no channel: 19 rows of domains in 20 diameters.
  CHECK(k.along_x == near(of(12e6) * 19 / 20, 3e-3));
  CHECK(k.along_y == near(of(10e6) * 29 / 30, 3e-3));
}

TEST_CASE("random rock under an even stress lets fluid through alike in all directions") {
  Simulator<LinearParallelBond, HyperbolicAperture, Dry, KdTree> sim(
      random_packing({.width = 0.3, .height = 0.3, .grains = 1576}), {.in_situ = {10e6, 10e6}});
  const auto k = measure::permeability(sim, HyperbolicAperture({}));
  CHECK(k.along_x == near(k.along_y, 0.1));
  CHECK(k.along_x > 1e-17);
  CHECK(k.along_x < 1e-15);
}
