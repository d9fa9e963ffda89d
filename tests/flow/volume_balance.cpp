// Where the fluid is, through all that can happen to a crack: the ledger of volumes closes.
#include <cmath>
#include <cstddef>
#include <string>

#include <hfdem/pressure/conventional.hpp>
#include <hfdem/pressure/implicit.hpp>
#include <hfdem/pressure/uniform.hpp>

#include <doctest/doctest.h>

#include "flow/chain.hpp"
#include "loops/jointed_rock.hpp"
#include "near.hpp"
#include "schemes/small_array.hpp"

namespace {

using hfdem::ConventionalFlow;
using hfdem::ImplicitFlow;
using hfdem::Index;
using hfdem::JointContent;
using hfdem::UniformPressure;
using hfdem::VolumeBalance;
using test::near;

/// What the wet channels hold at their pressures, and held before, from the network alone.
struct Held {
  double now = 0, before = 0;
};
Held held(const hfdem::Network& network, double bulk_modulus) {
  Held sum;
  for (const Index c : network.wet_channels()) {
    const auto& [domain, length] = network.geometry().channels[c];
    const double mean = (network.pressure(domain[0]) + network.pressure(domain[1])) / 2;
    sum.now += length * network.width(c) * (1 + mean / bulk_modulus);
    sum.before += length * network.filled_width(c);
  }
  return sum;
}

/// What a run goes through.
struct Events {
  int breaks = 0, joints = 0, at_floor = 0, not_converged = 0, shorter_steps = 0;
};

/// Runs until the crack is at the rim, or so many steps.
template <class Sim>
Events check_balance(Sim& sim, int steps, double bulk_modulus) {
  Events events;
  double dt = 0;
  for (int n = 0; n < steps; ++n) {
    const double before = sim.time();
    hfdem::FluidStep step;
    try {
      step = sim.step();
    } catch (const hfdem::ReachedRim&) {
      CHECK(sim.volume_balance().relative_error() < 1e-12);
      break;
    }
    const VolumeBalance b = sim.volume_balance();
    CHECK(b.relative_error() < 1e-12);
    CHECK(b.injected == near(sim.injected_volume(), 1e-12));
    const Held fluid = held(sim.network(), bulk_modulus);
    CHECK(b.initial == near(fluid.before));
    CHECK(b.stored == near(fluid.now));
    const double came = b.injected + b.initial;
    CHECK(std::abs(came - (fluid.now - b.empty + b.unmet)) < 1e-12 * came);
    CHECK(b.empty >= 0);
    CHECK(b.leaked == 0);
    CHECK(b.out == 0);
    events.not_converged += !step.converged;
    events.shorter_steps += sim.time() - before < 0.99 * dt;
    dt = sim.time() - before;
    for (const Index d : sim.network().wet_domains())
      events.at_floor += sim.network().pressure(d) == 0;
  }
  for (const auto& b : sim.breaks()) events.breaks += !sim.is_joint(b.contact);
  for (const Index c : sim.network().wet_channels()) events.joints += sim.is_joint(c);
  return events;
}

template <class Pressure>
typename test::Fractured<Pressure>::Params jointed(JointContent content) {
  typename test::Fractured<Pressure>::Params p{.joints = test::weak_joint,
                                               .injection = {.rate = 1e-3}};
  p.joints.initially = content;
  return p;
}

}  // namespace

TEST_CASE("the volumes of explicit flow balance through breaks, joints and empty domains") {
  for (const JointContent content : {JointContent::dry, JointContent::filled}) {
    auto params = jointed<ConventionalFlow<>>(content);
    params.fluid = {.viscosity = 1e-3, .bulk_modulus = 1e8};
    test::Fractured<ConventionalFlow<>> sim(test::fractured_square(), params);
    const Events e = check_balance(sim, 2000, params.fluid.bulk_modulus);
    CHECK(e.breaks >= 4);
    CHECK(e.joints >= 4);
    CHECK(e.at_floor > 0);
    // Pressures are those of what the domains hold, always.
    CHECK(std::abs(sim.volume_balance().unmet) < 1e-12 * sim.injected_volume());
  }
}

TEST_CASE("the volumes of implicit flow balance, in steps that converge and others") {
  for (const JointContent content : {JointContent::dry, JointContent::filled}) {
    auto params = jointed<ImplicitFlow<>>(content);
    params.fluid.viscosity = 1e-3;
    params.scheme.max_mechanical_steps = 150;
    test::Fractured<ImplicitFlow<>> sim(test::fractured_square(), params);
    const Events e = check_balance(sim, 60, params.fluid.bulk_modulus);
    CHECK(e.breaks >= 4);
    CHECK(e.joints >= 4);
    CHECK(e.at_floor > 0);
    CHECK(e.not_converged > 0);
    CHECK(e.shorter_steps > 0);
  }
}

TEST_CASE("the volumes of a uniform pressure balance, its fluid having no compressibility") {
  for (const JointContent content : {JointContent::dry, JointContent::filled}) {
    test::Fractured<UniformPressure> sim(test::fractured_square(),
                                         jointed<UniformPressure>(content));
    const Events e = check_balance(sim, 45, 1e99);
    CHECK(e.breaks >= 3);
    CHECK(e.joints >= 4);
  }
}

TEST_CASE("the volumes of a run that ended at the rim balance, too") {
  const auto to_the_rim = [](auto sim) {
    CHECK_THROWS_AS(while (true) sim.step(), hfdem::ReachedRim);
    CHECK(sim.volume_balance().relative_error() < 1e-12);
  };
  const hfdem::Injection fast{.rate = 1e-3};
  to_the_rim(test::SquareRock<ConventionalFlow<>>(test::square(12), {.injection = fast}));
  to_the_rim(test::SquareRock<ImplicitFlow<>>(test::square(12), {.injection = fast}));
}

TEST_CASE("small volumes add up, however many") {
  test::Chain chain(2, 1e-4, 1);
  hfdem::StoredFluid fluid;
  fluid.join(chain.network);
  const double before = fluid.stored()[0], part = 1e-17;
  constexpr int times = 1'000'000;
  for (int n = 0; n < times; ++n) fluid.inject(part, 1);
  CHECK(fluid.stored()[0] - before == near(times * part, 1e-9));
}

TEST_CASE("an implicit pump that starts slowly finds its first volumes") {
  test::SquareRock<ImplicitFlow<>> sim(
      test::square(20),
      {.injection = {.rise = 0.05}, .fluid = {.viscosity = 0.1}, .scheme = {.fluid_dt = 2e-3}});
  for (int n = 0; n < 10; ++n) {
    CAPTURE(n);
    CHECK(sim.step().converged);
  }
}

TEST_CASE("what a converged implicit step leaves without room is within its tolerance") {
  test::SquareRock<ImplicitFlow<>> sim(test::square(16),
                                       {.injection = {.rate = 2e-4}, .fluid = {.viscosity = 1e-3}});
  for (int n = 0; n < 20; ++n) {
    const hfdem::FluidStep step = sim.step();
    REQUIRE(step.converged);
    CHECK(step.volume_error <= 1e-3);
    CHECK(step.unbalanced_ratio < 1e-3);
    const double most = std::fmax(sim.injected_volume(), sim.network().rest_volume());
    CHECK(std::abs(sim.volume_balance().unmet) <= 1e-3 * most);
  }
}

TEST_CASE(
    "a channel that turns wet brings half of its fluid to each side, but no more than it holds") {
  test::Chain chain({5e-5, 4e-5, 6e-5}, 0);
  chain.network.set_filled_width(test::Chain::channel(0), 3e-5);  // partly full
  chain.network.set_filled_width(test::Chain::channel(1), 9e-5);  // closed further meanwhile
  ConventionalFlow<> scheme({}, hfdem::NewtonianFluid({}), test::rigid_walls);
  chain.inject(scheme, 0, 1e-12);
  const VolumeBalance b = scheme.balance(chain.network, 0);
  CHECK(b.initial == near(0.01 * (3e-5 + 4e-5 + 6e-5)));
  CHECK(b.stored == near(0.01 * (5e-5 + 4e-5 + 6e-5)));
  CHECK(b.empty == near(0.01 * 2e-5));
  CHECK(chain.network.filled_width(test::Chain::channel(1)) == 4e-5);
  CHECK(chain.pressure(3) == 0);
}

// ---- a scheme that cheats -----------------------------------------------------------------------

namespace {

/// Claims a share of a millionth more than it has.
class Cheat : public ConventionalFlow<> {
 public:
  using ConventionalFlow<>::ConventionalFlow;
  VolumeBalance balance(const hfdem::Network& network, double injected) const {
    VolumeBalance b = ConventionalFlow<>::balance(network, injected);
    b.unmet += 1e-6 * (b.injected + b.initial);
    return b;
  }
};

}  // namespace

TEST_CASE("a scheme that makes fluid out of nothing stops the run, in a sentence") {
  test::SquareRock<Cheat> sim(test::square(10), {});
  CHECK_THROWS_WITH_AS(sim.step(),
                       "the volumes of the fluid do not balance at t = 2e-06 s: 0.0001 % of what "
                       "came in is missing",
                       hfdem::RunStopped);
  CHECK(sim.fluid_steps() == 1);
}
