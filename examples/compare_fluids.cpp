// What viscosity changes: two studies over the same rocks beside each other, and whether each
// change has the sign that the paper draws (its Sections 4 and 5).
//
//   build/release/examples/intact --case 1-S1 --seeds 5 --out out/1-S1
//   build/release/examples/intact --case 2-S1 --seeds 5 --out out/2-S1
//   build/release/examples/compare_fluids out/1-S1 out/2-S1
//
// You should see a table: the viscous crack takes more pressure, is shorter and wider.
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

#include "support/command_line.hpp"
#include "support/seeds_table.hpp"

using namespace hfdem;
using namespace hfdem::support;

namespace {

/// A reading, and whether the paper has more or less of it with the viscous fluid; 0: it says
/// nothing.
struct Comparison {
  std::string_view key, name, unit;
  double factor;  ///< SI to the unit
  int paper;
};
constexpr std::array comparisons{
    Comparison{"breakdown_pressure_Pa", "breakdown pressure", "MPa", 1e-6, +1},
    Comparison{"propagation_pressure_Pa", "propagation pressure", "MPa", 1e-6, +1},
    Comparison{"pressure_drop_Pa", "pressure drop along the crack", "MPa", 1e-6, +1},
    Comparison{"0.3_s/tip_distance_m", "length at 0.3 s", "m", 1, -1},
    Comparison{"0.6_s/tip_distance_m", "length at 0.6 s", "m", 1, -1},
    Comparison{"0.9_s/tip_distance_m", "length at 0.9 s", "m", 1, -1},
    Comparison{"0.3_s/mean_aperture_m", "width at 0.3 s", "um", 1e6, +1},
    Comparison{"0.6_s/mean_aperture_m", "width at 0.6 s", "um", 1e6, +1},
    Comparison{"0.9_s/mean_aperture_m", "width at 0.9 s", "um", 1e6, +1},
    Comparison{"0.6_s/tortuosity", "tortuosity at 0.6 s", "", 1, -1},
    Comparison{"0.9_s/tortuosity", "tortuosity at 0.9 s", "", 1, -1},
    Comparison{"0.6_s/asymmetry", "asymmetry at 0.6 s", "", 1, -1},
    Comparison{"0.9_s/asymmetry", "asymmetry at 0.9 s", "", 1, -1},
    Comparison{"microcracks/joints", "microcracks in joints", "", 1, -1},
    Comparison{"microcracks/connected_joints", "of which connected", "", 1, -1}};

std::string said(double v) {
  char text[32];
  std::snprintf(text, sizeof text, std::abs(v) < 10 ? "%.3f" : "%.1f", v);
  return std::isfinite(v) ? text : "-";
}

void print(const SeedsTable& viscous, const SeedsTable& slick) {
  std::printf(
      "Means over the rocks in which both cracks are still inside at that time. Pressure drop and\n"
      "microcracks are those at the end of each run, the breakdown pressure is the highest once\n"
      "the pump has come to its rate. The change is that of each rock, with the 95 %% interval of\n"
      "Student's t.\n\n"
      "| | viscous | slick | change | 95 %% | rocks | |\n|---|---|---|---|---|---|---|\n");
  for (const Comparison& c : comparisons) {
    const PairedReading r = paired(viscous, slick, c.key, c.factor);
    if (r.rocks == 0) continue;
    std::printf("| %s%s%s | %s | %s | %s | %s | %zu | %s |\n", std::string(c.name).c_str(),
                c.unit.empty() ? "" : ", ", std::string(c.unit).c_str(), said(r.first.mean).c_str(),
                said(r.second.mean).c_str(), said(r.change.mean).c_str(),
                said(r.change.ci95).c_str(), r.rocks,
                std::string(verdict(r.change, c.paper, "as in the paper")).c_str());
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Two studies over the same rocks beside each other"};
  std::string viscous, slick;
  app.add_option("viscous", viscous, "folder of the study with the viscous fluid")->required();
  app.add_option("slick", slick, "folder of the study with carbon dioxide")->required();
  return guarded("compare_fluids", app, [&] {
    app.parse(argc, argv);
    print(SeedsTable(viscous + "/seeds.csv"), SeedsTable(slick + "/seeds.csv"));
    return success;
  });
}
