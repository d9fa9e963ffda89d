// Running until a time, and telling observers about it.
#include <algorithm>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "near.hpp"
#include "schemes/small_array.hpp"

namespace {

using test::Injected;
using test::near;

Injected quick_array() { return {test::square(20), {.injection = {.rate = 5e-4}}}; }

/// Writes down what it is told.
struct Diary {
  std::vector<std::string> entries{};
  std::vector<hfdem::BondBreak> breaks{};
  int mechanical_steps = 0;

  void fluid_step(const Injected&, const hfdem::FluidStep& step) {
    entries.push_back("step");
    mechanical_steps += step.mechanical_steps;
  }
  void bond_break(const Injected&, const hfdem::BondBreak& b) {
    entries.push_back("break");
    breaks.push_back(b);
  }
};

/// Lets the run go on for some fluid steps.
struct Patience {
  int steps;
  bool fluid_step(const Injected&, const hfdem::FluidStep&) { return --steps > 0; }
};

}  // namespace

TEST_CASE("a run ends at the time that it was given") {
  // One step more or less than asked for must not depend on whether the sum of steps is rounded.
  for (const double dt : {1e-4, 0x1p-13}) {
    Injected sim(test::square(6), {.crack = {.contacts = 2}, .scheme = {.fluid_dt = dt}});
    for (int n = 1; n <= 20; ++n) {
      CHECK(sim.run_until(n * dt));
      CHECK(sim.fluid_steps() == n);
      CHECK(sim.time() == near(n * dt));
    }
    CHECK(sim.run_until(22.5 * dt));  // not within a step
    CHECK(sim.fluid_steps() == 23);
    CHECK(sim.run_until(3 * dt));  // long past
    CHECK(sim.fluid_steps() == 23);
  }
}

TEST_CASE("a run in pieces is the run as a whole") {
  Injected whole = quick_array(), pieces = quick_array();
  whole.run_until(2e-3);
  for (int n = 1; n <= 20; ++n) pieces.run_until(n * 1e-4);
  CHECK(pieces.fluid_steps() == whole.fluid_steps());
  for (std::size_t i = 0; i < whole.discs().size(); ++i)
    for (std::size_t lane = 0; lane < 4; ++lane)
      CHECK(test::bits(pieces.discs().displacement[i][lane]) ==
            test::bits(whole.discs().displacement[i][lane]));
}

TEST_CASE("callables are observers of fluid steps") {
  Injected sim = quick_array();
  std::vector<double> times;
  int calls = 0;
  const bool reached = sim.run_until(
      1e-3, [&](const Injected& s) { times.push_back(s.time()); },
      [&](const auto&) {
        ++calls;
        return true;
      });
  CHECK(reached);
  CHECK(calls == 10);
  REQUIRE(times.size() == 10);
  for (std::size_t n = 0; n < 10; ++n) CHECK(times[n] == near(static_cast<double>(n + 1) * 1e-4));
}

TEST_CASE("false stops the run after the step, once all observers have been told") {
  Injected sim = quick_array();
  int told_later = 0;
  CHECK_FALSE(sim.run_until(
      1, [](const Injected& s) { return s.fluid_steps() < 4; },
      [&](const Injected&) { ++told_later; }));
  CHECK(sim.fluid_steps() == 4);
  CHECK(told_later == 4);

  Patience patience{3};
  CHECK_FALSE(sim.run_until(1, patience));
  CHECK(patience.steps == 0);
  CHECK(sim.fluid_steps() == 7);
}

TEST_CASE("named events tell every step and every break, the breaks of a step first") {
  Injected sim = quick_array();
  const long settled = sim.mechanical_steps();
  Diary diary;
  sim.run_until(1, diary, [](const Injected& s) { return s.breaks().size() < 6; });
  CHECK(std::count(diary.entries.begin(), diary.entries.end(), "step") == sim.fluid_steps());
  CHECK(diary.mechanical_steps == sim.mechanical_steps() - settled);
  REQUIRE(diary.breaks.size() == sim.breaks().size());
  for (std::size_t b = 0; b < diary.breaks.size(); ++b)
    CHECK(diary.breaks[b].contact == sim.breaks()[b].contact);
  CHECK(diary.entries.front() == "step");
  REQUIRE(diary.entries.size() > 2);  // the run stopped at breaks: they came before its last step
  CHECK(diary.entries.back() == "step");
  CHECK(diary.entries[diary.entries.size() - 2] == "break");
}

TEST_CASE("an observer need not know every event") {
  struct BreaksOnly {
    std::size_t count = 0;
    void bond_break(const Injected&, const hfdem::BondBreak&) { ++count; }
  };
  Injected sim = quick_array();
  BreaksOnly breaks;
  sim.run_until(1, breaks, [](const Injected& s) { return s.breaks().size() < 4; });
  CHECK(breaks.count == sim.breaks().size());
}

TEST_CASE("an observer that declines mechanical steps hears of none until it wants to") {
  struct Later {
    long heard = 0;
    bool wants = false;
    void mechanical_step(const Injected&) { ++heard; }
    bool wants_mechanical_steps() const { return wants; }
  };
  Injected sim = quick_array();
  Later later;
  sim.run_until(1e-3, later);
  CHECK(later.heard == 0);
  later.wants = true;
  const long before = sim.mechanical_steps();
  sim.run_until(2e-3, later);
  CHECK(later.heard == sim.mechanical_steps() - before);
  CHECK(later.heard > 0);
}

TEST_CASE("an observer of mechanical steps sees each once, before anything moves") {
  struct Watch {
    long steps = 0, next = 0;
    std::vector<hfdem::Pack> place{};
    bool in_step = true;
    void mechanical_step(const Injected& s) {
      in_step = in_step && s.mechanical_steps() == next++;
      if (steps++ > 0) {  // the discs have come here with the velocity that they have now
        for (std::size_t i = 0; i < s.discs().size(); ++i) {
          const hfdem::Pack there = place[i] + s.mechanical_dt() * s.discs().velocity[i];
          for (std::size_t lane = 0; lane < 3; ++lane)
            in_step = in_step && there[lane] == s.discs().displacement[i][lane];
        }
      }
      place = s.discs().displacement;
      // Forces and loads are those of this place.
      const std::size_t c = s.contacts().size() / 2;
      const auto f = s.contacts().response(c, place).reaction();
      const hfdem::Pack& row = s.forces().rows()[s.contacts().first_row() + c];
      const auto frame = s.contacts().frame(c);
      in_step = in_step && row[0] == f.normal * frame.normal_x - f.shear * frame.normal_y;
      for (const hfdem::Index i : s.network().pushed_discs())
        in_step = in_step && s.discs().load[i] == s.network().force_on(i);
    }
  };
  Injected sim = quick_array(), unwatched = quick_array();
  Watch watch;
  sim.run_until(1e-3, watch);
  const hfdem::FluidStep last = sim.step(watch);
  CHECK(watch.in_step);
  CHECK(watch.steps == sim.mechanical_steps());
  CHECK(last.mechanical_steps > 0);

  unwatched.run_until(1e-3);
  unwatched.step();
  for (std::size_t i = 0; i < sim.discs().size(); ++i)
    for (std::size_t lane = 0; lane < 4; ++lane)
      CHECK(test::bits(sim.discs().displacement[i][lane]) ==
            test::bits(unwatched.discs().displacement[i][lane]));
}
