/// @file
/// Neighbours by a uniform grid of cells: no library, and the fastest search where the discs are
/// alike in size and evenly spread.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// A `NeighbourSearch` that sorts the discs into square cells as wide as the widest pair is apart,
/// so that the neighbours of a disc lie in its own cell and the eight around it.
class CellGrid {
 public:
  /// Finds the pairs.
  /// @param specimen is not kept
  /// @param reach largest gap of a pair, m
  CellGrid(const Specimen& specimen, double reach) {
    if (specimen.size() < 2) return;
    lay_out(specimen, reach);
    const std::vector<Index> cell = fill(specimen);
    std::vector<Index> near;
    for (Index i = 0; i < specimen.size(); ++i) {
      const std::size_t first = pairs_.size();
      for_each_around(cell[i], [&](std::span<const Index> discs) {
        // Most are too far apart by much: seen without a root, and without a branch.
        near.resize(std::max(near.size(), discs.size()));
        std::size_t count = 0;
        for (const Index j : discs) {
          const double most = specimen.radius[i] + specimen.radius[j] + reach;
          const Vec2 between = specimen.centre[j] - specimen.centre[i];
          near[count] = j;
          count += static_cast<std::size_t>(i < j) &
                   static_cast<std::size_t>(dot(between, between) <= (1 + 1e-9) * most * most);
        }
        for (std::size_t k = 0; k < count; ++k)
          if (specimen.gap({i, near[k]}) <= reach) pairs_.push_back({i, near[k]});
      });
      std::sort(pairs_.begin() + static_cast<std::ptrdiff_t>(first), pairs_.end());
    }
  }

  /// Calls `f(Pair)` for every pair whose gap is at most the reach, sorted.
  template <class F>
  void for_each_pair(F&& f) const {
    for (const Pair& p : pairs_) f(p);
  }

 private:
  /// Chooses origin, pitch and number of cells; never many more cells than discs.
  void lay_out(const Specimen& s, double reach) {
    Vec2 low = s.centre[0], high = low;
    for (const Vec2 c : s.centre) {
      low = {std::fmin(low.x, c.x), std::fmin(low.y, c.y)};
      high = {std::fmax(high.x, c.x), std::fmax(high.y, c.y)};
    }
    origin_ = low;
    const Vec2 extent = high - low;
    const double largest = *std::max_element(s.radius.begin(), s.radius.end());
    const auto discs = static_cast<double>(s.size());
    // A little wider than needed: rounding must not push a pair two cells apart.
    const double widest = (1 + 1e-9) * std::fmax(2 * largest + reach, 0.0);
    pitch_ =
        std::max({widest, (extent.x + extent.y) / discs, std::sqrt(extent.x * extent.y / discs)});
    if (!(pitch_ > 0)) pitch_ = 1;
    columns_ = static_cast<std::size_t>(extent.x / pitch_) + 1;
    rows_ = static_cast<std::size_t>(extent.y / pitch_) + 1;
  }

  /// Sorts the discs into their cells, in the order of their numbers.
  /// @returns each disc's cell
  std::vector<Index> fill(const Specimen& s) {
    std::vector<Index> cell;
    begin_.assign(columns_ * rows_ + 1, 0);
    for (const Vec2 c : s.centre) {
      const Vec2 at = (1 / pitch_) * (c - origin_);
      const std::size_t column = std::min(columns_ - 1, static_cast<std::size_t>(at.x));
      const std::size_t row = std::min(rows_ - 1, static_cast<std::size_t>(at.y));
      cell.push_back(static_cast<Index>(row * columns_ + column));
      ++begin_[cell.back() + 1];
    }
    for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
    std::vector<Index> next_free(begin_.begin(), begin_.end() - 1);
    discs_.resize(s.size());
    for (Index i = 0; i < s.size(); ++i) discs_[next_free[cell[i]]++] = i;
    return cell;
  }

  /// Calls `f(discs)` for the discs in a cell and the eight around it, row by row.
  template <class F>
  void for_each_around(Index cell, F&& f) const {
    const std::size_t column = cell % columns_, row = cell / columns_;
    const std::size_t left = column == 0 ? 0 : column - 1;
    const std::size_t right = std::min(columns_ - 1, column + 1);
    for (std::size_t r = row == 0 ? 0 : row - 1; r <= std::min(rows_ - 1, row + 1); ++r) {
      const Index begin = begin_[r * columns_ + left], end = begin_[r * columns_ + right + 1];
      f(std::span(discs_).subspan(begin, end - begin));
    }
  }

  Vec2 origin_;
  double pitch_ = 1;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<Index> begin_,
      discs_;  ///< cell c holds discs_[begin_[c]] .. discs_[begin_[c + 1] - 1]
  std::vector<Pair> pairs_;
};

}  // namespace hfdem
