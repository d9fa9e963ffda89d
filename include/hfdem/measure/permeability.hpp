/// @file
/// The permeability of a rock whose intact contacts conduct: steady flow through all of its domains
/// under a pressure that falls from one side to the other, in the domains near both sides as it
/// would in a continuum.
///
/// Source: Darcy's law, k = mu q / |grad P|; channels are those of the paper's Eq. 5.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/graph_system.hpp>
#include <hfdem/setup/flow_domains.hpp>

#include <Eigen/OrderingMethods>

namespace hfdem::measure {

/// Of a specimen, m2.
struct Permeability {
  double along_x = 0, along_y = 0;  ///< for flow in that direction
};

namespace detail {

/// A channel between two domains.
struct PermeableChannel {
  Index first, second;
};

/// @param direction unit vector of the flow
/// @param size of the specimen along it, m
/// @param width across it, m
inline double permeability_along(const FlowDomains& g,
                                 const std::vector<PermeableChannel>& channels,
                                 const std::vector<double>& conductance, Vec2 direction,
                                 double size, double width) {
  constexpr double margin = 0.1;  // of the specimen, at both sides
  std::vector<bool> is_free;
  std::vector<double> pressure, own(g.centre.size(), 0), residual(g.centre.size(), 0);
  for (const Vec2 centre : g.centre) {
    pressure.push_back(dot(centre, direction) / size);
    is_free.push_back(pressure.back() > margin && pressure.back() < 1 - margin);
  }
  for (std::size_t k = 0; k < channels.size(); ++k) {
    const auto [a, b] = channels[k];
    const double flow = conductance[k] * (pressure[a] - pressure[b]);
    residual[a] -= flow;
    residual[b] += flow;
  }
  GraphSystem<Eigen::AMDOrdering<int>> system;
  const bool found = system.factorise(channels, {own, conductance}, is_free);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(pressure.size()));
  for (std::size_t d = 0; d < pressure.size(); ++d)
    if (is_free[d]) right[system.row(d)] = residual[d];
  const Eigen::VectorXd change = system.solve(right);
  for (std::size_t d = 0; d < pressure.size(); ++d) pressure[d] += change[system.row(d)];
  double through = 0;
  for (std::size_t k = 0; k < channels.size(); ++k) {
    const auto [a, b] = channels[k];
    const bool before = dot(g.centre[a], direction) < size / 2;
    if (before == (dot(g.centre[b], direction) < size / 2)) continue;
    through += conductance[k] * (pressure[a] - pressure[b]) * (before ? -1 : 1);
  }
  if (!found || !std::isfinite(through))
    throw RunStopped(
        "the flow through the rock has no solution: a channel conducts nothing, or is "
        "not a finite number wide");
  return through * size / width;
}

}  // namespace detail

/// Of a settled specimen.
/// @tparam Sim a `Simulator`; `Dry` will do
/// @tparam Aperture law of the channels
/// @param sim at rest under the stress for which the permeability is wanted
/// @param law of the channels
/// @throws RunStopped if there is no solution
template <class Sim, class Aperture>
Permeability permeability(const Sim& sim, const Aperture& law) {
  const FlowDomains& g = sim.network().geometry();
  std::vector<detail::PermeableChannel> channels;
  std::vector<double> conductance;
  for (Index c = 0; c < g.channels.size(); ++c) {
    const auto [ends, length] = g.channels[c];
    if (ends[0] == nothing || ends[1] == nothing || ends[0] == ends[1]) continue;
    const double force = sim.reaction(c).normal;
    const double width = law.width(law.rest_width(), std::fmax(0, force), 0);
    channels.push_back({ends[0], ends[1]});
    conductance.push_back(width * width * width / (12 * length));
  }
  const Specimen& s = sim.specimen();
  return {detail::permeability_along(g, channels, conductance, {1, 0}, s.width, s.height),
          detail::permeability_along(g, channels, conductance, {0, 1}, s.height, s.width)};
}

}  // namespace hfdem::measure
