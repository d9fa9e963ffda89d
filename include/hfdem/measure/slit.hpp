/// @file
/// A slit held open by a given pressure: the experiment that stiffness and toughness are read from.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <hfdem/contact/unbreakable.hpp>
#include <hfdem/measure/crack.hpp>
#include <hfdem/measure/slit_readings.hpp>
#include <hfdem/pressure/held.hpp>
#include <hfdem/simulator.hpp>

namespace hfdem::measure {

/// A straight slit of broken contacts in the middle of a specimen under in-situ stress. Its bonds
/// do not break; `would_break` says whether they should have.
template <ContactLaw Contact, ApertureLaw Aperture, NeighbourSearch Neighbours>
class Slit {
 public:
  /// The simulator that holds it open.
  using Sim = Simulator<Unbreakable<Contact>, Aperture, HeldPressure, Neighbours>;

  /// @param specimen in whose middle the slit lies
  /// @param params of the specimen; its crack is replaced by the slit
  /// @param contacts broken ones; an even number is centred on a domain
  /// @throws InvalidParameter, RunStopped as the simulator does
  Slit(const Specimen& specimen, typename Sim::Params params, int contacts)
      : sim_(specimen, with_slit(params, contacts)),
        closing_(std::fmin(params.in_situ.xx, params.in_situ.yy)) {}

  /// Relaxes the slit at a net pressure, Pa.
  /// @throws RunStopped if it finds no equilibrium
  SlitState at(double net_pressure) {
    sim_.pressure_scheme().hold(closing_ + net_pressure);
    if (!sim_.step().converged)
      throw RunStopped("a slit of " + in_words(2 * half_length()) + " m found no equilibrium at " +
                       in_words(net_pressure) + " Pa of net pressure");
    return {net_pressure, crack_shape(sim_).opening, sim_.network().crack_volume()};
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
    SlitTest test{.contacts = static_cast<int>(sim_.preset_contacts().size()),
                  .half_length = half_length()};
    test.net_pressure_at_break = Slit(*this).net_pressure_at_break(start, accuracy);
    Slit slit = *this;
    std::vector<Vec2> openings, volumes;
    for (const double part : {0.8, 0.9, 1.0}) {
      const SlitState s = slit.at(part * test.net_pressure_at_break);
      test.states.push_back(s);
      openings.push_back({s.net_pressure, s.opening});
      volumes.push_back({s.net_pressure, s.volume});
    }
    test.opening = Line::through(openings);
    test.volume = Line::through(volumes);
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

  static typename Sim::Params with_slit(typename Sim::Params params, int contacts) {
    params.crack = {.contacts = contacts};
    params.injection.position = {};
    return params;
  }

  Sim sim_;
  double closing_;
};

}  // namespace hfdem::measure
