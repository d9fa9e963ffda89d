/// @file
/// The innermost work: the contacts of one law, four to a block, at given displacements.
#pragma once

#include <array>

#include <hfdem/base/pack.hpp>
#include <hfdem/base/row_place.hpp>
#include <hfdem/state/contact.hpp>

namespace hfdem {

/// The bodies of four contacts, as places of their rows.
struct BodiesOfBlock {
  std::array<Index, pack_width> first{}, second{};  ///< in `RowPlace`s
};

/// A loop's view of contacts: pointers that a compiler keeps in registers, as it cannot do with the
/// members of what is written to meanwhile.
template <class Law>
struct ContactBlocks {
  Law law;                      ///< a copy, for the same reason
  const BodiesOfBlock* bodies;  ///< one per block, as are the next three
  const Frame<Pack>* frame;     ///< fixed
  const typename Law::template Stiffness<Pack>* stiffness;  ///< at present
  typename Law::template Memory<Pack>* memory;              ///< at present
  const Pack* displacement;                                 ///< one row per body
  Pack* force;                                              ///< one row per contact

  /// The relative motion of four contacts.
  [[gnu::always_inline]] Motion<Pack> motion(std::size_t block) const {
    const auto& [first, second] = bodies[block];
    Pack a = difference(first[0], second[0]), b = difference(first[1], second[1]);
    Pack c = difference(first[2], second[2]), d = difference(first[3], second[3]);
    transpose(a, b, c, d);
    return frame[block].motion(a, b, c, d);
  }

  /// What they answer; changes nothing.
  [[gnu::always_inline]] auto response(std::size_t block) const {
    return law.respond(stiffness[block], memory[block], motion(block));
  }

  /// Writes their force rows and what they remember.
  /// @returns what they answer
  [[gnu::always_inline]] auto evaluate(std::size_t block) const {
    const auto answer = response(block);
    if (differ(memory[block], answer.memory)) memory[block] = answer.memory;
    Pack r0, r1, r2, r3;
    frame[block].force(answer.reaction(), r0, r1, r2, r3);
    transpose(r0, r1, r2, r3);
    Pack* row = force + block * pack_width;
    row[0] = r0;
    row[1] = r1;
    row[2] = r2;
    row[3] = r3;
    return answer;
  }

 private:
  [[gnu::always_inline]] Pack difference(Index first, Index second) const {
    return difference_row(RowPlace::at(displacement, first), RowPlace::at(displacement, second));
  }
};

}  // namespace hfdem
