/// @file
/// The random specimen: discs of unequal size, packed so densely into a box that they hold each
/// other (the paper's rock, Section 3.1 and Table 2).
///
/// Discs start at random points, one in each cell of a grid, and push each other and the walls away
/// until their forces balance. They still overlap then, by 4.5 % of their radius on average; the
/// specimen is free of stress all the same, as forces are measured from where the discs bonded.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/fields.hpp>
#include <hfdem/base/random.hpp>
#include <hfdem/setup/floaters.hpp>
#include <hfdem/setup/packing_relaxation.hpp>
#include <hfdem/setup/space_filling_curve.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// The default is the paper's: 1 m by 1 m of discs with radii of 3 to 5 mm; about 17,500 of them.
struct RandomPacking {
  double width = 1;
  double height = 1;
  std::optional<int> grains{};  ///< takes the place of `porosity`
  double porosity = 0.1;
  double radius_min = 3e-3;
  double radius_max = 5e-3;
  double density = 3169;
  double bonding_gap = 0.02;
  int seed = 1;

  /// Less of it overlaps too much; with more of it the discs do not hold each other.
  static constexpr Range possible_porosity{0.02, 0.14};
  static constexpr int most_grains = 10'000'000;  ///< in one specimen

  static constexpr auto fields() {
    using P = RandomPacking;
    return std::tuple{
        Field{"width", &P::width, "m", positive, "of the specimen"},
        Field{"height", &P::height, "m", positive, "of the specimen"},
        Field{"grains", &P::grains, "", Range{1, most_grains},
              "exact number of discs, instead of a porosity"},
        Field{"porosity", &P::porosity, "", possible_porosity,
              "part of the area that the discs, overlaps counted twice, leave free"},
        Field{"radius_min", &P::radius_min, "m", positive, "radii are uniform from this on"},
        Field{"radius_max", &P::radius_max, "m", positive, "radii are uniform up to this"},
        Field{"density", &P::density, "kg/m3", positive, "density of the discs"},
        Field{"bonding_gap", &P::bonding_gap, "", Range{0, 1},
              "gap up to which two discs bond, over the mean radius"},
        Field{"seed", &P::seed, "", Range{0}, "of the random numbers; every seed is another rock"}};
  }
};

namespace detail {

/// Mean area of a disc whose radius is uniform, m2.
inline double mean_disc_area(const RandomPacking& p) {
  const double low = p.radius_min, high = p.radius_max;
  return std::numbers::pi * (low * low + low * high + high * high) / 3;
}

/// @throws InvalidParameter if a field is outside its range, or does not fit the others
inline void validate_packing(const RandomPacking& p) {
  validate(p, "specimen");
  if (p.radius_min > p.radius_max)
    refuse("specimen", "radius_min", to_text(p.radius_min) + " m",
           "at most radius_max, which is " + to_text(p.radius_max) + " m");
  const double side = std::fmin(p.width, p.height);
  if (p.radius_max > side / 4)
    refuse("specimen", "radius_max", to_text(p.radius_max) + " m",
           "at most " + to_text(side / 4) +
               " m, a quarter of the specimen's smaller side, for two discs to lie side by side");
  const double room = p.width * p.height / mean_disc_area(p);
  if (p.grains) {
    const Range possible{std::ceil((1 - RandomPacking::possible_porosity.high) * room),
                         std::floor((1 - RandomPacking::possible_porosity.low) * room)};
    if (!possible.contains(*p.grains))
      refuse("specimen", "grains", std::to_string(*p.grains),
             to_text(possible, "") + " in this box, for a porosity " +
                 to_text(RandomPacking::possible_porosity, ""));
  } else if (room > RandomPacking::most_grains) {
    refuse("specimen", "width", to_text(p.width) + " m",
           "at most " + in_words(p.width * RandomPacking::most_grains / room) +
               " m: more than 10,000,000 discs of this size would fit");
  }
}

/// As many radii as asked for, or as come nearest to the porosity.
inline std::vector<double> random_radii(const RandomPacking& p, Random& random) {
  std::vector<double> radii;
  const auto draw = [&] { return random.between(p.radius_min, p.radius_max); };
  if (p.grains) {
    for (int k = 0; k < *p.grains; ++k) radii.push_back(draw());
    return radii;
  }
  double to_fill = (1 - p.porosity) * p.width * p.height;
  while (true) {
    const double radius = draw(), area = std::numbers::pi * radius * radius;
    if (to_fill < area / 2) return radii;
    to_fill -= area;
    radii.push_back(radius);
  }
}

/// Random points, each in its own cell of a grid, so that no part of the box is crowded.
inline std::vector<Vec2> random_points(std::size_t count, double width, double height,
                                       Random& random) {
  const auto columns =
      static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count) * width / height)));
  const std::size_t rows = (count + columns - 1) / columns;
  const double cell_width = width / static_cast<double>(columns);
  const double cell_height = height / static_cast<double>(rows);
  std::vector<std::size_t> cell(columns * rows);
  std::iota(cell.begin(), cell.end(), std::size_t{0});
  std::vector<Vec2> points;
  for (std::size_t k = 0; k < count; ++k) {
    const auto left = static_cast<double>(cell.size() - k);
    std::swap(cell[k], cell[k + static_cast<std::size_t>(random.between(0, left))]);
    const auto column = static_cast<double>(cell[k] % columns);
    const auto row = static_cast<double>(cell[k] / columns);
    points.push_back(
        {(column + random.fraction()) * cell_width, (row + random.fraction()) * cell_height});
  }
  return points;
}

/// Brings the discs to equilibrium, again and again until none floats.
inline void relax_without_floaters(Specimen& s, double mean_radius, int threads) {
  constexpr double tolerance = 1e-3;  // of the mean contact force
  constexpr int most_cures = 50, most_exchanges = 10;
  PackingRelaxation relaxation(s, threads);
  relaxation.run(tolerance);
  for (int k = 0; k < most_cures; ++k) {
    const double push = 5e-3 * (k % 4) * mean_radius;  // another one if the last did not help
    const auto floaters =
        k < most_exchanges ? exchange_radii_of_floaters(s, push) : grow_floaters(s, push);
    if (floaters == 0) return;
    relaxation.run(tolerance);
  }
  throw RunStopped(
      "the random packing keeps discs that touch fewer than three others, whatever radii they are "
      "given: another seed or a lower porosity may do");
}

}  // namespace detail

/// Packs the specimen, its lower left corner at the origin; numbered along a space-filling curve.
/// The same parameters give the same bits, for any number of threads.
/// @param p what to pack
/// @param threads to use
/// @throws InvalidParameter if a field is outside its range, or does not fit the others
/// @throws RunStopped if the discs find no equilibrium, or some of them nothing to hold them
inline Specimen random_packing(const RandomPacking& p, int threads = 1) {
  detail::validate_packing(p);
  Random random(static_cast<std::uint64_t>(p.seed));
  Specimen s{.width = p.width, .height = p.height, .density = p.density};
  s.radius = detail::random_radii(p, random);
  s.centre = detail::random_points(s.radius.size(), p.width, p.height, random);
  const double mean_radius =
      std::accumulate(s.radius.begin(), s.radius.end(), 0.0) / static_cast<double>(s.radius.size());
  s.bonding_gap = p.bonding_gap * mean_radius;
  s = renumbered(s, order_along_curve(s));

  detail::relax_without_floaters(s, mean_radius, threads);
  s = renumbered(s, order_along_curve(s));
  s.input_index.clear();  // drawn, not given
  return s;
}

}  // namespace hfdem
