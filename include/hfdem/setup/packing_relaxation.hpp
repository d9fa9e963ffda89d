/// @file
/// Pushes overlapping discs in a box apart until their forces balance.
///
/// Frictionless springs of stiffness one that only push, between discs and (as between a disc and
/// its mirror image) at the walls; unit masses. The least energy is sought by FIRE: E. Bitzek, P.
/// Koskinen, F. Gaehler, M. Moseler, P. Gumbsch, "Structural relaxation made simple", Phys. Rev.
/// Lett. 97 (2006) 170201. Each pair of neighbours writes one row, each disc sums its own rows, and
/// sums over discs run chunk by chunk in a fixed order, so no bit depends on the number of threads.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/pack.hpp>
#include <hfdem/base/parallel.hpp>
#include <hfdem/base/row_place.hpp>
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
        farthest_(sums_.size()),
        signs_(all_signs()) {}

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

  /// Sums of every fourth row.
  using Lanes = std::array<Pack, four>;
  static Pack sum(const Lanes& l) { return (l[0] + l[1]) + (l[2] + l[3]); }

  /// The signs of (x, y, radius, 0), and of a pair's row, for the first disc and for the second.
  static constexpr Pack as_first{1, 1, 1, 1}, as_second{-1, -1, 1, 1};
  using Signs = std::array<std::array<Pack, usual>, usual + 1>;
  /// Those of a disc's usual rows if it is the second disc in so many of them.
  static Signs all_signs() {
    Signs signs{};
    for (std::size_t seconds = 0; seconds < signs.size(); ++seconds)
      for (std::size_t k = 0; k < usual; ++k)
        signs[seconds][k] = k < seconds ? as_second : as_first;
    return signs;
  }

  double discs() const { return static_cast<double>(specimen_.size()); }
  static Pack root(const Pack& p) {
    return Pack{std::sqrt(p[0]), std::sqrt(p[1]), std::sqrt(p[2]), std::sqrt(p[3])};
  }

  void start() {
    const std::size_t n = specimen_.size();
    for (std::size_t i = 0; i < n; ++i)
      row_[i] = Pack{specimen_.centre[i].x, specimen_.centre[i].y, specimen_.radius[i], 0};
    // Fills up the list of pairs; it is far from everything.
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

  /// Lists which discs may touch before any disc has moved by half the skin, and for each disc the
  /// rows of its pairs: first those in which it is the second, as pairs are sorted.
  void find_neighbours() {
    finish();
    const CellGrid grid(specimen_, skin_);
    const std::size_t n = specimen_.size();
    std::vector<Index> next_free(n, 0);
    as_second_.assign(n, 0);
    pairs_.clear();
    grid.for_each_pair([&](Pair p) {
      pairs_.push_back(p);
      ++next_free[p.first], ++next_free[p.second], ++as_second_[p.second];
    });
    begin_.assign(n + 1, 0);
    for (std::size_t i = 0; i < n; ++i)
      begin_[i + 1] = begin_[i] + std::max(usual, (next_free[i] + four - 1) / four * four);
    place_.assign(begin_[n], RowPlace::of(0));
    std::copy(begin_.begin(), begin_.end() - 1, next_free.begin());
    for (Index k = 0; k < pairs_.size(); ++k)
      for (const Index disc : {pairs_[k].first, pairs_[k].second})
        place_[next_free[disc]++] = RowPlace::of(1 + k);
    // Disc 0 is far from the one far away.
    pairs_.resize((pairs_.size() + four - 1) / four * four, {0, static_cast<Index>(n)});
    pull_.assign(1 + pairs_.size(), Pack{});
  }

  /// Computes the forces.
  Sums evaluate() {
    for_chunks(pairs_.size() / four, grain, threads_,
               [&](std::size_t, std::size_t begin, std::size_t end) {
                 for (std::size_t block = begin; block < end; ++block) pull(four * block);
               });
    for_chunks(specimen_.size(), grain, threads_,
               [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                 Sums s;
                 Lanes rows{};
                 for (std::size_t i = begin; i < end; ++i) {
                   const Vec2 f = force_[i] = force_on(i, rows);
                   const Vec2 v = velocity_[i];
                   s.power += dot(f, v);
                   s.velocity_squared += dot(v, v);
                   s.force_squared += dot(f, f);
                   s.resultant += norm(f);
                 }
                 const Pack all = sum(rows);
                 s.contact_force = all[2];
                 s.contacts = all[3];
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

  /// Writes the rows of four pairs: the force on the first disc, its size, and one if they touch.
  void pull(std::size_t k) {
    const auto row = [&](std::size_t pair) {
      return plus_signed(row_[pairs_[pair].first], as_second, row_[pairs_[pair].second]);
    };
    Pack away_x = row(k), away_y = row(k + 1), radii = row(k + 2), unused = row(k + 3);
    transpose(away_x, away_y, radii, unused);
    const Pack distance = root(away_x * away_x + away_y * away_y);
    const Pack overlap_share = max(Pack{}, radii / distance - 1.0);
    Pack force_x = overlap_share * away_x, force_y = overlap_share * away_y;
    Pack force = overlap_share * distance;
    Pack touch = overlap_share > 0.0 ? Pack{} + 1.0 : Pack{};
    transpose(force_x, force_y, force, touch);
    Pack* rows = &pull_[1 + k];
    rows[0] = force_x;
    rows[1] = force_y;
    rows[2] = force;
    rows[3] = touch;
  }

  /// The resultant on one disc; adds its rows, one after the other to four sums.
  Vec2 force_on(std::size_t disc, Lanes& sums) const {
    const Pack own = row_[disc];
    const Pack to_walls{own[0], specimen_.width - own[0], own[1], specimen_.height - own[1]};
    const Pack wall = max(Pack{}, 2.0 * (own[2] - to_walls));
    if (any(wall > 0.0)) [[unlikely]]
      for (std::size_t lane = 0; lane < four; ++lane)
        sums[lane] += Pack{0, 0, wall[lane], wall[lane] > 0 ? 1.0 : 0.0};
    Lanes rows{};
    const Index begin = begin_[disc], end = begin_[disc + 1], seconds = as_second_[disc];
    const Index* place = &place_[begin];
    const auto add = [&](std::size_t k, const Pack& sign) {
      const Pack& row = RowPlace::at(pull_.data(), place[k]);
      rows[k % four] = plus_signed(rows[k % four], sign, row);
      sums[k % four] += row;  // whose force and touch have no sign
    };
    const auto& signs = signs_[std::min(seconds, usual)];
    for (std::size_t k = 0; k < usual; ++k) add(k, signs[k]);
    for (Index k = usual; k < end - begin; ++k) add(k, k < seconds ? as_second : as_first);
    const Pack force = sum(rows);
    return {force[0] + wall[0] - wall[1], force[1] + wall[2] - wall[3]};
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
  std::vector<Pair> pairs_{};       ///< that may touch; four by four
  std::vector<Pack> pull_{};        ///< after a row of zeros, those of the pairs
  std::vector<Index> begin_{};      ///< where the places of each disc's rows begin, and the end
  std::vector<Index> place_{};      ///< of rows
  std::vector<Index> as_second_{};  ///< in how many of its pairs a disc is the second
  Signs signs_;
};

}  // namespace hfdem::detail
