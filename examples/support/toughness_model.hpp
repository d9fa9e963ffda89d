/// @file
/// Slit tests of the verification model's lattice, and the file that hands their result on; and the
/// sections and files that other rocks share with it.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <hfdem/analytic/lattice_fracture.hpp>
#include <hfdem/measure/slit.hpp>
#include <hfdem/measure/toughness.hpp>

#include "support/kgd_model.hpp"
#include "support/settings.hpp"

namespace hfdem::support {

using LatticeSlit = measure::Slit<LinearParallelBond, HyperbolicAperture, FixedPairs>;

/// The sections that shape a toughness; a run and the slits that explain it should share them.
/// @tparam SpecimenParams of the discs, e.g. `SquareArray`
template <class SpecimenParams>
struct RockSections : SectionTree<RockSections<SpecimenParams>> {
  SpecimenParams specimen;
  LinearParallelBond::Params contact;
  HyperbolicAperture::Params aperture;
  Loading::Params boundary;
  Stress in_situ;

  template <class Self, class F>
  static void visit(Self& self, F& f) {
    f("specimen", self.specimen);
    f("contact", self.contact);
    f("aperture", self.aperture);
    f("boundary", self.boundary);
    f("in_situ", self.in_situ);
  }
};

using Lattice = RockSections<SquareArray>;

/// The parameter file's sections.
struct ToughnessConfig : SectionTree<ToughnessConfig> {
  Lattice lattice;
  Mechanics mechanics;
  HeldPressure::Params scheme{.unbalanced_tolerance = 3e-7, .max_mechanical_steps = 100000};
  measure::SlitSeries slits;

  /// Short slits in a 40 x 40 array.
  static ToughnessConfig quick() {
    ToughnessConfig config;
    config.lattice.specimen.columns = config.lattice.specimen.rows = 40;
    config.slits = {.shortest = 6, .longest = 16, .count = 3};
    config.scheme.unbalanced_tolerance = 3e-6;
    return config;
  }

  template <class Self, class F>
  static void visit(Self& self, F& f) {
    self.lattice.for_each_section(f);
    f("mechanics", self.mechanics);
    f("scheme", self.scheme);
    f("slits", self.slits);
  }
};

/// Tests the next slit of a series.
/// @param config with the series
/// @param tests of the slits before it
/// @param threads for the loops
/// @throws RunStopped if a state finds no equilibrium
inline measure::SlitTest next_slit_test(const ToughnessConfig& config,
                                        const std::vector<measure::SlitTest>& tests, int threads) {
  const Lattice& lattice = config.lattice;
  LatticeSlit slit(square_array(lattice.specimen),
                   {.contact = lattice.contact,
                    .aperture = lattice.aperture,
                    .boundary = lattice.boundary,
                    .in_situ = lattice.in_situ,
                    .mechanics = config.mechanics,
                    .scheme = config.scheme},
                   config.slits.contacts()[tests.size()]);
  slit.use_threads(threads);
  const double closing = std::fmin(lattice.in_situ.xx, lattice.in_situ.yy);
  // Well below the first break; a longer slit breaks at less pressure, about as 1 / sqrt(a).
  const double start = tests.empty() ? 0.1 * std::fmax(closing, 1e6)
                                     : 0.8 * tests.back().net_pressure_at_break *
                                           std::sqrt(tests.back().half_length / slit.half_length());
  return slit.test(start, config.slits.accuracy);
}

/// What a toughness file holds: the numbers, and the lattice that they belong to.
struct MeasuredToughness : SectionTree<MeasuredToughness> {
  analytic::LatticeFracture toughness;
  Lattice lattice;

  template <class Self, class F>
  static void visit(Self& self, F& f) {
    f("toughness", self.toughness);
    self.lattice.for_each_section(f);
  }
};

/// Reads what was measured of one kind of rock.
/// @throws InvalidParameter with the line if the file is not a whole toughness file
template <class Measured>
Measured read_measured(const std::string& path) {
  Measured measured;
  const std::vector<Setting> settings = read_toml(path);
  for (const Setting& s : settings) apply(measured, s);
  measured.for_each_section([&](std::string_view name, const auto& section) {
    for_each_field<std::remove_cvref_t<decltype(section)>>([&](const auto& field) {
      if constexpr (!is_optional<std::remove_cvref_t<decltype(section.*(field.member))>>) {
        for (const Setting& s : settings)
          if (s.section == name && s.key == field.name) return;
        throw InvalidParameter(path + " is no whole toughness file: " + std::string(name) + "." +
                               std::string(field.name) + " is missing");
      }
    });
  });
  try {
    validate_all(measured);
  } catch (const InvalidParameter& e) {
    throw InvalidParameter(path + " is no whole toughness file: " + e.what());
  }
  return measured;
}

/// @throws InvalidParameter with the line if the file is not a whole toughness file of a square
/// array
inline MeasuredToughness read_toughness(const std::string& path) {
  return read_measured<MeasuredToughness>(path);
}

/// Young's modulus, Poisson's ratio and shear modulus of a square array whose contacts are closed:
/// columns of springs, which pure shear strains by half its angle each.
inline analytic::LatticeFracture square_lattice(const Lattice& lattice) {
  const LinearParallelBond law(lattice.contact);
  const Disc disc{lattice.specimen.radius};
  const Springs springs = law.springs(law.stiffness(disc, disc));
  return {.E = springs.normal, .poisson_ratio = 0, .shear_modulus = springs.shear / 2};
}

}  // namespace hfdem::support
