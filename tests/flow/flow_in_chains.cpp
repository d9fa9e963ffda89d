// Flow through channels whose walls do not move, by both schemes, against closed forms.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <hfdem/pressure/conventional.hpp>
#include <hfdem/pressure/implicit.hpp>

#include <doctest/doctest.h>

#include "flow/chain.hpp"
#include "near.hpp"

namespace {

using hfdem::NewtonianFluid;
using test::Chain;
using test::near;
using Explicit = hfdem::ConventionalFlow<>;
using Implicit = hfdem::ImplicitFlow<>;

constexpr double viscosity = 0.1, modulus = 2e9, width = 5e-5;
const NewtonianFluid fluid({.viscosity = viscosity, .bulk_modulus = modulus});
constexpr double diffusivity = modulus * width * width / (12 * viscosity);  // m2/s
constexpr double flow_limit =
    6 * viscosity * Chain::length * Chain::length / (modulus * width * width);

/// Of the pressures in a chain of ten equal channels, at a tenth of the time in which pressure
/// gets from the injection to its end.
struct Short {
  static constexpr std::size_t channels = 10, injection = 3;
  static constexpr double time = 49 * Chain::length * Chain::length / diffusivity / 10;
  static constexpr double rate = 1e-6;

  template <class Scheme>
  static std::vector<double> after(Scheme scheme, int steps) {
    Chain chain(channels, width, injection);
    for (int n = 0; n < steps; ++n) chain.inject(scheme, rate, time / steps);
    return chain.pressures();
  }
  static std::vector<double> exactly() {
    return test::exact_pressures(Chain(channels, width, injection), injection, viscosity, modulus,
                                 rate, time);
  }
};

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double squares = 0;
  for (std::size_t d = 0; d < a.size(); ++d) squares += (a[d] - b[d]) * (a[d] - b[d]);
  return std::sqrt(squares);
}

Implicit implicit() { return {{}, fluid, test::rigid_walls}; }
/// @param share of the stable step; not validated
Explicit explicitly(double share = 0.8, double floor = 0) {
  return {{.limit_fraction = share, .pressure_floor = floor}, fluid, test::rigid_walls};
}

}  // namespace

// ---- the implicit scheme ------------------------------------------------------------------------

TEST_CASE("the implicit scheme is of first order in the fluid step") {
  const std::vector<double> exact = Short::exactly();
  // Well below the time in which a domain fills its neighbours, and up to a tenth of the whole.
  for (const int steps : {10, 40, 1000}) {
    const double coarse = difference(Short::after(implicit(), steps), exact);
    const double fine = difference(Short::after(implicit(), 2 * steps), exact);
    CAPTURE(steps);
    CHECK(std::log2(coarse / fine) > 0.9);
    CHECK(std::log2(coarse / fine) < 1.1);
  }
}

TEST_CASE("the implicit scheme is stable and monotone at ten thousand times the explicit limit") {
  constexpr std::size_t injection = 12;
  Chain chain(40, width, injection);
  Implicit scheme = implicit();
  const double dt = 1e4 * flow_limit;
  std::vector<double> before(chain.size(), 0);
  for (int n = 0; n < 20; ++n) {
    const hfdem::FluidStep step = chain.inject(scheme, 1e-7, dt);
    CHECK(step.converged);
    CHECK(step.mechanical_steps == 1);  // linear: one Newton step
    CHECK(step.volume_error < 1e-9);
    double held = 0;
    for (std::size_t d = 0; d < chain.size(); ++d) {
      CHECK(chain.pressure(d) > before[d]);
      if (d < injection) CHECK(chain.pressure(d) < chain.pressure(d + 1));
      if (d > injection) CHECK(chain.pressure(d) < chain.pressure(d - 1));
      held += chain.room(d) * chain.pressure(d) / modulus;
    }
    CHECK(held == near(chain.injected(), 1e-9));
    before = chain.pressures();
  }
}

TEST_CASE("both schemes agree as the step goes to zero, in proportion to it") {
  const int steps = static_cast<int>(std::ceil(Short::time / (0.75 * flow_limit)));
  double previous = 0;
  for (const int finer : {1, 2, 4}) {
    const double apart = difference(Short::after(implicit(), finer * steps),
                                    Short::after(explicitly(), finer * steps));
    if (previous > 0) CHECK(previous / apart == near(2, 0.05));
    previous = apart;
  }
  CHECK(previous < 0.01 * Short::exactly()[Short::injection]);
}

// ---- closed forms -------------------------------------------------------------------------------

/// Injection at one end; at the other the last channel is empty, so that the pressure stays zero
/// there until it is full.
template <class Scheme>
void check_steady_flow(Scheme scheme, double dt, int steps) {
  const std::vector<double> widths{5e-5, 4e-5, 6e-5, 4.5e-5, 5e-5, 5.5e-5, 5e-5};
  Chain chain(widths, 0);
  chain.network.set_filled_width(Chain::channel(widths.size() - 1), 0);
  constexpr double rate = 4e-6;
  for (int n = 0; n < steps; ++n) chain.inject(scheme, rate, dt);
  REQUIRE(chain.pressure(widths.size() - 1) == 0);
  REQUIRE(chain.pressure(widths.size()) == 0);
  for (std::size_t k = 0; k + 1 < widths.size(); ++k)
    CHECK(chain.pressure(k) - chain.pressure(k + 1) ==
          near(12 * viscosity * Chain::length * rate / std::pow(widths[k], 3), 1e-10));
}

TEST_CASE("steady flow loses pressure as between parallel plates, by both schemes") {
  const double across = 49 * Chain::length * Chain::length / diffusivity;
  check_steady_flow(implicit(), across / 2, 40);
  const double dt = 10 * flow_limit;
  check_steady_flow(explicitly(), dt, static_cast<int>(20 * across / dt));
}

/// Integral of the complementary error function.
double ierfc(double x) { return std::exp(-x * x) / std::sqrt(std::numbers::pi) - x * std::erfc(x); }

template <class Scheme>
void check_diffusion(Scheme scheme, double dt) {
  constexpr std::size_t injection = 90;
  constexpr double rate = 1e-7, time = 225 * Chain::length * Chain::length / diffusivity;
  Chain chain(2 * injection, width, injection);
  const int steps = static_cast<int>(std::ceil(time / dt));
  for (int n = 0; n < steps; ++n) chain.inject(scheme, rate, time / steps);
  const double reach = 2 * std::sqrt(diffusivity * time);
  const double flow = width * width * width / (12 * viscosity);  // per gradient
  for (std::size_t d = 0; d < chain.size(); ++d) {
    const double x = Chain::length * std::abs(static_cast<double>(d) - injection);
    if (x > reach) continue;
    const double exact = rate / 2 * reach / flow * ierfc(x / reach);
    CHECK(chain.pressure(d) == near(exact, 3e-3));
  }
}

TEST_CASE("pressure spreads from a constant injection as heat does, by both schemes") {
  check_diffusion(explicitly(), 0.8 * flow_limit);
  check_diffusion(implicit(), 0.5 * flow_limit);
}

// ---- the limit of the explicit scheme -----------------------------------------------------------

TEST_CASE("the flow limit of a uniform channel is 6 mu l^2 / (K_f w^2)") {
  Chain chain(10, width, 5);
  Explicit scheme = explicitly();
  CHECK(std::isinf(scheme.flow_limit()));
  CHECK(scheme.limiting_channel() == hfdem::nothing);
  chain.inject(scheme, 1e-7, flow_limit / 2);
  CHECK(scheme.flow_limit() == near(flow_limit));
}

TEST_CASE("the flow limit is that of the domain that answers fastest, beside the widest channel") {
  const std::vector<double> widths{5e-5, 5e-5, 4e-5, 8e-5, 5e-5, 7e-5, 5e-5};
  Chain chain(widths, 0);
  Explicit scheme = explicitly();
  chain.inject(scheme, 1e-7, 1e-7);
  double limit = 1;
  for (std::size_t d = 0; d < chain.size(); ++d) {
    double leaving = 0;
    for (const std::size_t k : {d - 1, d})
      if (k < widths.size()) leaving += std::pow(widths[k], 3) / (12 * viscosity * Chain::length);
    limit = std::fmin(limit, chain.room(d) / (modulus * leaving));
  }
  CHECK(scheme.flow_limit() == near(limit));
  CHECK(scheme.limiting_channel() == Chain::channel(3));
}

TEST_CASE("flow is stable up to the limit, and not beyond") {
  for (const double share : {0.98, 1.02}) {
    CAPTURE(share);
    Chain chain(10, width, 5);
    Explicit scheme = explicitly(share, -1e15);
    const double dt = 0.9999 * share * flow_limit, rate = 1e-7;
    for (int n = 0; n < 500; ++n) REQUIRE(chain.inject(scheme, rate, dt).flow_steps == 1);
    const auto exact = test::exact_pressures(chain, 5, viscosity, modulus, rate, chain.time());
    const double error = difference(chain.pressures(), exact) / exact[5];
    if (share < 1)
      CHECK(error < 1e-2);
    else
      CHECK(error > 10);
  }
}

TEST_CASE("a fluid step has as many steps of the flow as its length asks for, or is as short") {
  Chain chain(10, width, 5);
  Explicit several({.fluid_dt = 1, .limit_fraction = 0.5}, fluid, test::rigid_walls);
  CHECK(chain.inject(several, 1e-8, 0.49 * flow_limit).flow_steps == 1);
  CHECK(chain.inject(several, 1e-8, 5.25 * flow_limit).flow_steps == 11);
  CHECK(several.fluid_dt(1e-6) == 1);
  Explicit one({.fluid_dt = 1, .limit_fraction = 0.5, .sub_cycling = false}, fluid,
               test::rigid_walls);
  CHECK(one.fluid_dt(1e-6) == 1);  // nothing is known yet
  chain.inject(one, 1e-8, 0.1 * flow_limit);
  CHECK(one.fluid_dt(1e-6) == near(0.5 * flow_limit));
}
