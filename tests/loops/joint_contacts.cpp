// Contacts on natural fractures: who they are, which piece of the fracture each stands for, and
// what they do to the discs.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <hfdem/base/pack.hpp>
#include <hfdem/mechanics/force_rows.hpp>
#include <hfdem/mechanics/joint_contacts.hpp>
#include <hfdem/setup/square_array.hpp>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "laws/sample_joint.hpp"
#include "loops/assembly.hpp"
#include "loops/jointed_rock.hpp"
#include "near.hpp"

namespace {

using hfdem::Index;
using hfdem::Pack;
using hfdem::Vec2;
using test::near;
namespace joint = test::joint;

constexpr double reach = 6e-3;  // far beyond the gap up to which the discs bond

/// Irregular discs with two fractures, neither along an axis; some pairs bond across them.
hfdem::Specimen two_fractures(std::uint64_t seed, Index columns = 12, Index rows = 9) {
  test::Random random(seed);
  hfdem::Specimen s = test::jittered_discs(columns, rows, random);
  test::add_fracture(s, {0.1 * s.width, 0.2 * s.height}, {0.93 * s.width, 0.38 * s.height}, reach);
  test::add_fracture(s, {0.9 * s.width, 0.95 * s.height}, {0.05 * s.width, 0.6 * s.height}, reach);
  return s;
}

/// The joints of a specimen alone, with the rows of their forces.
struct Joints {
  hfdem::Specimen specimen;
  hfdem::PartedContacts parted;
  std::size_t bonded;
  hfdem::Discs discs;
  hfdem::JointContacts<test::Joint> contacts;
  hfdem::ForceRows forces;

  explicit Joints(const hfdem::Specimen& s)
      : specimen(s),
        parted(hfdem::bonded_contacts<hfdem::FixedPairs>(s), s.joints.pairs),
        bonded(parted.bonded.size() - parted.of_rock),
        discs(s),
        contacts(test::Joint(test::sample_joint), 0, parted.joints, bonded, s),
        forces(s.size() + 4) {
    forces.add(contacts.geometry(), 0, contacts.contacts().padded_size());
    forces.arrange();
  }

  void evaluate(int threads = 1) {
    contacts.contacts().evaluate(discs.displacement, forces.rows(), threads);
  }
  Vec2 force_on(std::size_t body) const {
    const Pack total = forces.total(body);
    return {total[0], total[1]};
  }
  /// Moves the second disc of a pair so near to the first as discs that bond.
  void bring_together(std::size_t k) {
    const auto [first, second] = contacts.pair(k).bodies;
    const Vec2 between = specimen.centre[second] - specimen.centre[first];
    const double way = specimen.gap({first, second}) - 0.99 * specimen.bonding_gap;
    const Vec2 move = -(way / norm(between)) * between;
    discs.displacement[second] = discs.displacement[first] + Pack{move.x, move.y, 0, 0};
  }
};

/// Each point of each fracture is in the piece of the nearest crossing that has met, and pieces
/// leave nothing out.
void check_pieces(const Joints& joints) {
  const auto& contacts = joints.contacts;
  for (Index f = 0; f < joints.specimen.joints.fractures.size(); ++f) {
    const double length = joints.specimen.joints.fractures[f].length();
    double sum = 0, stiffness = 0;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      if (contacts.pair(k).fracture != f) continue;
      CHECK((contacts.piece(k).length() > 0) == contacts.has_met(k));
      sum += contacts.piece(k).length();
      const auto& range = contacts.contacts();
      stiffness += range.law().springs(range.stiffness(k)).normal;
    }
    CHECK(sum == near(length));
    CHECK(stiffness == near(joint::k_n * length));
    for (double at = 0; at <= length; at += length / 499) {
      std::size_t nearest = contacts.size();
      for (std::size_t k = 0; k < contacts.size(); ++k) {
        if (contacts.pair(k).fracture != f || !contacts.has_met(k)) continue;
        const auto away = [&](std::size_t c) { return std::abs(contacts.pair(c).along - at); };
        if (nearest == contacts.size() || away(k) < away(nearest)) nearest = k;
      }
      const hfdem::FracturePiece& piece = contacts.piece(nearest);
      CHECK(piece.begin <= at + 1e-12);
      CHECK(piece.end >= at - 1e-12);
    }
  }
}

}  // namespace

TEST_CASE("contacts are numbered rock first, then joints, and know their number in the list") {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const hfdem::Specimen s = two_fractures(seed);
    const auto all = hfdem::bonded_contacts<hfdem::FixedPairs>(s);
    const auto& across = s.joints.pairs;
    const hfdem::PartedContacts parted(all, across);
    const auto fracture_between = [&](const hfdem::Pair& bodies) {
      return std::find_if(across.begin(), across.end(),
                          [&](const hfdem::JointPair& p) { return p.bodies == bodies; });
    };
    REQUIRE(parted.bonded.size() == all.size());
    REQUIRE(parted.number.size() == all.size());
    CHECK(std::is_sorted(parted.number.begin(),
                         parted.number.begin() + static_cast<std::ptrdiff_t>(parted.of_rock)));
    CHECK(std::is_sorted(parted.number.begin() + static_cast<std::ptrdiff_t>(parted.of_rock),
                         parted.number.end()));
    std::vector<bool> seen(all.size(), false);
    for (std::size_t c = 0; c < all.size(); ++c) {
      CHECK(parted.bonded[c].bodies == all[parted.number[c]].bodies);
      CHECK(parted.bonded[c].frame.arm_mean == all[parted.number[c]].frame.arm_mean);
      CHECK((fracture_between(parted.bonded[c].bodies) == across.end()) == (c < parted.of_rock));
      seen[parted.number[c]] = true;
    }
    CHECK(std::count(seen.begin(), seen.end(), false) == 0);

    // Every pair across a fracture is a joint: first those with a bond, as they are numbered.
    const std::size_t with_bond = all.size() - parted.of_rock;
    REQUIRE(parted.joints.size() == across.size());
    CHECK(with_bond > 10);
    CHECK(across.size() > with_bond + 5);
    for (std::size_t k = 0; k < parted.joints.size(); ++k) {
      const auto given = fracture_between(parted.joints[k].bodies);
      REQUIRE(given != across.end());
      CHECK(parted.joints[k].along == given->along);
      if (k < with_bond) CHECK(parted.joints[k].bodies == parted.bonded[parted.of_rock + k].bodies);
      CHECK((s.gap(given->bodies) <= s.bonding_gap) == (k < with_bond));
    }
  }
}

TEST_CASE("without fractures all contacts are the rock's, in their order") {
  const hfdem::Specimen s = hfdem::square_array(5, 4, 5e-3);
  const auto all = hfdem::bonded_contacts<hfdem::FixedPairs>(s);
  const hfdem::PartedContacts parted(all, s.joints.pairs);
  CHECK(parted.of_rock == all.size());
  CHECK(parted.joints.empty());
  for (Index c = 0; c < all.size(); ++c) CHECK(parted.number[c] == c);
}

TEST_CASE("each point of a fracture belongs to the nearest contact that has met, and all sum up") {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Joints joints(two_fractures(seed));
    check_pieces(joints);
    test::Random random(seed);
    std::size_t met = 0;
    for (std::size_t k = joints.bonded; k < joints.contacts.size(); ++k) {
      if (joints.contacts.has_met(k) || random(0, 1) < 0.5) continue;
      joints.bring_together(k);
      joints.contacts.meet(joints.discs);
      CHECK(joints.contacts.has_met(k));
      check_pieces(joints);
      if (++met == 4) break;
    }
    CHECK(met == 4);
  }
}

TEST_CASE("discs meet where discs would bond, not before, and never part again") {
  Joints joints(two_fractures(4));
  const std::size_t k = joints.bonded;
  joints.bring_together(k);
  const auto [first, second] = joints.contacts.pair(k).bodies;
  const Vec2 between = joints.specimen.centre[second] - joints.specimen.centre[first];
  const Vec2 back = (0.02 * joints.specimen.bonding_gap / norm(between)) * between;
  joints.discs.displacement[second] += Pack{back.x, back.y, 0, 0};
  joints.contacts.meet(joints.discs);
  CHECK_FALSE(joints.contacts.has_met(k));
  joints.discs.displacement[second] -= Pack{back.x, back.y, 0, 0};
  joints.contacts.meet(joints.discs);
  CHECK(joints.contacts.has_met(k));
  joints.discs.displacement.assign(joints.discs.displacement.size(), Pack{});
  joints.contacts.meet(joints.discs);
  CHECK(joints.contacts.has_met(k));
  CHECK(joints.contacts.contacts().stiffness(k).bond == 0);
  for (std::size_t bonded = 0; bonded < joints.bonded; ++bonded)
    CHECK(joints.contacts.contacts().stiffness(bonded).bond == 1);
}

TEST_CASE("the pieces and crossings lie on the fracture") {
  const Joints joints(two_fractures(1));
  const auto& contacts = joints.contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const hfdem::NaturalFracture& f = joints.specimen.joints.fractures[contacts.pair(k).fracture];
    const auto [first, second] = contacts.pair(k).bodies;
    const Vec2 at = contacts.crossing(k), a = joints.specimen.centre[first];
    const Vec2 b = joints.specimen.centre[second];
    CHECK(std::abs(cross(f.direction(), at - f.from)) < 1e-12 * f.length());
    CHECK(std::abs(cross(b - a, at - a)) < 1e-12 * dot(b - a, b - a));
    CHECK(dot(contacts.pair(k).normal, b - a) > 0);
    if (!contacts.has_met(k)) continue;
    const auto [from, to] = contacts.ends(k);
    CHECK(norm(from - (f.from + contacts.piece(k).begin * f.direction())) < 1e-15);
    CHECK(norm(to - from) == near(contacts.piece(k).length(), 1e-9));
  }
}

TEST_CASE("a fracture that closes evenly pushes its sides apart by stiffness times length") {
  for (const double closure : {2e-6, -2e-6}) {
    Joints joints(two_fractures(2));
    const hfdem::NaturalFracture& f = joints.specimen.joints.fractures[0];
    const auto is_above = [&](std::size_t i) {
      return dot(joints.specimen.centre[i] - f.from, f.normal()) > 0;
    };
    for (std::size_t i = 0; i < joints.discs.size(); ++i)
      if (is_above(i)) {
        const Vec2 move = -closure * f.normal();
        joints.discs.displacement[i] = Pack{move.x, move.y, 1e-3, 1e-3};  // and it turns
      }
    joints.evaluate();
    Vec2 up, down;
    for (std::size_t i = 0; i < joints.discs.size(); ++i)
      (is_above(i) ? up : down) = (is_above(i) ? up : down) + joints.force_on(i);
    const double expected = joint::k_n * closure * f.length();  // bonds pull, too
    CHECK(dot(up, f.normal()) == near(expected, 1e-10));
    CHECK(std::abs(dot(up, f.direction())) < 1e-10 * std::abs(expected));
    CHECK(norm(up + down) < 1e-12 * std::abs(expected));
  }
}

TEST_CASE("joints push no momentum into the discs, and never turn them") {
  Joints joints(two_fractures(3));
  test::Random random(3);
  test::shake(joints.discs, 5e-6, random);
  for (std::size_t k = 0; k < joints.bonded; k += 3) joints.contacts.contacts().break_bond(k);
  joints.evaluate();
  Vec2 sum;
  double largest = 0;
  for (std::size_t i = 0; i < joints.discs.size(); ++i) {
    sum = sum + joints.force_on(i);
    largest = std::fmax(largest, norm(joints.force_on(i)));
    CHECK(joints.forces.total(i)[2] == 0);
    CHECK(joints.forces.total(i)[3] == 0);
  }
  CHECK(largest > 1e2);
  CHECK(norm(sum) < 1e-13 * largest);
}

TEST_CASE(
    "discs that have not met feel nothing of each other, and stand for their share once they do") {
  Joints joints(two_fractures(5));
  const std::size_t k = joints.bonded + 1;
  const auto [first, second] = joints.contacts.pair(k).bodies;
  const Vec2 normal = joints.contacts.pair(k).normal, move = -1e-6 * normal;
  joints.discs.displacement[second] = Pack{move.x, move.y, 0, 0};
  const auto row = [&](std::size_t c) {
    const Pack force = joints.forces.rows()[c];
    return Vec2{force[0], force[1]};
  };
  joints.evaluate();
  CHECK(joints.contacts.contacts().motion(k, joints.discs.displacement).opening == near(-1e-6));
  for (std::size_t c = joints.bonded; c < joints.contacts.size(); ++c) CHECK(row(c) == Vec2{});

  joints.bring_together(k);
  joints.contacts.meet(joints.discs);
  joints.evaluate();
  const double closure = -joints.contacts.contacts().motion(k, joints.discs.displacement).opening;
  REQUIRE(closure > 0);
  CHECK(dot(row(k), normal) ==
        near(joint::k_n * (closure + joints.contacts.contacts().memory(k).dilation) *
                 joints.contacts.piece(k).length(),
             1e-10));
}

TEST_CASE("the bits of joints do not depend on the number of threads") {
  const auto rows = [](int threads) {
    test::Random random(6);
    hfdem::Specimen s = test::jittered_discs(300, 2, random);
    test::add_fracture(s, {0, 0.5 * s.height}, {s.width, 0.52 * s.height}, reach);
    Joints joints(s);
    REQUIRE(joints.contacts.size() > 2 * 64 * hfdem::pack_width);  // what a thread takes at a time
    std::vector<std::uint64_t> words;
    for (int step = 0; step < 3; ++step) {
      test::shake(joints.discs, 4e-6, random);
      joints.evaluate(threads);
      joints.contacts.contacts().break_bonds(joints.discs.displacement, joints.forces.rows(),
                                             [&](Index k, hfdem::Mode) { words.push_back(k); });
      for (const Pack& row : joints.forces.rows())
        for (std::size_t lane = 0; lane < 2; ++lane) words.push_back(test::bits(row[lane]));
    }
    return words;
  };
  const auto alone = rows(1);
  for (const int threads : {2, 3, 5}) CHECK(rows(threads) == alone);
}
