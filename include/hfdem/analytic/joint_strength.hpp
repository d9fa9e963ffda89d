/// @file
/// Strength of a specimen with one joint from side to side.
///
/// Source: J. C. Jaeger, "Shear failure of anisotropic rocks", Geol. Mag. 97 (1960) 65-72. With the
/// joint at an angle b to the direction of the minor stress s3, the major stress at which it slips
/// under the law of Coulomb is
///
///   s1 = s3 + 2 (c + mu s3) / ((1 - mu cot b) sin 2b)
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

namespace hfdem::analytic {

/// The major stress at which a joint slips, Pa.
/// @param angle of the joint to the minor stress, deg
/// @param friction coefficient mu
/// @param cohesion c, Pa; zero once its bond has broken
/// @param confinement minor stress s3, Pa
/// @returns infinity where no stress makes it slip: up to the angle whose tangent is mu, and at 90
///   degrees
inline double joint_strength(double angle, double friction, double cohesion, double confinement) {
  const double b = angle * std::numbers::pi / 180;
  const double driving = (1 - friction / std::tan(b)) * std::sin(2 * b);
  return driving > 1e-12 ? confinement + 2 * (cohesion + friction * confinement) / driving
                         : std::numeric_limits<double>::infinity();
}

}  // namespace hfdem::analytic
