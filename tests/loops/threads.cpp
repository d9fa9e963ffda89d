// The bits of a run depend on its parameters alone: not on threads, not on other runs.
#include <algorithm>
#include <cstdint>
#include <vector>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/base/pack.hpp>
#include <hfdem/base/parallel.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

namespace {

using Kgd = hfdem::Simulator<hfdem::LinearParallelBond, hfdem::HyperbolicAperture,
                             hfdem::UniformPressure, hfdem::FixedPairs>;

/// Everything that a run has come to, as bits.
std::vector<std::uint64_t> state(const Kgd& sim) {
  std::vector<std::uint64_t> words;
  for (const hfdem::Pack& row : sim.discs().displacement)
    for (std::size_t lane = 0; lane < 4; ++lane) words.push_back(test::bits(row[lane]));
  for (const double pressure : sim.network().pressures()) words.push_back(test::bits(pressure));
  for (const auto& b : sim.breaks()) {
    words.push_back(b.contact);
    words.push_back(b.mode == hfdem::Mode::tension ? 0 : 1);
    words.push_back(test::bits(b.time));
    words.push_back(test::bits(b.pressure));
  }
  return words;
}

std::vector<std::uint64_t> state_after_run(int threads) {
  Kgd sim(hfdem::square_array(50, 50, 5e-3), {.injection = {.rate = 1e-3}});
  sim.use_threads(threads);
  for (int n = 0; n < 24; ++n) sim.step();
  CHECK(sim.breaks().size() >= 4);
  return state(sim);
}

}  // namespace

TEST_CASE("chunks cover every item once, whatever the number of threads") {
  for (const int threads : {1, 2, 3, 5})
    for (const std::size_t count : {0U, 1U, 63U, 64U, 65U, 1000U}) {
      std::vector<int> visits(count, 0);
      std::vector<int> chunk_of_64((count + 63) / 64, 0);
      hfdem::for_chunks(count, 64, threads,
                        [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                          ++chunk_of_64[chunk];
                          for (std::size_t k = begin; k < end; ++k) visits[k] += k / 64 == chunk;
                        });
      CHECK(std::count(visits.begin(), visits.end(), 1) == static_cast<std::ptrdiff_t>(count));
      CHECK(std::count(chunk_of_64.begin(), chunk_of_64.end(), 1) ==
            static_cast<std::ptrdiff_t>(chunk_of_64.size()));
    }
}

TEST_CASE("a run gives the same bits with any number of threads, and every time") {
  const auto alone = state_after_run(1);
  for (const int threads : {1, 2, 3, 5}) {
    CAPTURE(threads);
    CHECK(state_after_run(threads) == alone);
  }
}

TEST_CASE("two simulators alive at once do not disturb each other") {
  const auto make = [](double stress) -> Kgd {  // at equilibrium all of the state counts
    return {
        hfdem::square_array(20, 20, 5e-3),
        {.in_situ = {stress, 12e6}, .injection = {.rate = 2e-4}, .scheme = {.equilibrium = true}}};
  };
  const auto run = [](Kgd& sim) {
    for (int n = 0; n < 10; ++n) sim.step();
  };
  Kgd one = make(10e6), other = make(5e6);
  for (int n = 0; n < 10; ++n) {
    one.step();
    other.step();
  }
  Kgd one_alone = make(10e6);
  run(one_alone);
  CHECK(state(one) == state(one_alone));
  Kgd other_alone = make(5e6);
  run(other_alone);
  CHECK(state(other) == state(other_alone));
  CHECK(state(one) != state(other));
}
