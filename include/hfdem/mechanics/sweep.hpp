/// @file
/// Contacts and discs in one pass: a disc moves as soon as all its contacts are known, while its
/// force rows are still in the caches.
///
/// Contacts are sorted by their first disc, which is the one with the lower number. So once the
/// contacts of the discs up to i are known as first ones, no later contact looks at these discs,
/// and they can move. Threads take a part of the discs each; the few blocks of contacts between
/// discs of two parts come first. Every row and every sum is the same, bit for bit, as when all
/// contacts come before all discs, and does not depend on the parts (if the compiler fuses no
/// multiplications and additions: `-ffp-contract=off`).
///
/// A bond must not break meanwhile: discs would have moved under its force. `Assembly` sweeps only
/// when all are sure to hold.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <hfdem/base/parallel.hpp>
#include <hfdem/mechanics/contact_range.hpp>
#include <hfdem/mechanics/force_rows.hpp>
#include <hfdem/mechanics/tally.hpp>
#include <hfdem/state/discs.hpp>

namespace hfdem {

/// In which order contacts and discs of a specimen take their turns.
class Sweep {
 public:
  Sweep() = default;
  /// @param discs without the platens
  /// @param contacts between them, sorted by first disc; four to a block
  Sweep(std::size_t discs, std::span<const ContactGeometry> contacts)
      : discs_(discs), last_in_block_((contacts.size() + pack_width - 1) / pack_width, 0) {
    first_contact_.assign(discs + 1, 0);
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      const Pair bodies = contacts[c].bodies;
      ++first_contact_[bodies.first + 1];
      Index& last = last_in_block_[c / pack_width];
      last = std::max(last, bodies.second);
    }
    for (std::size_t i = 0; i < discs; ++i) first_contact_[i + 1] += first_contact_[i];
  }

  /// Finds the forces in all contacts of the rock and moves all discs by one time step. The rows of
  /// other contacts must be there already.
  /// @param rock whose bonds all hold
  /// @param discs that move
  /// @param forces of all contacts
  /// @param motion a `DiscMotion`
  /// @param threads that share the discs; the result does not depend on it
  template <class Law, class Motion>
  Moved step(ContactRange<Law>& rock, Discs& discs, ForceRows& forces, const Motion& motion,
             int threads) {
    share_out(threads);
    const ContactBlocks<Law> all = rock.blocks(discs.displacement, forces.rows());
    for_chunks(between_.size() - 1, 64, threads,
               [&](std::size_t, std::size_t begin, std::size_t end) {
                 for (std::size_t k = begin; k < end; ++k) all.evaluate(between_[k]);
               });
    for_parts(parts_.size(), [&](std::size_t k) {
      const Part part = parts_[k];
      const ContactBlocks<Law> contacts = all;
      MotionTally tally;
      const Index* skipped = &between_[part.first_between];
      Index block = blocks_before(part.begin);
      for (std::size_t i = part.begin; i < part.end; i += group) {
        const std::size_t end = std::min(i + group, part.end);
        for (const Index known = blocks_before(end); block < known; ++block) {
          if (block == *skipped)
            ++skipped;
          else
            contacts.evaluate(block);
        }
        motion.move(i, end, discs, forces, tally);
      }
      tallies_[k] = tally;
    });
    return motion.moved(tallies_);
  }

 private:
  /// Discs that move together, once the contacts of all of them are known.
  static constexpr std::size_t group = 32;

  /// So many discs take longer than it takes to wake another thread.
  static constexpr std::size_t worth_a_thread = 1024;

  struct Part {
    std::size_t begin = 0, end = 0;  // discs
    std::size_t first_between = 0;   // of their blocks: place in `between_`
  };

  /// How many blocks hold the contacts whose first disc is below `disc`.
  Index blocks_before(std::size_t disc) const {
    return (first_contact_[disc] + Index{pack_width - 1}) / Index{pack_width};
  }

  void share_out(int threads) {
    const auto count = std::clamp<std::size_t>(discs_ / worth_a_thread, 1,
                                               static_cast<std::size_t>(std::max(1, threads)));
    if (parts_.size() == count) return;
    const auto begin = [&](std::size_t part) {
      return part == count ? discs_ : discs_ * part / count / group * group;
    };
    parts_.assign(count, {});
    tallies_.assign(count, {});
    between_.clear();
    for (std::size_t k = 0; k < count; ++k) {
      Part& part = parts_[k];
      part.begin = begin(k);
      part.end = begin(k + 1);
      part.first_between = between_.size();
      for (Index b = blocks_before(part.begin); b < blocks_before(part.end); ++b)
        if (last_in_block_[b] >= part.end) between_.push_back(b);
    }
    between_.push_back(std::numeric_limits<Index>::max());
  }

  std::size_t discs_ = 0;
  std::vector<Index> first_contact_;  // of each disc as the first one, and the end
  std::vector<Index> last_in_block_;  // the last disc that a block of contacts looks at
  std::vector<Part> parts_;
  std::vector<Index> between_;  // blocks that look at discs of several parts; an end no block has
  std::vector<MotionTally> tallies_;
};

}  // namespace hfdem
