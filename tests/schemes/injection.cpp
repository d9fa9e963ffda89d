// Rates that change with time, and fluid that enters at several points.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <doctest/doctest.h>

#include "near.hpp"
#include "schemes/run_state.hpp"
#include "schemes/small_array.hpp"

namespace {

using hfdem::FluidStep;
using hfdem::Index;
using hfdem::Injection;
using hfdem::RateChange;
using hfdem::Vec2;
using test::Injected;
using test::near;
using test::radius;

constexpr double rate = 2e-4;

/// A scheme that moves nothing and keeps what it is told.
struct Listener {
  struct Params {
    double fluid_dt = 1e-4;
    static constexpr auto fields() {
      return std::tuple{
          hfdem::Field{"fluid_dt", &Params::fluid_dt, "s", hfdem::positive, "fluid time step"}};
    }
  };
  static constexpr bool holds_fluid = true;

  explicit Listener(const Params& params) : p(params) {}
  double fluid_dt(double) const { return p.fluid_dt; }
  template <class Relax>
  FluidStep advance(hfdem::Network&, const hfdem::Injected& injected, Relax&&) {
    told = injected;
    return {};
  }
  void exchange(auto&) {}

  Params p;
  hfdem::Injected told{};
};
using Listened = test::SquareRock<Listener>;

/// The integral of the rate from 0 to a time, piece by piece.
double volume_until(double time, const Injection& plan) {
  double volume = 0;
  for (std::size_t k = 0; k <= plan.schedule.size(); ++k) {
    const double begin = k == 0 ? 0 : plan.schedule[k - 1].time;
    const double end = k == plan.schedule.size() ? time : std::fmin(time, plan.schedule[k].time);
    const double piece = k == 0 ? plan.rate : plan.schedule[k - 1].rate;
    volume += piece * std::fmax(0, end - begin);
  }
  return volume;
}

std::string refusal(const Injection& injection) {
  try {
    const Injected sim(test::square(10), {.crack = {.contacts = 2}, .injection = injection});
  } catch (const hfdem::InvalidParameter& refused) {
    return refused.what();
  }
  return "accepted";
}

/// On the square array of 20 by 20, mirror images of each other.
const Vec2 left{12 * radius, 20 * radius}, right{28 * radius, 20 * radius};

std::set<Index> preset(const Injected& sim) {
  return {sim.preset_contacts().begin(), sim.preset_contacts().end()};
}

}  // namespace

TEST_CASE("a constant rate injects the rate times the step, to the last bit") {
  Listened sim(test::square(10), {.injection = {.rate = rate}});
  double volume = 0;
  for (int n = 0; n < 50; ++n) {
    sim.step();
    volume += rate * 1e-4;
    CHECK(test::bits(sim.injected_volume()) == test::bits(volume));
  }
}

TEST_CASE("the injected volume is the integral of the scheduled rate, also within a step") {
  // A step of 0.1 ms holds one change, then two, none, and one where it ends.
  const Injection plan{
      .rate = rate,
      .schedule = {{2.5e-4, 5e-4}, {4.1e-4, 9e-4}, {4.7e-4, 0}, {6e-4, 1e-4}, {12e-4, 0}}};
  Listened sim(test::square(10), {.injection = plan});
  for (int n = 1; n <= 20; ++n) {
    const double before = sim.injected_volume();
    sim.step();
    CAPTURE(n);
    CHECK(sim.injected_volume() == near(volume_until(n * 1e-4, plan), 1e-13));
    const hfdem::Injected& told = sim.pressure_scheme().told;
    CHECK(told.dt == 1e-4);
    CHECK(told.total == sim.injected_volume());
    CHECK(told.total == before + told.step);
  }
}

TEST_CASE("the pump comes to its rate, and to what is planned meanwhile, linearly") {
  const Injection plan{
      .rate = rate, .rise = 8.5e-4, .schedule = {{2.5e-4, 5e-4}, {4.1e-4, 9e-4}, {12e-4, 1e-4}}};
  Listened sim(test::square(10), {.injection = plan});
  // The middle of slices within which nothing changes: exact for a rate that is linear.
  constexpr double slice = 1e-6;
  double volume = 0;
  for (int n = 1; n <= 1500; ++n) {
    const double time = (n - 0.5) * slice;
    const double planned = time < 2.5e-4 ? rate : time < 4.1e-4 ? 5e-4 : time < 12e-4 ? 9e-4 : 1e-4;
    volume += slice * planned * std::fmin(1, time / 8.5e-4);
    if (n % 100 != 0) continue;
    sim.step();
    CAPTURE(n);
    CHECK(sim.injected_volume() == near(volume, 1e-12));
  }
}

TEST_CASE("a change at the very beginning takes the place of the rate") {
  Listened sim(test::square(10), {.injection = {.rate = rate, .schedule = {{0, 0}, {3e-4, rate}}}});
  for (int n = 0; n < 3; ++n) sim.step();
  CHECK(sim.injected_volume() < 1e-12 * rate);
  sim.step();
  CHECK(sim.injected_volume() == near(1e-4 * rate, 1e-12));
}

TEST_CASE("the host's rate holds from then on, whatever was planned") {
  Listened sim(
      test::square(10),
      {.injection = {.rate = rate, .rise = 1e-4, .schedule = {{1e-4, 3 * rate}, {4e-4, 0}}}});
  for (int n = 0; n < 3; ++n) sim.step();
  sim.inject(2 * rate);
  for (int n = 0; n < 5; ++n) sim.step();
  CHECK(sim.injected_volume() == near((0.5 + 2 * 3 + 5 * 2) * 1e-4 * rate, 1e-13));
  Listened rising(test::square(10), {.injection = {.rate = rate, .rise = 1}});
  rising.inject(rate);
  rising.step();
  CHECK(rising.injected_volume() == near(1e-4 * rate, 1e-13));
}

TEST_CASE("a change that is yet to come changes nothing") {
  const Injection plain{.rate = rate}, later{.rate = rate, .schedule = {{1, 0}}};
  Injected one(test::square(16), {.injection = plain}),
      other(test::square(16), {.injection = later});
  for (int n = 0; n < 30; ++n) one.step(), other.step();
  CHECK(test::state(one) == test::state(other));
}

TEST_CASE("a well that is shut in keeps its fluid, and the crack its volume") {
  for (const bool equilibrium : {false, true}) {
    CAPTURE(equilibrium);
    Injected sim(test::square(20), {.injection = {.rate = rate, .schedule = {{4.05e-3, 0}}},
                                    .scheme = {.equilibrium = equilibrium}});
    for (int n = 0; n < 41; ++n) sim.step();
    const double injected = sim.injected_volume();
    CHECK(injected == near(4.05e-3 * rate, 1e-13));
    for (int n = 0; n < 100; ++n) {
      sim.step();
      CHECK(sim.injected_volume() == injected);
    }
    CHECK(sim.time() == near(141e-4));
    CHECK(sim.network().crack_volume() == near(injected, 1.1e-2));
    CHECK(sim.injection_pressure() > 10e6);  // or it would close
  }
}

TEST_CASE("every point has a preset crack, and all hold fluid of one pressure from the beginning") {
  Injected sim(test::square(20),
               {.injection = {.rate = 1e-3, .position = left, .further_points = {right}},
                .scheme = {.equilibrium = true}});
  const auto& network = sim.network();
  const auto domains = network.injection_domains();
  REQUIRE(domains.size() == 2);
  CHECK(domains[0] == network.injection_domain());
  for (std::size_t k = 0; k < 2; ++k) {
    const Vec2 centre = network.geometry().centre[domains[k]];
    CHECK(centre.x == near((k == 0 ? left : right).x));
    CHECK(centre.y == near(20 * radius));
  }
  const Injected only_left(test::square(20), {.injection = {.position = left}});
  const Injected only_right(test::square(20), {.injection = {.position = right}});
  std::set<Index> both = preset(only_left);
  both.merge(preset(only_right));
  CHECK(both.size() == 8);
  CHECK(preset(sim) == both);

  for (int n = 0; n < 25; ++n) sim.step();
  CHECK(sim.injection_pressure() > 10e6);
  for (const Index d : network.wet_domains())
    CHECK(network.pressure(d) == sim.injection_pressure());
  CHECK(sim.breaks().size() >= 4);
  // By symmetry each crack holds half of what was injected.
  double volume = 0;
  for (const Index c : network.wet_channels())
    if (sim.contact_point(c).x < 20 * radius)
      volume += 2 * radius * (network.width(c) - network.rest_width(c));
  CHECK(volume == near(network.crack_volume() / 2, 1e-9));
  CHECK(volume == near(sim.injected_volume() / 2, 1.1e-3));
}

TEST_CASE("preset cracks that meet are one crack, cut once") {
  const Vec2 above{left.x, left.y + 4 * radius};
  const Injected sim(test::square(20),
                     {.injection = {.position = left, .further_points = {above}}});
  CHECK(preset(sim).size() == 6);
  CHECK(sim.preset_contacts().size() == 6);
  CHECK(sim.network().wet_channels().size() == 6);
}

TEST_CASE("a schedule that cannot be meant is refused by its entry") {
  CHECK(refusal({.schedule = {{0.1, 1e-4}, {0.2, 0}}}) == "accepted");
  CHECK(refusal({.schedule = {{0.1, 1e-4}, {0.1, 0}}}) ==
        "injection.schedule, entry 2, time = 0.1 s is not allowed: it must be greater than 0.1 s, "
        "that of the entry before");
  CHECK(refusal({.schedule = {{0.1, 1e-4}, {0.2, 0}, {0.15, 0}}}) ==
        "injection.schedule, entry 3, time = 0.15 s is not allowed: it must be greater than 0.2 s, "
        "that of the entry before");
  CHECK(refusal({.rise = -0.1}) ==
        "injection.rise = -0.1 s is not allowed: it must be at least 0 s");
  CHECK(refusal({.schedule = {{-0.1, 1e-4}}}) ==
        "injection.schedule, entry 1, time = -0.1 s is not allowed: it must be at least 0 s");
  CHECK(refusal({.schedule = {{0.1, 1e-4}, {0.2, -1e-4}}}) ==
        "injection.schedule, entry 2, rate = -1e-04 m2/s is not allowed: it must be at least 0 "
        "m2/s");
  CHECK(refusal({.schedule = {{std::nan(""), 1e-4}}}) ==
        "injection.schedule, entry 1, time = nan s is not allowed: it must be at least 0 s");
  CHECK(refusal({.schedule = {{0.1, INFINITY}}}) ==
        "injection.schedule, entry 1, rate = inf m2/s is not allowed: it must be at least 0 m2/s");
}

TEST_CASE("further points outside of the specimen, or where fluid enters already, are refused") {
  const Vec2 middle{10 * radius, 10 * radius}, beside{6 * radius, 10 * radius};
  CHECK(refusal({.further_points = {beside}}) == "accepted");
  CHECK(refusal({.further_points = {beside, {0.2, 0.03}}}) ==
        "injection.further_points, entry 2 = [0.2, 0.03] m is not allowed: it must be inside the "
        "specimen, which is 0.1 m by 0.1 m and has 81 flow domains");
  const std::string taken =
      " m is not allowed: it must be in another flow domain than injection.position and the "
      "entries before";
  CHECK(refusal({.further_points = {middle}}) ==
        "injection.further_points, entry 1 = [0.05, 0.05]" + taken);
  CHECK(refusal({.position = Vec2{0.07, 0.05}, .further_points = {beside, {0.031, 0.051}}}) ==
        "injection.further_points, entry 2 = [0.031, 0.051]" + taken);
  CHECK(refusal({.further_points = {{std::nan(""), 0.03}}}) ==
        "injection.further_points, entry 1 = nan m is not allowed: it must be any finite number");
}
