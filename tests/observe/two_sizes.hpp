// A specimen of unequal discs whose neighbours are known.
#pragma once

#include <cmath>

#include <hfdem/setup/square_array.hpp>
#include <hfdem/state/specimen.hpp>

namespace test {

/// Large discs on a square grid and a small one in every gap between four of them: unequal arms,
/// oblique contacts, triangular flow domains.
inline hfdem::Specimen two_sizes(hfdem::Index columns, hfdem::Index rows) {
  constexpr double large = 5e-3;
  hfdem::Specimen s = hfdem::square_array(static_cast<int>(columns), static_cast<int>(rows), large);
  for (hfdem::Index r = 0; r + 1 < rows; ++r)
    for (hfdem::Index c = 0; c + 1 < columns; ++c) {
      const auto small = static_cast<hfdem::Index>(s.size());
      const hfdem::Index corner = r * columns + c;
      s.centre.push_back(0.5 * (s.centre[corner] + s.centre[corner + columns + 1]));
      s.radius.push_back((std::sqrt(2.0) - 1) * large);
      for (const hfdem::Index around : {corner, corner + 1, corner + columns, corner + columns + 1})
        s.pairs.push_back({around, small});
    }
  return s;
}

}  // namespace test
