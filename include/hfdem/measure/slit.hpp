/// @file
/// A slit held open by a given pressure: the experiment that stiffness and toughness are read from.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <hfdem/contact/unbreakable.hpp>
#include <hfdem/measure/crack.hpp>
#include <hfdem/measure/slit_readings.hpp>
#include <hfdem/pressure/held.hpp>
#include <hfdem/simulator.hpp>

namespace hfdem::measure {

/// A slit of broken contacts in the middle of a specimen under in-situ stress: straight in a square
/// array, along a rough path of contacts in a random one. Its bonds do not break; `would_break`
/// says whether they should have.
template <ContactLaw Contact, ApertureLaw Aperture, NeighbourSearch Neighbours>
class Slit {
 public:
  /// The simulator that holds it open.
  using Sim = Simulator<Unbreakable<Contact>, Aperture, HeldPressure, Neighbours>;

  /// @param specimen in whose middle the slit lies
  /// @param params of the specimen; its crack is replaced by the slit
  /// @param contacts broken ones; an even number is centred on a domain
  /// @throws InvalidParameter, RunStopped as the simulator does
  Slit(const Specimen& specimen, const typename Sim::Params& params, int contacts)
      : Slit(specimen, params, PresetCrack{.contacts = contacts}, 0) {}

  /// @param specimen in whose middle the slit lies
  /// @param params of the specimen; its crack is replaced by the slit
  /// @param slit how long it is
  /// @param reach to both sides of the middle over which the opening is a mean, m, since a single
  /// facet of a rough path says little; 0 for the contacts at the middle
  /// @throws InvalidParameter, RunStopped as the simulator does
  Slit(const Specimen& specimen, const typename Sim::Params& params, const PresetCrack& slit,
       double reach)
      : sim_(specimen, with_slit(params, slit)),
        closing_(std::fmin(params.in_situ.xx, params.in_situ.yy)),
        reach_(reach) {}

  /// Relaxes the slit at a net pressure, Pa.
  /// @throws RunStopped if it finds no equilibrium
  SlitState at(double net_pressure) {
    sim_.pressure_scheme().hold(closing_ + net_pressure);
    if (!sim_.step().converged)
      throw RunStopped("a slit of " + in_words(2 * half_length()) + " m found no equilibrium at " +
                       in_words(net_pressure) + " Pa of net pressure");
    return {net_pressure, opening(), sim_.network().crack_volume()};
  }

  /// Stiffness: opening and volume at net pressures, in their order, with straight lines through
  /// them. The slit itself stays as it is.
  /// @param net_pressures two or more, Pa
  /// @throws RunStopped if a state finds no equilibrium
  SlitTest held_at(std::span<const double> net_pressures) const {
    SlitTest test{.contacts = static_cast<int>(sim_.preset_contacts().size()),
                  .half_length = half_length()};
    Slit slit = *this;
    std::vector<Vec2> openings, volumes;
    for (const double p : net_pressures) {
      const SlitState s = slit.at(p);
      test.states.push_back(s);
      openings.push_back({s.net_pressure, s.opening});
      volumes.push_back({s.net_pressure, s.volume});
    }
    test.opening = Line::through(openings);
    test.volume = Line::through(volumes);
    return test;
  }

  /// Whether some bond is over its strength at the present state.
  bool would_break() const {
    const auto& contacts = sim_.contacts();
    const Contact& law = contacts.law();
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const auto failure =
          law.failure(contacts.stiffness(c), contacts.response(c, sim_.discs().displacement));
      if (failure.tension || failure.shear) return true;
    }
    return false;
  }

  /// Raises the pressure until a bond is over its strength and stays just below: contacts that
  /// opened and closed again would remember it.
  /// @param start net pressure from which to look, Pa; a quarter of it, and so on, if it is too
  /// high
  /// @param accuracy relative
  /// @returns the net pressure at first break, Pa
  /// @throws RunStopped if a state finds no equilibrium
  double net_pressure_at_break(double start, double accuracy = 1e-3) {
    double holds = start;
    while (!survives(holds)) {
      holds /= 4;
      if (holds < 1e-6 * start)
        throw RunStopped("bonds around a slit are over their strength without any net pressure");
    }
    double rise = 0.1;
    while (true) {
      if (survives(holds * (1 + rise))) {
        holds *= 1 + rise;
        if (crack_shape(sim_).opening > half_length())
          throw RunStopped("a slit opened wider than it is long and no bond broke, at " +
                           in_words(holds) + " Pa of net pressure");
      } else if (rise <= accuracy) {
        return holds * (1 + rise / 2);
      } else {
        rise = std::fmax(rise / 2, accuracy);
      }
    }
  }

  /// First the pressure at first break, then stiffness at 80, 90 and 100 % of it, where the tips
  /// are softened but nothing has broken. The slit itself stays as it is.
  /// @param start net pressure from which to look for the first break, Pa
  /// @param accuracy of it, relative
  /// @throws RunStopped if a state finds no equilibrium
  SlitTest test(double start, double accuracy = 1e-3) const {
    const double at_break = Slit(*this).net_pressure_at_break(start, accuracy);
    SlitTest test = held_at(std::vector{0.8 * at_break, 0.9 * at_break, 1.0 * at_break});
    test.net_pressure_at_break = at_break;
    return test;
  }

  double half_length() const { return crack_shape(sim_).full_length() / 2; }  ///< m
  /// The simulator in its present state.
  const Sim& sim() const { return sim_; }
  /// Number of threads for the loops; the results do not depend on it.
  void use_threads(int threads) { sim_.use_threads(threads); }

 private:
  /// Goes to a net pressure, unless that breaks a bond.
  bool survives(double net_pressure) {
    Slit next = *this;
    next.at(net_pressure);
    if (next.would_break()) return false;
    *this = std::move(next);
    return true;
  }

  /// How far the walls part across the slit: volume over length. The facets of a rough path lie
  /// aslant and open by less, but are longer by as much.
  double opening() const {
    if (reach_ == 0) return crack_shape(sim_).opening;
    const auto& network = sim_.network();
    const Vec2 origin = injection_point(sim_), direction = sim_.crack_direction();
    double volume = 0;
    for (const Index c : network.wet_channels()) {
      const auto& channel = network.geometry().channels[c];
      const auto along = [&](Index domain) {
        return dot(network.geometry().centre[domain] - origin, direction);
      };
      const auto [low, high] = std::minmax({along(channel.domain[0]), along(channel.domain[1])});
      const double within = std::fmin(high, reach_) - std::fmax(low, -reach_);
      if (!(within > 0)) continue;
      const double opened = network.width(c) - network.rest_width(c);
      volume += within / (high - low) * channel.length * opened;
    }
    return volume / (2 * reach_);
  }

  static typename Sim::Params with_slit(typename Sim::Params params, const PresetCrack& slit) {
    params.crack = slit;
    params.injection.position = {};
    params.injection.further_points = {};
    return params;
  }

  Sim sim_;
  double closing_, reach_;
};

}  // namespace hfdem::measure
