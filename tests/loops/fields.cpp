// Parameters that describe themselves, and units.
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/fields.hpp>
#include <hfdem/base/units.hpp>
#include <hfdem/setup/square_array.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

using namespace hfdem::literals;
using hfdem::Range;
using hfdem::to_text;
using test::near;

namespace {

/// An entry of a list.
struct Bake {
  double start = 0, heat = 300;

  static constexpr auto fields() {
    using hfdem::Field;
    return std::tuple{Field{"start", &Bake::start, "s", hfdem::non_negative, "when"},
                      Field{"heat", &Bake::heat, "K", Range{273}, "how hot"}};
  }
};

struct Oven {
  double temperature = 450;
  int shelves = 2;
  bool fan = false;
  std::optional<double> timer{};
  hfdem::Vec2 position{};
  std::vector<hfdem::Vec2> vents{};
  std::vector<Bake> plan{};

  static constexpr auto fields() {
    using hfdem::Field;
    return std::tuple{
        Field{"temperature", &Oven::temperature, "K", Range{273, 600, true}, "of the air"},
        Field{"shelves", &Oven::shelves, "", Range{1}, "number of shelves"},
        Field{"fan", &Oven::fan, "", hfdem::any_number, "whether the fan turns"},
        Field{"timer", &Oven::timer, "s", hfdem::positive, "time to run"},
        Field{"position", &Oven::position, "m", hfdem::non_negative, "in the kitchen"},
        Field{"vents", &Oven::vents, "m", hfdem::non_negative, "in its wall"},
        Field{"plan", &Oven::plan, "", hfdem::any_number, "of the day"}};
  }
};

std::string refusal(const Oven& oven) {
  try {
    hfdem::validate(oven, "oven");
  } catch (const hfdem::InvalidParameter& refused) {
    return refused.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("numbers are written with as many digits as they need") {
  CHECK(to_text(0.1) == "0.1");
  CHECK(to_text(17e9) == "1.7e+10");
  CHECK(std::stod(to_text(1.0 / 3)) == 1.0 / 3);
}

TEST_CASE("a range says what it allows") {
  CHECK(to_text(hfdem::positive, "Pa") == "greater than 0 Pa");
  CHECK(to_text(hfdem::non_negative, "") == "at least 0");
  CHECK(to_text(Range{.high = 3, .open_high = true}, "m") == "less than 3 m");
  CHECK(to_text(Range{0, 90, false, true}, "deg") == "at least 0 deg and less than 90 deg");
  CHECK(to_text(Range{0, 1, true}, "") == "greater than 0 and at most 1");
  CHECK(to_text(hfdem::any_number, "m") == "any finite number");
}

TEST_CASE("a range contains its closed ends and not its open ones") {
  CHECK(Range{0, 1}.contains(0));
  CHECK(Range{0, 1}.contains(1));
  CHECK_FALSE(Range{0, 1, true}.contains(0));
  CHECK_FALSE(Range{0, 1, false, true}.contains(1));
  CHECK(hfdem::positive.contains(std::numeric_limits<double>::denorm_min()));
  CHECK_FALSE(hfdem::positive.contains(0));
  CHECK_FALSE(hfdem::non_negative.contains(-1));
}

TEST_CASE("values outside their range are refused by name, with the value and what is allowed") {
  CHECK(refusal({}) == "accepted");
  CHECK(refusal({.temperature = 273}) ==
        "oven.temperature = 273 K is not allowed: it must be greater than 273 K and at most 600 K");
  CHECK(refusal({.shelves = 0}) == "oven.shelves = 0 is not allowed: it must be at least 1");
  CHECK(refusal({.fan = true}) == "accepted");
  CHECK(refusal({.timer = 60}) == "accepted");
  CHECK(refusal({.timer = 0}) == "oven.timer = 0 s is not allowed: it must be greater than 0 s");
  CHECK(refusal({.position = {1, -2}}) ==
        "oven.position = -2 m is not allowed: it must be at least 0 m");
}

TEST_CASE("lists are refused by the entry that is out of range, and written as lists") {
  CHECK(refusal({.vents = {{1, 2}, {3, 4}}, .plan = {{0, 500}, {60, 300}}}) == "accepted");
  CHECK(refusal({.vents = {{1, 2}, {3, -4}}}) ==
        "oven.vents, entry 2 = -4 m is not allowed: it must be at least 0 m");
  CHECK(refusal({.plan = {{-1, 500}}}) ==
        "oven.plan, entry 1, start = -1 s is not allowed: it must be at least 0 s");
  CHECK(refusal({.plan = {{0, 500}, {60, 200}}}) ==
        "oven.plan, entry 2, heat = 200 K is not allowed: it must be at least 273 K");
  CHECK(to_text(std::vector<hfdem::Vec2>{{1, 0.5}, {3, 4}}) == "[[1, 0.5], [3, 4]]");
  CHECK(to_text(std::vector<Bake>{{0, 500}}) == "[[0, 500]]");
  CHECK(to_text(std::vector<Bake>{}) == "[]");
}

TEST_CASE("what is not a finite number is refused everywhere") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(refusal({.temperature = nan}) != "accepted");
  CHECK(refusal({.timer = infinity}) != "accepted");
  CHECK(refusal({.position = {nan, 0}}) != "accepted");
}

TEST_CASE("a square array refuses senseless counts and sizes") {
  CHECK_THROWS_AS(hfdem::square_array(1, 5, 1e-3), hfdem::InvalidParameter);
  CHECK_THROWS_AS(hfdem::square_array(5, 5, 0), hfdem::InvalidParameter);
}

TEST_CASE("units are those of the SI, whole numbers and fractions alike") {
  CHECK(2_m == 2);
  CHECK(5_mm == near(0.005));
  CHECK(6_um == near(6e-6));
  CHECK(3_s == 3);
  CHECK(7_Pa == 7);
  CHECK(8_MPa == near(8e6));
  CHECK(17_GPa == near(17e9));
  CHECK(100_cp == near(0.1));
  CHECK(30_deg == near(std::numbers::pi / 6));
  CHECK(2.5_m == 2.5);
  CHECK(2.5_mm == near(0.0025));
  CHECK(2.5_um == near(2.5e-6));
  CHECK(0.5_s == 0.5);
  CHECK(0.5_Pa == 0.5);
  CHECK(0.5_MPa == near(5e5));
  CHECK(0.5_GPa == near(5e8));
  CHECK(0.06_cp == near(6e-5));
  CHECK(22.5_deg == near(std::numbers::pi / 8));
}
