/// @file
/// A straight central crack under uniform net pressure in a rectangular plate, parallel to two of
/// its sides: what a specimen of finite size does to K_I, opening and volume.
///
/// Solved at a few lengths (plate_solver.hpp) and interpolated between them, so that
/// dV/da = 4 K_I^2 / (p E') (G. R. Irwin, J. Appl. Mech. 24 (1957) 361-364) holds in between.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

#include <hfdem/analytic/plate_solver.hpp>
#include <hfdem/base/fields.hpp>

namespace hfdem::analytic {

/// Elasticity in the plane: the same along and across the crack, with a shear modulus of its own. A
/// square array of discs is such a plane; so is every isotropic one, with G = E / (2 (1 + nu)).
struct OrthotropicPlane {
  double E = 0;        ///< Young's modulus along both axes, Pa
  double poisson = 0;  ///< Poisson's ratio between the axes
  double G = 0;        ///< shear modulus, Pa

  static constexpr auto fields() {
    using P = OrthotropicPlane;
    return std::tuple{
        Field{"E", &P::E, "Pa", positive, "Young's modulus along both axes"},
        Field{"poisson", &P::poisson, "", Range{-1, 1, true, true}, "Poisson's ratio"},
        Field{"G", &P::G, "Pa", positive, "shear modulus"}};
  }

  /// 1 if isotropic.
  double rho() const { return E / (2 * G) - poisson; }
  /// Modulus with which a crack along an axis opens, Pa.
  double E_prime() const { return 2 * E / std::sqrt(2 + 2 * rho()); }
};

/// Isotropic rock in plane strain.
/// @param E_prime plane modulus E / (1 - nu^2), Pa
/// @param poisson the rock's Poisson's ratio nu; only fixed sides feel it
/// @throws InvalidParameter unless E' > 0 and 0 <= nu < 0.5
inline OrthotropicPlane isotropic_plane(double E_prime, double poisson = 0.3) {
  hfdem::detail::check_range("rock", "E_prime", "Pa", positive, E_prime);
  hfdem::detail::check_range("rock", "poisson", "", Range{0, 0.5, false, true}, poisson);
  const double in_plane = poisson / (1 - poisson);
  return {E_prime, in_plane, E_prime / (2 * (1 + in_plane))};
}

/// What holds the sides of a plate; none of them carries shear.
enum class PlateSides {
  stress,  ///< constant normal stress
  rigid,   ///< smooth rigid platens under constant mean stress
  fixed    ///< smooth walls that do not move
};

/// Factors of a plate for every length of its crack; solved once, when built.
class CrackedPlate {
 public:
  /// @param width along the crack, m
  /// @param rock with rho from 0.3 to 6
  /// @param sides what holds them
  /// @param height_per_width of the plate, 0.5 to 2
  /// @throws InvalidParameter naming the number that is out of range
  CrackedPlate(double width, const OrthotropicPlane& rock, PlateSides sides,
               double height_per_width = 1)
      : width_(width), E_prime_(rock.E_prime()) {
    hfdem::detail::check_range("plate", "width", "m", positive, width);
    validate(rock, "rock");
    hfdem::detail::check_range("rock", "rho", "", Range{0.3, 6}, rock.rho());
    hfdem::detail::check_range("plate", "height_per_width", "", Range{0.5, 2}, height_per_width);
    if (sides == PlateSides::fixed)
      wall_stiffness_ = std::numbers::pi * rock.E /
                        (2 * (1 - rock.poisson * rock.poisson) * E_prime_ * height_per_width);
    fit(detail::PlateSolver(height_per_width, rock.rho(), sides != PlateSides::stress));
  }

  /// m
  double width() const { return width_; }
  /// Modulus with which the crack opens, Pa.
  double E_prime() const { return E_prime_; }
  /// The longest full length for which the factors are known, m.
  double longest() const { return longest_ratio * width_; }

  /// @param full_length of the crack, m
  /// @throws InvalidParameter if it is not between 0 and `longest()`; so do all that follow
  PlateFactors factors(double full_length) const {
    const Range known{.low = 0, .high = longest(), .open_low = true};
    hfdem::detail::check_range("crack", "full_length", "m", known, full_length);
    const double r = full_length / width_, t = r * r;
    const Terms of = terms(t);
    double volume = 0, slope = 0, width_per_volume = 0;
    for (std::size_t j = 0; j < volume_.size(); ++j) {
      volume += volume_[j] * of.value[j];
      slope += volume_[j] * of.slope[j];
    }
    for (std::size_t j = 0; j < nodes; ++j) width_per_volume += width_per_volume_[j] * of.value[j];
    // Walls that stay press back with a uniform stress, in proportion to the crack's volume.
    const double left = 1 / (1 + wall_stiffness_ * t * volume);
    // dV/da = 4 K_I^2 / (p E') with V = 2 pi p a^2 f_V / E'
    return {left * std::sqrt(volume + t * slope), left * width_per_volume * volume, left * volume};
  }

  /// K_I, Pa sqrt(m), at a net pressure, Pa.
  double stress_intensity(double net_pressure, double full_length) const {
    return net_pressure * factors(full_length).toughness *
           std::sqrt(std::numbers::pi * full_length / 2);
  }
  /// w(0), m, at a net pressure, Pa.
  double opening(double net_pressure, double full_length) const {
    return 2 * net_pressure * full_length * factors(full_length).width / E_prime_;
  }
  /// Of the open crack, m2, at a net pressure, Pa.
  double volume(double net_pressure, double full_length) const {
    return std::numbers::pi / 2 * net_pressure * full_length * full_length *
           factors(full_length).volume / E_prime_;
  }
  /// Net pressure at which K_I = K_IC, Pa.
  double pressure_at(double K_IC, double full_length) const {
    hfdem::detail::check_range("rock", "K_IC", "Pa sqrt(m)", positive, K_IC);
    return K_IC / stress_intensity(1, full_length);
  }

 private:
  static constexpr double longest_ratio = 0.94;
  static constexpr std::size_t nodes = 16;  ///< keep the factors to 1e-6 of the solved ones

  /// Chebyshev polynomials of t = (2a/W)^2 and their derivatives.
  struct Terms {
    std::array<double, 2 * nodes> value, slope;
  };
  static Terms terms(double t) {
    constexpr double scale = 2 / (longest_ratio * longest_ratio);
    const double s = scale * t - 1;
    Terms of;
    of.value[0] = 1, of.slope[0] = 0;
    of.value[1] = s, of.slope[1] = scale;
    for (std::size_t j = 2; j < 2 * nodes; ++j) {
      of.value[j] = 2 * s * of.value[j - 1] - of.value[j - 2];
      of.slope[j] = 2 * s * of.slope[j - 1] + 2 * scale * of.value[j - 1] - of.slope[j - 2];
    }
    return of;
  }

  /// f_V takes the solved f_V and F_K^2 = d(t f_V)/dt at every node, f_w / f_V the solved one.
  void fit(const detail::PlateSolver& plate) {
    std::vector<std::vector<double>> for_volume, for_width;
    for (std::size_t n = 0; n < nodes; ++n) {
      const double r = longest_ratio *
                       std::sin((static_cast<double>(n) + 0.5) * std::numbers::pi / (2.0 * nodes));
      const PlateFactors f = plate.solve(r);
      const Terms of = terms(r * r);
      std::vector<double> energy(of.value.begin(), of.value.end()), value = energy;
      for (std::size_t j = 0; j < 2 * nodes; ++j) energy[j] += r * r * of.slope[j];
      for_width.emplace_back(value.begin(), value.begin() + nodes).push_back(f.width / f.volume);
      value.push_back(f.volume);
      energy.push_back(f.toughness * f.toughness);
      for_volume.push_back(std::move(value));
      for_volume.push_back(std::move(energy));
    }
    volume_ = detail::solve_linear(std::move(for_volume));
    width_per_volume_ = detail::solve_linear(std::move(for_width));
  }

  double width_, E_prime_;
  double wall_stiffness_ = 0;  ///< against the mean strain by which the crack swells the plate
  std::vector<double> volume_, width_per_volume_;
};

}  // namespace hfdem::analytic
