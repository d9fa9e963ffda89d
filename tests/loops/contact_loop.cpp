// The contact loop and the force rows against plain sums over all pairs.
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "laws/sample_rock.hpp"
#include "loops/assembly.hpp"
#include "loops/textbook.hpp"

namespace {

using hfdem::Vec2;

Vec2 force_on(const hfdem::ForceRows& rows, std::size_t body) {
  const hfdem::Pack total = rows.total(body);
  return {total[0], total[1]};
}
double torque_on(const hfdem::ForceRows& rows, std::size_t body) {
  const hfdem::Pack total = rows.total(body);
  return total[2] + total[3];
}

/// The largest difference over all bodies, relative to the largest value.
struct Difference {
  double force = 0, torque = 0;
};
Difference difference(const hfdem::ForceRows& rows, const std::vector<test::Load>& expected) {
  double largest_force = 0, largest_torque = 0;
  Difference worst;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    largest_force = std::fmax(largest_force, norm(expected[i].force));
    largest_torque = std::fmax(largest_torque, std::abs(expected[i].torque));
    worst.force = std::fmax(worst.force, norm(force_on(rows, i) - expected[i].force));
    worst.torque = std::fmax(worst.torque, std::abs(torque_on(rows, i) - expected[i].torque));
  }
  return {worst.force / largest_force, worst.torque / largest_torque};
}

}  // namespace

TEST_CASE("forces and torques are those of a sum over all pairs, through slip and broken bonds") {
  std::set<std::size_t> lanes_used_last;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    test::Random random(seed);
    const auto specimen = test::jittered_discs(7, 6, random);
    test::Assembly assembly(specimen, test::Bond(test::sample_rock));
    test::Textbook textbook(specimen, test::sample_rock);
    REQUIRE(assembly.contacts.size() == textbook.size());
    CHECK(assembly.touching.size() > 8);
    CHECK(textbook.size() > 60);
    CHECK(textbook.size() < 42 * 41 / 2);
    lanes_used_last.insert(textbook.size() % 4);

    for (int load_step = 0; load_step < 8; ++load_step) {
      for (std::size_t c = static_cast<std::size_t>(load_step); c < textbook.size(); c += 17) {
        assembly.rock.break_bond(c);
        textbook.break_bond(c);
      }
      shake(assembly.discs, 4e-6, random);
      assembly.evaluate();
      const auto off = difference(assembly.forces, textbook.loads(assembly.discs.displacement));
      CHECK(off.force < 1e-12);
      CHECK(off.torque < 1e-12);
      if (load_step > 0) continue;
      CHECK(textbook.slipped() > 20);
      CHECK(textbook.slipped() < textbook.size() - 5);
    }
  }
  CHECK(lanes_used_last.size() > 1);  // the last block was not always full
}

TEST_CASE("a single response is the one that the loop has written") {
  test::Random random(5);
  test::Assembly assembly(test::jittered_discs(6, 5, random), test::Bond(test::sample_rock));
  shake(assembly.discs, 5e-6, random);
  assembly.evaluate();
  for (std::size_t c = 0; c < assembly.rock.size(); ++c) {
    const auto reaction = assembly.rock.response(c, assembly.discs.displacement).reaction();
    const hfdem::Pack row = assembly.forces.rows()[assembly.rock.first_row() + c];
    const double size = std::hypot(reaction.normal, reaction.shear);
    CHECK(std::abs(std::hypot(row[0], row[1]) - size) <= 1e-12 * size);
    CHECK(assembly.rock.bodies(c) == assembly.contacts[c].bodies);
  }
}

TEST_CASE("the contacts push no momentum and no angular momentum into the assembly") {
  test::Random random(6);
  test::Assembly assembly(test::jittered_discs(8, 7, random), test::Bond(test::sample_rock));
  shake(assembly.discs, 5e-6, random);
  assembly.rock.evaluate(assembly.discs.displacement, assembly.forces.rows(), 1);

  Vec2 force;
  double torque = 0, largest = 0;
  for (std::size_t i = 0; i < assembly.discs.size(); ++i) {
    const Vec2 f = force_on(assembly.forces, i);
    force = force + f;
    torque += cross(assembly.discs.centre[i], f) + torque_on(assembly.forces, i);
    largest = std::fmax(largest, norm(f));
  }
  CHECK(largest > 0);
  CHECK(norm(force) < 1e-13 * largest);
  CHECK(std::abs(torque) < 1e-13 * largest * assembly.specimen.width);
}

TEST_CASE("a mirrored star of discs receives mirrored sums to the last bit") {
  const std::array<Vec2, 4> around{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const auto star = [&] {
    hfdem::Specimen s{.width = 0.02,
                      .height = 0.02,
                      .density = 1,
                      .centre = {{0.01, 0.01}},
                      .radius = std::vector<double>(5, 2e-3),
                      .bonding_gap = 1e-9,
                      .pairs = {{0, 1}, {0, 2}, {0, 3}, {0, 4}}};
    for (const Vec2 way : around) s.centre.push_back(s.centre[0] + 4e-3 * way);
    return test::Assembly(s, test::Bond(test::sample_rock));
  };
  struct Mirror {
    std::array<hfdem::Index, 5> image;  // of each disc
    Vec2 sign;
  };
  const Mirror left_right{{0, 3, 2, 1, 4}, {-1, 1}}, up_down{{0, 1, 4, 3, 2}, {1, -1}};
  test::Random random(7);
  for (const Mirror& mirror : {left_right, up_down})
    for (int trial = 0; trial < 50; ++trial) {
      auto one = star(), other = star();
      shake(one.discs, 5e-6, random);
      for (std::size_t i = 0; i < 5; ++i)
        other.discs.displacement[i] = one.discs.displacement[mirror.image[i]] *
                                      hfdem::Pack{mirror.sign.x, mirror.sign.y, -1, -1};
      one.evaluate();
      other.evaluate();
      const Vec2 a = force_on(one.forces, 0), b = force_on(other.forces, 0);
      CHECK(a.x == mirror.sign.x * b.x);
      CHECK(a.y == mirror.sign.y * b.y);
      CHECK(torque_on(one.forces, 0) == -torque_on(other.forces, 0));
    }
}
