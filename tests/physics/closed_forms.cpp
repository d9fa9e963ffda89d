// Elastic moduli and the KGD vertex against closed forms.
#include <cmath>

#include <hfdem/hfdem.hpp>

#include <doctest/doctest.h>

#include "near.hpp"
#include "truth/static_lattice.hpp"

using namespace hfdem;

namespace {
using test::near;
}  // namespace

TEST_SUITE("closed_forms") {
  TEST_CASE("the square array has E = E_c + E_b and no Poisson effect") {
    const LinearParallelBond::Params contact;
    const auto moduli = measure::elastic_moduli<LinearParallelBond, FixedPairs>(
        square_array({}), contact, {10_MPa, 12_MPa});
    CHECK(moduli.young == near(contact.E + contact.bond_E, 1e-5));
    CHECK(std::abs(moduli.poisson) < 1e-5);
  }

  TEST_CASE("the moduli follow the contact's, whatever the disc's size") {
    const auto moduli = measure::elastic_moduli<LinearParallelBond, FixedPairs>(
        square_array(20, 30, 2_mm), {.E = 20_GPa, .bond_E = 5_GPa}, {10_MPa, 12_MPa});
    CHECK(moduli.young == near(25_GPa, 1e-5));
  }

  TEST_CASE("the independent lattice has the same moduli") {
    const auto moduli = truth::moduli({});
    CHECK(moduli.E == near(34_GPa, 1e-6));
    CHECK(std::abs(moduli.nu) < 1e-6);
  }

  TEST_CASE("the toughness vertex gives the values of the reference tables") {
    // E' = 35.1 GPa, K_IC = 1.88 MPa sqrt(m), Q = 0.5e-4 m2/s at 0.1 s and 0.9 s, infinite plane.
    const auto early = analytic::toughness_vertex(35.1e9, 1.88e6, 0.5e-4, 0.1);
    CHECK(early.full_length() == near(0.1770, 5e-4));
    CHECK(early.width == near(35.96e-6, 5e-4));
    CHECK(early.net_pressure == near(3.5652e6, 5e-5));
    const auto late = analytic::toughness_vertex(35.1e9, 1.88e6, 0.5e-4, 0.9);
    CHECK(late.full_length() == near(0.7660, 5e-4));
    CHECK(late.width == near(74.80e-6, 5e-4));
    CHECK(late.net_pressure == near(1.7139e6, 5e-5));
  }

  TEST_CASE("at the toughness vertex an ellipse holds the injected volume at K_I = K_IC") {
    const double E = 30e9, K = 1.5e6, rate = 1e-4, time = 2;
    const auto kgd = analytic::toughness_vertex(E, K, rate, time);
    CHECK(std::numbers::pi / 2 * kgd.half_length * kgd.width == near(rate * time, 1e-12));
    CHECK(kgd.net_pressure * std::sqrt(std::numbers::pi * kgd.half_length) == near(K, 1e-12));
    CHECK(kgd.width == near(4 * kgd.net_pressure * kgd.half_length / E, 1e-12));
    CHECK(kgd.width_at(0.6 * kgd.half_length) == near(0.8 * kgd.width, 1e-12));
    CHECK(kgd.width_at(1.1 * kgd.half_length) == 0);
  }
}
