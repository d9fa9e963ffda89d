/// @file
/// Newton's law for the discs: explicit central differences with local damping.
///
/// Source: P. A. Cundall, local (non-viscous) damping as in PFC2D: the force that accelerates is
/// F - d |F| sign(v), component by component.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include <hfdem/base/pack.hpp>
#include <hfdem/base/parallel.hpp>
#include <hfdem/mechanics/force_rows.hpp>
#include <hfdem/state/discs.hpp>

namespace hfdem {

/// Both torque lanes of a sum of force rows become the whole torque; the two force lanes stay.
inline Pack with_whole_torque(const Pack& force) {
  return force + __builtin_shufflevector(force, Pack{}, 4, 5, 3, 2);
}

/// What local damping takes from a resultant force, component by component: d |F| sign(v).
inline Pack local_damping(double d, const Pack& force, const Pack& velocity) {
  return d * abs(force) * sign(velocity);
}

/// The time stepping of the discs; platens are moved by `Loading`.
class DiscMotion {
 public:
  DiscMotion() = default;
  /// @param discs whose masses it needs
  /// @param dt mechanical time step, s
  /// @param damping local damping coefficient d
  DiscMotion(const Discs& discs, double dt, double damping)
      : damping_(damping),
        dt_over_inertia_(discs.size(), {1, 1}),
        largest_in_chunk_((discs.size() + grain - 1) / grain) {
    set_dt(discs, dt);
  }

  /// Changes the mechanical time step, s.
  void set_dt(const Discs& discs, double dt) {
    dt_ = dt;
    for (std::size_t i = 0; i < discs.size(); ++i)
      if (auto& of_disc = dt_over_inertia_[i]; of_disc.translation > 0)
        of_disc = {dt / discs.mass[i], dt / discs.inertia(i)};
  }

  double dt() const { return dt_; }  ///< mechanical time step, s

  /// Leaves discs out of the largest resultant that `step` returns: a loose grain that carries a
  /// dead load alone finds no equilibrium.
  void leave_out(std::span<const Index> discs) {
    if (discs.empty()) return;
    counted_.resize(dt_over_inertia_.size(), true);
    for (const Index i : discs) counted_[i] = false;
  }
  /// A disc that from now on keeps its velocity, whatever pulls on it.
  void keep_velocity(Index disc) { dt_over_inertia_[disc] = {0, 0}; }

  /// Gathers all forces on each disc and moves it by one time step.
  /// @returns the largest resultant force on a disc before damping, N per m; not a finite number if
  ///   any resultant is not
  double step(Discs& discs, const ForceRows& forces, int threads) {
    for_chunks(
        discs.size(), grain, threads, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
          Pack largest{}, sum{};
          for (std::size_t i = begin; i < end; ++i) {
            const auto [x, y] = discs.load[i];
            const Pack force = forces.total(i) + Pack{x, y, 0, 0};
            const Pack square = force * force;
            if (counted_.empty() || counted_[i])
              largest = max(largest, square + __builtin_shufflevector(square, square, 1, 0, 3, 2));
            sum += square;
            move(discs, i, force);
          }
          // A maximum loses what is not a number; a sum keeps it.
          const double total = sum[0] + sum[1] + sum[2] + sum[3];
          largest_in_chunk_[chunk] = std::isfinite(total) ? largest[0] : total;
        });
    double largest = 0;
    for (const double square : largest_in_chunk_) {
      if (!std::isfinite(square)) return square;
      largest = max(largest, square);
    }
    return std::sqrt(largest);
  }

 private:
  struct DtOverInertia {
    double translation, rotation;
  };
  static constexpr std::size_t grain = 256;

  void move(Discs& discs, std::size_t i, const Pack& force) const {
    const Pack pull = with_whole_torque(force);
    Pack& velocity = discs.velocity[i];
    const Pack damped = pull - local_damping(damping_, pull, velocity);
    const auto [translation, rotation] = dt_over_inertia_[i];
    velocity += damped * Pack{translation, translation, rotation, rotation};
    discs.displacement[i] += velocity * dt_;
  }

  double dt_ = 0, damping_ = 0;
  std::vector<DtOverInertia> dt_over_inertia_;
  std::vector<bool> counted_;  // empty if all are
  std::vector<double> largest_in_chunk_;
};

}  // namespace hfdem
