/// @file
/// The mechanical side of a simulator: bonded discs in their boundary, and one step of their
/// motion.
#pragma once

#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <hfdem/contact/jointed.hpp>
#include <hfdem/contact/smooth_platen.hpp>
#include <hfdem/mechanics/contact_range.hpp>
#include <hfdem/mechanics/force_rows.hpp>
#include <hfdem/mechanics/joint_contacts.hpp>
#include <hfdem/mechanics/loading.hpp>
#include <hfdem/mechanics/motion.hpp>
#include <hfdem/mechanics/stable_step.hpp>
#include <hfdem/mechanics/sweep.hpp>
#include <hfdem/mechanics/uniform_strain.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/state/concepts.hpp>
#include <hfdem/state/step.hpp>

namespace hfdem {

/// Discs, the contacts between them, and what holds them.
///
/// One range of contacts per law shares the force rows: first the bonded discs, then joints, then
/// the platens. Contacts between discs are numbered through: those of the rock, then bonded joints.
/// @tparam Contact law between bonded discs, with or without joints
template <ContactLaw Contact>
class Assembly {
 public:
  /// @param specimen whose discs it takes, as they are when they are bonded, and whose joints
  /// @param bonded contacts between discs, sorted by bodies, the first with the lower number
  /// @param law of these contacts
  /// @param boundary what holds the discs of the rim
  /// @param damping local damping coefficient
  /// @param step_fraction mechanical time step over the longest stable one
  /// @throws InvalidParameter if the specimen has joints and the law has none
  Assembly(const Specimen& specimen, std::vector<ContactGeometry> bonded, const Contact& law,
           const Loading::Params& boundary, double damping, double step_fraction)
      : specimen_(specimen),
        discs_(specimen),
        parted_(std::move(bonded), specimen.joints.pairs),
        loading_(boundary, specimen),
        forces_(discs_.size() + all_sides.size()),
        rock_(make_rock(law)),
        joints_(make_joints(joint_law(law))),
        platens_(make_platens()),
        sweep_(discs_.size(), geometry().first(rock_.size())) {
    forces_.arrange();
    const FrequencyBound bound = frequency_bound();
    motion_ = DiscMotion(discs_, step_fraction * stable_step(bound.value(), damping), damping);
    springs_ = {bound, discs_};
    step_factor_ = step_fraction * stable_step(1, damping);
    for (const Side side : all_sides) motion_.leave_out(loading_.rim(side));
    lever_ = rock_.longest_arm();
    for (const double radius : discs_.radius) lever_ = max(lever_, radius);
  }

  // ---- one mechanical step ----------------------------------------------------------------------

  /// Finds the forces in all contacts and breaks the bonds that are over their strength, calling
  /// `note(contact, mode)` for each in the order of the contacts.
  template <class Note>
  void find_forces(int threads, Note&& note) {
    to_sweep_ = false;
    rock_.evaluate(discs_.displacement, forces_.rows(), threads);
    find_other_forces(threads);
    rock_.break_bonds(discs_.displacement, forces_.rows(), note);
    break_joints(note);
  }

  /// The same for a step whose forces nobody reads and whose contacts nobody changes before `move`:
  /// where no bond of the rock can break, its forces are left for `move` to find on the way, which
  /// is faster; the result is the same.
  template <class Note>
  void begin_step(int threads, Note&& note) {
    if constexpr (ForeseesFailure<RockLawOf<Contact>>) {
      if (rock_.all_hold(discs_.displacement, threads)) {
        find_other_forces(threads);
        to_sweep_ = true;
        break_joints([&](Index contact, Mode mode) {
          to_sweep_ = false;  // whoever stops a run where something breaks finds all forces
          note(contact, mode);
        });
        if (!to_sweep_) rock_.evaluate(discs_.displacement, forces_.rows(), threads);
        return;
      }
    }
    find_forces(threads, note);
  }

  /// Sets the force that the fluid exerts on a disc, N per m, beside a dead load.
  void push(Index disc, Vec2 fluid) { discs_.load[disc] = loading_.dead_load(disc) + fluid; }

  /// Keeps the mechanical step stable where a fluid is a further spring between discs.
  /// @param for_each_spring calls its argument with contact and stiffness, N/m per m, of each
  template <class ForEachSpring>
  void carry(ForEachSpring&& for_each_spring) {
    for_each_spring(
        [&](Index contact, double stiffness) { springs_.add(geometry()[contact], stiffness); });
    const double longest = step_factor_ / springs_.take(discs_);
    // A step that changes all the time costs a pass over all discs each time.
    constexpr double margin = 0.95, worth_it = 1.1, round_off = 1e-12;
    if (longest < (1 - round_off) * dt() || margin * longest > worth_it * dt())
      motion_.set_dt(discs_, margin * longest);
  }

  /// Moves platens and discs by one time step.
  /// @param settling frozen platens still move then
  /// @param threads for the loop; the result does not depend on it
  /// @returns the largest resultant force on a disc before damping, N per m; discs under a dead
  /// load do not count
  double move(bool settling, int threads) {
    loading_.step(discs_, forces_, settling);
    const Moved moved = std::exchange(to_sweep_, false)
                            ? sweep_.step(rock_, discs_, forces_, motion_, threads)
                            : motion_.step(discs_, forces_, threads);
    rock_.moved(moved.of_contacts(lever_));
    if (joints_.size() > joints_.bonded() && ++steps_ % between_meetings == 0) joints_.meet(discs_);
    return moved.resultant;
  }

  // ---- other verbs ------------------------------------------------------------------------------

  /// Changes the stress that the boundary holds, and starts from the uniform strain that it makes.
  /// Dead loads take effect with the next `push`.
  void set_stress(Stress stress) {
    const Stress before = loading_.stress();
    loading_.set_stress(stress);
    shorten(discs_, uniform_strain_.shortening({stress.xx - before.xx, stress.yy - before.yy}),
            loading_.width(), loading_.height());
    rock_.displaced();
  }

  /// Whatever its strength.
  void break_bond(Index contact) {
    if (is_joint(contact))
      joints_.contacts().break_bond(contact - rock_.size());
    else
      rock_.break_bond(contact);
  }

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

  const Specimen& specimen() const { return specimen_; }  ///< as it was bonded
  const Discs& discs() const { return discs_; }           ///< and platens
  /// Between discs of the rock.
  const ContactRange<RockLawOf<Contact>>& contacts() const { return rock_; }
  /// Between discs with a natural fracture between them.
  const JointContacts<JointLawOf<Contact>>& joints() const { return joints_; }
  /// Whether a contact between discs is a joint.
  bool is_joint(Index contact) const { return contact >= rock_.size(); }
  /// The number that joint `joint` has among the contacts between discs.
  Index number_of(Index joint) const { return static_cast<Index>(rock_.size()) + joint; }
  const ContactRange<SmoothPlaten>& platens() const { return platens_; }  ///< on the discs
  const Loading& loading() const { return loading_; }  ///< that holds the specimen
  const ForceRows& forces() const { return forces_; }  ///< of the last step
  double dt() const { return motion_.dt(); }           ///< mechanical time step, s
  /// Shortenings for a stress if all discs moved with a uniform strain.
  Vec2 uniform_shortening(Stress stress) const { return uniform_strain_.shortening(stress); }
  /// Bodies of the contacts between discs, normals and arms from centre to centre.
  std::span<const ContactGeometry> geometry() const { return parted_.bonded; }
  /// The same of the contacts on platens.
  std::span<const ContactGeometry> platen_geometry() const { return platen_geometry_; }

  /// What a flow channel between two discs sees of its contact.
  struct Opening {
    double compression;  ///< N per m; of a joint, its stress on the width of the bond, 2 Rb
    double gap;          ///< opening since bonding, m; of a joint, beyond its dilation
    double dilation;     ///< by how much slip has opened a joint, m
  };
  /// Inlined: the loop over wet channels is little else.
  [[gnu::always_inline]] Opening opening(Index contact) const {
    if (!is_joint(contact)) {
      const Motion<double> motion = rock_.motion(contact, discs_.displacement);
      const auto response =
          rock_.law().respond(rock_.stiffness(contact), rock_.memory(contact), motion);
      return {max(0.0, response.reaction().normal), motion.opening, 0};
    }
    const std::size_t k = contact - rock_.size();
    const ContactRange<JointLawOf<Contact>>& range = joints_.contacts();
    const auto [first, second] = joints_.pair(k).bodies;
    const double width = 2 * std::fmin(discs_.radius[first], discs_.radius[second]);
    const auto response = range.response(k, discs_.displacement);
    const double dilation = range.law().dilation(response.memory);
    const double gap = range.motion(k, discs_.displacement).opening - dilation;
    return {max(0.0, response.normal_stress * width), gap, dilation};
  }

  /// How fast the compression of an opening falls with its gap, N/m per m.
  double closing_stiffness(Index contact) const {
    if (!is_joint(contact)) return rock_.law().springs(rock_.stiffness(contact)).normal;
    const auto [first, second] = joints_.pair(contact - rock_.size()).bodies;
    const JointLawOf<Contact>& law = joints_.contacts().law();
    return law.springs(law.stiffness(2 * std::fmin(discs_.radius[first], discs_.radius[second])))
        .normal;
  }

  /// How the rock answers, roughly.
  RockResponse response() const {
    double mass = 0;
    for (const double m : discs_.mass) mass += m;
    const double modulus = 1 / uniform_shortening({.xx = 1, .yy = 0}).x;
    const double density = mass / (specimen_.width * specimen_.height);
    return {modulus, std::sqrt(modulus / density) * dt()};
  }

  /// Mean size of the force in the contacts between discs at the last mechanical step, N per m.
  double mean_contact_force() const {
    double sum = 0;
    const auto add = [&](std::size_t first_row, std::size_t count) {
      for (const Pack& row : forces_.rows().subspan(first_row, count))
        sum += std::sqrt(row[0] * row[0] + row[1] * row[1]);
    };
    add(rock_.first_row(), rock_.size());
    add(joints_.contacts().first_row(), joints_.size());
    const std::size_t bonded = parted_.bonded.size();
    return bonded == 0 ? 0 : sum / static_cast<double>(bonded);
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
  void exchange(auto& archive) {
    double dt = motion_.dt();
    archive(discs_, loading_, forces_, rock_, joints_, platens_, steps_, dt);
    motion_.set_dt(discs_, dt);
  }

 private:
  void find_other_forces(int threads) {
    joints_.contacts().evaluate(discs_.displacement, forces_.rows(), threads);
    platens_.evaluate(discs_.displacement, forces_.rows(), threads);
  }
  template <class Note>
  void break_joints(Note&& note) {
    joints_.contacts().break_bonds(discs_.displacement, forces_.rows(),
                                   [&](Index joint, Mode mode) { note(number_of(joint), mode); });
  }

  ContactRange<RockLawOf<Contact>> make_rock(const Contact& law) {
    const auto rock = geometry().first(parted_.of_rock);
    std::vector<typename Contact::template Stiffness<double>> stiffness;
    stiffness.reserve(rock.size());
    for (const auto& c : rock) {
      stiffness.push_back(law.stiffness(disc(c.bodies.first), disc(c.bodies.second)));
      // By its number without joints: the rock's strength is the same with them.
      if constexpr (VaryingLaw<Contact>)
        stiffness.back() = law.varied(stiffness.back(), parted_.number[stiffness.size() - 1]);
      uniform_strain_.add(c.frame, law.springs(stiffness.back()), 2 * c.frame.arm_mean,
                          specimen_.width * specimen_.height);
    }
    ContactRange<RockLawOf<Contact>> range(law, 0, rock, stiffness);
    forces_.add(rock, 0, range.padded_size());
    return range;
  }

  JointContacts<JointLawOf<Contact>> make_joints(const JointLawOf<Contact>& law) {
    if (!HasJoints<Contact> && !specimen_.joints.fractures.empty())
      refuse("specimen", "joints", std::to_string(specimen_.joints.fractures.size()) + " fractures",
             "empty for a contact law without joints; Jointed<law, SmoothJoint> has them");
    const std::size_t bonded = parted_.bonded.size() - parted_.of_rock;
    JointContacts<JointLawOf<Contact>> joints(law, rock_.padded_size(), std::move(parted_.joints),
                                              bonded, specimen_);
    const auto geometry = joints.geometry();
    forces_.add(geometry, rock_.padded_size(), joints.contacts().padded_size());
    for (std::size_t k = 0; k < bonded; ++k)
      uniform_strain_.add(geometry[k].frame, law.springs(joints.contacts().stiffness(k)),
                          norm(specimen_.centre[geometry[k].bodies.second] -
                               specimen_.centre[geometry[k].bodies.first]),
                          specimen_.width * specimen_.height);
    return joints;
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
    const ContactRange<JointLawOf<Contact>>& joints = joints_.contacts();
    ContactRange<SmoothPlaten> platens({}, joints.first_row() + joints.padded_size(),
                                       platen_geometry_, stiffness);
    forces_.add(platen_geometry_, platens.first_row(), platens.padded_size());
    return platens;
  }

  FrequencyBound frequency_bound() const {
    FrequencyBound bound(discs_);
    for (std::size_t c = 0; c < rock_.size(); ++c)
      bound.add(geometry()[c], rock_.law().springs(rock_.stiffness(c)));
    const JointLawOf<Contact>& joint = joints_.contacts().law();
    const auto joint_geometry = joints_.geometry();
    for (std::size_t k = 0; k < joints_.size(); ++k) {
      const double share = joints_.longest_share(k);
      bound.add(joint_geometry[k], joint.springs(joint.stiffness(share)));
    }
    for (std::size_t c = 0; c < platens_.size(); ++c)
      bound.add(platen_geometry_[c], platens_.law().springs(platens_.stiffness(c)));
    return bound;
  }

  Disc disc(Index i) const { return {specimen_.radius[i]}; }

  Specimen specimen_;
  Discs discs_;
  PartedContacts parted_;
  std::vector<ContactGeometry> platen_geometry_;
  Loading loading_;
  ForceRows forces_;
  UniformStrainModulus uniform_strain_;
  ContactRange<RockLawOf<Contact>> rock_;
  JointContacts<JointLawOf<Contact>> joints_;
  ContactRange<SmoothPlaten> platens_;
  Sweep sweep_;
  DiscMotion motion_;
  SpringBound springs_;
  double lever_ = 0;        ///< no arm and no radius is longer, m
  bool to_sweep_ = false;   ///< `move` is to find the forces in the rock
  double step_factor_ = 0;  ///< mechanical time step times the largest frequency
  /// Discs move by less than a thousandth of their radius meanwhile.
  static constexpr long between_meetings = 100;
  long steps_ = 0;
};

}  // namespace hfdem
