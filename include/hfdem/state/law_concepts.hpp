/// @file
/// What a law of contacts or joints must offer: the concepts of concepts.hpp that the contact loop
/// and what lies below it need.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include <hfdem/base/fields.hpp>
#include <hfdem/state/contact.hpp>

namespace hfdem {

/// Nested `Params`: an aggregate with documented defaults and a table of its fields.
template <class P>
concept has_described_params = std::is_aggregate_v<typename P::Params> &&
    std::default_initializable<typename P::Params> && Described<typename P::Params>;

/// The policy is made from its parameters.
template <class P>
concept constructible_from_params = std::constructible_from<P, const typename P::Params&>;

// ---- contact law ------------------------------------------------------------------------------

/// `Stiffness<T>`: what is fixed per contact, an aggregate of values of type T.
template <class L>
concept has_stiffness_record = std::is_aggregate_v<typename L::template Stiffness<double>> &&
    std::is_aggregate_v<typename L::template Stiffness<Pack>>;

/// `Memory<T>`: what evolves per contact, an aggregate of values of type T, possibly empty.
template <class L>
concept has_memory_record = std::is_aggregate_v<typename L::template Memory<double>> &&
    std::is_aggregate_v<typename L::template Memory<Pack>>;

/// `stiffness(disc, disc)` gives the stiffness of a new contact.
template <class L>
concept gives_stiffness_of_two_discs = requires(const L& law, Disc disc) {
  { law.stiffness(disc, disc) }
  noexcept->std::same_as<typename L::template Stiffness<double>>;
};

/// `springs(stiffness)` gives bounds on the tangent stiffness, for the stable time step.
template <class L>
concept gives_springs = requires(const L& law,
                                 const typename L::template Stiffness<double>& stiffness) {
  { law.springs(stiffness) }
  noexcept->std::same_as<Springs>;
};

/// What a law's `respond` returns.
template <class L, class T>
using ResponseOf = decltype(std::declval<const L&>().respond(
    std::declval<const typename L::template Stiffness<T>&>(),
    std::declval<const typename L::template Memory<T>&>(), std::declval<const Motion<T>&>()));

/// `responds_to_motion` for one value type.
template <class L, class T>
concept responds_for_value_type = requires(const L& law,
                                           const typename L::template Stiffness<T>& stiffness,
                                           const typename L::template Memory<T>& memory,
                                           const Motion<T>& motion) {
  { law.respond(stiffness, memory, motion).reaction() } -> std::same_as<Reaction<T>>;
  {
    law.respond(stiffness, memory, motion).memory
    } -> std::convertible_to<typename L::template Memory<T>>;
};

/// `respond(stiffness, memory, motion)` gives a response with `reaction()` and the new `memory`,
/// for one contact (double) and for four (Pack).
template <class L>
concept responds_to_motion = responds_for_value_type<L, double> && responds_for_value_type<L, Pack>;

/// `tells_failure` for one value type.
template <class L, class T>
concept fails_for_value_type = requires(const L& law,
                                        const typename L::template Stiffness<T>& stiffness,
                                        const typename L::template Memory<T>& memory,
                                        const Motion<T>& motion) {
  { law.failure(stiffness, law.respond(stiffness, memory, motion)) } -> std::same_as<Failure<T>>;
};

/// `failure(stiffness, response)` says which bonds are over their strength.
template <class L>
concept tells_failure = fails_for_value_type<L, double> && fails_for_value_type<L, Pack>;

/// `broken(stiffness)` gives what is left of a contact whose bond has broken.
template <class L>
concept gives_broken_stiffness = requires(const L& law,
                                          const typename L::template Stiffness<double>& stiffness) {
  { law.broken(stiffness) }
  noexcept->std::same_as<typename L::template Stiffness<double>>;
};

/// What the contact loop needs of any law.
template <class L>
concept RespondingLaw =
    has_stiffness_record<L> && has_memory_record<L> && responds_to_motion<L> && gives_springs<L>;

/// A law whose bonds can break.
template <class L>
concept BreakableLaw = RespondingLaw<L> && tells_failure<L> && gives_broken_stiffness<L>;

/// The contact law between bonded discs.
template <class L>
concept ContactLaw = has_described_params<L> && constructible_from_params<L> &&
    gives_stiffness_of_two_discs<L> && BreakableLaw<L>;

/// `energy(stiffness, memory, motion)` gives what a contact stores, J per m.
template <class L>
concept gives_energy = requires(const L& law,
                                const typename L::template Stiffness<double>& stiffness,
                                const typename L::template Memory<double>& memory,
                                const Motion<double>& motion) {
  { law.energy(stiffness, memory, motion) }
  noexcept->std::same_as<double>;
};

/// A law whose energy can be booked. Simulators need none; ledgers of energy do.
template <class L>
concept StoresEnergy = RespondingLaw<L> && gives_energy<L>;

/// A contact law whose bonds are not all alike: `varied(stiffness, contact)` makes the stiffness of
/// a new contact its own.
template <class L>
concept VaryingLaw = ContactLaw<L> &&
    requires(const L& law, const typename L::template Stiffness<double>& k) {
  { law.varied(k, Index{}) }
  noexcept->std::same_as<typename L::template Stiffness<double>>;
};

namespace detail {
template <class Member>
struct ClassOf;
template <class Class, class Function>
struct ClassOf<Function Class::*> {
  using Type = Class;
};
template <class Member>
using class_of = typename ClassOf<Member>::Type;
}  // namespace detail

/// `margin(stiffness, response)` for one value type: how far a contact may still move before its
/// bond can fail, m. It counts only if it comes from the class that says how the contact responds
/// and fails, or from one derived of it: a law that changes either of another law's formulas does
/// not inherit its margin.
template <class L, class T>
concept foresees_failure_for_value_type =
    std::derived_from<detail::class_of<decltype(&L::template margin<T>)>,
                      detail::class_of<decltype(&L::template failure<T>)>> &&
    std::derived_from<detail::class_of<decltype(&L::template margin<T>)>,
                      detail::class_of<decltype(&L::template respond<T>)>> &&
    requires(const L& law, const typename L::template Stiffness<T>& stiffness,
             const typename L::template Memory<T>& memory, const Motion<T>& motion) {
  { law.margin(stiffness, law.respond(stiffness, memory, motion)) } -> std::same_as<T>;
};

/// A law that says how far its bonds are from failing, so that the loop need not ask whether they
/// do in every step: no bond fails while |change of opening| + |change of shear| + |change of
/// rotation| times the smaller disc's radius stays below the margin. Other laws are asked.
template <class L>
concept ForeseesFailure = BreakableLaw<L> && foresees_failure_for_value_type<L, double> &&
    foresees_failure_for_value_type<L, Pack>;

// ---- joint law ----------------------------------------------------------------------------------

/// `stiffness(length)` gives a new contact that stands for so many metres of fracture;
/// `with_length` the same contact with another share.
template <class J>
concept gives_stiffness_of_length = requires(const J& law,
                                             const typename J::template Stiffness<double>& k,
                                             double length) {
  { law.stiffness(length) }
  noexcept->std::same_as<typename J::template Stiffness<double>>;
  { law.with_length(k, length) }
  noexcept->std::same_as<typename J::template Stiffness<double>>;
};

/// `slip(memory)` and `dilation(memory)`: how far the joint has slid, and what that has opened, m.
template <class J>
concept tells_slip = requires(const J& law, const typename J::template Memory<double>& memory) {
  { law.slip(memory) }
  noexcept->std::same_as<double>;
  { law.dilation(memory) }
  noexcept->std::same_as<double>;
};

/// `rest_width()` gives the aperture at zero force, w0, m.
template <class A>
concept gives_rest_width = requires(const A& law) {
  { law.rest_width() }
  noexcept->std::same_as<double>;
};

/// Its response knows the `normal_stress` on the fracture, Pa, compression positive.
template <class J>
concept tells_normal_stress = requires(const J& law,
                                       const typename J::template Stiffness<double>& k,
                                       const typename J::template Memory<double>& memory) {
  { law.respond(k, memory, Motion<double>{}).normal_stress } -> std::convertible_to<double>;
};

/// `initially()` says whether fluid is in the joint before the injected one comes.
template <class J>
concept tells_content = requires(const J& law) {
  { law.initially() }
  noexcept;
};

/// The contact law between discs on either side of a natural fracture.
template <class J>
concept JointLaw = has_described_params<J> && constructible_from_params<J> &&
    gives_stiffness_of_length<J> && BreakableLaw<J> && tells_slip<J> && tells_normal_stress<J> &&
    gives_rest_width<J> && tells_content<J>;

}  // namespace hfdem
