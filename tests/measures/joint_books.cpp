// Measures of a specimen with natural fractures: books of energy, microcracks, stresses.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <hfdem/measure/crack.hpp>
#include <hfdem/measure/energy_ledger.hpp>
#include <hfdem/measure/microcracks.hpp>
#include <hfdem/measure/particle_stress.hpp>
#include <hfdem/pressure/dry.hpp>
#include <hfdem/pressure/held.hpp>
#include <hfdem/pressure/uniform.hpp>

#include <doctest/doctest.h>

#include "laws/sample_joint.hpp"
#include "loops/jointed_rock.hpp"
#include "near.hpp"
#include "schemes/small_array.hpp"

namespace {

using hfdem::Index;
using hfdem::Vec2;
using hfdem::measure::EnergyEntries;
using test::near;
namespace joint = test::joint;

using Ledger = hfdem::measure::EnergyLedger<test::JointedRock>;
using Injected = test::Fractured<hfdem::UniformPressure>;
using Held = test::Fractured<hfdem::HeldPressure>;

/// What happened to the joints of a run.
struct Events {
  int broken = 0, slipped = 0, met = 0;
  bool opened = false, closed = false;  ///< wide open, pressed together, while broken

  template <class Sim>
  void look(const Sim& sim) {
    broken = slipped = met = 0;
    const auto& contacts = sim.joints().contacts();
    for (std::size_t k = 0; k < sim.joints().size(); ++k) {
      const bool is_broken = contacts.stiffness(k).bond == 0;
      broken += is_broken && k < sim.joints().bonded();
      met += k >= sim.joints().bonded() && sim.joints().has_met(k);
      slipped += contacts.memory(k).slip != 0;
      const double gap =
          contacts.motion(k, sim.discs().displacement).opening - contacts.memory(k).dilation;
      if (is_broken) (gap > 0 ? opened : closed) = true;
    }
  }
};

/// Two discs and the joint between them, led by hand: as much of a simulator as a ledger looks at.
class OneJoint {
 public:
  /// Its second disc moves; the joint lies along x, its normal along y.
  void lead_to(const hfdem::Motion<double>& motion) {
    discs_.displacement[1] = hfdem::Pack{-motion.shear, motion.opening, 0, 0};
    joints_.contacts().evaluate(discs_.displacement, forces_.rows(), 1);
    ledger_.mechanical_step(*this);
    ++steps_;
  }
  /// With the next motion.
  void break_bond() { joints_.contacts().break_bond(0); }
  const EnergyEntries& entries() const { return ledger_.entries(); }

  // ---- what a ledger reads ----------------------------------------------------------------------

  struct Params {
    struct {
      double damping = 0;
    } mechanics;
  };
  struct Nothing {
    Vec2 force_on(Index) const { return {}; }
    Vec2 dead_load(Index) const { return {}; }
  };
  long mechanical_steps() const { return steps_; }
  long settling_steps() const { return 0; }
  double mechanical_dt() const { return 1e-6; }
  Params params() const { return {}; }
  Nothing network() const { return {}; }
  Nothing loading() const { return {}; }
  const hfdem::Discs& discs() const { return discs_; }
  const hfdem::ForceRows& forces() const { return forces_; }
  const hfdem::ContactRange<test::JointedRock>& contacts() const { return rock_; }
  const hfdem::ContactRange<hfdem::SmoothPlaten>& platens() const { return platens_; }
  const hfdem::JointContacts<test::Joint>& joints() const { return joints_; }

 private:
  static hfdem::Specimen two_discs() {
    hfdem::Specimen s{.width = 1, .height = 1, .density = 1};
    s.centre = {{0, 0}, {0, 1e-2}};
    s.radius = {5e-3, 5e-3};
    s.joints.fractures = {{{-joint::length / 2, 5e-3}, {joint::length / 2, 5e-3}}};
    s.joints.pairs = {{{0, 1}, 0, joint::length / 2, {0, 1}}};
    return s;
  }
  hfdem::ForceRows arranged() const {
    hfdem::ForceRows rows(discs_.size() + 4);
    rows.add(joints_.geometry(), 0, hfdem::pack_width);
    rows.arrange();
    return rows;
  }

  hfdem::Specimen specimen_ = two_discs();
  hfdem::Discs discs_{specimen_};
  hfdem::JointContacts<test::Joint> joints_{test::Joint(test::sample_joint), 0,
                                            specimen_.joints.pairs, 1, specimen_};
  hfdem::ContactRange<test::JointedRock> rock_{
      test::JointedRock({}, test::sample_joint), hfdem::pack_width, {}, {}};
  hfdem::ContactRange<hfdem::SmoothPlaten> platens_{{}, hfdem::pack_width, {}, {}};
  hfdem::ForceRows forces_ = arranged();
  Ledger ledger_;
  long steps_ = 0;
};

}  // namespace

// ---- books --------------------------------------------------------------------------------------

TEST_CASE("the books close through joints that break, slip, open, close and meet") {
  const hfdem::Specimen sinking =
      test::fractured_square({{4, 4.2e-5}, {6, 5.25e-5}, {9, 5.3e-5}, {11, 1e-4}});
  for (const auto& specimen : {test::fractured_square(), sinking})
    for (const double dilation_angle : {0.0, 1.0, 10.0}) {
      CAPTURE(dilation_angle);
      Injected::Params params{.joints = test::weak_joint, .injection = {.rate = 1e-3}};
      params.joints.dilation_angle = dilation_angle;
      if (dilation_angle > 1) params.joints.friction = 0.2;  // steeper than the rise
      Injected sim(specimen, params);
      Ledger ledger;
      Events before, events;
      before.look(sim);
      for (int n = 0; n < (dilation_angle > 1 ? 24 : 45); ++n) {
        sim.step(ledger);
        events.look(sim);
      }
      CHECK(ledger.worst_relative_error() < 1e-9);
      const EnergyEntries& e = ledger.entries();
      for (const double entry :
           {e.boundary, e.fluid, e.elastic, e.friction, e.damping, e.breaks, e.switching})
        CHECK(std::abs(entry) > 1e-6 * ledger.work_done());
      CHECK(e.friction > 0);
      CHECK(events.broken >= 3);
      CHECK(events.slipped >= 3);
      CHECK(events.opened == (dilation_angle <= 1));  // strong friction lets the crack cross
      CHECK(events.closed);
      CHECK((events.met > before.met) == (specimen.centre == sinking.centre));
    }
}

TEST_CASE("a joint that breaks in shear sets free what its stress falls by, over its slip") {
  const double pressed = 5e-6, shear = 70e-6;
  OneJoint contact;
  contact.lead_to({.opening = -pressed, .shear = shear});
  contact.break_bond();
  contact.lead_to({.opening = -pressed, .shear = shear});
  const double slip = (joint::k_s * shear - joint::friction * joint::k_n * pressed) /
                      (joint::k_s + joint::friction * joint::k_n * joint::rise);
  const double residual = joint::friction * joint::k_n * (pressed + joint::rise * slip);
  const double lift = joint::k_n * (2 * pressed + joint::rise * slip) / 2 * joint::rise * slip;
  CHECK(contact.entries().breaks ==
        near(joint::length * ((joint::k_s * shear + residual) / 2 * slip - lift), 1e-11));
  CHECK(contact.entries().elastic == near(-contact.entries().breaks, 1e-11));
  CHECK(contact.entries().friction == near(0).scale(1e-3));
}

TEST_CASE("friction of a joint is the stress over its slip, less what lifts it") {
  const double pressed = 5e-6, limit = joint::friction * joint::k_n * pressed;
  const double slips_at = limit / joint::k_s;
  OneJoint contact;
  contact.break_bond();
  contact.lead_to({.opening = -pressed});
  contact.lead_to({.opening = -pressed, .shear = slips_at});
  CHECK(contact.entries().friction == near(0).scale(limit * slips_at * joint::length));
  contact.lead_to({.opening = -pressed, .shear = 3 * slips_at});
  const double slip = 2 * limit / (joint::k_s + joint::friction * joint::k_n * joint::rise);
  const double mean_normal = joint::k_n * (pressed + joint::rise * slip / 2);
  CHECK(contact.entries().friction ==
        near(joint::length * (joint::friction - joint::rise) * mean_normal * slip, 1e-10));
}

// ---- microcracks --------------------------------------------------------------------------------

TEST_CASE("broken joints are microcracks along their fracture, as long as their pieces") {
  Injected sim(test::fractured_square(), {.joints = test::weak_joint, .injection = {.rate = 1e-3}});
  for (int n = 0; n < 14; ++n) sim.step();
  const auto cracks = hfdem::measure::microcracks(sim);
  double along_fracture = 0;
  int in_joint = 0;
  for (const auto& m : cracks) {
    CHECK(m.in_joint == sim.is_joint(m.contact));
    if (!m.in_joint) {
      CHECK(m.length() == near(2 * test::radius));
      continue;
    }
    ++in_joint;
    along_fracture += m.length();
    CHECK(m.facet.from.y == near(0.12));
    CHECK(m.facet.to.y == near(0.12));
    CHECK(m.facet.to.x > m.facet.from.x);
    const double x = sim.discs().centre[sim.contact_geometry(m.contact).bodies.first].x;
    CHECK(std::abs(m.middle().x - x) < 1e-12);
    REQUIRE(m.mode);
    CHECK(m.connected);
    CHECK(m.aperture == sim.network().width(m.contact));
    CHECK(m.opening == near(m.aperture - 2e-5));
  }
  CHECK(in_joint == 10);
  CHECK(along_fracture == near(0.1));
  const auto of_joints =
      hfdem::measure::count(cracks, [](const hfdem::measure::Microcrack& m) { return m.in_joint; });
  const auto of_rock = hfdem::measure::count(
      cracks, [](const hfdem::measure::Microcrack& m) { return !m.in_joint; });
  CHECK(of_joints.connected.total() == 10);
  CHECK(of_joints.connected.shear > 0);
  CHECK(of_joints.connected.length == near(0.1));
  CHECK(of_rock.connected.preset == 4);
  CHECK(of_rock.total() + of_joints.total() == hfdem::measure::count(cracks).total());
  CHECK(hfdem::measure::crack_shape(sim).tip_up > 0.02);
}

// ---- stresses -----------------------------------------------------------------------------------

TEST_CASE("the mean stress of a jointed specimen is that on its sides, whatever its joints do") {
  hfdem::Specimen oblique = test::square(16);
  test::add_fracture(oblique, {0.03, 0.105}, {0.13, 0.145}, 1e-8);
  for (const auto& specimen : {test::fractured_square(), oblique})
    for (const double pressure : {0.0, 14e6}) {
      CAPTURE(pressure);
      Held sim(specimen, {.contact = {.tensile_strength = 1e9, .cohesion = 1e9},
                          .joints = test::weak_joint,
                          .boundary = {.kind = hfdem::BoundaryKind::dead_loads},
                          .in_situ = {.xx = 10e6, .yy = 12e6},
                          .mechanics = {.settle_tolerance = 1e-6},
                          .scheme = {.pressure = pressure}});
      for (int n = 0; n < 20 && !sim.step().converged;) ++n;
      REQUIRE(sim.step().converged);
      if (pressure > 0) CHECK(sim.breaks().size() >= 2);
      const auto stress = hfdem::measure::particle_stress(sim);
      hfdem::measure::StressTensor mean;
      const double count = static_cast<double>(stress.size());
      for (const auto& s : stress) {
        mean.xx += s.xx / count;
        mean.yy += s.yy / count;
        mean.xy += s.xy / count;
      }
      CHECK(mean.xx == near(10e6, 1e-5));
      CHECK(mean.yy == near(12e6, 1e-5));
      CHECK(std::abs(mean.xy) < 1e3);
    }
}

TEST_CASE("a fracture from side to side carries the stress across it evenly") {
  hfdem::Specimen s = test::square(12);
  test::add_fracture(s, {0, 0.09}, {0.12, 0.09}, 1e-8);
  using Dry = test::Fractured<hfdem::Dry>;
  const Dry sim(s, {.joints = {.w0 = 2e-5},
                    .in_situ = {.xx = 10e6, .yy = 12e6},
                    .crack = {.contacts = 0},
                    .mechanics = {.settle_tolerance = 1e-6}});
  CHECK(sim.joints().bonded() == 12);
  for (std::size_t k = 0; k < sim.joints().size(); ++k) {
    const auto response = sim.joints().contacts().response(k, sim.discs().displacement);
    CHECK(response.normal_stress == near(12e6, 1e-5));
    CHECK(sim.reaction(static_cast<Index>(sim.contacts().size() + k)).normal ==
          near(12e6 * 2 * test::radius, 1e-5));
  }
  for (const auto& stress : hfdem::measure::particle_stress(sim)) {
    CHECK(stress.xx == near(10e6, 1e-5));
    CHECK(stress.yy == near(12e6, 1e-5));
  }
}
