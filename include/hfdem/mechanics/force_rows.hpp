/// @file
/// Force rows: each contact writes one, each body gathers its own.
#pragma once

#include <algorithm>
#include <bit>
#include <limits>
#include <span>
#include <vector>

#include <hfdem/base/pack.hpp>
#include <hfdem/state/contact.hpp>

namespace hfdem {

/// The rows, and for every body the list of rows that act on it in a fixed order of summation.
///
/// The order does not depend on threads. Opposite contacts are summed in pairs, so that on a
/// regular array mirror images receive mirrored sums to the last bit; a symmetric crack then stays
/// symmetric however long the run.
class ForceRows {
 public:
  /// @param bodies discs and platens
  explicit ForceRows(std::size_t bodies) : pulls_(bodies) {}

  /// Adds contacts whose rows start at `first_row`; `padded_size` rows are theirs.
  void add(std::span<const ContactGeometry> contacts, std::size_t first_row,
           std::size_t padded_size) {
    rows_.resize(std::max(rows_.size(), first_row + padded_size), Pack{});
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const auto& [bodies, frame] = contacts[c];
      const Vec2 normal{frame.normal_x, frame.normal_y};
      const auto row = static_cast<Index>(first_row + c);
      pulls_[bodies.first].push_back({row, true, normal});
      pulls_[bodies.second].push_back({row, false, -normal});
    }
  }

  /// Fixes the order of summation; call once, after the last `add`.
  void arrange() {
    for (auto& pulls : pulls_) {
      const std::size_t opposites = pair_up(pulls, 0, [](const Pull& a, const Pull& b) {
        return dot(a.direction, b.direction) < -0.999999;
      });
      pair_up(pulls, opposites, [](const Pull& a, const Pull& b) { return a.first != b.first; });
      list(pulls);
    }
    lists_.push_back({static_cast<Index>(entries_.size()), 0});
    pulls_ = {};
  }

  /// All rows; the contacts write them.
  std::span<Pack> rows() { return rows_; }
  /// All rows, as of the last mechanical step.
  std::span<const Pack> rows() const { return rows_; }

  /// Sum of the rows that act on a body: (x, y) in N per m; its torque is the sum of the other two.
  /// Inlined wherever it is called: a function that returns a pack has no portable way to.
  [[gnu::always_inline]] Pack total(std::size_t body) const {
    const Index* entry = entries_.data() + lists_[body].begin;
    const Index* const through = entries_.data() + lists_[body].through;
    const Index* const end = entries_.data() + lists_[body + 1].begin;
    Pack sum{};
    for (; entry < through; entry += 2) sum += rows_[entry[0]] + flipped(rows_[entry[1]]);
    for (; entry + 1 < end; entry += 2) sum += signed_row(entry[0]) + signed_row(entry[1]);
    if (entry < end) sum += signed_row(entry[0]);
    return sum;
  }

  /// The rows; who gathers them is fixed.
  void exchange(auto& archive) { archive(std::span(rows_)); }

 private:
  struct Pull {
    Index row;
    bool first;      ///< whether the body is the contact's first
    Vec2 direction;  ///< from the body to the contact
  };

  /// A body's entries: up to `through`, pairs of rows that have the body as second and as first
  /// (all pairs within a regular array); from there on, rows with their sign in the last bit.
  struct List {
    Index begin, through;
  };

  Pack signed_row(Index entry) const {
    constexpr long long sign_bit = std::numeric_limits<long long>::min();
    static constexpr PackMask flip[2] = {PackMask{}, PackMask{sign_bit, sign_bit, sign_bit, 0}};
    return std::bit_cast<Pack>(std::bit_cast<PackMask>(rows_[entry >> 1]) ^ flip[entry & 1]);
  }

  /// Moves pairs that match to the front, behind those that are `paired` already.
  /// @returns how many are paired then
  template <class Match>
  static std::size_t pair_up(std::vector<Pull>& pulls, std::size_t paired, Match&& match) {
    for (std::size_t a = paired; a < pulls.size(); ++a) {
      for (std::size_t b = a + 1; b < pulls.size(); ++b) {
        if (!match(pulls[a], pulls[b])) continue;
        std::swap(pulls[paired], pulls[a]);
        std::swap(pulls[paired + 1], pulls[b]);
        paired += 2;
        a = paired - 1;
        break;
      }
    }
    return paired;
  }

  void list(std::span<const Pull> pulls) {
    const auto begin = static_cast<Index>(entries_.size());
    std::size_t k = 0;
    for (; k + 1 < pulls.size() && pulls[k].first != pulls[k + 1].first; k += 2) {
      const std::size_t as_first = pulls[k].first ? k : k + 1, as_second = 2 * k + 1 - as_first;
      entries_.push_back(pulls[as_second].row);
      entries_.push_back(pulls[as_first].row);
    }
    lists_.push_back({begin, static_cast<Index>(entries_.size())});
    for (; k < pulls.size(); ++k)
      entries_.push_back(pulls[k].row << 1 | (pulls[k].first ? 1U : 0U));
  }

  std::vector<Pack> rows_;
  std::vector<std::vector<Pull>> pulls_;
  std::vector<List> lists_;  // one per body, and the end
  std::vector<Index> entries_;
};

}  // namespace hfdem
