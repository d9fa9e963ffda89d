/// @file
/// Turns neighbours into contacts.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/state/concepts.hpp>
#include <hfdem/state/contact.hpp>
#include <hfdem/state/discs.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// Normal and arms of a contact between two discs. The contact point divides the gap (or overlap).
inline ContactGeometry contact_geometry(const Specimen& s, Pair pair) {
  const Vec2 between = s.centre[pair.second] - s.centre[pair.first];
  const double distance = norm(between), sum = s.radius[pair.first] + s.radius[pair.second];
  const Vec2 normal = (1 / distance) * between;
  // A gap of no more than the rounding of the coordinates is none: touching discs stay mirror
  // images of each other to the last bit.
  const double rounding = 1e-9 * sum;
  const double gap = std::abs(distance - sum) < rounding ? 0 : distance - sum;
  return {.bodies = pair,
          .frame = {normal.x, normal.y, (sum + gap) / 2,
                    (s.radius[pair.second] - s.radius[pair.first]) / 2}};
}

/// All pairs within the specimen's bonding gap, sorted, the lower number first.
/// @throws InvalidParameter if two discs share a centre.
template <NeighbourSearch Search>
std::vector<ContactGeometry> bonded_contacts(const Specimen& s) {
  std::vector<Pair> pairs;
  Search(s, s.bonding_gap).for_each_pair([&](Pair p) {
    if (s.gap(p) <= s.bonding_gap)
      pairs.push_back({std::min(p.first, p.second), std::max(p.first, p.second)});
  });
  std::sort(pairs.begin(), pairs.end());
  std::vector<ContactGeometry> contacts;
  contacts.reserve(pairs.size());
  for (const Pair& p : pairs) {
    if (s.centre[p.first] == s.centre[p.second])
      throw InvalidParameter("specimen: discs " + std::to_string(p.first) + " and " +
                             std::to_string(p.second) + " have the same centre");
    contacts.push_back(contact_geometry(s, p));
  }
  return contacts;
}

/// The contacts between the discs on the rim and the platens, side by side.
inline std::vector<ContactGeometry> platen_contacts(const Specimen& s, const Discs& discs) {
  std::vector<ContactGeometry> contacts;
  for (const Side side : all_sides) {
    const Vec2 out = outward(side);
    for (Index i = 0; i < s.size(); ++i)
      if (s.touches(i, side)) contacts.push_back({{i, discs.platen(side)}, {out.x, out.y, 0, 0}});
  }
  return contacts;
}

}  // namespace hfdem
