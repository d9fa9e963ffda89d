// Whether the host code's breakdown is that of the static solution of the same lattice.
//
//   static_breakdown <pressure, MPa> <opening of the walls, um>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "truth/static_lattice.hpp"

int main(int argc, char** argv) {
  truth::StaticSlit slit({.columns = 40, .rows = 40}, 4);
  const truth::SlitState state = slit.at_first_break();
  const double pressure = state.pressure / 1e6, opening = state.opening / 1e-6;
  std::printf("static solution: %.2f MPa, %.1f um\n", pressure, opening);
  const auto agrees = [&](int argument, double expected) {
    return argument < argc && std::abs(std::atof(argv[argument]) / expected - 1) < 0.02;
  };
  return agrees(1, pressure) && agrees(2, opening) ? EXIT_SUCCESS : EXIT_FAILURE;
}
