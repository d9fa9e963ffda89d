// A host code that owns the fluid: a pump fills a wellbore, in which the fluid is compressible, and
// hfdem is the rock around it. Exchange after exchange the host reads how far the crack has opened,
// computes the pressure, and hands it back.
//
//   host_code/build/wellbore
//
// You should see the pressure rise until the first bond breaks, and the crack then take fluid out
// of the wellbore. The last line is
//   breakdown at 17.9 MPa, with the walls 19.7 um apart
#include <algorithm>
#include <cstdio>
#include <span>
#include <utility>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/base/units.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/pressure/held.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

using namespace hfdem;
using Rock = Simulator<LinearParallelBond, HyperbolicAperture, HeldPressure, FixedPairs>;

namespace {

/// The host's own model: what is pumped either compresses the fluid or goes into the crack.
/// Volumes are per metre of thickness.
struct Wellbore {
  double storage = 5e-13;    // volume that a pressure of 1 Pa stores, m2/Pa
  double rate = 0.5e-4;      // of the pump, m2/s
  double dt = 1e-3;          // between two exchanges, s
  double pressure = 14_MPa;  // when the pump starts

  void pump(double into_crack) { pressure += (rate * dt - into_crack) / storage; }
};

/// What the crack has opened, m2: from the aperture of each channel that holds fluid.
double opened_volume(const Network& network) {
  double volume = 0;
  for (const Index c : network.wet_channels())
    volume += network.geometry().channels[c].length * (network.width(c) - network.rest_width(c));
  return volume;
}

/// How far the two walls in the middle of the crack have moved apart, m: from the displacements.
double wall_opening(const Rock& rock) {
  const std::span<const Pack> displacement = rock.discs().displacement;  // x, y, rotation
  const auto [left, right] = rock.contacts().bodies(rock.preset_contacts().front());
  return displacement[right][0] - displacement[left][0];
}

}  // namespace

int main() {
  Wellbore well;
  Rock rock{
      square_array(40, 40, 5_mm),
      {.scheme = {.pressure = well.pressure, .fluid_dt = well.dt, .unbalanced_tolerance = 1e-5}}};
  rock.step();
  double opened = opened_volume(rock.network()), peak = 0, intact_opening = 0;

  while (well.pressure > 0.95 * peak) {
    peak = std::max(peak, well.pressure);
    rock.pressure_scheme().hold(well.pressure);
    rock.step();
    if (rock.breaks().empty()) intact_opening = wall_opening(rock);
    std::printf("t = %.3f s   pressure %.2f MPa   walls %5.2f um apart   %zu bonds broken\n",
                rock.time(), well.pressure / 1_MPa, wall_opening(rock) / 1_um,
                rock.breaks().size());
    const double before = std::exchange(opened, opened_volume(rock.network()));
    well.pump(opened - before);
  }
  std::printf("breakdown at %.1f MPa, with the walls %.1f um apart\n",
              rock.breaks().front().pressure / 1_MPa, intact_opening / 1_um);
}
