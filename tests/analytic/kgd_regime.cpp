// Dimensionless numbers and regimes of the KGD fracture.
#include <hfdem/analytic/kgd_regime.hpp>

#include "analytic/kgd_truth.hpp"
#include "near.hpp"

using namespace hfdem::analytic;
using test::near;
using test::tight_problem;
using test::unit_problem;

namespace {

double distance_to(const KgdFracture& vertex, const KgdFracture& f) {
  return std::hypot(std::log(vertex.half_length / f.half_length), std::log(vertex.width / f.width));
}

}  // namespace

TEST_CASE("K_m has the paper's values for its two fluids") {
  // Section 3.1: E' = 39.17 GPa, K_IC = 2.66 MPa m^0.5, 0.5e-4 m2/s, 0.06 cp and 100 cp.
  KgdProblem p{.E_prime = 39.17e9, .K_IC = 2.66e6, .viscosity = 0.06e-3, .rate = 0.5e-4, .time = 1};
  CHECK(dimensionless_toughness(p) == near(6.99, 1.5e-3));
  CHECK(regime(p) == KgdRegime::storage_toughness);
  p.viscosity = 0.1;
  CHECK(dimensionless_toughness(p) == near(1.09, 6e-3));
  CHECK(regime(p) == KgdRegime::transitional);
}

TEST_CASE("tau is E' C'^6 t / (mu' Q^3)") {
  const KgdProblem p{
      .E_prime = 3e10, .viscosity = 0.02, .leak_off = 4e-5, .rate = 2e-4, .time = 70};
  CHECK(dimensionless_time(p) == near(3e10 * std::pow(8e-5, 6) * 70 / (0.24 * 8e-12)));
  CHECK(dimensionless_time(tight_problem(1)) == 0);
  CHECK(dimensionless_time(unit_problem(2, 1e-7)) == near(1e-7));
  CHECK(dimensionless_toughness(unit_problem(2, 1e-7)) == near(2));
}

TEST_CASE("each corner of the map has its regime, and the middle none") {
  CHECK(regime(unit_problem(0.3, 1e-15)) == KgdRegime::storage_viscosity);
  CHECK(regime(unit_problem(10, 1e-15)) == KgdRegime::storage_toughness);
  CHECK(regime(unit_problem(0.3, 1e9)) == KgdRegime::leak_off_viscosity);
  CHECK(regime(unit_problem(10, 1e12)) == KgdRegime::leak_off_toughness);
  CHECK(regime(unit_problem(2, 1e-15)) == KgdRegime::transitional);
  CHECK(regime(unit_problem(10, 1)) == KgdRegime::transitional);
  CHECK(regime(unit_problem(0.3, 1)) == KgdRegime::transitional);
  CHECK(regime(unit_problem(2, 1e12)) == KgdRegime::transitional);
}

TEST_CASE("on the bounds of the regimes the vertex is about 1 % off the general solution") {
  const auto check = [](KgdRegime inside, auto&& vertex, double K_m, double tau, double K_factor,
                        double tau_factor) {
    CAPTURE(K_m);
    CAPTURE(tau);
    const auto p = unit_problem(K_m, tau);
    const double off = distance_to(vertex(p), general_kgd(p));
    CHECK(off > 0.0085);
    CHECK(off < 0.0115);
    CHECK(regime(unit_problem(K_m * K_factor, tau * tau_factor)) == inside);
    CHECK(regime(unit_problem(K_m / K_factor, tau / tau_factor)) == KgdRegime::transitional);
  };
  using enum KgdRegime;
  check(storage_viscosity, hfdem::analytic::storage_viscosity, 0.70, 1e-19, 0.999, 1);
  check(storage_viscosity, hfdem::analytic::storage_viscosity, 0.10, 1.21e-13, 1, 0.999);
  check(storage_toughness, hfdem::analytic::storage_toughness, 4.80, 1e-19, 1.001, 1);
  check(storage_toughness, hfdem::analytic::storage_toughness, 20, 1.25e-14 * 160000, 1, 0.999);
  check(leak_off_viscosity, hfdem::analytic::leak_off_viscosity, 0.90, 1e12, 0.999, 1);
  check(leak_off_viscosity, hfdem::analytic::leak_off_viscosity, 0.10, 2.36e6, 1, 1.001);
  check(leak_off_toughness, hfdem::analytic::leak_off_toughness, 4.80, 1e14, 1.001, 1);
  check(leak_off_toughness, hfdem::analytic::leak_off_toughness, 20, 1.76e5 * 160000, 1, 1.001);
}

TEST_CASE("the nearest vertex is the one with the least distance, zeros included") {
  const auto nearest = [](const KgdProblem& p) { return nearest_vertex(p, general_kgd(p)); };
  CHECK(nearest(unit_problem(0.5, 1e-12)).regime == KgdRegime::storage_viscosity);
  CHECK(nearest(unit_problem(2, 1e-12)).regime == KgdRegime::storage_toughness);
  CHECK(nearest(unit_problem(0.5, 1e3)).regime == KgdRegime::leak_off_viscosity);
  CHECK(nearest(unit_problem(9, 1e6)).regime == KgdRegime::leak_off_toughness);

  const auto p = unit_problem(0.5, 1e-12);
  const auto vertex = nearest(p);
  CHECK(vertex.fracture.half_length == hfdem::analytic::storage_viscosity(p).half_length);
  CHECK(vertex.distance == near(distance_to(vertex.fracture, general_kgd(p))));

  KgdProblem zeros{.E_prime = 1e10, .K_IC = 1e6, .rate = 1e-4, .time = 1};
  CHECK(nearest(zeros).regime == KgdRegime::storage_toughness);
  CHECK(regime(zeros) == KgdRegime::storage_toughness);
  zeros.leak_off = 1;
  CHECK(nearest(zeros).regime == KgdRegime::leak_off_toughness);
  CHECK(regime(zeros) == KgdRegime::leak_off_toughness);
  zeros.K_IC = 0, zeros.viscosity = 0.1;
  CHECK(nearest(zeros).regime == KgdRegime::leak_off_viscosity);
  CHECK(regime(zeros) == KgdRegime::leak_off_viscosity);
  zeros.leak_off = 0;
  CHECK(nearest(zeros).regime == KgdRegime::storage_viscosity);
  CHECK(regime(zeros) == KgdRegime::storage_viscosity);
}
