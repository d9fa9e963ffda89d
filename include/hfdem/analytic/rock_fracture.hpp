/// @file
/// What a fracture meets in an isotropic rock, in the numbers that slits and running cracks
/// measure.
#pragma once

#include <tuple>

#include <hfdem/base/fields.hpp>

namespace hfdem::analytic {

/// A random packing of bonded discs opens like an isotropic elastic plate, and a crack that runs
/// through it meets one toughness. Its path is rough, so it closes at more than the in-situ stress.
struct RockFracture {
  double E_prime = 0;
  double poisson_ratio = 0;
  double K_IC = 0;
  double closing_excess = 0;
  double K_IC_above_in_situ = 0;

  static constexpr auto fields() {
    using P = RockFracture;
    return std::tuple{
        Field{"E_prime", &P::E_prime, "Pa", positive, "plane modulus with which a crack opens, E'"},
        Field{"poisson_ratio", &P::poisson_ratio, "", Range{-1, 1, true, true},
              "Poisson's ratio in the plane"},
        Field{"K_IC", &P::K_IC, "Pa sqrt(m)", positive,
              "toughness, from the pressure above the closing pressure; it drives the growth"},
        Field{"closing_excess", &P::closing_excess, "Pa", any_number,
              "closing pressure of a crack less the in-situ stress across it"},
        Field{"K_IC_above_in_situ", &P::K_IC_above_in_situ, "Pa sqrt(m)", positive,
              "toughness, from the pressure above the in-situ stress, as it is often defined"}};
  }
};

}  // namespace hfdem::analytic
