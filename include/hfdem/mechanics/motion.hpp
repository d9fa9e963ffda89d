/// @file
/// Newton's law for the discs: explicit central differences with local damping.
///
/// Source: P. A. Cundall, local (non-viscous) damping as in PFC2D: the force that accelerates is
/// F - d |F| sign(v), component by component.
#pragma once

#include <bit>
#include <cmath>
#include <span>
#include <vector>

#include <hfdem/base/pack.hpp>
#include <hfdem/base/parallel.hpp>
#include <hfdem/mechanics/force_rows.hpp>
#include <hfdem/mechanics/tally.hpp>
#include <hfdem/state/discs.hpp>

namespace hfdem {

/// Both torque lanes of a sum of force rows become the whole torque; the two force lanes stay.
inline Pack with_whole_torque(const Pack& force) {
  return force + __builtin_shufflevector(force, Pack{}, 4, 5, 3, 2);
}

/// What local damping takes from a resultant force, component by component: d |F| sign(v).
inline Pack local_damping(double d, const Pack& force, const Pack& velocity) {
  return with_sign(d * abs(force), velocity);
}

/// The time stepping of the discs; platens are moved by `Loading`.
class DiscMotion {
 public:
  DiscMotion() = default;
  /// @param discs whose masses it needs
  /// @param dt mechanical time step, s
  /// @param damping local damping coefficient d
  DiscMotion(const Discs& discs, double dt, double damping)
      : damping_(damping), dt_over_inertia_(discs.size(), {1, 1}) {
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

  /// Leaves discs out of the largest resultant: a loose grain that carries a
  /// dead load alone finds no equilibrium.
  void leave_out(std::span<const Index> discs) {
    if (discs.empty()) return;
    counted_.resize(dt_over_inertia_.size(), true);
    for (const Index i : discs) counted_[i] = false;
  }
  /// A disc that from now on keeps its velocity, whatever pulls on it.
  void keep_velocity(Index disc) { dt_over_inertia_[disc] = {0, 0}; }

  /// Gathers all forces on discs `begin` to `end` - 1 and moves them by one time step.
  [[gnu::always_inline]] void move(std::size_t begin, std::size_t end, Discs& discs,
                                   const ForceRows& forces, MotionTally& tally) const {
    // Pointers that nothing written here can change.
    const Vec2* load = discs.load.data();
    const DtOverInertia* dt_over_inertia = dt_over_inertia_.data();
    Pack *velocities = discs.velocity.data(), *displacement = discs.displacement.data();
    const double dt = dt_, damping = damping_;
    const bool all_count = counted_.empty();
    MotionTally so_far = tally;
    for (std::size_t i = begin; i < end; ++i) {
      const Pack force = forces.total(i) + widened(load[i]);
      const Pack square = force * force;
      if (all_count || counted_[i])
        so_far.largest =
            max(so_far.largest, square + __builtin_shufflevector(square, square, 1, 0, 3, 2));
      so_far.sum += square;
      const Pack pull = with_whole_torque(force), before = velocities[i];
      const Pack damped = pull - local_damping(damping, pull, before);
      const Pack velocity = before + damped * doubled(dt_over_inertia[i]);
      velocities[i] = velocity;
      so_far.fastest = max(so_far.fastest, abs(velocity));
      displacement[i] += velocity * dt;
    }
    tally = so_far;
  }

  /// Moves all discs by one time step.
  Moved step(Discs& discs, const ForceRows& forces, int threads) {
    tallies_.assign((discs.size() + grain - 1) / grain, {});
    for_chunks(discs.size(), grain, threads,
               [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                 move(begin, end, discs, forces, tallies_[chunk]);
               });
    return moved(tallies_);
  }

  /// Puts the tallies of all discs together.
  Moved moved(std::span<const MotionTally> tallies) const {
    Pack largest{}, fastest{};
    for (const MotionTally& t : tallies) {
      const double total = t.sum[0] + t.sum[1] + t.sum[2] + t.sum[3];
      if (!std::isfinite(total)) return {total, total, total};
      largest = max(largest, t.largest);
      fastest = max(fastest, t.fastest);
    }
    return {std::sqrt(largest[0]), dt_ * max(fastest[0], fastest[1]), dt_ * fastest[2]};
  }

 private:
  struct DtOverInertia {
    double translation, rotation;
  };
  static constexpr std::size_t grain = 256;

  /// (a, b, 0, 0)
  static Pack widened(const Vec2& two) {
    return __builtin_shufflevector(std::bit_cast<PackHalf>(two), PackHalf{}, 0, 1, 2, 3);
  }
  /// (a, a, b, b)
  static Pack doubled(const DtOverInertia& two) {
    const PackHalf both = std::bit_cast<PackHalf>(two);
    return __builtin_shufflevector(both, both, 0, 0, 1, 1);
  }

  double dt_ = 0, damping_ = 0;
  std::vector<DtOverInertia> dt_over_inertia_;
  std::vector<bool> counted_;  // empty if all are
  std::vector<MotionTally> tallies_;
};

}  // namespace hfdem
