/// @file
/// Numbers printed in the paper, to stand beside ours.
#pragma once

#include <cmath>
#include <string_view>

namespace hfdem::support::paper {

/// Section 3.2, Figs. 5 and 6: the square array at t = 0.9 s.
struct Verification {
  static constexpr double time = 0.9;               ///< s
  static constexpr double full_length = 0.770;      ///< m, numerical
  static constexpr double aperture = 7.24e-5;       ///< m, numerical
  static constexpr double kgd_full_length = 0.763;  ///< m, as printed
  static constexpr double kgd_aperture = 7.52e-5;   ///< m, as printed
  static constexpr double E_prime = 35.1e9;         ///< Pa: what its KGD values were computed with
  static constexpr double K_IC = 1.88e6;            ///< Pa sqrt(m): fitted there to its length
};

/// Section 4.1: intact rock.
struct Intact {
  static constexpr double E_prime = 39.17e9;        ///< Pa: what its KGD values follow from
  static constexpr double K_IC = 2.66e6;            ///< Pa sqrt(m): fitted there to case 2-S1
  static constexpr double time = 1.5;               ///< of the figures of cases S1, s
  static constexpr double kgd_full_length = 0.919;  ///< of case 2-S1, m, as printed
  static constexpr double kgd_aperture = 10.40e-5;  ///< of case 2-S1, m, as printed
};

/// What is printed of a case of Table 4: one random specimen each, with natural fractures that are
/// drawn, not listed. Not a number where nothing is.
struct Case {
  double breakdown = NAN;              ///< Pa
  double tortuosity = NAN;             ///< at 1.5 s (cases S1)
  double tip_distance = NAN;           ///< at 1.5 s, m
  double total_length = NAN;           ///< of all microcracks at 1.5 s, m
  double aperture = NAN;               ///< at the injection at 1.5 s, m
  double joint_microcracks = NAN;      ///< Table 5
  double connected_microcracks = NAN;  ///< of these
};
/// Section 4.1, Figs. 7 and 12, Section 4.2, Table 5, and Section 5.1.
inline Case of_case(std::string_view name) {
  if (name == "1-S1") return {.breakdown = 24.1e6, .tortuosity = 1.19};
  if (name == "1-S2") return {.breakdown = 23.7e6};
  if (name == "2-S1")
    return {.breakdown = 22.3e6,
            .tortuosity = 1.63,
            .tip_distance = 0.683,
            .total_length = 1.099,
            .aperture = 10.64e-5};
  if (name == "2-S2") return {.breakdown = 22.1e6};
  if (name == "L1-S1") return {.breakdown = 21.0e6};
  if (name == "N1-S2") return {.joint_microcracks = 109, .connected_microcracks = 57};
  if (name == "N2-S2") return {.joint_microcracks = 168, .connected_microcracks = 117};
  return {};
}

/// Table 2: what the paper's rock tests of its random specimen came to.
struct Rock {
  static constexpr double E = 29.1e9;                ///< Pa
  static constexpr double poisson_ratio = 0.30;      ///< -
  static constexpr double ucs = 22.3e6;              ///< Pa
  static constexpr double tensile_strength = 4.8e6;  ///< Pa
  static constexpr double friction_angle = 37.5;     ///< deg
  static constexpr double cohesion = 5.8e6;          ///< Pa
};

}  // namespace hfdem::support::paper
