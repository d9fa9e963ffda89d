/// @file
/// A fluid of constant viscosity and constant compressibility.
///
/// Source: the paper's Eq. 5, Poiseuille flow between parallel walls (the cubic law), and its
/// Eq. 4 in terms of what a domain stores:
///   q = w^3 / (12 mu) dP / l_p            m2/s per m of thickness
///   P = K_f (S / V - 1)                   S: stored, as a volume at zero pressure; V: its room
#pragma once

#include <tuple>

#include <hfdem/base/fields.hpp>

namespace hfdem {

/// A `FluidLaw`.
class NewtonianFluid {
 public:
  /// Defaults: supercritical carbon dioxide, the paper's Table 2. The uniform-pressure algorithm is
  /// the limit of no viscosity and no compressibility; it uses neither.
  struct Params {
    double viscosity = 6e-5;
    double bulk_modulus = 2e9;

    static constexpr auto fields() {
      using P = Params;
      return std::tuple{
          Field{"viscosity", &P::viscosity, "Pa s", positive, "dynamic viscosity"},
          Field{"bulk_modulus", &P::bulk_modulus, "Pa", positive, "bulk modulus of the fluid"}};
    }
  };

  /// @param p validated parameters
  explicit NewtonianFluid(const Params& p)
      : twelve_viscosity_(12 * p.viscosity), modulus_(p.bulk_modulus) {}

  /// Flow through a channel per pressure drop between its ends, m2/(s Pa).
  /// @param width hydraulic aperture, m
  /// @param length of the channel, m
  double conductance(double width, double length, double /*drop*/,
                     double /*pressure*/) const noexcept {
    return width * width * width / (twelve_viscosity_ * length);
  }

  /// What a room holds at a pressure, over what it holds at zero pressure.
  double filling(double pressure) const noexcept { return 1 + pressure / modulus_; }
  /// The pressure at which a room is filled so, Pa: the inverse of `filling`.
  double pressure(double filling) const noexcept { return modulus_ * (filling - 1); }
  /// Pressure per filling at a pressure, Pa.
  double modulus(double /*pressure*/) const noexcept { return modulus_; }

 private:
  double twelve_viscosity_, modulus_;
};

}  // namespace hfdem
