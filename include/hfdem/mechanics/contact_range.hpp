/// @file
/// The contact loop: one law over its own range of contacts.
///
/// Contacts are evaluated four at a time. Each writes one force row to its own place, so there are
/// no write conflicts and the result does not depend on the number of threads; the bodies gather
/// their rows afterwards (see motion.hpp). Bonds over strength are only noted in the loop; a cold
/// pass looks at the few blocks concerned.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <hfdem/base/pack.hpp>
#include <hfdem/base/parallel.hpp>
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
        suspect_((bodies_.size() + grain - 1) / grain, 0) {
    for (std::size_t c = 0; c < size_; ++c) {
      bodies_[c / pack_width].first[c % pack_width] = geometry[c].bodies.first;
      bodies_[c / pack_width].second[c % pack_width] = geometry[c].bodies.second;
      frame_.set(c, geometry[c].frame);
      stiffness_.set(c, stiffness[c]);
    }
  }

  const Law& law() const { return law_; }               ///< with its parameters
  std::size_t size() const { return size_; }            ///< number of contacts
  std::size_t first_row() const { return first_row_; }  ///< of contact 0
  /// Number of force rows, unused ones at the end included.
  std::size_t padded_size() const { return bodies_.size() * pack_width; }

  /// The two bodies of contact c.
  Pair bodies(std::size_t c) const {
    const Bodies& b = bodies_[c / pack_width];
    return {b.first[c % pack_width], b.second[c % pack_width]};
  }
  Frame<double> frame(std::size_t c) const { return frame_[c]; }      ///< normal and arms
  Stiffness stiffness(std::size_t c) const { return stiffness_[c]; }  ///< at present
  Memory memory(std::size_t c) const { return memory_[c]; }           ///< at present

  /// The present relative motion of one contact.
  Motion<double> motion(std::size_t c, std::span<const Pack> displacement) const {
    const auto [first, second] = bodies(c);
    const Pack d = displacement[second] + flipped(displacement[first]);
    return frame_[c].motion(d[0], d[1], d[2], d[3]);
  }
  /// The present response of one contact; changes nothing.
  auto response(std::size_t c, std::span<const Pack> displacement) const {
    return law_.respond(stiffness_[c], memory_[c], motion(c, displacement));
  }

  /// Evaluates every contact at the given displacements and writes the force rows.
  void evaluate(std::span<const Pack> displacement, std::span<Pack> force, int threads) {
    for_chunks(bodies_.size(), grain, threads,
               [&](std::size_t chunk, std::size_t begin, std::size_t end) {
                 PackMask over_strength{};
                 for (std::size_t b = begin; b < end; ++b)
                   over_strength |= evaluate_block(b, displacement.data(), force.data());
                 suspect_[chunk] = any(over_strength);
               });
  }

  /// Breaks every bond that `evaluate` found over its strength, calling `note(contact, mode)` in
  /// the order of the contacts, and rewrites their force rows.
  template <class Note>
  void break_bonds(std::span<const Pack> displacement, std::span<Pack> force,
                   Note&& note) requires BreakableLaw<Law> {
    for (std::size_t chunk = 0; chunk < suspect_.size(); ++chunk) {
      if (suspect_[chunk] == 0) continue;
      const std::size_t end = std::min(bodies_.size(), (chunk + 1) * grain);
      for (std::size_t b = chunk * grain; b < end; ++b) {
        const auto failure = block_failure(b, displacement.data());
        const PackMask failed = failure.tension | failure.shear;
        if (!any(failed)) continue;
        for (std::size_t lane = 0; lane < pack_width; ++lane) {
          if (failed[lane] == 0) continue;
          const std::size_t c = b * pack_width + lane;
          break_bond(c);
          note(static_cast<Index>(c), failure.tension[lane] != 0 ? Mode::tension : Mode::shear);
        }
        evaluate_block(b, displacement.data(), force.data());
      }
      suspect_[chunk] = 0;
    }
  }

  /// Leaves contact c with what its law has without a bond.
  void break_bond(std::size_t c) requires BreakableLaw<Law> {
    stiffness_.set(c, law_.broken(stiffness_[c]));
  }

  /// Replaces what is otherwise fixed of contact c.
  void set_stiffness(std::size_t c, const Stiffness& k) { stiffness_.set(c, k); }

  /// What is left of the bonds, and what the contacts remember.
  void exchange(auto& archive) {
    if constexpr (BreakableLaw<Law>) archive(stiffness_);
    archive(memory_);
  }

 private:
  struct Bodies {
    std::array<Index, pack_width> first{}, second{};
  };
  /// Blocks that one thread takes at a time, and that the cold pass looks at together.
  static constexpr std::size_t grain = 64;

  static std::size_t block_count(std::size_t size) { return (size + pack_width - 1) / pack_width; }

  Motion<Pack> block_motion(std::size_t block, const Pack* displacement) const {
    const auto& [first, second] = bodies_[block];
    Pack a = displacement[second[0]] + flipped(displacement[first[0]]);
    Pack b = displacement[second[1]] + flipped(displacement[first[1]]);
    Pack c = displacement[second[2]] + flipped(displacement[first[2]]);
    Pack d = displacement[second[3]] + flipped(displacement[first[3]]);
    transpose(a, b, c, d);
    return frame_.block(block).motion(a, b, c, d);
  }

  /// Inlined even where little is: a function that returns a pack has no portable way to.
  [[gnu::always_inline]] PackMask evaluate_block(std::size_t b, const Pack* displacement,
                                                 Pack* force) {
    const auto& k = stiffness_.block(b);
    const auto response = law_.respond(k, memory_.block(b), block_motion(b, displacement));
    if (memory_.differs(b, response.memory)) memory_.block(b) = response.memory;
    Pack* row = force + first_row_ + b * pack_width;
    Pack r0, r1, r2, r3;
    frame_.block(b).force(response.reaction(), r0, r1, r2, r3);
    transpose(r0, r1, r2, r3);
    row[0] = r0;
    row[1] = r1;
    row[2] = r2;
    row[3] = r3;
    if constexpr (BreakableLaw<Law>) {
      const auto failure = law_.failure(k, response);
      return failure.tension | failure.shear;
    } else {
      return PackMask{};
    }
  }

  auto block_failure(std::size_t b, const Pack* displacement) const {
    const auto& k = stiffness_.block(b);
    return law_.failure(k, law_.respond(k, memory_.block(b), block_motion(b, displacement)));
  }

  Law law_;
  std::size_t size_, first_row_;
  std::vector<Bodies> bodies_;
  PackedColumn<Frame> frame_;
  PackedColumn<Law::template Stiffness> stiffness_;
  PackedColumn<Law::template Memory> memory_;
  std::vector<char> suspect_;
};

}  // namespace hfdem
