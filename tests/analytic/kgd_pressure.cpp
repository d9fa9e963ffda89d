// Net pressure of viscous KGD fractures: the true values at the injection, the fluid's law along
// the fracture, and elasticity, which must turn the pressure back into the width.
#include <vector>

#include <hfdem/analytic/kgd_general.hpp>

#include "analytic/kgd_truth.hpp"
#include "near.hpp"

using namespace hfdem::analytic;
using test::leaky_rows;
using test::near;
using test::tight_problem;
using test::tight_rows;
using test::unit_problem;

namespace {

/// Opens rock of E' = 1 by a fracture's net pressure: the width is the integral over the wing of
/// 4 p / (pi E') ln |(a + b) / (a - b)|, with a, b = (1 - xi^2)^(1/2), (1 - s^2)^(1/2).
class Opening {
 public:
  explicit Opening(const KgdFracture& f) {
    constexpr int cells = 500;
    for (int k = 0; k < cells; ++k) {
      // s = 1 - y^3: fine where the pressure plunges.
      const double y = (k + 0.5) / cells, s = 1 - y * y * y;
      b_.push_back(std::sqrt(1 - s * s));
      load_.push_back(12 / std::numbers::pi * y * y / cells * f.half_length *
                      f.net_pressure_at(s * f.half_length));
    }
  }
  double width_at(double xi) const {
    const double a = std::sqrt(1 - xi * xi);
    double sum = 0;
    for (std::size_t k = 0; k < b_.size(); ++k)
      sum += load_[k] * std::log(std::abs((a + b_[k]) / (a - b_[k])));
    return sum;
  }

 private:
  std::vector<double> b_, load_;
};

}  // namespace

TEST_CASE("the net pressure at the injection is within 0.9 % of the truth") {
  for (const auto& row : tight_rows) {
    CAPTURE(row.K_m);
    CHECK(general_kgd(tight_problem(row.K_m)).net_pressure == near(row.p, 0.009));
  }
  for (const auto& row : leaky_rows) {
    CAPTURE(row.K_m);
    CAPTURE(row.tau);
    CHECK(general_kgd(unit_problem(row.K_m, row.tau)).net_pressure == near(row.p, 0.009));
  }
}

TEST_CASE("from the injection the pressure falls as Poiseuille's law says, for half the rate") {
  const auto check = [](const KgdProblem& p, const KgdFracture& f) {
    const double step = 1e-5 * f.half_length;
    const double slope = (f.net_pressure_at(step) - f.net_pressure) / step;
    CHECK(slope == near(-12 * p.viscosity * p.rate / 2 / std::pow(f.width, 3), 1e-3));
  };
  for (const double K_m : {0.0, 1.5, 5.0})
    for (const double tau : {1e-8, 1.0, 1e6}) {
      const auto p = unit_problem(K_m, tau);
      check(p, general_kgd(p));
      check(p, storage_viscosity(p));
      check(p, leak_off_viscosity(p));
    }
}

TEST_CASE("what flows past a place is what the fracture beyond it stores and leaks") {
  // Beyond x: volume of one wing, and what it has leaked since the tip passed each point.
  const auto fluid_beyond = [](const KgdFracture& f, double x, double time) {
    double sum = 0;
    constexpr int cells = 4000;
    for (int k = 0; k < cells; ++k) {
      const double y = (k + 0.5) / cells, s = f.half_length - (f.half_length - x) * y * y * y;
      const double passed = time * std::pow(s / f.half_length, 1 / f.flow.growth);
      sum += (f.width_at(s) + 2 * std::sqrt(time - passed)) * 3 * y * y / cells;
    }
    return sum * (f.half_length - x);
  };
  for (const double K_m : {0.2, 1.5, 4.8})
    for (const double tau : {1e-12, 1e-3, 1.0, 1e3}) {
      CAPTURE(K_m);
      CAPTURE(tau);
      const auto f = general_kgd(unit_problem(K_m, tau));
      const double step = 1e-3;
      const auto later = general_kgd(unit_problem(K_m, tau * (1 + step)));
      const auto earlier = general_kgd(unit_problem(K_m, tau * (1 - step)));
      for (const double xi : {0.3, 0.6, 0.9}) {
        CAPTURE(xi);
        const double x = xi * f.half_length;
        const double flow = (fluid_beyond(later, x, tau * (1 + step)) -
                             fluid_beyond(earlier, x, tau * (1 - step))) /
                            (2 * step * tau);
        CHECK(f.flow.at(xi, f.shape) == near(flow / 0.5, 0.01));
      }
    }
}

TEST_CASE("elasticity turns the pressure along the fracture back into the width") {
  const auto check = [](const KgdFracture& f, double tolerance, double near_tip) {
    const Opening opening(f);
    for (const double xi : {0.005, 0.3, 0.5, 0.7, 0.9}) {
      CAPTURE(xi);
      const double width = f.width_at(xi * f.half_length);
      CHECK(opening.width_at(xi) == near(width, xi < 0.8 ? tolerance : near_tip));
    }
  };
  SUBCASE("storage-viscosity vertex") { check(storage_viscosity(tight_problem(0)), 0.01, 0.01); }
  SUBCASE("leak-off-viscosity vertex") {
    check(leak_off_viscosity(unit_problem(0, 1)), 0.02, 0.02);
  }
  SUBCASE("general solution") {
    for (const double K_m : {0.2, 1.5, 4.8})
      for (const double tau : {1e-12, 1e-3, 1e3}) {
        CAPTURE(K_m);
        CAPTURE(tau);
        check(general_kgd(unit_problem(K_m, tau)), 0.02, 0.04);
      }
  }
}

TEST_CASE("the pressure of a viscous fluid falls all the way and without bound at the tip") {
  const auto f = general_kgd(tight_problem(1));
  double last = f.net_pressure;
  for (double xi = 0.05; xi < 1; xi += 0.05) {
    CHECK(f.net_pressure_at(xi * f.half_length) < last);
    last = f.net_pressure_at(xi * f.half_length);
  }
  CHECK(f.net_pressure_at(f.half_length) == -INFINITY);
  CHECK(f.net_pressure_at(-0.5 * f.half_length) == f.net_pressure_at(0.5 * f.half_length));
}
