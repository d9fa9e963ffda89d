/// @file
/// The preset crack: a short straight slit at the injection, along the greater in-situ stress.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <hfdem/base/fields.hpp>
#include <hfdem/state/contact.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// How long the preset crack is.
struct PresetCrack {
  int contacts = 4;
  std::optional<double> length{};  ///< takes the place of `contacts`

  static constexpr auto fields() {
    using P = PresetCrack;
    return std::tuple{
        Field{"contacts", &P::contacts, "", Range{0},
              "broken contacts of the preset crack; an even number is centred on the injection"},
        Field{"length", &P::length, "m", positive,
              "length of the preset crack, instead of a number of contacts"}};
  }
};

/// Direction in which a crack opens least work: along the greater of the two stresses (y if equal).
inline Vec2 crack_direction(Stress in_situ) {
  return in_situ.xx <= in_situ.yy ? Vec2{0, 1} : Vec2{1, 0};
}

/// The contacts that the preset crack cuts, nearest to its centre first.
/// @param crack how many, or how long
/// @param specimen gives the discs' centres
/// @param contacts all bonded contacts
/// @param centre centroid of the injection domain, m
/// @param direction unit vector along the crack
/// @throws InvalidParameter if the specimen does not have so many on the crack's line
inline std::vector<Index> preset_crack(const PresetCrack& crack, const Specimen& specimen,
                                       std::span<const ContactGeometry> contacts, Vec2 centre,
                                       Vec2 direction) {
  struct Cut {
    double distance;
    Index contact;
  };
  std::vector<Cut> cuts;
  for (Index c = 0; c < contacts.size(); ++c) {
    const Vec2 a = specimen.centre[contacts[c].bodies.first] - centre;
    const Vec2 b = specimen.centre[contacts[c].bodies.second] - centre;
    const double side_a = cross(direction, a), side_b = cross(direction, b);
    if ((side_a < 0) == (side_b < 0)) continue;
    const double share = side_a / (side_a - side_b);
    cuts.push_back({std::abs(dot(a + share * (b - a), direction)), c});
  }
  std::stable_sort(cuts.begin(), cuts.end(),
                   [](const Cut& p, const Cut& q) { return p.distance < q.distance; });

  std::size_t count = static_cast<std::size_t>(crack.contacts);
  if (crack.length) {
    count = 0;
    while (count < cuts.size() && cuts[count].distance < *crack.length / 2) ++count;
  }
  if (count > cuts.size())
    refuse("crack", "contacts", std::to_string(crack.contacts),
           "at most " + std::to_string(cuts.size()) + ", the contacts on the crack's line");
  std::vector<Index> chosen;
  for (std::size_t k = 0; k < count; ++k) chosen.push_back(cuts[k].contact);
  return chosen;
}

}  // namespace hfdem
