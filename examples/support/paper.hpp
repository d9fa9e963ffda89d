/// @file
/// Numbers printed in the paper, to stand beside ours.
#pragma once

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

/// Section 4.1: carbon dioxide in intact rock, cases 2-S1 and 2-S2, one random specimen each.
struct Intact {
  static constexpr double E_prime = 39.17e9;  ///< Pa: what its KGD values follow from
  static constexpr double K_IC = 2.66e6;      ///< Pa sqrt(m): fitted there to case 2-S1
  static constexpr double breakdown_S1 = 22.3e6, breakdown_S2 = 22.1e6;  ///< Pa

  /// Case 2-S1 at t = 1.5 s, Figs. 7 and 12.
  static constexpr double time = 1.5;            ///< s
  static constexpr double tip_distance = 0.683;  ///< m
  static constexpr double total_length = 1.099;  ///< of all microcracks, m
  static constexpr double tortuosity = 1.63;
  static constexpr double aperture = 10.64e-5;      ///< at the injection, m
  static constexpr double kgd_full_length = 0.919;  ///< m, as printed
  static constexpr double kgd_aperture = 10.40e-5;  ///< m, as printed
};

/// Section 4.2, Table 5: carbon dioxide in fractured rock, case N2-S2, one random specimen with 18
/// fractures that are drawn, not listed.
struct Fractured {
  static constexpr int joint_microcracks = 168;
  static constexpr int connected_joint_microcracks = 117;
};

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
