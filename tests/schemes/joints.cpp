// Natural fractures in a run: where the fluid goes, what it fills, and what is refused.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include <hfdem/pressure/dry.hpp>
#include <hfdem/pressure/held.hpp>
#include <hfdem/pressure/uniform.hpp>

#include <doctest/doctest.h>

#include "loops/jointed_rock.hpp"
#include "near.hpp"
#include "schemes/run_state.hpp"
#include "schemes/small_array.hpp"

namespace {

using hfdem::Index;
using hfdem::JointContent;
using hfdem::Network;
using hfdem::Vec2;
using test::near;

using Sim = test::Fractured<hfdem::UniformPressure>;
constexpr double pitch = 2 * test::radius;

Sim::Params params_of(JointContent content, double dilation_angle, bool equilibrium) {
  Sim::Params p{.joints = test::weak_joint,
                .injection = {.rate = 1e-3},
                .scheme = {.equilibrium = equilibrium}};
  p.joints.initially = content;
  p.joints.dilation_angle = dilation_angle;
  return p;
}

/// Which channels open ones connect to the injection, found by trying all until nothing changes.
std::vector<bool> reached(const Network& network) {
  const auto& channels = network.geometry().channels;
  std::vector<bool> wet(channels.size(), false), at(network.geometry().centre.size(), false);
  at[network.injection_domain()] = true;
  for (bool changed = true; changed;) {
    changed = false;
    for (Index c = 0; c < channels.size(); ++c) {
      const auto [left, right] = channels[c].domain;
      const auto is_at = [&](Index d) { return d != hfdem::nothing && at[d]; };
      if (wet[c] || !network.is_open(c) || !(is_at(left) || is_at(right))) continue;
      wet[c] = changed = true;
      for (const Index d : channels[c].domain)
        if (d != hfdem::nothing) at[d] = true;
    }
  }
  return wet;
}

/// How wide a joint across y is, from the motion of its discs: l_p and the width of the bond are
/// 2 R. `dilation` is part of the state.
double joint_width(const Sim& sim, std::size_t k) {
  const auto& p = sim.params();
  const auto [below, above] = sim.joints().pair(k).bodies;
  const double opening = sim.discs().displacement[above][1] - sim.discs().displacement[below][1];
  const double dilation = sim.joints().contacts().memory(k).dilation;
  if (opening > dilation) return p.joints.w0 + opening;
  const double shear = sim.discs().displacement[below][0] - sim.discs().displacement[above][0];
  const double slip = sim.joints().contacts().memory(k).slip;
  // Slip since the forces were last found has risen, too.
  const double rise = std::tan(p.joints.dilation_angle * std::numbers::pi / 180);
  const double stress = p.joints.normal_stiffness * (dilation - opening);
  const double excess =
      std::fmax(0,
                std::abs(p.joints.shear_stiffness * (slip - shear)) - p.joints.friction * stress) /
      (p.joints.shear_stiffness + p.joints.friction * p.joints.normal_stiffness * rise);
  const double force = (stress + p.joints.normal_stiffness * rise * excess) * pitch,
               F0 = p.aperture.F0;
  return (p.joints.w0 + dilation + rise * excess) * F0 / (force + F0);
}

/// How wide a channel of the rock is; its broken contact is a spring E without tension.
double rock_width(const Sim& sim, Index c) {
  const auto& p = sim.params();
  const auto [first, second] = sim.contacts().bodies(c);
  const std::size_t lane = second == first + 1 ? 0 : 1;
  const double opening =
      sim.discs().displacement[second][lane] - sim.discs().displacement[first][lane];
  const double force = -p.contact.E * opening, F0 = p.aperture.F0;
  return force > 0 ? p.aperture.w0 * F0 / (force + F0) : p.aperture.w0 + opening;
}

/// Sees how V_c and the pressure change where joints turn wet: in the middle of a mechanical step,
/// after breaks and before anything moves.
struct Connections {
  double volume_before = 0;  // V_c at the end of the mechanical step before
  std::size_t wet_before = 0;
  int joints = 0;       // that turned wet
  double jump = 0;      // of V_c at the last connection
  double expected = 0;  // l_p w of the joints that turned wet then

  template <class AnySim>
  void mechanical_step(const AnySim& sim) {
    const Network& network = sim.network();
    double volume = 0;
    int here = 0;
    for (const Index c : network.wet_channels().subspan(wet_before))
      if (sim.is_joint(c)) volume += pitch * network.width(c), ++here;
    joints += here;
    if (here == 0) return;
    jump = network.crack_volume() - volume_before;
    expected = volume;
  }
  /// To be called between mechanical steps.
  void look(const Sim& sim) {
    volume_before = sim.network().crack_volume();
    wet_before = sim.network().wet_channels().size();
  }
};

std::string refusal(const hfdem::Specimen& specimen, const Sim::Params& params) {
  try {
    const Sim sim(specimen, params);
  } catch (const hfdem::InvalidParameter& refused) {
    return refused.what();
  }
  return "accepted";
}

}  // namespace

// ---- where the fluid goes -----------------------------------------------------------------------

TEST_CASE("fluid is in a broken joint as soon as open channels connect it, and not before") {
  for (const JointContent content : {JointContent::dry, JointContent::filled}) {
    Sim sim(test::fractured_square(), params_of(content, 1, false));
    REQUIRE(sim.joints().bonded() == 10);
    int waiting = 0, wet = 0;
    for (int n = 0; n < 18; ++n) {
      sim.step();
      const Network& network = sim.network();
      const std::vector<bool> connected = reached(network);
      waiting = wet = 0;
      for (Index c = 0; c < connected.size(); ++c) {
        CHECK(network.is_wet(c) == connected[c]);
        if (!sim.is_joint(c)) continue;
        const auto& bond = sim.joints().contacts().stiffness(c - sim.contacts().size()).bond;
        CHECK(network.is_open(c) == (bond == 0));
        if (connected[c]) {
          ++wet;
          CHECK(network.width(c) > 0);
          for (const Index d : network.geometry().channels[c].domain)
            CHECK(network.pressure(d) == sim.injection_pressure());
        } else {
          waiting += network.is_open(c);
          CHECK(network.width(c) == 0);
        }
      }
      for (Index d = 0; d < network.pressures().size(); ++d) {
        const auto around = network.channels_of(d);
        const bool any_wet =
            std::any_of(around.begin(), around.end(), [&](Index c) { return network.is_wet(c); });
        if (!any_wet) CHECK(network.pressure(d) == 0);
      }
      if (n == 8) CHECK(waiting >= 4);
    }
    CHECK(wet == 10);
    CHECK(waiting == 0);
  }
}

TEST_CASE("a joint that is broken by hand far from the crack waits until it is connected") {
  const Sim sim(test::fractured_square(), params_of(JointContent::dry, 0, false));
  Network network = sim.network();
  const double before = network.crack_volume();
  const auto joint = [&](std::size_t k) { return static_cast<Index>(sim.contacts().size() + k); };
  network.open(joint(8));
  network.open(joint(7));
  CHECK_FALSE(network.is_wet(joint(8)));
  CHECK(network.width(joint(8)) == 0);
  CHECK(network.crack_volume() == before);
  for (Index c = 0; c < sim.contacts().size(); ++c) {  // the crack's way up: (7, row) to (8, row)
    const auto [first, second] = sim.contacts().bodies(c);
    if (first % 16 == 7 && second == first + 1 && first / 16 > 9 && first / 16 < 12)
      network.open(c);
  }
  CHECK_FALSE(network.is_wet(joint(7)));
  network.open(joint(6));
  network.open(joint(5));
  for (const std::size_t k : {5U, 6U, 7U, 8U}) {
    CHECK(network.is_wet(joint(k)));
    CHECK(network.width(joint(k)) == 2e-5);
    CHECK(network.filled_width(joint(k)) == 0);
  }
  CHECK_FALSE(network.is_wet(joint(4)));
  CHECK(network.crack_volume() == near(before + 4 * pitch * 2e-5));
}

// ---- volumes ------------------------------------------------------------------------------------

TEST_CASE("connecting dry joints takes their volume, and a full one takes nothing") {
  for (const JointContent content : {JointContent::dry, JointContent::filled}) {
    CAPTURE(static_cast<int>(content));
    auto params = params_of(content, 1, false);
    params.injection.rate = 1e-4;
    params.scheme.max_mechanical_steps = 1;
    Sim sim(test::fractured_square(), params);
    Connections connections;
    double pressure = 0;  // before they connect
    while (connections.joints == 0) {
      connections.look(sim);
      pressure = sim.injection_pressure();
      sim.step(connections);
    }
    CHECK(connections.joints >= 8);
    const double at_rest = connections.joints * pitch * params.joints.w0;
    CHECK(connections.expected < 0.9 * at_rest);  // they are pressed together
    CHECK(connections.expected > 0.3 * at_rest);
    if (content == JointContent::dry) {
      CHECK(connections.jump == near(connections.expected, 1e-10));
      REQUIRE(sim.network().crack_volume() > 1.1 * sim.injected_volume());
      CHECK(sim.injection_pressure() < pressure);
    } else {
      CHECK(std::abs(connections.jump) < 1e-14 * connections.expected);
    }
  }
}

TEST_CASE("the crack's volume is that of its displacements, in rock and in joints") {
  for (const JointContent content : {JointContent::dry, JointContent::filled})
    for (const double dilation_angle : {0.0, 1.0, 10.0}) {
      CAPTURE(dilation_angle);
      Sim sim(test::fractured_square(), params_of(content, dilation_angle, false));
      int joints = 0;
      bool open = false, closed = false;
      for (int n = 0; n < (content == JointContent::dry ? 45 : 18); ++n) {
        sim.step();
        const Network& network = sim.network();
        double volume = 0, size = 0;
        joints = 0;
        for (const Index c : network.wet_channels()) {
          double width = 0, filled = sim.params().aperture.w0;
          if (sim.is_joint(c)) {
            width = joint_width(sim, c - sim.contacts().size());
            filled = content == JointContent::dry ? 0 : network.filled_width(c);
            ++joints;
            (width > network.rest_width(c) ? open : closed) = true;
          } else {
            width = rock_width(sim, c);
          }
          volume += pitch * (width - filled);
          size += pitch * width;
        }
        CHECK(network.crack_volume() == near(volume, 1e-10).scale(size));
      }
      CHECK(joints == 10);
      CHECK(open);
      CHECK(closed);
    }
}

TEST_CASE("a crack that runs into dry joints lies half empty without pressure, until it is full") {
  Sim sim(test::fractured_square(), params_of(JointContent::dry, 0, true));
  const double tolerance = 1e-3;
  int half_empty = 0, full_before = 0, full_again = 0;
  for (int n = 0; n < 16; ++n) {
    const hfdem::FluidStep step = sim.step();
    const double volume = sim.network().crack_volume(), injected = sim.injected_volume();
    CHECK(step.converged);
    CHECK(step.unbalanced_ratio < 1e-3);
    if (sim.injection_pressure() == 0) {
      ++half_empty;
      CHECK(volume > injected);
      CHECK(full_again == 0);
      if (half_empty > 1) CHECK(step.mechanical_steps < 100);  // nothing is left to be found
    } else {
      ++(half_empty > 0 ? full_again : full_before);
      CHECK(std::abs(volume - injected) <= tolerance * injected);
    }
  }
  CHECK(full_before >= 4);
  CHECK(half_empty >= 2);
  CHECK(full_again >= 4);
  CHECK(sim.injection_pressure() > 5e6);
}

// ---- bits ---------------------------------------------------------------------------------------

TEST_CASE("a run with breaking joints gives the same bits with any number of threads") {
  const auto run = [](int threads) {
    hfdem::Specimen s = test::square(40);
    test::add_fracture(s, {0.13, 0.225}, {0.27, 0.235}, 1e-8);
    Sim sim(s, params_of(JointContent::dry, 5, false));
    sim.use_threads(threads);
    int joints = 0;
    for (int n = 0; n < 16; ++n) sim.step();
    for (const auto& b : sim.breaks()) joints += sim.is_joint(b.contact);
    CHECK(joints >= 4);
    return test::state(sim);
  };
  const auto alone = run(1);
  for (const int threads : {2, 3, 5}) CHECK(run(threads) == alone);
}

TEST_CASE("a law with joints gives a specimen without any the bits of the law without them") {
  for (const bool equilibrium : {false, true}) {
    test::Injected plain(test::square(20),
                         {.injection = {.rate = 5e-4}, .scheme = {.equilibrium = equilibrium}});
    Sim jointed(test::square(20), {.joints = test::weak_joint,
                                   .injection = {.rate = 5e-4},
                                   .scheme = {.equilibrium = equilibrium}});
    for (int n = 0; n < 40; ++n) plain.step(), jointed.step();
    CHECK(plain.breaks().size() >= 4);
    CHECK(test::state(jointed) == test::state(plain));
  }
}

// ---- what is refused ----------------------------------------------------------------------------

TEST_CASE("a specimen with fractures needs a law with joints") {
  CHECK_THROWS_WITH_AS(
      test::Injected(test::fractured_square(), {}),
      "specimen.joints = 1 fractures is not allowed: it must be empty for a contact law without "
      "joints; Jointed<law, SmoothJoint> has them",
      hfdem::InvalidParameter);
}

TEST_CASE("a fracture through the preset crack or the injection is refused by its number") {
  CHECK(refusal(test::fractured_square(), {}) == "accepted");
  hfdem::Specimen along = test::fractured_square();
  test::add_fracture(along, {0.08, 0.095}, {0.08, 0.15}, 1e-3);
  CHECK(refusal(along, {}) ==
        "specimen.joints = fracture 1 from [0.08, 0.095] to [0.08, 0.15] m is not allowed: it must "
        "be away from the preset crack");
  CHECK(refusal(along, {.crack = {.contacts = 2}}) == "accepted");
  hfdem::Specimen through = test::square(16);
  test::add_fracture(through, {0.03, 0.08}, {0.0755, 0.08}, 1e-3);
  CHECK(refusal(through, {}) ==
        "specimen.joints = fracture 0 from [0.03, 0.08] to [0.0755, 0.08] m is not allowed: it "
        "must be away from the injection");
  // The same of a further point.
  const auto at = [](hfdem::Vec2 point, hfdem::PresetCrack crack) {
    return refusal(test::fractured_square(),
                   {.crack = crack, .injection = {.further_points = {point}}});
  };
  CHECK(at({0.06, 0.10}, {.contacts = 2}) == "accepted");
  const std::string crossing =
      "specimen.joints = fracture 0 from [0.03, 0.12] to [0.13, 0.12] m is not allowed: it must be "
      "away from the ";
  CHECK(at({0.06, 0.12}, {.contacts = 1}) == crossing + "injection");
}

TEST_CASE("parameters of joints outside their range are refused under joints") {
  const auto with = [](const hfdem::SmoothJoint::Params& joints) {
    return refusal(test::fractured_square(), {.joints = joints});
  };
  CHECK(with({.normal_stiffness = 0}) ==
        "joints.normal_stiffness = 0 Pa/m is not allowed: it must be greater than 0 Pa/m");
  CHECK(with({.tensile_strength = -1}).starts_with("joints.tensile_strength = -1 Pa"));
  CHECK(with({.dilation_angle = 61}) ==
        "joints.dilation_angle = 61 deg is not allowed: it must be at least 0 deg and at most 60 "
        "deg");
  CHECK(with({.w0 = std::nan("")}).starts_with("joints.w0 = nan m"));
}
