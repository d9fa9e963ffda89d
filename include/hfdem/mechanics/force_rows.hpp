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
  explicit ForceRows(std::size_t bodies) : pulls_(bodies) {}

  /// Adds contacts whose rows start at `first_row`.
  void add(std::span<const ContactGeometry> contacts, std::size_t first_row,
           std::size_t padded_size) {
    rows_.resize(std::max(rows_.size(), first_row + padded_size), Pack{});
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const auto& [bodies, frame] = contacts[c];
      const Vec2 normal{frame.normal_x, frame.normal_y};
      const auto row = static_cast<Index>(first_row + c);
      pulls_[bodies.first].push_back({encode(row, true), normal});
      pulls_[bodies.second].push_back({encode(row, false), -normal});
    }
  }

  /// Fixes the order of summation; call once, after the last `add`.
  void arrange() {
    begin_.assign(1, 0);
    for (auto& pulls : pulls_) {
      pair_up_opposites(pulls);
      for (const Pull& p : pulls) entries_.push_back(p.entry);
      begin_.push_back(static_cast<Index>(entries_.size()));
    }
    pulls_ = {};
  }

  std::span<Pack> rows() { return rows_; }
  std::span<const Pack> rows() const { return rows_; }

  /// Sum of the rows that act on a body: (x, y) in N per m; its torque is the sum of the other two.
  Pack total(std::size_t body) const {
    const Index* entry = entries_.data() + begin_[body];
    const Index* const end = entries_.data() + begin_[body + 1];
    Pack sum{};
    for (; entry + 1 < end; entry += 2) sum += signed_row(entry[0]) + signed_row(entry[1]);
    if (entry < end) sum += signed_row(entry[0]);
    return sum;
  }

 private:
  struct Pull {
    Index entry;
    Vec2 direction;  ///< from the body to the contact
  };

  static Index encode(Index row, bool as_first) { return row << 1 | (as_first ? 1U : 0U); }

  Pack signed_row(Index entry) const {
    constexpr long long sign_bit = std::numeric_limits<long long>::min();
    static constexpr PackMask flip[2] = {PackMask{}, PackMask{sign_bit, sign_bit, sign_bit, 0}};
    return std::bit_cast<Pack>(std::bit_cast<PackMask>(rows_[entry >> 1]) ^ flip[entry & 1]);
  }

  static void pair_up_opposites(std::vector<Pull>& pulls) {
    constexpr double opposite = -0.999999;
    std::size_t paired = 0;
    for (std::size_t a = 0; a < pulls.size(); ++a) {
      if (a < paired) continue;
      for (std::size_t b = a + 1; b < pulls.size(); ++b) {
        if (dot(pulls[a].direction, pulls[b].direction) > opposite) continue;
        std::swap(pulls[paired], pulls[a]);
        std::swap(pulls[paired + 1], pulls[b]);
        paired += 2;
        a = paired - 1;
        break;
      }
    }
  }

  std::vector<Pack> rows_;
  std::vector<std::vector<Pull>> pulls_;
  std::vector<Index> begin_, entries_;
};

}  // namespace hfdem
