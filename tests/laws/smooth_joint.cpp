// The smooth joint on one contact: stiffness per metre, strength, slip, dilation, and what it
// costs.
#include <array>
#include <cmath>

#include <hfdem/base/pack.hpp>
#include <hfdem/contact/smooth_joint.hpp>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "laws/sample_joint.hpp"
#include "laws/sample_rock.hpp"
#include "near.hpp"

namespace {

using hfdem::Vec2;
using test::bits;
using test::Joint;
using test::Move;
using test::near;
using test::sample_joint;
namespace joint = test::joint;

const Joint law(sample_joint);
const Joint flat = [] {  // it does not dilate
  auto params = sample_joint;
  params.dilation_angle = 0;
  return Joint(params);
}();
const auto bonded = law.stiffness(joint::length);
const auto broken = law.broken(bonded);

Joint::Response<double> respond(const Joint::Stiffness<double>& k, const Move& motion) {
  return law.respond<double>(k, {}, motion);
}

/// A broken joint led along a path of motions.
class Path {
 public:
  explicit Path(const Joint& its_law, double length = joint::length)
      : law_(its_law), k_(its_law.broken(its_law.stiffness(length))) {}

  /// Leads it straight to a new motion in equal steps; the trapezoidal rule gives the work exactly
  /// where the kinks of the forces lie on steps.
  Joint::Response<double> lead_to(const Move& end, int steps = 1) {
    const Move start = motion_;
    for (int n = 1; n <= steps; ++n) {
      const double share = static_cast<double>(n) / steps;
      const Move next{start.opening + share * (end.opening - start.opening),
                      start.shear + share * (end.shear - start.shear)};
      const auto response = law_.respond<double>(k_, memory_, next);
      const auto r = response.reaction();
      work_ -= (r.normal + last_.normal) / 2 * (next.opening - motion_.opening) +
               (r.shear + last_.shear) / 2 * (next.shear - motion_.shear);
      memory_ = response.memory;
      motion_ = next;
      last_ = r;
    }
    return law_.respond<double>(k_, memory_, motion_);
  }

  double work() const { return work_; }  // done on the joint, J per m
  double stored() const { return law_.energy<double>(k_, memory_, motion_); }
  double slip() const { return law_.slip(memory_); }
  double dilation() const { return law_.dilation(memory_); }

 private:
  Joint law_;
  Joint::Stiffness<double> k_;
  Joint::Memory<double> memory_{};
  Move motion_;
  hfdem::Reaction<double> last_{};
  double work_ = 0;
};

/// Forces on both discs of a joint contact across `normal`, as the contact loop finds them.
struct Forces {
  Vec2 on_first, on_second;
};
Forces forces(Vec2 normal, Vec2 first_moves, Vec2 second_moves) {
  const hfdem::Frame<double> frame{normal.x, normal.y, 0, 0};
  const Vec2 d = second_moves - first_moves;
  const auto r = law.respond(broken, {}, frame.motion(d.x, d.y, 1e-3, 2e-3)).reaction();
  Vec2 force;
  double torque_difference = 1, torque_sum = 1;
  frame.force(r, force.x, force.y, torque_difference, torque_sum);
  CHECK(torque_difference == 0);
  CHECK(torque_sum == 0);
  return {-force, force};
}

}  // namespace

// ---- stiffness ----------------------------------------------------------------------------------

TEST_CASE("a joint contact is as stiff as its length of fracture") {
  CHECK(respond(bonded, {.opening = -2e-6}).normal_stress == near(joint::k_n * 2e-6));
  CHECK(respond(bonded, {.opening = 2e-6}).normal_stress == near(-joint::k_n * 2e-6));
  for (const double shear : {2e-6, -2e-6})
    CHECK(respond(bonded, {.shear = shear}).shear_stress == near(-joint::k_s * shear));

  const auto r = respond(bonded, {.opening = -2e-6, .shear = 3e-6}).reaction();
  CHECK(r.normal == near(joint::length * joint::k_n * 2e-6));
  CHECK(r.shear == near(-joint::length * joint::k_s * 3e-6));

  for (const auto& k : {bonded, broken}) {
    const hfdem::Springs springs = law.springs(k);
    CHECK(springs.normal == near(joint::length * joint::k_n));
    CHECK(springs.shear == near(joint::length * joint::k_s));
    CHECK(springs.moment == 0);
  }
}

TEST_CASE("the length of a joint contact scales its forces and not its stresses") {
  const auto longer = law.with_length(broken, 2.5 * joint::length);
  CHECK(longer.bond == 0);
  CHECK(law.with_length(bonded, 1).bond == 1);
  const Joint::Memory<double> memory{.slip = 1e-6, .dilation = 2e-6};
  const Move motion{.opening = -3e-6, .shear = 9e-6};
  const auto one = law.respond<double>(broken, memory, motion);
  const auto other = law.respond<double>(longer, memory, motion);
  CHECK(other.normal_stress == one.normal_stress);
  CHECK(other.shear_stress == one.shear_stress);
  CHECK(other.memory.slip == one.memory.slip);
  CHECK(other.memory.dilation == one.memory.dilation);
  CHECK(other.reaction().normal == near(2.5 * one.reaction().normal));
  CHECK(other.reaction().shear == near(2.5 * one.reaction().shear));
  CHECK(law.energy<double>(longer, memory, motion) ==
        near(2.5 * law.energy<double>(broken, memory, motion)));

  const auto unmet = law.respond<double>(law.broken(law.stiffness(0)), memory, motion);
  CHECK(unmet.reaction().normal == 0);
  CHECK(unmet.reaction().shear == 0);
  CHECK(unmet.memory.slip == one.memory.slip);
}

TEST_CASE("a joint feels no rotation and has no moment") {
  for (const auto& k : {bonded, broken}) {
    const auto still = respond(k, {.opening = -2e-6, .shear = 5e-6});
    const auto turned = respond(k, {.opening = -2e-6, .shear = 5e-6, .rotation = 1e-2});
    CHECK(turned.normal_stress == still.normal_stress);
    CHECK(turned.shear_stress == still.shear_stress);
    CHECK(turned.reaction().moment == 0);
  }
}

TEST_CASE("a joint tells its aperture and what is in it") {
  CHECK(law.rest_width() == 8e-5);
  CHECK(law.initially() == hfdem::JointContent::filled);
  CHECK(Joint({}).initially() == hfdem::JointContent::dry);
}

// ---- strength -----------------------------------------------------------------------------------

TEST_CASE("a joint's bond breaks in tension at its strength, whatever its length") {
  const double at_strength = joint::tensile_strength / joint::k_n;
  for (const double length : {1e-4, joint::length, 3.0}) {
    const auto k = law.stiffness(length);
    const auto fails = [&](double factor) {
      return law.failure(k, respond(k, {.opening = factor * at_strength}));
    };
    CHECK_FALSE(fails(1 - 1e-12).tension);
    CHECK(fails(1 + 1e-12).tension);
    CHECK_FALSE(fails(1 + 1e-12).shear);
    CHECK_FALSE(fails(-1e3).tension);  // however hard it is pressed
  }
}

TEST_CASE(
    "a joint's bond breaks in shear at cohesion plus friction, which tension does not lower") {
  for (const double normal : {0.0, 0.5e6, 20e6, -0.9 * joint::tensile_strength}) {
    const double strength = joint::cohesion + joint::friction * std::fmax(0, normal);
    for (const double way : {1.0, -1.0}) {
      const auto fails = [&](double factor) {
        const Move motion{.opening = -normal / joint::k_n,
                          .shear = way * factor * strength / joint::k_s};
        return law.failure(bonded, respond(bonded, motion));
      };
      CHECK_FALSE(fails(1 - 1e-12).shear);
      CHECK(fails(1 + 1e-12).shear);
      CHECK_FALSE(fails(1 + 1e-12).tension);
    }
  }
}

TEST_CASE("while the bond holds nothing slips and nothing dilates") {
  const auto r = respond(bonded, {.opening = -1e-6, .shear = 1e-3});
  CHECK(r.memory.slip == 0);
  CHECK(r.memory.dilation == 0);
}

TEST_CASE("a joint whose bond has broken cannot break again, however weak the bond was") {
  auto params = sample_joint;
  params.tensile_strength = params.cohesion = params.friction = 0;
  const Joint weak(params);
  for (const Move& motion :
       {Move{}, Move{.opening = 1e-3, .shear = 1e-3}, Move{.opening = -1e-3, .shear = 1e-3}}) {
    const auto failure = weak.failure(broken, weak.respond<double>(broken, {}, motion));
    CHECK_FALSE(failure.tension);
    CHECK_FALSE(failure.shear);
  }
  CHECK(weak.failure(bonded, weak.respond<double>(bonded, {}, Move{.shear = 1e-9})).shear);
}

// ---- slip ---------------------------------------------------------------------------------------

TEST_CASE("a broken joint presses and rubs, but does not pull") {
  const auto open = respond(broken, {.opening = 1e-6, .shear = 1e-3});
  CHECK(open.normal_stress == 0);
  CHECK(open.shear_stress == near(0).scale(joint::k_s * 1e-3));
  CHECK(open.memory.slip == near(1e-3));
  CHECK(respond(broken, {.opening = -2e-6}).normal_stress == near(joint::k_n * 2e-6));
}

TEST_CASE("the shear stress of a broken joint ends at friction times its normal stress") {
  const double pressed = 5e-6, limit = joint::friction * joint::k_n * pressed;
  const double slips_at = limit / joint::k_s;
  for (const double way : {1.0, -1.0}) {
    const auto at = [&](double factor) {
      return flat.respond<double>(broken, {},
                                  Move{.opening = -pressed, .shear = way * factor * slips_at});
    };
    CHECK(at(0.5).shear_stress == near(-way * 0.5 * limit));
    CHECK(at(1 - 1e-9).memory.slip == 0);
    CHECK(at(1.5).shear_stress == near(-way * limit));
    CHECK(at(1.5).memory.slip == near(way * 0.5 * slips_at));
    CHECK(at(1e4).shear_stress == near(-way * limit, 1e-10));
    CHECK(at(1e4).normal_stress == near(joint::k_n * pressed));
  }
}

TEST_CASE("a joint that has slipped unloads elastically, and slips back at the limit") {
  const double pressed = 5e-6, limit = joint::friction * joint::k_n * pressed;
  const double slips_at = limit / joint::k_s;
  Path path(flat);
  const auto shear_to = [&](double factor) {
    return path.lead_to({.opening = -pressed, .shear = factor * slips_at}).shear_stress;
  };
  CHECK(shear_to(3) == near(-limit));
  CHECK(path.slip() == near(2 * slips_at));
  CHECK(shear_to(2.5) == near(-0.5 * limit));
  CHECK(shear_to(1.5) == near(0.5 * limit));
  CHECK(path.slip() == near(2 * slips_at));
  CHECK(shear_to(0) == near(limit));
  CHECK(path.slip() == near(slips_at));
  CHECK(shear_to(0.75) == near(0.25 * limit));
  CHECK(path.dilation() == 0);
}

TEST_CASE("a closed path of a joint costs the friction over its slip") {
  const double pressed = 5e-6, limit = joint::friction * joint::k_n * pressed;
  const double slips_at = limit / joint::k_s;
  Path path(flat);
  const auto shear_to = [&](double factor, int distances) {
    path.lead_to({.opening = -pressed, .shear = factor * slips_at}, 8 * distances);
  };
  path.lead_to({.opening = -pressed});
  shear_to(1, 1);
  CHECK(path.work() == near(path.stored()));  // nothing has slipped
  shear_to(3, 2);
  shear_to(-3, 6);
  shear_to(1, 4);
  shear_to(0, 1);  // elastic the whole way back
  path.lead_to({});
  // It has slipped by two, four and two slip distances.
  CHECK(path.work() - path.stored() == near(joint::length * limit * 8 * slips_at, 1e-11));
  CHECK(path.slip() == near(0).scale(slips_at));
}

// ---- dilation -----------------------------------------------------------------------------------

TEST_CASE("a joint that is held shut presses harder while it slips, as its rise demands") {
  const double pressed = 5e-6, at_first = joint::k_n * pressed, shear = 30e-6;
  const double slip = (joint::k_s * shear - joint::friction * at_first) /
                      (joint::k_s + joint::friction * joint::k_n * joint::rise);
  const double normal = at_first + joint::k_n * joint::rise * slip;
  for (const double way : {1.0, -1.0})
    for (const int steps : {1, 7, 1000}) {  // as many as one likes
      Path path(law);
      path.lead_to({.opening = -pressed});
      const auto r = path.lead_to({.opening = -pressed, .shear = way * shear}, steps);
      CHECK(path.slip() == near(way * slip, 1e-11));
      CHECK(path.dilation() == near(joint::rise * slip, 1e-11));
      CHECK(r.normal_stress == near(normal, 1e-11));
      CHECK(r.shear_stress == near(-way * joint::friction * normal, 1e-11));
    }
}

TEST_CASE("a joint under a constant load rises by the tangent of its angle over its slip") {
  const double pressed = 5e-6, slips_at = joint::friction * joint::k_n * pressed / joint::k_s;
  Path path(law);
  path.lead_to({.opening = -pressed, .shear = slips_at});
  CHECK(path.dilation() == 0);
  for (int n = 1; n <= 2000; ++n) {
    const double slip = n * 1e-9;
    const Move on_its_load{.opening = joint::rise * slip - pressed, .shear = slips_at + slip};
    CHECK(path.lead_to(on_its_load).normal_stress == near(joint::k_n * pressed, 1e-9));
  }
  CHECK(path.slip() == near(2e-6, 1e-9));
  CHECK(path.dilation() == near(joint::rise * 2e-6, 1e-9));
}

TEST_CASE("an open joint slides without rising") {
  Path path(law);
  path.lead_to({.opening = 1e-6});
  path.lead_to({.opening = 1e-6, .shear = 5e-6});
  CHECK(path.slip() == near(5e-6));
  CHECK(path.dilation() == 0);
  const auto closed = path.lead_to({.opening = -2e-6, .shear = 5e-6});
  CHECK(closed.normal_stress == near(joint::k_n * 2e-6));
  CHECK(closed.shear_stress == near(0).scale(joint::k_s * 5e-6));
}

TEST_CASE("what has risen stays up, and holds the walls apart by so much") {
  Path path(law);
  path.lead_to({.opening = -5e-6});
  path.lead_to({.opening = -5e-6, .shear = 30e-6});
  const double there = path.dilation();
  CHECK(there > 1e-6);
  CHECK(path.lead_to({.opening = 1.01 * there, .shear = 30e-6}).normal_stress == 0);
  CHECK(path.lead_to({.opening = 0.75 * there, .shear = 30e-6}).normal_stress ==
        near(joint::k_n * 0.25 * there));
  CHECK(path.dilation() == there);
  path.lead_to({.opening = -5e-6, .shear = -30e-6});
  CHECK(path.dilation() > 1.5 * there);  // the way back wears nothing off
}

TEST_CASE("friction holds exactly under the stress after the rise, on any path") {
  test::Random random(1);
  int slipped = 0;
  for (int trial = 0; trial < 50; ++trial) {
    Path path(law);
    for (int step = 0; step < 20; ++step) {
      const double slip = path.slip(), rise = path.dilation();
      const Move motion{.opening = random(-8e-6, 2e-6), .shear = random(-2e-5, 2e-5)};
      const auto r = path.lead_to(motion);
      const double moved = std::abs(path.slip() - slip);
      CHECK(r.normal_stress ==
            near(std::fmax(0, joint::k_n * (path.dilation() - motion.opening)), 1e-10).scale(1));
      CHECK(std::abs(r.shear_stress) <= joint::friction * r.normal_stress * (1 + 1e-10) + 1e-6);
      if (moved == 0 || r.normal_stress == 0) continue;
      ++slipped;
      CHECK(std::abs(r.shear_stress) == near(joint::friction * r.normal_stress, 1e-9));
      CHECK(path.dilation() - rise == near(joint::rise * moved, 1e-9));
      CHECK((path.slip() > slip) == (r.shear_stress < 0));  // friction is against the slip
    }
  }
  CHECK(slipped > 300);
}

TEST_CASE("what a joint that rises spends is friction less the work of its rise") {
  const double pressed = 5e-6, at_first = joint::k_n * pressed;
  const double slips_at = joint::friction * at_first / joint::k_s;
  Path path(law);
  path.lead_to({.opening = -pressed});
  path.lead_to({.opening = -pressed, .shear = slips_at});
  CHECK(path.work() == near(path.stored()));
  path.lead_to({.opening = -pressed, .shear = 4 * slips_at}, 3);
  const double slip = path.slip();
  const double stress_over_slip = at_first * slip + joint::k_n * joint::rise * slip * slip / 2;
  CHECK(path.work() - path.stored() ==
        near(joint::length * (joint::friction - joint::rise) * stress_over_slip, 1e-11));
}

// ---- frames and packs ---------------------------------------------------------------------------

TEST_CASE("turning the joint turns its forces, and swapping its sides swaps them") {
  const auto turned = [](Vec2 v, double angle) {
    return Vec2{std::cos(angle) * v.x - std::sin(angle) * v.y,
                std::sin(angle) * v.x + std::cos(angle) * v.y};
  };
  const Vec2 normal{0.6, 0.8}, first{2e-6, -1e-6}, second{-3e-6, -9e-6};
  const Forces plain = forces(normal, first, second);
  CHECK(norm(plain.on_second) > 1e3);
  for (const double angle : {0.3, 1.5, 2.6, -2.0}) {
    const Forces f = forces(turned(normal, angle), turned(first, angle), turned(second, angle));
    CHECK(norm(f.on_second - turned(plain.on_second, angle)) < 1e-12 * norm(plain.on_second));
  }
  const Forces swapped = forces(-normal, second, first);
  CHECK(swapped.on_first == plain.on_second);
  CHECK(swapped.on_second == plain.on_first);
}

TEST_CASE("a joint gives four contacts the bits that it gives each alone") {
  test::Random random(2);
  const auto some = [&](double size) {
    const double chance = random(0, 1);
    if (chance < 0.1) return chance < 0.05 ? 0.0 : -0.0;
    return random(-size, size);
  };
  hfdem::PackedColumn<Joint::Stiffness> stiffness(4);
  hfdem::PackedColumn<Joint::Memory> memory(4);
  hfdem::PackedColumn<hfdem::Motion> motion(4);
  int in_tension = 0, in_shear = 0, slipped = 0, risen = 0;
  for (int trial = 0; trial < 500; ++trial) {
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const auto k = law.stiffness(random(0, 1) < 0.1 ? 0 : random(1e-3, 1e-2));
      stiffness.set(lane, random(0, 1) < 0.5 ? law.broken(k) : k);
      memory.set(lane, {some(2e-5), std::abs(some(4e-6))});
      motion.set(lane, {some(8e-6), some(2e-5), some(1e-3)});
    }
    const auto four = law.respond(stiffness.block(0), memory.block(0), motion.block(0));
    const auto energies = law.energy(stiffness.block(0), memory.block(0), motion.block(0));
    const auto failures = law.failure(stiffness.block(0), four);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const auto one = law.respond(stiffness[lane], memory[lane], motion[lane]);
      const auto its = hfdem::PackedColumn<Joint::Response>::lane(four, lane);
      CHECK(bits(one.normal_stress) == bits(its.normal_stress));
      CHECK(bits(one.shear_stress) == bits(its.shear_stress));
      CHECK(bits(one.memory.slip) == bits(its.memory.slip));
      CHECK(bits(one.memory.dilation) == bits(its.memory.dilation));
      CHECK(bits(one.reaction().normal) == bits(four.reaction().normal[lane]));
      CHECK(bits(one.reaction().shear) == bits(four.reaction().shear[lane]));
      CHECK(bits(law.energy(stiffness[lane], memory[lane], motion[lane])) == bits(energies[lane]));
      const auto failure = law.failure(stiffness[lane], one);
      CHECK(failure.tension == (failures.tension[lane] != 0));
      CHECK(failure.shear == (failures.shear[lane] != 0));
      in_tension += failure.tension;
      in_shear += failure.shear;
      slipped += one.memory.slip != memory[lane].slip;
      risen += one.memory.dilation != memory[lane].dilation;
    }
  }
  for (const int count : {in_tension, in_shear, slipped, risen}) {
    CHECK(count > 50);
    CHECK(count < 1900);
  }
}
