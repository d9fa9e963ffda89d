// What natural fractures have come to, counted by hand in a made-up run.
#include <cstddef>
#include <span>
#include <vector>

#include <hfdem/measure/natural_fractures.hpp>
#include <hfdem/mechanics/joint_contacts.hpp>
#include <hfdem/simulator_observers.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

using namespace hfdem;
using test::near;

namespace {

BondBreak broken_bond(Index contact) { return {0, contact, Mode::shear, 0}; }

/// Ten contacts in rock and four joints: three in the first fracture, one in the second.
struct MadeUpRun {
  struct Law {
    static double slip(double memory) { return memory; }
  };
  struct Contacts {
    std::vector<double> slip{3e-5, -6e-5, 9e-5, 8e-5}, opening{2e-5, -4e-5, 9e-5, 5e-5};
    static std::size_t size() { return 10; }
    static Law law() { return {}; }
    double memory(std::size_t k) const { return slip[k]; }
    Motion<double> motion(std::size_t k, int) const { return {.opening = opening[k]}; }
  };
  struct Joints {
    Contacts range;
    std::vector<NaturalFracture> all{{{0, 0}, {0.3, 0.4}}, {{1, 0}, {1, 0.25}}};
    std::vector<FracturePiece> pieces{{0, 0.1}, {0.1, 0.4}, {0.4, 0.5}, {0, 0.25}};
    const Contacts& contacts() const { return range; }
    const std::vector<NaturalFracture>& fractures() const { return all; }
    const FracturePiece& piece(std::size_t k) const { return pieces[k]; }
    static JointPair pair(std::size_t k) { return {{}, k == 3 ? Index{1} : Index{0}, 0, {}}; }
  };
  struct Network {
    static bool is_wet(Index channel) { return channel == 11 || channel == 2; }
  };
  struct Discs {
    int displacement = 0;
  };
  Joints made;
  std::vector<BondBreak> broken{broken_bond(2), broken_bond(11), broken_bond(10)};

  const Joints& joints() const { return made; }
  const Contacts& contacts() const { return made.range; }
  static Network network() { return {}; }
  static Discs discs() { return {}; }
  static bool is_joint(Index contact) { return contact >= 10; }
  std::span<const BondBreak> breaks() const { return broken; }
};

}  // namespace

TEST_CASE("slip and opening are means over the broken length, closed joints do not count as open") {
  const auto each = measure::fracture_activity(MadeUpRun{});
  REQUIRE(each.size() == 2);
  CHECK(each[0].broken == 2);
  CHECK(each[0].connected == 1);
  CHECK(each[0].length == near(0.5));
  CHECK(each[0].broken_length == near(0.4));
  CHECK(each[0].connected_length == near(0.3));
  CHECK(each[0].slip == near((0.1 * 3e-5 + 0.3 * 6e-5) / 0.4));
  CHECK(each[0].largest_slip == near(6e-5));
  CHECK(each[0].opening == near(0.1 * 2e-5 / 0.4));
  CHECK(each[0].largest_opening == near(2e-5));
  CHECK(each[1].broken == 0);
  CHECK(each[1].slip == 0);
}

TEST_CASE("all fractures together are as long as each, and their means weigh by broken length") {
  MadeUpRun run;
  run.broken.push_back(broken_bond(13));
  const auto sum = measure::total(measure::fracture_activity(run));
  CHECK(sum.broken == 3);
  CHECK(sum.connected == 1);
  CHECK(sum.length == near(0.75));
  CHECK(sum.broken_length == near(0.65));
  CHECK(sum.slip == near((0.1 * 3e-5 + 0.3 * 6e-5 + 0.25 * 8e-5) / 0.65));
  CHECK(sum.largest_slip == near(8e-5));
  CHECK(sum.opening == near((0.1 * 2e-5 + 0.25 * 5e-5) / 0.65));
}
