// Which pairs of discs natural fractures part, against exact arithmetic, and which are refused.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <hfdem/base/random.hpp>
#include <hfdem/base/side_of_line.hpp>
#include <hfdem/setup/joints.hpp>
#include <hfdem/setup/random_packing.hpp>
#include <hfdem/setup/space_filling_curve.hpp>
#include <hfdem/setup/square_array.hpp>

#include <boost/multiprecision/cpp_int.hpp>
#include <doctest/doctest.h>

#include "near.hpp"
#include "refusal.hpp"

using namespace hfdem;

namespace {

// ---- the truth: all pairs, all fractures, fractions of whole numbers ---------------------------

using Rational = boost::multiprecision::cpp_rational;

struct ExactPoint {
  Rational x, y;
  explicit ExactPoint(Vec2 p) : x(p.x), y(p.y) {}
  ExactPoint(Rational x_, Rational y_) : x(std::move(x_)), y(std::move(y_)) {}
  ExactPoint operator-(const ExactPoint& o) const { return {x - o.x, y - o.y}; }
};
Rational cross(const ExactPoint& a, const ExactPoint& b) { return a.x * b.y - a.y * b.x; }

/// Whether a point is left of the fracture's line or on it, for one who looks up; above it or on
/// it, if the line is level.
bool is_left(const NaturalFracture& f, Vec2 point) {
  const ExactPoint from(f.from), to(f.to), p(point);
  if (from.y == to.y) return p.y >= from.y;
  return p.x <= from.x + (p.y - from.y) / (to.y - from.y) * (to.x - from.x);
}

/// Normal of a fracture, towards the side that is left by `is_left`, or away from it.
Vec2 normal_of(const NaturalFracture& f, bool to_left) {
  const double length = std::hypot(f.to.x - f.from.x, f.to.y - f.from.y);
  const Vec2 normal = (1 / length) * left_of(f.to - f.from);
  const bool points_left = normal.x < 0 || (normal.x == 0 && normal.y > 0);
  return points_left == to_left ? normal : -normal;
}

/// Pairs that fractures part where discs keep their sides.
std::vector<JointPair> parted_pairs(const Specimen& s, const std::vector<NaturalFracture>& all,
                                    double reach) {
  std::vector<std::vector<bool>> left(all.size());
  for (Index k = 0; k < all.size(); ++k)
    for (const Vec2 centre : s.centre) left[k].push_back(is_left(all[k], centre));
  std::vector<JointPair> pairs;
  for (Index i = 0; i < s.size(); ++i) {
    for (Index j = i + 1; j < s.size(); ++j) {
      const Vec2 between = s.centre[j] - s.centre[i];
      const double distance = std::hypot(between.x, between.y);
      if (distance - s.radius[i] - s.radius[j] > reach) continue;
      const double contact = s.radius[i] + (distance - s.radius[i] - s.radius[j]) / 2;
      double nearest = 0;
      std::optional<JointPair> best;
      for (Index k = 0; k < all.size(); ++k) {
        if (left[k][i] == left[k][j]) continue;
        const ExactPoint a(s.centre[i]), from(all[k].from);
        const ExactPoint ab = ExactPoint(s.centre[j]) - a, line = ExactPoint(all[k].to) - from;
        const Rational area = cross(ab, line);
        const Rational share = cross(from - a, line) / area, along = cross(from - a, ab) / area;
        if (along < 0 || along > 1) continue;
        const double off = std::abs(share.convert_to<double>() * distance - contact);
        if (best && off > nearest - 1e-9 * distance) continue;
        nearest = off;
        const double length = std::hypot(all[k].to.x - all[k].from.x, all[k].to.y - all[k].from.y);
        best = JointPair{
            {i, j}, k, along.convert_to<double>() * length, normal_of(all[k], left[k][j])};
      }
      if (best) pairs.push_back(*best);
    }
  }
  return pairs;
}

/// How many bonds of a disc the joints leave to the rock, and how many they are.
struct Hold {
  int rock = 0, joints = 0;
  /// On its side by one bond or none, and drawn to the other by more.
  bool hangs() const { return rock <= 1 && joints > rock; }
};

bool bonds(const Specimen& s, Index i, Index j) {
  return i != j && s.gap({std::min(i, j), std::max(i, j)}) <= s.bonding_gap;
}

const JointPair* joint_of(const std::vector<JointPair>& pairs, Index i, Index j) {
  const Pair bodies{std::min(i, j), std::max(i, j)};
  const auto at = std::ranges::find(pairs, bodies, &JointPair::bodies);
  return at == pairs.end() ? nullptr : &*at;
}

Hold hold_of(const Specimen& s, const std::vector<JointPair>& pairs, Index disc) {
  Hold hold;
  for (Index j = 0; j < s.size(); ++j)
    if (bonds(s, disc, j)) ++(joint_of(pairs, disc, j) ? hold.joints : hold.rock);
  return hold;
}

/// One after the other, discs that hang go over to the last of their neighbours across: what parted
/// them from others does so no longer, and the fracture now parts them from the disc that held them
/// where it runs beside the middle between both.
std::vector<JointPair> expected_pairs(const Specimen& s, const std::vector<NaturalFracture>& all,
                                      double reach) {
  std::vector<JointPair> pairs = parted_pairs(s, all, reach);
  for (Index disc = 0; disc < s.size(); ++disc) {
    if (!hold_of(s, pairs, disc).hangs()) continue;
    Index number = 0;
    std::vector<Index> left_behind;
    for (Index j = 0; j < s.size(); ++j) {
      if (!bonds(s, disc, j)) continue;
      const JointPair* joint = joint_of(pairs, disc, j);
      joint ? number = joint->fracture : (left_behind.push_back(j), 0);
    }
    std::erase_if(pairs, [&](const JointPair& p) {
      return p.bodies.first == disc || p.bodies.second == disc;
    });
    const NaturalFracture& f = all[number];
    const double length = std::hypot(f.to.x - f.from.x, f.to.y - f.from.y);
    const bool was_left = is_left(f, s.centre[disc]);
    for (const Index j : left_behind) {
      const Vec2 middle{(s.centre[disc].x + s.centre[j].x) / 2,
                        (s.centre[disc].y + s.centre[j].y) / 2};
      const double along = ((middle.x - f.from.x) * (f.to.x - f.from.x) +
                            (middle.y - f.from.y) * (f.to.y - f.from.y)) /
                           length;
      if (along <= 0 || along >= length) continue;
      const Pair bodies{std::min(disc, j), std::max(disc, j)};
      // The one left behind is where the disc was.
      pairs.push_back({bodies, number, along, normal_of(f, (bodies.second == j) == was_left)});
    }
  }
  std::ranges::sort(pairs, {}, &JointPair::bodies);
  return pairs;
}

double mean_radius(const Specimen& s) {
  return std::accumulate(s.radius.begin(), s.radius.end(), 0.0) / static_cast<double>(s.size());
}

void check_same(const std::vector<JointPair>& found, const std::vector<JointPair>& expected) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    CAPTURE(k);
    CHECK(found[k].bodies == expected[k].bodies);
    CHECK(found[k].fracture == expected[k].fracture);
    CHECK(std::abs(found[k].along - expected[k].along) < 1e-12);
    CHECK(norm(found[k].normal - expected[k].normal) < 1e-12);
  }
}

/// Random segments of all lengths and directions, many of which cross.
std::vector<NaturalFracture> scattered(std::size_t count, double size, std::uint64_t seed) {
  Random random(seed);
  const auto point = [&] {
    const double x = random.between(0, size);
    return Vec2{x, random.between(0, size)};
  };
  std::vector<NaturalFracture> fractures;
  for (std::size_t k = 0; k < count; ++k) {
    const NaturalFracture f{point(), point()};
    const double share = k % 3 == 0 ? 1 : 0.1;  // few long ones, many short ones
    fractures.push_back({f.from, f.from + share * (f.to - f.from)});
  }
  return fractures;
}

Specimen packing() { return random_packing({.width = 0.1, .height = 0.1, .seed = 4}); }

/// Two discs beside each other, the middle of their gap at (0.5, 0.5).
Specimen two_discs(double left_radius, double right_radius, double gap = 0) {
  return {.width = 1,
          .height = 1,
          .density = 1,
          .centre = {{0.5 - gap / 2 - left_radius, 0.5}, {0.5 + gap / 2 + right_radius, 0.5}},
          .radius = {left_radius, right_radius}};
}

}  // namespace

// ---- sides -------------------------------------------------------------------------------------

TEST_CASE("the side of a line is exact where rounding decides the plain formula") {
  Random random(7);
  int misjudged = 0, on_line = 0;
  for (int k = 0; k < 3000; ++k) {
    const auto draw = [&] { return Vec2{random.fraction(), random.fraction()}; };
    const Vec2 a = draw(), b = k % 3 == 0 ? 3 * a : draw();
    Vec2 p = k % 3 == 0 ? 5 * a : a + random.between(-1, 2) * (b - a);
    if (k % 3 == 1) p.x = std::nextafter(p.x, 2);
    const Rational exact = cross(ExactPoint(b) - ExactPoint(a), ExactPoint(p) - ExactPoint(a));
    const double plain = cross(b - a, p - a);
    misjudged += (plain > 0) - (plain < 0) != exact.sign();
    on_line += exact == 0;
    CHECK(side_of_line(a, b, p) == exact.sign());
    CHECK(side_of_line(b, a, p) == -exact.sign());
  }
  CHECK(misjudged > 100);
  CHECK(on_line > 100);
}

// ---- pairs -------------------------------------------------------------------------------------

TEST_CASE("joints in a random packing are those of exact arithmetic over all pairs") {
  Specimen s = packing();
  const auto fractures = scattered(24, 0.1, 1);
  insert_joints(s, fractures);
  CHECK(s.joints.pairs.size() > 80);
  check_same(s.joints.pairs, expected_pairs(s, fractures, mean_radius(s)));
  REQUIRE(s.joints.fractures.size() == fractures.size());
  CHECK(s.joints.fractures[23].from == fractures[23].from);

  const std::size_t far = s.joints.pairs.size();
  insert_joints(s, fractures, s.bonding_gap);
  CHECK(s.joints.pairs.size() < far);
  check_same(s.joints.pairs, expected_pairs(s, fractures, s.bonding_gap));
}

TEST_CASE("joints in a square array are exact along fractures through centres of discs") {
  Specimen s = square_array(14, 14, 5e-3);
  std::vector<NaturalFracture> fractures;
  const auto between = [&](Index a, Index b) { fractures.push_back({s.centre[a], s.centre[b]}); };
  between(17, 25), between(40, 32), between(20, 90), between(107, 51);  // level, upright
  between(30, 30 + 15 * 4), between(99 + 13 * 3, 99), between(5, 5 + 29 * 3), between(189, 150);
  for (const NaturalFracture& f : fractures) {
    insert_joints(s, {f});
    CHECK(!s.joints.pairs.empty());
    check_same(s.joints.pairs, expected_pairs(s, {f}, mean_radius(s)));
  }
  insert_joints(s, fractures);
  check_same(s.joints.pairs, expected_pairs(s, fractures, mean_radius(s)));
}

TEST_CASE("a fracture from its other end parts the same pairs, also where it meets centres") {
  for (Specimen s : {packing(), square_array(10, 10, 5e-3)}) {
    const NaturalFracture f{{0.015, 0.025}, {0.085, 0.095}}, back{f.to, f.from};
    insert_joints(s, {f});
    const auto forth = s.joints.pairs;
    insert_joints(s, {back});
    REQUIRE(forth.size() > 10);
    REQUIRE(forth.size() == s.joints.pairs.size());
    for (std::size_t k = 0; k < forth.size(); ++k) {
      CHECK(forth[k].bodies == s.joints.pairs[k].bodies);
      CHECK(forth[k].normal == s.joints.pairs[k].normal);
      CHECK(forth[k].along ==
            test::near(f.length() - s.joints.pairs[k].along, 1e-12).scale(f.length()));
    }
  }
}

TEST_CASE("the mirror image of a fractured packing has the mirror image of its joints") {
  Specimen s = packing();
  std::vector<NaturalFracture> fractures = scattered(24, 0.1, 2);
  const auto snapped = [](Vec2 p) {  // so that mirroring rounds nothing
    return Vec2{std::round(0x1p40 * p.x) * 0x1p-40, std::round(0x1p40 * p.y) * 0x1p-40};
  };
  s.width = 0.125;
  const auto mirrored = [&](Vec2 p) { return Vec2{s.width - p.x, p.y}; };
  for (Vec2& c : s.centre) c = snapped(c);
  for (NaturalFracture& f : fractures) f = {snapped(f.from), snapped(f.to)};
  Specimen image = s;
  for (Vec2& c : image.centre) c = mirrored(c);
  std::vector<NaturalFracture> images;
  for (const NaturalFracture& f : fractures) images.push_back({mirrored(f.from), mirrored(f.to)});

  insert_joints(s, fractures);
  insert_joints(image, images);
  auto expected = s.joints.pairs;
  REQUIRE(expected.size() > 80);
  for (JointPair& p : expected) p.normal.x = -p.normal.x;
  check_same(image.joints.pairs, expected);
}

TEST_CASE("a specimen that is numbered anew keeps its joints") {
  Specimen s = packing();
  const auto fractures = scattered(24, 0.1, 1);
  insert_joints(s, fractures);
  std::vector<Index> backwards(s.size());
  for (Index i = 0; i < s.size(); ++i) backwards[i] = static_cast<Index>(s.size()) - 1 - i;
  std::vector<JointPair> expected;
  for (const auto& [bodies, fracture, along, normal] : s.joints.pairs)
    expected.push_back(
        {{backwards[bodies.second], backwards[bodies.first]}, fracture, along, -normal});
  std::ranges::sort(expected, {}, &JointPair::bodies);
  const Specimen renamed = renumbered(s, backwards);
  CHECK(renamed.joints.fractures.size() == fractures.size());
  check_same(renamed.joints.pairs, expected);
}

TEST_CASE("a fracture that ends between two discs parts them if it reaches their line") {
  const auto pairs = [](double end, double gap) {
    Specimen s = two_discs(0.004, 0.004, gap);
    insert_joints(s, {{{0.5, 0.4}, {0.5, end}}});
    return s.joints.pairs;
  };
  CHECK(pairs(std::nextafter(0.5, 0), 0).empty());
  REQUIRE(pairs(0.5, 0).size() == 1);
  CHECK(pairs(std::nextafter(0.5, 1), 0.001).size() == 1);
  CHECK(pairs(0.6, 0.0039).size() == 1);
  CHECK(pairs(0.6, 0.0041).empty());  // farther apart than the mean radius
  const JointPair joint = pairs(0.52, 0)[0];
  CHECK(joint.bodies == Pair{0, 1});
  CHECK(joint.along == test::near(0.1, 1e-9));
  CHECK(joint.normal == Vec2{1, 0});
}

TEST_CASE("where two fractures cross, a pair belongs to that nearer to the middle of its gap") {
  // The middle of the centres is at 0.501.
  Specimen s = two_discs(0.003, 0.005);
  const auto fracture_of = [&](double x0, double x1) {
    insert_joints(s, {{{x0 - 0.1, 0.4}, {x0 + 0.1, 0.6}}, {{x1 + 0.1, 0.4}, {x1 - 0.1, 0.6}}});
    REQUIRE(s.joints.pairs.size() == 1);
    return s.joints.pairs[0].fracture;
  };
  CHECK(fracture_of(0.5002, 0.5008) == 0);
  CHECK(fracture_of(0.5008, 0.5002) == 1);
  CHECK(fracture_of(0.4993, 0.5008) == 0);
  CHECK(fracture_of(0.4991, 0.5008) == 1);
  CHECK(fracture_of(0.5, 0.5) == 0);
  CHECK(fracture_of(0.4995, 0.5005) == 0);  // equally near, but for rounding
  CHECK(fracture_of(0.5005, 0.4995) == 0);
}

// ---- discs that change sides --------------------------------------------------------------------

namespace {

/// A disc, number 0, with others around it, all alike and in contact with it; a level fracture
/// passes just above its centre. Each of the others rests on two more, farther out.
std::vector<JointPair> joints_around(const std::vector<double>& directions, double from = 0.45,
                                     double to = 0.55) {
  Specimen s{.width = 1, .height = 1, .density = 1, .bonding_gap = 1e-6};
  const auto beside = [&](Vec2 centre, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return centre + 0.008 * Vec2{std::cos(angle), std::sin(angle)};
  };
  s.centre.push_back({0.5, 0.5});
  for (const double d : directions) s.centre.push_back(beside(s.centre[0], d));
  for (Index k = 0; k < directions.size(); ++k)
    for (const double turn : {-30, 30})
      s.centre.push_back(beside(s.centre[k + 1], directions[k] + turn));
  s.radius.assign(s.centre.size(), 0.004);
  insert_joints(s, {{{from, 0.501}, {to, 0.501}}}, s.bonding_gap);
  return s.joints.pairs;
}

}  // namespace

TEST_CASE("a disc that hangs on its side of a fracture by one bond changes sides") {
  const auto gained = joints_around({30, 90, 150, 270});
  REQUIRE(gained.size() == 1);
  CHECK(gained[0].bodies == Pair{0, 4});
  CHECK(gained[0].along == test::near(0.05, 1e-9));
  CHECK(gained[0].normal == Vec2{0, -1});  // the disc counts as above now
  // By none: the fracture passes beyond it.
  CHECK(joints_around({30, 90, 150}).empty());
  // The middle between disc and bond, at x = 0.50346, is beyond the fracture's end or before it.
  CHECK(joints_around({30, 90, 150, 330}, 0.45, 0.503).empty());
  CHECK(joints_around({30, 90, 150, 330}, 0.45, 0.504).size() > 0);
}

TEST_CASE("a disc that as many bonds or two hold on its side of a fracture keeps it") {
  const auto two_below = joints_around({30, 90, 150, 240, 300});
  REQUIRE(two_below.size() == 3);
  for (Index k = 0; k < 3; ++k) {
    CHECK(two_below[k].bodies == Pair{0, k + 1});
    CHECK(two_below[k].normal == Vec2{0, 1});
  }
  CHECK(joints_around({90, 270}).size() == 1);
}

TEST_CASE("no disc beside fractures that keep apart hangs by one bond where it had a choice") {
  Specimen s = random_packing({.width = 0.2, .height = 0.2, .seed = 4});
  std::vector<NaturalFracture> fractures;
  for (const double x : {0.02, 0.06, 0.1, 0.14}) fractures.push_back({{x, 0.01}, {x + 0.05, 0.19}});
  const auto hanging = [&](const std::vector<JointPair>& pairs) {
    int count = 0;
    for (Index i = 0; i < s.size(); ++i) count += hold_of(s, pairs, i).hangs();
    return count;
  };
  CHECK(hanging(parted_pairs(s, fractures, mean_radius(s))) >= 3);
  insert_joints(s, fractures);
  CHECK(hanging(s.joints.pairs) == 0);
}

// ---- refusals ----------------------------------------------------------------------------------

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::string said_of(const std::vector<NaturalFracture>& fractures,
                    const std::vector<std::string>& names = {}) {
  return refusal([&] { check_fractures(fractures, 1, 0.5, names); });
}

}  // namespace

TEST_CASE("a fracture that cannot be meant is named with its ends and what is allowed") {
  const std::string allowed =
      " is not allowed: in this specimen x must be at least 0 m and at most 1 m, y at least 0 m "
      "and at most 0.5 m";
  const NaturalFracture sound{{0, 0}, {1, 0.5}}, rim{{1, 0}, {1, 0.5}};
  CHECK(said_of({sound, rim}) == "accepted");
  CHECK(said_of({sound, {{0.1, 0.2}, {1.2, 0.4}}}) ==
        "fracture 1: from (0.1, 0.2) m to (1.2, 0.4) m" + allowed);
  CHECK(said_of({{{0.1, 0.6}, {0.2, 0.4}}}) ==
        "fracture 0: from (0.1, 0.6) m to (0.2, 0.4) m" + allowed);
  CHECK(said_of({{{-0.1, 0.1}, {0.2, 0.4}}}, {"line 7 of fractures.csv"}) ==
        "line 7 of fractures.csv: from (-0.1, 0.1) m to (0.2, 0.4) m" + allowed);
  CHECK(said_of({{{0.1, 0.1}, {0.2, -0.4}}}).find(allowed) != std::string::npos);
  CHECK(said_of({{{0.1, 0.2}, {0.1, 0.2}}}) ==
        "fracture 0: from (0.1, 0.2) m to (0.1, 0.2) m is not allowed: its length must be greater "
        "than 0 m");
  CHECK(said_of({{{not_a_number, 0.2}, {0.1, 0.2}}}) ==
        "fracture 0: from (nan, 0.2) m to (0.1, 0.2) m is not allowed: its ends must be finite "
        "numbers");
  CHECK(
      said_of({{{0.1, 0.2}, {0.1, -1 / 0.0}}}).find("to (0.1, -inf) m is not allowed: its ends") !=
      std::string::npos);
  CHECK(said_of({sound, rim, {sound.to, sound.from}}, {"line 2", "line 3", "line 5"}) ==
        "line 5: from (1, 0.5) m to (0, 0) m is not allowed: it must differ from line 2, which has "
        "the same ends");
}

TEST_CASE("what is refused leaves the specimen as it was") {
  Specimen s = two_discs(0.004, 0.004);
  insert_joints(s, {{{0.5, 0.4}, {0.5, 0.6}}});
  CHECK(refusal([&] { insert_joints(s, {{{0.5, 0.4}, {0.5, 1.6}}}); }).find("fracture 0: ") == 0);
  s.bonding_gap = 1e-4;
  const auto with_reach = [&](double reach) {
    return refusal([&] { insert_joints(s, {{{0.4, 0.5}, {0.6, 0.5}}}, reach); });
  };
  CHECK(with_reach(9e-5) == "joints.reach = 9e-05 m is not allowed: it must be at least 1e-04 m");
  CHECK(with_reach(not_a_number) ==
        "joints.reach = nan m is not allowed: it must be at least 1e-04 m");
  CHECK(s.joints.pairs.size() == 1);
  CHECK(with_reach(1e-4) == "accepted");
  CHECK(s.joints.pairs.empty());
  insert_joints(s, {});
  CHECK(s.joints.fractures.empty());
  Specimen empty{.width = 1, .height = 1};
  insert_joints(empty, {{{0.4, 0.5}, {0.6, 0.5}}});
  CHECK(empty.joints.fractures.size() == 1);
}

TEST_CASE("a fracture at the injection or its crack is refused") {
  const Vec2 injection{0.5, 0.5};
  const NaturalFracture crack{{0.5, 0.484}, {0.5, 0.516}};
  const auto said = [&](const NaturalFracture& f, double clearance = 0.01) {
    return refusal([&] {
      keep_clear(std::vector{f}, injection, crack, clearance,
                 std::vector<std::string>{"line 4 of f.csv"});
    });
  };
  const std::string place =
      " at (0.5, 0.5) m with its crack from (0.5, 0.484) m to (0.5, 0.516) m; it must stay at "
      "least 0.01 m away";
  CHECK(said({{0.45, 0.51}, {0.55, 0.51}}) ==
        "line 4 of f.csv: from (0.45, 0.51) m to (0.55, 0.51) m is not allowed: it crosses the "
        "injection" +
            place);
  CHECK(said({{0.508, 0.4}, {0.508, 0.6}}) ==
        "line 4 of f.csv: from (0.508, 0.4) m to (0.508, 0.6) m is not allowed: it comes within "
        "0.008 m of the injection" +
            place);
  CHECK(said({{0.4, 0.525}, {0.6, 0.525}}).find("within 0.009 m") != std::string::npos);
  CHECK(said({{0.506, 0.524}, {0.6, 0.6}}) == "accepted");  // 3, 4, 5
  CHECK(said({{0.5059, 0.524}, {0.6, 0.6}}) != "accepted");
  CHECK(said({{0.511, 0.4}, {0.511, 0.6}}) == "accepted");
  CHECK(said({{0.5, 0.516}, {0.6, 0.6}}, 0) != "accepted");  // touching is crossing
  CHECK(said({{0.5001, 0.516}, {0.6, 0.6}}, 0) == "accepted");
  CHECK(said({{0.1, 0.1}, {0.2, 0.2}}, -1) ==
        "fractures.clearance = -1 m is not allowed: it must be at least 0 m");
  // A specimen without a preset crack.
  const NaturalFracture none{injection, injection}, passing{{0.508, 0.4}, {0.508, 0.6}};
  CHECK(refusal([&] {
          keep_clear(std::vector{passing}, injection, none, 0.0081);
        }).find("fracture 0: from") == 0);
  CHECK(refusal([&] { keep_clear(std::vector{passing}, injection, none, 0.0079); }) == "accepted");
  // The injection need not lie on the crack.
  CHECK(refusal([&] {
          keep_clear(std::vector{passing}, {0.515, 0.5}, {{0.1, 0.1}, {0.1, 0.2}}, 0.0079);
        }).find("within 0.007 m") != std::string::npos);
}
