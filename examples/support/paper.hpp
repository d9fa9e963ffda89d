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

}  // namespace hfdem::support::paper
