/// @file
/// Growth of a fluid-driven crack through a lattice of bonded discs: a staircase of one contact at
/// each tip, predicted from slit tests.
///
/// At a fixed length the injected volume raises the net pressure until a contact at the tip breaks,
/// p F_K sqrt(pi a) = K_IC(p); the crack then is one contact longer at each tip, at the same
/// volume. The limit of no viscosity and no leak-off.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <hfdem/analytic/lattice_fracture.hpp>
#include <hfdem/analytic/plate.hpp>

namespace hfdem::analytic {

/// The staircase of one specimen.
class StepwiseGrowth {
 public:
  /// A length and the break that ends it.
  struct Break {
    int contacts;         ///< broken ones, before it
    double full_length;   ///< before it, m
    double net_pressure;  ///< Pa
    double volume;        ///< injected until then, m2
  };

  /// @param plate the specimen
  /// @param rock as slit tests of it say
  /// @param facet length of one broken contact, m
  /// @param preset_contacts broken ones when injection begins
  /// @throws InvalidParameter if there are none, more than the plate solution knows, or no pressure
  ///   breaks them
  StepwiseGrowth(const CrackedPlate& plate, const LatticeFracture& rock, double facet,
                 int preset_contacts)
      : plate_(plate), rock_(rock) {
    const auto most = static_cast<int>(plate.longest() / facet);
    if (preset_contacts < 1 || preset_contacts > most)
      refuse("crack", "contacts", std::to_string(preset_contacts),
             "at least 1 and at most " + std::to_string(most) +
                 ": the plate is known for cracks of up to 0.94 of its width");
    double volume = 0;
    for (int n = preset_contacts; n * facet <= plate.longest(); n += 2) {
      const double length = n * facet, per_pressure = plate.stress_intensity(1, length);
      if (!(per_pressure > rock.K_IC_per_pressure))
        refuse("toughness", "K_IC_per_pressure", to_text(rock.K_IC_per_pressure) + " sqrt(m)",
               "less than " + to_text(per_pressure) +
                   " sqrt(m), or no pressure breaks a crack of " + in_words(length) + " m");
      const double net_pressure = rock.K_IC / (per_pressure - rock.K_IC_per_pressure);
      // A longer crack that breaks at less volume is run through at once.
      volume = std::max(volume, volume_at(length, net_pressure));
      breaks_.push_back({n, length, net_pressure, volume});
    }
  }

  /// In their order, up to the longest crack whose factors the plate knows.
  std::span<const Break> breaks() const { return breaks_; }

  /// The crack once a volume is injected, m2; nothing if the plate has split by then.
  std::optional<LatticeCrack> at(double volume) const {
    const auto next = std::upper_bound(breaks_.begin(), breaks_.end(), volume,
                                       [](double v, const Break& b) { return v < b.volume; });
    if (next == breaks_.end()) return {};
    const double length = next->full_length;
    const double offset = length * rock_.volume_offset;
    const double net_pressure = (volume + offset) / (volume_at(length, 1) + offset);
    return LatticeCrack{length, opening_at(length, net_pressure), net_pressure};
  }

 private:
  double volume_at(double length, double net_pressure) const {
    const double a = length / 2 + rock_.overhang;
    return 2 * std::numbers::pi * a * a * net_pressure * plate_.factors(length).volume /
               rock_.E_prime -
           length * rock_.volume_offset;
  }
  double opening_at(double length, double net_pressure) const {
    return 2 * length * net_pressure * plate_.factors(length).width / rock_.E_prime -
           rock_.opening_offset;
  }

  CrackedPlate plate_;
  LatticeFracture rock_;
  std::vector<Break> breaks_;
};

}  // namespace hfdem::analytic
