// A contact law of your own, from one that is there: bonds like hinges, which carry no moment (as
// the contact bonds of Potyondy & Cundall 2004, Int. J. Rock Mech. Min. Sci. 41, 1329-1364).
//
//   build/release/examples/own_contact_law
//
// You should see that a crack needs a higher pressure where moments do not help to break bonds:
//   parallel bonds: the first one breaks at 17.9 MPa
//   hinges: the first one breaks at 21.0 MPa
#include <cstdio>

#include <hfdem/hfdem.hpp>

using namespace hfdem;

/// Everything but the moment is that of the parallel bond, its parameters and strengths included.
class Hinge : public LinearParallelBond {
 public:
  using LinearParallelBond::LinearParallelBond;

  Springs springs(const Stiffness<double>& k) const noexcept {
    const Springs bond = LinearParallelBond::springs(k);
    return {.normal = bond.normal, .shear = bond.shear, .moment = 0};
  }

  template <class T>
  Response<T> respond(const Stiffness<T>& k, const Memory<T>& memory,
                      const Motion<T>& motion) const noexcept {
    Response<T> response = LinearParallelBond::respond(k, memory, motion);
    response.bond_moment = T{};
    return response;
  }
};

template <class Law>
double breakdown_pressure() {
  Simulator<Law, HyperbolicAperture, UniformPressure, FixedPairs> sim{
      square_array(40, 40, 5_mm), {.scheme = {.equilibrium = true}}};
  while (sim.breaks().empty()) sim.step();
  return sim.breaks().front().pressure / 1_MPa;
}

int main() {
  std::printf("parallel bonds: the first one breaks at %.1f MPa\n",
              breakdown_pressure<LinearParallelBond>());
  std::printf("hinges: the first one breaks at %.1f MPa\n", breakdown_pressure<Hinge>());
}
