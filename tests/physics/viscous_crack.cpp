// A crack that a viscous fluid drives, beside the KGD fracture of slits in the same contacts.
// Nothing is fitted to the run. Program `regimes` has more of them, from vertex to vertex.
#include <vector>

#include <hfdem/hfdem.hpp>
#include <hfdem/measure/slit.hpp>
#include <hfdem/measure/toughness.hpp>
#include <hfdem/pressure/implicit.hpp>

#include <doctest/doctest.h>

#include "near.hpp"
#include "support/regimes_reading.hpp"
#include "support/regimes_reference.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

using Viscous = Simulator<LinearParallelBond, HyperbolicAperture, ImplicitFlow<>, FixedPairs>;
using Slit = measure::Slit<LinearParallelBond, HyperbolicAperture, FixedPairs>;

// Strong bonds, a low stress across the crack, a high one along it: it grows straight.
const LinearParallelBond::Params contact{.tensile_strength = 20e6, .cohesion = 200e6};
const HyperbolicAperture::Params aperture{.w0 = 3.5e-6};
constexpr Stress in_situ{5e6, 150e6};
constexpr double disc = 0.01;

/// nu = 0 and G = E / 5, closed forms of the square array with k_n / k_s = 2.5.
const analytic::LatticeFracture lattice{.E = 34e9, .poisson_ratio = 0, .shear_modulus = 6.8e9};

analytic::LatticeFracture measured() {
  constexpr int size = 50;
  std::vector<measure::SlitTest> slits;
  double start = 4e6;
  for (const int contacts : {8, 20}) {
    const Slit slit(square_array({.columns = size, .rows = size}),
                    {.contact = contact,
                     .aperture = aperture,
                     .in_situ = in_situ,
                     .scheme = {.unbalanced_tolerance = 3e-6, .max_mechanical_steps = 100000}},
                    contacts);
    slits.push_back(slit.test(start, 2e-3));
    start = 0.5 * slits.back().net_pressure_at_break;
  }
  const analytic::CrackedPlate plate(disc * size, {34e9, 0, 6.8e9}, analytic::PlateSides::rigid);
  return measure::toughness_test(slits, plate, lattice).rock;
}

using test::near;

}  // namespace

TEST_SUITE("viscous_crack") {
  TEST_CASE("a crack on the edge between viscosity and toughness is the KGD fracture of slits") {
    constexpr double viscosity = 0.1, rate = 3e-4, time = 0.1;
    const analytic::LatticeFracture rock = measured();
    Viscous sim(square_array({.columns = 80, .rows = 80}),
                {.contact = contact,
                 .aperture = aperture,
                 .in_situ = in_situ,
                 .injection = {.rate = rate},
                 .fluid = {.viscosity = viscosity},
                 .scheme = {.fluid_dt = 1e-3, .pressure_floor = -45e6}});
    CrackWatch watch(0.9 * time, in_situ.xx, -45e6);
    sim.run_until(1.1 * time, watch);
    const CrackReading ours = watch.reading(sim);
    const RegimeReference kgd = regime_reference(rock, viscosity, rate, ours.time, disc);
    const auto& f = kgd.fracture;
    const double opening = ours.opening + rock.opening_offset;
    MESSAGE("E' = " << rock.E_prime / 1e9 << " GPa, K_m = " << kgd.K_m() << ", half-length "
                    << ours.half_length << " m (" << f.half_length << "), opening " << opening * 1e6
                    << " um (" << f.width * 1e6 << "), net pressure " << ours.net_pressure / 1e6
                    << " MPa (" << f.net_pressure / 1e6 << ")");
    CHECK(rock.E_prime == near(25.7e9, 0.03));
    CHECK(kgd.K_m() < 1);
    CHECK(std::abs(ours.half_length - f.half_length) < disc);
    CHECK(ours.half_length == near(f.half_length, 0.05));
    CHECK(opening == near(f.width, 0.04));
    CHECK(ours.net_pressure == near(f.net_pressure, 0.07));
    CHECK(ours.off_plane == 0);
    CHECK(ours.unconverged == 0);
    CHECK(ours.lag < 0.1);
  }

  TEST_CASE("without viscosity the reference is the crack that the lattice's toughness allows") {
    const analytic::LatticeFracture rock{.E_prime = 25e9, .K_IC = 2.4e6, .K_IC_per_pressure = 0.06};
    constexpr double rate = 1e-4, time = 0.3;
    const auto exact = analytic::crack_in_plane(rock, rate * time);
    REQUIRE(exact);
    for (const auto at : {ToughnessAt::tip, ToughnessAt::mean, ToughnessAt::injection}) {
      const auto kgd = regime_reference(rock, 1e-12, rate, time, disc, at);
      CHECK(kgd.fracture.full_length() == near(exact->full_length, 1e-3));
      CHECK(kgd.toughness_pressure == near(exact->net_pressure, 1e-3));
    }
  }

  TEST_CASE("what a lattice opens less is added to the volume of the reference") {
    const analytic::LatticeFracture rock{.E_prime = 25e9, .K_IC = 2.4e6, .volume_offset = 5e-6};
    const auto kgd = regime_reference(rock, 0.01, 1e-4, 0.2, disc);
    CHECK(kgd.fracture.volume() == near(1e-4 * 0.2 + kgd.fracture.full_length() * 5e-6, 1e-7));
  }
}
