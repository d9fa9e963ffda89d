// Platens and dead loads: forces that sum up, a servo that converges, and settled specimens.
#include <cmath>
#include <utility>
#include <vector>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/mechanics/uniform_strain.hpp>
#include <hfdem/neighbours/cell_grid.hpp>
#include <hfdem/pressure/dry.hpp>
#include <hfdem/pressure/held.hpp>
#include <hfdem/setup/random_packing.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

#include <doctest/doctest.h>

#include "loops/assembly.hpp"
#include "near.hpp"

namespace {

using hfdem::BoundaryKind;
using hfdem::Index;
using hfdem::Pack;
using hfdem::Side;
using hfdem::Vec2;
using test::near;
using Bond = hfdem::LinearParallelBond;
using DryRock = hfdem::Simulator<Bond, hfdem::HyperbolicAperture, hfdem::Dry, hfdem::FixedPairs>;
using Rock = hfdem::Simulator<Bond, hfdem::HyperbolicAperture, hfdem::Dry, hfdem::CellGrid>;
using Slit =
    hfdem::Simulator<Bond, hfdem::HyperbolicAperture, hfdem::HeldPressure, hfdem::FixedPairs>;

constexpr double S_xx = 10e6, S_yy = 15e6;

hfdem::Specimen irregular_specimen() {
  test::Random random(1);
  return test::jittered_discs(7, 6, random);
}

/// How far a platen has moved outwards, m.
template <class Simulator>
double platen_position(const Simulator& sim, Side side) {
  const Pack moved = sim.discs().displacement[sim.discs().platen(side)];
  return dot({moved[0], moved[1]}, hfdem::outward(side));
}

}  // namespace

TEST_CASE("the in-situ stress acts on the whole of each side") {
  const hfdem::Specimen s{.width = 0.3, .height = 0.7};
  hfdem::Loading loading({}, s);
  loading.set_stress({S_xx, S_yy});
  CHECK(loading.target(Side::left) == near(S_xx * 0.7));
  CHECK(loading.target(Side::right) == near(S_xx * 0.7));
  CHECK(loading.target(Side::bottom) == near(S_yy * 0.3));
  CHECK(loading.target(Side::top) == near(S_yy * 0.3));
}

TEST_CASE("dead loads sum up to the force on each side") {
  const auto specimen = irregular_specimen();
  hfdem::Loading loading({.kind = BoundaryKind::dead_loads}, specimen);
  loading.set_stress({1, 1});
  loading.set_stress({S_xx, S_yy});  // replaces, does not add
  Vec2 pushed_right, pushed_up, all;
  for (Index i = 0; i < specimen.size(); ++i) {
    const Vec2 load = loading.dead_load(i);
    all = all + load;
    if (load.x > 0) pushed_right = pushed_right + load;
    if (load.y > 0) pushed_up = pushed_up + load;
    if (load == Vec2{}) continue;
    CHECK((specimen.touches(i, Side::left) || specimen.touches(i, Side::right) ||
           specimen.touches(i, Side::bottom) || specimen.touches(i, Side::top)));
  }
  CHECK(pushed_right.x == near(S_xx * specimen.height));
  CHECK(pushed_up.y == near(S_yy * specimen.width));
  CHECK(norm(all) < 1e-12 * S_yy * specimen.width);
}

TEST_CASE("the dead loads of a side act in its middle, each by its radius and where it is") {
  // Three discs on the left, with gaps between them: their mean height is not the middle.
  hfdem::Specimen s{.width = 1, .height = 1, .density = 1, .bonding_gap = 1e-3};
  s.centre = {{0.1, 0.1}, {0.1, 0.3}, {0.05, 0.8}, {0.5, 0.5}};
  s.radius = {0.1, 0.1, 0.05, 0.1};
  hfdem::Loading loading({.kind = BoundaryKind::dead_loads}, s);
  loading.set_stress({S_xx, 0});
  double force = 0, moment = 0;
  for (Index i = 0; i < 3; ++i) {
    force += loading.dead_load(i).x;
    moment += loading.dead_load(i).x * s.centre[i].y;
  }
  CHECK(force == near(S_xx));
  CHECK(moment == near(S_xx * 0.5));
  // Per radius, they lie on a straight line.
  const auto per_radius = [&](Index i) { return loading.dead_load(i).x / s.radius[i]; };
  CHECK((per_radius(1) - per_radius(0)) / 0.2 == near((per_radius(2) - per_radius(1)) / 0.5));
  CHECK(per_radius(2) > 1.5 * per_radius(0));
  CHECK(loading.dead_load(3) == Vec2{});
}

TEST_CASE("dead loads on a symmetric rim are shares of the radius, to the last bit") {
  hfdem::Loading loading({.kind = BoundaryKind::dead_loads}, hfdem::square_array(7, 5, 5e-3));
  loading.set_stress({S_xx, S_yy});
  for (Index row = 0; row < 5; ++row)
    CHECK(test::bits(loading.dead_load(row * 7).x) == test::bits(loading.dead_load(0).x));
}

TEST_CASE("a random specimen under dead loads settles and does not turn") {
  const Rock sim(hfdem::random_packing({.width = 0.1, .height = 0.14}),
                 {.boundary = {.kind = BoundaryKind::dead_loads},
                  .in_situ = {S_xx, S_yy},
                  .crack = {.contacts = 0}});
  double turn = 0, shortening = 0;
  const Vec2 middle{sim.specimen().width / 2, sim.specimen().height / 2};
  for (Index i = 0; i < sim.discs().size(); ++i) {
    const Vec2 arm = sim.discs().centre[i] - middle;
    const Vec2 moved{sim.discs().displacement[i][0], sim.discs().displacement[i][1]};
    turn += cross(arm, moved);
    shortening -= dot(arm, moved);
  }
  CHECK(shortening > 0);
  CHECK(std::abs(turn) < 0.5 * shortening);
}

TEST_CASE("discs of the rim do not count as unbalanced under dead loads") {
  // A disc that touches nothing but carries a dead load flies away; the others are at rest.
  hfdem::Specimen s{.width = 1, .height = 1, .density = 1};
  s.centre = {{0.1, 0.5}, {0.5, 0.5}};
  s.radius = {0.1, 0.1};
  hfdem::Discs discs(s);
  discs.load = {{5, 0}, {0, 3}};
  hfdem::ForceRows rows(2 + hfdem::all_sides.size());
  rows.arrange();
  hfdem::DiscMotion motion(discs, 1e-3, 0);
  CHECK(motion.step(discs, rows, 1).resultant == near(5));
  const std::vector<Index> rim{0};
  motion.leave_out(rim);
  CHECK(motion.step(discs, rows, 1).resultant == near(3));
}

TEST_CASE("with platens there are no dead loads") {
  const auto specimen = irregular_specimen();
  hfdem::Loading loading({.kind = BoundaryKind::servo}, specimen);
  loading.set_stress({S_xx, S_yy});
  for (Index i = 0; i < specimen.size(); ++i) CHECK(loading.dead_load(i) == Vec2{});
}

TEST_CASE("a servo takes back its gain's part of the error in each step") {
  // One disc that stays where it is, between platens of stiffness k: the error shrinks by 1 - gain.
  constexpr double k = 5e10, gain = 0.3, R = 0.5;
  const hfdem::Specimen s{.width = 2 * R,
                          .height = 2 * R,
                          .density = 1,
                          .centre = {{R, R}},
                          .radius = {R},
                          .bonding_gap = 1e-9};
  hfdem::Discs discs(s);
  hfdem::Loading loading({.servo_gain = gain}, s);
  const auto touching = hfdem::platen_contacts(s, discs);
  REQUIRE(touching.size() == 4);
  for (const Side side : hfdem::all_sides) loading.add_stiffness(side, k);
  const std::vector<hfdem::SmoothPlaten::Stiffness<double>> stiffness(4, {k});
  hfdem::ContactRange<hfdem::SmoothPlaten> platens({}, 0, touching, stiffness);
  hfdem::ForceRows forces(5);
  forces.add(touching, 0, platens.padded_size());
  forces.arrange();

  loading.set_stress({S_xx, S_yy});
  for (int step = 0; step < 10; ++step) {
    platens.evaluate(discs.displacement, forces.rows(), 1);
    for (const Side side : hfdem::all_sides) {
      const double missing = std::pow(1 - gain, step);
      CHECK(loading.compression(side, discs, forces) ==
            near((1 - missing) * loading.target(side)).scale(loading.target(side)));
      CHECK(loading.error(side, discs, forces) == near(missing));
    }
    loading.step(discs, forces, false);
  }
}

TEST_CASE("a settled square array has the strain of its closed form") {
  for (const BoundaryKind kind :
       {BoundaryKind::servo, BoundaryKind::frozen, BoundaryKind::dead_loads}) {
    DryRock sim(hfdem::square_array(6, 7, 5e-3),
                {.boundary = {.kind = kind}, .in_situ = {S_xx, S_yy}, .crack = {.contacts = 0}});
    // Rows and columns of equal springs: E and E_b side by side, no lateral strain.
    const double E = Bond::Params{}.E + Bond::Params{}.bond_E;
    const double right = S_xx / E * sim.specimen().width / 2;
    const double top = S_yy / E * sim.specimen().height / 2;
    for (Index i = 0; i < sim.discs().size(); ++i) {
      const Vec2 from_middle =
          sim.discs().centre[i] - 0.5 * Vec2{sim.specimen().width, sim.specimen().height};
      const Pack moved = sim.discs().displacement[i];
      CHECK(std::abs(moved[0] + S_xx / E * from_middle.x) < 3e-4 * right);
      CHECK(std::abs(moved[1] + S_yy / E * from_middle.y) < 3e-4 * top);
      CHECK(std::abs(moved[2]) < 1e-6 * top / 5e-3);
    }
    CHECK(sim.settling_steps() < 100);  // as it starts from that strain
    if (kind == BoundaryKind::dead_loads) continue;
    CHECK(platen_position(sim, Side::left) == near(-right, 3e-4));
    CHECK(platen_position(sim, Side::right) == near(-right, 3e-4));
    CHECK(platen_position(sim, Side::bottom) == near(-top, 3e-4));
    CHECK(platen_position(sim, Side::top) == near(-top, 3e-4));
  }
}

TEST_CASE("a settled irregular specimen is in equilibrium with its platens") {
  const DryRock sim(irregular_specimen(), {.contact = {.tensile_strength = 1e9, .cohesion = 1e9},
                                           .in_situ = {S_xx, S_yy},
                                           .crack = {.contacts = 0}});
  double worst = 0;
  for (Index i = 0; i < sim.discs().size(); ++i) {
    const Pack total = sim.forces().total(i);
    worst = std::fmax(worst, std::hypot(total[0], total[1]));
  }
  CHECK(sim.mean_contact_force() > 0.1 * S_xx * 8e-3);
  CHECK(worst < 1.01 * sim.params().mechanics.settle_tolerance * sim.mean_contact_force());
  for (const Side side : hfdem::all_sides)
    CHECK(sim.loading().compression(side, sim.discs(), sim.forces()) ==
          near(sim.loading().target(side), 2e-4));
}

TEST_CASE("frozen platens stay where they settled; a servo gives way to the crack") {
  const auto pressurised = [](BoundaryKind kind) {
    Slit sim(hfdem::square_array(10, 10, 5e-3),
             {.boundary = {.kind = kind}, .scheme = {.pressure = 15e6}});
    const double before = platen_position(sim, Side::right);
    sim.step();
    return std::pair{before, platen_position(sim, Side::right)};
  };
  const auto [frozen_before, frozen_after] = pressurised(BoundaryKind::frozen);
  CHECK(test::bits(frozen_before) == test::bits(frozen_after));
  const auto [servo_before, servo_after] = pressurised(BoundaryKind::servo);
  CHECK(servo_after > servo_before);
}

TEST_CASE("a change of the in-situ stress moves frozen platens as well") {
  DryRock sim(hfdem::square_array(6, 7, 5e-3), {.boundary = {.kind = BoundaryKind::frozen},
                                                .in_situ = {S_xx, S_yy},
                                                .crack = {.contacts = 0}});
  sim.set_in_situ({S_xx / 2, S_yy});
  CHECK(sim.loading().compression(Side::right, sim.discs(), sim.forces()) ==
        near(S_xx / 2 * sim.specimen().height, 2e-4));
}

TEST_CASE("the modulus of uniform strain is that of the closed forms") {
  // A triangular lattice of k_n and k_s alone is isotropic: lambda and mu follow from both springs.
  constexpr double L = 0.2, k_n = 3e9, k_s = 1e9;
  const double cell = L * L * std::sqrt(3.0) / 2;  // area of one disc, which owns three contacts
  hfdem::UniformStrainModulus modulus;
  for (const double angle : {0.0, 60.0, 120.0}) {
    const double a = angle * std::acos(-1.0) / 180;
    modulus.add({std::cos(a), std::sin(a), L / 2, 0}, {.normal = k_n, .shear = k_s}, L, cell);
  }
  const double lambda_and_2mu = std::sqrt(3.0) / 4 * (3 * k_n + k_s);
  const double lambda = std::sqrt(3.0) / 4 * (k_n - k_s);
  CHECK(modulus.xxxx == near(lambda_and_2mu));
  CHECK(modulus.yyyy == near(lambda_and_2mu));
  CHECK(modulus.xxyy == near(lambda));

  const Vec2 strain = modulus.shortening({S_xx, S_yy});
  CHECK(lambda_and_2mu * strain.x + lambda * strain.y == near(S_xx));
  CHECK(lambda * strain.x + lambda_and_2mu * strain.y == near(S_yy));
}
