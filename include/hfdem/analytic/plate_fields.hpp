/// @file
/// Elastic fields of a plate with a central crack that satisfy the symmetry and the crack y = 0,
/// |x| < a, free of traction, exactly.
///
/// Stress functions of the orthotropic plane: S. G. Lekhnitskii, Theory of Elasticity of an
/// Anisotropic Elastic Body (1963), with z_k = x + mu_k y and mu^4 + 2 rho mu^2 + 1 = 0:
///
///     phi_1' = (-mu_2 F(z_1) + i A(z_1)) / (mu_1 - mu_2),  F = d/dz Q(z) sqrt(z^2 - a^2)
///     phi_2' = ( mu_1 F(z_2) - i A(z_2)) / (mu_1 - mu_2),  A = d/dz Q(z) z
///
/// with Q even and real. F opens the crack by 4 Q sqrt(a^2 - x^2) / E'; A neither opens it nor
/// loads the line y = 0. Units: half-width and Young's modulus 1, Poisson's ratio 0.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

namespace hfdem::analytic::detail {

/// The fields for one crack: one for each power in Q, of either kind.
class CrackFields {
 public:
  /// Powers in Q. With 30, and 40 points on a side, all factors of a square plate are good to 1e-6
  /// up to 2a/W = 0.8 and to 1e-5 up to 0.94 for rho from 0.3 to 2.5; for rho = 6 to 5e-5 and 3e-4.
  static constexpr std::size_t terms = 30;
  /// Stresses and displacements.
  struct Elastic {
    double xx, yy, xy, u, v;
  };

  /// @param rho E / (2 G) - nu
  /// @param height of the plate over its width
  /// @param a half-length of the crack over half the width, 0 < a < 1
  CrackFields(double rho, double height, double a) : a_(a), images_(2 - a) {
    // The fields are differences between the two planes, so the planes must stay apart.
    const Complex r = std::abs(rho - 1) < 1e-9 ? 1 + 1e-9 : rho;
    const Complex sum = std::sqrt((r + 1.0) / 2.0), difference = std::sqrt((r - 1.0) / 2.0);
    mu_1_ = i * (sum + difference);
    mu_2_ = i * (sum - difference);
    largest_ =
        std::fmax(std::norm(zeta(1.0 + mu_1_ * height)), std::norm(zeta(1.0 + mu_2_ * height)));
  }

  /// The fields that open the crack, one for each power in Q, then those that do not.
  std::array<Elastic, 2 * terms> at(double x, double y) const {
    const Complex z_1 = x + mu_1_ * y, z_2 = x + mu_2_ * y;
    const Complex root_1 = root(z_1), root_2 = root(z_2);
    const auto q_1 = powers(z_1), q_2 = powers(z_2);
    std::array<Elastic, 2 * terms> fields;
    for (std::size_t j = 0; j < terms; ++j) {
      const auto [v_1, d_1] = q_1[j];
      const auto [v_2, d_2] = q_2[j];
      fields[j] = opening({d_1 * root_1 + v_1 * z_1 / root_1, d_2 * root_2 + v_2 * z_2 / root_2},
                          {v_1 * root_1, v_2 * root_2});
      fields[terms + j] = closed({v_1 + z_1 * d_1, v_2 + z_2 * d_2}, {z_1 * v_1, z_2 * v_2});
    }
    return fields;
  }

  /// The powers in Q on the line of the crack.
  std::array<double, terms> on_the_crack(double x) const {
    const auto q = powers(x);
    std::array<double, terms> values;
    for (std::size_t j = 0; j < terms; ++j) values[j] = q[j].value.real();
    return values;
  }

 private:
  using Complex = std::complex<double>;
  static constexpr Complex i{0, 1};

  /// The variable of Q is zeta^2, z = 2 c zeta / (1 + zeta^2): it opens the plane cut along
  /// |x| > c = 2 - a, where the images of the crack in the sides lie, so that its powers converge
  /// however short the ligament.
  Complex zeta(Complex z) const {
    const Complex u = z / images_;
    return u / (1.0 + std::sqrt(1.0 - u * u));
  }
  struct Power {
    Complex value, slope;
  };
  std::array<Power, terms> powers(Complex z) const {
    const Complex root = zeta(z), square = root * root;
    const Complex slope = (1.0 + square) * (1.0 + square) / (2 * images_ * (1.0 - square));
    const Complex t = square / largest_, dt = 2.0 * root * slope / largest_;
    std::array<Power, terms> q;
    q[0] = {1, 0};
    for (std::size_t j = 1; j < terms; ++j)
      q[j] = {t * q[j - 1].value, t * q[j - 1].slope + dt * q[j - 1].value};
    return q;
  }
  Complex root(Complex z) const { return std::sqrt(z - a_) * std::sqrt(z + a_); }

  /// A function at z_1 and z_2.
  struct Planes {
    Complex at_1, at_2;
  };
  /// (f(z_1) - f(z_2)) / (mu_1 - mu_2), which has a limit as rho -> 1.
  Complex divided(const Planes& f) const { return (f.at_1 - f.at_2) / (mu_1_ - mu_2_); }

  /// The field of F and its integral.
  Elastic opening(const Planes& F, const Planes& integral) const {
    const Complex d = divided(F), e = divided(integral);
    return {(F.at_2 + mu_1_ * d).real(), (F.at_2 - mu_2_ * d).real(), -d.real(),
            (integral.at_2 + mu_1_ * e).real(),
            (mu_2_ * mu_2_ * e - (mu_1_ + mu_2_) * integral.at_2).real()};
  }
  /// The field of A and its integral.
  Elastic closed(const Planes& A, const Planes& integral) const {
    const Complex d = divided(A), e = divided(integral);
    return {(i * ((mu_1_ + mu_2_) * A.at_2 + mu_1_ * mu_1_ * d)).real(), (i * d).real(),
            -(i * (A.at_2 + mu_1_ * d)).real(),
            (i * ((mu_1_ + mu_2_) * integral.at_2 + mu_1_ * mu_1_ * e)).real(),
            (i * (integral.at_2 - mu_2_ * e)).real()};
  }

  double a_, images_, largest_ = 1;
  Complex mu_1_, mu_2_;
};

}  // namespace hfdem::analytic::detail
