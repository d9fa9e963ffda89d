// A state as bytes: it comes back as it was, or is refused.
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <hfdem/base/archive.hpp>
#include <hfdem/base/pack.hpp>
#include <hfdem/state/contact.hpp>
#include <hfdem/state/injection.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

namespace {

using hfdem::Loader;
using hfdem::Saver;

/// A value of every kind.
struct Everything {
  bool flag = false;
  int number = 0;
  std::uint64_t large = 0;
  double value = 0;
  hfdem::Mode mode = hfdem::Mode::tension;
  std::string text{};
  hfdem::Vec2 point{};
  std::optional<double> given{}, missing = 1.0;
  std::vector<double> list{};
  std::vector<bool> flags{};
  std::vector<std::string> texts{};
  std::vector<hfdem::Pack> rows = std::vector<hfdem::Pack>(2);
  hfdem::Injection described{};

  void exchange(auto& archive) {
    archive(flag, number, large, value, mode, text, point, given, missing, list, flags, texts,
            std::span(rows), described);
  }
};

Everything example() {
  return {.flag = true,
          .number = -7,
          .large = std::numeric_limits<std::uint64_t>::max(),
          .value = -0.0,
          .mode = hfdem::Mode::shear,
          .text = "in words",
          .point = {1.5, -2},
          .given = NAN,
          .missing = {},
          .list = {1, 0.1, 5e-324},
          .flags = {true, false, true},
          .texts = {"one", "", "three"},
          .rows = {hfdem::Pack{1, 2, 3, 4}, hfdem::Pack{5, 6, 7, 8}},
          .described = {.rate = 3e-4,
                        .position = hfdem::Vec2{0.1, 0.2},
                        .schedule = {{0.3, 1e-4}, {0.6, 0}},
                        .further_points = {{0.3, 0.4}}}};
}

struct Rows {
  std::vector<double> rows;
  void exchange(auto& archive) { archive(std::span(rows)); }
};

template <class... Parts>
std::string sealed(const Parts&... parts) {
  Saver saver;
  saver(parts...);
  return saver.sealed();
}

/// Why a file is refused; empty if it is not.
template <class Value = Everything>
std::string refusal(const std::string& bytes, Value value = {}) {
  try {
    Loader loader(bytes, "out/checkpoint");
    loader(value);
    loader.finish();
  } catch (const hfdem::InvalidParameter& e) {
    return e.what();
  }
  return {};
}

bool begins(const std::string& text, const std::string& with) {
  return text.compare(0, with.size(), with) == 0;
}

}  // namespace

TEST_CASE("every kind of value comes back to the last bit") {
  const Everything whole = example();
  Loader loader(sealed(whole), "a file");
  Everything back;
  loader(back);
  loader.finish();
  CHECK(back.flag);
  CHECK(back.number == -7);
  CHECK(back.large == whole.large);
  CHECK(test::bits(back.value) == test::bits(-0.0));
  CHECK(back.mode == hfdem::Mode::shear);
  CHECK(back.text == whole.text);
  CHECK(back.point == whole.point);
  REQUIRE(back.given);
  CHECK(std::isnan(*back.given));
  CHECK(!back.missing);
  CHECK(back.list == whole.list);
  CHECK(back.flags == whole.flags);
  CHECK(back.texts == whole.texts);
  for (std::size_t lane = 0; lane < 4; ++lane)
    CHECK(test::bits(back.rows[1][lane]) == test::bits(static_cast<double>(5 + lane)));
  CHECK(back.described.rate == 3e-4);
  CHECK(back.described.position == whole.described.position);
  REQUIRE(back.described.schedule.size() == 2);
  CHECK(back.described.schedule[0].rate == 1e-4);
  CHECK(back.described.schedule[1].time == 0.6);
  CHECK(back.described.further_points == whole.described.further_points);
}

TEST_CASE("the checksum is the one of the literature") {
  // Test vectors of the 64-bit FNV-1a hash, from draft-eastlake-fnv.
  CHECK(hfdem::detail::checksum("") == 0xcbf29ce484222325);
  CHECK(hfdem::detail::checksum("a") == 0xaf63dc4c8601ec8c);
  CHECK(hfdem::detail::checksum("foobar") == 0x85944171f73967e8);
}

TEST_CASE("a file with any one bit turned is refused") {
  const std::string sound = sealed(example());
  CHECK(refusal(sound).empty());
  for (std::size_t place = 0; place < sound.size(); ++place)
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = sound;
      damaged[place] = static_cast<char>(damaged[place] ^ (1 << bit));
      CHECK(begins(refusal(damaged), "out/checkpoint is "));
    }
}

TEST_CASE("a file cut off at any place, or with something behind it, is refused") {
  const std::string sound = sealed(example());
  for (std::size_t length = 0; length < sound.size(); ++length)
    CHECK(begins(refusal(sound.substr(0, length)), "out/checkpoint is "));
  CHECK(begins(refusal(sound.substr(0, sound.size() - 1)),
               "out/checkpoint is cut off or damaged: it has "));
  CHECK(begins(refusal(sound + "x"), "out/checkpoint is cut off or damaged: it has "));
  CHECK(begins(refusal(sound + sound), "out/checkpoint is cut off or damaged: it has "));
}

TEST_CASE("what is no state of this format is said to be none") {
  CHECK(refusal("") == "out/checkpoint is no saved state: it does not begin with \"hfdem state \"");
  CHECK(refusal("hfdem specimen 1\nwidth 0.3") ==
        "out/checkpoint is no saved state: it does not begin with \"hfdem state \"");
  CHECK(refusal("hfdem state 2\n") ==
        "out/checkpoint is of another version of the format than the only one known, 1");
  CHECK(refusal("hfdem state 1\n") == "out/checkpoint is cut off at byte 14");
}

TEST_CASE("a sound file of something else is refused with the place") {
  const std::string at_first = "out/checkpoint does not fit this run, at byte 30: ";
  CHECK(refusal(sealed(Rows{{1, 2}}), Rows{{0, 0, 0}}) ==
        at_first + "2 values stand where 3 should");
  CHECK(refusal(sealed(std::uint64_t{1} << 40), std::vector<double>{}) ==
        at_first + "a list of 1099511627776 entries should begin, which is too long");
  CHECK(refusal(sealed(2), true) == at_first + "2 stands before it, where a smaller number should");
  CHECK(refusal(sealed(1.0, 2.0), 1.0) == at_first + "8 bytes follow the last value that is known");
  CHECK(refusal(sealed(true), 1.0).empty());  // eight bytes either way: only what does not fit
  CHECK(refusal(sealed(1.0), hfdem::Vec2{}) == at_first + "8 bytes should follow, and 0 do");
}
