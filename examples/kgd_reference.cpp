// Reference solutions for a plane-strain (KGD) hydraulic fracture in an infinite plane: Dontsov's
// general solution with toughness, viscosity and leak-off, its regime, and the nearest vertex.
//
//   build/release/examples/kgd_reference --E-prime 35.1e9 --K-IC 1.88e6 --viscosity 6e-5
//       --leak-off 0 --rate 0.5e-4 --time 0.9
//
// You should see one JSON object: a half-length of 0.382 m, 75.2 um at the injection, a net
// pressure of 1.73 MPa, K_m = 5.37 and the regime storage-toughness. With a fluid of 100 cp,
// leak-off and profiles at 51 points: 0.218 m, 138.7 um, 6.55 MPa, between the regimes
// (transitional).
//
//   build/release/examples/kgd_reference --E-prime 35.1e9 --K-IC 1.88e6 --viscosity 0.1
//       --leak-off 1e-6 --rate 0.5e-4 --time 0.9 --profile 51
//
// In a sample of 1 m between servo-controlled platens, from volume and toughness alone (0.800 m and
// 70.2 um at 0.9 s; at 1.00 s it splits):
//
//   build/release/examples/kgd_reference --E-prime 35.1e9 --K-IC 1.88e6 --viscosity 0
//       --leak-off 0 --rate 0.5e-4 --time 0.9 --plate 1 --sides rigid
//
// With --map FILE.svg also a picture of the map of propagation regimes (the paper's Fig. 4) with
// the fracture on it.
#include <cstdio>

#include <CLI/CLI.hpp>

#include "support/command_line.hpp"
#include "support/kgd_reference_answer.hpp"
#include "support/kgd_reference_options.hpp"

using namespace hfdem;
using namespace hfdem::support;

int main(int argc, char** argv) {
  CLI::App app{
      "Reference solutions for a plane-strain (KGD) hydraulic fracture, as one JSON object.\n"
      "null stands for what is infinite: tau and K_m without viscosity, the pressure at the tip\n"
      "with it; and for the crack in a plate that has split."};
  app.failure_message([](const CLI::App*, const CLI::Error& e) {
    return std::string("kgd_reference: ") + e.what() + "\n";
  });
  KgdReferenceOptions options;
  options.add_to(app);
  return guarded("kgd_reference", app, [&] {
    app.parse(argc, argv);
    const auto problem = options.problem();
    const int points = options.profile_points();
    const auto plate = options.plate(problem);
    const auto fracture = analytic::general_kgd(problem);
    Summary json;
    describe(json, problem, fracture);
    if (plate) describe(json, problem, *plate);
    describe_profile(json, fracture, points);
    if (!options.map_file().empty())
      write_whole_file(options.map_file(), observe::svg(regime_map(problem, fracture)));
    std::fputs(json.json().c_str(), stdout);
    return success;
  });
}
