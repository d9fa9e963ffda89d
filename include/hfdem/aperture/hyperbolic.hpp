/// @file
/// Aperture of a flow channel from its contact's force and gap.
///
/// Source: the paper's Eqs. 6 and 7 (Hazzard et al. 2002, Al-Busaidi et al. 2005 for the form):
///   compressed   w = w0 F0 / (F + F0)      at F0 the aperture is half of w0
///   open         w = w0 + gap
#pragma once

#include <tuple>

#include <hfdem/base/fields.hpp>

namespace hfdem {

/// An `ApertureLaw`.
class HyperbolicAperture {
 public:
  /// The two constants of the law.
  struct Params {
    double w0 = 6e-6;
    double F0 = 1e5;

    static constexpr auto fields() {
      return std::tuple{Field{"w0", &Params::w0, "m", positive, "residual aperture of the rock"},
                        Field{"F0", &Params::F0, "N/m", positive,
                              "normal force that halves the residual aperture"}};
    }
  };

  /// @param p validated parameters
  explicit HyperbolicAperture(const Params& p) : w0_(p.w0), F0_(p.F0) {}

  /// The aperture of rock at zero force, m: what a new channel starts from.
  double rest_width() const noexcept { return w0_; }

  /// The hydraulic aperture, m.
  /// @param w0 the channel's own aperture at zero force, m
  /// @param compression total compressive force of the contact, N per m (0 when open)
  /// @param gap opening since bonding, m
  double width(double w0, double compression, double gap) const noexcept {
    return compression > 0 ? w0 * F0_ / (compression + F0_) : w0 + (gap > 0 ? gap : 0);
  }

 private:
  double w0_, F0_;
};

}  // namespace hfdem
