/// @file
/// The least aperture law that a crack can open by; docs/concepts/aperture_law.md explains it.
#pragma once

#include <cmath>
#include <tuple>

#include <hfdem/state/concepts.hpp>

namespace models {

using namespace hfdem;

/// A channel that no force closes any further.
struct RoughWalls {
  struct Params {
    double w0 = 6e-6;
    static constexpr auto fields() {
      return std::tuple{Field{"w0", &Params::w0, "m", positive, "aperture of a closed channel"}};
    }
  };

  explicit RoughWalls(const Params& params) : p(params) {}

  double rest_width() const noexcept { return p.w0; }
  double width(double w0, double /*compression*/, double gap) const noexcept {
    return w0 + std::fmax(0, gap);
  }

  Params p;
};

}  // namespace models
