/// @file
/// Pushes overlapping discs in a box apart until their forces balance.
///
/// Frictionless springs of stiffness one that only push, between discs and (as between a disc and
/// its mirror image) at the walls; unit masses. The least energy is sought by FIRE: E. Bitzek, P.
/// Koskinen, F. Gaehler, M. Moseler, P. Gumbsch, "Structural relaxation made simple", Phys. Rev.
/// Lett. 97 (2006) 170201. Each disc sums its own forces, and sums over discs run chunk by chunk in
/// a fixed order, so no bit depends on the number of threads.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/pack.hpp>
#include <hfdem/base/parallel.hpp>
#include <hfdem/neighbours/cell_grid.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem::detail {

/// Relaxes the centres of one specimen in place; its radii may change between runs.
class PackingRelaxation {
 public:
  /// @param specimen must outlive the relaxation
  /// @param threads for the loops
  PackingRelaxation(Specimen& specimen, int threads)
      : specimen_(specimen),
        threads_(threads),
        row_(specimen.size() + 1),
        force_(specimen.size()),
        velocity_(specimen.size()),
        sums_((specimen.size() + grain - 1) / grain),
        farthest_(sums_.size()) {}

  /// Until the mean resultant on a disc is at most `tolerance` of the mean contact force.
  /// @throws RunStopped if that takes too long
  void run(double tolerance) {
    constexpr int max_steps = 100000, steps_before_speeding_up = 5;
    constexpr double first_dt = 0.1, longest_dt = 0.6, first_steering = 0.1;
    start();
    double dt = first_dt, steering = first_steering;
    int downhill = 0;
    for (int step = 0; step < max_steps; ++step) {
      const Sums s = evaluate();
      if (s.resultant * s.contacts <= tolerance * s.contact_force * discs()) return finish();
      double keep = 0, along_force = 0;
      if (s.power > 0) {
        keep = 1 - steering;
        along_force = steering * std::sqrt(s.velocity_squared / s.force_squared);
        if (++downhill > steps_before_speeding_up) {
          dt = std::fmin(1.1 * dt, longest_dt);
          steering *= 0.99;
        }
      } else {  // uphill: stop, and set out again more slowly
        downhill = 0;
        dt /= 2;
        steering = first_steering;
      }
      if (2 * move(dt, keep, along_force) > skin_) find_neighbours();
    }
    throw RunStopped("the random packing found no equilibrium in " + std::to_string(max_steps) +
                     " steps: its porosity is too high for its grains to hold each other");
  }

 private:
  static constexpr std::size_t grain = 512;  ///< discs per chunk
  static constexpr Index four = pack_width;
  /// Places that every list of neighbours has, and few need more: a loop that ends after two blocks
  /// of four or after three is one that processors guess wrongly.
  static constexpr Index usual = 12;

  /// Over the discs of a chunk, or all of them.
  struct Sums {
    double power = 0, velocity_squared = 0, force_squared = 0, resultant = 0;
    double contact_force = 0, contacts = 0;  ///< a contact counts at each of its ends
  };

  double discs() const { return static_cast<double>(specimen_.size()); }
  static double sum(const Pack& p) { return (p[0] + p[1]) + (p[2] + p[3]); }
  static Pack root(const Pack& p) {
    return Pack{std::sqrt(p[0]), std::sqrt(p[1]), std::sqrt(p[2]), std::sqrt(p[3])};
  }

  void start() {
    const std::size_t n = specimen_.size();
    for (std::size_t i = 0; i < n; ++i)
      row_[i] = Pack{specimen_.centre[i].x, specimen_.centre[i].y, specimen_.radius[i], 0};
    // Fills up lists of neighbours; it is far from everything.
    const double far = 1e3 * (specimen_.width + specimen_.height);
    row_[n] = Pack{far, far, 0, 0};
    std::fill(velocity_.begin(), velocity_.end(), Vec2{});
    // The mean radius: wider skins make longer lists, narrower ones more searches.
    skin_ = std::accumulate(specimen_.radius.begin(), specimen_.radius.end(), 0.0) / discs();
    find_neighbours();
  }

  void finish() {
    for (std::size_t i = 0; i < specimen_.size(); ++i)
      specimen_.centre[i] = {row_[i][0], row_[i][1]};
  }

  /// Lists, for each disc, whom it may touch before any disc has moved by half the skin; four by
  /// four.
  void find_neighbours() {
    finish();
    const CellGrid grid(specimen_, skin_);
    const std::size_t n = specimen_.size();
    std::vector<Index> next_free(n, 0);
    grid.for_each_pair([&](Pair p) { ++next_free[p.first], ++next_free[p.second]; });
    begin_.assign(n + 1, 0);
    for (std::size_t i = 0; i < n; ++i)
      begin_[i + 1] = begin_[i] + std::max(usual, (next_free[i] + four - 1) / four * four);
    neighbour_.assign(begin_[n], static_cast<Index>(n));
    std::copy(begin_.begin(), begin_.end() - 1, next_free.begin());
    grid.for_each_pair([&](Pair p) {
      neighbour_[next_free[p.first]++] = p.second;
      neighbour_[next_free[p.second]++] = p.first;
    });
  }

  /// Computes the forces.
  Sums evaluate() {
    for_chunks(specimen_.size(), grain, threads_,
               [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                 Sums s;
                 Pack contact_force{}, contacts{};
                 for (std::size_t i = begin; i < end; ++i) {
                   const Vec2 f = force_[i] = force_on(i, contact_force, contacts);
                   const Vec2 v = velocity_[i];
                   s.power += dot(f, v);
                   s.velocity_squared += dot(v, v);
                   s.force_squared += dot(f, f);
                   s.resultant += norm(f);
                 }
                 s.contact_force = sum(contact_force);
                 s.contacts = sum(contacts);
                 sums_[chunk] = s;
               });
    Sums all;
    for (const Sums& s : sums_) {
      all.power += s.power;
      all.velocity_squared += s.velocity_squared;
      all.force_squared += s.force_squared;
      all.resultant += s.resultant;
      all.contact_force += s.contact_force;
      all.contacts += s.contacts;
    }
    return all;
  }

  /// The resultant on one disc; adds up the forces of its contacts, and counts them.
  Vec2 force_on(std::size_t disc, Pack& contact_force, Pack& contacts) const {
    const Pack own = row_[disc], one = Pack{} + 1.0;
    const Pack to_walls{own[0], specimen_.width - own[0], own[1], specimen_.height - own[1]};
    const Pack wall = max(Pack{}, 2.0 * (own[2] - to_walls));
    contact_force += wall;
    contacts += wall > 0.0 ? one : Pack{};
    Pack force_x{}, force_y{};
    const auto add_four = [&](Index k) {
      Pack x = row_[neighbour_[k]], y = row_[neighbour_[k + 1]];
      Pack radius = row_[neighbour_[k + 2]], unused = row_[neighbour_[k + 3]];
      transpose(x, y, radius, unused);
      const Pack away_x = own[0] - x, away_y = own[1] - y;
      const Pack distance = root(away_x * away_x + away_y * away_y);
      const Pack overlap_share = max(Pack{}, (own[2] + radius) / distance - 1.0);
      force_x += overlap_share * away_x;
      force_y += overlap_share * away_y;
      contact_force += overlap_share * distance;
      contacts += overlap_share > 0.0 ? one : Pack{};
    };
    const Index begin = begin_[disc], end = begin_[disc + 1];
    for (Index k = 0; k < usual; k += four) add_four(begin + k);
    for (Index k = begin + usual; k < end; k += four) add_four(k);
    return {sum(force_x) + wall[0] - wall[1], sum(force_y) + wall[2] - wall[3]};
  }

  /// Moves the discs, whose velocities become `keep` of themselves and so much of the forces.
  /// @returns how far a disc is from where its neighbours were found, at most
  double move(double dt, double keep, double along_force) {
    for_chunks(specimen_.size(), grain, threads_,
               [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                 double farthest = 0;
                 for (std::size_t i = begin; i < end; ++i) {
                   const Vec2 v = keep * velocity_[i] + (along_force + dt) * force_[i];
                   velocity_[i] = v;
                   row_[i] += Pack{dt * v.x, dt * v.y, 0, 0};
                   const Vec2 moved = Vec2{row_[i][0], row_[i][1]} - specimen_.centre[i];
                   farthest = max(farthest, dot(moved, moved));
                 }
                 farthest_[chunk] = farthest;
               });
    return std::sqrt(*std::max_element(farthest_.begin(), farthest_.end()));
  }

  Specimen& specimen_;  ///< its centres are where the neighbours were found
  int threads_;
  std::vector<Pack> row_;  ///< (x, y, radius, 0) of each disc, and of the one far away
  std::vector<Vec2> force_, velocity_;
  std::vector<Sums> sums_;        ///< of each chunk
  std::vector<double> farthest_;  ///< of each chunk, squared
  double skin_ = 0;
  std::vector<Index> begin_{}, neighbour_{};  ///< of disc i: neighbour_[begin_[i]] and following
};

}  // namespace hfdem::detail
