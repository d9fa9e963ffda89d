// Bonds of unequal strength: the distribution of their factors, and what a factor does.
#include <cmath>
#include <vector>

#include <hfdem/contact/scattered_parallel_bond.hpp>
#include <hfdem/contact/unbreakable.hpp>
#include <hfdem/state/concepts.hpp>

#include <doctest/doctest.h>

#include "laws/sample_rock.hpp"
#include "near.hpp"

namespace {

using hfdem::Index;
using hfdem::LinearParallelBond;
using Scattered = hfdem::ScatteredParallelBond;
using test::near;
namespace sample = test::sample;

static_assert(hfdem::VaryingLaw<Scattered>);
static_assert(hfdem::VaryingLaw<hfdem::Unbreakable<Scattered>>);
static_assert(!hfdem::VaryingLaw<LinearParallelBond>);

Scattered law_of(double modulus, int seed = 1) {
  return Scattered({test::sample_rock, modulus, seed});
}

std::vector<double> factors(const Scattered& law) {
  std::vector<double> all;
  for (Index c = 0; c < 200'000; ++c) all.push_back(law.strength_factor(c));
  return all;
}

/// Whether contact 7 fails with these stresses in its bond, Pa.
hfdem::Failure<double> failure(const Scattered& law, double tension, double shear) {
  const auto k = law.varied(law.stiffness(test::small_disc, test::large_disc), 7);
  const test::Move motion{.opening = tension * sample::area / sample::bond_k_n,
                          .shear = shear * sample::area / sample::bond_k_s,
                          .rotation = 0};
  return law.failure(k, law.respond<double>(k, {}, motion));
}

}  // namespace

TEST_CASE("strength factors have Weibull's distribution, with mean one") {
  for (const double m : {1.0, 2.0, 5.0, 20.0}) {
    CAPTURE(m);
    const double scale = 1 / std::tgamma(1 + 1 / m);
    double mean = 0, square = 0;
    int below_half = 0, below_scale = 0;
    const auto all = factors(law_of(m));
    const auto count = static_cast<double>(all.size());
    for (const double f : all) {
      mean += f / count;
      square += f * f / count;
      below_half += f < 0.5;
      below_scale += f < scale;
    }
    CHECK(mean == near(1, 0.01));
    CHECK(square == near(std::tgamma(1 + 2 / m) * scale * scale, 0.02));
    CHECK(below_scale / count == near(1 - std::exp(-1.0), 0.01));
    const double expected = 1 - std::exp(-std::pow(0.5 / scale, m));
    CHECK(std::abs(below_half / count - expected) < 4 * std::sqrt(expected / count));
  }
}

TEST_CASE("every seed and every contact draws its own factor") {
  const Scattered one = law_of(5, 1), same = law_of(5, 1), other = law_of(5, 2);
  CHECK(one.strength_factor(3) == same.strength_factor(3));
  CHECK(one.strength_factor(3) != other.strength_factor(3));
  CHECK(one.strength_factor(3) != one.strength_factor(4));
}

TEST_CASE("a factor scales tensile strength and cohesion, and neither friction nor stiffness") {
  const Scattered law = law_of(3);
  const double factor = law.strength_factor(7);
  REQUIRE(std::abs(factor - 1) > 0.05);
  const double tensile = factor * test::sample_rock.tensile_strength;
  const double cohesion = factor * test::sample_rock.cohesion;
  CHECK_FALSE(failure(law, 0.999 * tensile, 0).tension);
  CHECK(failure(law, 1.001 * tensile, 0).tension);
  CHECK_FALSE(failure(law, 0, 0.999 * cohesion).shear);
  CHECK(failure(law, 0, 1.001 * cohesion).shear);
  const double pressed = 40e6, friction = pressed * std::tan(35 * std::acos(-1.0) / 180);
  CHECK_FALSE(failure(law, -pressed, 0.999 * (cohesion + friction)).shear);
  CHECK(failure(law, -pressed, 1.001 * (cohesion + friction)).shear);

  const LinearParallelBond even(test::sample_rock);
  const auto k = law.varied(law.stiffness(test::small_disc, test::large_disc), 7);
  const auto as_even = even.springs(even.stiffness(test::small_disc, test::large_disc));
  CHECK(law.springs(k).normal == as_even.normal);
  CHECK(law.springs(k).shear == as_even.shear);
  CHECK(law.broken(k).bond == 0);
}

TEST_CASE("without a modulus all bonds are alike") {
  const Scattered law({test::sample_rock, {}, 1});
  CHECK(law.strength_factor(7) == 1);
  CHECK_FALSE(failure(law, 0.9999 * test::sample_rock.tensile_strength, 0).tension);
  CHECK(failure(law, 1.0001 * test::sample_rock.tensile_strength, 0).tension);
}
