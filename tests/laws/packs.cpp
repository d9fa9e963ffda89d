// Four contacts at once must give the bits of four single ones.
#include <array>
#include <cmath>
#include <limits>

#include <hfdem/base/pack.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/contact/smooth_platen.hpp>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "laws/sample_rock.hpp"
#include "near.hpp"

namespace {

using hfdem::Pack;
using hfdem::PackedColumn;
using test::bits;

/// Whether two records of doubles are the same bits.
template <class Record>
bool same_bits(const Record& a, const Record& b) {
  using Words = std::array<std::uint64_t, sizeof(Record) / sizeof(std::uint64_t)>;
  return std::bit_cast<Words>(a) == std::bit_cast<Words>(b);
}

/// A number of a size that contacts see; now and then exactly zero, of either sign.
double sometimes_zero(test::Random& random, double size) {
  const double chance = random(0, 1);
  if (chance < 0.1) return chance < 0.05 ? 0.0 : -0.0;
  return random(-size, size);
}

}  // namespace

TEST_CASE("a contact law gives four contacts the bits it gives each alone") {
  test::Random random(1);
  const test::Bond law(test::sample_rock);
  PackedColumn<test::Bond::Stiffness> stiffness(4);
  PackedColumn<test::Bond::Memory> memory(4);
  PackedColumn<hfdem::Motion> motion(4);
  int in_tension = 0, in_shear = 0, slipped = 0;
  for (int trial = 0; trial < 500; ++trial) {
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const auto k = law.stiffness({random(3e-3, 5e-3)}, {random(3e-3, 5e-3)});
      stiffness.set(lane, random(0, 1) < 0.2 ? law.broken(k) : k);
      memory.set(lane, {sometimes_zero(random, 1e4)});
      motion.set(lane, {sometimes_zero(random, 4e-6), sometimes_zero(random, 1.5e-5),
                        sometimes_zero(random, 3e-4)});
    }
    const auto four = law.respond(stiffness.block(0), memory.block(0), motion.block(0));
    const auto four_reactions = four.reaction();
    const auto four_failures = law.failure(stiffness.block(0), four);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const auto one = law.respond(stiffness[lane], memory[lane], motion[lane]);
      CHECK(same_bits(one, PackedColumn<test::Bond::Response>::lane(four, lane)));
      CHECK(same_bits(one.reaction(), PackedColumn<hfdem::Reaction>::lane(four_reactions, lane)));
      const auto failure = law.failure(stiffness[lane], one);
      CHECK(failure.tension == (four_failures.tension[lane] != 0));
      CHECK(failure.shear == (four_failures.shear[lane] != 0));
      in_tension += failure.tension;
      in_shear += failure.shear;
      slipped += one.memory.shear_offset != memory[lane].shear_offset;
    }
  }
  // All branches were taken, and none always.
  for (const int count : {in_tension, in_shear, slipped}) {
    CHECK(count > 100);
    CHECK(count < 1900);
  }
}

TEST_CASE("a platen gives four discs the bits it gives each alone") {
  test::Random random(2);
  const hfdem::SmoothPlaten law;
  PackedColumn<hfdem::SmoothPlaten::Stiffness> stiffness(4);
  PackedColumn<hfdem::Motion> motion(4);
  for (int trial = 0; trial < 100; ++trial) {
    for (std::size_t lane = 0; lane < 4; ++lane) {
      stiffness.set(lane, {random(1e10, 1e11)});
      motion.set(lane, {sometimes_zero(random, 1e-6), random(-1e-6, 1e-6), random(-1e-4, 1e-4)});
    }
    const auto four = law.respond(stiffness.block(0), {}, motion.block(0)).reaction();
    for (std::size_t lane = 0; lane < 4; ++lane)
      CHECK(same_bits(law.respond(stiffness[lane], {}, motion[lane]).reaction(),
                      PackedColumn<hfdem::Reaction>::lane(four, lane)));
  }
}

TEST_CASE("a frame gives four contacts the bits it gives each alone") {
  test::Random random(3);
  PackedColumn<hfdem::Frame> frame(4);
  PackedColumn<hfdem::Reaction> reaction(4);
  for (int trial = 0; trial < 100; ++trial) {
    std::array<Pack, 4> row;  // one lane of the difference row each
    for (Pack& lanes : row)
      for (std::size_t lane = 0; lane < 4; ++lane) lanes[lane] = sometimes_zero(random, 1e-5);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const double angle = random(-3.2, 3.2);
      frame.set(lane, {std::cos(angle), std::sin(angle), random(3e-3, 5e-3), random(-1e-3, 1e-3)});
      reaction.set(lane, {random(-1e5, 1e5), random(-1e5, 1e5), random(-1e2, 1e2)});
    }
    const auto motions = frame.block(0).motion(row[0], row[1], row[2], row[3]);
    std::array<Pack, 4> force;
    frame.block(0).force(reaction.block(0), force[0], force[1], force[2], force[3]);
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const auto f = frame[lane];
      CHECK(same_bits(f.motion(row[0][lane], row[1][lane], row[2][lane], row[3][lane]),
                      PackedColumn<hfdem::Motion>::lane(motions, lane)));
      std::array<double, 4> one;
      f.force(reaction[lane], one[0], one[1], one[2], one[3]);
      for (std::size_t k = 0; k < 4; ++k) CHECK(bits(one[k]) == bits(force[k][lane]));
    }
  }
}

TEST_CASE("a packed column keeps each record apart from its neighbours") {
  PackedColumn<hfdem::Motion> column(8);
  const auto numbered = [](double i) { return hfdem::Motion<double>{i, 10 + i, 20 + i}; };
  for (std::size_t i = 0; i < 8; ++i) column.set(i, numbered(static_cast<double>(i)));
  for (std::size_t i = 0; i < 8; ++i) CHECK(same_bits(column[i], numbered(static_cast<double>(i))));

  auto other = column.block(1);
  CHECK_FALSE(differ(column.block(1), other));
  CHECK(differ(column.block(0), other));
  other.rotation[3] = std::nextafter(other.rotation[3], 0.0);
  CHECK(differ(column.block(1), other));
}

TEST_CASE("the functions of packs are those of numbers, lane by lane") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Pack a{-2, -0.0, 3, -infinity}, b{1, 0.0, 2.5, 7};
  for (std::size_t lane = 0; lane < 4; ++lane) {
    CHECK(bits(hfdem::max(a, b)[lane]) == bits(hfdem::max(a[lane], b[lane])));
    CHECK(bits(hfdem::min(a, b)[lane]) == bits(hfdem::min(a[lane], b[lane])));
    CHECK(bits(hfdem::abs(a)[lane]) == bits(hfdem::abs(a[lane])));
  }
  CHECK(hfdem::max(-2.0, 1.0) == 1);
  CHECK(hfdem::min(-2.0, 1.0) == -2);
  CHECK(hfdem::abs(-2.0) == 2);
  for (const double value : {-7.0, 0.25, 7.0})
    CHECK(hfdem::clamp(value, -1.0, 2.0) == std::fmin(std::fmax(value, -1.0), 2.0));
}

TEST_CASE("a sign is that of the other number, and zero has none") {
  const Pack s = hfdem::with_sign(Pack{3, 4, 5, 6}, Pack{-1e-300, 0.0, -0.0, 5});
  const std::array<double, 4> expected{-3, 0, 0, 6};
  for (std::size_t lane = 0; lane < 4; ++lane) CHECK(bits(s[lane]) == bits(expected[lane]));
}

TEST_CASE("what is added with a sign is rounded once") {
  const Pack a{1, 1, 0.1, -0.0}, b{1e-17, 0.2, 0.3, 0.0}, signs{-1, 1, -1, -1};
  const Pack s = hfdem::plus_signed(a, signs, b);
  const std::array<double, 4> expected{1 - 1e-17, 1 + 0.2, 0.1 - 0.3, -0.0 - 0.0};
  for (std::size_t lane = 0; lane < 4; ++lane) CHECK(bits(s[lane]) == bits(expected[lane]));
}

TEST_CASE("any finds a true lane wherever it is") {
  CHECK_FALSE(hfdem::any(hfdem::PackMask{}));
  for (std::size_t lane = 0; lane < 4; ++lane) {
    Pack one{};
    one[lane] = 1;
    CHECK(hfdem::any(one > Pack{}));
  }
}

TEST_CASE("transposing turns rows into columns") {
  std::array<Pack, 4> m{Pack{0, 1, 2, 3}, Pack{10, 11, 12, 13}, Pack{20, 21, 22, 23},
                        Pack{30, 31, 32, 33}};
  hfdem::transpose(m[0], m[1], m[2], m[3]);
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column) {
      const double entry = m[row][column];
      CHECK(entry == static_cast<double>(10 * column + row));
    }
}
