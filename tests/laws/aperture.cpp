// The hyperbolic aperture: its named points, its limits, and no jumps between them.
#include <hfdem/aperture/hyperbolic.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

namespace {

using test::near;

constexpr double w0 = 6e-6, F0 = 1e5;
const hfdem::HyperbolicAperture law({.w0 = w0, .F0 = F0});

}  // namespace

TEST_CASE("the aperture halves at F0 and goes on as a hyperbola") {
  CHECK(law.rest_width() == w0);
  CHECK(law.width(w0, 0, 0) == w0);
  CHECK(law.width(w0, F0, 0) == near(w0 / 2));
  CHECK(law.width(w0, 3 * F0, 0) == near(w0 / 4));
}

TEST_CASE("each channel has its own rest width") {
  constexpr double joint = 1e-4;
  CHECK(law.width(joint, F0, 0) == near(joint / 2));
  CHECK(law.width(joint, 0, 2e-6) == near(joint + 2e-6));
}

TEST_CASE("an open channel is as wide as its gap and its rest width") {
  CHECK(law.width(w0, 0, 3e-6) == near(9e-6));
  CHECK(law.width(w0, 0, 1e-3) == near(1.006e-3));
  CHECK(law.width(w0, 0, -1e-6) == w0);  // slack, neither pressed nor open
}

TEST_CASE("the aperture has no jump where the force vanishes") {
  CHECK(law.width(w0, 1e-9 * F0, 0) == near(w0, 1e-8));
  CHECK(law.width(w0, 0, 1e-9 * w0) == near(w0, 1e-8));
}

TEST_CASE("more force closes the aperture without ever shutting it; more gap opens it") {
  double last = law.width(w0, 0, 0);
  for (double force = 1; force < 1e12; force *= 3) {
    const double width = law.width(w0, force, 0);
    CHECK(width < last);
    CHECK(width > 0);
    last = width;
  }
  CHECK(law.width(w0, 1e12, 0) * 1e12 == near(w0 * F0, 1e-6));  // the far end of the hyperbola
  last = law.width(w0, 0, 0);
  for (double gap = 1e-9; gap < 1e-2; gap *= 3) {
    CHECK(law.width(w0, 0, gap) > last);
    last = law.width(w0, 0, gap);
  }
}
