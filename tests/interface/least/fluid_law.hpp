/// @file
/// The least fluid that flows; docs/concepts/fluid_law.md explains it.
#pragma once

#include <cmath>
#include <tuple>

#include <hfdem/state/concepts.hpp>

namespace models {

using namespace hfdem;

/// Flows as between parallel plates; its density grows exponentially with pressure.
struct DenserFluid {
  struct Params {
    double viscosity = 1e-3, stiffness = 2e9;
    static constexpr auto fields() {
      using P = Params;
      return std::tuple{Field{"viscosity", &P::viscosity, "Pa s", positive, "dynamic viscosity"},
                        Field{"stiffness", &P::stiffness, "Pa", positive,
                              "rise of pressure per rise of density"}};
    }
  };

  explicit DenserFluid(const Params& params) : p(params) {}

  double conductance(double width, double length, double /*drop*/,
                     double /*pressure*/) const noexcept {
    return width * width * width / (12 * p.viscosity * length);
  }
  double filling(double pressure) const noexcept { return std::exp(pressure / p.stiffness); }
  double pressure(double filling) const noexcept { return p.stiffness * std::log(filling); }
  double modulus(double pressure) const noexcept { return p.stiffness / filling(pressure); }

  Params p;
};

}  // namespace models
