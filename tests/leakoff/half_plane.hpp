// A strip of intact square lattice whose first domains are a wall of given pressure.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <hfdem/analytic/pore_diffusion.hpp>
#include <hfdem/fluid/newtonian.hpp>
#include <hfdem/leakoff/matrix_flow.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/setup/flow_domains.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/state/network.hpp>

namespace test {

struct HalfPlane {
  static constexpr int rows = 3;          // of domains
  static constexpr double radius = 5e-3;  // m
  static constexpr double spacing = 2 * radius;
  static constexpr double width = 3e-6;     // of every channel, m
  static constexpr double pressure = 20e6;  // of the wall, Pa
  hfdem::NewtonianFluid fluid{{.viscosity = 0.1, .bulk_modulus = 2e9}};
  hfdem::MatrixFlow rock;
  hfdem::Network network;
  std::vector<double> wall, stored;

  HalfPlane(int columns, double saturation)
      : rock({.saturation = saturation}), network(strip(columns)) {
    for (hfdem::Index c = 0; c < network.geometry().channels.size(); ++c)
      network.set_width(c, width);
    wall.assign(network.wet_domains().size(), pressure);
    stored.assign(wall.size(), 1);
  }

  // The closed form, from the same channels.
  hfdem::analytic::PoreDiffusion exact() const {
    const double conductance = fluid.conductance(width, spacing, 0, 0);
    return {conductance * 2e9 * spacing * spacing / pore(), pressure, 2e9};
  }
  static double pore() { return (4 - std::numbers::pi) * radius * radius; }

  // Steps up to a time. Returns what the wall has lost.
  double run(double time, int steps, hfdem::Euler euler) {
    double lost = 0;
    rock.join(network);
    for (int n = 0; n < steps; ++n) {
      rock.find_loss(network, fluid, time / steps, {wall, stored}, euler);
      rock.commit(network, fluid, {wall, stored});
      for (std::size_t d = 0; d < rock.size(); ++d) lost += rock.loss(d, wall[d]);
    }
    return lost;
  }

  // Pressures of the middle row, from the wall on.
  std::vector<double> pressures() const {
    std::vector<double> row;
    for (const hfdem::Index d : middle()) row.push_back(network.pressure(d));
    return row;
  }
  // How many pores of a row are full, parts counted.
  double filled() const {
    double sum = 0;
    const auto row = middle();
    for (std::size_t k = 1; k < row.size(); ++k) sum += rock.filling(network, row[k]);
    return sum;
  }

 private:
  // In a square array domains are found column by column or row by row: sort by place.
  std::vector<hfdem::Index> middle() const {
    const auto& centre = network.geometry().centre;
    std::vector<hfdem::Index> row;
    for (int column = 0;; ++column) {
      const hfdem::Vec2 at{spacing * (column + 1), spacing * (rows / 2 + 1)};
      hfdem::Index found = hfdem::nothing;
      for (hfdem::Index d = 0; d < centre.size(); ++d)
        if (norm(centre[d] - at) < 1e-6) found = d;
      if (found == hfdem::nothing) return row;
      row.push_back(found);
    }
  }

  static hfdem::Network strip(int columns) {
    const auto specimen = hfdem::square_array(columns + 1, rows + 1, radius);
    auto domains =
        hfdem::flow_domains(specimen, hfdem::bonded_contacts<hfdem::FixedPairs>(specimen));
    std::vector<hfdem::Index> first;
    for (hfdem::Index d = 0; d < domains.centre.size(); ++d)
      if (domains.centre[d].x < 1.5 * spacing) first.push_back(d);
    return {std::move(domains), std::move(first), 6e-6};
  }
};

}  // namespace test
