// A chain of flow channels whose walls do not move: domains one above the other between two columns
// of discs, and the exact pressures in it.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/setup/flow_domains.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/state/network.hpp>
#include <hfdem/state/step.hpp>

namespace test {

constexpr hfdem::RockResponse rigid_walls{std::numeric_limits<double>::infinity(), 1};

struct Chain {
  static constexpr double length = 0.01;  // l_p, m

  hfdem::Network network;
  std::vector<double> widths;  // channel k joins the domains k and k + 1

  /// Full of fluid without pressure. @param injection domain that receives more
  Chain(const std::vector<double>& of_channels, std::size_t injection)
      : network(domains(of_channels.size()), {static_cast<hfdem::Index>(injection)}, 1e-6),
        widths(of_channels) {
    for (std::size_t k = 0; k < widths.size(); ++k) network.set_rest_width(channel(k), widths[k]);
    for (std::size_t k = injection; k < widths.size(); ++k) network.open(channel(k));
    for (std::size_t k = injection; k-- > 0;) network.open(channel(k));
    for (std::size_t k = 0; k < widths.size(); ++k) network.set_filled_width(channel(k), widths[k]);
  }
  /// All channels alike.
  Chain(std::size_t channels, double width, std::size_t injection)
      : Chain(std::vector<double>(channels, width), injection) {}

  std::size_t size() const { return widths.size() + 1; }  // domains
  /// In the network: of two columns of discs, each row has a contact across and two upwards.
  static hfdem::Index channel(std::size_t k) { return static_cast<hfdem::Index>(3 * (k + 1)); }
  double pressure(std::size_t domain) const {
    return network.pressure(static_cast<hfdem::Index>(domain));
  }
  std::vector<double> pressures() const {
    return {network.pressures().begin(), network.pressures().end()};
  }
  double room(std::size_t domain) const {
    double twice = 0;
    if (domain > 0) twice += length * widths[domain - 1];
    if (domain < widths.size()) twice += length * widths[domain];
    return twice / 2;
  }

  /// A fluid step in which nothing moves.
  template <class Scheme>
  hfdem::FluidStep inject(Scheme& scheme, double rate, double dt) {
    time_ += dt;
    injected_ += rate * dt;
    return scheme.advance(network, {injected_, rate * dt, dt},
                          [] { return hfdem::Relaxed{.unbalanced_ratio = 0, .breaks = 0}; });
  }
  double time() const { return time_; }
  double injected() const { return injected_; }

 private:
  static hfdem::FlowDomains domains(std::size_t channels) {
    const auto specimen = hfdem::square_array(2, static_cast<int>(channels) + 2, length / 2);
    return hfdem::flow_domains(specimen, hfdem::bonded_contacts<hfdem::FixedPairs>(specimen));
  }

  double time_ = 0, injected_ = 0;
};

/// Pressures in a chain of equal channels, by the waves in which they decay: cosines, as nothing
/// leaves at the ends.
inline std::vector<double> exact_pressures(const Chain& chain, std::size_t injection,
                                           double viscosity, double modulus, double rate,
                                           double time) {
  const double channels = static_cast<double>(chain.widths.size()), w = chain.widths.front();
  const double diffusivity = modulus * w * w / (12 * viscosity);
  std::vector<double> pressures;
  for (std::size_t d = 0; d < chain.size(); ++d) {
    double sum = time;
    for (std::size_t k = 1; k <= chain.widths.size(); ++k) {
      const double wave = std::numbers::pi * static_cast<double>(k) / channels;
      const double decay = diffusivity * std::pow(2 * std::sin(wave / 2) / Chain::length, 2);
      const double twice = k < chain.widths.size() ? 2 : 1;
      sum += twice * std::cos(wave * static_cast<double>(injection)) *
             std::cos(wave * static_cast<double>(d)) * -std::expm1(-decay * time) / decay;
    }
    pressures.push_back(modulus * rate / (channels * Chain::length * w) * sum);
  }
  return pressures;
}

}  // namespace test
