/// @file
/// The contact model of several laws: bonded grains, and joints along natural fractures.
///
/// Each law owns a range of contacts of its own, so neither pays for the other.
#pragma once

#include <concepts>
#include <tuple>
#include <type_traits>

#include <hfdem/contact/smooth_joint.hpp>
#include <hfdem/state/concepts.hpp>

namespace hfdem {

/// A contact law for grains, and the law of the joints between them.
///
///     using Fractured = Simulator<Jointed<LinearParallelBond, SmoothJoint>, ...>;
///
/// To the grains it is their own law; the joints have a section `joints` among the parameters.
/// @tparam Rock between bonded grains
/// @tparam Joint between grains on either side of a natural fracture
template <ContactLaw Rock, JointLaw Joint = SmoothJoint>
class Jointed : public Rock {
 public:
  using RockPolicy = Rock;    ///< as composed
  using JointPolicy = Joint;  ///< as composed

  /// @param rock validated parameters of the grains' law
  /// @param joint validated parameters of the joints' law
  explicit Jointed(const typename Rock::Params& rock, const typename Joint::Params& joint = {})
      : Rock(rock), joint_(joint) {}

  const Joint& joint() const { return joint_; }  ///< with its parameters

 private:
  Joint joint_;
};

/// A contact law with joints.
template <class L>
concept HasJoints = requires {
  typename L::JointPolicy;
};

/// The joint law of a contact law without joints: of no contact, ever.
class NoJoint {
 public:
  /// None.
  struct Params {
    static constexpr auto fields() { return std::tuple{}; }
  };
  /// Nothing is fixed.
  template <class T>
  struct Stiffness {};
  /// Nothing evolves.
  template <class T>
  struct Memory {};
  /// No force.
  template <class T>
  struct Response {
    T normal_stress;                                          ///< Pa
    Memory<T> memory;                                         ///< empty
    Reaction<T> reaction() const { return {T{}, T{}, T{}}; }  ///< none
  };

  /// Nothing to set.
  explicit NoJoint(const Params& = {}) {}

  Stiffness<double> stiffness(double) const noexcept { return {}; }  ///< nothing
  /// Nothing either.
  Stiffness<double> broken(const Stiffness<double>& k) const noexcept { return k; }
  /// As it was.
  Stiffness<double> with_length(const Stiffness<double>& k, double) const noexcept { return k; }
  Springs springs(const Stiffness<double>&) const noexcept { return {}; }  ///< none
  double rest_width() const noexcept { return 0; }                         ///< m
  JointContent initially() const noexcept { return JointContent::dry; }    ///< nothing
  double dilation(const Memory<double>&) const noexcept { return 0; }      ///< m
  double slip(const Memory<double>&) const noexcept { return 0; }          ///< m

  /// No force.
  template <class T>
  Response<T> respond(const Stiffness<T>&, const Memory<T>&, const Motion<T>&) const noexcept {
    return {T{}, {}};
  }
  /// J per m.
  template <class T>
  T energy(const Stiffness<T>&, const Memory<T>&, const Motion<T>&) const noexcept {
    return {};
  }
  /// None.
  template <class T>
  Failure<T> failure(const Stiffness<T>&, const Response<T>&) const noexcept {
    return Failure<T>{.tension = {}, .shear = {}};
  }
};

namespace detail {
template <class Contact>
struct JointOf {
  using Rock = Contact;
  using Law = NoJoint;
  static Law of(const Contact&) { return Law{}; }
};
template <HasJoints Contact>
struct JointOf<Contact> {
  using Rock = typename Contact::RockPolicy;
  using Law = typename Contact::JointPolicy;
  static Law of(const Contact& contact) { return contact.joint(); }
};
}  // namespace detail

/// What bonded grains obey: the contact law itself, or the rock's where it has joints. Their loop
/// is then the same code with joints and without.
template <class Contact>
using RockLawOf = typename detail::JointOf<Contact>::Rock;
/// The joint law of any contact law: `NoJoint` where it has none.
template <class Contact>
using JointLawOf = typename detail::JointOf<Contact>::Law;

/// The joints of a contact law, with their parameters.
template <class Contact>
JointLawOf<Contact> joint_law(const Contact& contact) {
  return detail::JointOf<Contact>::of(contact);
}

}  // namespace hfdem
