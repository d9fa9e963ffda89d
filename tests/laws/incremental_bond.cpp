// The incremental parallel bond beside the total one: on one contact, and in undamped motion.
#include <algorithm>
#include <cmath>
#include <vector>

#include <hfdem/assembly.hpp>
#include <hfdem/contact/incremental_parallel_bond.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/setup/square_array.hpp>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "laws/sample_rock.hpp"
#include "near.hpp"

namespace {

using Total = test::Bond;
using Incremental = hfdem::IncrementalParallelBond;

struct Break {
  hfdem::Index contact;
  int step;
  friend bool operator==(const Break&, const Break&) = default;
};

/// An array that is struck once: a disc of its middle gets a velocity, and nothing damps it.
template <class Law>
class Struck {
 public:
  explicit Struck(double speed)
      : specimen_(hfdem::square_array(12, 12, 5e-3)),
        body_(specimen_, hfdem::bonded_contacts<hfdem::FixedPairs>(specimen_), Law({}), {}, 0,
              0.5) {
    body_.drive(hfdem::Index{66}, {speed, 0.3 * speed});
  }
  void steps(int count) {
    for (int n = 0; n < count; ++n, ++step_) {
      body_.find_forces(1, [&](hfdem::Index contact, hfdem::Mode) {
        breaks.push_back({contact, step_});
      });
      body_.move(false, 1);
    }
  }
  const hfdem::Assembly<Law>& body() const { return body_; }

  std::vector<Break> breaks{};

 private:
  hfdem::Specimen specimen_;
  hfdem::Assembly<Law> body_;
  int step_ = 0;
};

}  // namespace

TEST_SUITE_BEGIN("incremental_bond");

TEST_CASE("step by step a contact comes to the forces of the total form") {
  const Total total(test::sample_rock);
  const Incremental incremental(test::sample_rock);
  auto k = total.stiffness(test::small_disc, test::large_disc);
  Total::Memory<double> slip{};
  Incremental::Memory<double> last{};
  test::Random random(3);
  test::Move move;
  int slipped = 0, apart = 0;
  for (int n = 0; n < 4000; ++n) {
    if (n == 2000) k = total.broken(k);
    move.opening = 0.99 * move.opening + random(-2e-7, 2e-7);
    move.shear += random(-2e-7, 2e-7);
    move.rotation += random(-2e-5, 2e-5);
    const auto t = total.respond<double>(k, slip, move);
    const auto i = incremental.respond<double>(k, last, move);
    CHECK(std::abs(i.reaction().normal - t.reaction().normal) < 1e-4);  // of some 1e5
    CHECK(std::abs(i.reaction().shear - t.reaction().shear) < 1e-4);
    CHECK(std::abs(i.reaction().moment - t.reaction().moment) < 1e-6);
    CHECK(incremental.energy<double>(k, i.memory, move) ==
          test::near(total.energy<double>(k, t.memory, move), 1e-9));
    const auto it = incremental.failure(k, i), tt = total.failure(k, t);
    CHECK((it.tension == tt.tension && it.shear == tt.shear));
    slipped += t.memory.shear_offset != slip.shear_offset;
    apart += t.linear_normal == 0;
    slip = t.memory;
    last = i.memory;
  }
  CHECK(slipped > 100);
  CHECK(apart > 100);
}

TEST_CASE("a break leaves nothing of what the bond bore") {
  const Incremental law(test::sample_rock);
  const auto k = law.stiffness(test::small_disc, test::large_disc);
  const auto stretched =
      law.respond<double>(k, {}, test::Move{.opening = 1e-6, .shear = 2e-6, .rotation = 1e-4});
  CHECK(stretched.bond_normal < 0);
  const auto after =
      law.respond<double>(law.broken(k), stretched.memory,
                          test::Move{.opening = 1e-6, .shear = 2e-6, .rotation = 1e-4});
  CHECK(after.reaction().normal == 0);
  CHECK(after.reaction().shear == 0);
  CHECK(after.reaction().moment == 0);
}

TEST_CASE("both forms move undamped discs alike, and break the same bonds in the same steps") {
  for (const double speed : {0.05, 0.6}) {
    CAPTURE(speed);
    Struck<Total> total(speed);
    Struck<Incremental> incremental(speed);
    total.steps(1500);
    incremental.steps(1500);
    CHECK(std::ranges::equal(total.breaks, incremental.breaks));
    if (speed > 0.5) CHECK(total.breaks.size() > 3);
    double largest = 0, difference = 0;
    for (std::size_t i = 0; i < 144; ++i)
      for (std::size_t lane = 0; lane < 3; ++lane) {
        const double u = total.body().discs().displacement[i][lane];
        largest = std::fmax(largest, std::abs(u));
        difference =
            std::fmax(difference, std::abs(incremental.body().discs().displacement[i][lane] - u));
      }
    CHECK(difference < 1e-9 * largest);
  }
}

TEST_SUITE_END();
