// The general KGD solution against converged numerical solutions, the exact edge without viscosity,
// its four limits, and the balance of fluid over the whole map of regimes.
#include <vector>

#include <hfdem/analytic/kgd_general.hpp>

#include "analytic/kgd_truth.hpp"
#include "near.hpp"

using namespace hfdem::analytic;
using hfdem::InvalidParameter;
using test::leaky_rows;
using test::near;
using test::tight_problem;
using test::tight_rows;
using test::unit_problem;

namespace {

double per_cent_off(double value, double truth) { return 100 * (value / truth - 1); }

/// Half-length at `time` of a fracture with C' = Q = K'/E' = 1 and no viscosity, by marching: at
/// every length, the time at which the injected fluid fills an ellipse at K_I = K_IC and what has
/// leaked off since each point was passed.
double marched_half_length(double time) {
  std::vector<double> length{0}, passed{0};
  const double first = 1e-4 * std::sqrt(time);
  for (;;) {
    const double l = length.back() + std::fmax(first, 4e-3 * length.back());
    const double stored = std::numbers::pi / 4 * std::pow(l, 1.5) / std::sqrt(2);
    const auto surplus = [&](double t) {
      double lost = 0;
      for (std::size_t k = 1; k < length.size(); ++k) {
        const double since = (passed[k - 1] + passed[k]) / 2;
        lost += (length[k] - length[k - 1]) * std::sqrt(t - since);
      }
      // Over the newest piece the time of passage is nearly linear.
      lost += (l - length.back()) * 2.0 / 3 * std::sqrt(t - passed.back());
      return t / 2 - stored - 2 * lost;
    };
    double low = passed.back(), high = 4 * time;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (surplus(middle) < 0 ? low : high) = middle;
    }
    if (high > time) {
      const double part = (time - passed.back()) / (high - passed.back());
      return length.back() + part * (l - length.back());
    }
    length.push_back(l);
    passed.push_back(high);
  }
}

}  // namespace

TEST_CASE("without leak-off, the general solution is off the truth as published") {
  for (const auto& row : tight_rows) {
    CAPTURE(row.K_m);
    const auto f = general_kgd(tight_problem(row.K_m));
    CHECK(std::abs(per_cent_off(f.half_length, row.l) - row.off_l) < 0.007);
    CHECK(std::abs(per_cent_off(f.width, row.w) - row.off_w) < 0.007);
    CHECK(f.efficiency == 1);
    CHECK(f.flow.growth == near(2.0 / 3, 1e-8));
  }
}

TEST_CASE("with leak-off, the general solution is off the truth as published") {
  for (const auto& row : leaky_rows) {
    CAPTURE(row.K_m);
    CAPTURE(row.tau);
    const auto f = general_kgd(unit_problem(row.K_m, row.tau));
    CHECK(std::abs(per_cent_off(f.half_length, row.l) - row.off_l) < 0.0012);
    CHECK(std::abs(per_cent_off(f.width, row.w) - row.off_w) < 0.0012);
    CHECK(std::abs(f.efficiency - row.efficiency - row.off_efficiency) < 1e-4);
  }
}

TEST_CASE("without viscosity, the length is that of a march through the leak-off's history") {
  for (const double time : {1e-3, 1.0, 30.0, 1e3}) {
    CAPTURE(time);
    // K' = E' = 1: the ellipse at K_I = K_IC is w = (l / 2)^(1/2).
    const auto f = general_kgd({.E_prime = 1,
                                .K_IC = 1 / std::sqrt(32 / std::numbers::pi),
                                .leak_off = 0.5,
                                .rate = 1,
                                .time = time});
    CHECK(f.half_length == near(marched_half_length(time), 2e-3));
    CHECK(f.width == near(std::sqrt(f.half_length / 2), 1e-9));
  }
}

TEST_CASE("the four limits are the four vertices") {
  KgdProblem p{.E_prime = 35e9, .K_IC = 2e6, .rate = 5e-5, .time = 3};
  const auto check = [&](const KgdFracture& vertex, double tolerance, double pressure_tolerance) {
    const auto f = general_kgd(p);
    CHECK(f.half_length == near(vertex.half_length, tolerance));
    CHECK(f.width == near(vertex.width, tolerance));
    CHECK(f.net_pressure == near(vertex.net_pressure, pressure_tolerance));
    CHECK(f.efficiency == near(vertex.efficiency, 0.01));  // at M~ the shape's error
    CHECK(f.shape.mouth == near(vertex.shape.mouth, 1e-3));
    CHECK(f.shape.tip == near(vertex.shape.tip, 1e-3));
    CHECK(f.flow.growth == near(vertex.flow.growth, 1e-3));
  };
  SUBCASE("toughness and storage: exact") { check(storage_toughness(p), 1e-9, 1e-9); }
  SUBCASE("almost no viscosity") {
    p.viscosity = 1e-9;
    check(storage_toughness(p), 1e-4, 1e-4);
  }
  SUBCASE("toughness and leak-off") {
    p.leak_off = 10;
    check(leak_off_toughness(p), 1e-5, 1e-5);
    p.viscosity = 1e-12;
    check(leak_off_toughness(p), 1e-3, 1e-3);
  }
  SUBCASE("viscosity and storage") {
    p.K_IC = 0, p.viscosity = 0.1;
    check(storage_viscosity(p), 1e-3, 3e-3);
    p.K_IC = 1;
    check(storage_viscosity(p), 1e-3, 3e-3);
  }
  SUBCASE("viscosity and leak-off") {
    p.K_IC = 0, p.viscosity = 0.1, p.leak_off = 10;
    check(leak_off_viscosity(p), 1e-3, 3e-3);
    p.K_IC = 1;
    check(leak_off_viscosity(p), 1e-3, 3e-3);
  }
}

TEST_CASE("all over the map, fluid is in the fracture or leaked off since the tip passed") {
  for (const double K_m : {0.1, 0.7, 1.5, 4.8, 20.0})
    for (double tau = 1e-15; tau < 2e10; tau *= 1e5) {
      CAPTURE(K_m);
      CAPTURE(tau);
      const auto f = general_kgd(unit_problem(K_m, tau));
      double in_fracture = 0, leaked = 0;
      constexpr int cells = 2000;
      for (int k = 0; k < cells; ++k) {
        const double y = (k + 0.5) / cells, xi = 1 - y * y * y;
        const double dx = 3 * y * y / cells * f.half_length;
        in_fracture += 2 * dx * f.width_at(xi * f.half_length);
        leaked += 4 * dx * std::sqrt(tau * (1 - std::pow(xi, 1 / f.flow.growth)));
      }
      CHECK(in_fracture == near(f.efficiency * tau, 1e-5));
      CHECK(in_fracture + leaked == near(tau, 1e-5));
      CHECK(in_fracture == near(f.volume(), 1e-5));
    }
}

TEST_CASE("all over the map, the solution is smooth and goes one way") {
  std::vector<KgdFracture> last_row;
  for (double K_m = 0.1; K_m < 20; K_m *= 1.7) {
    std::vector<KgdFracture> row;
    for (double log_tau = -15; log_tau < 10; log_tau += 0.5) {
      const auto f = general_kgd(unit_problem(K_m, std::pow(10, log_tau)));
      CAPTURE(K_m);
      CAPTURE(log_tau);
      if (!row.empty()) {
        const auto& earlier = row.back();
        CHECK(f.width > earlier.width);
        CHECK(f.net_pressure < earlier.net_pressure);
        CHECK(f.efficiency < earlier.efficiency);
        // The growth it states is the growth it shows.
        const double growth = 2 * std::log10(f.half_length / earlier.half_length);
        CHECK(growth == near((f.flow.growth + earlier.flow.growth) / 2, 5e-3));
      }
      if (row.size() < last_row.size()) {
        const auto& softer = last_row[row.size()];
        CHECK(f.half_length < softer.half_length);
        CHECK(f.width > softer.width);
        CHECK(f.net_pressure > softer.net_pressure);
      }
      row.push_back(f);
    }
    last_row = row;
  }
}

TEST_CASE("the solution depends on the problem through its two dimensionless numbers alone") {
  const double E = 2e10, mu = 0.3, Q = 7e-4, C = 3e-5, K_m = 1.6, tau = 1e-3;
  const double time = tau * mu * Q * Q * Q / (E * std::pow(C, 6));
  const auto f = general_kgd(
      {.E_prime = E,
       .K_IC = K_m * std::pow(mu * E * E * E * Q, 0.25) / std::sqrt(32 / std::numbers::pi),
       .viscosity = mu / 12,
       .leak_off = C / 2,
       .rate = Q,
       .time = time});
  const auto unit = general_kgd(unit_problem(K_m, tau));
  const double strain = C * C / Q, length = std::sqrt(mu / E) * std::pow(Q, 2.5) / std::pow(C, 4);
  CHECK(f.half_length == near(length * unit.half_length, 1e-9));
  CHECK(f.width == near(strain * length * unit.width, 1e-9));
  CHECK(f.net_pressure == near(strain * E * unit.net_pressure, 1e-9));
  CHECK(f.efficiency == near(unit.efficiency, 1e-9));
}

TEST_CASE("zeros and extreme numbers have finite answers") {
  for (const double E : {1e-20, 1e20})
    for (const double K : {0.0, 1e-300, 1e20})
      for (const double mu : {0.0, 1e-300, 1e20})
        for (const double C : {0.0, 1e-300, 1e20})
          for (const double Q : {1e-20, 1e20})
            for (const double t : {1e-20, 1e20}) {
              if (K < 1 && mu < 1) continue;
              const auto f = general_kgd({E, K, mu, C, Q, t});
              for (const double v : {f.half_length, f.width, f.net_pressure, f.efficiency})
                CHECK((std::isfinite(v) && v > 0));
              CHECK(f.efficiency <= 1);
            }
}

TEST_CASE("problems without a solution are refused") {
  const KgdProblem good{.E_prime = 1e9, .K_IC = 1e6, .rate = 1e-4, .time = 1};
  CHECK_NOTHROW(general_kgd(good));
  const auto refused = [&](double KgdProblem::*member, double value, const char* words) {
    KgdProblem bad = good;
    bad.*member = value;
    CHECK_THROWS_WITH_AS(general_kgd(bad), doctest::Contains(words), InvalidParameter);
  };
  refused(&KgdProblem::K_IC, 0, "K_IC = 0 Pa m^0.5 together with viscosity = 0");
  refused(&KgdProblem::E_prime, 0, "kgd.E_prime = 0 Pa is not allowed");
  refused(&KgdProblem::rate, -1, "kgd.rate = -1 m2/s is not allowed");
  refused(&KgdProblem::time, std::nan(""), "kgd.time = nan s is not allowed");
  refused(&KgdProblem::leak_off, -1e-9, "kgd.leak_off = -1e-09");
  refused(&KgdProblem::viscosity, INFINITY, "kgd.viscosity = inf Pa s");
}
