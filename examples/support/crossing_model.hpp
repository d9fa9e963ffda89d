/// @file
/// A fluid-driven crack that meets a joint: does it stop there, leave the joint elsewhere, or
/// cross?
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <numbers>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/contact/jointed.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/measure/microcracks.hpp>
#include <hfdem/neighbours/cell_grid.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/setup/joints.hpp>
#include <hfdem/setup/random_packing.hpp>
#include <hfdem/simulator.hpp>

#include "support/settings.hpp"

namespace hfdem::support {

using CrossingRock = Simulator<Jointed<LinearParallelBond, SmoothJoint>, HyperbolicAperture,
                               UniformPressure, CellGrid>;

/// The joints, and what is tried.
struct CrossingStudy {
  int seeds = 3;
  double distance = 0.08;
  double length = 0.2;
  double end_time = 0.6;
  double offset = 0.016;
  double beyond = 0.024;
  int every = 1;

  static constexpr auto fields() {
    using P = CrossingStudy;
    return std::tuple{
        Field{"seeds", &P::seeds, "", Range{1, 1000},
              "rocks for each angle and stress, numbered from specimen.seed on"},
        Field{"distance", &P::distance, "m", positive,
              "from the injection to the middle of each joint"},
        Field{"length", &P::length, "m", positive, "of each joint"},
        Field{"end_time", &P::end_time, "s", positive,
              "injection time after which a crack that is not beyond the joint is arrested"},
        Field{"offset", &P::offset, "m", positive,
              "along the joint, from where the crack meets it: one that leaves it nearer crosses"},
        Field{"beyond", &P::beyond, "m", positive,
              "length of microcracks beyond the joint that count as a crack"},
        Field{"every", &P::every, "", Range{1, 5},
              "1: all angles and stresses of the map; 2: every second, from the first on; ..."}};
  }
};

/// The parameter file's sections.
struct CrossingConfig : SectionTree<CrossingConfig> {
  RandomPacking specimen{.width = 0.5, .height = 0.5};
  /// Filled joints, about as stiff as the rock's own contacts: the criteria that the map stands
  /// beside know neither volume nor compliance of a joint.
  CrossingRock::Params simulator{.joints = {.normal_stiffness = 4e12,
                                            .shear_stiffness = 1.6e12,
                                            .initially = JointContent::filled},
                                 .crack = {.length = 0.032},
                                 .mechanics = {.settle_tolerance = 5e-4},
                                 .scheme = {.fluid_dt = 1e-3,
                                            .equilibrium = true,
                                            .max_mechanical_steps = 500,
                                            .unbalanced_tolerance = 5e-3}};
  CrossingStudy study;

  /// Joint to crack, deg.
  std::vector<double> angles() const { return tried({90, 75, 60, 45, 30}); }
  /// Along the crack, Pa.
  std::vector<double> stresses() const { return tried({11e6, 13e6, 16e6, 20e6, 25e6}); }

  /// The corners of the map, in small specimens with joints near the injection.
  void shrink() {
    specimen.width = specimen.height = 0.2;
    study = {.seeds = 1, .distance = 0.03, .length = 0.06, .end_time = 0.05, .every = 4};
  }

  /// A rock with a joint above the injection and one below, either the other turned by half a
  /// circle: no wing is favoured.
  Specimen rock(double angle, int seed, int threads) const {
    RandomPacking packing = specimen;
    packing.seed = seed;
    Specimen rock = random_packing(packing, threads);
    const double b = angle * std::numbers::pi / 180;
    const Vec2 half = study.length / 2 * Vec2{std::sin(b), std::cos(b)};
    const Vec2 injection = 0.5 * Vec2{packing.width, packing.height}, up{0, study.distance};
    insert_joints(rock, {{injection + up - half, injection + up + half},
                         {injection - up - half, injection - up + half}});
    return rock;
  }

  template <class Self, class F>
  static void visit(Self& self, F& f) {
    f("specimen", self.specimen);
    hfdem::for_each_section(self.simulator, f);
    f("study", self.study);
  }

 private:
  std::vector<double> tried(std::initializer_list<double> all) const {
    std::vector<double> some;
    for (std::size_t k = 0; k < all.size(); k += static_cast<std::size_t>(study.every))
      some.push_back(all.begin()[k]);
    return some;
  }
};

/// What becomes of a crack at a joint.
enum class Encounter { arrested, offset, crossing };
/// In words.
inline constexpr std::array<std::string_view, 3> encounter_names{"arrested", "offset", "crossing"};

/// Watches a run until a wing is beyond its joint; an observer.
class EncounterWatch {
 public:
  explicit EncounterWatch(const CrossingStudy& study) : study_(study) {}

  /// Ends the run by false.
  bool operator()(const CrossingRock& sim) {
    for (Index f = 0; f < 2 && !result_; ++f) look(sim, f);
    return !result_;
  }

  /// What has happened so far.
  Encounter result() const { return result_.value_or(Encounter::arrested); }

 private:
  void look(const CrossingRock& sim, Index f) {
    const NaturalFracture& joint = sim.joints().fractures()[f];
    const Network& network = sim.network();
    const Vec2 origin = network.geometry().centre[network.injection_domain()];
    const double near_side = cross(joint.direction(), origin - joint.from);
    const auto along = [&](Vec2 p) { return dot(p - joint.from, joint.direction()); };
    if (!met_[f]) find_meeting(sim, f, along);
    double length = 0;
    std::optional<double> leaves_at;
    for (const Index c : network.wet_channels()) {
      if (sim.is_joint(c)) continue;
      const Vec2 at = sim.contact_point(c);
      if (cross(joint.direction(), at - joint.from) * near_side > 0) continue;
      if (!leaves_at) leaves_at = along(at);
      const auto [from, to] = measure::facet(sim, c);
      length += norm(to - from);
    }
    if (length < study_.beyond) return;
    const bool across = met_[f] && std::abs(*leaves_at - *met_[f]) <= study_.offset;
    result_ = across ? Encounter::crossing : Encounter::offset;
  }

  /// Where the first wet domain beside a joint contact is.
  template <class F>
  void find_meeting(const CrossingRock& sim, Index f, F&& along) {
    const auto rock = static_cast<Index>(sim.contacts().size());
    for (const Index d : sim.network().wet_domains())
      for (const Index c : sim.network().channels_of(d))
        if (!met_[f] && sim.is_joint(c) && sim.joints().pair(c - rock).fracture == f)
          met_[f] = along(sim.joints().crossing(c - rock));
  }

  CrossingStudy study_;
  std::array<std::optional<double>, 2> met_{};  ///< along each joint, m
  std::optional<Encounter> result_{};
};

}  // namespace hfdem::support
