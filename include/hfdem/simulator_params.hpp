/// @file
/// Everything that a run can be told, as a tree: the sections of the parameter file.
#pragma once

#include <tuple>

#include <hfdem/base/fields.hpp>
#include <hfdem/contact/jointed.hpp>
#include <hfdem/fluid/newtonian.hpp>
#include <hfdem/leakoff/none.hpp>
#include <hfdem/mechanics/loading.hpp>
#include <hfdem/setup/flow_domains.hpp>
#include <hfdem/setup/preset_crack.hpp>
#include <hfdem/state/concepts.hpp>
#include <hfdem/state/injection.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// How a specimen is brought towards equilibrium.
struct Mechanics {
  double damping = 0.7;
  double step_fraction = 0.97;
  double settle_tolerance = 1e-4;
  int max_settle_steps = 100000;

  static constexpr auto fields() {
    using P = Mechanics;
    return std::tuple{
        Field{"damping", &P::damping, "", Range{0, 1, false, true}, "local damping coefficient"},
        Field{"step_fraction", &P::step_fraction, "", Range{0, 1, true},
              "mechanical time step over the longest stable one"},
        Field{"settle_tolerance", &P::settle_tolerance, "", positive,
              "largest resultant on a disc over the mean contact force, once settled"},
        Field{"max_settle_steps", &P::max_settle_steps, "", Range{20},
              "mechanical steps after which settling gives up"}};
  }
};

/// The law of a scheme's fluid; a scheme that asks for none takes any, and uses nothing of it.
template <class Pressure>
struct FluidOfScheme {
  using type = NewtonianFluid;  ///< it
};
/// The scheme's own.
template <FlowScheme Pressure>
struct FluidOfScheme<Pressure> {
  using type = typename Pressure::Fluid;  ///< it
};
/// That of a scheme.
template <class Pressure>
using FluidOf = typename FluidOfScheme<Pressure>::type;

/// What a scheme's crack loses into the rock; nothing if the scheme does not say.
template <class Pressure>
struct LeakoffOfScheme {
  using type = NoLeakoff;  ///< it
};
/// The scheme's own.
template <names_leakoff Pressure>
struct LeakoffOfScheme<Pressure> {
  using type = typename Pressure::Leakoff;  ///< it
};
/// That of a scheme.
template <class Pressure>
using LeakoffOf = typename LeakoffOfScheme<Pressure>::type;

/// One section per policy and per part of the model.
template <class Contact, class Aperture, class Pressure>
struct SimulatorParams {
  typename Contact::Params contact{};             ///< of the contact law
  typename JointLawOf<Contact>::Params joints{};  ///< of its joints, if it has any
  typename Aperture::Params aperture{};           ///< of the aperture law
  FlowChannels channels{};                        ///< of the fluid network
  Loading::Params boundary{};                     ///< what holds the specimen
  Stress in_situ{};                            ///< before injection, and on the boundary during it
  PresetCrack crack{};                         ///< where the fluid enters
  Injection injection{};                       ///< how much of it, when and where
  typename FluidOf<Pressure>::Params fluid{};  ///< its properties
  typename LeakoffOf<Pressure>::Params leakoff{};  ///< of what the crack loses, if it does
  Mechanics mechanics{};                           ///< mechanical steps
  typename Pressure::Params scheme{};              ///< of the pressure scheme

  /// The table of these sections.
  static constexpr auto sections() {
    using P = SimulatorParams;
    const auto joints = [] {
      if constexpr (HasJoints<Contact>)
        return std::tuple{Section{"joints", &P::joints}};
      else
        return std::tuple{};
    };
    const auto leakoff = [] {
      if constexpr (LeakoffOf<Pressure>::leaks)
        return std::tuple{Section{"leakoff", &P::leakoff}};
      else
        return std::tuple{};
    };
    return std::tuple_cat(
        std::tuple{Section{"contact", &P::contact}}, joints(),
        std::tuple{Section{"aperture", &P::aperture}, Section{"channels", &P::channels},
                   Section{"boundary", &P::boundary}, Section{"in_situ", &P::in_situ},
                   Section{"crack", &P::crack}, Section{"injection", &P::injection},
                   Section{"fluid", &P::fluid}},
        leakoff(), std::tuple{Section{"mechanics", &P::mechanics}, Section{"scheme", &P::scheme}});
  }

  /// Checks every section, and the order of the injection's schedule.
  /// @throws InvalidParameter naming the field, its value and the allowed range
  void validate() const {
    for_each_section(*this, [](std::string_view name, const auto& s) { hfdem::validate(s, name); });
    injection.check();
  }
};

}  // namespace hfdem
