// When a parallel bond breaks: just below its strength it holds, just above it fails.
#include <cmath>
#include <numbers>

#include <hfdem/contact/linear_parallel_bond.hpp>

#include <doctest/doctest.h>

#include "laws/sample_rock.hpp"

namespace {

using test::Move;
namespace sample = test::sample;

constexpr double just_below = 1 - 1e-6, just_above = 1 + 1e-6;

hfdem::Failure<double> failure(const Move& motion, double moment_factor = 1) {
  test::Bond::Params params = test::sample_rock;
  params.moment_factor = moment_factor;
  const test::Bond law(params);
  const auto k = law.stiffness(test::small_disc, test::large_disc);
  return law.failure(k, law.respond<double>(k, {}, motion));
}

/// The motion at which the bond has these stresses, Pa: in the mean (tension positive), from
/// bending at its edge, and in shear.
Move stressed(double tension, double bending, double shear) {
  return {.opening = tension * sample::area / sample::bond_k_n,
          .shear = shear * sample::area / sample::bond_k_s,
          .rotation = bending * sample::inertia / sample::bond_radius / sample::bond_k_m};
}

const double tan_friction_angle = std::tan(35 * std::numbers::pi / 180);

}  // namespace

TEST_CASE("a bond breaks in tension when mean and bending stress exceed its strength") {
  const double strength = test::sample_rock.tensile_strength;
  for (const double beta : {0.0, 0.6, 1.0})
    for (const double mean : {-0.5, 0.0, 0.3, 1.0})  // of the strength
      for (const double side : {1.0, -1.0}) {
        if (beta == 0 && mean != 1) continue;
        const double bending = beta == 0 ? 5.0 : side * (1 - mean) / beta;
        const auto at = [&](double factor) {
          return failure(stressed(factor * mean * strength, factor * bending * strength, 0), beta);
        };
        CAPTURE(beta);
        CAPTURE(mean);
        CHECK_FALSE(at(just_below).tension);
        CHECK(at(just_above).tension);
        CHECK_FALSE(at(just_above).shear);
      }
}

TEST_CASE("compression and bending without moment factor break nothing in tension") {
  CHECK_FALSE(failure(stressed(-1e9, 0, 0)).tension);
  CHECK_FALSE(failure(stressed(0, 1e9, 0), 0.0).tension);
}

TEST_CASE("a bond breaks in shear when the stress exceeds cohesion and friction") {
  for (const double compression : {0.0, 2e6, 40e6})
    for (const double way : {1.0, -1.0}) {
      const double strength = test::sample_rock.cohesion + compression * tan_friction_angle;
      const auto at = [&](double factor) {
        return failure(stressed(-compression, 0, way * factor * strength));
      };
      CAPTURE(compression);
      CHECK_FALSE(at(just_below).shear);
      CHECK(at(just_above).shear);
      CHECK_FALSE(at(just_above).tension);
    }
}

TEST_CASE("tension takes nothing from the cohesion") {
  const double tension = 0.9 * test::sample_rock.tensile_strength;
  const double cohesion = test::sample_rock.cohesion;
  CHECK_FALSE(failure(stressed(tension, 0, just_below * cohesion)).shear);
  CHECK(failure(stressed(tension, 0, just_above * cohesion)).shear);
}

TEST_CASE("a bond can be over both strengths at once") {
  const auto both = failure(stressed(8e6, 0, 12e6));
  CHECK(both.tension);
  CHECK(both.shear);
}

TEST_CASE("a broken bond never breaks again") {
  const test::Bond law(test::sample_rock);
  const auto broken = law.broken(law.stiffness(test::small_disc, test::large_disc));
  for (const double opening : {-1.0, 0.0, 1.0}) {
    const auto r =
        law.respond<double>(broken, {}, Move{.opening = opening, .shear = 1, .rotation = 1});
    CHECK(r.bond_normal == 0);
    CHECK(r.bond_shear == 0);
    CHECK(r.bond_moment == 0);
    CHECK_FALSE(law.failure(broken, r).tension);
    CHECK_FALSE(law.failure(broken, r).shear);
  }
}
