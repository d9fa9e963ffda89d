/// @file
/// The injected fluid, and where and how fast it is injected.
#pragma once

#include <optional>
#include <tuple>

#include <hfdem/base/fields.hpp>

namespace hfdem {

/// Defaults: supercritical carbon dioxide, the paper's Table 2. The uniform-pressure algorithm is
/// the limit of no viscosity and no compressibility; it uses neither.
struct Fluid {
  double viscosity = 6e-5;
  double bulk_modulus = 2e9;

  static constexpr auto fields() {
    return std::tuple{
        Field{"viscosity", &Fluid::viscosity, "Pa s", positive, "dynamic viscosity"},
        Field{"bulk_modulus", &Fluid::bulk_modulus, "Pa", positive, "bulk modulus of the fluid"}};
  }
};

/// Where the fluid goes in, and how fast.
struct Injection {
  double rate = 0.5e-4;
  std::optional<Vec2> position{};  ///< the middle of the specimen if not given

  static constexpr auto fields() {
    using P = Injection;
    return std::tuple{
        Field{"rate", &P::rate, "m2/s", positive, "injection rate per m of thickness"},
        Field{"position", &P::position, "m", any_number,
              "where; the flow domain with the nearest centre receives the fluid"}};
  }
};

}  // namespace hfdem
