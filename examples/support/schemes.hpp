/// @file
/// The pressure schemes that programs offer: their choice on the command line, and what reports say
/// of them.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <hfdem/analytic/kgd_general.hpp>
#include <hfdem/pressure/conventional.hpp>
#include <hfdem/pressure/implicit.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/simulator_params.hpp>

#include <CLI/CLI.hpp>

#include "support/command_line.hpp"
#include "support/injected.hpp"

namespace hfdem::support {

/// What reports say of a scheme.
struct SchemeWords {
  std::string_view name;       ///< on the command line
  std::string_view rule;       ///< in summary.json: when a fluid step ends
  std::string_view ends;       ///< the same in words: "a fluid step ends ..."
  std::string_view driven_by;  ///< "a crack driven by ..."
  std::string_view steps;      ///< "fluid steps ..."
};
inline SchemeWords words_of(const UniformPressure::Params& p) {
  return p.equilibrium ? SchemeWords{"uniform", "equilibrium", "at equilibrium", "uniform pressure",
                                     "under equilibrium control"}
                       : SchemeWords{"uniform", "paper", "by the paper's rule", "uniform pressure",
                                     "by the paper's rule"};
}
inline SchemeWords words_of(const ConventionalFlowParams&) {
  return {"conventional", "explicit", "after one mechanical step", "a flowing fluid",
          "with explicit flow"};
}
inline SchemeWords words_of(const ImplicitFlowParams&) {
  return {"implicit", "equilibrium", "at equilibrium", "a flowing fluid", "with implicit flow"};
}

/// The scheme of a simulator.
template <class Sim>
using SchemeOf = std::remove_cvref_t<decltype(std::declval<const Sim&>().pressure_scheme())>;
/// Whether viscosity matters in the crack of a simulator.
template <class Sim>
inline constexpr bool flows =
    FlowScheme<SchemeOf<Sim>> &&
    !std::is_same_v<typename SchemeOf<Sim>::Params, UniformPressure::Params>;
/// Whether its crack loses fluid.
template <class Sim>
inline constexpr bool leaks = LeakoffOf<SchemeOf<Sim>>::leaks;
/// Whether that flows through the rock.
template <class Sim>
inline constexpr bool seeps = FlowsThroughRock<SchemeOf<Sim>>;

/// The fluid in a caption: " of a fluid of 100 cp"; nothing where its viscosity does not matter.
template <class Sim>
std::string said_fluid(const typename Sim::Params& p) {
  if constexpr (flows<Sim>) return " of a fluid of " + in_words(p.fluid.viscosity * 1e3) + " cp";
  return "";
}

/// The KGD fracture in an infinite plane for what a run has injected, whose volume is not zero.
/// @param E_prime Pa @param K_IC Pa sqrt(m) @param viscosity Pa s @param time s
inline analytic::KgdFracture kgd_with_viscosity(const Injection& injection, double E_prime,
                                                double K_IC, double viscosity, double time) {
  return analytic::general_kgd({.E_prime = E_prime,
                                .K_IC = K_IC,
                                .viscosity = viscosity,
                                .rate = InjectionRate(injection).volume(0, time) / time,
                                .time = time});
}

/// The same as a reference for a run: the toughness vertex where viscosity does not matter.
/// @param E_prime Pa @param K_IC Pa sqrt(m) @param time s
template <class Sim>
analytic::KgdFracture reference_kgd(const typename Sim::Params& p, double E_prime, double K_IC,
                                    double time) {
  if (!flows<Sim> || !(InjectionRate(p.injection).volume(0, time) > 0))
    return toughness_vertex(E_prime, K_IC, p.injection, time);
  return kgd_with_viscosity(p.injection, E_prime, K_IC, p.fluid.viscosity, time);
}

/// A sentence on what uniform pressure leaves out, where that is much; nothing for fluids that
/// flow. @param E_prime Pa @param K_IC Pa sqrt(m) @param time s
template <class Sim>
std::string viscosity_left_out(const typename Sim::Params& p, double E_prime, double K_IC,
                               double time) {
  constexpr double much = 0.1, most_viscous = 1e20;  // for the KGD solution
  if (flows<Sim> || !(InjectionRate(p.injection).volume(0, time) > 0)) return "";
  const double with =
      kgd_with_viscosity(p.injection, E_prime, K_IC, min(p.fluid.viscosity, most_viscous), time)
          .half_length;
  const double without = kgd_with_viscosity(p.injection, E_prime, K_IC, 0, time).half_length;
  const double shorter = 1 - with / without;
  if (!(shorter > much)) return "";
  char percent[16];
  std::snprintf(percent, sizeof percent, "%.0f", 100 * shorter);
  return "Uniform pressure leaves viscosity out: " + in_words(p.fluid.viscosity * 1e3) +
         " cp make the KGD fracture " + percent +
         " % shorter. With --scheme implicit the fluid flows.";
}

/// Which one a program is to run.
class SchemeChoice {
 public:
  /// @param offered names of schemes
  template <class Names>
  void add_to(CLI::App& app, const Names& offered) {
    app.add_option("--scheme", asked_,
                   "pressure scheme; by default that of the parameter file or of the case")
        ->check(CLI::IsMember(offered))
        ->excludes("--resume");
  }

  /// The one that was asked for, or whose parameters the file has, or else the usual one.
  std::string name(const CommandLine& options, const std::string& usual) const {
    if (!asked_.empty()) return asked_;
    if (options.config.empty()) return usual;
    const auto settings = read_toml(options.config);
    for (const std::string& name :
         {usual, std::string("uniform"), std::string("conventional"), std::string("implicit")})
      if (knows_all(name, settings)) return name;
    return usual;  // which will say what it does not know
  }

 private:
  template <class Scheme>
  static bool knows(const std::string& key) {
    bool known = false;
    for_each_field<typename Scheme::Params>(
        [&](const auto& field) { known = known || field.name == key; });
    return known;
  }

  static bool knows_all(const std::string& name, const std::vector<Setting>& settings) {
    for (const Setting& s : settings) {
      if (s.section != "scheme") continue;
      const bool known = name == "uniform"        ? knows<UniformPressure>(s.key)
                         : name == "conventional" ? knows<ConventionalFlow<>>(s.key)
                                                  : knows<ImplicitFlow<>>(s.key);
      if (!known) return false;
    }
    return true;
  }

  std::string asked_;
};

}  // namespace hfdem::support
