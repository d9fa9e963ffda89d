/// @file
/// The books of mechanical energy: where the work of boundary and fluid goes.
///
/// In every mechanical step
///
///   work of platens or dead loads + work of the fluid
///     = change of elastic and of kinetic energy + friction + damping + set free by breaks
///       + switching of contacts
///
/// to round-off, and each entry is computed on its own, none as what the others leave. Central
/// differences know displacements u_n and forces F_n at whole steps and velocities at half steps;
/// with all work by the trapezoidal rule, (F_n + F_n+1) / 2 times (u_n+1 - u_n), the law of motion
/// gives exactly the change of m v_n-1/2 v_n+1/2 / 2, the kinetic energy at whole steps. A contact
/// law that is linear stores exactly the work that it receives; theory.md has the rest.
#pragma once

#include <array>
#include <cmath>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <hfdem/contact/jointed.hpp>
#include <hfdem/contact/smooth_platen.hpp>
#include <hfdem/mechanics/motion.hpp>
#include <hfdem/state/concepts.hpp>
#include <hfdem/state/discs.hpp>

namespace hfdem::measure {

/// Entries of a ledger since it was opened, J per m of thickness.
struct EnergyEntries {
  double boundary = 0;  ///< work that platens or dead loads have done on the discs
  double fluid = 0;     ///< work of the fluid's pressure, over the chords on which it pushes
  double elastic = 0;   ///< change of what contacts store
  double kinetic = 0;   ///< change of kinetic energy
  double friction = 0;  ///< spent on slip
  double damping = 0;   ///< spent on local damping
  double breaks = 0;    ///< set free by bonds that broke, or by joints shared out anew
  double switching =
      0;  ///< spent, or if negative made, by steps in which a contact opens or closes

  double work() const { return boundary + fluid; }              ///< of all that acts from outside
  double spent() const { return friction + damping + breaks; }  ///< gone for good
  /// What the entries account for.
  double accounted() const { return elastic + kinetic + spent() + switching; }
};

/// What a ledger has to know of one contact at one instant.
template <class Law>
struct ContactInstant {
  Motion<double> motion;                               ///< since bonding
  typename Law::template Stiffness<double> stiffness;  ///< without the bond if it has broken
  typename Law::template Memory<double> memory;        ///< after that motion
  double energy;                                       ///< that it stores, J per m
};

/// What a ledger has to know of one instant: that of a mechanical step before anything moves.
template <class Law>
struct EnergyInstant {
  long step = 0;                       ///< mechanical steps made before
  double dt = 0;                       ///< mechanical step that follows, s
  double moving = 0;                   ///< sum of m v^2 / 2 half a step before, J per m
  double pushed = 0;                   ///< sum of v F / 2, W per m: kinetic = moving + dt pushed
  std::vector<Pack> place;             ///< displacements of discs and platens
  std::vector<Pack> damped;            ///< per disc: what damping takes from the resultant
  std::vector<Vec2> fluid;             ///< per disc: force of the fluid, N per m
  std::array<Pack, 4> platen_force{};  ///< of the discs on each platen
  std::vector<ContactInstant<RockLawOf<Law>>> contacts;  ///< between discs of the rock
  std::vector<ContactInstant<JointLawOf<Law>>> joints;   ///< between discs on a natural fracture
  std::vector<ContactInstant<SmoothPlaten>> platens;     ///< on platens

  /// All of it.
  void exchange(auto& archive) {
    archive(step, dt, moving, pushed, place, damped, fluid, std::span<Pack>(platen_force), contacts,
            joints, platens);
  }
};

/// An observer of mechanical steps that keeps the books. It books what happens between two steps
/// that it hears of; where it misses some, as in `settle`, it goes on with the next ones. All sums
/// run over discs and contacts in their order, whatever the number of threads.
/// @tparam Law the simulator's contact law; its force is linear in the motion but for slip and for
///   opening and closing at zero: the books of any other close only as well as its steps are short
template <class Law>
class EnergyLedger {
  static_assert(StoresEnergy<Law>,
                "an energy ledger needs a contact law that says what a contact stores: a member "
                "energy(stiffness, memory, motion)");

 public:
  /// Books the step that led here.
  template <class Sim>
  void mechanical_step(const Sim& sim) {
    see(sim);
    if (!open_) {
      open_ = true;
      for (const auto& c : now_.contacts) stored_ += c.energy;
      for (const auto& c : now_.joints) stored_ += c.energy;
      for (const auto& c : now_.platens) stored_ += c.energy;
    } else if (now_.step == before_.step + 1) {
      book(sim);
    }
    std::swap(before_, now_);
  }

  const EnergyEntries& entries() const { return entries_; }  ///< since the first step heard of
  /// Sum of the sizes of what boundary and fluid did in each step, J per m.
  double work_done() const { return work_done_; }
  /// The work for which the entries do not account, over the work done, or over 1e-6 of the energy
  /// stored when the ledger was opened, if that is more.
  double relative_error() const {
    const double missing = std::abs(entries_.work() - entries_.accounted());
    return missing == 0 ? 0 : missing / std::fmax(work_done_, 1e-6 * stored_);
  }
  /// The largest of these after any step.
  double worst_relative_error() const { return worst_error_; }

  /// The books so far.
  void exchange(auto& archive) {
    archive(std::span<EnergyEntries>(&entries_, 1), work_done_, stored_, worst_error_, open_,
            before_);
  }

 private:
  /// Of the lanes (x, y, rotation) of a body's row; the fourth is the twin of the third.
  static double product(const Pack& a, const Pack& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  // ---- the present instant ----------------------------------------------------------------------

  template <class Sim>
  void see(const Sim& sim) {
    const Discs& discs = sim.discs();
    now_.step = sim.mechanical_steps() + sim.settling_steps();
    now_.place = discs.displacement;
    now_.damped.resize(discs.size());
    now_.fluid.resize(discs.size());
    now_.dt = sim.mechanical_dt();
    now_.moving = now_.pushed = 0;
    for (Index i = 0; i < discs.size(); ++i) {
      const Pack force =
          with_whole_torque(sim.forces().total(i) + Pack{discs.load[i].x, discs.load[i].y, 0, 0});
      const Pack& velocity = discs.velocity[i];
      const double m = discs.mass[i];
      now_.damped[i] = local_damping(sim.params().mechanics.damping, force, velocity);
      now_.fluid[i] = sim.network().force_on(i);
      now_.moving += 0.5 * product(velocity, velocity * Pack{m, m, discs.inertia(i), 0});
      now_.pushed += 0.5 * product(velocity, force - now_.damped[i]);
    }
    for (std::size_t p = 0; p < all_sides.size(); ++p)
      now_.platen_force[p] = sim.forces().total(discs.platen(all_sides[p]));
    see(sim.contacts(), now_.place, now_.contacts);
    see(sim.joints().contacts(), now_.place, now_.joints);
    see(sim.platens(), now_.place, now_.platens);
  }

  template <class Range, class Instants>
  static void see(const Range& range, std::span<const Pack> place, Instants& contacts) {
    contacts.resize(range.size());
    for (std::size_t c = 0; c < range.size(); ++c) {
      const auto motion = range.motion(c, place);
      const auto stiffness = range.stiffness(c);
      const auto memory = range.memory(c);
      contacts[c] = {motion, stiffness, memory, range.law().energy(stiffness, memory, motion)};
    }
  }

  // ---- what happened since the last one ---------------------------------------------------------

  template <class Sim>
  void book(const Sim& sim) {
    const double boundary = entries_.boundary, fluid = entries_.fluid;
    book_bodies(sim);
    book_contacts<RockLawOf<Law>>(sim.contacts().law(), before_.contacts, now_.contacts);
    book_contacts<JointLawOf<Law>>(sim.joints().contacts().law(), before_.joints, now_.joints);
    book_contacts<SmoothPlaten>(sim.platens().law(), before_.platens, now_.platens);
    work_done_ += std::abs(entries_.boundary - boundary) + std::abs(entries_.fluid - fluid);
    worst_error_ = std::fmax(worst_error_, relative_error());
  }

  template <class Sim>
  void book_bodies(const Sim& sim) {
    for (Index i = 0; i < sim.discs().size(); ++i) {
      const Pack way = now_.place[i] - before_.place[i];
      const Vec2 move{way[0], way[1]};
      entries_.fluid += dot(0.5 * (before_.fluid[i] + now_.fluid[i]), move);
      entries_.boundary += dot(sim.loading().dead_load(i), move);
      entries_.damping += product(0.5 * (before_.damped[i] + now_.damped[i]), way);
    }
    for (std::size_t p = 0; p < all_sides.size(); ++p) {
      const Index body = sim.discs().platen(all_sides[p]);
      const Pack on_platen = 0.5 * (before_.platen_force[p] + now_.platen_force[p]);
      entries_.boundary -= product(on_platen, now_.place[body] - before_.place[body]);
    }
    // m v_n-1/2 v_n+1/2 / 2, at both ends with the step between them: where the mechanical step
    // changes, the kinetic energy of that instant has two readings.
    entries_.kinetic += now_.moving - before_.moving + before_.dt * (now_.pushed - before_.pushed);
  }

  /// A contact whose bond broke in this step is taken as broken since its beginning, but for the
  /// energy stored then: what only the bond kept from slipping has slipped by then, too.
  template <class ThisLaw>
  void book_contacts(const ThisLaw& law, std::span<const ContactInstant<ThisLaw>> before,
                     std::span<const ContactInstant<ThisLaw>> now) {
    for (std::size_t c = 0; c < now.size(); ++c) {
      const auto& [from, earlier, slip_before, stored] = before[c];
      const auto& [to, k, new_slip, stores] = now[c];
      entries_.elastic += stores - stored;
      auto slip = slip_before;
      if (differ(earlier, k)) {
        slip = law.respond(k, slip_before, from).memory;
        book_change(law, before[c], now[c], slip);
      }
      // What a change of memory alone takes from the energy: the mean of before and after motion.
      if (differ(slip, new_slip))
        entries_.friction += 0.5 * (law.energy(k, slip, from) - law.energy(k, new_slip, from) +
                                    law.energy(k, slip, to) - law.energy(k, new_slip, to));
      // By Betti's theorem zero for what stays one spring.
      const double gap = opening(law, slip, from), new_gap = opening(law, new_slip, to);
      if ((gap > 0) != (new_gap > 0))
        entries_.switching += 0.5 * (law.respond(k, new_slip, to).reaction().normal * gap -
                                     law.respond(k, slip, from).reaction().normal * new_gap);
    }
  }

  /// How far a contact is open: a joint, beyond what its slip has lifted it.
  template <class ThisLaw, class Memory>
  static double opening(const ThisLaw& law, const Memory& memory, const Motion<double>& motion) {
    if constexpr (JointLaw<ThisLaw>)
      return motion.opening - law.dilation(memory);
    else
      return motion.opening;
  }

  /// A bond gives up what it stored, less what its last force still did while it fell to zero
  /// during the step. So does what one joint contact leaves to another.
  template <class ThisLaw, class Memory>
  void book_change(const ThisLaw& law, const ContactInstant<ThisLaw>& earlier,
                   const ContactInstant<ThisLaw>& now, const Memory& slip) {
    const auto& [from, whole, memory, stored] = earlier;
    const auto& [to, rest, new_memory, stores] = now;
    const Reaction<double> before = law.respond(whole, memory, from).reaction();
    const Reaction<double> after = law.respond(rest, slip, from).reaction();
    entries_.breaks += stored - law.energy(rest, slip, from) -
                       0.5 * ((before.normal - after.normal) * (to.opening - from.opening) +
                              (before.shear - after.shear) * (to.shear - from.shear) -
                              (before.moment - after.moment) * (to.rotation - from.rotation));
  }

  template <class Record>
  static bool differ(const Record& a, const Record& b) {
    if constexpr (std::is_empty_v<Record>)
      return false;
    else
      return std::memcmp(&a, &b, sizeof(Record)) != 0;
  }

  EnergyEntries entries_;
  double work_done_ = 0, stored_ = 0, worst_error_ = 0;
  bool open_ = false;
  EnergyInstant<Law> before_, now_;
};

}  // namespace hfdem::measure
