// From the motion of two discs to the forces on them, through the rows of the contact loop: the
// geometry must neither make nor lose force, torque or energy.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>

#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/state/contact.hpp>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "laws/sample_rock.hpp"
#include "near.hpp"

namespace {

using hfdem::Pack;
using hfdem::Vec2;
using test::near;

constexpr double first_arm = 3.1e-3, second_arm = 5.2e-3;

hfdem::Frame<double> frame_along(Vec2 normal) {
  return {normal.x, normal.y, (first_arm + second_arm) / 2, (second_arm - first_arm) / 2};
}

struct Body {
  Vec2 xy;
  double turn;  // rotation, or torque
};
using Both = std::array<Body, 2>;

/// Four lanes; as numbers, because functions of this file may be called without being inlined, and
/// packs are passed differently with and without AVX.
using Row = std::array<double, 4>;

Row difference_row(const Both& moved) {
  const auto& [first, second] = moved;
  const Pack row_first{first.xy.x, first.xy.y, first.turn, first.turn};
  const Pack row_second{second.xy.x, second.xy.y, second.turn, second.turn};
  return std::bit_cast<Row>(hfdem::difference_row(row_first, row_second));
}

hfdem::Motion<double> motion_of(const hfdem::Frame<double>& frame, const Both& moved) {
  const auto [dx, dy, rotation, rotation_sum] = difference_row(moved);
  return frame.motion(dx, dy, rotation, rotation_sum);
}

Row force_row(const hfdem::Frame<double>& frame, const hfdem::Reaction<double>& reaction) {
  Row row;
  frame.force(reaction, row[0], row[1], row[2], row[3]);
  return row;
}

/// The forces and torques on both discs.
Both loads_of(const hfdem::Frame<double>& frame, const hfdem::Reaction<double>& reaction) {
  const auto load = [](const Row& row) { return Body{{row[0], row[1]}, row[2] + row[3]}; };
  const Row row = force_row(frame, reaction);
  return {load(std::bit_cast<Row>(hfdem::of_first * std::bit_cast<Pack>(row))), load(row)};
}

// No slip: what is loaded elastically must come back.
const test::Bond elastic_law = [] {
  auto params = test::sample_rock;
  params.friction = 1e3;
  return test::Bond(params);
}();
const auto stiffness = elastic_law.stiffness(test::small_disc, test::large_disc);

Both forces(const hfdem::Frame<double>& frame, const Both& moved) {
  return loads_of(frame, elastic_law.respond(stiffness, {}, motion_of(frame, moved)).reaction());
}

Vec2 turned(Vec2 v, double angle) {
  return {std::cos(angle) * v.x - std::sin(angle) * v.y,
          std::sin(angle) * v.x + std::cos(angle) * v.y};
}

/// Pressed together along `normal`, sheared and rolled.
Both pressed_discs(Vec2 normal, test::Random& random) {
  const auto some = [&] { return random(-1e-6, 1e-6); };
  return {{{3e-6 * normal + Vec2{some(), some()}, random(-1e-4, 1e-4)},
           {-3e-6 * normal + Vec2{some(), some()}, random(-1e-4, 1e-4)}}};
}

}  // namespace

TEST_CASE("opening is along the normal, shear to its left, arms carry the rotations") {
  const auto along_y = frame_along({0, 1});
  const auto pulled = motion_of(along_y, {{{{0, 0}, 0}, {{0, 2e-6}, 0}}});
  CHECK(pulled.opening == near(2e-6));
  CHECK(pulled.shear == 0);

  const auto slid = motion_of(along_y, {{{{3e-6, 0}, 0}, {{1e-6, 0}, 0}}});
  CHECK(slid.opening == 0);
  CHECK(slid.shear == near(2e-6));  // the left of up is -x

  const auto first_turned = motion_of(along_y, {{{{0, 0}, 1e-3}, {{0, 0}, 0}}});
  CHECK(first_turned.shear == near(-first_arm * 1e-3));
  CHECK(first_turned.rotation == near(-1e-3));
  const auto second_turned = motion_of(along_y, {{{{0, 0}, 0}, {{0, 0}, 1e-3}}});
  CHECK(second_turned.shear == near(-second_arm * 1e-3));
  CHECK(second_turned.rotation == near(1e-3));
}

TEST_CASE("a rotation of both discs about any point loads nothing") {
  const Vec2 normal = turned({1, 0}, 0.7), first{0.2, -0.1};
  const Vec2 second = first + (first_arm + second_arm) * normal;
  for (const Vec2 pivot : {Vec2{0, 0}, Vec2{0.3, 0.4}, first}) {
    constexpr double angle = 1e-3;
    const Both moved{{{angle * hfdem::left_of(first - pivot), angle},
                      {angle * hfdem::left_of(second - pivot), angle}}};
    const auto motion = motion_of(frame_along(normal), moved);
    const double scale = angle * (first_arm + second_arm);
    CHECK(std::abs(motion.opening) < 1e-12 * scale);
    CHECK(std::abs(motion.shear) < 1e-12 * scale);
    CHECK(motion.rotation == 0);
  }
}

TEST_CASE("forces on both discs balance, and so do the torques about any point") {
  test::Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const Vec2 normal = turned({1, 0}, random(-3.2, 3.2));
    const auto loads =
        loads_of(frame_along(normal), {random(-1e5, 1e5), random(-1e5, 1e5), random(-1e2, 1e2)});
    CHECK(loads[0].xy.x == -loads[1].xy.x);
    CHECK(loads[0].xy.y == -loads[1].xy.y);

    const Vec2 about{random(-0.1, 0.1), random(-0.1, 0.1)};
    const Vec2 first{0.05, 0.03}, second = first + (first_arm + second_arm) * normal;
    const double torque = cross(first - about, loads[0].xy) + loads[0].turn +
                          cross(second - about, loads[1].xy) + loads[1].turn;
    CHECK(std::abs(torque) < 1e-13 * 0.1 * 1e5);
  }
}

TEST_CASE("a reaction acts on the discs as it says") {
  const auto pushed = loads_of(frame_along({0, 1}), {.normal = 5, .shear = 0, .moment = 0});
  CHECK(pushed[1].xy == Vec2{0, 5});
  const auto rubbed = loads_of(frame_along({0, 1}), {.normal = 0, .shear = 7, .moment = 0});
  CHECK(rubbed[1].xy == Vec2{-7, 0});
  CHECK(rubbed[0].turn == near(-7 * first_arm));
  CHECK(rubbed[1].turn == near(-7 * second_arm));
  const auto bent = loads_of(frame_along({0, 1}), {.normal = 0, .shear = 0, .moment = 3});
  CHECK(bent[0].turn == 3);
  CHECK(bent[1].turn == -3);
}

TEST_CASE("force row and difference row do the work of reaction and motion") {
  test::Random random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const auto frame = frame_along(turned({1, 0}, random(-3.2, 3.2)));
    const Both moved = pressed_discs({frame.normal_x, frame.normal_y}, random);
    const hfdem::Reaction<double> reaction{random(1e3, 1e5), random(1e3, 1e5), random(10, 1e2)};
    const Row force = force_row(frame, reaction), difference = difference_row(moved);
    const auto motion = motion_of(frame, moved);
    const double expected = reaction.normal * motion.opening + reaction.shear * motion.shear -
                            reaction.moment * motion.rotation;
    const double work = std::inner_product(force.begin(), force.end(), difference.begin(), 0.0);
    CHECK(work == near(expected).scale(0.1));
  }
}

TEST_CASE("turning the whole contact turns the forces and nothing else") {
  test::Random random(3);
  for (const double angle : {0.3, 1.5, 2.6, -2.0}) {
    const Vec2 normal = turned({1, 0}, 0.4);
    const Both moved = pressed_discs(normal, random);
    const Both moved_turned{
        {{turned(moved[0].xy, angle), moved[0].turn}, {turned(moved[1].xy, angle), moved[1].turn}}};
    const Both plain = forces(frame_along(normal), moved);
    const Both rotated = forces(frame_along(turned(normal, angle)), moved_turned);
    const double force = norm(plain[0].xy);
    for (const std::size_t side : {0U, 1U}) {
      CHECK(norm(rotated[side].xy - turned(plain[side].xy, angle)) < 1e-12 * force);
      CHECK(std::abs(rotated[side].turn - plain[side].turn) < 1e-12 * force * second_arm);
    }
  }
}

TEST_CASE("a closed elastic path of two bonded discs gives back all work") {
  test::Random random(4);
  const Vec2 normal = turned({1, 0}, 0.9);
  const auto frame = frame_along(normal);
  std::array<Both, 7> corner;
  for (Both& moved : corner) moved = pressed_discs(normal, random);

  double work = 0, largest_leg = 0;
  for (std::size_t k = 0; k < corner.size(); ++k) {
    const Both &from = corner[k], &to = corner[(k + 1) % corner.size()];
    Both middle;
    for (const std::size_t side : {0U, 1U})
      middle[side] = {0.5 * (from[side].xy + to[side].xy), (from[side].turn + to[side].turn) / 2};
    const Both load = forces(frame, middle);  // linear while pressed: the middle is the mean
    double leg = 0;
    for (const std::size_t side : {0U, 1U})
      leg -= dot(load[side].xy, to[side].xy - from[side].xy) +
             load[side].turn * (to[side].turn - from[side].turn);
    work += leg;
    largest_leg = std::max(largest_leg, std::abs(leg));
  }
  CHECK(largest_leg > 1e-3);  // J/m: it does cost something on the way
  CHECK(std::abs(work) < 1e-13 * largest_leg);
}

TEST_CASE("pressing, shearing and rolling a bonded contact stores the springs' energy") {
  test::Random random(5);
  const auto frame = frame_along({0.6, 0.8});
  const Both moved = pressed_discs({0.6, 0.8}, random);
  const Both load = forces(frame, moved);
  double work = 0;  // along the straight way from rest, where all forces grow in proportion
  for (const std::size_t side : {0U, 1U})
    work -= (dot(load[side].xy, moved[side].xy) + load[side].turn * moved[side].turn) / 2;
  const auto m = motion_of(frame, moved);
  const hfdem::Springs k = elastic_law.springs(stiffness);
  CHECK(work == near((k.normal * m.opening * m.opening + k.shear * m.shear * m.shear +
                      k.moment * m.rotation * m.rotation) /
                     2));
}
