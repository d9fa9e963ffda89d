/// @file
/// Uniform pressure in a crack that loses fluid into the rock.
///
/// The uniform-pressure algorithm matches the volume of the crack with what is left of the
/// injection at its pressure, V_f - loss(P); what the rock takes is found before, with its slope,
/// and once more at the pressure with which the step ends. Flow through the rock goes backward in
/// time, so any fluid and any step will do.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include <hfdem/base/pack.hpp>
#include <hfdem/fluid/newtonian.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/state/concepts.hpp>
#include <hfdem/state/leakoff.hpp>
#include <hfdem/state/network.hpp>
#include <hfdem/state/step.hpp>
#include <hfdem/state/volume_balance.hpp>

namespace hfdem {

/// A `FlowScheme`: one pressure in the whole crack, and flow through the rock.
/// @tparam LeakoffPolicy what the crack loses into the rock
/// @tparam FluidPolicy law of the fluid; its viscosity counts in the rock alone
template <LeakoffLaw LeakoffPolicy, FluidLaw FluidPolicy = NewtonianFluid>
class LeakyUniformPressure {
 public:
  using Fluid = FluidPolicy;                 ///< as composed
  using Leakoff = LeakoffPolicy;             ///< as composed
  using Params = UniformPressure::Params;    ///< gain and tolerances
  static constexpr bool holds_fluid = true;  ///< needs a crack to enter
  static_assert(Leakoff::leaks, "without leak-off, uniform pressure is UniformPressure");

  /// @param params validated
  /// @param law of the fluid
  /// @param leakoff law of what is lost
  LeakyUniformPressure(const Params& params, const Fluid& law, const RockResponse&,
                       const Leakoff& leakoff = Leakoff({}))
      : uniform_(params), law_(law), leakoff_(leakoff) {}

  /// Fluid time of a step, s: the same for every step.
  double fluid_dt(double mechanical_dt) const { return uniform_.fluid_dt(mechanical_dt); }

  /// Lets the crack lose what it does, then matches its volume with the rest.
  /// @throws RunStopped if the crack opens far more than was injected, or the flow through the rock
  ///   has no solution
  template <class Relax>
  FluidStep advance(Network& network, const Injected& injected, Relax&& relax) {
    leakoff_.join(network);
    find_loss(network, injected);
    const FluidStep step = uniform_.advance(network, injected, std::forward<Relax>(relax), sum());
    find_loss(network, injected);
    leakoff_.commit(network, law_, {pressure_, stored_});
    return step;
  }

  /// Where the fluid is.
  /// @param network with widths and pressures
  /// @param injected so far, m2
  VolumeBalance balance(const Network& network, double injected) const {
    VolumeBalance b = uniform_.balance(network, injected - leakoff_.leaked());
    b.injected = injected;
    b.leaked = leakoff_.leaked();
    return b;
  }
  const Leakoff& leakoff() const { return leakoff_; }  ///< to be read

  /// The control, and what is lost.
  void exchange(auto& archive) { archive(uniform_, leakoff_); }

 private:
  /// What all wet domains have lost by the end of the step.
  struct Sum {
    double at, loss, slope;
    double operator()(double pressure) const { return loss + slope * (pressure - at); }
  };
  Sum sum() const {
    Sum sum{pressure_.front(), leakoff_.leaked(), 0};
    for (std::size_t d = 0; d < leakoff_.size(); ++d) {
      sum.loss += leakoff_.loss(d, pressure_[d]);
      sum.slope += leakoff_.slope(d);
    }
    return sum;
  }

  /// At the present pressure. The wet domains have all their room, or as much of it as there is
  /// fluid.
  void find_loss(const Network& network, const Injected& injected) {
    const double room = network.total_volume();
    const double left = injected.total - leakoff_.leaked() + network.filled_volume();
    const double full = room > 0 ? clamp(left / room, 0.0, 1.0) : 0;
    pressure_.clear(), stored_.clear();
    for (const Index d : network.wet_domains()) {
      pressure_.push_back(network.pressure(d));
      stored_.push_back(full * network.domain_volume(d));
    }
    leakoff_.find_loss(network, law_, injected.dt, {pressure_, stored_}, Euler::backward);
  }

  UniformPressure uniform_;
  Fluid law_;
  Leakoff leakoff_;
  std::vector<double> pressure_, stored_;  // of each wet domain
};

}  // namespace hfdem
