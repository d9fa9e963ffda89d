/// @file
/// The contacts of natural fractures: which discs they join, and which piece of its fracture each
/// stands for.
///
/// Every point of a fracture belongs to the contact whose crossing is nearest, so that stiffness
/// and strength per metre of fracture are the law's however the discs lie. Discs that meet across a
/// fracture later, because it closes or slides, take their share of it from then on; until then
/// their contact follows the slip there, but stands for no piece.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <hfdem/base/fields.hpp>
#include <hfdem/mechanics/contact_range.hpp>
#include <hfdem/state/contact.hpp>
#include <hfdem/state/discs.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// Bonded contacts by the law that they obey.
struct PartedContacts {
  std::vector<ContactGeometry> bonded{};  ///< those of the rock, then those of joints
  std::vector<Index> number{};            ///< of each in the list that was parted
  std::size_t of_rock = 0;                ///< how many are the rock's
  std::vector<JointPair> joints{};        ///< those of joints, then pairs that have not met

  /// @param contacts between all discs that bond, sorted by bodies
  /// @param across pairs of discs with a fracture between them, sorted by bodies
  PartedContacts(std::vector<ContactGeometry> contacts, std::span<const JointPair> across) {
    number.reserve(contacts.size());
    const auto before = [](const JointPair& p, const Pair& bodies) { return p.bodies < bodies; };
    const auto place = [&](const Pair& bodies) {
      const auto at = std::lower_bound(across.begin(), across.end(), bodies, before);
      return at != across.end() && at->bodies == bodies ? at - across.begin() : -1;
    };
    std::vector<bool> has_bond(across.size(), false);
    std::vector<Index> later;
    for (Index c = 0; c < contacts.size(); ++c) {
      const auto at = place(contacts[c].bodies);
      if (at < 0) {
        number.push_back(c);
      } else {
        later.push_back(c);
        joints.push_back(across[static_cast<std::size_t>(at)]);
        has_bond[static_cast<std::size_t>(at)] = true;
      }
    }
    of_rock = number.size();
    number.insert(number.end(), later.begin(), later.end());
    if (later.empty()) {
      bonded = std::move(contacts);
    } else {
      bonded.reserve(number.size());
      for (const Index c : number) bonded.push_back(contacts[c]);
    }
    for (std::size_t k = 0; k < across.size(); ++k)
      if (!has_bond[k]) joints.push_back(across[k]);
  }
};

/// A piece of a natural fracture, m from its end `from`.
struct FracturePiece {
  double begin = 0, end = 0;                     ///< m
  double length() const { return end - begin; }  ///< m
};

/// All joints of a specimen.
/// @tparam Law a `JointLaw`
template <class Law>
class JointContacts {
 public:
  /// @param law of all joints
  /// @param first_row of the contacts' force rows
  /// @param joints as `PartedContacts` lists them
  /// @param bonded how many of these have a bond; the others have not met
  /// @param specimen gives fractures, radii and the gap up to which discs touch
  JointContacts(const Law& law, std::size_t first_row, std::vector<JointPair> joints,
                std::size_t bonded, const Specimen& specimen)
      : pairs_(std::move(joints)),
        fractures_(specimen.joints.fractures),
        bonded_(bonded),
        bonding_gap_(specimen.bonding_gap),
        met_(pairs_.size(), false),
        piece_(pairs_.size()),
        along_(fractures_.size()),
        range_(law, first_row, geometry(),
               std::vector(pairs_.size(), law.broken(law.stiffness(0)))) {
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      along_[pairs_[k].fracture].push_back(k);
      if (k >= bonded_) continue;
      met_[k] = true;
      range_.set_stiffness(k, law.stiffness(0));
    }
    for (auto& contacts : along_)
      std::stable_sort(contacts.begin(), contacts.end(), [&](std::size_t a, std::size_t b) {
        return pairs_[a].along < pairs_[b].along;
      });
    for (std::size_t f = 0; f < fractures_.size(); ++f) share_out(f);
  }

  /// Their motion, force and state; discs that have not met feel nothing.
  const ContactRange<Law>& contacts() const { return range_; }
  ContactRange<Law>& contacts() { return range_; }               ///< to be evaluated
  std::size_t size() const { return pairs_.size(); }             ///< pairs, met or not
  std::size_t bonded() const { return bonded_; }                 ///< the first so many had a bond
  bool has_met(std::size_t joint) const { return met_[joint]; }  ///< or was bonded
  const JointPair& pair(std::size_t joint) const { return pairs_[joint]; }       ///< its discs
  const FracturePiece& piece(std::size_t joint) const { return piece_[joint]; }  ///< its share
  std::span<const NaturalFracture> fractures() const { return fractures_; }      ///< as given

  /// Bodies and frames: along the fracture, without arms.
  std::vector<ContactGeometry> geometry() const {
    std::vector<ContactGeometry> all;
    for (const JointPair& p : pairs_) all.push_back({p.bodies, {p.normal.x, p.normal.y, 0, 0}});
    return all;
  }

  /// Where the line between the centres crosses the fracture, m.
  Vec2 crossing(std::size_t joint) const {
    const NaturalFracture& f = fractures_[pairs_[joint].fracture];
    return f.from + pairs_[joint].along * f.direction();
  }
  /// The ends of the piece that a contact stands for, m.
  std::pair<Vec2, Vec2> ends(std::size_t joint) const {
    const NaturalFracture& f = fractures_[pairs_[joint].fracture];
    return {f.from + piece_[joint].begin * f.direction(),
            f.from + piece_[joint].end * f.direction()};
  }

  /// No shorter than the piece that a contact stands for now or later, when its discs have met:
  /// that piece is part of what others stand for now.
  double longest_share(std::size_t joint) const {
    double longest = 0;
    for (const std::size_t k : along_[pairs_[joint].fracture])
      longest = std::fmax(longest, piece_[k].length());
    // One that comes between two others takes half of both.
    return longest > 0 ? longest : fractures_[pairs_[joint].fracture].length();
  }

  /// Refuses the fracture of a joint.
  /// @throws InvalidParameter naming it
  [[noreturn]] void refuse(std::size_t joint, std::string_view allowed) const {
    const Index fracture = pairs_[joint].fracture;
    const auto& [from, to] = fractures_[fracture];
    hfdem::refuse("specimen", "joints",
                  std::string("fracture ").append(std::to_string(fracture)) + " from " +
                      to_text(from) + " to " + to_text(to) + " m",
                  allowed);
  }

  /// Makes joint contacts of discs that have come as near as discs that bond.
  void meet(const Discs& discs) {
    for (std::size_t k = bonded_; k < pairs_.size(); ++k) {
      if (met_[k] || gap(discs, pairs_[k].bodies) > bonding_gap_) continue;
      met_[k] = true;
      share_out(pairs_[k].fracture);
    }
  }

  /// What has met, and the state of the contacts.
  void exchange(auto& archive) {
    archive(met_, range_);
    for (std::size_t f = 0; f < fractures_.size(); ++f) share_out(f);
  }

 private:
  static double gap(const Discs& discs, Pair p) {
    const Pack d = discs.displacement[p.second] - discs.displacement[p.first];
    return norm(discs.centre[p.second] - discs.centre[p.first] + Vec2{d[0], d[1]}) -
           discs.radius[p.first] - discs.radius[p.second];
  }

  /// Gives each point of a fracture to the nearest of the contacts that have met.
  void share_out(std::size_t fracture) {
    double begin = 0;
    std::size_t last = pairs_.size();
    for (const std::size_t k : along_[fracture]) {
      if (!met_[k]) continue;
      if (last < pairs_.size()) {
        const double between = 0.5 * (pairs_[last].along + pairs_[k].along);
        give(last, {begin, between});
        begin = between;
      }
      last = k;
    }
    if (last < pairs_.size()) give(last, {begin, fractures_[fracture].length()});
  }
  void give(std::size_t joint, FracturePiece piece) {
    piece_[joint] = piece;
    range_.set_stiffness(joint, range_.law().with_length(range_.stiffness(joint), piece.length()));
  }

  std::vector<JointPair> pairs_;
  std::vector<NaturalFracture> fractures_;
  std::size_t bonded_;
  double bonding_gap_;
  std::vector<bool> met_;
  std::vector<FracturePiece> piece_;
  std::vector<std::vector<std::size_t>> along_;  // per fracture, its pairs from end to end
  ContactRange<Law> range_;
};

}  // namespace hfdem
