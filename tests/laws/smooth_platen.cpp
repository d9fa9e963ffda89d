// A disc against a smooth platen.
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/contact/smooth_platen.hpp>

#include <doctest/doctest.h>

#include "laws/sample_rock.hpp"
#include "near.hpp"

using test::near;

TEST_CASE("a platen is as stiff as the other half of a bonded cell") {
  // Discs of one size: k_n = E, bond E_b, and half the length of a contact gives twice its spring.
  const test::Bond rock(test::sample_rock);
  const hfdem::Springs like = rock.springs(rock.stiffness(test::large_disc, test::large_disc));
  const auto k = hfdem::SmoothPlaten::stiffness(like);
  CHECK(k.normal == near(2 * (test::sample_rock.E + test::sample_rock.bond_E)));

  const hfdem::Springs springs = hfdem::SmoothPlaten{}.springs(k);
  CHECK(springs.normal == k.normal);
  CHECK(springs.shear == 0);
  CHECK(springs.moment == 0);
}

TEST_CASE("a platen pushes a disc that presses it, and does nothing else") {
  const hfdem::SmoothPlaten platen;
  const auto pressed = platen.respond<double>(
      {5e10}, {}, test::Move{.opening = -2e-6, .shear = 1e-3, .rotation = 1e-2});
  CHECK(pressed.reaction().normal == near(1e5));
  CHECK(pressed.reaction().shear == 0);
  CHECK(pressed.reaction().moment == 0);
  CHECK(platen.respond<double>({5e10}, {}, test::Move{.opening = 2e-6}).reaction().normal == 0);
}

TEST_CASE("a platen stores what pressing spends, and nothing once it is free") {
  const hfdem::SmoothPlaten platen;
  CHECK(platen.energy<double>({5e10}, {}, test::Move{.opening = -2e-6, .shear = 1e-3}) ==
        near(1e5 * 2e-6 / 2));
  CHECK(platen.energy<double>({5e10}, {}, test::Move{.opening = 2e-6}) == 0);
}
