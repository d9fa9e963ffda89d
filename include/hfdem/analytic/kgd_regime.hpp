/// @file
/// Where on the map of regimes a KGD fracture is (the paper's Fig. 4).
#pragma once

#include <array>
#include <cmath>

#include <hfdem/analytic/kgd_general.hpp>

namespace hfdem::analytic {

/// Dimensionless time tau = E' C'^6 t / (mu' Q^3), the paper's Eq. 8: leak-off takes over as it
/// grows. 0 without leak-off; infinite without viscosity.
inline double dimensionless_time(const KgdProblem& p) {
  if (p.leak_off == 0) return 0;
  return std::pow(p.C_prime() / p.rate * p.C_prime(), 3) * (p.E_prime / p.mu_prime() * p.time);
}

/// K_m = (K'^4 / (mu' E'^3 Q))^(1/4), the paper's Eq. 9: toughness takes over from viscosity as it
/// grows. Infinite without viscosity.
inline double dimensionless_toughness(const KgdProblem& p) {
  const auto root = [](double v) { return std::sqrt(std::sqrt(v)); };
  return p.K_prime() / p.E_prime / root(p.mu_prime() / p.E_prime) / root(p.rate);
}

/// Which vertex a fracture is close to, if any.
enum class KgdRegime {
  storage_toughness,
  storage_viscosity,
  leak_off_toughness,
  leak_off_viscosity,
  transitional
};

/// The decimal logarithm of tau / K_m^4 = E'^4 C'^6 t / (K'^4 Q^2), the time by which leak-off
/// takes over from storage where toughness dominates: no viscosity is in it.
inline double log_toughness_time(const KgdProblem& p) {
  return 4 * std::log10(p.E_prime / p.K_prime()) + 6 * std::log10(p.C_prime()) +
         std::log10(p.time) - 2 * std::log10(p.rate);
}

/// The regime by the bounds that Dontsov (Int. J. Fract. 205 (2017) 221-237) and the paper's Fig. 4
/// draw. On them the vertex is about 1 % off the general solution (the root of the sum of the
/// squares in length and width).
inline KgdRegime regime(const KgdProblem& p) {
  const double K_m = dimensionless_toughness(p);
  const double log_time = std::log10(dimensionless_time(p));
  const double log_tough_time = log_toughness_time(p);
  if (K_m > 4.80 && log_tough_time < std::log10(1.25e-14)) return KgdRegime::storage_toughness;
  if (K_m > 4.80 && log_tough_time > std::log10(1.76e5)) return KgdRegime::leak_off_toughness;
  if (K_m < 0.70 && log_time < std::log10(1.21e-13)) return KgdRegime::storage_viscosity;
  if (K_m < 0.90 && log_time > std::log10(2.36e6)) return KgdRegime::leak_off_viscosity;
  return KgdRegime::transitional;
}

/// A problem's fracture at one of the vertices.
inline KgdFracture at_vertex(KgdRegime vertex, const KgdProblem& p) {
  constexpr std::array vertices{&storage_toughness, &storage_viscosity, &leak_off_toughness,
                                &leak_off_viscosity};
  return vertices[static_cast<std::size_t>(vertex)](p);
}

/// How far a vertex is from the general solution of the same problem: the root of the sum of the
/// squares of the logarithms of the ratios of half-length and width at the injection. (By length
/// alone M~ and K~ would be the same.) Infinite where the vertex has no fracture.
inline double vertex_distance(const KgdFracture& vertex, const KgdFracture& general) {
  return std::hypot(std::log(vertex.half_length / general.half_length),
                    std::log(vertex.width / general.width));
}

/// A vertex, and how far it is from the general solution.
struct NearestVertex {
  KgdRegime regime = KgdRegime::transitional;  ///< never that, once found
  KgdFracture fracture{};                      ///< of the same problem at the vertex
  double distance = INFINITY;                  ///< `vertex_distance`
};

/// The vertex closest to the general solution.
inline NearestVertex nearest_vertex(const KgdProblem& p, const KgdFracture& general) {
  NearestVertex nearest;
  for (std::size_t k = 0; k < std::size_t(KgdRegime::transitional); ++k) {
    const auto vertex = static_cast<KgdRegime>(k);
    const KgdFracture f = at_vertex(vertex, p);
    // Without viscosity, toughness or leak-off some vertices lie infinitely far: never closer.
    const double distance = vertex_distance(f, general);
    if (distance < nearest.distance) nearest = {vertex, f, distance};
  }
  return nearest;
}

}  // namespace hfdem::analytic

namespace hfdem {
template <>
inline constexpr std::array<std::string_view, 5> names_of<analytic::KgdRegime>{
    "storage-toughness", "storage-viscosity", "leak-off-toughness", "leak-off-viscosity",
    "transitional"};
}  // namespace hfdem
