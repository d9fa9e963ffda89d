// What a packing cannot be is refused in a sentence.
#include <limits>
#include <string>

#include <hfdem/base/errors.hpp>
#include <hfdem/setup/random_packing.hpp>

#include <doctest/doctest.h>

namespace {

std::string refusal(const hfdem::RandomPacking& p) {
  try {
    hfdem::random_packing(p);
  } catch (const hfdem::InvalidParameter& e) {
    return e.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("each bad field of a packing is named with its value and what is allowed") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal({.width = 0}) ==
        "specimen.width = 0 m is not allowed: it must be greater than 0 m");
  CHECK(refusal({.height = nan}) ==
        "specimen.height = nan m is not allowed: it must be greater than 0 m");
  CHECK(refusal({.porosity = 0.2}) ==
        "specimen.porosity = 0.2 is not allowed: it must be at least 0.02 and at most 0.14");
  CHECK(refusal({.porosity = 0}) ==
        "specimen.porosity = 0 is not allowed: it must be at least 0.02 and at most 0.14");
  CHECK(refusal({.radius_min = -1}) ==
        "specimen.radius_min = -1 m is not allowed: it must be greater than 0 m");
  CHECK(refusal({.radius_min = 6e-3}) ==
        "specimen.radius_min = 0.006 m is not allowed: it must be at most radius_max, which is "
        "0.005 m");
  CHECK(refusal({.height = 0.016}) ==
        "specimen.radius_max = 0.005 m is not allowed: it must be at most 0.004 m, a quarter of "
        "the specimen's smaller side, for two discs to lie side by side");
  CHECK(refusal({.radius_max = 2}).find("at most 0.25 m") != std::string::npos);
  CHECK(refusal({.grains = 0}) ==
        "specimen.grains = 0 is not allowed: it must be at least 1 and at most 1e+07");
  CHECK(refusal({.grains = -17511}).find("specimen.grains = -17511") == 0);
  CHECK(refusal({.seed = -1}) == "specimen.seed = -1 is not allowed: it must be at least 0");
  CHECK(refusal({.density = 0}).find("specimen.density = 0 kg/m3") == 0);
  CHECK(refusal({.bonding_gap = 1.5}).find("specimen.bonding_gap = 1.5") == 0);
  CHECK(refusal({.width = 1e6}) ==
        "specimen.width = 1e+06 m is not allowed: it must be at most 513.127 m: more than "
        "10,000,000 discs of this size would fit");
}

TEST_CASE("too few and too many grains for the box are refused with the numbers that fit") {
  // A disc of 3 to 5 mm has 51.3 mm2 on average; of 0.1 m by 0.1 m at most 98 % can be filled.
  const std::string few =
      "specimen.grains = 167 is not allowed: it must be at least 168 and at "
      "most 190 in this box, for a porosity at least 0.02 and at most 0.14";
  CHECK(refusal({.width = 0.1, .height = 0.1, .grains = 167}) == few);
  CHECK(refusal({.width = 0.1, .height = 0.1, .grains = 191}).find("at most 190") !=
        std::string::npos);
  CHECK(refusal({.width = 0.1, .height = 0.1, .grains = 168}) == "accepted");
  CHECK(refusal({.width = 0.1, .height = 0.1, .grains = 190}) == "accepted");
}

TEST_CASE("a packing of the fewest grains that a box can hold works") {
  CHECK(refusal({.width = 0.02, .height = 0.02}) == "accepted");
}
