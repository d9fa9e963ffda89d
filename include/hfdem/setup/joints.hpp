/// @file
/// Natural fractures put into a specimen: which pairs of discs they part, and which fractures are
/// refused.
///
/// A pair of discs belongs to a fracture that passes between their centres, as in the smooth-joint
/// model (D. Mas Ivars et al., "The synthetic rock mass approach for jointed rock mass modelling",
/// Int. J. Rock Mech. Min. Sci. 48 (2011), 219-244).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/fields.hpp>
#include <hfdem/base/side_of_line.hpp>
#include <hfdem/neighbours/cell_grid.hpp>
#include <hfdem/setup/fracture_geometry.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

namespace detail {

/// The place that a message names; fractures without names are counted from 0.
inline std::string name_of_fracture(std::size_t k, std::span<const std::string> names) {
  return k < names.size() ? names[k] : std::string("fracture ") + std::to_string(k);
}

inline std::string point_in_words(Vec2 p) {
  return std::string("(") + to_text(p.x) + ", " + to_text(p.y) + ") m";
}

[[noreturn]] inline void refuse_fracture(const std::string& name, const NaturalFracture& f,
                                         const std::string& why) {
  throw InvalidParameter(name + ": from " + point_in_words(f.from) + " to " + point_in_words(f.to) +
                         " is not allowed: " + why);
}

/// The same segment from its lower end up, or from left to right: what lies on its left side does
/// not depend on which end was given first.
inline NaturalFracture upwards(const NaturalFracture& f) {
  const bool up = f.from.y < f.to.y || (f.from.y == f.to.y && f.from.x < f.to.x);
  return up ? f : NaturalFracture{f.to, f.from};
}

/// Where the line between two centres crosses a fracture.
struct Crossing {
  JointPair pair;
  double off_contact;  ///< distance from the middle of the discs' gap, m
};

/// A centre exactly on the fracture's line counts to its left side, as seen upwards; a line that
/// just touches an end of the fracture crosses it.
inline std::optional<Crossing> crossing(const Specimen& s, Pair p, const NaturalFracture& fracture,
                                        Index number) {
  const Vec2 a = s.centre[p.first], b = s.centre[p.second];
  const NaturalFracture f = upwards(fracture);
  const bool left_a = side_of_line(f.from, f.to, a) >= 0;
  const bool left_b = side_of_line(f.from, f.to, b) >= 0;
  if (left_a == left_b) return {};
  if (side_of_line(a, b, f.from) * side_of_line(a, b, f.to) > 0) return {};

  const Vec2 normal = f.normal();
  const double from_a = std::abs(dot(a - f.from, normal)),
               from_b = std::abs(dot(b - f.from, normal));
  const double share = from_a + from_b > 0 ? from_a / (from_a + from_b) : 0.5;
  const Vec2 point = a + share * (b - a);
  const double distance = norm(b - a);
  const double contact = (distance + s.radius[p.first] - s.radius[p.second]) / 2;
  const double along = dot(point - fracture.from, fracture.direction());
  return Crossing{.pair = {.bodies = p,
                           .fracture = number,
                           .along = std::clamp(along, 0.0, fracture.length()),
                           .normal = left_a ? -normal : normal},
                  .off_contact = std::abs(share * distance - contact)};
}

}  // namespace detail

/// Checks that fractures can be put into a box whose lower left corner is the origin. Their ends
/// may lie on its rim.
/// @param fractures to check
/// @param width of the box, m
/// @param height of the box, m
/// @param names where each fracture comes from, for messages; if empty, "fracture 0" and so on
/// @throws InvalidParameter naming a fracture that is no finite segment, leaves the box or is given
///   twice
inline void check_fractures(std::span<const NaturalFracture> fractures, double width, double height,
                            std::span<const std::string> names = {}) {
  const Range in_x{0, width}, in_y{0, height};
  std::map<std::array<double, 4>, std::size_t> known;
  for (std::size_t k = 0; k < fractures.size(); ++k) {
    const NaturalFracture f = fractures[k], up = detail::upwards(f);
    const auto wrong = [&](const std::string& why) {
      detail::refuse_fracture(detail::name_of_fracture(k, names), f, why);
    };
    if (!std::isfinite(f.from.x + f.from.y + f.to.x + f.to.y))
      wrong("its ends must be finite numbers");
    for (const Vec2 end : {f.from, f.to})
      if (!in_x.contains(end.x) || !in_y.contains(end.y))
        wrong("in this specimen x must be " + to_text(in_x, "m") + ", y " + to_text(in_y, "m"));
    if (!(f.length() > 0)) wrong("its length must be greater than 0 m");
    const auto [same, is_new] = known.try_emplace({up.from.x, up.from.y, up.to.x, up.to.y}, k);
    if (!is_new)
      wrong("it must differ from " + detail::name_of_fracture(same->second, names) +
            ", which has the same ends");
  }
}

/// Checks that no fracture meets the injection or the preset crack at it.
/// @param fractures to check
/// @param injection its position, m
/// @param crack the preset crack; its ends may coincide
/// @param clearance the least distance, m
/// @param names where each fracture comes from, for messages; if empty, "fracture 0" and so on
/// @throws InvalidParameter naming a fracture that crosses or comes nearer than the clearance
inline void keep_clear(std::span<const NaturalFracture> fractures, Vec2 injection,
                       const NaturalFracture& crack, double clearance,
                       std::span<const std::string> names = {}) {
  detail::check_range("fractures", "clearance", "m", non_negative, clearance);
  for (std::size_t k = 0; k < fractures.size(); ++k) {
    const double away = std::fmin(distance(fractures[k], injection), distance(fractures[k], crack));
    if (away > 0 && away >= clearance) continue;
    detail::refuse_fracture(detail::name_of_fracture(k, names), fractures[k],
                            (away > 0 ? "it comes within " + in_words(away) + " m of the injection"
                                      : std::string("it crosses the injection")) +
                                " at " + detail::point_in_words(injection) +
                                " with its crack from " + detail::point_in_words(crack.from) +
                                " to " + detail::point_in_words(crack.to) +
                                "; it must stay at least " + to_text(clearance) + " m away");
  }
}

namespace detail {

/// A disc that would hang on its own side by one bond or none changes sides: the fracture passes on
/// its other side. Once that bond broke, joints alone would hold it, which cannot turn back what
/// pushes it along them, and it would wander.
/// @param s gives the centres
/// @param fractures that part the pairs
/// @param bonds all pairs that bond
/// @param across pairs with a fracture between them, sorted; changed to what holds then
inline void change_sides(const Specimen& s, std::span<const NaturalFracture> fractures,
                         std::span<const Pair> bonds, std::vector<JointPair>& across) {
  std::vector<std::vector<Pair>> bonds_of(s.size());
  for (const Pair& p : bonds) bonds_of[p.first].push_back(p), bonds_of[p.second].push_back(p);
  const auto joint_of = [&](const Pair& p) {
    const auto at = std::ranges::lower_bound(across, p, {}, &JointPair::bodies);
    return at != across.end() && at->bodies == p ? &*at : nullptr;
  };
  for (Index disc = 0; disc < s.size(); ++disc) {
    std::vector<Pair> own;
    const JointPair* joint = nullptr;
    for (const Pair& p : bonds_of[disc])
      if (const JointPair* j = joint_of(p))
        joint = j;
      else
        own.push_back(p);
    if (joint == nullptr || own.size() > 1 || bonds_of[disc].size() <= 2 * own.size()) continue;
    const NaturalFracture& f = fractures[joint->fracture];
    std::vector<JointPair> added;
    for (const Pair& p : own) {
      const double along =
          dot(0.5 * (s.centre[p.first] + s.centre[p.second]) - f.from, f.direction());
      // Across from where the disc is now.
      const bool same_end = (p.first == disc) == (joint->bodies.first == disc);
      if (along > 0 && along < f.length())
        added.push_back({p, joint->fracture, along, same_end ? -joint->normal : joint->normal});
    }
    std::erase_if(across, [&](const JointPair& j) {
      return j.bodies.first == disc || j.bodies.second == disc;
    });
    across.insert(across.end(), added.begin(), added.end());
    std::ranges::sort(across, {}, &JointPair::bodies);
  }
}

}  // namespace detail

/// Puts natural fractures into a specimen, instead of those that it had: finds the pairs of discs
/// that they part. A pair that two fractures part belongs to the one that passes nearer to the
/// middle of its gap; if they pass equally near, to the first. A disc that hardly anything
/// else would hold changes sides.
/// @param specimen gets the fractures and the pairs
/// @param fractures in the order of their numbers
/// @param reach largest gap of a pair, m; by default the mean radius
/// @throws InvalidParameter if `check_fractures` refuses, or if the reach is less than the gap up
///   to which discs bond
inline void insert_joints(Specimen& specimen, std::vector<NaturalFracture> fractures,
                          std::optional<double> reach = {}) {
  check_fractures(fractures, specimen.width, specimen.height);
  if (!reach)
    reach = std::accumulate(specimen.radius.begin(), specimen.radius.end(), 0.0) /
            std::fmax(1, static_cast<double>(specimen.size()));
  detail::check_range("joints", "reach", "m", Range{specimen.bonding_gap}, *reach);

  const FractureTree tree(fractures);
  std::vector<JointPair> pairs;
  std::vector<Pair> bonds;
  std::vector<Index> near;
  CellGrid(specimen, *reach).for_each_pair([&](Pair p) {
    const Vec2 a = specimen.centre[p.first], b = specimen.centre[p.second];
    const double rounding = 1e-9 * norm(b - a);
    std::optional<detail::Crossing> best;
    tree.near(a, b, 0, near);
    for (const Index k : near) {
      const auto next = detail::crossing(specimen, p, fractures[k], k);
      if (next && (!best || next->off_contact < best->off_contact - rounding)) best = next;
    }
    if (best) pairs.push_back(best->pair);
    if (specimen.gap(p) <= specimen.bonding_gap) bonds.push_back(p);
  });
  detail::change_sides(specimen, fractures, bonds, pairs);
  specimen.joints = {std::move(fractures), std::move(pairs)};
}

}  // namespace hfdem
