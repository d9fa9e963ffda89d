/// @file
/// The mechanical side of a simulator: bonded discs in their boundary, and one step of their
/// motion.
#pragma once

#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include <hfdem/contact/smooth_platen.hpp>
#include <hfdem/mechanics/contact_range.hpp>
#include <hfdem/mechanics/force_rows.hpp>
#include <hfdem/mechanics/loading.hpp>
#include <hfdem/mechanics/motion.hpp>
#include <hfdem/mechanics/stable_step.hpp>
#include <hfdem/mechanics/uniform_strain.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/state/concepts.hpp>

namespace hfdem {

/// Discs, the contacts between them, and what holds them.
///
/// One range of contacts per law shares the force rows: first the bonded discs, then the platens.
/// @tparam Contact law between bonded discs
template <ContactLaw Contact>
class Assembly {
 public:
  /// @param specimen whose discs it takes, as they are when they are bonded
  /// @param bonded contacts between discs
  /// @param law of these contacts
  /// @param boundary what holds the discs of the rim
  /// @param damping local damping coefficient
  /// @param step_fraction mechanical time step over the longest stable one
  Assembly(const Specimen& specimen, std::vector<ContactGeometry> bonded, const Contact& law,
           const Loading::Params& boundary, double damping, double step_fraction)
      : specimen_(specimen),
        discs_(specimen),
        geometry_(std::move(bonded)),
        loading_(boundary, specimen),
        forces_(discs_.size() + all_sides.size()),
        rock_(make_rock(law)),
        platens_(make_platens()) {
    forces_.arrange();
    motion_ =
        DiscMotion(discs_, step_fraction * stable_step(largest_frequency(), damping), damping);
    for (const Side side : all_sides) motion_.leave_out(loading_.rim(side));
  }

  // ---- one mechanical step ----------------------------------------------------------------------

  /// Finds the forces in all contacts and breaks the bonds that are over their strength, calling
  /// `note(contact, mode)` for each in the order of the contacts.
  template <class Note>
  void find_forces(int threads, Note&& note) {
    rock_.evaluate(discs_.displacement, forces_.rows(), threads);
    platens_.evaluate(discs_.displacement, forces_.rows(), threads);
    rock_.break_bonds(discs_.displacement, forces_.rows(), note);
  }

  /// Sets the force that the fluid exerts on a disc, N per m, beside a dead load.
  void push(Index disc, Vec2 fluid) { discs_.load[disc] = loading_.dead_load(disc) + fluid; }

  /// Moves platens and discs by one time step.
  /// @param settling frozen platens still move then
  /// @param threads for the loop; the result does not depend on it
  /// @returns the largest resultant force on a disc before damping, N per m
  double move(bool settling, int threads) {
    loading_.step(discs_, forces_, settling);
    return motion_.step(discs_, forces_, threads);
  }

  // ---- other verbs ------------------------------------------------------------------------------

  /// Changes the stress that the boundary holds, and starts from the uniform strain that it makes.
  /// Dead loads take effect with the next `push`.
  void set_stress(Stress stress) {
    const Stress before = loading_.stress();
    loading_.set_stress(stress);
    shorten(discs_, uniform_strain_.shortening({stress.xx - before.xx, stress.yy - before.yy}),
            loading_.width(), loading_.height());
  }

  void break_bond(Index contact) { rock_.break_bond(contact); }  ///< whatever its strength

  /// From now on a platen moves inwards at this speed, m/s, instead of holding a stress.
  void drive(Side side, double speed) { loading_.drive(side, speed * dt()); }

  /// Takes a platen away.
  void withdraw(Side side) {
    const Vec2 away = (specimen_.width + specimen_.height) * outward(side);
    discs_.displacement[discs_.platen(side)] += Pack{away.x, away.y, 0, 0};
    loading_.drive(side, 0);
  }

  /// From now on a disc moves at this velocity, m/s, without turning, whatever pulls on it.
  void drive(Index disc, Vec2 velocity) {
    discs_.velocity[disc] = Pack{velocity.x, velocity.y, 0, 0};
    motion_.keep_velocity(disc);
  }

  /// Gives the discs velocities with which the specimen shortens uniformly, 1/s: a load that rises
  /// from the start on as it would in a specimen without inertia.
  void shorten_at(Vec2 rate) {
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      const Vec2 away = discs_.centre[i] - 0.5 * Vec2{specimen_.width, specimen_.height};
      discs_.velocity[i] = Pack{-rate.x * away.x, -rate.y * away.y, 0, 0};
    }
  }

  // ---- what can be read -------------------------------------------------------------------------

  const Specimen& specimen() const { return specimen_; }                  ///< as it was bonded
  const Discs& discs() const { return discs_; }                           ///< and platens
  const ContactRange<Contact>& contacts() const { return rock_; }         ///< between discs
  const ContactRange<SmoothPlaten>& platens() const { return platens_; }  ///< on the discs
  const Loading& loading() const { return loading_; }  ///< that holds the specimen
  const ForceRows& forces() const { return forces_; }  ///< of the last step
  double dt() const { return motion_.dt(); }           ///< mechanical time step, s
  /// Shortenings for a stress if all discs moved with a uniform strain.
  Vec2 uniform_shortening(Stress stress) const { return uniform_strain_.shortening(stress); }
  /// Bodies, normals and arms of the contacts between discs.
  std::span<const ContactGeometry> geometry() const { return geometry_; }
  /// The same of the contacts on platens.
  std::span<const ContactGeometry> platen_geometry() const { return platen_geometry_; }

  /// Mean size of the force in the contacts between discs at the last mechanical step, N per m.
  double mean_contact_force() const {
    double sum = 0;
    for (std::size_t c = 0; c < rock_.size(); ++c) {
      const Pack& row = forces_.rows()[rock_.first_row() + c];
      sum += std::sqrt(row[0] * row[0] + row[1] * row[1]);
    }
    return rock_.size() == 0 ? 0 : sum / static_cast<double>(rock_.size());
  }

  /// The largest relative error of a platen's force; 0 without platens.
  double worst_platen_error() const {
    double worst = 0;
    if (loading_.has_platens())
      for (const Side side : all_sides)
        worst = std::fmax(worst, loading_.error(side, discs_, forces_));
    return worst;
  }

  /// Everything that moves, breaks or is held; discs that are driven must be driven anew.
  void exchange(auto& archive) { archive(discs_, loading_, forces_, rock_, platens_); }

 private:
  ContactRange<Contact> make_rock(const Contact& law) {
    std::vector<typename Contact::template Stiffness<double>> stiffness;
    for (const auto& c : geometry_) {
      stiffness.push_back(law.stiffness(disc(c.bodies.first), disc(c.bodies.second)));
      if constexpr (VaryingLaw<Contact>)
        stiffness.back() = law.varied(stiffness.back(), static_cast<Index>(stiffness.size() - 1));
      uniform_strain_.add(c.frame, law.springs(stiffness.back()), 2 * c.frame.arm_mean,
                          specimen_.width * specimen_.height);
    }
    ContactRange<Contact> rock(law, 0, geometry_, stiffness);
    forces_.add(geometry_, 0, rock.padded_size());
    return rock;
  }

  ContactRange<SmoothPlaten> make_platens() {
    if (loading_.has_platens()) platen_geometry_ = platen_contacts(specimen_, discs_);
    std::vector<SmoothPlaten::Stiffness<double>> stiffness;
    for (const auto& c : platen_geometry_) {
      const Index i = c.bodies.first;
      const Springs like = rock_.law().springs(rock_.law().stiffness(disc(i), disc(i)));
      stiffness.push_back(SmoothPlaten::stiffness(like));
      const double k = stiffness.back().normal;
      loading_.add_stiffness(static_cast<Side>(c.bodies.second - discs_.size()), k);
      uniform_strain_.add(c.frame, {.normal = k}, specimen_.radius[i],
                          specimen_.width * specimen_.height);
    }
    ContactRange<SmoothPlaten> platens({}, rock_.padded_size(), platen_geometry_, stiffness);
    forces_.add(platen_geometry_, platens.first_row(), platens.padded_size());
    return platens;
  }

  double largest_frequency() const {
    FrequencyBound bound(discs_);
    for (std::size_t c = 0; c < rock_.size(); ++c)
      bound.add(geometry_[c], rock_.law().springs(rock_.stiffness(c)));
    for (std::size_t c = 0; c < platens_.size(); ++c)
      bound.add(platen_geometry_[c], platens_.law().springs(platens_.stiffness(c)));
    return bound.value();
  }

  Disc disc(Index i) const { return {specimen_.radius[i]}; }

  Specimen specimen_;
  Discs discs_;
  std::vector<ContactGeometry> geometry_, platen_geometry_;
  Loading loading_;
  ForceRows forces_;
  UniformStrainModulus uniform_strain_;
  ContactRange<Contact> rock_;
  ContactRange<SmoothPlaten> platens_;
  DiscMotion motion_;
};

}  // namespace hfdem
