/// @file
/// A run file for a simulator of one's own policies, as docs/own_law.md has it.
#include <fstream>

#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/pressure/held.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator.hpp>

#include <doctest/doctest.h>

#include "least/aperture_law.hpp"
#include "least/contact_law.hpp"
#include "support/settings.hpp"

using namespace hfdem;
using models::GluedSprings;
using models::RoughWalls;

namespace {

using Sim = Simulator<GluedSprings, RoughWalls, HeldPressure, FixedPairs>;

struct Config {
  SquareArray specimen;
  Sim::Params simulator;

  template <class F>
  void for_each_section(F&& f) {
    f("specimen", specimen);
    hfdem::for_each_section(simulator, f);
  }
};

Config read_run_file(const std::string& path) {
  Config config;
  for (const auto& setting : support::read_toml(path)) support::apply(config, setting);
  validate(config.specimen, "specimen");
  config.simulator.validate();
  return config;
}

void write(const char* path, const char* text) { std::ofstream(path) << text; }

TEST_CASE("a run file gives the parameters of one's own laws") {
  write("own_law.toml", "[specimen]\ncolumns = 8\n[contact]\nE = 20e9\n[aperture]\nw0 = 1e-5\n");
  const Config config = read_run_file("own_law.toml");
  CHECK(config.specimen.columns == 8);
  CHECK(config.simulator.contact.E == 20e9);
  CHECK(config.simulator.contact.tensile_strength == GluedSprings::Params{}.tensile_strength);
  CHECK(config.simulator.aperture.w0 == 1e-5);
}

TEST_CASE("a run file with a wrong value or name is refused in the words of one's own table") {
  write("own_law.toml", "[contact]\nE = -1\n");
  CHECK_THROWS_WITH_AS(read_run_file("own_law.toml"),
                       "contact.E = -1 Pa is not allowed: it must be greater than 0 Pa",
                       InvalidParameter);
  write("own_law.toml", "[contact]\ncohesion = 15e6\n");
  CHECK_THROWS_WITH_AS(read_run_file("own_law.toml"),
                       "line 2 of own_law.toml: there is no key \"cohesion\" in section "
                       "\"contact\"; its keys are E, tensile_strength",
                       InvalidParameter);
}

}  // namespace
