// Natural fractures as tables: the round trip, and the refusal of files that are not right.
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <hfdem/base/random.hpp>
#include <hfdem/base/whole_file.hpp>
#include <hfdem/setup/fracture_file.hpp>

#include <doctest/doctest.h>

#include "refusal.hpp"

using namespace hfdem;

namespace {

NamedFractures from_text(const std::string& text) {
  std::istringstream in(text);
  return read_fracture_table(in, "fractures.csv");
}

std::string said_of(const std::string& text) {
  return refusal([&] { from_text(text); });
}

void check_same(const std::vector<NaturalFracture>& a, const std::vector<NaturalFracture>& b) {
  CHECK(std::equal(a.begin(), a.end(), b.begin(), b.end(),
                   [](const auto& f, const auto& g) { return f.from == g.from && f.to == g.to; }));
}

const std::string header = "x1_m,y1_m,x2_m,y2_m\n";

}  // namespace

TEST_CASE("fractures survive writing and reading to the last bit") {
  Random random(1);
  std::vector<NaturalFracture> fractures{{{0, -0.5}, {1e-300, 1.0 / 3}}};
  for (int k = 0; k < 20; ++k) {
    const Vec2 from{random.fraction(), random.fraction()};
    fractures.push_back({from, {random.fraction(), random.fraction()}});
  }
  std::ostringstream text;
  write_fracture_table(text, fractures, "two lines,\n\nwith one between");
  CHECK(text.str().find("# two lines,\n#\n# with one between\n" + header) == 0);
  check_same(fractures, from_text(text.str()).fractures);

  const auto path = (std::filesystem::temp_directory_path() / "hfdem_fractures_test.csv").string();
  save_fractures(path, fractures);
  const NamedFractures read = load_fractures(path);
  check_same(fractures, read.fractures);
  CHECK(read.names[20] == "line 22 of " + path);

  std::filesystem::create_directory(path + ".part");
  CHECK_THROWS_AS(save_fractures(path, {}), WriteFailed);
  check_same(fractures, load_fractures(path).fractures);
  std::filesystem::remove(path + ".part");
  std::filesystem::remove(path);
}

TEST_CASE("a table is read with its comments, empty lines, blanks and Windows line ends") {
  const NamedFractures read = from_text(
      "# two fractures\r\n\r\n x1_m, y1_m ,\tx2_m,y2_m \r\n0.1,0.2,0.3,0.4# here\r\n \t\r\n"
      "#0,0,1,1\r\n  1e-1 , -2 ,3,4\r\n5,6,7,8");
  CHECK(read.names == std::vector<std::string>{"line 4 of fractures.csv", "line 7 of fractures.csv",
                                               "line 8 of fractures.csv"});
  check_same(read.fractures, {{{0.1, 0.2}, {0.3, 0.4}}, {{0.1, -2}, {3, 4}}, {{5, 6}, {7, 8}}});
}

TEST_CASE("a table that is not right is refused with its line and what is wrong") {
  const std::string line_2 = "line 2 of fractures.csv: ", columns = "x1_m,y1_m,x2_m,y2_m";
  CHECK(said_of("") ==
        "line 0 of fractures.csv: ends where the header " + columns + " should follow");
  CHECK(said_of("# nothing\n\n") ==
        "line 2 of fractures.csv: ends where the header " + columns + " should follow");
  const std::string no_table =
      "this is no table of fractures: it does not begin with the header " + columns;
  CHECK(said_of("0.1,0.2,0.3,0.4\n") == "line 1 of fractures.csv: " + no_table);
  CHECK(said_of("#\nx1_m,y1_m,x2_m\n") == line_2 + no_table);
  CHECK(said_of("x1_m,x2_m,y1_m,y2_m\n") == "line 1 of fractures.csv: " + no_table);
  CHECK(said_of(header) ==
        "line 1 of fractures.csv: ends where a fracture, " + columns + ", should follow");
  CHECK(said_of(header + " 0.1,0.2,0.3 \r\n") ==
        line_2 + "\"0.1,0.2,0.3\" has 3 columns where " + columns + " should stand");
  CHECK(said_of(header + "0.1,0.2,0.3,0.4,0.5\n") ==
        line_2 + "\"0.1,0.2,0.3,0.4,0.5\" has 5 columns where " + columns + " should stand");
  CHECK(said_of(header + "0.1,0.2,0.3,0.4,\n") ==
        line_2 + "\"0.1,0.2,0.3,0.4,\" has 5 columns where " + columns + " should stand");
  CHECK(said_of(header + "0.1 0.2 0.3 0.4\n") ==
        line_2 + "\"0.1 0.2 0.3 0.4\" has 1 column where " + columns + " should stand");
  const std::string finite = " is not allowed: it must be any finite number";
  CHECK(said_of(header + "0.1,east,0.3,0.4\n") == line_2 + "y1_m = east" + finite);
  CHECK(said_of(header + "0.1,0.2,,0.4\n") == line_2 + "x2_m = nothing" + finite);
  CHECK(said_of(header + "0.1,0.2,0.3,\n") == line_2 + "y2_m = nothing" + finite);
  CHECK(said_of(header + "nan,0.2,0.3,0.4\n") == line_2 + "x1_m = nan" + finite);
  CHECK(said_of(header + "0.1,-inf,0.3,0.4\n") == line_2 + "y1_m = -inf" + finite);
  CHECK(said_of(header + "0.1,0.2,1e999,0.4\n") == line_2 + "x2_m = 1e999" + finite);
  CHECK(said_of(header + "0.1,0.2,0.3m,0.4\n") == line_2 + "x2_m = 0.3m" + finite);
  CHECK(said_of(header + "0.1,0.2,0.3 1,0.4\n") == line_2 + "x2_m = 0.3 1" + finite);
  CHECK(said_of(header + "0,0,1,1\n\n0,0,1,y\n") == "line 4 of fractures.csv: y2_m = y" + finite);
}

TEST_CASE("a table that is not there is refused, one that cannot be written is said to be so") {
  CHECK(refusal([] { load_fractures("no/such.csv"); }) ==
        "fracture file no/such.csv cannot be read");
  CHECK_THROWS_AS(save_fractures("no/such.csv", {}), WriteFailed);
}
