// The fluid as a spring between discs: the bound on the mechanical step against eigenvalues.
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <hfdem/assembly.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/pressure/conventional.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/setup/flow_domains.hpp>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "loops/assembly.hpp"
#include "near.hpp"
#include "schemes/small_array.hpp"

namespace {

using hfdem::Index;
using test::near;
using Law = hfdem::LinearParallelBond;
using Conventional = hfdem::ConventionalFlow<>;

/// One number for x, y and rotation of each disc.
using Row = std::vector<double>;

/// A specimen cracked from side to side, but for the rim, with fluid in the crack.
class Cracked {
 public:
  Cracked(const hfdem::Specimen& specimen, double bulk_modulus)
      : assembly_(specimen, hfdem::bonded_contacts<hfdem::FixedPairs>(specimen), Law({}), {}, 0, 1),
        network_(crack(hfdem::flow_domains(specimen, assembly_.geometry()))),
        scheme_({}, hfdem::NewtonianFluid({.bulk_modulus = bulk_modulus}), {1, 1}),
        modulus_(bulk_modulus) {
    scheme_.advance(network_, {0, 0, 1e-9}, [] { return hfdem::Relaxed{0, 0}; });
    assembly_.carry([&](auto&& add) { scheme_.for_each_spring(add); });
  }

  /// The bound on the largest frequency from which the mechanical step follows, undamped.
  double bound() const {
    constexpr double margin = 0.95;
    return margin * 2 / assembly_.dt();
  }

  /// By powers of stiffness over mass, whose fastest mode is real.
  double largest_frequency() const {
    const std::vector<Row> matrix = stiffness_over_mass();
    Row x(matrix.size());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::sin(1 + 7.3 * static_cast<double>(i));
    double square = 0;
    for (int n = 0; n < 1000; ++n) {
      Row y(x.size(), 0);
      double xy = 0, xx = 0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t j = 0; j < x.size(); ++j) y[i] += matrix[i][j] * x[j];
        xy += x[i] * y[i], xx += x[i] * x[i];
      }
      square = xy / xx;
      for (std::size_t i = 0; i < x.size(); ++i) x[i] = y[i] / square;
    }
    return std::sqrt(square);
  }

 private:
  hfdem::Network crack(const hfdem::FlowDomains& domains) const {
    const hfdem::Specimen& s = assembly_.specimen();
    const auto above = [&](Index disc) { return s.centre[disc].y > s.height / 2; };
    std::vector<Index> broken;
    for (Index c = 0; c < domains.channels.size(); ++c) {
      const auto [first, second] = assembly_.geometry()[c].bodies;
      const auto [left, right] = domains.channels[c].domain;
      if (above(first) != above(second) && left != hfdem::nothing && right != hfdem::nothing)
        broken.push_back(c);
    }
    REQUIRE(broken.size() > 1);
    constexpr double width = 2e-5;
    hfdem::Network network(domains, {domains.channels[broken.front()].domain[0]}, width);
    for (const Index c : broken) network.open(c);
    REQUIRE(network.wet_channels().size() == broken.size());
    return network;
  }

  /// From the definitions: springs between discs, and what pressure does when they move.
  std::vector<Row> stiffness_over_mass() const {
    const hfdem::Discs& discs = assembly_.discs();
    const std::size_t n = 3 * discs.size();
    std::vector<Row> matrix(n, Row(n, 0));
    const auto mass = [&](std::size_t k) {
      return k % 3 == 2 ? discs.inertia(k / 3) : discs.mass[k / 3];
    };
    const auto add = [&](double k, const Row& force, const Row& motion) {
      for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < n; ++b)
          matrix[a][b] += k * force[a] * motion[b] / std::sqrt(mass(a) * mass(b));
    };
    for (std::size_t c = 0; c < assembly_.contacts().size(); ++c) {
      const auto& [bodies, f] = assembly_.geometry()[c];
      const auto springs = assembly_.contacts().law().springs(assembly_.contacts().stiffness(c));
      Row opening(n, 0), shear(n, 0), rotation(n, 0);
      for (const auto& [disc, sign] : {std::pair{bodies.first, -1.0}, {bodies.second, 1.0}}) {
        opening[3 * disc] = sign * f.normal_x, opening[3 * disc + 1] = sign * f.normal_y;
        shear[3 * disc] = -sign * f.normal_y, shear[3 * disc + 1] = sign * f.normal_x;
        shear[3 * disc + 2] = -(f.arm_mean + sign * f.arm_half_difference);
        rotation[3 * disc + 2] = sign;
      }
      add(springs.normal, opening, opening);
      add(springs.shear, shear, shear);
      add(springs.moment, rotation, rotation);
    }
    const hfdem::FlowDomains& domains = network_.geometry();
    for (const Index d : network_.wet_domains()) {
      Row push(n, 0), widening(n, 0);  // force per pressure, volume per motion
      for (Index i = 0; i < discs.size(); ++i)
        for (Index k = domains.corners_begin[i]; k < domains.corners_begin[i + 1]; ++k) {
          const auto& [domain, chord] = domains.corners[k];
          if (domain == d) push[3 * i] += chord.x, push[3 * i + 1] += chord.y;
        }
      for (const Index c : network_.channels_of(d)) {
        if (!network_.is_wet(c)) continue;
        const auto& [bodies, f] = assembly_.geometry()[c];
        const double half = domains.channels[c].length / 2;
        for (const auto& [disc, sign] : {std::pair{bodies.first, -1.0}, {bodies.second, 1.0}}) {
          widening[3 * disc] += sign * half * f.normal_x;
          widening[3 * disc + 1] += sign * half * f.normal_y;
        }
      }
      add(modulus_ / network_.domain_volume(d), push, widening);
    }
    return matrix;
  }

  hfdem::Assembly<Law> assembly_;
  hfdem::Network network_;
  Conventional scheme_;
  double modulus_;
};

}  // namespace

TEST_CASE("the frequency bound of an array with fluid is above the largest frequency, and close") {
  for (const int size : {4, 6})
    for (const double bulk_modulus : {2e8, 2e9, 2e11}) {
      CAPTURE(bulk_modulus);
      const Cracked array(hfdem::square_array(size, size, test::radius), bulk_modulus);
      const double exact = array.largest_frequency();
      CHECK(array.bound() >= exact);
      CHECK(array.bound() < (bulk_modulus > 1e9 ? 1.05 : 1.25) * exact);
    }
}

TEST_CASE("the frequency bound of irregular discs with fluid is above the largest frequency") {
  for (const std::uint64_t seed : {3U, 4U, 6U, 7U})
    for (const double bulk_modulus : {2e8, 2e9, 2e11}) {
      CAPTURE(seed);
      CAPTURE(bulk_modulus);
      test::Random random(seed);
      const Cracked rock(test::jittered_discs(6, 6, random), bulk_modulus);
      const double exact = rock.largest_frequency();
      CHECK(rock.bound() >= exact);
      CHECK(rock.bound() < 2 * exact);
    }
}

TEST_CASE("the mechanical step shortens with the fluid's stiffness, and grows as the crack opens") {
  // A single crack of width w in rock that hardly matters: 4 R K_f / w on either side of a disc.
  const double bulk_modulus = 2e13, width = 2e-5, pitch = 2 * test::radius;
  const hfdem::Specimen s = hfdem::square_array(6, 6, test::radius);
  const Cracked array(s, bulk_modulus);
  const double mass = s.density * std::acos(-1.0) * test::radius * test::radius;
  const double stiffness = 2 * pitch * bulk_modulus / width;
  CHECK(array.bound() == near(std::sqrt(stiffness / mass), 1e-3));
}

TEST_CASE("pressures of a stiff fluid in a small crack stay bounded, and the step gets longer") {
  using Sim = test::SquareRock<Conventional>;
  Sim sim(test::square(10), {.contact = {.tensile_strength = 1e12, .cohesion = 1e12},
                             .injection = {.rate = 1e-4},
                             .fluid = {.viscosity = 1e-3}});
  const double without_fluid = sim.mechanical_dt();
  double shortest = without_fluid;
  for (int n = 0; n < 1500; ++n) {
    sim.step();
    shortest = std::fmin(shortest, sim.mechanical_dt());
    REQUIRE(sim.injection_pressure() < 40e6);  // water hammer
    if (n < 500) continue;
    REQUIRE(sim.injection_pressure() > 10e6);  // what holds the crack shut
    REQUIRE(sim.injection_pressure() < 20e6);
  }
  CHECK(shortest < 0.2 * without_fluid);
  CHECK(sim.mechanical_dt() > 1.1 * shortest);
}

TEST_CASE("without fluid in it a crack leaves the mechanical step as it is") {
  for (const double fraction : {0.97, 0.9, 0.8}) {
    const hfdem::Mechanics mechanics{.step_fraction = fraction};
    const test::SquareRock<Conventional> settled(test::square(10), {.mechanics = mechanics});
    const test::SquareRock<hfdem::Dry> dry(test::square(10), {.mechanics = mechanics});
    CHECK(settled.mechanical_dt() == dry.mechanical_dt());
  }
}
