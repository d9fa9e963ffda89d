// A square array, a few fluid steps, and the pressure: about the least that a user of hfdem writes.
#include <iostream>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/base/units.hpp>
#include <hfdem/base/version.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

using namespace hfdem;
using Kgd = Simulator<LinearParallelBond, HyperbolicAperture, UniformPressure, FixedPairs>;

int main() {
  Kgd simulator{square_array(20, 20, 5_mm), {.in_situ = {.xx = 10_MPa, .yy = 12_MPa}}};
  for (int step = 0; step < 5; ++step) simulator.step();
  std::cout << "hfdem " << version << ": " << simulator.injection_pressure() / 1_MPa << " MPa\n";
}
