// A straight crack under uniform pressure: energy, equilibrium and the singularity at its tip.
#include <hfdem/analytic/kgd.hpp>
#include <hfdem/analytic/pressurised_crack.hpp>

#include "near.hpp"

using namespace hfdem::analytic;
using test::near;

namespace {

constexpr double pi = std::numbers::pi;
constexpr PressurisedCrack crack{.E_prime = 35.1e9, .half_length = 0.2, .net_pressure = 3e6};

}  // namespace

TEST_CASE("the crack is an ellipse whose area is its volume") {
  CHECK(crack.width() == near(4 * 3e6 * 0.2 / 35.1e9));
  CHECK(crack.width_at(0) == crack.width());
  CHECK(crack.width_at(-0.12) == near(0.8 * crack.width()));
  CHECK(crack.width_at(0.21) == 0);
  double area = 0;
  constexpr int cells = 4000;
  for (int k = 0; k < cells; ++k) {
    const double angle = pi * (k + 0.5) / cells;
    area += crack.width_at(0.2 * std::cos(angle)) * 0.2 * std::sin(angle) * pi / cells;
  }
  CHECK(area == near(crack.volume(), 1e-6));
}

TEST_CASE("growth releases K_I^2 / E' at each tip") {
  // Energy at constant pressure: p V / 2, with V growing by dV for a growth da of both tips.
  const double da = 1e-6;
  PressurisedCrack longer = crack;
  longer.half_length += da;
  const double released = crack.net_pressure * (longer.volume() - crack.volume()) / 2;
  const double K = crack.stress_intensity();
  CHECK(released == near(2 * da * K * K / crack.E_prime, 1e-5));
  CHECK(K == near(3e6 * std::sqrt(pi * 0.2)));
}

TEST_CASE("the stress on the crack's line is singular as K_I says, and carries the crack's load") {
  const double s = 1e-8;
  CHECK(crack.stress_at(0.2 + s) == near(crack.stress_intensity() / std::sqrt(2 * pi * s), 1e-3));
  CHECK(crack.stress_at(0.25) == near(3e6 * (0.25 / 0.15 - 1)));
  CHECK(crack.stress_at(-0.25) == crack.stress_at(0.25));
  CHECK(crack.stress_at(0.1) == -3e6);
  // Far away p a^2 / (2 x^2) is left.
  CHECK(crack.stress_at(200) == near(3e6 * 0.2 * 0.2 / (2 * 200.0 * 200), 1e-5));
  double ahead = 0, from = 0;
  for (int k = 1; k <= 200000; ++k) {  // x = a + y^2: the singularity gone
    const double to = 40 * k / 200000.0, y = (from + to) / 2;
    ahead += crack.stress_at(0.2 + y * y) * 2 * y * (to - from);
    from = to;
  }
  CHECK(ahead == near(3e6 * 0.2, 1e-3));  // the load on one half of the crack
}

TEST_CASE("a crack starts to grow at the pressure that brings K_I to the toughness") {
  CHECK(growth_pressure(1.88e6, 0.016) == near(8.3854e6, 1e-5));
  CHECK(growth_pressure(2.66e6, 0.016) == near(11.8644e6, 1e-5));
  PressurisedCrack preset{35.1e9, 0.016, growth_pressure(1.88e6, 0.016)};
  CHECK(preset.stress_intensity() == near(1.88e6));
  CHECK(preset.width() == near(15.3e-6, 2e-3));
  CHECK(preset.volume() == near(3.84e-7, 2e-3));
}

TEST_CASE("at K_I = K_IC it is the storage-toughness fracture of its volume") {
  PressurisedCrack grown{35.1e9, 0.3, growth_pressure(1.88e6, 0.3)};
  const auto kgd = toughness_vertex(35.1e9, 1.88e6, grown.volume(), 1);
  CHECK(kgd.half_length == near(0.3));
  CHECK(kgd.width == near(grown.width()));
  CHECK(kgd.net_pressure == near(grown.net_pressure));
}
