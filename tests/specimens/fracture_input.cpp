// Natural fractures from TOML, and the choice of a reader by the file's ending.
#include "support/fracture_input.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "refusal.hpp"

using namespace hfdem;

namespace {

const std::string name = "hfdem_fractures_test.toml";

NamedFractures from_text(const std::string& text, const std::string& file = name) {
  std::ofstream(file) << text;
  const struct Removal {
    const std::string& file;
    ~Removal() { std::filesystem::remove(file); }
  } removal{file};
  return support::read_fractures(file);
}

std::string said_of(const std::string& text) {
  return refusal([&] { from_text(text); });
}

}  // namespace

TEST_CASE("fractures are read from TOML, with the lines where each begins") {
  const NamedFractures read = from_text(
      "# two\n[[fracture]]\nfrom = [0.1, 0.2]\nto = [0.3, 1]\n\n"
      "[[fracture]]\nto = [\n  1,\n  2e-1]\nfrom = [0, -0.5]\n");
  REQUIRE(read.fractures.size() == 2);
  CHECK(read.fractures[0].from == Vec2{0.1, 0.2});
  CHECK(read.fractures[0].to == Vec2{0.3, 1});
  CHECK(read.fractures[1].from == Vec2{0, -0.5});
  CHECK(read.fractures[1].to == Vec2{1, 0.2});
  CHECK(read.names == std::vector<std::string>{"line 2 of " + name, "line 6 of " + name});
}

TEST_CASE("TOML that is not right is refused with its line and what is wrong") {
  const std::string from = "[[fracture]]\nfrom = [0.1, 0.2]\n", of = " of " + name + ": ";
  CHECK(said_of(from) == "line 1" + of + "this fracture has no \"to = [x, y]\"");
  CHECK(said_of("\n[[fracture]]\nto = [1, 2]\n") ==
        "line 2" + of + "this fracture has no \"from = [x, y]\"");
  const std::string allowed = " is not allowed: it must be two finite numbers, [x, y]";
  CHECK(said_of(from + "to = 0.3\n") == "line 3" + of + "to = 0.3" + allowed);
  CHECK(said_of(from + "to = [0.3]\n") == "line 3" + of + "to = [0.3]" + allowed);
  CHECK(said_of(from + "to = [1, 2, 3]\n") == "line 3" + of + "to = [1, 2, 3]" + allowed);
  CHECK(said_of(from + "to = [0.3, nan]\n") == "line 3" + of + "to = [0.3, nan]" + allowed);
  CHECK(said_of(from + "to = [-inf, 1]\n") == "line 3" + of + "to = [-inf, 1]" + allowed);
  CHECK(said_of(from + "to = [\"a\", 1]\n") == "line 3" + of + "to = ['a', 1]" + allowed);
  CHECK(said_of(from + "to = [1, 2]\n\nwidth = 1\n") ==
        "line 5" + of + "there is no key \"width\" in a fracture; its keys are from, to");
  CHECK(said_of(from + "to = [1, 2]\n[injection]\nrate = 1\n") ==
        "line 4" + of + "\"injection\" is not known: there are only fractures, [[fracture]]");
  const std::string form = "a fracture is written as [[fracture]], with its ends below";
  CHECK(said_of("[fracture]\nfrom = [0.1, 0.2]\n") == "line 1" + of + form);
  CHECK(said_of("\nfracture = [1, 2]\n") == "line 2" + of + form);
  CHECK(said_of("# nothing\n") == name + " has no fracture: it needs at least one [[fracture]]");
  CHECK(said_of("fracture = []\n") ==
        name + " has no fracture: it needs at least one [[fracture]]");
  CHECK(said_of(from + "to = [1, 2\n").find("line 3" + of) == 0);
}

TEST_CASE("the ending of a file of fractures says how to read it") {
  CHECK(from_text("x1_m,y1_m,x2_m,y2_m\n1,2,3,4\n", "hfdem_fractures_test.csv").fractures.size() ==
        1);
  CHECK(refusal([] { from_text("", "fractures.txt"); }) ==
        "fracture file fractures.txt is not known by its ending: it must be .csv or .toml");
  CHECK(refusal([] { support::read_fractures("no/such.csv"); }) ==
        "fracture file no/such.csv cannot be read");
  CHECK(refusal([] { support::read_fractures("no/such.toml"); }).find("cannot read no/such.toml") ==
        0);
}
