// The linear parallel bond on one contact: stiffness, slip, and what is left when it has broken.
#include <hfdem/contact/linear_parallel_bond.hpp>

#include <doctest/doctest.h>

#include "laws/sample_rock.hpp"
#include "near.hpp"

namespace {

using test::Move;
namespace sample = test::sample;
using test::near;

const test::Bond law(test::sample_rock);
const auto bonded = law.stiffness(test::small_disc, test::large_disc);
const auto broken = law.broken(bonded);

hfdem::Reaction<double> reaction(const test::Bond::Stiffness<double>& k, const Move& motion) {
  return law.respond<double>(k, {}, motion).reaction();
}

/// A contact led along a path of motions, remembering its slip.
class Path {
 public:
  explicit Path(const test::Bond::Stiffness<double>& k) : k_(k) {}

  /// Leads the contact straight to a new motion in equal steps. Forces are linear between kinks, so
  /// the trapezoidal rule gives the work exactly when the kinks lie on steps.
  hfdem::Reaction<double> lead_to(const Move& end, int steps = 1) {
    const Move start = motion_;
    for (int n = 1; n <= steps; ++n) {
      const double share = static_cast<double>(n) / steps;
      const Move next{start.opening + share * (end.opening - start.opening),
                      start.shear + share * (end.shear - start.shear),
                      start.rotation + share * (end.rotation - start.rotation)};
      const auto response = law.respond<double>(k_, memory_, next);
      const auto r = response.reaction();
      work_ -= (r.normal + last_.normal) / 2 * (next.opening - motion_.opening) +
               (r.shear + last_.shear) / 2 * (next.shear - motion_.shear) -
               (r.moment + last_.moment) / 2 * (next.rotation - motion_.rotation);
      memory_ = response.memory;
      motion_ = next;
      last_ = r;
    }
    return last_;
  }

  double work() const { return work_; }  // done on the contact, J/m per m
  double shear_offset() const { return memory_.shear_offset; }

 private:
  test::Bond::Stiffness<double> k_;
  test::Bond::Memory<double> memory_{};
  Move motion_;
  hfdem::Reaction<double> last_{};
  double work_ = 0;
};

}  // namespace

TEST_CASE("a contact has the section of its smaller disc and the length of both") {
  CHECK(bonded.normal == near(sample::k_n));
  CHECK(bonded.bond == near(sample::bond_k_n));
  CHECK(bonded.bond_radius == near(sample::bond_radius));

  const auto swapped = law.stiffness(test::large_disc, test::small_disc);
  CHECK(swapped.normal == bonded.normal);
  CHECK(swapped.bond == bonded.bond);
  CHECK(swapped.bond_radius == bonded.bond_radius);

  const auto equal = law.stiffness(test::large_disc, test::large_disc);
  CHECK(equal.normal == near(test::sample_rock.E));
  CHECK(equal.bond == near(test::sample_rock.bond_E));
}

TEST_CASE("the tangent springs are those of both parts together") {
  const hfdem::Springs whole = law.springs(bonded);
  CHECK(whole.normal == near(sample::k_n + sample::bond_k_n));
  CHECK(whole.shear == near(sample::k_s + sample::bond_k_s));
  CHECK(whole.moment == near(sample::bond_k_m));

  const hfdem::Springs rest = law.springs(broken);
  CHECK(rest.normal == near(sample::k_n));
  CHECK(rest.shear == near(sample::k_s));
  CHECK(rest.moment == 0);
}

TEST_CASE("a bonded contact resists pressing with both parts and pulling with its bond alone") {
  CHECK(reaction(bonded, {.opening = -2e-6}).normal ==
        near((sample::k_n + sample::bond_k_n) * 2e-6));
  CHECK(reaction(bonded, {.opening = 2e-6}).normal == near(-sample::bond_k_n * 2e-6));
  CHECK(reaction(bonded, {}).normal == 0);
}

TEST_CASE("a bonded contact resists shear with both parts while it does not slip") {
  // Pressed hard enough: 0.4 k_n 9 um > k_n / 2 times 2 um.
  for (const double shear : {2e-6, -2e-6}) {
    const auto r = reaction(bonded, {.opening = -9e-6, .shear = shear});
    CHECK(r.shear == near(-(sample::k_s + sample::bond_k_s) * shear));
  }
  CHECK(reaction(bonded, {.opening = 1e-6, .shear = 2e-6}).shear == near(-sample::bond_k_s * 2e-6));
}

TEST_CASE("a bond resists rotation with its bending stiffness") {
  for (const double rotation : {1e-4, -1e-4}) {
    CHECK(reaction(bonded, {.rotation = rotation}).moment == near(sample::bond_k_m * rotation));
    CHECK(reaction(broken, {.opening = -1e-6, .rotation = rotation}).moment == 0);
  }
}

TEST_CASE("a broken contact presses and rubs, but neither pulls nor bends") {
  const auto open = reaction(broken, {.opening = 1e-3, .shear = 1e-3, .rotation = 1e-2});
  CHECK(open.normal == 0);
  CHECK(open.shear == 0);
  CHECK(open.moment == 0);
  CHECK(reaction(broken, {.opening = -2e-6}).normal == near(sample::k_n * 2e-6));
}

TEST_CASE("the shear force of a broken contact ends at friction times its normal force") {
  const double pressed = 5e-6, limit = 0.4 * sample::k_n * pressed, slips_at = limit / sample::k_s;
  for (const double way : {1.0, -1.0}) {
    const auto shear_at = [&](double factor) {
      return reaction(broken, {.opening = -pressed, .shear = way * factor * slips_at}).shear;
    };
    CHECK(shear_at(0.5) == near(-way * 0.5 * limit));
    CHECK(shear_at(1 - 1e-9) == near(-way * (1 - 1e-9) * limit));
    CHECK(shear_at(1.5) == near(-way * limit));
    CHECK(shear_at(1e4) == near(-way * limit));
  }
}

TEST_CASE("a contact that has slipped unloads elastically") {
  const double pressed = 5e-6, limit = 0.4 * sample::k_n * pressed, slips_at = limit / sample::k_s;
  Path path(broken);
  const auto shear_to = [&](double factor) {
    return path.lead_to({.opening = -pressed, .shear = factor * slips_at}).shear;
  };
  CHECK(shear_to(3) == near(-limit));
  CHECK(shear_to(2.5) == near(-0.5 * limit));
  CHECK(shear_to(1.5) == near(0.5 * limit));
  CHECK(shear_to(0) == near(limit));  // slips back
  CHECK(shear_to(0.75) == near(0.25 * limit));
}

TEST_CASE("nothing is remembered where nothing slips") {
  Path path(broken);
  path.lead_to({.opening = -5e-6});
  path.lead_to({.opening = -5e-6, .shear = 3e-6});
  path.lead_to({.opening = -4e-6, .shear = -1e-6});
  CHECK(path.shear_offset() == 0);
}

TEST_CASE("a contact stores what was spent on it, but for what slip took") {
  // From rest in straight lines, without slip and with both parts pressed or the bond pulled.
  for (const Move& end :
       {Move{-9e-6, 2e-6, 1e-4}, Move{-9e-6, -1e-6, -3e-4}, Move{3e-6, 0, 2e-4}}) {
    Path path(bonded);
    path.lead_to({.opening = end.opening});
    path.lead_to(end);
    CHECK(law.energy<double>(bonded, {path.shear_offset()}, end) == near(path.work()));
  }
  // What slipped is gone: half the limit over the elastic part of the way is left.
  const double pressed = 5e-6, limit = 0.4 * sample::k_n * pressed, slips_at = limit / sample::k_s;
  Path path(broken);
  const Move end{.opening = -pressed, .shear = 7 * slips_at};
  path.lead_to({.opening = -pressed});
  path.lead_to(end);
  CHECK(law.energy<double>(broken, {path.shear_offset()}, end) ==
        near(sample::k_n * pressed * pressed / 2 + limit * slips_at / 2));
  CHECK(law.energy<double>(broken, {}, Move{.opening = 1e-6}) == 0);
}

TEST_CASE("work spent on slip is the friction force times the slip") {
  const double pressed = 5e-6, limit = 0.4 * sample::k_n * pressed, slips_at = limit / sample::k_s;
  constexpr int per_slip_distance = 8;
  Path path(broken);
  path.lead_to({.opening = -pressed});
  const double pressing = sample::k_n * pressed * pressed / 2;
  CHECK(path.work() == near(pressing));

  const auto shear_to = [&](double factor, int distances) {
    path.lead_to({.opening = -pressed, .shear = factor * slips_at}, distances * per_slip_distance);
  };
  const double stored = limit * slips_at / 2;
  shear_to(3, 3);  // elastic over one slip distance, slipping over two
  CHECK(path.work() == near(pressing + stored + 2 * limit * slips_at));
  shear_to(-3, 6);  // gives back, loads and slips over four
  CHECK(path.work() == near(pressing + stored + 6 * limit * slips_at));
  shear_to(3, 6);
  shear_to(2, 1);  // gives back what it stored
  CHECK(path.work() == near(pressing + 10 * limit * slips_at));
}

TEST_CASE("relief of the normal force lets a sheared contact slip for good") {
  const double pressed = 5e-6, limit = 0.4 * sample::k_n * pressed, slips_at = limit / sample::k_s;
  Path path(broken);
  const auto go = [&](double press, double shear) {
    return path.lead_to({.opening = -press, .shear = shear}).shear;
  };
  CHECK(go(pressed, 0.8 * slips_at) == near(-0.8 * limit));
  CHECK(go(pressed / 2, 0.8 * slips_at) == near(-0.5 * limit));
  CHECK(go(pressed, 0.8 * slips_at) == near(-0.5 * limit));
  CHECK(go(-1e-6, 0.8 * slips_at) == 0);
  CHECK(go(pressed, 0.8 * slips_at) == near(0).scale(limit));
  CHECK(go(pressed, 0.9 * slips_at) == near(-0.1 * limit, 1e-10));
}
