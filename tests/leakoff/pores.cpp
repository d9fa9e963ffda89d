// Pores: their volumes, and the flow between them in random rock.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <hfdem/fluid/newtonian.hpp>
#include <hfdem/leakoff/matrix_flow.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/neighbours/kd_tree.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/setup/flow_domains.hpp>
#include <hfdem/setup/random_packing.hpp>
#include <hfdem/setup/square_array.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

namespace {

using hfdem::Euler;
using hfdem::Index;
using hfdem::MatrixFlow;
using test::near;

TEST_CASE("a pore is the domain's polygon less its discs") {
  const auto square = hfdem::square_array(4, 3, 5e-3);
  const auto g = hfdem::flow_domains(square, hfdem::bonded_contacts<hfdem::FixedPairs>(square));
  REQUIRE(g.area.size() == 6);
  for (std::size_t d = 0; d < g.area.size(); ++d) {
    CHECK(g.area[d] == near(1e-4, 1e-12));
    CHECK(g.void_area[d] == near(1e-4 - std::numbers::pi * 25e-6, 1e-12));
  }
  // Of random discs, by the angles at their centres.
  const auto rock = hfdem::random_packing({.width = 0.1, .height = 0.1, .grains = 180});
  const auto r = hfdem::flow_domains(rock, hfdem::bonded_contacts<hfdem::KdTree>(rock));
  double worst = 0;
  for (std::size_t d = 0; d < r.area.size(); ++d) {
    const auto begin = r.discs_begin[d], end = r.discs_begin[d + 1];
    double sectors = 0;
    for (auto k = begin; k < end; ++k) {
      const auto at = [&](auto n) {
        return rock.centre[r.discs_of[begin + (n - begin) % (end - begin)]];
      };
      const hfdem::Vec2 in = at(k) - at(k + 1), out = at(k + 2) - at(k + 1);
      double angle = std::atan2(in.y, in.x) - std::atan2(out.y, out.x);
      if (angle < 0) angle += 2 * std::numbers::pi;
      sectors +=
          std::pow(rock.radius[r.discs_of[begin + (k + 1 - begin) % (end - begin)]], 2) * angle / 2;
    }
    worst = std::fmax(worst, std::abs(r.area[d] - sectors - r.void_area[d]) / r.area[d]);
  }
  CHECK(worst < 1e-9);
}

/// A small random rock with one wet domain in its middle.
struct Rock {
  hfdem::NewtonianFluid fluid{{.viscosity = 1e-3, .bulk_modulus = 2e9}};
  MatrixFlow law;
  hfdem::Network network = made();
  std::vector<double> pressure{5e6}, stored{1};

  explicit Rock(double saturation) : law({.saturation = saturation}) {
    for (Index c = 0; c < network.geometry().channels.size(); ++c) network.set_width(c, 4e-6);
  }
  static hfdem::Network made() {
    const auto rock = hfdem::random_packing({.width = 0.15, .height = 0.15, .grains = 400});
    auto g = hfdem::flow_domains(rock, hfdem::bonded_contacts<hfdem::KdTree>(rock));
    auto points = hfdem::injection_domains(g, rock, {});
    return {std::move(g), std::move(points), 6e-6};
  }
  double run(double time, int steps, Euler euler) {
    double lost = 0;
    law.join(network);
    for (int n = 0; n < steps; ++n) {
      law.find_loss(network, fluid, time / steps, {pressure, stored}, euler);
      law.commit(network, fluid, {pressure, stored});
      lost += law.loss(0, pressure[0]);
    }
    return lost;
  }
};

TEST_CASE("going backward is going forward, with short enough steps") {
  for (const double saturation : {0.0, 0.7, 1.0}) {
    CAPTURE(saturation);
    Rock forward(saturation), backward(saturation), once(saturation);
    const double time = 0.5;
    const double a = forward.run(time, 4000, Euler::forward);
    const double b = backward.run(time, 4000, Euler::backward);
    CHECK(a > 0);
    CHECK(b == near(a, 2e-3));
    double worst = 0;
    for (Index d = 0; d < forward.network.pressures().size(); ++d)
      worst =
          std::fmax(worst, std::abs(forward.network.pressure(d) - backward.network.pressure(d)));
    CHECK(worst < 0.01 * 5e6);
    CHECK(forward.law.leaked() == near(a, 1e-12));
    CHECK(backward.law.leaked() == near(b, 1e-12));
    // In steps far longer than explicit flow bears, which it makes in parts.
    Rock in_parts(saturation);
    CHECK(in_parts.run(time, 100, Euler::forward) == near(a, 4e-3));
    for (const double p : in_parts.network.pressures()) CHECK(p < 5e6);
    // One step for all of it: no pore above the wall, none that pulls.
    CHECK(once.run(time, 1, Euler::backward) > 0);
    for (const double p : once.network.pressures()) {
      CHECK(p >= 0);
      CHECK(p < 5e6);
    }
  }
}

TEST_CASE("a sealed rock comes to the pressure of the crack") {
  Rock rock(1);
  const double lost = rock.run(1e5, 50, Euler::backward);
  double pores = 0;
  const auto& g = rock.network.geometry();
  for (Index d = 0; d < g.area.size(); ++d) {
    if (d == rock.network.injection_domain()) continue;
    CHECK(rock.network.pressure(d) == near(5e6, 1e-6));
    // It pushes its discs; where all domains around a disc press alike, they cancel.
    for (const Index disc : rock.network.discs_of(d)) {
      const auto pushed = rock.network.pushed_discs();
      REQUIRE(std::find(pushed.begin(), pushed.end(), disc) != pushed.end());
    }
    pores += std::fmax(g.void_area[d], 0.01 * g.area[d]);
  }
  CHECK(lost == near(pores * 5e6 / 2e9, 1e-6));
}

TEST_CASE("the loss answers the crack's pressure as it says") {
  for (const Euler euler : {Euler::forward, Euler::backward}) {
    CAPTURE(static_cast<int>(euler));
    Rock rock(1);
    rock.run(0.01, 100, euler);
    const double dt = 1e-6;  // too short for pores farther away to answer
    rock.law.find_loss(rock.network, rock.fluid, dt, {rock.pressure, rock.stored}, euler);
    const double expected = rock.law.loss(0, 5.1e6);
    CHECK(rock.law.slope(0) > 0);
    rock.pressure[0] = 5.1e6;
    rock.law.find_loss(rock.network, rock.fluid, dt, {rock.pressure, rock.stored}, euler);
    CHECK(rock.law.loss(0, 5.1e6) == near(expected, 1e-3));
  }
  // Over a longer time the pores beside the wall answer, too, and a little of those behind them.
  Rock rock(1);
  rock.run(0.01, 100, Euler::backward);
  const auto loss_at = [&](double crack) {
    rock.pressure[0] = crack;
    rock.law.find_loss(rock.network, rock.fluid, 1e-3, {rock.pressure, rock.stored},
                       Euler::backward);
    return rock.law.loss(0, crack);
  };
  const double answer = (loss_at(5.1e6) - loss_at(5e6)) / 1e5;
  CHECK(rock.law.slope(0) > answer);
  CHECK(rock.law.slope(0) < 1.2 * answer);
}

}  // namespace
