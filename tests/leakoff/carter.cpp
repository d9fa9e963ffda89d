// Carter's law, on a crack of a few channels.
#include <cmath>
#include <cstddef>
#include <vector>

#include <hfdem/fluid/newtonian.hpp>
#include <hfdem/leakoff/carter.hpp>

#include <doctest/doctest.h>

#include "flow/chain.hpp"
#include "near.hpp"

namespace {

using hfdem::CarterLeakoff;
using hfdem::Euler;
using test::near;

const hfdem::NewtonianFluid fluid{{}};

double lose(CarterLeakoff& law, hfdem::Network& network, double dt, std::vector<double>& stored) {
  const std::vector<double> pressure(stored.size(), 1e6);
  law.join(network);
  law.find_loss(network, fluid, dt, {pressure, stored}, Euler::backward);
  law.commit(network, fluid, {pressure, stored});
  double lost = 0;
  for (std::size_t d = 0; d < law.size(); ++d) {
    lost += law.loss(d, 0);
    stored[d] -= law.loss(d, 0);
  }
  return lost;
}

}  // namespace

TEST_SUITE_BEGIN("carter");

TEST_CASE("a channel loses with the square root of time") {
  test::Chain chain(1, 5e-5, 0);
  CarterLeakoff law({.coefficient = 3e-6});
  std::vector<double> stored(2, 1.0);
  double lost = 0, time = 0;
  for (int n = 1; n <= 1000; ++n) {
    const double dt = 1e-4 * (1 + n % 7);  // the law does not care how long steps are
    lost += lose(law, chain.network, dt, stored);
    time += dt;
    const double exact = 2 * 2 * 3e-6 * test::Chain::length * std::sqrt(time);
    CHECK(lost == near(exact, 1e-12));
    CHECK(law.leaked() == near(exact, 1e-12));
  }
  // Both ends alike.
  CHECK(stored[0] == near(stored[1], 1e-14));
}

TEST_CASE("a channel counts from when it turned wet, and loses no more than there is") {
  test::Chain chain(std::vector<double>(4, 5e-5), 0);
  CarterLeakoff law({.coefficient = 1e-5});
  std::vector<double> stored(5, 1.0);
  // Four channels that were wet from the beginning.
  const double first = lose(law, chain.network, 0.01, stored);
  CHECK(first == near(4 * 4e-5 * test::Chain::length * std::sqrt(0.01), 1e-12));

  SUBCASE("one that turns wet later") {
    test::Chain two(1, 5e-5, 0);
    CarterLeakoff late({.coefficient = 1e-5});
    std::vector<double> its(2, 1.0);
    lose(late, two.network, 0.01, its);
    const hfdem::Index next = test::Chain::channel(0) - 3;  // below the first: on the rim
    two.network.open(next);
    its.resize(two.network.wet_domains().size(), 1.0);
    const double lost = lose(late, two.network, 0.01, its);
    const double old = std::sqrt(0.02) - std::sqrt(0.01), fresh = std::sqrt(0.01);
    const double length = two.network.geometry().channels[next].length;
    // Of a channel on the rim the half outside is not ours.
    CHECK(lost == near(4e-5 * (test::Chain::length * old + length * fresh / 2), 1e-12));
  }
  SUBCASE("little fluid") {
    stored.assign(5, 1e-12);
    CHECK(lose(law, chain.network, 0.01, stored) == near(5e-12, 1e-12));
    for (const double s : stored) CHECK(s == 0);
    // The walls have taken less than they could, so they take the more of what comes: together as
    // much as if they had been wet later.
    stored.assign(5, 1.0);
    const double before = law.leaked(), full = 4e-5 * test::Chain::length;
    const double lost = lose(law, chain.network, 0.01, stored);
    const double inner = (before - 5e-12) / 8 + 5e-13, outer = (before - 5e-12) / 8 + 1e-12;
    const double square = full * full / 4 * 0.01;
    const auto rest = [&](double v) { return std::sqrt(v * v + square) - v; };
    CHECK(lost == near(6 * rest(inner) + 2 * rest(outer), 1e-12));
    CHECK(lost > 1.2 * 4 * full * (std::sqrt(0.03) - std::sqrt(0.02)));  // of walls wet so long
  }
}

TEST_SUITE_END();
