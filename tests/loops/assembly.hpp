// Irregular bonded assemblies between platens, put together by hand as the simulator would.
#pragma once

#include <cstddef>
#include <vector>

#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/contact/smooth_platen.hpp>
#include <hfdem/mechanics/contact_range.hpp>
#include <hfdem/mechanics/force_rows.hpp>
#include <hfdem/neighbours/fixed_pairs.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/state/discs.hpp>

#include "laws/random.hpp"

namespace test {

/// Discs of random radii on a jittered triangular grid; some overlap, some are apart. All pairs are
/// proposed for bonding.
inline hfdem::Specimen jittered_discs(hfdem::Index columns, hfdem::Index rows, Random& random) {
  constexpr double pitch = 9.4e-3, row_height = 8.2e-3;
  hfdem::Specimen s{.width = columns * pitch + pitch / 2,
                    .height = rows * row_height,
                    .density = 2700,
                    .bonding_gap = 1.4e-3};
  for (hfdem::Index r = 0; r < rows; ++r)
    for (hfdem::Index c = 0; c < columns; ++c) {
      const double shift = r % 2 == 0 ? 0.5 : 1.0;
      s.centre.push_back({(c + shift) * pitch + random(-6e-4, 6e-4),
                          (r + 0.5) * row_height + random(-6e-4, 6e-4)});
      s.radius.push_back(random(3.6e-3, 5e-3));
    }
  for (hfdem::Index j = 0; j < s.size(); ++j)
    for (hfdem::Index i = 0; i < j; ++i) s.pairs.push_back({i, j});
  return s;
}

/// All bonded contacts and platens of a specimen, with the rows that carry their forces.
template <class Law>
struct Assembly {
  hfdem::Specimen specimen;
  hfdem::Discs discs;
  std::vector<hfdem::ContactGeometry> contacts, touching;
  hfdem::ContactRange<Law> rock;
  hfdem::ContactRange<hfdem::SmoothPlaten> platens;
  hfdem::ForceRows forces;

  Assembly(const hfdem::Specimen& s, const Law& law)
      : specimen(s),
        discs(s),
        contacts(hfdem::bonded_contacts<hfdem::FixedPairs>(s)),
        touching(hfdem::platen_contacts(s, discs)),
        rock(law, 0, contacts, bonds(law)),
        platens({}, rock.padded_size(), touching, walls(law)),
        forces(s.size() + hfdem::all_sides.size()) {
    forces.add(contacts, rock.first_row(), rock.padded_size());
    forces.add(touching, platens.first_row(), platens.padded_size());
    forces.arrange();
  }

  void evaluate(int threads = 1) {
    rock.evaluate(discs.displacement, forces.rows(), threads);
    platens.evaluate(discs.displacement, forces.rows(), threads);
  }

 private:
  hfdem::Disc disc(hfdem::Index i) const { return {specimen.radius[i]}; }

  std::vector<typename Law::template Stiffness<double>> bonds(const Law& law) const {
    std::vector<typename Law::template Stiffness<double>> result;
    for (const auto& c : contacts)
      result.push_back(law.stiffness(disc(c.bodies.first), disc(c.bodies.second)));
    return result;
  }
  std::vector<hfdem::SmoothPlaten::Stiffness<double>> walls(const Law& law) const {
    std::vector<hfdem::SmoothPlaten::Stiffness<double>> result;
    for (const auto& c : touching) {
      const hfdem::Disc d = disc(c.bodies.first);
      result.push_back(hfdem::SmoothPlaten::stiffness(law.springs(law.stiffness(d, d))));
    }
    return result;
  }
};

/// Moves every body at random, by up to `size` in place and in the arc of its rotation.
inline void shake(hfdem::Discs& discs, double size, Random& random) {
  for (std::size_t i = 0; i < discs.displacement.size(); ++i) {
    const double turn = i < discs.size() ? random(-size, size) / discs.radius[i] : 0;
    discs.displacement[i] += hfdem::Pack{random(-size, size), random(-size, size), turn, turn};
  }
}

}  // namespace test
