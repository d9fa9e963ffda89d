/// @file
/// A specimen before it is bonded: discs in a box, and how far apart two of them may be to bond.
#pragma once

#include <array>
#include <tuple>
#include <vector>

#include <hfdem/base/fields.hpp>
#include <hfdem/base/vec2.hpp>
#include <hfdem/state/contact.hpp>

namespace hfdem {

/// The four sides of the box, in this order everywhere.
enum class Side { left, right, bottom, top };
/// All of them, for loops.
inline constexpr std::array<Side, 4> all_sides{Side::left, Side::right, Side::bottom, Side::top};

/// Unit normal of a side, pointing out of the specimen.
constexpr Vec2 outward(Side side) {
  switch (side) {
    case Side::left:
      return {-1, 0};
    case Side::right:
      return {1, 0};
    case Side::bottom:
      return {0, -1};
    case Side::top:
      break;
  }
  return {0, 1};
}
/// Whether a side's normal is along x.
constexpr bool is_vertical(Side side) { return side == Side::left || side == Side::right; }

/// In-situ principal stresses along the axes, Pa, compression positive.
struct Stress {
  double xx = 10e6, yy = 12e6;

  static constexpr auto fields() {
    return std::tuple{Field{"xx", &Stress::xx, "Pa", non_negative, "in-situ stress along x"},
                      Field{"yy", &Stress::yy, "Pa", non_negative, "in-situ stress along y"}};
  }
};

/// A natural fracture of the rock: a straight segment.
struct NaturalFracture {
  Vec2 from, to;  ///< its ends, m

  double length() const { return norm(to - from); }                ///< m
  Vec2 direction() const { return (1 / length()) * (to - from); }  ///< unit vector from end to end
  Vec2 normal() const { return left_of(direction()); }             ///< unit vector across it
};

/// Two discs with a natural fracture between their centres: if they bond, or meet later, they do so
/// through a joint along the fracture.
struct JointPair {
  Pair bodies;     ///< first < second
  Index fracture;  ///< number of the fracture
  double along;    ///< where the line between the centres crosses it, m from its end `from`
  Vec2 normal;     ///< unit vector across the fracture, from the first disc's side to the second's
};

/// Natural fractures, and the pairs of discs that they part (setup/joints.hpp finds them).
struct JointSet {
  std::vector<NaturalFracture> fractures{};  ///< in their order of input
  std::vector<JointPair> pairs{};            ///< each two discs once, bonded or only near; sorted

  /// All of it.
  void exchange(auto& archive) { archive(fractures, pairs); }
};

/// Discs in a box whose lower left corner is the origin.
struct Specimen {
  double width = 0, height = 0;  ///< of the box, m
  double density = 0;            ///< of the discs, kg/m3
  std::vector<Vec2> centre{};    ///< m, one per disc
  std::vector<double> radius{};  ///< m, one per disc
  /// Discs bond to each other, and touch a platen, where the gap is at most this, m. The gap that
  /// they have then becomes the reference from which opening is measured.
  double bonding_gap = 0;
  /// Known neighbours, for the search `FixedPairs`; other searches do not need them.
  std::vector<Pair> pairs{};
  /// The number that each disc had before the specimen was renumbered, for outputs; empty if it was
  /// not.
  std::vector<Index> input_index{};
  /// Natural fractures, if there are any.
  JointSet joints{};

  std::size_t size() const { return centre.size(); }  ///< number of discs

  /// All of it.
  void exchange(auto& archive) {
    archive(width, height, density, centre, radius, bonding_gap, pairs, input_index, joints);
  }

  /// Distance between two discs' surfaces, m; negative where they overlap.
  double gap(Pair p) const {
    return norm(centre[p.second] - centre[p.first]) - radius[p.first] - radius[p.second];
  }
  /// Distance from a disc's surface to a side of the box, m.
  double gap(Index disc, Side side) const {
    const Vec2 out = outward(side), corner{width, height};
    return (side == Side::right || side == Side::top ? dot(corner, out) : 0.0) -
           dot(centre[disc], out) - radius[disc];
  }
  /// Whether a disc touches the platen of a side.
  bool touches(Index disc, Side side) const { return gap(disc, side) <= bonding_gap; }
};

}  // namespace hfdem
