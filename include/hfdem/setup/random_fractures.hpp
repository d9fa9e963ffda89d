/// @file
/// Random natural fractures, placed one after the other where there is room (random sequential
/// addition).
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <hfdem/base/fields.hpp>
#include <hfdem/base/random.hpp>
#include <hfdem/setup/fracture_geometry.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// The default is a set like that of the paper's Fig. 3, which is drawn there but not listed; in
/// 1 m by 1 m it gives, rounded to mm, examples/data/fractures.csv.
struct RandomFractures {
  int count = 18;
  double shortest = 0.15;
  double longest = 0.25;
  double angle = 45;
  double angle_spread = 15;
  bool conjugate = true;
  double spacing = 0.03;
  double margin = 0.02;
  double clearance = 0.06;
  int seed = 252;

  static constexpr auto fields() {
    using P = RandomFractures;
    return std::tuple{
        Field{"count", &P::count, "", Range{1, 100'000}, "number of natural fractures"},
        Field{"shortest", &P::shortest, "m", positive, "lengths are uniform from this on"},
        Field{"longest", &P::longest, "m", positive, "lengths are uniform up to this"},
        Field{"angle", &P::angle, "deg", Range{0, 180}, "mean angle of a family from the x axis"},
        Field{"angle_spread", &P::angle_spread, "deg", Range{0, 90},
              "angles are uniform within this of their mean"},
        Field{"conjugate", &P::conjugate, "", any_number,
              "a second family, the first in a vertical mirror: every other fracture is of it"},
        Field{"spacing", &P::spacing, "m", non_negative, "least distance between two fractures"},
        Field{"margin", &P::margin, "m", non_negative, "least distance from the rim"},
        Field{"clearance", &P::clearance, "m", non_negative, "least distance from the injection"},
        Field{"seed", &P::seed, "", Range{0}, "of the random numbers; every seed is another set"}};
  }
};

namespace detail {

/// @throws InvalidParameter if a field is outside its range, or does not fit the others
inline void validate_fractures(const RandomFractures& p) {
  validate(p, "fractures");
  if (p.shortest > p.longest)
    refuse("fractures", "shortest", to_text(p.shortest) + " m",
           "at most longest, which is " + to_text(p.longest) + " m");
}

/// Why no more than so many fractures were placed.
[[noreturn]] inline void refuse_count(const RandomFractures& p, std::size_t placed, int tries) {
  const auto metres = [](double v) { return to_text(v) + " m"; };
  refuse("fractures", "count", std::to_string(p.count),
         "at most " + std::to_string(placed) + ": " + std::to_string(tries) +
             " random places for one more, of a length from " + metres(p.shortest) + " to " +
             metres(p.longest) + ", did not leave a spacing of " + metres(p.spacing) +
             ", a margin of " + metres(p.margin) + " and a clearance of " + metres(p.clearance));
}

}  // namespace detail

/// Draws natural fractures for a box whose lower left corner is the origin. Each has its length and
/// angle before it looks for a place, so crowding does not change their distributions.
/// @param p what to draw
/// @param width of the box, m
/// @param height of the box, m
/// @param injection its position, m; by default the middle of the box
/// @throws InvalidParameter if a field is outside its range, or so many fractures find no room
inline std::vector<NaturalFracture> random_fractures(const RandomFractures& p, double width,
                                                     double height,
                                                     std::optional<Vec2> injection = {}) {
  constexpr int most_tries = 10'000;
  detail::validate_fractures(p);
  const Vec2 clear_of = injection.value_or(Vec2{width / 2, height / 2});
  Random random(static_cast<std::uint64_t>(p.seed));
  std::vector<NaturalFracture> placed;
  FractureTree tree;
  std::vector<Index> near;

  const auto has_room = [&](const NaturalFracture& f) {
    for (const Vec2 end : {f.from, f.to})  // rounding must not push it out of the box
      if (!Range{0, width}.contains(end.x) || !Range{0, height}.contains(end.y)) return false;
    if (distance(f, clear_of) < p.clearance) return false;
    tree.near(f.from, f.to, p.spacing, near);
    for (const Index k : near)
      if (const double d = distance(placed[k], f); d == 0 || d < p.spacing) return false;
    return true;
  };
  while (placed.size() < static_cast<std::size_t>(p.count)) {
    const double length = random.between(p.shortest, p.longest);
    double angle = random.between(p.angle - p.angle_spread, p.angle + p.angle_spread);
    if (p.conjugate && placed.size() % 2 == 1) angle = 180 - angle;
    angle *= std::numbers::pi / 180;
    const Vec2 half = length / 2 * Vec2{std::cos(angle), std::sin(angle)};
    const double beside = std::abs(half.x) + p.margin, below = std::abs(half.y) + p.margin;
    std::optional<NaturalFracture> found;
    for (int k = 0; k < most_tries && !found && 2 * beside <= width && 2 * below <= height; ++k) {
      const double x = random.between(beside, width - beside);
      const Vec2 middle{x, random.between(below, height - below)};
      const NaturalFracture f{middle - half, middle + half};
      if (has_room(f)) found = f;
    }
    if (!found) detail::refuse_count(p, placed.size(), most_tries);
    placed.push_back(*found);
    tree.insert(*found);
  }
  return placed;
}

}  // namespace hfdem
