/// @file
/// The KGD fracture that a crack in an array of discs is compared with. Nothing of it is fitted to
/// a run: modulus, toughness and offsets are those of slits in the same array.
///
///   volume     a lattice opens by `volume_offset` less than a continuum does, so the continuum's
///              crack holds 2 a `volume_offset` more than was injected
///   opening    that of the crack plus `opening_offset`
///   toughness  grows with the net pressure beside the contact that breaks. A slit has one
///              pressure; in a viscous fluid it falls towards the tip. So K_IC is taken at the mean
///              over the last disc before the tip, as the fracture itself has it there.
#pragma once

#include <cmath>
#include <numbers>

#include <hfdem/analytic/kgd_general.hpp>
#include <hfdem/analytic/kgd_regime.hpp>
#include <hfdem/analytic/lattice_fracture.hpp>

namespace hfdem::support {

/// The pressure for which the toughness of a lattice is taken.
enum class ToughnessAt {
  tip,       ///< mean over the last disc
  mean,      ///< that opens a crack as much, if it is uniform
  injection  ///< at the injection
};

/// The mean net pressure over the last piece of a wing, Pa.
inline double tip_pressure(const analytic::KgdFracture& f, double piece) {
  constexpr int cells = 50;  // finer towards the tip, where the pressure is singular
  const double within = std::fmin(piece, f.half_length);
  double mean = 0;
  for (int k = 0; k < cells; ++k) {
    const double y = (k + 0.5) / cells;
    mean += 3 * y * y / cells * f.net_pressure_at(f.half_length - within * y * y * y);
  }
  return mean;
}

/// A problem with its solution.
struct RegimeReference {
  analytic::KgdProblem problem{};
  analytic::KgdFracture fracture{};
  double toughness_pressure = 0;  ///< net pressure for which K_IC was taken, Pa

  double K_m() const { return analytic::dimensionless_toughness(problem); }  ///< Eq. 9
};

/// @param rock as slits say
/// @param viscosity Pa s
/// @param rate m2/s
/// @param time s
/// @param disc diameter, m
/// @param at where the toughness is that of the pressure
/// @param leakoff Carter's C_L, m/s^0.5
/// @throws InvalidParameter if a number is out of range
inline RegimeReference regime_reference(const analytic::LatticeFracture& rock, double viscosity,
                                        double rate, double time, double disc,
                                        ToughnessAt at = ToughnessAt::tip, double leakoff = 0) {
  RegimeReference r{.problem = {.E_prime = rock.E_prime,
                                .K_IC = rock.K_IC,
                                .viscosity = viscosity,
                                .leak_off = leakoff,
                                .rate = rate,
                                .time = time}};
  const auto pressure = [&] {
    const auto& f = r.fracture;
    if (at == ToughnessAt::tip) return tip_pressure(f, disc);
    if (at == ToughnessAt::injection) return f.net_pressure;
    return rock.E_prime * f.volume() / (2 * std::numbers::pi * f.half_length * f.half_length);
  };
  for (int round = 0; round < 30; ++round) {
    r.fracture = analytic::general_kgd(r.problem);
    r.toughness_pressure = pressure();
    r.problem.rate = rate + 2 * r.fracture.half_length * rock.volume_offset / time;
    // Half the way: pressure falls while toughness grows.
    r.problem.K_IC += (std::fmax(0, rock.toughness(r.toughness_pressure)) - r.problem.K_IC) / 2;
  }
  return r;
}

/// How far a crack may be from the fracture.
struct RegimeTolerance {
  static constexpr double length = 0.05;      ///< of the half-length, if that is more than a disc
  static constexpr double opening = 0.08;     ///< of the opening
  static constexpr double efficiency = 0.08;  ///< of the efficiency
  static constexpr double length_with_leak_off = 0.08;  ///< instead of the other two

  static bool length_holds(double half_length, double reference, double disc, bool leaks) {
    const double allowed =
        leaks ? length_with_leak_off * reference : std::fmax(disc, length * reference);
    return std::abs(half_length - reference) <= allowed;
  }
  static bool efficiency_holds(double ours, double reference) {
    return std::abs(ours / reference - 1) <= efficiency;
  }
  static bool opening_holds(double ours, double reference) {
    return std::abs(ours / reference - 1) <= opening;
  }
};

}  // namespace hfdem::support
