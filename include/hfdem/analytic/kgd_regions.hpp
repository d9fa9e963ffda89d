/// @file
/// The regions of the map of regimes (the paper's Fig. 4): where a vertex is as close to the
/// general solution as a tolerance asks, in half-length and width (`vertex_distance`).
///
/// Each region is a quadrant of the map with a rounded corner. Its sides are a K_m at which
/// viscosity and toughness change places, and a time at which storage and leak-off do: a tau at M
/// and M~, a tau / K_m^4 at K and K~. At a tolerance of 1 % these are the straight bounds that E.
/// V. Dontsov (Int. J. Fract. 205 (2017) 221-237) and the paper draw, and that `regime` knows.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <hfdem/analytic/kgd_regime.hpp>

namespace hfdem::analytic {

/// A place on the map. Without leak-off `log_time` is minus infinity.
struct KgdPlace {
  double log_time;       ///< log10 of tau
  double log_toughness;  ///< log10 of K_m
};

/// The place's problem in units E' = mu' = Q = t = 1.
inline KgdProblem problem_at(const KgdPlace& place) {
  return {.E_prime = 1,
          .K_IC = std::pow(10, place.log_toughness) / k_prime(1),
          .viscosity = 1.0 / 12,
          .leak_off = std::pow(10, place.log_time / 6) / 2,
          .rate = 1,
          .time = 1};
}

/// `vertex_distance` at a place.
inline double vertex_distance(KgdRegime vertex, const KgdPlace& place) {
  const KgdProblem p = problem_at(place);
  return vertex_distance(at_vertex(vertex, p), general_kgd(p));
}

namespace detail {

/// Where a vertex's region begins, and one step along the diagonal of its quadrant into it.
struct KgdCorner {
  KgdPlace place, inward;
};

/// Roughly: the bound itself is found by its distance.
inline KgdCorner corner(KgdRegime vertex) {
  constexpr double time = 4, toughness = 0.5;  // decades of a step
  switch (vertex) {
    case KgdRegime::storage_toughness:
      return {{-9, 0.5}, {-time, toughness}};
    case KgdRegime::storage_viscosity:
      return {{-10, -0.05}, {-time, -toughness}};
    case KgdRegime::leak_off_toughness:
      return {{5, 0.5}, {time, toughness}};
    case KgdRegime::leak_off_viscosity:
      return {{4.5, 0.1}, {time, -toughness}};
    case KgdRegime::transitional:
      break;
  }
  throw InvalidParameter("the regime transitional has no region: it is what the vertices leave");
}

/// The zero of log(distance / tolerance) along a path of places that enters the vertex's region
/// between `out` and `in`.
template <class Path>
double entrance(KgdRegime vertex, double tolerance, double out, double in, Path&& place) {
  const auto surplus = [&](double way) {
    // Deep inside, what is left of the distance says nothing, and may be zero.
    return std::log(std::fmax(vertex_distance(vertex, place(way)), 1e-3 * tolerance) / tolerance);
  };
  return zero_between(out, in, surplus, 1e-4);
}

inline void validate_tolerance(double tolerance) {
  constexpr Range known{.low = 0.005, .high = 0.1};  // where the general solution is that accurate
  if (!known.contains(tolerance))
    refuse("regions", "tolerance", to_text(tolerance), to_text(known, ""));
}

}  // namespace detail

/// The bound of a vertex's region: along the side that a K_m bounds, around the corner, along the
/// side that a time bounds, each 13 to 40 decades of tau or 3 of K_m long; and last a place deep
/// inside that closes it.
/// @param vertex the region's
/// @param tolerance `vertex_distance` on the bound, 0.005 to 0.1
/// @throws InvalidParameter for another tolerance, or the regime transitional
inline std::vector<KgdPlace> region(KgdRegime vertex, double tolerance) {
  detail::validate_tolerance(tolerance);
  const detail::KgdCorner corner = detail::corner(vertex);
  const KgdPlace &from = corner.place, &step = corner.inward;
  constexpr double far = 5;       // steps
  constexpr int half_count = 24;  // close around the corner, far apart along the straight sides
  std::vector<KgdPlace> places;
  for (int k = -half_count; k <= half_count; ++k) {
    // Parallels of the diagonal: each enters the region once.
    const double part = double(k) / half_count, aside = far * part * std::abs(part);
    const auto along = [&](double way) -> KgdPlace {
      return {from.log_time + (way - aside) * step.log_time,
              from.log_toughness + (way + aside) * step.log_toughness};
    };
    places.push_back(
        along(detail::entrance(vertex, tolerance, -2, 3 + 3 * std::abs(aside), along)));
  }
  places.push_back(
      {from.log_time + 2 * far * step.log_time, from.log_toughness + 2 * far * step.log_toughness});
  return places;
}

/// K_m on the bound of a region where there is no leak-off.
/// @param vertex storage_toughness, whose region is above, or storage_viscosity, below
/// @param tolerance `vertex_distance` on the bound, 0.005 to 0.1
/// @throws InvalidParameter for another vertex or tolerance
inline double bound_without_leak_off(KgdRegime vertex, double tolerance) {
  detail::validate_tolerance(tolerance);
  if (vertex != KgdRegime::storage_toughness && vertex != KgdRegime::storage_viscosity)
    throw InvalidParameter(
        "without leak-off only storage-toughness and storage-viscosity have regions");
  const double side = vertex == KgdRegime::storage_toughness ? 1 : -1;
  const auto across = [&](double way) -> KgdPlace { return {-INFINITY, 0.25 + side * way}; };
  return std::pow(10, across(detail::entrance(vertex, tolerance, 0, 1, across)).log_toughness);
}

}  // namespace hfdem::analytic
