// Cracks laid out by hand: microcracks that reach exactly from domain to domain.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <hfdem/measure/crack_path.hpp>

namespace test {

class MadeUpCrack {
 public:
  std::vector<hfdem::measure::Microcrack> microcracks{};
  hfdem::measure::CrackOrigin origin{};

  /// @param injection centre of the domain that receives the fluid
  explicit MadeUpCrack(hfdem::Vec2 injection = {}, hfdem::Vec2 direction = {0, 1}) {
    origin = {domain(injection), injection, direction};
  }

  hfdem::Index domain(hfdem::Vec2 centre) {
    centres_.push_back(centre);
    return static_cast<hfdem::Index>(centres_.size() - 1);
  }

  /// A connected microcrack between two domains; returns its place.
  std::size_t join(hfdem::Index a, hfdem::Index b,
                   std::optional<hfdem::Mode> mode = hfdem::Mode::tension) {
    microcracks.push_back({.contact = static_cast<hfdem::Index>(microcracks.size()),
                           .facet = {centres_[a], centres_[b]},
                           .domain = {a, b},
                           .mode = mode,
                           .connected = true});
    return microcracks.size() - 1;
  }

  /// A chain of microcracks from a domain, each by one of the vectors; returns the last domain.
  hfdem::Index grow(hfdem::Index from, const std::vector<hfdem::Vec2>& vectors) {
    for (const hfdem::Vec2 v : vectors) {
      const hfdem::Index to = domain(centres_[from] + v);
      join(from, to);
      from = to;
    }
    return from;
  }
  /// The same from the injection.
  hfdem::Index grow(const std::vector<hfdem::Vec2>& vectors) {
    return grow(origin.domain, vectors);
  }

  hfdem::measure::CrackPath measured() const {
    return hfdem::measure::crack_path(microcracks, origin);
  }

 private:
  std::vector<hfdem::Vec2> centres_{};
};

}  // namespace test
