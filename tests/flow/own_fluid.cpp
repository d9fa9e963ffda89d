// Fluid laws of one's own, in one struct each: the schemes use all that they say.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include <hfdem/fluid/newtonian.hpp>
#include <hfdem/pressure/conventional.hpp>
#include <hfdem/pressure/implicit.hpp>

#include <doctest/doctest.h>

#include "flow/chain.hpp"
#include "interface/least/fluid_law.hpp"
#include "near.hpp"
#include "schemes/small_array.hpp"

namespace {

using hfdem::ConventionalFlow;
using hfdem::ImplicitFlow;
using hfdem::NewtonianFluid;
using test::Chain;
using test::near;

/// Water that becomes turbulent: Blasius' friction factor, 0.316 / Re^(1/4), with the Reynolds
/// number on the hydraulic diameter, 2 w.
struct TurbulentWater : NewtonianFluid {
  explicit TurbulentWater(const Params& p) : NewtonianFluid(p), viscosity(p.viscosity) {}

  double conductance(double width, double length, double drop, double pressure) const noexcept {
    const double laminar = NewtonianFluid::conductance(width, length, drop, pressure);
    if (drop == 0) return laminar;
    const double loss = 0.316 / 4 * std::pow(viscosity / 2, 0.25) * std::pow(1000, 0.75);
    const double gradient = std::abs(drop) / length;
    const double velocity = std::pow(gradient * std::pow(width, 1.25) / loss, 4.0 / 7);
    return std::min(laminar, velocity * width / std::abs(drop));
  }

  double viscosity;
};

constexpr double viscosity = 1e-3, width = 1e-3;
const TurbulentWater water({.viscosity = viscosity, .bulk_modulus = 2e9});

/// Loss of pressure along a channel between parallel plates, from the friction factor.
double loss(double rate) {
  const double density = 1000, velocity = rate / width, diameter = 2 * width;
  const double reynolds = density * velocity * diameter / viscosity;
  const double friction = std::max(96 / reynolds, 0.316 / std::pow(reynolds, 0.25));
  return friction * Chain::length / diameter * density * velocity * velocity / 2;
}

template <class Scheme>
void check_steady_flow(Scheme scheme, double rate, double dt, int steps) {
  constexpr std::size_t channels = 6;
  Chain chain(channels, width, 0);
  chain.network.set_filled_width(Chain::channel(channels - 1), 0);  // takes up the flow
  for (int n = 0; n < steps; ++n) chain.inject(scheme, rate, dt);
  REQUIRE(chain.pressure(channels) == 0);
  for (std::size_t k = 0; k + 1 < channels; ++k)
    CHECK(chain.pressure(k) - chain.pressure(k + 1) == near(loss(rate), 1e-5));
}

}  // namespace

TEST_CASE("a turbulent fluid loses pressure by its friction factor, in both schemes") {
  CHECK(loss(1e-3) == near(12 * viscosity * Chain::length * 1e-3 / std::pow(width, 3)));
  CHECK(loss(1e-2) > 2 * 10 * loss(1e-3));
  for (const double rate : {0.5e-3, 2e-3, 1e-2}) {
    CAPTURE(rate);
    check_steady_flow(
        ImplicitFlow<TurbulentWater>({.volume_tolerance = 1e-9}, water, test::rigid_walls), rate,
        1e-5, 30);
    check_steady_flow(ConventionalFlow<TurbulentWater>({}, water, test::rigid_walls), rate, 3e-9,
                      1000);
  }
}

TEST_CASE("a fluid whose density is no straight line fills the same rooms by its own law") {
  constexpr std::size_t channels = 8, injection = 2;
  const double stiffness = 2e7, rate = 1e-6;
  const models::DenserFluid fluid({.viscosity = 0.1, .stiffness = stiffness});
  Chain implicit_chain(channels, 5e-5, injection), explicit_chain = implicit_chain;
  ImplicitFlow<models::DenserFluid> implicitly({.volume_tolerance = 1e-12}, fluid,
                                               test::rigid_walls);
  ConventionalFlow<models::DenserFluid> explicitly({}, fluid, test::rigid_walls);
  for (int n = 0; n < 20; ++n) {
    CHECK(implicit_chain.inject(implicitly, rate, 0.05).converged);
    explicit_chain.inject(explicitly, rate, 0.05);
  }
  for (int n = 0; n < 8; ++n) {  // shut in: the pressure becomes even
    implicit_chain.inject(implicitly, 0, 1);
    explicit_chain.inject(explicitly, 0, 1);
  }
  const double room = channels * Chain::length * 5e-5;
  const double pressure = stiffness * std::log(1 + rate / room);
  CHECK(pressure > 0.2 * stiffness);
  for (std::size_t d = 0; d <= channels; ++d) {
    CHECK(implicit_chain.pressure(d) == near(pressure, 1e-9));
    CHECK(explicit_chain.pressure(d) == near(pressure, 1e-9));
  }
}

TEST_CASE("the flow limit is that of the fluid's own modulus, at its pressure") {
  const double stiffness = 2e7, rate = 1e-6;
  const models::DenserFluid fluid({.viscosity = 0.1, .stiffness = stiffness});
  Chain chain(4, 5e-5, 2);
  ConventionalFlow<models::DenserFluid> scheme({}, fluid, test::rigid_walls);
  chain.inject(scheme, rate, 1);
  chain.inject(scheme, 0, 3);
  chain.inject(scheme, 0, 1e-9);
  const double denser = 1 + rate / (4 * Chain::length * 5e-5);
  CHECK(scheme.flow_limit() ==
        near(6 * 0.1 * Chain::length * Chain::length / (stiffness / denser * 25e-10), 1e-9));
}

TEST_CASE("a fluid that nothing holds back stops the run, in a sentence") {
  struct Superfluid : NewtonianFluid {
    using NewtonianFluid::NewtonianFluid;
    double conductance(double, double, double, double) const noexcept { return HUGE_VAL; }
  };
  const Superfluid fluid(Superfluid::Params{});
  Chain chain(4, 5e-5, 2);
  ConventionalFlow<Superfluid> explicitly({}, fluid, test::rigid_walls);
  CHECK_THROWS_WITH_AS(chain.inject(explicitly, 1e-6, 1e-6),
                       "explicit flow would take inf steps in a fluid step: a channel is too wide, "
                       "or its fluid too thin",
                       hfdem::RunStopped);
  ImplicitFlow<Superfluid> implicitly({}, fluid, test::rigid_walls);
  CHECK_THROWS_WITH_AS(
      chain.inject(implicitly, 1e-6, 1e-6),
      "the pressures have no solution: a width or a pressure is not a finite number",
      hfdem::RunStopped);
}

TEST_CASE("a fluid of one's own drives a crack, in rock") {
  test::SquareRock<ImplicitFlow<models::DenserFluid>> sim(
      test::square(12), {.injection = {.rate = 2e-4}, .fluid = {.stiffness = 1e9}});
  for (int n = 0; n < 40; ++n) sim.step();
  CHECK(sim.breaks().size() >= 2);
  CHECK(sim.volume_balance().relative_error() < 1e-12);
}

// ---- bad input ----------------------------------------------------------------------------------

namespace {

template <class Pressure>
std::string refusal(const typename test::SquareRock<Pressure>::Params& params) {
  try {
    const test::SquareRock<Pressure> sim(test::square(6), params);
  } catch (const hfdem::InvalidParameter& refused) {
    return refused.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("properties of the fluid and of its schemes outside their range are refused by name") {
  const auto with = [](const NewtonianFluid::Params& fluid) {
    return refusal<ConventionalFlow<>>({.fluid = fluid});
  };
  CHECK(with({.viscosity = 0}) ==
        "fluid.viscosity = 0 Pa s is not allowed: it must be greater than 0 Pa s");
  CHECK(with({.viscosity = -1}).starts_with("fluid.viscosity = -1 Pa s is not"));
  CHECK(with({.bulk_modulus = std::nan("")}) ==
        "fluid.bulk_modulus = nan Pa is not allowed: it must be greater than 0 Pa");
  const auto explicitly = [](const ConventionalFlow<>::Params& scheme) {
    return refusal<ConventionalFlow<>>({.scheme = scheme});
  };
  CHECK(explicitly({.fluid_dt = 0}) ==
        "scheme.fluid_dt = 0 s is not allowed: it must be greater than 0 s");
  CHECK(explicitly({.limit_fraction = 1.01}) ==
        "scheme.limit_fraction = 1.01 is not allowed: it must be greater than 0 and at most 1");
  CHECK(explicitly({.pressure_floor = -HUGE_VAL}).starts_with("scheme.pressure_floor = -inf Pa"));
  const auto implicitly = [](const ImplicitFlow<>::Params& scheme) {
    return refusal<ImplicitFlow<>>({.scheme = scheme});
  };
  CHECK(implicitly({.fluid_dt = std::nan("")}).starts_with("scheme.fluid_dt = nan s is not"));
  CHECK(implicitly({.volume_tolerance = 0}).starts_with("scheme.volume_tolerance = 0 is not"));
  CHECK(implicitly({.unbalanced_tolerance = -1}) ==
        "scheme.unbalanced_tolerance = -1 is not allowed: it must be greater than 0");
  CHECK(implicitly({.max_mechanical_steps = 0}) ==
        "scheme.max_mechanical_steps = 0 is not allowed: it must be at least 1");
}
