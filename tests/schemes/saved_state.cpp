// A run that is saved and taken up again is the run without a break, bit for bit.
#include <cstdint>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <hfdem/base/archive.hpp>
#include <hfdem/observe/history.hpp>

#include <doctest/doctest.h>

#include "interface/least/pressure_scheme.hpp"
#include "loops/jointed_rock.hpp"
#include "schemes/run_state.hpp"
#include "schemes/small_array.hpp"

namespace {

using hfdem::BoundaryKind;
using hfdem::Loader;
using hfdem::Saver;

using test::put;
using test::state;
using test::Words;

/// Steps, and every answer of a step.
template <class Sim>
Words steps(Sim& sim, int count) {
  Words words;
  for (int n = 0; n < count; ++n) {
    const hfdem::FluidStep step = sim.step();
    words.push_back(static_cast<std::uint64_t>(step.mechanical_steps));
    words.push_back(step.converged ? 1 : 0);
    put(words, step.volume_error);
    put(words, step.unbalanced_ratio);
  }
  return words;
}

template <class... Parts>
Loader saved(const Parts&... parts) {
  Saver saver;
  saver(parts...);
  return {saver.sealed(), "the state"};
}

/// What happens in the middle of a run, beside its steps.
template <class Sim>
using Event = std::function<void(Sim&)>;

/// Makes `before` steps, saves, and lets one run go on while another takes it up; twice, so that
/// what was taken up can be saved, too.
/// @returns how many bonds have broken since it was first saved
template <class Sim>
std::size_t check_taken_up(const hfdem::Specimen& specimen, const typename Sim::Params& params,
                           int before, int after, int threads = 1, const Event<Sim>& event = {}) {
  Sim whole(specimen, params);
  steps(whole, before);
  if (event) event(whole);
  const std::size_t broken = whole.breaks().size();
  Loader state_then = saved(whole);
  Sim pieces(specimen, params, state_then);
  state_then.finish();
  CHECK(state(pieces) == state(whole));
  pieces.use_threads(threads);
  for (int part = 0; part < 2; ++part) {
    CHECK(steps(pieces, after) == steps(whole, after));
    CHECK(state(pieces) == state(whole));
    Loader state_now = saved(pieces);
    Sim again(specimen, params, state_now);
    pieces = again;
    pieces.use_threads(threads);
  }
  return whole.breaks().size() - broken;
}

/// The same on a square array.
template <class Sim>
std::size_t check_taken_up(const typename Sim::Params& params, int before, int after,
                           int threads = 1, const Event<Sim>& event = {}, int size = 16) {
  return check_taken_up<Sim>(test::square(size), params, before, after, threads, event);
}

template <class Pressure>
using Rock = test::SquareRock<Pressure>;
using Injected = test::Injected;

}  // namespace

TEST_CASE("an injection goes on bit for bit, by both rules, within every boundary") {
  for (const BoundaryKind kind :
       {BoundaryKind::servo, BoundaryKind::frozen, BoundaryKind::dead_loads})
    for (const bool equilibrium : {false, true}) {
      CAPTURE(static_cast<int>(kind));
      CAPTURE(equilibrium);
      const Injected::Params params{.contact = {.friction = 0.01},  // much slips
                                    .boundary = {.kind = kind},
                                    .injection = {.rate = 2e-4},
                                    .scheme = {.equilibrium = equilibrium}};
      check_taken_up<Injected>(params, 3, 4);
      const std::size_t breaks = check_taken_up<Injected>(params, 41, 16);
      CHECK(breaks >= 2);
    }
}

TEST_CASE("a crack that has grown goes on growing with any number of threads") {
  for (const int threads : {1, 2, 3}) {
    const auto grown = [](Injected& sim) { CHECK(sim.breaks().size() >= 2); };
    CHECK(check_taken_up<Injected>({.injection = {.rate = 1e-3}}, 12, 3, threads, grown, 50) >= 2);
  }
}

TEST_CASE("what was changed during the run stays changed") {
  for (const BoundaryKind kind : {BoundaryKind::servo, BoundaryKind::dead_loads})
    check_taken_up<Injected>({.boundary = {.kind = kind}}, 5, 5, 1, [](Injected& sim) {
      sim.inject(1e-4);
      sim.set_in_situ({9e6, 13e6});
    });
  check_taken_up<Rock<hfdem::HeldPressure>>(
      {.scheme = {.pressure = 8e6, .max_mechanical_steps = 50}}, 2, 2, 1,
      [](Rock<hfdem::HeldPressure>& sim) { sim.pressure_scheme().hold(13e6); });
}

TEST_CASE("rise and schedule go on where they were, and stay forgotten once the host has steered") {
  // The run is saved after 1.2 ms, its two pieces end at 1.8 and 2.4 ms.
  const Injected::Params params{
      .injection = {.rate = 1e-4,
                    .position = hfdem::Vec2{10 * test::radius, 16 * test::radius},
                    .rise = 1.5e-3,
                    .schedule = {{0.55e-3, 9e-4}, {1.55e-3, 2e-4}, {2.05e-3, 0}},
                    .further_points = {{22 * test::radius, 16 * test::radius}}}};
  const auto rise = [](Injected& sim) { CHECK(sim.injected_volume() > 1.1 * 1.2e-3 * 1e-4); };
  check_taken_up<Injected>(params, 12, 6, 2, rise);
  check_taken_up<Injected>(params, 12, 6, 1, [](Injected& sim) { sim.inject(3e-4); });
}

TEST_CASE("runs without fluid, and with a scheme of one's own") {
  check_taken_up<Rock<hfdem::Dry>>({}, 20, 20, 1, [](Rock<hfdem::Dry>& sim) {
    sim.set_in_situ({9e6, 13e6});
  });
  check_taken_up<Rock<models::PressureSteps>>({}, 5, 5);
}

TEST_CASE("joints that break, slip and meet go on where they were") {
  using Sim = test::Fractured<hfdem::UniformPressure>;
  // Two pairs meet while the stress settles, one does during the run, one never.
  const hfdem::Specimen specimen =
      test::fractured_square({{4, 4.2e-5}, {6, 5.25e-5}, {9, 5.3e-5}, {11, 1e-4}});
  for (const auto initially : {hfdem::JointContent::dry, hfdem::JointContent::filled}) {
    Sim::Params params{.joints = test::weak_joint, .injection = {.rate = 1e-3}};
    params.joints.initially = initially;
    const auto met = [](const Sim& sim) {
      int count = 0;
      for (std::size_t k = sim.joints().bonded(); k < sim.joints().size(); ++k)
        count += sim.joints().has_met(k);
      return count;
    };
    std::vector<int> met_before, broken_before;
    bool slipped = false;
    const Event<Sim> look = [&](const Sim& sim) {
      met_before.push_back(met(sim));
      broken_before.push_back(0);
      for (const auto& b : sim.breaks()) broken_before.back() += sim.is_joint(b.contact);
      for (std::size_t k = 0; k < sim.joints().size(); ++k)
        slipped = slipped || sim.joints().contacts().memory(k).slip != 0;
    };
    for (const int before : {0, 3, 9}) check_taken_up<Sim>(specimen, params, before, 4, 2, look);
    CHECK(met_before == std::vector<int>{2, 3, 3});
    CHECK(broken_before == std::vector<int>{0, 1, 4});
    CHECK(slipped);
  }
}

TEST_CASE("a network that waits for fluid, or has lost it at the rim, remembers that") {
  const Injected sim(test::square(8), {.crack = {.contacts = 2}});
  hfdem::Network whole = sim.network(), other = whole;
  const auto channels = static_cast<hfdem::Index>(sim.contacts().size());
  std::vector<hfdem::Index> dry;
  for (hfdem::Index c = 0; c < channels; ++c)
    if (!whole.is_wet(c)) dry.push_back(c);
  whole.open(dry.front());  // at a corner: out of the fluid's reach
  REQUIRE(!whole.is_wet(dry.front()));
  const auto take_up = [&] {
    Loader state_then = saved(whole);
    state_then(other);
    state_then.finish();
  };
  take_up();
  CHECK(other.is_open(dry.front()));
  for (const hfdem::Index c : dry) whole.open(c), other.open(c);
  CHECK(other.is_wet(dry.front()));
  REQUIRE(whole.reached_rim());
  other = sim.network();
  take_up();
  CHECK(other.reached_rim());
  CHECK(other.wet_channels().size() == channels);
}

TEST_CASE("a history goes on with the row that follows") {
  const hfdem::Specimen specimen = test::square(16);
  const Injected::Params params{.injection = {.rate = 2e-4}};
  const double interval = 2.5e-4;  // two and a half fluid steps
  std::ostringstream whole_text, first_text, second_text;
  Injected sim(specimen, params);
  hfdem::observe::History whole(whole_text, interval, 10e6), first(first_text, interval, 10e6);
  sim.run_until(3e-3, whole, first);
  Loader state_then = saved(sim, first);
  Injected pieces(specimen, params, state_then);
  hfdem::observe::History second(second_text, interval, 10e6);
  state_then(second);
  state_then.finish();
  CHECK(sim.run_until(9e-3, whole));
  CHECK(pieces.run_until(9e-3, second));
  const std::string text = second_text.str();
  CHECK(first_text.str() + text.substr(text.find('\n') + 1) == whole_text.str());
  REQUIRE(second.instants().size() == whole.instants().size());
  for (std::size_t k = 0; k < whole.instants().size(); ++k) {
    const auto &a = whole.instants()[k], &b = second.instants()[k];
    CHECK(b.time == a.time);
    CHECK(b.pressure == a.pressure);
    CHECK(b.crack.aperture == a.crack.aperture);
    CHECK(b.crack_volume == a.crack_volume);
  }
}

TEST_CASE("the state of another specimen is refused, in a sentence that says where") {
  const Injected sim(test::square(8), {.crack = {.contacts = 2}});
  Loader state_then = saved(sim);
  CHECK_THROWS_WITH_AS(
      (Injected{test::square(9), {.crack = {.contacts = 2}}, state_then}),
      "the state does not fit this run, at byte 30: 68 values stand where 85 should",
      hfdem::InvalidParameter);
  Loader longer = saved(sim, 1.0);
  const Injected same(test::square(8), {.crack = {.contacts = 2}}, longer);
  CHECK_THROWS_WITH_AS(longer.finish(), doctest::Contains("8 bytes follow the last value"),
                       hfdem::InvalidParameter);
}
