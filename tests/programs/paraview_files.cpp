// Writes ParaView's files of four runs, and the numbers in them as tables besides, for
// paraview_test.py to compare.
//
//   paraview_files FOLDER
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <hfdem/leakoff/matrix_flow.hpp>
#include <hfdem/measure/pores.hpp>
#include <hfdem/observe/history.hpp>
#include <hfdem/observe/paraview.hpp>
#include <hfdem/pressure/leaky_uniform.hpp>

#include "observe/two_sizes.hpp"
#include "schemes/small_array.hpp"

namespace {

using namespace hfdem;
namespace fs = std::filesystem;

template <class Sim>
void write_tables(const fs::path& folder, const Sim& sim) {
  const Discs& discs = sim.discs();
  std::ofstream particles(folder / "particles.csv"), contacts(folder / "contacts.csv"),
      profile(folder / "profile.csv"), breaks(folder / "breaks.csv");
  particles << "x,y,radius,dx,dy,rotation\n";
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const Pack& d = discs.displacement[i];
    observe::write_row(particles, {discs.centre[i].x + d[0], discs.centre[i].y + d[1],
                                   discs.radius[i], d[0], d[1], d[2]});
  }
  contacts << "first,second,normal,shear,moment,open,wet\n";
  for (Index c = 0; c < sim.contacts().size(); ++c) {
    const auto [first, second] = sim.contacts().bodies(c);
    const auto r = sim.contacts().response(c, discs.displacement).reaction();
    observe::write_row(contacts,
                       {double(first), double(second), r.normal, r.shear, r.moment,
                        double(sim.network().is_open(c)), double(sim.network().is_wet(c))});
  }
  observe::write_profile(profile, sim);
  observe::write_cracks(breaks, sim);
}

/// The closed form: every contact of an intact array carries the stress times one diameter.
void intact(const fs::path& folder) {
  const test::SquareRock<Dry> sim(
      square_array(10, 8, 5e-3),
      {.crack = {.contacts = 0}, .mechanics = {.settle_tolerance = 1e-6}});
  observe::ParaView(folder, 1).write(sim);
  write_tables(folder, sim);
}

/// A growing crack, over time.
void injected(const fs::path& folder) {
  test::Injected sim(test::square(20), {.injection = {.rate = 5e-4}});
  observe::ParaView out(folder, 2e-3);
  out.write(sim);
  sim.run_until(0.0085, out);
  out.write(sim);
  write_tables(folder, sim);
}

/// Bonds too weak in shear for the in-situ stress, away from a slit that holds fluid.
void sheared(const fs::path& folder) {
  test::SquareRock<HeldPressure> sim(test::two_sizes(9, 8),
                                     {.contact = {.cohesion = 0.5e6, .friction_angle = 0},
                                      .in_situ = {.xx = 6e6, .yy = 12e6},
                                      .scheme = {.pressure = 6e6}});
  sim.step();
  observe::ParaView(folder, 1).write(sim);
  write_tables(folder, sim);
}

/// Rock whose pores take fluid from the crack.
void seeping(const fs::path& folder) {
  test::SquareRock<LeakyUniformPressure<MatrixFlow>> sim(
      test::square(12), {.injection = {.rate = 5e-4}, .leakoff = {.saturation = 1}});
  for (int step = 0; step < 20; ++step) sim.step();
  observe::ParaView(folder, 1).write(sim);
  write_tables(folder, sim);
  std::ofstream file(folder / "pores.csv");
  file << "x,y,pressure,filling,in_crack\n";
  for (const measure::Pore& p : measure::pores(sim))
    observe::write_row(file, {p.centre.x, p.centre.y, p.pressure, p.filling, double(p.in_crack)});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: paraview_files FOLDER\n"), 2;
  const fs::path folder = argv[1];
  intact(folder / "intact");
  injected(folder / "injected");
  sheared(folder / "sheared");
  seeping(folder / "seeping");
}
