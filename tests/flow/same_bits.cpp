// With fluid that flows: the bits of a run that is taken up again, of any number of threads, and of
// mirror images.
#include <cstddef>
#include <cstdint>
#include <utility>

#include <hfdem/base/archive.hpp>
#include <hfdem/pressure/conventional.hpp>
#include <hfdem/pressure/implicit.hpp>

#include <doctest/doctest.h>

#include "schemes/run_state.hpp"
#include "schemes/small_array.hpp"

namespace {

using Explicit = test::SquareRock<hfdem::ConventionalFlow<>>;
using Implicit = test::SquareRock<hfdem::ImplicitFlow<>>;

Explicit::Params explicitly() {
  return {.injection = {.rate = 1e-3}, .fluid = {.viscosity = 1e-3}};
}
/// Some steps do not converge, so that the fluid step changes.
Implicit::Params implicitly() {
  return {.injection = {.rate = 1e-3},
          .fluid = {.viscosity = 1e-3},
          .scheme = {.max_mechanical_steps = 100}};
}

/// Steps, what they answer, and the state that they lead to.
template <class Sim>
test::Words steps(Sim& sim, int count) {
  test::Words words;
  for (int n = 0; n < count; ++n) {
    const hfdem::FluidStep step = sim.step();
    for (const double v : {step.volume_error, step.unbalanced_ratio, sim.mechanical_dt()})
      test::put(words, v);
    for (const long v : {static_cast<long>(step.mechanical_steps), step.flow_steps})
      words.push_back(static_cast<std::uint64_t>(v));
  }
  const test::Words state = test::state(sim);
  words.insert(words.end(), state.begin(), state.end());
  return words;
}

/// @returns how many bonds have broken since the run was taken up
template <class Sim>
std::size_t check_taken_up(const typename Sim::Params& params, int before, int after) {
  const hfdem::Specimen specimen = test::square(16);
  Sim whole(specimen, params);
  steps(whole, before);
  const std::size_t broken = whole.breaks().size();
  hfdem::Saver saver;
  saver(whole);
  hfdem::Loader saved(saver.sealed(), "the state");
  Sim pieces(specimen, params, saved);
  saved.finish();
  const hfdem::VolumeBalance one = whole.volume_balance(), other = pieces.volume_balance();
  CHECK(one.stored == other.stored);
  CHECK(one.unmet == other.unmet);
  Sim copy = pieces;  // a third, from the same state
  copy.use_threads(3);
  const test::Words expected = steps(whole, after);
  CHECK(steps(pieces, after) == expected);
  CHECK(steps(copy, after) == expected);
  return whole.breaks().size() - broken;
}

template <class Sim>
void check_threads(const typename Sim::Params& params, int count, std::size_t breaks) {
  const auto run = [&](int threads) {
    Sim sim(test::square(40), params);
    sim.use_threads(threads);
    const test::Words words = steps(sim, count);
    CHECK(sim.breaks().size() >= breaks);
    return words;
  };
  const test::Words alone = run(1);
  for (const int threads : {2, 3}) CHECK(run(threads) == alone);
}

template <class Sim>
void check_symmetry(const typename Sim::Params& params, int every) {
  for (const bool lying : {false, true}) {
    CAPTURE(lying);
    typename Sim::Params turned = params;
    if (lying) turned.in_situ = {12e6, 10e6};
    Sim sim(test::square(20), turned);
    for (int n = 0; n < 400 && sim.breaks().size() < 8; ++n) {
      for (int k = 0; k < every; ++k) sim.step();
      REQUIRE(test::asymmetric_discs(sim.discs()) == 0);
    }
    CHECK(sim.breaks().size() >= 8);
  }
}

}  // namespace

TEST_CASE("explicit flow goes on bit for bit from a saved state") {
  check_taken_up<Explicit>(explicitly(), 3, 50);
  CHECK(check_taken_up<Explicit>(explicitly(), 600, 400) >= 1);
}

TEST_CASE("implicit flow goes on bit for bit from a saved state, in the middle of shorter steps") {
  Implicit sim(test::square(16), implicitly());
  const double first = sim.pressure_scheme().fluid_dt(0);
  steps(sim, 30);
  REQUIRE(sim.pressure_scheme().fluid_dt(0) < first);
  check_taken_up<Implicit>(implicitly(), 1, 5);
  CHECK(check_taken_up<Implicit>(implicitly(), 30, 20) >= 1);
}

TEST_CASE("fluid that flows gives the same bits with any number of threads") {
  check_threads<Explicit>(explicitly(), 700, 2);
  check_threads<Implicit>(implicitly(), 40, 2);
}

TEST_CASE("explicit flow drives two wings that mirror each other to the last bit") {
  check_symmetry<Explicit>(explicitly(), 10);
}

TEST_CASE("implicit flow drives two wings that mirror each other to the last bit") {
  auto params = implicitly();
  params.injection.rate = 2e-4;
  params.scheme = {};
  check_symmetry<Implicit>(params, 1);
}
