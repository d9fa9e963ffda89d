// The natural fractures that come with the examples: where they are from, and what is said of them.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <hfdem/setup/fracture_file.hpp>
#include <hfdem/setup/joints.hpp>
#include <hfdem/setup/random_fractures.hpp>

#include <doctest/doctest.h>

using namespace hfdem;

namespace {

const std::string file = HFDEM_EXAMPLE_DATA "/fractures.csv";

double to_mm(double metres) { return std::round(1000 * metres) / 1000; }

/// The file as the generator makes it.
std::string made() {
  const RandomFractures parameters;
  auto fractures = random_fractures(parameters, 1, 1);
  for (NaturalFracture& f : fractures)
    f = {{to_mm(f.from.x), to_mm(f.from.y)}, {to_mm(f.to.x), to_mm(f.to.y)}};
  std::ostringstream comment, table;
  comment << std::boolalpha
          << "18 natural fractures for a specimen of 1 m by 1 m that is injected in its middle,\n"
             "through an upright preset crack of 0.032 m. They resemble the description of the\n"
             "paper's Fig. 3, where 18 are drawn but not listed; they are not the same.\n\n"
             "Made by random_fractures (hfdem/setup/random_fractures.hpp), rounded to mm, from\n";
  for_each_field<RandomFractures>([&](const auto& field) {
    comment << "  " << field.name << " = " << parameters.*(field.member)
            << (field.unit.empty() ? "" : " ") << field.unit << '\n';
  });
  write_fracture_table(table, fractures, comment.str());
  return table.str();
}

/// Heights over the injection at which a line straight up from it crosses fractures, m.
std::vector<double> crossings(const std::vector<NaturalFracture>& fractures) {
  std::vector<double> heights;
  for (const NaturalFracture& f : fractures) {
    const double share = (0.5 - f.from.x) / (f.to.x - f.from.x);
    if (share >= 0 && share <= 1) heights.push_back(f.from.y + share * (f.to.y - f.from.y) - 0.5);
  }
  return heights;
}

}  // namespace

TEST_CASE("the fractures of the examples are made from the parameters in their file") {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  CHECK(text.str() == made());
}

TEST_CASE("the fractures of the examples are as their file and the paper say") {
  const NamedFractures read = load_fractures(file);
  const auto& fractures = read.fractures;
  CHECK(fractures.size() == 18);
  CHECK_NOTHROW(check_fractures(fractures, 1, 1, read.names));
  CHECK_NOTHROW(keep_clear(fractures, {0.5, 0.5}, {{0.5, 0.484}, {0.5, 0.516}}, 0.05, read.names));
  for (std::size_t i = 0; i < fractures.size(); ++i) {
    CHECK(fractures[i].length() > 0.149);
    CHECK(fractures[i].length() < 0.251);
    CHECK(distance(fractures[i], Vec2{0.5, 0.5}) > 0.059);
    for (std::size_t j = 0; j < i; ++j) CHECK(distance(fractures[i], fractures[j]) > 0.029);
  }
  const auto heights = crossings(fractures);
  const auto within = [&](double low, double high) {
    return std::count_if(heights.begin(), heights.end(),
                         [=](double y) { return y > low && y < high; });
  };
  CHECK(within(0, 0.4) >= 2);
  CHECK(within(-0.4, 0) >= 2);
}
