/// @file
/// Parallel bonds of unequal strength: tensile strength and cohesion of each bond times a random
/// factor of mean 1.
///
/// The factor has the distribution of W. Weibull, "A statistical distribution function of wide
/// applicability", J. Appl. Mech. 18 (1951) 293-297: P(factor < f) = 1 - exp(-(f Gamma(1 +
/// 1/m))^m). Stiffness and the angles of friction are those of all bonds. A bond's factor depends
/// on the seed and on its number alone, so it is the same for any number of threads.
#pragma once

#include <cmath>
#include <optional>
#include <tuple>

#include <hfdem/base/random.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>

namespace hfdem {

/// A `ContactLaw`; without a modulus every result is that of `LinearParallelBond`, bit for bit.
class ScatteredParallelBond : public LinearParallelBond {
 public:
  /// Those of `LinearParallelBond`, and how the strengths scatter.
  struct Params : LinearParallelBond::Params {
    std::optional<double> weibull_modulus{};
    int strength_seed = 1;

    static constexpr auto fields() {
      using P = Params;
      return std::tuple_cat(
          LinearParallelBond::Params::fields(),
          std::tuple{Field{"weibull_modulus", &P::weibull_modulus, "", Range{1, 1000},
                           "of the random factor of each bond's strength; unset: all are alike"},
                     Field{"strength_seed", &P::strength_seed, "", Range{0},
                           "of the random numbers that these factors are made from"}});
    }
  };

  /// What is fixed per contact.
  template <class T>
  struct Stiffness : LinearParallelBond::Stiffness<T> {
    T weakness;  ///< 1 / factor
  };

  /// @param p validated parameters
  explicit ScatteredParallelBond(const Params& p) : LinearParallelBond(p), scatter_(p) {}

  /// Of a new contact of mean strength.
  Stiffness<double> stiffness(Disc a, Disc b) const noexcept {
    return {LinearParallelBond::stiffness(a, b), 1};
  }

  /// Of the contact with this number: its strength drawn.
  Stiffness<double> varied(const Stiffness<double>& k, Index contact) const noexcept {
    return {k, 1 / strength_factor(contact)};
  }

  /// What is left of a contact whose bond has broken.
  Stiffness<double> broken(const Stiffness<double>& k) const noexcept {
    return {LinearParallelBond::broken(k), k.weakness};
  }

  /// By how much a bond is stronger than the mean.
  double strength_factor(Index contact) const noexcept {
    if (!scatter_.weibull_modulus) return 1;
    const double exponent = 1 / *scatter_.weibull_modulus;
    // Not the numbers that a packing of the same seed is made from.
    Random random(~static_cast<std::uint64_t>(scatter_.strength_seed));
    random.skip(contact);
    const double chance = random.fraction() + 0x1p-54;  // never 0
    return std::pow(-std::log(chance), exponent) / std::tgamma(1 + exponent);
  }

  /// Both criteria are of the first degree in forces and strengths: a bond that is twice as strong
  /// fails when one of mean strength would under half the forces.
  template <class T>
  Failure<T> failure(const Stiffness<T>& k, const Response<T>& r) const noexcept {
    return LinearParallelBond::failure(k, as_of_mean(k, r));
  }

  /// And it may move twice as far.
  template <class T>
  T margin(const Stiffness<T>& k, const Response<T>& r) const noexcept {
    return LinearParallelBond::margin(k, as_of_mean(k, r)) / k.weakness;
  }

 private:
  /// What brings a bond of mean strength as near to failing.
  template <class T>
  static Response<T> as_of_mean(const Stiffness<T>& k, const Response<T>& r) noexcept {
    Response<T> scaled = r;
    scaled.bond_normal = r.bond_normal * k.weakness;
    scaled.bond_shear = r.bond_shear * k.weakness;
    scaled.bond_moment = r.bond_moment * k.weakness;
    return scaled;
  }

  Params scatter_;
};

}  // namespace hfdem
