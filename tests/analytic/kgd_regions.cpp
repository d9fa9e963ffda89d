// The bounds on the map of regimes, against the general solution beside the places that were
// computed, and against converged numerical solutions.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

#include <hfdem/analytic/kgd_regions.hpp>

#include "analytic/kgd_truth.hpp"
#include "near.hpp"

using namespace hfdem::analytic;
using Vertex = KgdRegime;
using hfdem::InvalidParameter;
using test::near;

namespace {

/// The distance written out.
double distance_of(const KgdFracture& vertex, const KgdFracture& f) {
  const double length = std::log(vertex.half_length / f.half_length);
  const double width = std::log(vertex.width / f.width);
  return std::sqrt(length * length + width * width);
}

KgdFracture truth(const test::Row& row) { return {.half_length = row.l, .width = row.w}; }

/// Whether a place is within a closed bound (even-odd rule).
bool inside(const std::vector<KgdPlace>& bound, double log_time, double log_toughness) {
  bool in = false;
  for (std::size_t i = 0; i < bound.size(); ++i) {
    const KgdPlace &a = bound[i], &b = bound[(i + 1) % bound.size()];
    if ((a.log_toughness > log_toughness) == (b.log_toughness > log_toughness)) continue;
    const double part = (log_toughness - a.log_toughness) / (b.log_toughness - a.log_toughness);
    if (log_time < std::lerp(a.log_time, b.log_time, part)) in = !in;
  }
  return in;
}

constexpr std::array vertices{Vertex::storage_toughness, Vertex::storage_viscosity,
                              Vertex::leak_off_toughness, Vertex::leak_off_viscosity};

}  // namespace

TEST_CASE("a place of the map has its tau and K_m") {
  const auto p = problem_at({-7, std::log10(2.0)});
  CHECK(dimensionless_time(p) == near(1e-7));
  CHECK(dimensionless_toughness(p) == near(2));
  CHECK(dimensionless_time(problem_at({-INFINITY, 0})) == 0);
}

TEST_CASE("on a bound, and between its places, the vertex is as far off as the tolerance says") {
  for (const double tolerance : {0.05, 0.01}) {
    for (const Vertex vertex : vertices) {
      CAPTURE(tolerance);
      CAPTURE(static_cast<int>(vertex));
      const auto distance = [&](double log_time, double log_toughness) {
        const auto p = test::unit_problem(std::pow(10, log_toughness), std::pow(10, log_time));
        return distance_of(at_vertex(vertex, p), general_kgd(p));
      };
      const auto bound = region(vertex, tolerance);
      std::size_t checked = 0;
      for (std::size_t i = 0; i + 2 < bound.size(); ++i) {  // the last closes it, deep inside
        const KgdPlace &a = bound[i], &b = bound[i + 1];
        if (std::abs(a.log_time) > 19 || std::abs(b.log_time) > 19) continue;  // of these units
        CHECK(distance(a.log_time, a.log_toughness) == near(tolerance, 0.002));
        // The chords cut the corners.
        CHECK(distance(std::midpoint(a.log_time, b.log_time),
                       std::midpoint(a.log_toughness, b.log_toughness)) == near(tolerance, 0.06));
        ++checked;
      }
      CHECK(checked > 20);
      CHECK(vertex_distance(vertex, bound.back()) < 0.2 * tolerance);
    }
  }
}

TEST_CASE("a place is in a region if and only if its vertex is within the tolerance") {
  for (const double tolerance : {0.05, 0.01})
    for (const KgdRegime vertex : vertices) {
      CAPTURE(tolerance);
      CAPTURE(static_cast<int>(vertex));
      const auto bound = region(vertex, tolerance);
      std::size_t in = 0;
      for (double log_time = -19.3; log_time < 15; log_time += 2.9)
        for (double log_toughness = -0.97; log_toughness < 1.5; log_toughness += 0.21) {
          const auto p = test::unit_problem(std::pow(10, log_toughness), std::pow(10, log_time));
          const double distance = distance_of(at_vertex(vertex, p), general_kgd(p));
          if (std::abs(std::log(distance / tolerance)) < 0.05) continue;  // on the bound
          CHECK(inside(bound, log_time, log_toughness) == (distance < tolerance));
          if (distance < tolerance) ++in;
        }
      CHECK(in >= 6);
    }
}

TEST_CASE("converged numerical solutions are in the regions that they belong to") {
  for (const KgdRegime vertex : vertices) {
    CAPTURE(static_cast<int>(vertex));
    const auto bound = region(vertex, 0.05);
    std::size_t in = 0;
    for (const test::Row& row : test::leaky_rows) {
      const auto p = test::unit_problem(row.K_m, row.tau);
      const double distance = distance_of(at_vertex(vertex, p), truth(row));
      if (std::abs(distance - 0.05) < 0.005) continue;  // the approximation may be beyond
      CAPTURE(row.K_m);
      CAPTURE(row.tau);
      CHECK(inside(bound, std::log10(row.tau), std::log10(row.K_m)) == (distance < 0.05));
      if (distance < 0.05) ++in;
    }
    CHECK(in > 0);
  }
}

TEST_CASE("without leak-off the bounds are where converged solutions are that far off") {
  const auto check = [](KgdRegime vertex, double K_m) {
    CAPTURE(K_m);
    const auto row = std::ranges::find(test::tight_rows, K_m, &test::Row::K_m);
    const auto p = test::tight_problem(K_m);
    const double tolerance = distance_of(at_vertex(vertex, p), truth(*row));
    CHECK(bound_without_leak_off(vertex, tolerance) == near(K_m, 0.028));
  };
  check(Vertex::storage_viscosity, 0.70);  // 1.0 %
  check(Vertex::storage_viscosity, 1.09);  // 3.9 %
  check(Vertex::storage_viscosity, 1.50);  // 9.4 %
  check(Vertex::storage_toughness, 3.00);  // 5.3 %: -3.12 % in length, +4.33 % in width
  check(Vertex::storage_toughness, 4.80);  // 0.9 %
}

TEST_CASE(
    "at 1 % the bounds are those that Dontsov and the paper draw, and that the regime knows") {
  CHECK(bound_without_leak_off(Vertex::storage_toughness, 0.01) == near(4.80, 0.01));
  CHECK(bound_without_leak_off(Vertex::storage_viscosity, 0.01) == near(0.70, 0.01));
  // Far from its corner a bound is one in K_m at its beginning and one in time at its end.
  const auto check = [](KgdRegime vertex, double K_m, double log_time, double time_per_toughness) {
    CAPTURE(static_cast<int>(vertex));
    const auto bound = region(vertex, 0.01);
    CHECK(std::pow(10, bound.front().log_toughness) == near(K_m, 0.02));
    const KgdPlace& last = bound[bound.size() - 2];
    CHECK(std::abs(last.log_time - time_per_toughness * last.log_toughness - log_time) < 0.3);
  };
  check(Vertex::storage_toughness, 4.80, std::log10(1.25e-14), 4);
  check(Vertex::storage_viscosity, 0.70, std::log10(1.21e-13), 0);
  check(Vertex::leak_off_toughness, 4.80, std::log10(1.76e5), 4);
  check(Vertex::leak_off_viscosity, 0.90, std::log10(2.36e6), 0);
}

TEST_CASE("regions that cannot be are refused") {
  CHECK_THROWS_WITH_AS(region(Vertex::storage_toughness, 0.2),
                       doctest::Contains("regions.tolerance = 0.2 is not allowed: it must be at "
                                         "least 0.005 and at most 0.1"),
                       InvalidParameter);
  CHECK_THROWS_AS(region(Vertex::storage_toughness, NAN), InvalidParameter);
  CHECK_THROWS_WITH_AS(region(Vertex::transitional, 0.05), doctest::Contains("transitional"),
                       InvalidParameter);
  CHECK_THROWS_AS(bound_without_leak_off(Vertex::storage_toughness, 0.001), InvalidParameter);
  CHECK_THROWS_WITH_AS(bound_without_leak_off(Vertex::leak_off_toughness, 0.05),
                       doctest::Contains("leak-off"), InvalidParameter);
}
