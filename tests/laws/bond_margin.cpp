// How far a contact is from failing: no motion within the margin breaks the bond, and one a little
// beyond it does.
#include <algorithm>
#include <cmath>

#include <hfdem/contact/incremental_parallel_bond.hpp>
#include <hfdem/contact/scattered_parallel_bond.hpp>
#include <hfdem/contact/unbreakable.hpp>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "laws/sample_rock.hpp"
#include "near.hpp"

namespace {

using test::Move;
using Scattered = hfdem::ScatteredParallelBond;

template <class Law>
bool fails(const Law& law, const typename Law::template Stiffness<double>& k, const Move& move) {
  const auto f = law.failure(k, law.template respond<double>(k, {}, move));
  return f.tension || f.shear;
}
template <class Law>
double margin(const Law& law, const typename Law::template Stiffness<double>& k, const Move& move) {
  return law.margin(k, law.template respond<double>(k, {}, move));
}

/// Motions in which a bond of the sample rock holds or fails, about as often.
Move any_move(test::Random& random) {
  const double strain = 4e-6;  // m; at 1.9 um the bond breaks in tension
  return {random(-strain, strain), random(-strain, strain), random(-strain, strain) / 3e-3};
}

/// The same motion further by `distance`, as the margin measures it, in this direction.
Move further(const Move& from, const Move& way, double distance) {
  const double length = std::abs(way.opening) + std::abs(way.shear) +
                        std::abs(way.rotation) * test::sample::bond_radius;
  const double part = distance / length;
  return {from.opening + part * way.opening, from.shear + part * way.shear,
          from.rotation + part * way.rotation};
}

template <class Law>
void check_margin(const Law& law, const typename Law::template Stiffness<double>& k) {
  test::Random random(11);
  int held = 0, reached = 0;
  for (int n = 0; n < 2000; ++n) {
    const Move at = any_move(random);
    const double distance = margin(law, k, at);
    CHECK((distance >= 0) == !fails(law, k, at));
    if (distance <= 0) continue;
    ++held;
    for (int way = 0; way < 20; ++way)
      CHECK_FALSE(fails(law, k, further(at, any_move(random), 0.999999 * distance)));
    // Straight towards tension or shear.
    const double side = at.rotation < 0 ? -1 : 1, along = at.shear < 0 ? -1 : 1;
    reached += fails(law, k, further(at, {.opening = 1}, 1.000001 * distance)) ||
               fails(law, k, further(at, {.rotation = side}, 1.000001 * distance)) ||
               fails(law, k, further(at, {.shear = along}, 1.000001 * distance));
  }
  CHECK(held > 500);
  CHECK(reached > held / 2);  // where cohesion is next to friction, the margin is on the safe side
}

}  // namespace

TEST_SUITE_BEGIN("bond_margin");

TEST_CASE("no motion within the margin breaks a bond, and one beyond it does") {
  const test::Bond law(test::sample_rock);
  check_margin(law, law.stiffness(test::small_disc, test::large_disc));
}

TEST_CASE("the same in incremental form") {
  const hfdem::IncrementalParallelBond law(test::sample_rock);
  check_margin(law, law.stiffness(test::small_disc, test::large_disc));
}

TEST_CASE("a bond of another strength has another margin") {
  const Scattered law(Scattered::Params{test::sample_rock, 4, 1});
  auto k = law.stiffness(test::small_disc, test::large_disc);
  const double mean = margin(law, k, {});
  for (const double weakness : {0.5, 1.0, 1.7}) {
    k.weakness = weakness;
    CHECK(margin(law, k, {}) == test::near(mean / weakness, 1e-12));
    check_margin(law, k);
  }
}

TEST_CASE("the margins of single strengths are their closed forms") {
  const test::Bond law(test::sample_rock);
  const auto k = law.stiffness(test::small_disc, test::large_disc);
  namespace sample = test::sample;
  const double in_tension = test::sample_rock.tensile_strength * sample::area / sample::bond_k_n;
  CHECK(margin(law, k, {}) == test::near(in_tension, 1e-12));
  CHECK(margin(law, k, {.opening = 0.4 * in_tension}) == test::near(0.6 * in_tension, 1e-12));
  CHECK(margin(law, k, {.rotation = 0.4 * in_tension / sample::bond_radius}) ==
        test::near(0.6 * in_tension, 1e-12));
  // Under strong compression shear is nearer; friction grows faster there than stiffness in shear.
  const double tan = std::tan(35 * std::numbers::pi / 180), closing = 3e-6;
  const double strength =
      test::sample_rock.cohesion * sample::area + tan * sample::bond_k_n * closing;
  CHECK(margin(law, k, {.opening = -closing, .shear = 0.9 * strength / sample::bond_k_s}) ==
        test::near(0.1 * strength / (sample::bond_k_n * tan), 1e-12));
}

TEST_CASE("a broken bond never comes near to failing") {
  const test::Bond law(test::sample_rock);
  const auto broken = law.broken(law.stiffness(test::small_disc, test::large_disc));
  for (const double opening : {-1.0, 0.0, 1.0})
    CHECK(margin(law, broken, {.opening = opening, .shear = 1, .rotation = 1}) > 1e300);
}

TEST_CASE("an unbreakable bond has no end") {
  const hfdem::Unbreakable<test::Bond> law(test::sample_rock);
  const auto k = law.stiffness(test::small_disc, test::large_disc);
  CHECK(margin(law, k, {.opening = 1, .shear = 1, .rotation = 1}) > 1e300);
  CHECK_FALSE(fails(law, k, {.opening = 1, .shear = 1, .rotation = 1}));
}

TEST_SUITE_END();
