// The books of mechanical energy: that they close, and that each entry is what its name says.
#include <cmath>
#include <cstddef>
#include <vector>

#include <hfdem/measure/energy_ledger.hpp>
#include <hfdem/neighbours/cell_grid.hpp>
#include <hfdem/pressure/conventional.hpp>
#include <hfdem/setup/random_packing.hpp>

#include <doctest/doctest.h>

#include "measures/one_contact.hpp"
#include "near.hpp"
#include "schemes/small_array.hpp"

namespace {

using hfdem::BoundaryKind;
using hfdem::Index;
using hfdem::LinearParallelBond;
using hfdem::Pack;
using hfdem::Vec2;
using hfdem::measure::EnergyEntries;
using test::near;
using test::OneContact;
namespace sample = test::sample;

using Ledger = hfdem::measure::EnergyLedger<LinearParallelBond>;
using Held = test::SquareRock<hfdem::HeldPressure>;
template <class Law>
using RandomRock =
    hfdem::Simulator<Law, hfdem::HyperbolicAperture, hfdem::HeldPressure, hfdem::CellGrid>;

/// Some 180 grains.
const hfdem::Specimen& grains() {
  static const auto s = hfdem::random_packing({.width = 0.1, .height = 0.1, .seed = 3});
  return s;
}

template <class Law = LinearParallelBond>
RandomRock<Law> random_rock(BoundaryKind kind) {
  return {grains(), {.boundary = {.kind = kind}, .in_situ = {.xx = 5e6, .yy = 8e6}}};
}

/// Bursts open under some breaks and closes again.
template <class Sim, class ItsLedger>
void burst_and_close(Sim& sim, ItsLedger& ledger) {
  const auto hold = [&](double pressure, int steps) {
    sim.pressure_scheme().hold(pressure);
    const double end = sim.time() + steps;
    sim.run_until(end, ledger);
  };
  for (double pressure = 5e6; sim.breaks().size() < 6; pressure += 2e6) hold(pressure, 1);
  hold(1e6, 2);
  hold(20e6, 1);
  hold(0, 2);
}

/// Every entry is so large that 5 % of it, left out, would be seen.
void check_that_all_matter(const EnergyEntries& e, double work_done) {
  for (const double entry :
       {e.boundary, e.fluid, e.elastic, e.friction, e.damping, e.breaks, e.switching})
    CHECK(std::abs(entry) > 1e-6 * work_done);
}

double product(const Pack& a, const Pack& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Kinetic energy and damping of a run from its velocities alone: what accelerates a disc beyond
/// its resultant is damping.
struct FromVelocities {
  struct Instant {
    std::vector<Pack> velocity, resultant, place;
  };
  std::vector<Instant> instants{};

  void mechanical_step(const Held& sim) {
    Instant now{sim.discs().velocity, {}, sim.discs().displacement};
    for (std::size_t i = 0; i < sim.discs().size(); ++i) {
      const Pack total = sim.forces().total(i);
      const auto [x, y] = sim.discs().load[i];
      now.resultant.push_back(Pack{total[0] + x, total[1] + y, total[2] + total[3], 0});
    }
    instants.push_back(now);
  }

  Pack inertia(const Held& sim, std::size_t i) const {
    return Pack{sim.discs().mass[i], sim.discs().mass[i], sim.discs().inertia(i), 0};
  }
  /// At instant n, with velocities of half a step before and after.
  double kinetic(const Held& sim, std::size_t n) const {
    double sum = 0;
    for (std::size_t i = 0; i < sim.discs().size(); ++i)
      sum += product(inertia(sim, i) * instants[n].velocity[i], instants[n + 1].velocity[i]) / 2;
    return sum;
  }
  Pack damping(const Held& sim, std::size_t n, std::size_t i) const {
    const Pack gained = instants[n + 1].velocity[i] - instants[n].velocity[i];
    return instants[n].resultant[i] - inertia(sim, i) * gained / sim.mechanical_dt();
  }
  double damped(const Held& sim, std::size_t through) const {
    double sum = 0;
    for (std::size_t n = 0; n < through; ++n)
      for (std::size_t i = 0; i < sim.discs().size(); ++i)
        sum += product(damping(sim, n, i) + damping(sim, n + 1, i),
                       instants[n + 1].place[i] - instants[n].place[i]) /
               2;
    return sum;
  }
};

/// In each mechanical step, the work of all forces over all displacements, told twice.
struct VirtualWork {
  double of_contacts = 0, of_bodies = 0;

  void mechanical_step(const RandomRock<LinearParallelBond>& sim) {
    of_contacts = of_bodies = 0;
    add(sim.contacts(), sim.discs().displacement);
    add(sim.platens(), sim.discs().displacement);
    for (std::size_t body = 0; body < sim.discs().displacement.size(); ++body) {
      const Pack force = sim.forces().total(body), place = sim.discs().displacement[body];
      of_bodies += force[0] * place[0] + force[1] * place[1] + (force[2] + force[3]) * place[2];
    }
  }

 private:
  template <class Range>
  void add(const Range& range, const std::vector<Pack>& displacement) {
    for (std::size_t c = 0; c < range.size(); ++c) {
      const auto motion = range.motion(c, displacement);
      const auto force = range.response(c, displacement).reaction();
      of_contacts += force.normal * motion.opening + force.shear * motion.shear -
                     force.moment * motion.rotation;
    }
  }
};

}  // namespace

// ---- closing ------------------------------------------------------------------------------------

TEST_CASE("the books of an injected square array close, through its breaks") {
  test::Injected sim(test::square(20), {.injection = {.rate = 5e-4}});
  Ledger ledger;
  sim.run_until(5e-3, ledger);
  CHECK(sim.breaks().size() >= 6);
  CHECK(ledger.worst_relative_error() < 1e-9);
  check_that_all_matter(ledger.entries(), ledger.work_done());
  CHECK(std::abs(ledger.entries().kinetic) > 1e-6 * ledger.work_done());
}

TEST_CASE("the books close where a stiff fluid changes the mechanical step") {
  test::SquareRock<hfdem::ConventionalFlow<>> sim(
      test::square(20), {.injection = {.rate = 1e-3}, .fluid = {.viscosity = 1e-3}});
  Ledger ledger;
  int changes = 0;
  double dt = sim.mechanical_dt();
  while (sim.mechanical_steps() < 2000) {
    sim.step(ledger);
    changes += sim.mechanical_dt() != dt;
    dt = sim.mechanical_dt();
  }
  CHECK(changes > 3);
  CHECK(sim.breaks().size() >= 2);
  CHECK(ledger.worst_relative_error() < 1e-9);
}

TEST_CASE("the books of a random specimen close, through breaks, slip and closing again") {
  for (const BoundaryKind kind : {BoundaryKind::servo, BoundaryKind::dead_loads}) {
    CAPTURE(static_cast<int>(kind));
    auto sim = random_rock(kind);
    Ledger ledger;
    burst_and_close(sim, ledger);
    CHECK(ledger.worst_relative_error() < 1e-9);
    check_that_all_matter(ledger.entries(), ledger.work_done());
    CHECK(ledger.entries().damping > 0);
    CHECK(ledger.entries().friction > 0);
    CHECK(ledger.entries().breaks > 0);
  }
}

TEST_CASE("the books do not close with a law that is wrong about its energy") {
  struct Forgetful : LinearParallelBond {
    using LinearParallelBond::LinearParallelBond;
    double energy(const Stiffness<double>& k, const Memory<double>& slip,
                  const hfdem::Motion<double>& m) const noexcept {
      return LinearParallelBond::energy(k, slip, {m.opening, m.shear, 0});
    }
  };
  auto sim = random_rock<Forgetful>(BoundaryKind::servo);
  hfdem::measure::EnergyLedger<Forgetful> ledger;
  sim.pressure_scheme().hold(8e6);
  sim.run_until(1, ledger);
  CHECK(ledger.worst_relative_error() > 1e-6);
}

TEST_CASE("steps that a ledger does not hear of are in none of its entries") {
  Held sim(test::square(12), {.crack = {.contacts = 2}, .scheme = {.pressure = 3e6}});
  Ledger ledger;
  sim.run_until(1, ledger);
  const EnergyEntries before = ledger.entries();
  sim.pressure_scheme().hold(6e6);
  sim.step();
  sim.set_in_situ({9e6, 11e6});
  sim.run_until(sim.time() + 1, ledger);  // at rest already
  CHECK(ledger.entries().fluid == near(before.fluid, 0.02));
  CHECK(ledger.entries().elastic == near(before.elastic, 0.02));
  CHECK(ledger.worst_relative_error() < 1e-9);
}

TEST_CASE("the books are the same bits for any number of threads") {
  const auto books = [](int threads) {
    Held sim(test::square(60), {.scheme = {.pressure = 11e6, .max_mechanical_steps = 60}});
    sim.use_threads(threads);
    Ledger ledger;
    sim.run_until(1, ledger);
    return ledger.entries();
  };
  const EnergyEntries one = books(1), three = books(3);
  CHECK(test::bits(one.boundary) == test::bits(three.boundary));
  CHECK(test::bits(one.fluid) == test::bits(three.fluid));
  CHECK(test::bits(one.accounted()) == test::bits(three.accounted()));
  CHECK(one.fluid > 0);
}

TEST_CASE("the forces of all contacts over their motions are those of all bodies over theirs") {
  auto sim = random_rock(BoundaryKind::servo);
  VirtualWork work;
  sim.pressure_scheme().hold(9e6);
  sim.run_until(1, work);
  CHECK(std::abs(work.of_contacts) > 1);
  CHECK(work.of_contacts == near(work.of_bodies, 1e-11));
}

// ---- what the entries say -----------------------------------------------------------------------

TEST_CASE("a held pressure works over the displacement of the discs that it pushes") {
  Held sim(test::square(12),
           {.contact = {.tensile_strength = 1e9, .cohesion = 1e9}, .scheme = {.pressure = 14e6}});
  const std::vector<Pack> before = sim.discs().displacement;
  std::vector<Pack> after;  // at the last mechanical step that the ledger hears of
  struct Place {
    std::vector<Pack>* last;
    void mechanical_step(const Held& s) { *last = s.discs().displacement; }
  } place{&after};
  Ledger ledger;
  sim.run_until(1, ledger, place);
  double work = 0;
  for (const Index i : sim.network().pushed_discs()) {
    const Vec2 force = sim.network().force_on(i);
    work += force.x * (after[i][0] - before[i][0]) + force.y * (after[i][1] - before[i][1]);
  }
  CHECK(work > 0.1);
  CHECK(ledger.entries().fluid == near(work, 1e-10));
}

TEST_CASE("platens work as the force of the stress over their way, frozen ones do none") {
  for (const BoundaryKind kind :
       {BoundaryKind::servo, BoundaryKind::frozen, BoundaryKind::dead_loads}) {
    CAPTURE(static_cast<int>(kind));
    Held sim(test::square(12), {.contact = {.tensile_strength = 1e9, .cohesion = 1e9},
                                .boundary = {.kind = kind},
                                .scheme = {.pressure = 14e6}});
    const std::vector<Pack> before = sim.discs().displacement;
    Ledger ledger;
    sim.run_until(1, ledger);
    const auto way = [&](std::size_t body, int lane) {
      return sim.discs().displacement[body][lane] - before[body][lane];
    };
    double work = 0;
    for (std::size_t i = 0; i < sim.discs().size(); ++i) {
      const Vec2 load = sim.loading().dead_load(static_cast<Index>(i));
      work += load.x * way(i, 0) + load.y * way(i, 1);
    }
    for (const hfdem::Side side : hfdem::all_sides)
      if (kind == BoundaryKind::servo) {
        const Vec2 out = hfdem::outward(side);
        const Index p = sim.discs().platen(side);
        work -= sim.loading().target(side) * (out.x * way(p, 0) + out.y * way(p, 1));
      }
    if (kind == BoundaryKind::frozen)
      CHECK(ledger.entries().boundary == 0);
    else  // the servo lets the force waver
      CHECK(ledger.entries().boundary == near(work, kind == BoundaryKind::servo ? 0.03 : 1e-5));
  }
}

TEST_CASE("kinetic energy and damping are those of the velocities") {
  Held sim(test::square(12), {.mechanics = {.damping = 0.3}, .scheme = {.pressure = 14e6}});
  Ledger ledger;
  FromVelocities velocities;
  // The last instant only tells the velocity after the one before.
  struct AllButTheLast {
    Ledger& ledger;
    EnergyEntries before_last{}, last{};
    void mechanical_step(const Held& s) {
      before_last = last;
      ledger.mechanical_step(s);
      last = ledger.entries();
    }
  } booked{ledger};
  sim.run_until(1, booked, velocities);
  const std::size_t n = velocities.instants.size() - 2;
  REQUIRE(n > 10);
  const EnergyEntries& e = booked.before_last;
  CHECK(e.kinetic == near(velocities.kinetic(sim, n) - velocities.kinetic(sim, 0), 1e-6));
  CHECK(e.damping == near(velocities.damped(sim, n), 1e-6));
  CHECK(e.damping > 0);
}

TEST_CASE("without damping none is booked, and without slip no friction") {
  Held sim(test::square(12), {.mechanics = {.damping = 0, .settle_tolerance = 10},
                              .scheme = {.pressure = 9e6, .max_mechanical_steps = 200}});
  Ledger ledger;
  sim.run_until(1, ledger);
  CHECK(ledger.entries().damping == 0);
  CHECK(ledger.entries().friction == 0);
  CHECK(ledger.entries().breaks == 0);
  CHECK(ledger.worst_relative_error() < 1e-9);
}

TEST_CASE("a contact stores what its springs take up") {
  OneContact contact;
  contact.lead_to({});
  contact.lead_to({.opening = -4e-6, .shear = 1e-6, .rotation = 3e-4});
  CHECK(contact.entries().elastic ==
        near(((sample::k_n + sample::bond_k_n) * 16e-12 + (sample::k_s + sample::bond_k_s) * 1e-12 +
              sample::bond_k_m * 9e-8) /
             2));
  CHECK(contact.entries().friction == 0);
  contact.lead_to({});
  CHECK(contact.entries().elastic == near(0).scale(1e-3));
}

TEST_CASE("friction is the force at which a contact slips, over its slip") {
  const double pressed = 5e-6, limit = 0.4 * sample::k_n * pressed, slips_at = limit / sample::k_s;
  OneContact contact;
  contact.break_bond();
  contact.lead_to({.opening = -pressed});
  const auto shear_to = [&](double slip_distances) {
    contact.lead_to({.opening = -pressed, .shear = slip_distances * slips_at});
  };
  shear_to(1);
  CHECK(contact.entries().friction == near(0).scale(limit * slips_at));
  shear_to(2);
  shear_to(3.5);
  CHECK(contact.entries().friction == near(2.5 * limit * slips_at));
  shear_to(1.5);  // elastic the whole way back
  CHECK(contact.entries().friction == near(2.5 * limit * slips_at));
  shear_to(0);
  CHECK(contact.entries().friction == near(4 * limit * slips_at));
  CHECK(contact.entries().elastic == near(limit * slips_at / 2));
}

TEST_CASE("a broken bond sets free what it stored, and what it took up in the step it broke") {
  const test::Move stretched{.opening = 2e-6, .shear = -1e-6, .rotation = 2e-4};
  const double stored =
      (sample::bond_k_n * 4e-12 + sample::bond_k_s * 1e-12 + sample::bond_k_m * 4e-8) / 2;
  {
    OneContact contact;
    contact.lead_to(stretched);
    contact.break_bond();
    contact.lead_to(stretched);
    CHECK(contact.entries().breaks == near(stored));
    CHECK(contact.entries().elastic == near(-stored));
  }
  {
    OneContact contact;
    contact.lead_to(stretched);
    contact.break_bond();
    contact.lead_to({.opening = 2.5e-6, .shear = -3e-6, .rotation = 1e-4});
    const double force_over_way = sample::bond_k_n * 2e-6 * 0.5e-6 +
                                  sample::bond_k_s * 1e-6 * 2e-6 - sample::bond_k_m * 2e-4 * 1e-4;
    CHECK(contact.entries().breaks == near(stored + force_over_way / 2));
  }
}

TEST_CASE("a step across the opening of a contact books half its force over the gap left behind") {
  OneContact contact;
  contact.break_bond();
  contact.lead_to({.opening = -3e-6});
  contact.lead_to({.opening = 2e-6});
  CHECK(contact.entries().elastic == near(-sample::k_n * 9e-12 / 2));
  CHECK(contact.entries().switching == near(-sample::k_n * 3e-6 * 2e-6 / 2));
  contact.lead_to({.opening = -4e-6});
  CHECK(contact.entries().switching == near(sample::k_n * (4e-6 * 2e-6 - 3e-6 * 2e-6) / 2));
  contact.lead_to({.opening = 0});  // in two steps, without a gap between
  contact.lead_to({.opening = 1e-6});
  CHECK(contact.entries().switching == near(sample::k_n * (4e-6 * 2e-6 - 3e-6 * 2e-6) / 2));
}
