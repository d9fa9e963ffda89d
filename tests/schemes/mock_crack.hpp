// A crack of two channels without mechanics: each `relax` opens it in proportion to its pressure.
#pragma once

#include <functional>
#include <vector>

#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/setup/flow_domains.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/state/network.hpp>
#include <hfdem/state/step.hpp>

namespace test {

struct MockCrack {
  static constexpr double w0 = 6e-6, length = 2, rest_volume = 2 * length * w0;

  double width_at_rest = w0;    // less where the crack is pressed shut
  double compliance = 1e-12;    // width per pressure, m/Pa
  double unbalanced_ratio = 0;  // what each relax answers
  std::function<void()> on_relax = [] {};

  hfdem::Network network = crack_in_square();
  std::vector<double> pressures{};  // at each relax

  hfdem::Relaxed relax() {
    const double pressure = network.pressure(network.injection_domain());
    pressures.push_back(pressure);
    on_relax();
    for (const hfdem::Index c : network.wet_channels())
      network.set_width(c, width_at_rest + compliance * pressure);
    return {.unbalanced_ratio = unbalanced_ratio, .breaks = 0};
  }
  std::size_t steps() const { return pressures.size(); }
  /// V_c at a pressure.
  double volume(double pressure) const {
    return 2 * length * (width_at_rest - w0 + compliance * pressure);
  }

  /// Lengthens the crack by a third channel.
  void grow() { network.open(contact_in_row(1)); }

 private:
  /// Of the array of six by six, the contact between its middle columns; contacts are sorted, each
  /// disc's right neighbour before the upper one.
  static hfdem::Index contact_in_row(hfdem::Index row) { return row * 11 + 4; }

  static hfdem::Network crack_in_square() {
    const auto specimen = hfdem::square_array(6, 6, length / 2);
    const auto contacts = hfdem::bonded_contacts<hfdem::FixedPairs>(specimen);
    constexpr hfdem::Index middle = 12;  // of 5 x 5 domains
    hfdem::Network network(hfdem::flow_domains(specimen, contacts), {middle}, w0);
    network.open(contact_in_row(2));
    network.open(contact_in_row(3));
    return network;
  }
};

}  // namespace test
