/// @file
/// Young's modulus and Poisson's ratio of a specimen by dry biaxial compression.
#pragma once

#include <cmath>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/measure/mean_strain.hpp>
#include <hfdem/pressure/dry.hpp>
#include <hfdem/simulator.hpp>

namespace hfdem::measure {

/// Settles the intact specimen under `in_situ`, raises the stress along y by a tenth of the larger
/// one, and compares. What is left unbalanced is 1e-5 of the mean contact force: in random rock
/// both moduli are right to some 1e-4 then; how contacts slip on the way matters as much.
/// @param specimen that is bonded anew
/// @param contact parameters of its contacts
/// @param in_situ stress under which it is measured, Pa
/// @param mechanics how it is relaxed
/// @param threads for the loops once the specimen has settled; the result does not depend on it
/// @throws RunStopped if it finds no equilibrium or bonds break on the way
template <ContactLaw Contact, NeighbourSearch Neighbours>
ElasticModuli elastic_moduli(const Specimen& specimen, const typename Contact::Params& contact,
                             Stress in_situ, Mechanics mechanics = {}, int threads = 1) {
  mechanics.settle_tolerance = std::fmin(mechanics.settle_tolerance, 1e-5);
  Simulator<Contact, HyperbolicAperture, Dry, Neighbours> test{
      specimen,
      {.contact = contact, .in_situ = in_situ, .crack = {.contacts = 0}, .mechanics = mechanics}};
  test.use_threads(threads);
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
