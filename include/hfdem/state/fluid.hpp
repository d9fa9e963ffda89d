/// @file
/// Where and how fast the fluid is injected.
#pragma once

#include <optional>
#include <tuple>

#include <hfdem/base/fields.hpp>

namespace hfdem {

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
