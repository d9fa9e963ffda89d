// The verification run against the staircase that the independent static solution predicts.
#include <doctest/doctest.h>

#include "near.hpp"
#include "physics/verification_run.hpp"
#include "truth/static_lattice.hpp"

using namespace test;

namespace {

constexpr double rate = 0.5e-4;

struct Predicted {
  std::vector<truth::BreakEvent> events;
  std::vector<double> times, lengths, openings;  ///< window means
};

/// Break events of 4 to 80 contacts, and means over +-0.02 s at t = 0.1, 0.2 ... 0.8 s.
const Predicted& predicted() {
  static const Predicted result = [] {
    Predicted p{
        .events = truth::staircase({}, 4, 80, rate), .times = {}, .lengths = {}, .openings = {}};
    for (int k = 1; k <= 8; ++k) {
      const double time = 0.1 * k;
      constexpr int points = 41;
      double length = 0, opening = 0;
      for (int i = 0; i < points; ++i) {
        const double at = time - 0.02 + 0.04 * i / (points - 1);
        const auto event = std::find_if(p.events.begin(), p.events.end(),
                                        [&](const auto& e) { return e.time > at; });
        truth::StaticSlit slit({}, event->broken_contacts);
        length += event->length / points;
        opening += slit.at_volume(rate * at).opening / points;
      }
      p.times.push_back(time);
      p.lengths.push_back(length);
      p.openings.push_back(opening);
    }
    return p;
  }();
  return result;
}

struct Deviations {
  Worst time, pressure, length, opening;
};

Deviations deviations(const VerificationRun& run) {
  Deviations d;
  int compared = 0;
  for (const auto& event : predicted().events) {
    if (event.broken_contacts < 16 || event.broken_contacts > 78) continue;
    for (const Advance& ours : run.advances) {
      if (ours.contacts != event.broken_contacts) continue;
      d.time.see(ours.time, event.time, event.length);
      if (event.time <= 0.8)
        d.pressure.see(ours.net_pressure, event.state.net_pressure, event.length);
      ++compared;
    }
  }
  CHECK(compared == 32);
  for (std::size_t k = 0; k < predicted().times.size(); ++k) {
    const double t = predicted().times[k];
    d.length.see(run.mean(&Sample::length, t), predicted().lengths[k], t);
    d.opening.see(run.mean(&Sample::opening, t), predicted().openings[k], t);
  }
  MESSAGE("largest deviations: break time "
          << d.time.deviation << " (at " << d.time.at << " m), net pressure "
          << d.pressure.deviation << " (" << d.pressure.at << " m), length " << d.length.deviation
          << " (" << d.length.at << " s), opening " << d.opening.deviation << " (" << d.opening.at
          << " s); mechanical steps " << run.mechanical_steps);
  return d;
}

void check_planar_and_symmetric(const VerificationRun& run) {
  CHECK(run.tips_always_equal);
  CHECK(run.off_plane == 0);
}

}  // namespace

TEST_SUITE("staircase") {
  TEST_CASE("under equilibrium control the run climbs the predicted staircase") {
    const auto d = deviations(equilibrium());
    CHECK(d.time.deviation < 0.02);
    CHECK(d.pressure.deviation < 0.05);
    CHECK(d.length.deviation < 0.015);
    CHECK(d.opening.deviation < 0.015);
    check_planar_and_symmetric(equilibrium());
  }

  TEST_CASE("under the paper's rule it does so within a few per cent") {
    const auto d = deviations(paper_rule());
    CHECK(d.time.deviation < 0.03);
    CHECK(d.pressure.deviation < 0.10);
    CHECK(d.length.deviation < 0.025);
    CHECK(d.opening.deviation < 0.02);
    check_planar_and_symmetric(paper_rule());
  }

  TEST_CASE("the default run stands beside the paper's") {
    const auto& end = paper_rule().end;
    // 5 % of the length; it moves in steps of a diameter at each tip.
    CHECK(std::abs(end.full_length() - 0.770) <= std::max(0.05 * 0.770, 2 * 0.010));
    CHECK(std::abs(end.aperture - 7.24e-5) <= 0.08 * 7.24e-5);
    CHECK(end.aperture - end.opening == test::near(6e-6, 1e-9));
  }
}
