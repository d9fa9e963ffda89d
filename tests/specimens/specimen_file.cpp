// Specimens as text: the round trip, and the refusal of files that are not right.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <hfdem/base/errors.hpp>
#include <hfdem/setup/random_packing.hpp>
#include <hfdem/setup/specimen_file.hpp>
#include <hfdem/setup/square_array.hpp>

#include <doctest/doctest.h>

namespace {

using hfdem::Specimen;

std::string text_of(const Specimen& s) {
  std::ostringstream text;
  hfdem::write_specimen(text, s);
  return text.str();
}

Specimen from_text(const std::string& text) {
  std::istringstream in(text);
  return hfdem::read_specimen(in, "rock.txt");
}

void check_same(const Specimen& a, const Specimen& b) {
  CHECK(a.width == b.width);
  CHECK(a.height == b.height);
  CHECK(a.density == b.density);
  CHECK(a.bonding_gap == b.bonding_gap);
  CHECK(a.centre == b.centre);
  CHECK(a.radius == b.radius);
  CHECK(a.pairs == b.pairs);
}

const std::string sound =
    "hfdem specimen 1\n"   // 1
    "width 0.3\n"          // 2
    "height 0.6\n"         // 3
    "density 3169\n"       // 4
    "bonding_gap 8e-05\n"  // 5
    "discs 3\n"            // 6
    "0.1 0.2 0.004\n"      // 7
    "0.108 0.2 0.004\n"    // 8
    "0.116 0.2 0.005\n"    // 9
    "pairs 2\n"            // 10
    "0 1\n"                // 11
    "1 2\n";               // 12

/// What is said of the sound file after one replacement.
std::string refusal(const std::string& right, const std::string& wrong) {
  std::string text = sound;
  const auto at = text.find(right);
  REQUIRE(at != std::string::npos);
  text.replace(at, right.size(), wrong);
  try {
    from_text(text);
  } catch (const hfdem::InvalidParameter& e) {
    return e.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("a specimen survives writing and reading to the last bit") {
  const auto packing = hfdem::random_packing({.width = 0.1, .height = 0.15});
  check_same(packing, from_text(text_of(packing)));
  const auto array = hfdem::square_array(7, 5, 1.0 / 3);
  check_same(array, from_text(text_of(array)));

  const auto path = (std::filesystem::temp_directory_path() / "hfdem_specimen_test.txt").string();
  hfdem::save_specimen(path, packing);
  check_same(packing, hfdem::load_specimen(path));
  std::filesystem::remove(path);
}

TEST_CASE("a specimen is read from the text that is described") {
  const Specimen s = from_text(sound);
  CHECK(s.width == 0.3);
  CHECK(s.height == 0.6);
  CHECK(s.density == 3169);
  CHECK(s.bonding_gap == 8e-5);
  REQUIRE(s.size() == 3);
  CHECK(s.centre[2] == hfdem::Vec2{0.116, 0.2});
  CHECK(s.radius[2] == 0.005);
  CHECK(s.pairs == std::vector<hfdem::Pair>{{0, 1}, {1, 2}});
}

TEST_CASE("comments, empty lines, tabs and Windows line ends do not count") {
  CHECK(refusal("discs 3\n", "# the discs\r\n\n  discs\t3 # of them\r\n") == "accepted");
}

TEST_CASE("a file that is not right is refused with its name, the line and what is wrong") {
  const std::string file = "specimen file rock.txt, line ";
  CHECK(refusal("hfdem specimen 1", "solid rock 1") ==
        file + "1: this is no specimen file: it does not begin with \"hfdem specimen 1\"");
  CHECK(refusal("specimen 1", "specimen 2") ==
        file + "1: version 2 of the format is not known: only version 1 is");
  CHECK(refusal("height 0.6", "hight 0.6") == file + "3: \"hight\" stands where \"height\" should");
  CHECK(refusal("width 0.3", "width -0.3") ==
        file + "2: width = -0.3 is not allowed: it must be a number, greater than 0 m");
  CHECK(refusal("0.108 0.2 0.004", "0.108 0.2 -0.004") ==
        file +
            "8: radius = -0.004 is not allowed: it must be a number, greater than 0 m and at "
            "most 0.15 m");
  CHECK(refusal("0.108 0.2", "nan 0.2").find(file + "8: x = nan is not allowed") == 0);
  CHECK(refusal("0.108 0.2", "0.108 1e999").find(file + "8: y = 1e999 is not allowed") == 0);
  CHECK(refusal("0.108 0.2", "0.308 0.2") ==
        file + "8: x = 0.308 is not allowed: it must be a number, at least 0 m and at most 0.3 m");
  CHECK(refusal("0.108 0.2", "0.108 0,2").find(file + "8: y = 0,2 is not allowed") == 0);
  CHECK(refusal("0.108 0.2 0.004", "0.108 0.2") ==
        file + "8: \"0.108 0.2\" has 2 words where disc 1 of 3, \"x y radius\", should stand");
  CHECK(refusal("discs 3", "discs 4") ==
        file + "10: \"pairs 2\" has 2 words where disc 3 of 4, \"x y radius\", should stand");
  CHECK(refusal("discs 3", "discs 2") ==
        file + "9: \"0.116 0.2 0.005\" has 3 words where \"pairs\" and its value should stand");
  CHECK(refusal("discs 3", "discs -3").find(file + "6: discs = -3 is not allowed") == 0);
  CHECK(refusal("discs 3", "discs 3.5").find("must be a whole number") != std::string::npos);
  CHECK(refusal("pairs 2", "pairs 3") ==
        file + "12: ends where pair 2 of 3, \"first second\", should follow");
  CHECK(refusal("pairs 2", "pairs 1") == file + "12: the file should end before this line");
  CHECK(refusal("1 2\n", "1 3\n") ==
        file +
            "12: second disc = 3 is not allowed: it must be a whole number, at least 2 and at "
            "most 2");
  CHECK(refusal("1 2\n", "1 1\n").find(file + "12: second disc = 1 is not allowed") == 0);
  CHECK(refusal("1 2\n", "0 1\n") == file + "12: discs 0 and 1 are a pair twice");
  CHECK(refusal(sound, "") == file + "0: ends where \"hfdem specimen 1\" should follow");
}

TEST_CASE("a file cut off at any place is refused") {
  // Except within its last number, where nobody can tell.
  for (std::size_t length = 0; length + 3 < sound.size(); ++length)
    CHECK_THROWS_AS(from_text(sound.substr(0, length)), hfdem::InvalidParameter);
}

TEST_CASE("a file that is not there is refused, one that cannot be written is said to be so") {
  CHECK_THROWS_AS(hfdem::load_specimen("no/such/file"), hfdem::InvalidParameter);
  CHECK_THROWS_AS(hfdem::save_specimen("no/such/file", hfdem::square_array(2, 2, 1)),
                  hfdem::WriteFailed);
}

TEST_CASE("until a new specimen is written whole, the old one stands") {
  const auto path = (std::filesystem::temp_directory_path() / "hfdem_old_specimen.txt").string();
  const auto old = hfdem::square_array(2, 2, 1), larger = hfdem::square_array(3, 3, 1);
  hfdem::save_specimen(path, old);
  std::filesystem::create_directory(path + ".part");
  CHECK_THROWS_AS(hfdem::save_specimen(path, larger), hfdem::WriteFailed);
  check_same(old, hfdem::load_specimen(path));
  std::filesystem::remove(path + ".part");
  hfdem::save_specimen(path, larger);
  check_same(larger, hfdem::load_specimen(path));
  std::filesystem::remove(path);
}
