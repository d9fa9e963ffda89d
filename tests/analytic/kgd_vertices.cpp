// The four vertices of the KGD fracture: published and converged coefficients, and the laws that
// bind length, width and pressure to each other.
#include "analytic/kgd_truth.hpp"
#include "near.hpp"

using namespace hfdem::analytic;
using test::near;

namespace {

constexpr double pi = std::numbers::pi;

// A problem of everyday numbers, none of them 1, and its primed parameters.
const KgdProblem rock{
    .E_prime = 30e9, .K_IC = 1.5e6, .viscosity = 0.1, .leak_off = 2e-5, .rate = 3e-4, .time = 50};
const double E = 30e9, K = 4 * std::sqrt(2 / pi) * 1.5e6, mu = 1.2, C = 4e-5, Q = 3e-4, t = 50;

/// Integral of f over (0, 1), midpoints crowded at 1.
template <class F>
double integral(F&& f) {
  double sum = 0;
  constexpr int cells = 2000;
  for (int k = 0; k < cells; ++k) {
    const double y = (k + 0.5) / cells;
    sum += 3 * y * y * f(1 - y * y * y) / cells;
  }
  return sum;
}

double one_wing(const KgdFracture& f) {
  return f.half_length * integral([&](double xi) { return f.width_at(xi * f.half_length); });
}

}  // namespace

TEST_CASE("the storage-toughness vertex has its published coefficients") {
  const auto f = storage_toughness(rock);
  CHECK(f.half_length == near(0.932387 * std::pow(E * Q * t / K, 2.0 / 3), 2e-6));
  CHECK(f.width == near(0.682784 * std::cbrt(K * K * Q * t / (E * E)), 1e-6));
  CHECK(f.net_pressure == near(0.183074 * std::cbrt(K * K * K * K / (E * Q * t)), 3e-6));
  CHECK(f.efficiency == 1);
}

TEST_CASE("the storage-viscosity vertex has the converged coefficients") {
  const auto f = storage_viscosity(rock);
  CHECK(f.half_length == near(0.615411 * std::pow(E * Q * Q * Q * t * t * t * t / mu, 1.0 / 6)));
  CHECK(f.width == near(1.125835 * std::pow(mu * Q * Q * Q * t * t / E, 1.0 / 6)));
  CHECK(f.net_pressure == near(0.544817 * std::cbrt(mu * E * E / t)));
  CHECK(f.efficiency == 1);
}

TEST_CASE("the leak-off-toughness vertex has its published coefficients") {
  const auto f = leak_off_toughness(rock);
  CHECK(f.half_length == near(Q * std::sqrt(t) / (pi * C)));
  CHECK(f.width == near(0.398942 * std::sqrt(K * K * Q * std::sqrt(t) / (E * E * C)), 1e-6));
  CHECK(f.net_pressure == near(0.313329 * K * std::sqrt(C / (Q * std::sqrt(t))), 2e-6));
  CHECK(f.efficiency == near(pi * f.width * f.half_length / (2 * Q * t)));
}

TEST_CASE("the leak-off-viscosity vertex has the converged coefficients") {
  const auto f = leak_off_viscosity(rock);
  CHECK(f.half_length == near(Q * std::sqrt(t) / (pi * C)));
  CHECK(f.width == near(0.816389 * std::pow(mu * Q * Q * Q * t / (E * C * C), 0.25)));
  CHECK(f.net_pressure == near(0.751469 * std::pow(E * E * E * mu * C * C / (Q * t), 0.25)));
  CHECK(f.efficiency == near(1.459991 * f.width * f.half_length / (Q * t)));
}

TEST_CASE("where all fluid is stored, the volume is what was injected") {
  CHECK(2 * one_wing(storage_toughness(rock)) == near(Q * t, 1e-5));
  CHECK(2 * one_wing(storage_viscosity(rock)) == near(Q * t, 2e-3));  // the shape's error
}

TEST_CASE(
    "where all fluid leaks off, Carter's law from the time of passage loses what was injected") {
  const double l = leak_off_toughness(rock).half_length;  // grows as the square root of time
  const double lost =
      4 * C * std::sqrt(t) * l * integral([](double xi) { return std::sqrt(1 - xi * xi); });
  CHECK(lost == near(Q * t, 1e-5));
}

TEST_CASE("the efficiency is the volume of the fracture over what was injected") {
  const auto tough = leak_off_toughness(rock), viscous = leak_off_viscosity(rock);
  CHECK(tough.efficiency == near(2 * one_wing(tough) / (Q * t), 1e-5));
  CHECK(viscous.efficiency == near(2 * one_wing(viscous) / (Q * t), 0.01));  // the shape's error
  CHECK(viscous.volume() == near(2 * one_wing(viscous), 1e-5));
}

TEST_CASE("a fluid without viscosity presses evenly, and K_I is the toughness") {
  for (const auto& f : {storage_toughness(rock), leak_off_toughness(rock)}) {
    CHECK(f.net_pressure * std::sqrt(pi * f.half_length) == near(rock.K_IC));
    CHECK(f.width == near(4 * f.net_pressure * f.half_length / E));
    CHECK(f.net_pressure_at(0.9 * f.half_length) == f.net_pressure);
    CHECK(f.net_pressure_at(f.half_length) == f.net_pressure);
    CHECK(std::isnan(f.net_pressure_at(1.01 * f.half_length)));
    CHECK(f.width_at(-0.6 * f.half_length) == near(0.8 * f.width));
    CHECK(f.width_at(1.01 * f.half_length) == 0);
  }
}

TEST_CASE("viscous fractures open at the tip as the tip's own solutions say") {
  constexpr double s = 1e-6;  // distance from the tip over l
  const auto m = storage_viscosity(rock);
  const double tip_m = std::cbrt(2 * std::pow(3, 2.5) * mu / E * (2.0 / 3 * m.half_length / t)) *
                       std::pow(s * m.half_length, 2.0 / 3);
  CHECK(m.width_at((1 - s) * m.half_length) == near(tip_m, 1e-3));

  const auto l = leak_off_viscosity(rock);
  const double tip_l = 4 / std::pow(15 * (std::numbers::sqrt2 - 1), 0.25) *
                       std::pow(2 * mu * C / E * std::sqrt(l.half_length / (2 * t)), 0.25) *
                       std::pow(s * l.half_length, 0.625);
  CHECK(l.width_at((1 - s) * l.half_length) == near(tip_l, 1e-3));
}

TEST_CASE("toughness_vertex is the storage-toughness vertex, and nothing at time 0") {
  const auto f = toughness_vertex(E, 1.5e6, Q, t);
  CHECK(f.half_length == storage_toughness(rock).half_length);
  CHECK(f.width == storage_toughness(rock).width);
  CHECK(f.net_pressure == storage_toughness(rock).net_pressure);
  const auto none = toughness_vertex(E, 1.5e6, Q, 0);
  CHECK(none.half_length + none.width + none.net_pressure == 0);
}
