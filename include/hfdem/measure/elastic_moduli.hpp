/// @file
/// Young's modulus and Poisson's ratio of a specimen by dry biaxial compression.
#pragma once

#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/pressure/dry.hpp>
#include <hfdem/simulator.hpp>

namespace hfdem::measure {

/// Raw values of the plane assembly, tested with its sides free to move.
struct ElasticModuli {
  double young;    ///< Pa
  double poisson;  ///< -
};

/// Mean strains (shortening positive) by a straight line through the displacements of some discs:
/// measured on the grains, not between platens.
inline Vec2 mean_shortening(const Discs& discs, std::span<const Index> some) {
  const auto slope = [&](double Vec2::*axis, int lane) {
    double mean_position = 0, mean_displacement = 0, covariance = 0, variance = 0;
    const auto count = static_cast<double>(some.size());
    for (const Index i : some) {
      mean_position += discs.centre[i].*axis / count;
      mean_displacement += discs.displacement[i][lane] / count;
    }
    for (const Index i : some) {
      const double away = discs.centre[i].*axis - mean_position;
      covariance += away * (discs.displacement[i][lane] - mean_displacement);
      variance += away * away;
    }
    return -covariance / variance;
  };
  return {slope(&Vec2::x, 0), slope(&Vec2::y, 1)};
}

/// The same of all discs.
inline Vec2 mean_shortening(const Discs& discs) {
  std::vector<Index> all(discs.size());
  std::iota(all.begin(), all.end(), Index{0});
  return mean_shortening(discs, all);
}

/// Settles the intact specimen under `in_situ`, raises the stress along y by a tenth of the larger
/// one, and compares.
/// @throws RunStopped if it finds no equilibrium or bonds break on the way
template <ContactLaw Contact, NeighbourSearch Neighbours>
ElasticModuli elastic_moduli(const Specimen& specimen, const typename Contact::Params& contact,
                             Stress in_situ, Mechanics mechanics = {}) {
  mechanics.settle_tolerance = std::fmin(mechanics.settle_tolerance, 1e-6);
  Simulator<Contact, HyperbolicAperture, Dry, Neighbours> test{
      specimen,
      {.contact = contact, .in_situ = in_situ, .crack = {.contacts = 0}, .mechanics = mechanics}};
  const Vec2 before = mean_shortening(test.discs());
  const double largest = std::fmax(in_situ.xx, in_situ.yy);
  const double raise = largest > 0 ? largest / 10 : 1e5;
  test.set_in_situ({in_situ.xx, in_situ.yy + raise});
  if (!test.breaks().empty())
    throw RunStopped("bonds broke while the elastic moduli were measured: the in-situ stress is " +
                     in_words(in_situ.xx) + " Pa and " + in_words(in_situ.yy) + " Pa");
  const Vec2 change = mean_shortening(test.discs()) - before;
  return {raise / change.y, -change.x / change.y};
}

}  // namespace hfdem::measure
