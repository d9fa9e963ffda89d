// A joint contact, and its closed forms. Every parameter has a value of its own, so that none can
// stand in for another.
#pragma once

#include <cmath>
#include <numbers>

#include <hfdem/contact/smooth_joint.hpp>

namespace test {

using Joint = hfdem::SmoothJoint;

inline constexpr Joint::Params sample_joint{.normal_stiffness = 90e9,
                                            .shear_stiffness = 40e9,
                                            .tensile_strength = 0.4e6,
                                            .cohesion = 0.7e6,
                                            .friction = 0.6,
                                            .dilation_angle = 12,
                                            .w0 = 8e-5,
                                            .initially = hfdem::JointContent::filled};

/// The closed forms of its contacts, Pa/m and Pa.
namespace joint {
inline constexpr double k_n = 90e9, k_s = 40e9, friction = 0.6;
inline constexpr double tensile_strength = 0.4e6, cohesion = 0.7e6;
inline const double rise = std::tan(12 * std::numbers::pi / 180);  // of a slip of one
inline constexpr double length = 7e-3;                             // of fracture, m
}  // namespace joint

}  // namespace test
