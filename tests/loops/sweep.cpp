// Contacts and discs in one pass come to the same bits as one after the other, with breaking bonds,
// joints, slip and any number of threads.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <vector>

#include <hfdem/assembly.hpp>
#include <hfdem/contact/incremental_parallel_bond.hpp>
#include <hfdem/contact/scattered_parallel_bond.hpp>
#include <hfdem/neighbours/cell_grid.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/setup/joints.hpp>
#include <hfdem/setup/random_packing.hpp>
#include <hfdem/setup/square_array.hpp>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "loops/assembly.hpp"
#include "near.hpp"

namespace {

using namespace hfdem;

struct Break {
  Index contact;
  Mode mode;
  int step;
  friend bool operator==(const Break&, const Break&) = default;
};

/// What a rock has come to.
struct Outcome {
  std::vector<std::uint64_t> bits{};
  std::vector<double> resultants{};
  std::vector<Break> breaks{};
  friend bool operator==(const Outcome&, const Outcome&) = default;
};

/// Pulls the rock apart while it is pressed from the sides, until some bonds have broken.
/// @param in_one_pass or contacts first
template <class Law>
Outcome torn(const Law& law, const Specimen& specimen, int steps, bool in_one_pass, int threads) {
  Assembly<Law> rock(specimen, bonded_contacts<CellGrid>(specimen), law, {}, 0.7, 0.97);
  rock.set_stress({20e6, 1e6});
  Outcome outcome;
  int step = 0;
  const auto note = [&](Index contact, Mode mode) {
    outcome.breaks.push_back({contact, mode, step});
  };
  for (; step < steps; ++step) {
    if (step == steps / 3)  // the bottom stays, and the top is drawn away
      for (Index i = 0; i < specimen.size(); ++i) {
        if (specimen.touches(i, Side::top)) rock.drive(i, {0, 0.5});
        if (specimen.touches(i, Side::bottom)) rock.drive(i, {0, 0});
      }
    in_one_pass ? rock.begin_step(threads, note) : rock.find_forces(threads, note);
    outcome.resultants.push_back(rock.move(false, threads));
  }
  for (const Pack& row : rock.discs().displacement)
    for (std::size_t lane = 0; lane < 4; ++lane) outcome.bits.push_back(test::bits(row[lane]));
  for (const Pack& row : rock.forces().rows())
    for (std::size_t lane = 0; lane < 4; ++lane) outcome.bits.push_back(test::bits(row[lane]));
  return outcome;
}

template <class Law>
void check_sweep(const Law& law, const Specimen& specimen, int steps, std::size_t least_breaks) {
  const Outcome apart = torn(law, specimen, steps, false, 1);
  CHECK(apart.breaks.size() >= least_breaks);
  for (const int threads : {1, 2, 3, 5}) {
    CAPTURE(threads);
    CHECK(torn(law, specimen, steps, true, threads) == apart);
  }
}

Specimen rock_of(int grains) {
  const double side = std::sqrt(grains / 17511.0);
  return random_packing({.width = side, .height = side, .grains = grains});
}

/// A search that gives the higher number first.
struct Backwards {
  CellGrid search;
  Backwards(const Specimen& s, double reach) : search(s, reach) {}
  template <class F>
  void for_each_pair(F&& f) const {
    search.for_each_pair([&](Pair p) { f({p.second, p.first}); });
  }
};

}  // namespace

TEST_CASE("random rock that breaks moves by the same bits in one pass") {
  check_sweep(LinearParallelBond({}), rock_of(6000), 900, 100);
}

TEST_CASE("bonds of unequal strength break at the same steps in one pass") {
  check_sweep(ScatteredParallelBond({{}, 4, 1}), rock_of(4000), 600, 20);
}

TEST_CASE("so does the bond in incremental form, all of whose memory changes") {
  check_sweep(IncrementalParallelBond({}), rock_of(4000), 600, 20);
}

TEST_CASE("a square array moves by the same bits in one pass") {
  check_sweep(LinearParallelBond({}), square_array(70, 90, 5e-3), 700, 10);
}

TEST_CASE("rock with natural fractures moves by the same bits in one pass") {
  Specimen specimen = rock_of(6000);
  const double side = specimen.width;
  insert_joints(specimen, std::vector<NaturalFracture>{
                              {{0.2 * side, 0.3 * side}, {0.7 * side, 0.6 * side}},
                              {{0.3 * side, 0.8 * side}, {0.8 * side, 0.75 * side}}});
  REQUIRE(specimen.joints.pairs.size() > 20);
  check_sweep(Jointed<LinearParallelBond>(LinearParallelBond::Params{}), specimen, 900, 100);
}

TEST_CASE("a step's account of the fastest disc bounds every motion") {
  test::Random random(5);
  const Specimen specimen = test::jittered_discs(20, 15, random);
  const LinearParallelBond law({});
  test::Assembly<LinearParallelBond> a(specimen, law);
  test::shake(a.discs, 1e-6, random);
  DiscMotion motion(a.discs, 1e-6, 0.7);
  for (int n = 0; n < 20; ++n) {
    a.evaluate();
    const auto before = a.discs.displacement;
    const Moved moved = motion.step(a.discs, a.forces, 1);
    double distance = 0, rotation = 0;
    for (std::size_t i = 0; i < a.discs.size(); ++i) {
      const Pack change = a.discs.displacement[i] - before[i];
      distance = std::max({distance, std::abs(change[0]), std::abs(change[1])});
      rotation = std::max(rotation, std::abs(change[2]));
    }
    CHECK(moved.distance / distance == test::near(1, 1e-6));
    CHECK(moved.rotation / rotation == test::near(1, 1e-6));
  }
}

TEST_CASE("no contact moves by more than a step says, and some by as much") {
  test::Random random(6);
  const Moved apart{.resultant = 0, .distance = 2e-6, .rotation = 0};
  const Moved turned{.resultant = 0, .distance = 0, .rotation = 3e-4};
  const Moved both{.resultant = 0, .distance = 2e-6, .rotation = 3e-4};
  const auto worst = [&](const Moved& moved) {
    double most = 0;
    for (int n = 0; n < 200; ++n) {
      const double first = random(3e-3, 5e-3), second = n % 2 == 0 ? first : random(3e-3, 5e-3);
      const double angle = random(0, 2 * std::numbers::pi), gap = random(-1e-4, 1e-4);
      const Frame<double> frame{std::cos(angle), std::sin(angle), (first + second + gap) / 2,
                                (second - first) / 2};
      const double arm = (first > second ? first : second) + gap / 2;
      const double lever = std::max({first, second, arm});
      for (unsigned corner = 0; corner < 64; ++corner) {
        const auto end = [&](unsigned k, double size) {
          return (corner >> k & 1U) != 0 ? size : -size;
        };
        const double dx = end(0, moved.distance) - end(1, moved.distance);
        const double dy = end(2, moved.distance) - end(3, moved.distance);
        const double turn = end(4, moved.rotation), other = end(5, moved.rotation);
        const auto u = frame.motion(dx, dy, turn - other, turn + other);
        const double change = std::abs(u.opening) + std::abs(u.shear) +
                              std::abs(u.rotation) * std::min(first, second);
        most = std::max(most, change / moved.of_contacts(lever));
      }
    }
    return most;
  };
  for (const Moved& moved : {apart, turned, both}) {
    CHECK(worst(moved) <= 1 + 1e-12);
    CHECK(worst(moved) > 0.98);
  }
}

TEST_CASE("a search may give pairs with the higher number first") {
  const Specimen specimen = rock_of(500);
  const auto forward = bonded_contacts<CellGrid>(specimen);
  const auto backward = bonded_contacts<Backwards>(specimen);
  REQUIRE(forward.size() == backward.size());
  for (std::size_t c = 0; c < forward.size(); ++c) {
    CHECK(forward[c].bodies == backward[c].bodies);
    CHECK(forward[c].frame.normal_x == backward[c].frame.normal_x);
  }
}

TEST_CASE("where asking buys nothing, nobody is asked for some steps") {
  Foresight all_fast(4, 1e-12), one_fast(4, 1e-12);
  int asked_all = 0, asked_one = 0;
  const auto step = [](Foresight& book, std::size_t fast, int& asked) {
    if (!book.sure() && book.pays()) {
      ++asked;
      for (const std::size_t chunk : book.unsure()) book.tell(chunk, chunk < fast ? 1e-9 : 1);
      book.count();
    }
    book.moved(1e-8);
  };
  for (int n = 0; n < 1000; ++n) {
    step(all_fast, 4, asked_all);
    step(one_fast, 1, asked_one);
  }
  CHECK(asked_all > 40);
  CHECK(asked_all < 80);
  CHECK(asked_one > 900);  // a quarter is soon asked
}

TEST_CASE("after a long way even the slowest motion counts") {
  Foresight book(1, 1e-12);
  book.moved(100);
  book.unsure();
  book.tell(0, 2e-6);
  book.count();
  int steps = 0;
  for (; book.sure() && steps < 1000; ++steps) book.moved(5e-15);
  CHECK(book.sure());
  book.moved(2e-6);
  CHECK_FALSE(book.sure());
}

TEST_CASE(
    "what is foreseen ends when the motion has used it up, and when discs are put elsewhere") {
  const Specimen specimen = square_array(20, 20, 5e-3);
  const LinearParallelBond law({});
  const auto contacts = bonded_contacts<CellGrid>(specimen);
  const std::vector bonds(contacts.size(), law.stiffness({5e-3}, {5e-3}));
  for (const double used : {0.99, 1.01}) {
    CAPTURE(used);
    ContactRange<LinearParallelBond> range(law, 0, contacts, bonds);
    std::vector<Pack> place(specimen.size() + 4, Pack{});
    CHECK(range.all_hold(place, 1));
    const double margin = 8e6 * 10e-3 / 17e9;  // in tension, from rest: strength L / E_b
    range.moved(used * margin);
    for (std::size_t i = 0; i < specimen.size(); ++i)  // pulled apart, so that all bonds fail
      place[i] = Pack{0.002 * specimen.centre[i].x, 0, 0, 0};
    CHECK(range.all_hold(place, 1) == (used < 1));
    range.displaced();
    CHECK_FALSE(range.all_hold(place, 1));
  }
}

TEST_CASE("the copy of an assembly goes on by itself") {
  const Specimen specimen = rock_of(4000);
  const auto made = [&] {
    auto rock = std::make_unique<Assembly<LinearParallelBond>>(
        specimen, bonded_contacts<CellGrid>(specimen), LinearParallelBond({}), Loading::Params{},
        0.7, 0.97);
    rock->set_stress({10e6, 12e6});
    return rock;
  };
  const auto step = [](auto& rock) {
    for (int n = 0; n < 50; ++n) {
      rock.begin_step(3, [](Index, Mode) {});
      rock.move(false, 3);
    }
  };
  auto original = made(), whole = made();
  step(*original);
  Assembly<LinearParallelBond> copy = *original;
  original.reset();
  step(copy);
  step(*whole);
  step(*whole);
  bool same = true;
  for (std::size_t i = 0; i < specimen.size(); ++i)
    for (std::size_t lane = 0; lane < 4; ++lane)
      same = same && copy.discs().displacement[i][lane] == whole->discs().displacement[i][lane];
  CHECK(same);
}
