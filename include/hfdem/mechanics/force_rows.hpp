/// @file
/// Force rows: each contact writes one, each body gathers its own.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include <hfdem/base/pack.hpp>
#include <hfdem/base/row_place.hpp>
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
  explicit ForceRows(std::size_t bodies) : bodies_(bodies) {}

  /// Adds contacts whose rows start at `first_row`; `padded_size` rows are theirs.
  void add(std::span<const ContactGeometry> contacts, std::size_t first_row,
           std::size_t padded_size) {
    rows_.resize(std::max(rows_.size(), 1 + first_row + padded_size), Pack{});
    pulls_.reserve(pulls_.size() + 2 * contacts.size());
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const auto& [bodies, frame] = contacts[c];
      const Vec2 normal{frame.normal_x, frame.normal_y};
      const auto row = static_cast<Index>(1 + first_row + c);
      pulls_.push_back({bodies.first, row << 1 | 1U, normal});
      pulls_.push_back({bodies.second, row << 1, -normal});
    }
  }

  /// Fixes the order of summation; call once, after the last `add`.
  void arrange() {
    // Sorted by body without moving them: the contacts of a large specimen fill much of the memory.
    std::vector<Index> next(bodies_ + 1, 0), sorted(pulls_.size());
    for (const auto& p : pulls_) ++next[p.body + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (Index k = 0; k < pulls_.size(); ++k) sorted[next[pulls_[k].body]++] = k;
    usual_rows_.reserve(usual * bodies_);
    signs_.reserve(bodies_);
    further_from_.reserve(bodies_ + 1);
    std::vector<Pull> pulls;
    for (std::size_t body = 0, k = 0; body < bodies_; ++body) {
      pulls.clear();
      for (; k < next[body]; ++k) pulls.push_back(pulls_[sorted[k]]);
      const std::size_t opposites = pair_up(pulls, 0, [](const Pull& a, const Pull& b) {
        return dot(a.direction, b.direction) < -0.999999;
      });
      pair_up(pulls, opposites,
              [](const Pull& a, const Pull& b) { return a.first() != b.first(); });
      list(pulls);
    }
    further_from_.push_back(static_cast<Index>(further_.size()));
    pulls_ = {};
  }

  /// All rows; the contacts write them.
  std::span<Pack> rows() { return std::span(rows_).subspan(1); }
  /// All rows, as of the last mechanical step.
  std::span<const Pack> rows() const { return std::span(rows_).subspan(1); }

  /// Sum of the rows that act on a body: (x, y) in N per m; its torque is the sum of the other two.
  /// Inlined wherever it is called: a function that returns a pack has no portable way to.
  [[gnu::always_inline]] Pack total(std::size_t body) const {
    const Index* place = usual_rows_.data() + usual * body;
    const Pack* rows = rows_.data();
    const unsigned signs = signs_[body];
    const auto& sign = signs_of_rows_[signs % (1U << usual)];
    Pack sum{};
    for (std::size_t k = 0; k < usual; k += 2)
      sum += plus_signed(sign[k] * RowPlace::at(rows, place[k]), sign[k + 1],
                         RowPlace::at(rows, place[k + 1]));
    if (signs >= has_further) {
      for (Index k = further_from_[body]; k < further_from_[body + 1]; k += 2)
        sum += signed_row(further_[k]) + signed_row(further_[k + 1]);
    }
    return sum;
  }

  /// The rows; who gathers them is fixed.
  void exchange(auto& archive) { archive(rows()); }

 private:
  struct Pull {
    Index body;
    Index entry;     ///< row, and in the last bit whether the body is the contact's first
    Vec2 direction;  ///< from the body to the contact

    bool first() const { return (entry & 1U) != 0; }
  };

  /// Every body has so many rows at hand, and few need more: random rock has 4.8 contacts per disc,
  /// and a loop that ends after three, five or four of them is one that processors guess wrongly.
  /// Row 0 is zero, and fills what a body does not need.
  static constexpr std::size_t usual = 6;
  static constexpr unsigned has_further = 1U << 7;  // in a body's signs

  static Pack sign(bool first) { return first ? of_first : Pack{1, 1, 1, 1}; }
  Pack signed_row(Index entry) const { return sign((entry & 1U) != 0) * rows_[entry >> 1]; }

  /// What every pattern of first and second bodies makes of the usual rows.
  static std::vector<std::array<Pack, usual>> all_signs() {
    std::vector<std::array<Pack, usual>> all(1U << usual);
    for (std::size_t signs = 0; signs < all.size(); ++signs)
      for (std::size_t k = 0; k < usual; ++k) all[signs][k] = sign((signs >> k & 1U) != 0);
    return all;
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

  /// Pairs that pull and push have the row of the body as second first.
  void list(std::span<Pull> pulls) {
    for (std::size_t k = 0; k + 1 < pulls.size() && pulls[k].first() != pulls[k + 1].first();
         k += 2)
      if (pulls[k].first()) std::swap(pulls[k], pulls[k + 1]);
    further_from_.push_back(static_cast<Index>(further_.size()));
    unsigned signs = pulls.size() > usual ? has_further : 0;
    for (std::size_t k = 0; k < usual; ++k) {
      usual_rows_.push_back(RowPlace::of(k < pulls.size() ? pulls[k].entry >> 1 : 0));
      if (k < pulls.size() && pulls[k].first()) signs |= 1U << k;
    }
    signs_.push_back(static_cast<std::uint8_t>(signs));
    for (std::size_t k = usual; k < pulls.size(); ++k) further_.push_back(pulls[k].entry);
    if (further_.size() % 2 != 0) further_.push_back(0);
  }

  std::size_t bodies_;
  std::vector<Pack> rows_{Pack{}};   // after the zero, those of the contacts
  std::vector<Pull> pulls_;          // until they are arranged
  std::vector<Index> usual_rows_;    // places of those of each body
  std::vector<std::uint8_t> signs_;  // of each body: in which of them it is the first
  std::vector<std::array<Pack, usual>> signs_of_rows_ = all_signs();
  std::vector<Index> further_;       // of bodies with more contacts, in pairs: row and sign
  std::vector<Index> further_from_;  // where they begin, of each body; and the end
};

}  // namespace hfdem
