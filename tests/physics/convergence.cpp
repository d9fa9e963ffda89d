// What halving and doubling the fluid step and the tolerance changes.
#include <algorithm>
#include <string>

#include <doctest/doctest.h>

#include "physics/verification_run.hpp"

using namespace test;

namespace {

struct Change {
  double tip;  ///< largest difference of a tip's position at the end, m
  Worst opening, time, pressure;
};

Change change(const VerificationRun& run, const VerificationRun& base, const std::string& what) {
  Change c{
      .tip = std::abs(run.end.tip_up - base.end.tip_up), .opening = {}, .time = {}, .pressure = {}};
  for (int k = 1; k <= 8; ++k)
    c.opening.see(run.mean(&Sample::opening, 0.1 * k), base.mean(&Sample::opening, 0.1 * k),
                  0.1 * k);
  const auto count = std::min(run.advances.size(), base.advances.size());
  for (std::size_t a = 0; a < count; ++a) {
    if (base.advances[a].contacts < 16 || base.advances[a].contacts > 78) continue;
    c.time.see(run.advances[a].time, base.advances[a].time, base.advances[a].time);
    c.pressure.see(run.advances[a].net_pressure, base.advances[a].net_pressure,
                   base.advances[a].time);
  }
  MESSAGE(what << ": length " << run.end.full_length() << " m, opening " << run.end.opening * 1e6
               << " um, changes: opening " << c.opening.deviation << ", break times "
               << c.time.deviation << ", net pressure at break " << c.pressure.deviation
               << "; mechanical steps " << run.mechanical_steps);
  return c;
}

}  // namespace

TEST_SUITE("convergence") {
  TEST_CASE("equilibrium control does not depend on fluid step and tolerance") {
    struct Variant {
      std::string what;
      hfdem::UniformPressure::Params scheme;
    } variants[] = {
        {"half the fluid step", {.fluid_dt = 0.5e-4, .equilibrium = true}},
        {"twice the fluid step", {.fluid_dt = 2e-4, .equilibrium = true}},
        {"half the tolerances",
         {.equilibrium = true, .volume_tolerance = 0.5e-3, .unbalanced_tolerance = 0.5e-3}},
        {"twice the tolerances",
         {.equilibrium = true, .volume_tolerance = 2e-3, .unbalanced_tolerance = 2e-3}}};
    for (const Variant& variant : variants) {
      CAPTURE(variant.what);
      const Change c = change(verify(variant.scheme), equilibrium(), variant.what);
      CHECK(c.tip <= 0.010 + 1e-9);
      CHECK(c.opening.deviation < 0.01);
      CHECK(c.time.deviation < 0.02);
      CHECK(c.pressure.deviation < 0.05);
    }
  }

  TEST_CASE("the paper's rule: the same study, reported") {
    const double dt = 1e-4;
    change(verify({.fluid_dt = dt / 2}), paper_rule(), "half the fluid step");
    change(verify({.fluid_dt = 2 * dt}), paper_rule(), "twice the fluid step");
    change(verify({.volume_tolerance = 0.005}), paper_rule(), "half the tolerance");
    change(verify({.volume_tolerance = 0.02}), paper_rule(), "twice the tolerance");
    CHECK(paper_rule().tips_always_equal);
  }
}
