/// @file
/// The contact loop: one law over its own range of contacts.
///
/// Contacts are evaluated four at a time. Each writes one force row to its own place, so there are
/// no write conflicts and the result does not depend on the number of threads; the bodies gather
/// their rows afterwards (see motion.hpp). Bonds over strength are only noted in the loop; a cold
/// pass looks at the few blocks concerned.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <hfdem/base/pack.hpp>
#include <hfdem/base/parallel.hpp>
#include <hfdem/mechanics/contact_blocks.hpp>
#include <hfdem/mechanics/foresight.hpp>
#include <hfdem/state/contact.hpp>
#include <hfdem/state/law_concepts.hpp>

namespace hfdem {

/// The contacts of one law.
template <class Law>
class ContactRange {
 public:
  using Stiffness = typename Law::template Stiffness<double>;  ///< what is fixed per contact
  using Memory = typename Law::template Memory<double>;        ///< what evolves per contact

  /// @param law with its parameters; kept
  /// @param first_row index of this range's first force row; a multiple of `pack_width`
  /// @param geometry one per contact
  /// @param stiffness one per contact
  ContactRange(const Law& law, std::size_t first_row, std::span<const ContactGeometry> geometry,
               std::span<const Stiffness> stiffness)
      : law_(law),
        size_(geometry.size()),
        first_row_(first_row),
        bodies_(block_count(size_)),
        frame_(padded_size()),
        stiffness_(padded_size()),
        memory_(padded_size()),
        suspect_((bodies_.size() + grain - 1) / grain, 0),
        longest_arm_(longest_arm(geometry)),
        foresight_(suspect_.size(), rounding * longest_arm_) {
    for (std::size_t c = 0; c < size_; ++c) {
      bodies_[c / pack_width].first[c % pack_width] = RowPlace::of(geometry[c].bodies.first);
      bodies_[c / pack_width].second[c % pack_width] = RowPlace::of(geometry[c].bodies.second);
      frame_.set(c, geometry[c].frame);
      stiffness_.set(c, stiffness[c]);
    }
    // Places that no contact fills look at a disc that the last contact looks at, so that no block
    // looks at more discs than its contacts do.
    for (std::size_t c = size_; c < padded_size(); ++c)
      bodies_[c / pack_width].first[c % pack_width] =
          bodies_[c / pack_width].second[c % pack_width] =
              RowPlace::of(geometry.back().bodies.first);
  }

  const Law& law() const { return law_; }               ///< with its parameters
  std::size_t size() const { return size_; }            ///< number of contacts
  std::size_t first_row() const { return first_row_; }  ///< of contact 0
  /// Number of force rows, unused ones at the end included.
  std::size_t padded_size() const { return bodies_.size() * pack_width; }

  /// The two bodies of contact c.
  Pair bodies(std::size_t c) const {
    const auto& [first, second] = bodies_[c / pack_width];
    return {RowPlace::row(first[c % pack_width]), RowPlace::row(second[c % pack_width])};
  }
  Frame<double> frame(std::size_t c) const { return frame_[c]; }      ///< normal and arms
  Stiffness stiffness(std::size_t c) const { return stiffness_[c]; }  ///< at present
  Memory memory(std::size_t c) const { return memory_[c]; }           ///< at present

  /// The present relative motion of one contact.
  Motion<double> motion(std::size_t c, std::span<const Pack> displacement) const {
    const auto [first, second] = bodies(c);
    const Pack d = difference_row(displacement[first], displacement[second]);
    return frame_[c].motion(d[0], d[1], d[2], d[3]);
  }
  /// The present response of one contact; changes nothing.
  auto response(std::size_t c, std::span<const Pack> displacement) const {
    return law_.respond(stiffness_[c], memory_[c], motion(c, displacement));
  }

  // ---- the loop ---------------------------------------------------------------------------------

  /// All contacts, four to a block.
  /// @param displacement of the bodies, m and rad
  /// @param force rows that are written, of all laws
  ContactBlocks<Law> blocks(std::span<const Pack> displacement, std::span<Pack> force) {
    return {law_,
            bodies_.data(),
            frame_.blocks(),
            stiffness_.blocks(),
            memory_.blocks(),
            displacement.data(),
            force.data() + first_row_};
  }

  /// Evaluates every contact at the given displacements and writes the force rows.
  void evaluate(std::span<const Pack> displacement, std::span<Pack> force, int threads) {
    for_chunks(bodies_.size(), grain, threads,
               [&, all = blocks(displacement, force)](std::size_t chunk, std::size_t begin,
                                                      std::size_t end) {
                 const ContactBlocks<Law> contacts = all;
                 PackMask over_strength{};
                 for (std::size_t b = begin; b < end; ++b) {
                   const auto response = contacts.evaluate(b);
                   if constexpr (BreakableLaw<Law>)
                     over_strength |= over(contacts.law.failure(contacts.stiffness[b], response));
                 }
                 suspect_[chunk] = any(over_strength);
               });
  }

  /// Breaks every bond that `evaluate` found over its strength, calling `note(contact, mode)` in
  /// the order of the contacts, and rewrites their force rows.
  template <class Note>
  void break_bonds(std::span<const Pack> displacement, std::span<Pack> force,
                   Note&& note) requires BreakableLaw<Law> {
    const ContactBlocks<Law> contacts = blocks(displacement, force);
    for (std::size_t chunk = 0; chunk < suspect_.size(); ++chunk) {
      if (suspect_[chunk] == 0) continue;
      for (std::size_t b = chunk * grain; b < end_of(chunk); ++b) {
        const auto failure = law_.failure(contacts.stiffness[b], contacts.response(b));
        const PackMask failed = over(failure);
        if (!any(failed)) continue;
        for (std::size_t lane = 0; lane < pack_width; ++lane) {
          if (failed[lane] == 0) continue;
          const std::size_t c = b * pack_width + lane;
          break_bond(c);
          note(static_cast<Index>(c), failure.tension[lane] != 0 ? Mode::tension : Mode::shear);
        }
        contacts.evaluate(b);
      }
      suspect_[chunk] = 0;
    }
  }

  /// Whether no bond can fail at these displacements; asks the law where that is not sure and pays.
  bool all_hold(std::span<const Pack> displacement, int threads) requires ForeseesFailure<Law> {
    if (foresight_.sure()) return true;
    if (!foresight_.pays()) return false;
    const auto& unsure = foresight_.unsure();
    for_chunks(unsure.size(), 1, threads,
               [&, all = blocks(displacement, {})](std::size_t k, std::size_t, std::size_t) {
                 const ContactBlocks<Law> contacts = all;
                 Pack least = Pack{} + std::numeric_limits<double>::max();
                 for (std::size_t b = unsure[k] * grain; b < end_of(unsure[k]); ++b)
                   least =
                       min(least, contacts.law.margin(contacts.stiffness[b], contacts.response(b)));
                 foresight_.tell(unsure[k], min(min(least[0], least[1]), min(least[2], least[3])));
               });
    foresight_.count();
    return foresight_.sure();
  }
  /// From a disc's centre to its farthest contact point, m.
  double longest_arm() const { return longest_arm_; }
  /// Tells `all_hold` that no contact's motion has changed by more than this, m, in a step.
  void moved(double at_most) { foresight_.moved(at_most); }
  /// Tells it that discs have moved otherwise.
  void displaced() { foresight_.forget(); }

  // ---- other verbs ------------------------------------------------------------------------------

  /// Leaves contact c with what its law has without a bond.
  void break_bond(std::size_t c) requires BreakableLaw<Law> {
    set_stiffness(c, law_.broken(stiffness_[c]));
  }

  /// Replaces what is otherwise fixed of contact c.
  void set_stiffness(std::size_t c, const Stiffness& k) {
    stiffness_.set(c, k);
    foresight_.forget(c / pack_width / grain);
  }

  /// What is left of the bonds, and what the contacts remember.
  void exchange(auto& archive) {
    if constexpr (BreakableLaw<Law>) archive(stiffness_);
    archive(memory_);
    displaced();
  }

 private:
  /// Blocks that one thread takes at a time, and that the cold pass looks at together.
  static constexpr std::size_t grain = 64;

  /// Of an arm: motions smaller than this may be lost when displacements are rounded.
  static constexpr double rounding = 1e-9;

  static double longest_arm(std::span<const ContactGeometry> geometry) {
    double longest = 0;
    for (const auto& [bodies, f] : geometry)
      longest = std::fmax(longest, f.arm_mean + std::abs(f.arm_half_difference));
    return longest;
  }

  static std::size_t block_count(std::size_t size) { return (size + pack_width - 1) / pack_width; }

  std::size_t end_of(std::size_t chunk) const {
    return std::min(bodies_.size(), (chunk + 1) * grain);
  }
  static PackMask over(const Failure<Pack>& failure) { return failure.tension | failure.shear; }

  Law law_;
  std::size_t size_, first_row_;
  std::vector<BodiesOfBlock> bodies_;
  PackedColumn<Frame> frame_;
  PackedColumn<Law::template Stiffness> stiffness_;
  PackedColumn<Law::template Memory> memory_;
  std::vector<char> suspect_;
  double longest_arm_;
  Foresight foresight_;
};

}  // namespace hfdem
