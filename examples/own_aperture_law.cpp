// An aperture law of your own: pressing closes a channel exponentially, to a residual width (after
// Rutqvist et al. 2002, Int. J. Rock Mech. Min. Sci. 39, 429-442). A short crack is pressed open.
//
//   build/release/examples/own_aperture_law
//
// You should see the two laws differ while the crack is closed (w < 6 um), and agree once it opens:
//    0 MPa   hyperbolic 3.10 um   exponential 2.96 um
//   12 MPa   hyperbolic 8.39 um   exponential 8.39 um
#include <cmath>
#include <cstdio>

#include <hfdem/hfdem.hpp>

using namespace hfdem;

struct ExponentialAperture {
  struct Params {
    double w0 = 6e-6, residual = 1e-6, F0 = 1e5;
    static constexpr auto fields() {
      using P = Params;
      return std::tuple{Field{"w0", &P::w0, "m", positive, "aperture at zero force"},
                        Field{"residual", &P::residual, "m", non_negative, "aperture at any force"},
                        Field{"F0", &P::F0, "N/m", positive, "force that leaves 1/e of the rest"}};
    }
  };

  explicit ExponentialAperture(const Params& params) : p(params) {}
  double rest_width() const noexcept { return p.w0; }
  double width(double w0, double compression, double gap) const noexcept {
    if (compression <= 0) return w0 + std::fmax(0, gap);
    return p.residual + (w0 - p.residual) * std::exp(-compression / p.F0);
  }

  Params p;
};

template <class Aperture>
double width_at(double pressure) {
  Simulator<LinearParallelBond, Aperture, HeldPressure, FixedPairs> sim{
      square_array(40, 40, 5_mm), {.scheme = {.pressure = pressure}}};
  sim.step();
  return measure::crack_shape(sim).aperture / 1_um;
}

int main() {
  for (const double p : {0_MPa, 4_MPa, 8_MPa, 12_MPa})
    std::printf("%2.0f MPa   hyperbolic %.2f um   exponential %.2f um\n", p / 1_MPa,
                width_at<HyperbolicAperture>(p), width_at<ExponentialAperture>(p));
}
