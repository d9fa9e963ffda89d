// A crack driven by fluid through a square array of bonded discs, step by step.
//
//   build/release/examples/first_crack
//
// You should see the crack jump one disc at each tip, again and again, while the pressure falls
// from 18 MPa towards the 10 MPa that hold it closed. The last line is
//   t = 0.180 s   length 0.26 m   pressure 12.9 MPa
#include <cstdio>

#include <hfdem/hfdem.hpp>

using namespace hfdem;

// The policies are the model: composed at compile time, each can be replaced by your own.
using Kgd = Simulator<LinearParallelBond, HyperbolicAperture, UniformPressure, FixedPairs>;

int main() {
  Kgd sim{square_array(100, 100, 5_mm),
          {.contact = {.E = 17_GPa, .tensile_strength = 8_MPa, .cohesion = 15_MPa},
           .in_situ = {.xx = 10_MPa, .yy = 12_MPa},
           .injection = {.rate = 0.5e-4}}};

  std::size_t broken = 0;
  while (sim.time() < 0.2_s) {
    sim.step();
    if (sim.breaks().size() == broken) continue;
    broken = sim.breaks().size();
    std::printf("t = %.3f s   length %.2f m   pressure %.1f MPa\n", sim.time(),
                measure::crack_shape(sim).full_length(), sim.injection_pressure() / 1_MPa);
  }
}
