/// @file
/// Specimens of any size for benchmarks: square arrays, and the paper's random rock, which is laid
/// side by side until there are enough discs.
#pragma once

#include <cmath>
#include <cstddef>
#include <map>

#include <hfdem/setup/random_packing.hpp>
#include <hfdem/setup/square_array.hpp>

/// So many copies of a specimen beside and above each other; discs at the seams touch.
inline hfdem::Specimen tiled(const hfdem::Specimen& tile, int columns, int rows) {
  hfdem::Specimen all{.width = columns * tile.width,
                      .height = rows * tile.height,
                      .density = tile.density,
                      .bonding_gap = tile.bonding_gap};
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const hfdem::Vec2 corner{c * tile.width, r * tile.height};
      for (const hfdem::Vec2& centre : tile.centre) all.centre.push_back(corner + centre);
      all.radius.insert(all.radius.end(), tile.radius.begin(), tile.radius.end());
    }
  return all;
}

/// The paper's rock: 17,511 discs packed as one, or less; more of them are its copies.
inline hfdem::Specimen random_rock(std::size_t discs) {
  constexpr int paper = 17511;
  static std::map<int, hfdem::Specimen> packed;
  const int grains = discs < paper ? static_cast<int>(discs) : paper;
  auto& tile = packed[grains];
  if (tile.size() == 0) {
    const double side = std::sqrt(static_cast<double>(grains) / paper);
    tile = hfdem::random_packing({.width = side, .height = side, .grains = grains});
  }
  const auto side = static_cast<int>(
      std::ceil(std::sqrt(static_cast<double>(discs) / static_cast<double>(grains)) - 1e-9));
  return side == 1 ? tile : tiled(tile, side, side);
}

inline hfdem::Specimen square_rock(std::size_t discs) {
  const auto side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(discs))));
  return hfdem::square_array(side, side, 5e-3);
}
