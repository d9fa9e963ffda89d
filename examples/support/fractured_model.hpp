/// @file
/// The paper's fractured rock: a crack driven among natural fractures by uniform pressure (its
/// Section 4.2, cases N2-S1 and N2-S2 of its Table 4).
#pragma once

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include <hfdem/contact/jointed.hpp>
#include <hfdem/setup/random_fractures.hpp>

#include "support/rock_model.hpp"

namespace hfdem::support {

/// The parameter file; the defaults are those of the first case.
/// @tparam Pressure scheme
template <class Pressure>
struct FracturedRock : RockRunSections<Jointed<ScatteredParallelBond, SmoothJoint>, Pressure>,
                       SectionTree<FracturedRock<Pressure>> {
  using Sections = RockRunSections<Jointed<ScatteredParallelBond, SmoothJoint>, Pressure>;

  RandomFractures fractures;  ///< unless they come from a file

  FracturedRock() { load_case(cases.front()); }

  static constexpr auto cases = cases_of<Pressure>({"N2-S1", "N2-S2"}, {"N1-S1", "N1-S2"});

  /// Loads a case of the paper's Table 4, with the time of its figures.
  void load_case(std::string_view name) {
    this->load_conditions(name);
    this->run.end_time = name.ends_with("S2") ? 0.9 : 2;
  }

  /// A tenth of the area, with a few shorter fractures.
  void shrink() {
    Sections::shrink();
    fractures.count = 5;
    fractures.shortest = 0.06;
    fractures.longest = 0.1;
    fractures.clearance = 0.04;
    fractures.seed = 2;
  }

  template <class Self, class F>
  static void visit(Self& self, F& f) {
    f("fractures", self.fractures);
    Sections::visit(self, f);
  }
};

/// The fractures of section `fractures`, with their ends at whole thousandths of the box: at 1 m by
/// 1 m, the default ones are those of examples/data/fractures.csv.
inline std::vector<NaturalFracture> drawn(const RandomFractures& wanted, Vec2 box, Vec2 injection) {
  auto all = random_fractures(wanted, box.x, box.y, injection);
  const auto rounded = [](double x, double side) {
    return std::round(x / side * 1000) / 1000 * side;
  };
  for (NaturalFracture& f : all)
    for (Vec2* end : {&f.from, &f.to}) *end = {rounded(end->x, box.x), rounded(end->y, box.y)};
  return all;
}

}  // namespace hfdem::support
