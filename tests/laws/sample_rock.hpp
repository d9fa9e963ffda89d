// A contact between two unequal discs, and its closed forms. Every parameter has a value of its
// own, so that none can stand in for another.
#pragma once

#include <hfdem/contact/linear_parallel_bond.hpp>

namespace test {

using Bond = hfdem::LinearParallelBond;

inline constexpr Bond::Params sample_rock{.E = 20e9,
                                          .stiffness_ratio = 2,
                                          .friction = 0.4,
                                          .bond_E = 30e9,
                                          .bond_stiffness_ratio = 3,
                                          .tensile_strength = 7e6,
                                          .cohesion = 11e6,
                                          .friction_angle = 35,
                                          .moment_factor = 1};
inline constexpr hfdem::Disc small_disc{3e-3}, large_disc{5e-3};

/// The closed forms for a contact of the two.
namespace sample {
inline constexpr double length = 8e-3;                           // R1 + R2, m
inline constexpr double bond_radius = 3e-3;                      // the smaller of the two, m
inline constexpr double area = 2 * bond_radius;                  // m2 per m
inline constexpr double inertia = 2.0 / 3 * 3e-3 * 3e-3 * 3e-3;  // m4 per m
inline constexpr double k_n = area * 20e9 / length, k_s = k_n / 2;
inline constexpr double bond_k_n = area * 30e9 / length, bond_k_s = bond_k_n / 3;
inline constexpr double bond_k_m = 30e9 / length * inertia;

}  // namespace sample

/// A motion, zero but for what is named.
struct Move {
  double opening = 0, shear = 0, rotation = 0;
  operator hfdem::Motion<double>() const { return {opening, shear, rotation}; }
};

}  // namespace test
