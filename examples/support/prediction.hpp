/// @file
/// What measured toughness predicts for a run of the verification model.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <hfdem/analytic/kgd_regime.hpp>
#include <hfdem/analytic/stepwise_growth.hpp>

#include "support/injected.hpp"
#include "support/plate_of_lattice.hpp"
#include "support/run_report.hpp"

namespace hfdem::support {

/// Every parameter of a tree and its value as a parameter file has it.
template <class Tree>
std::vector<std::pair<std::string, std::string>> written_values(const Tree& tree) {
  std::vector<std::pair<std::string, std::string>> all;
  tree.for_each_section([&](std::string_view name, const auto& section) {
    for_each_field<std::remove_cvref_t<decltype(section)>>([&](const auto& field) {
      all.emplace_back(std::string(name) + "." + std::string(field.name),
                       detail::exact(section.*(field.member)));
    });
  });
  return all;
}

/// The crack of a run, from slits of the same lattice: in the specimen and in an infinite plane.
class Prediction {
 public:
  /// @param preset_contacts broken ones when the injection begins
  /// @throws InvalidParameter if the specimen is no plate that the solution knows, or the injection
  ///   not at a constant rate through one point
  template <class Pressure>
  Prediction(const MeasuredToughness& measured, const KgdConfig<Pressure>& config,
             int preset_contacts)
      : rock_(measured.toughness),
        rate_(config.simulator.injection.rate),
        viscosity_(config.simulator.fluid.viscosity),
        growth_(
            plate_of(config.specimen, config.simulator.boundary, config.simulator.in_situ, rock_),
            rock_, 2 * config.specimen.radius, preset_contacts) {
    check_predictable(config.simulator.injection);
    find_differences(measured.lattice, config);
  }

  const analytic::LatticeFracture& rock() const { return rock_; }

  /// Parameters of the run that are not those of the slits, in words.
  const std::vector<std::string>& differences() const { return differences_; }

  /// In the specimen, step by step; nothing once it has split.
  std::optional<analytic::LatticeCrack> in_specimen(double time) const {
    return growth_.at(rate_ * time);
  }

  /// In an infinite plane, toughness alone; nothing while it is too short to grow steadily.
  std::optional<analytic::LatticeCrack> in_plane(double time) const {
    return analytic::crack_in_plane(rock_, rate_ * time);
  }

  /// The run in the terms of the map of regimes, with the toughness at the net pressure of the
  /// infinite plane.
  analytic::KgdProblem problem(double time) const {
    const auto crack = in_plane(time);
    return {.E_prime = rock_.E_prime,
            .K_IC = rock_.toughness(crack ? crack->net_pressure : 0),
            .viscosity = viscosity_,
            .rate = rate_,
            .time = time};
  }

 private:
  /// The plate takes care of the size of the array, and the density of a lattice at rest and the
  /// gain of its servo do not matter.
  template <class Pressure>
  void find_differences(const Lattice& measured, const KgdConfig<Pressure>& config) {
    const auto run = written_values(config);
    for (const auto& [name, there] : written_values(measured)) {
      if (name == "specimen.columns" || name == "specimen.rows" || name == "specimen.density" ||
          name == "boundary.servo_gain")
        continue;
      for (const auto& [other, here] : run)
        if (other == name && here != there)
          differences_.push_back(name + " is " + here + ", and was " + there + " for the slits");
    }
    const double diameter = 2 * config.specimen.radius;
    const Vec2 middle{diameter * config.specimen.columns / 2, diameter * config.specimen.rows / 2};
    if (norm(config.simulator.injection.position.value_or(middle) - middle) > diameter)
      differences_.push_back(
          "injection.position is not the middle of the specimen, for which the prediction holds");
  }

  analytic::LatticeFracture rock_;
  double rate_, viscosity_;
  analytic::StepwiseGrowth growth_;
  std::vector<std::string> differences_;
};

}  // namespace hfdem::support
