// The fit of slit tests, on readings made up from a known lattice.
#include <cmath>
#include <numbers>
#include <string>

#include <hfdem/analytic/kgd.hpp>
#include <hfdem/analytic/plate.hpp>
#include <hfdem/analytic/stepwise_growth.hpp>
#include <hfdem/measure/toughness.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

using namespace hfdem;
using std::numbers::pi;

namespace {

const analytic::LatticeFracture lattice{.E = 34e9,
                                        .poisson_ratio = 0,
                                        .shear_modulus = 6.8e9,
                                        .E_prime = 25e9,
                                        .K_IC = 1.5e6,
                                        .K_IC_per_pressure = 0.06,
                                        .opening_offset = 5e-6,
                                        .volume_offset = 4e-6,
                                        .overhang = 1e-3};
const analytic::CrackedPlate plate{1, {34e9, 0, 6.8e9}, analytic::PlateSides::rigid};

using test::near;

/// w - w0 = 4 a p f_w / E' - w_off
double opening(double a, double p) {
  return 4 * a * p * plate.factors(2 * a).width / lattice.E_prime - lattice.opening_offset;
}
/// V = 2 pi (a + b)^2 p f_V / E' - 2 a v_off
double volume(double a, double p) {
  return 2 * pi * std::pow(a + lattice.overhang, 2) * p * plate.factors(2 * a).volume /
             lattice.E_prime -
         2 * a * lattice.volume_offset;
}
/// p F_K sqrt(pi a) = K_IC + K_IC' p
double net_pressure_at_break(double a) {
  return lattice.K_IC / (plate.factors(2 * a).toughness * std::sqrt(pi * a) - 0.06);
}

}  // namespace

TEST_CASE("slits made up from a lattice give that lattice back") {
  std::vector<measure::SlitTest> slits;
  for (const double a : {0.05, 0.1, 0.15, 0.2}) {
    const double p = net_pressure_at_break(a);
    measure::SlitTest slit{.half_length = a, .net_pressure_at_break = p};
    slit.opening = measure::Line::through({{0.8 * p, opening(a, 0.8 * p)}, {p, opening(a, p)}});
    slit.volume = measure::Line::through({{0.8 * p, volume(a, 0.8 * p)}, {p, volume(a, p)}});
    slits.push_back(slit);
  }
  const auto test = measure::toughness_test(slits, plate, {.E = 34e9, .shear_modulus = 6.8e9});
  CHECK(test.rock.E == 34e9);
  CHECK(test.rock.E_prime == near(lattice.E_prime));
  CHECK(test.E_prime_from_volume == near(lattice.E_prime));
  CHECK(test.rock.K_IC == near(lattice.K_IC));
  CHECK(test.rock.K_IC_per_pressure == near(lattice.K_IC_per_pressure));
  CHECK(test.rock.opening_offset == near(lattice.opening_offset));
  CHECK(test.rock.volume_offset == near(lattice.volume_offset));
  CHECK(test.rock.overhang == near(lattice.overhang));
  for (const auto& reading : test.readings)
    CHECK(reading.K_IC == near(lattice.toughness(reading.slit.net_pressure_at_break)));
}

TEST_CASE("a straight line through points is that of least squares") {
  const auto line = measure::Line::through({{0, 1}, {1, 3}, {2, 2}});
  CHECK(line.slope == near(0.5));
  CHECK(line.intercept == near(1.5));
}

TEST_CASE("slits are spread evenly and even in number of contacts, or refused") {
  CHECK(measure::SlitSeries{}.contacts() == std::vector{10, 20, 30, 40});
  CHECK(measure::SlitSeries{.shortest = 7, .longest = 13, .count = 3}.contacts() ==
        std::vector{8, 10, 12});
  CHECK_THROWS_WITH_AS((measure::SlitSeries{.shortest = 8, .longest = 10, .count = 3}.contacts()),
                       doctest::Contains("slits.count = 3"), InvalidParameter);
}

TEST_CASE("a crack grows by one contact at each tip, at the volume that breaks it") {
  const double facet = 0.01, one = 1e-9;
  const analytic::StepwiseGrowth growth(plate, lattice, facet, 4);
  const auto breaks = growth.breaks();
  REQUIRE(breaks.size() > 40);
  for (std::size_t k = 0; k < 35; ++k) {
    const double a = (2 + static_cast<double>(k)) * facet;
    const double p = net_pressure_at_break(a);
    CHECK(breaks[k].contacts == 4 + 2 * static_cast<int>(k));
    CHECK(breaks[k].full_length == near(2 * a));
    CHECK(breaks[k].net_pressure == near(p));
    CHECK(breaks[k].volume == near(volume(a, p)));
    const auto before = growth.at((1 - one) * breaks[k].volume);
    REQUIRE(before);
    CHECK(before->full_length == near(2 * a));
    CHECK(before->net_pressure == near(p, 1e-7));
    CHECK(before->opening == near(opening(a, p), 1e-7));
    const auto after = growth.at((1 + one) * breaks[k].volume);
    REQUIRE(after);
    CHECK(after->full_length == near(2 * a + 2 * facet));
    CHECK(volume(a + facet, after->net_pressure) == near(breaks[k].volume, 1e-7));
  }
}

TEST_CASE("longer cracks that break at less volume are run through, and split the plate at last") {
  const analytic::StepwiseGrowth growth(plate, lattice, 0.01, 4);
  double volume = 0;
  for (const auto& b : growth.breaks()) {
    CHECK(b.volume >= volume);
    volume = b.volume;
  }
  CHECK(growth.breaks().back().full_length > plate.longest() - 2 * 0.01 - 1e-9);
  CHECK(growth.at(0.999 * volume));
  CHECK(!growth.at(1.001 * volume));
}

TEST_CASE("a crack in an infinite plane of such rock obeys both its equations") {
  for (const double volume : {1e-6, 1e-5, 1e-4}) {
    const auto crack = analytic::crack_in_plane(lattice, volume);
    REQUIRE(crack);
    const double a = crack->full_length / 2, p = crack->net_pressure;
    CHECK(p * std::sqrt(pi * a) == near(lattice.toughness(p)));
    CHECK(2 * pi * p * a * a / lattice.E_prime == near(volume));
    CHECK(crack->opening == near(4 * a * p / lattice.E_prime));
  }
  // With a constant toughness it is the storage-toughness vertex.
  analytic::LatticeFracture constant = lattice;
  constant.K_IC_per_pressure = 0;
  const auto crack = analytic::crack_in_plane(constant, 4.5e-5);
  const auto kgd = analytic::toughness_vertex(25e9, 1.5e6, 0.5e-4, 0.9);
  REQUIRE(crack);
  CHECK(crack->full_length == near(kgd.full_length()));
  CHECK(crack->opening == near(kgd.width));
  CHECK(crack->net_pressure == near(kgd.net_pressure));
}

TEST_CASE("a volume too small for steady growth drives no crack through the plane") {
  // At sqrt(pi a) = 4/3 of 0.06: p = 3 K_IC / 0.06, V = 2 pi p a^2 / E'.
  const double root = 0.08, a = root * root / pi, p = 3 * 1.5e6 / 0.06;
  const double least = 2 * pi * p * a * a / lattice.E_prime;
  CHECK(!analytic::crack_in_plane(lattice, 0.999 * least));
  REQUIRE(analytic::crack_in_plane(lattice, 1.001 * least));
  CHECK(analytic::crack_in_plane(lattice, 1.001 * least)->full_length > 2 * a);
}

TEST_CASE("a staircase that no pressure climbs is refused") {
  const auto refusal = [](double per_pressure, int contacts) {
    analytic::LatticeFracture rock = lattice;
    rock.K_IC_per_pressure = per_pressure;
    try {
      analytic::StepwiseGrowth(plate, rock, 0.01, contacts);
    } catch (const InvalidParameter& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  CHECK(refusal(0.06, 4) == "");
  CHECK(refusal(-0.5, 4) == "");
  CHECK(refusal(1, 4).find("toughness.K_IC_per_pressure = 1 sqrt(m)") == 0);
  CHECK(refusal(0.06, 0).find("crack.contacts = 0") == 0);
  CHECK(refusal(0.06, 95).find("crack.contacts = 95") == 0);
}
