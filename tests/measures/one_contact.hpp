// Two discs and the contact between them, led by hand: as much of a simulator as a ledger of energy
// looks at.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <hfdem/contact/smooth_platen.hpp>
#include <hfdem/measure/energy_ledger.hpp>
#include <hfdem/mechanics/contact_range.hpp>
#include <hfdem/mechanics/force_rows.hpp>
#include <hfdem/mechanics/joint_contacts.hpp>
#include <hfdem/simulator_observers.hpp>

#include "laws/sample_rock.hpp"

namespace test {

class OneContact {
 public:
  /// The contact lies along x, and moves with its second disc alone.
  void lead_to(const Move& motion) {
    discs_.displacement[1] =
        hfdem::Pack{motion.opening,
                    motion.shear + (frame_.arm_mean + frame_.arm_half_difference) * motion.rotation,
                    motion.rotation, motion.rotation};
    contacts_.evaluate(discs_.displacement, forces_.rows(), 1);
    ledger_.mechanical_step(*this);
    ++steps_;
  }
  /// With the next motion.
  void break_bond() { contacts_.break_bond(0); }
  const hfdem::measure::EnergyEntries& entries() const { return ledger_.entries(); }

  // ---- what a ledger reads ----------------------------------------------------------------------

  struct Params {
    struct {
      double damping = 0;
    } mechanics;
  };
  struct NoFluid {
    hfdem::Vec2 force_on(hfdem::Index) const { return {}; }
  };
  struct NoLoading {
    hfdem::Vec2 dead_load(hfdem::Index) const { return {}; }
  };
  long mechanical_steps() const { return steps_; }
  long settling_steps() const { return 0; }
  double mechanical_dt() const { return 1e-6; }
  Params params() const { return {}; }
  NoFluid network() const { return {}; }
  NoLoading loading() const { return {}; }
  const hfdem::Discs& discs() const { return discs_; }
  const hfdem::ForceRows& forces() const { return forces_; }
  const hfdem::ContactRange<Bond>& contacts() const { return contacts_; }
  const hfdem::ContactRange<hfdem::SmoothPlaten>& platens() const { return platens_; }
  const hfdem::JointContacts<hfdem::NoJoint>& joints() const { return joints_; }

 private:
  static hfdem::Specimen two_discs() {
    hfdem::Specimen s;
    s.centre = {{0, 0}, {sample::length, 0}};
    s.radius = {small_disc.radius, large_disc.radius};
    return s;
  }

  hfdem::ForceRows arranged() const {
    hfdem::ForceRows rows(discs_.size() + 4);
    rows.add(geometry_, 0, hfdem::pack_width);
    rows.arrange();
    return rows;
  }

  hfdem::Discs discs_{two_discs()};
  hfdem::Frame<double> frame_{1, 0, 4e-3, 1e-3};
  std::array<hfdem::ContactGeometry, 1> geometry_{{{{0, 1}, frame_}}};
  std::array<Bond::Stiffness<double>, 1> stiffness_{
      Bond(sample_rock).stiffness(small_disc, large_disc)};
  hfdem::ContactRange<Bond> contacts_{Bond(sample_rock), 0, geometry_, stiffness_};
  hfdem::ContactRange<hfdem::SmoothPlaten> platens_{{}, hfdem::pack_width, {}, {}};
  hfdem::ForceRows forces_ = arranged();
  hfdem::JointContacts<hfdem::NoJoint> joints_{hfdem::NoJoint(), hfdem::pack_width, {}, 0, {}};
  hfdem::measure::EnergyLedger<Bond> ledger_;
  long steps_ = 0;
};

}  // namespace test
