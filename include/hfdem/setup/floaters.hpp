/// @file
/// Floaters: discs that lie in a cage of larger ones and touch fewer than three of them. They would
/// hang on one or two bonds and carry nothing.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <hfdem/neighbours/cell_grid.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// For each disc the gap to the third nearest of its neighbours and walls, m, but at most the
/// largest radius: where it is positive, fewer than three hold the disc.
inline std::vector<double> gaps_to_third(const Specimen& s) {
  if (s.size() == 0) return {};
  const double reach = *std::max_element(s.radius.begin(), s.radius.end());
  std::vector<std::array<double, 3>> nearest(s.size(), {reach, reach, reach});
  const auto note = [&](Index disc, double gap) {
    auto& three = nearest[disc];
    if (gap >= three[2]) return;
    three[2] = gap;
    std::sort(three.begin(), three.end());
  };
  CellGrid(s, reach).for_each_pair([&](Pair p) {
    const double gap = s.gap(p);
    note(p.first, gap);
    note(p.second, gap);
  });
  std::vector<double> third;
  for (Index i = 0; i < s.size(); ++i) {
    for (const Side side : all_sides) note(i, s.gap(i, side));
    third.push_back(nearest[i][2]);
  }
  return third;
}

/// Gives every floater a radius with which it reaches its third neighbour. It exchanges radii with
/// the disc, wherever, whose radius is the next larger one: number, porosity and distribution of
/// the radii stay what they are. The specimen has to be relaxed again afterwards.
/// @param s the specimen
/// @param push how much farther it shall reach, m
/// @returns the number of floaters
inline std::size_t exchange_radii_of_floaters(Specimen& s, double push) {
  const std::vector<double> third = gaps_to_third(s);
  std::vector<Index> floaters, by_radius;
  for (Index i = 0; i < s.size(); ++i) (third[i] > 0 ? floaters : by_radius).push_back(i);
  std::sort(by_radius.begin(), by_radius.end(), [&](Index a, Index b) {
    return s.radius[a] != s.radius[b] ? s.radius[a] < s.radius[b] : a < b;
  });
  for (const Index i : floaters) {
    if (by_radius.empty()) break;
    auto larger =
        std::lower_bound(by_radius.begin(), by_radius.end(), s.radius[i] + third[i] + push,
                         [&](Index a, double radius) { return s.radius[a] < radius; });
    if (larger == by_radius.end()) --larger;
    std::swap(s.radius[i], s.radius[*larger]);
    by_radius.erase(larger);
  }
  return floaters.size();
}

/// Lets every floater grow to its third neighbour, be it beyond the range of the radii: for discs
/// so alike that no exchange helps.
/// @param s the specimen
/// @param push how much farther it shall reach, m
/// @returns the number of floaters
inline std::size_t grow_floaters(Specimen& s, double push) {
  const std::vector<double> third = gaps_to_third(s);
  std::size_t floaters = 0;
  for (Index i = 0; i < s.size(); ++i)
    if (third[i] > 0) s.radius[i] += third[i] + push, ++floaters;
  return floaters;
}

}  // namespace hfdem
