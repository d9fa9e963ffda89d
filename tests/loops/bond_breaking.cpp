// The cold pass that breaks bonds, against the textbook's criterion on every contact.
#include <algorithm>
#include <vector>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "laws/sample_rock.hpp"
#include "loops/assembly.hpp"
#include "loops/textbook.hpp"

namespace {

struct Break {
  hfdem::Index contact;
  hfdem::Mode mode;
  friend bool operator==(const Break&, const Break&) = default;
};

std::vector<Break> break_bonds(test::Assembly<test::Bond>& assembly) {
  std::vector<Break> told;
  assembly.rock.break_bonds(assembly.discs.displacement, assembly.forces.rows(),
                            [&](hfdem::Index contact, hfdem::Mode mode) {
                              told.push_back({contact, mode});
                            });
  return told;
}

std::size_t count(const std::vector<Break>& breaks, hfdem::Mode mode) {
  return static_cast<std::size_t>(
      std::count_if(breaks.begin(), breaks.end(), [&](const Break& b) { return b.mode == mode; }));
}

}  // namespace

TEST_CASE("all bonds over strength break together, once each, in order and in the right mode") {
  test::Random random(1);
  // More contacts than one thread takes at a time, so that some chunks break and some do not.
  const auto specimen = test::jittered_discs(20, 16, random);
  auto rock = test::sample_rock;
  rock.cohesion = 2e6;  // or nearly all would break in tension
  test::Assembly assembly(specimen, test::Bond(rock));
  test::Textbook textbook(specimen, rock);
  REQUIRE(textbook.size() > 2 * 64 * hfdem::pack_width);

  std::vector<Break> all;
  for (int load_step = 0; load_step < 6; ++load_step) {
    shake(assembly.discs, 1e-6, random);
    std::vector<Break> expected;
    for (std::size_t c = 0; c < textbook.size(); ++c) {
      const auto over = textbook.over_strength(c, assembly.discs.displacement);
      if (over.tension || over.shear)
        expected.push_back({static_cast<hfdem::Index>(c),
                            over.tension ? hfdem::Mode::tension : hfdem::Mode::shear});
    }
    assembly.evaluate();
    const auto told = break_bonds(assembly);
    CHECK(told == expected);
    for (const Break& b : told) textbook.break_bond(b.contact);
    all.insert(all.end(), told.begin(), told.end());

    // The rows are those of broken contacts at once, and nothing is left to break.
    const auto loads = textbook.loads(assembly.discs.displacement);
    double worst = 0, largest = 0;
    for (std::size_t i = 0; i < loads.size(); ++i) {
      const hfdem::Pack total = assembly.forces.total(i);
      worst = std::fmax(worst, norm(hfdem::Vec2{total[0], total[1]} - loads[i].force));
      largest = std::fmax(largest, norm(loads[i].force));
    }
    CHECK(worst < 1e-12 * largest);
    CHECK(break_bonds(assembly).empty());
    assembly.evaluate();
    CHECK(break_bonds(assembly).empty());
  }
  CHECK(count(all, hfdem::Mode::tension) > 20);
  CHECK(count(all, hfdem::Mode::shear) > 5);
  CHECK(all.size() < textbook.size());
}

TEST_CASE("shear alone breaks a bond") {
  const double R = 4e-3;
  test::Assembly assembly({.width = 1,
                           .height = 1,
                           .density = 1,
                           .centre = {{R, R}, {3 * R, R}},
                           .radius = {R, R},
                           .bonding_gap = 1e-9,
                           .pairs = {{0, 1}}},
                          test::Bond(test::sample_rock));
  assembly.discs.displacement[1] = hfdem::Pack{0, 1e-3, 0, 0};
  assembly.evaluate();
  CHECK(break_bonds(assembly) == std::vector<Break>{{0, hfdem::Mode::shear}});
}

TEST_CASE("an assembly under its strength breaks nothing") {
  test::Random random(2);
  test::Assembly assembly(test::jittered_discs(7, 6, random), test::Bond(test::sample_rock));
  shake(assembly.discs, 1e-7, random);
  assembly.evaluate();
  CHECK(break_bonds(assembly).empty());
}
