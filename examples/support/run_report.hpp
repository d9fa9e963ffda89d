/// @file
/// What the reports of all programs have in common: parameters, how the run went, where it comes
/// from.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <hfdem/observe/report.hpp>

#include "support/manifest.hpp"
#include "support/run_options.hpp"
#include "support/settings.hpp"

namespace hfdem::support {

/// A value and its unit as a person says them: 17e9 and "Pa" are 17 and "GPa".
struct Said {
  std::string value, unit;
  std::string both() const { return unit.empty() ? value : value + "\u00a0" + unit; }
};

namespace detail {

/// Twelve digits, so that 8e6 / 1e6 is 8, and powers of ten as they are written by hand.
inline std::string said_number(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.12g", std::abs(value));
  std::string words(text.data());
  if (const auto e = words.find('e'); e != std::string::npos) {
    const int power = std::stoi(words.substr(e + 1));
    words = words.substr(0, e) + " × 10^{" + (power < 0 ? "−" : "") +
            std::to_string(std::abs(power)) + "}";
  }
  return (value < 0 ? "−" : "") + words;
}

/// A unit of the field tables, and another one for values from `least` on.
struct SaidUnit {
  std::string_view unit;
  double least;
  std::string_view said;
  double factor;
};
inline constexpr std::array said_units{
    SaidUnit{"Pa", 1e9, "GPa", 1e9},   SaidUnit{"Pa", 1e6, "MPa", 1e6},
    SaidUnit{"Pa", 1e3, "kPa", 1e3},   SaidUnit{"m", 0.1, "m", 1},
    SaidUnit{"m", 1e-3, "mm", 1e-3},   SaidUnit{"m", 1e-9, "µm", 1e-6},
    SaidUnit{"s", 0.01, "s", 1},       SaidUnit{"s", 1e-3, "ms", 1e-3},
    SaidUnit{"s", 1e-9, "µs", 1e-6},   SaidUnit{"m2/s", 0, "m²/s", 1},
    SaidUnit{"m3/s", 0, "m³/s", 1},    SaidUnit{"kg/m3", 0, "kg/m³", 1},
    SaidUnit{"N/m", 1e3, "kN/m", 1e3}, SaidUnit{"Pa s", 0, "mPa·s", 1e-3},
    SaidUnit{"deg", 0, "°", 1}};

}  // namespace detail

inline Said said(double value, std::string_view unit) {
  for (const detail::SaidUnit& u : detail::said_units)
    if (u.unit == unit && std::abs(value) >= u.least)
      return {detail::said_number(value / u.factor), std::string(u.said)};
  return {detail::said_number(value), std::string(unit)};
}

/// A count with its thousands apart: 15 340.
inline std::string said(long count) {
  std::string digits = std::to_string(count);
  for (std::size_t k = digits.size(); digits.size() > 4 && k > 3;) digits.insert(k -= 3, "\u202f");
  return digits;
}

namespace detail {

template <class T>
Said said_field(const T& value, std::string_view unit) {
  if constexpr (is_optional<T>) {
    return value ? said_field(*value, unit) : Said{"not set", ""};
  } else if constexpr (is_list<T>) {
    return value.empty() ? Said{"not set", ""} : Said{toml_value(value), std::string(unit)};
  } else if constexpr (std::is_same_v<T, double>) {
    return said(value, unit);
  } else if constexpr (std::is_same_v<T, int>) {
    return {said(long{value}), std::string(unit)};
  } else if constexpr (std::is_same_v<T, Vec2>) {
    return {"(" + said_number(value.x) + ", " + said_number(value.y) + ")", std::string(unit)};
  } else if constexpr (std::is_enum_v<T>) {
    return {std::string(names_of<T>[static_cast<std::size_t>(value)]), std::string(unit)};
  } else {
    return {toml_value(value), std::string(unit)};
  }
}

/// The value as a parameter file has it; empty if it is not set.
template <class T>
std::string exact(const T& value) {
  return is_left_out(value) ? "" : toml_value(value);
}

/// Calls `f(section, field, value)` for every parameter of a tree.
template <class Tree, class F>
void for_each_value(const Tree& tree, F&& f) {
  tree.for_each_section([&](std::string_view name, const auto& section) {
    for_each_field<std::remove_cvref_t<decltype(section)>>(
        [&](const auto& field) { f(name, field, section.*(field.member)); });
  });
}

}  // namespace detail

/// Every parameter of a run; those that are not set and have no default are left out.
template <class Tree>
std::vector<observe::Parameter> listed(const Tree& tree, const Tree& defaults) {
  struct Usual {
    std::string exact;
    Said said;
  };
  std::vector<Usual> usual;
  detail::for_each_value(defaults, [&](std::string_view, const auto& f, const auto& value) {
    usual.push_back({detail::exact(value), detail::said_field(value, f.unit)});
  });
  std::vector<observe::Parameter> parameters;
  std::size_t k = 0;
  detail::for_each_value(tree, [&](std::string_view section, const auto& f, const auto& value) {
    const Usual& before = usual[k++];
    const std::string exact = detail::exact(value);
    if (exact.empty() && before.exact.empty()) return;
    const Said now = detail::said_field(value, f.unit);
    parameters.push_back({.section = std::string(section),
                          .name = std::string(f.name),
                          .value = now.value,
                          .unit = now.unit,
                          .meaning = std::string(f.meaning),
                          .usual = exact == before.exact ? "" : before.said.both()});
  });
  return parameters;
}

/// How far ours is from a reference, as a reader expects it: "+2.6 %"; a dash without either.
inline std::string difference(double ours, double reference) {
  if (!std::isfinite(ours) || !(reference > 0 && std::isfinite(reference))) return "\u2013";
  const double percent = 100 * (ours / reference - 1);
  return (percent > 0 ? "+" : "") + observe::fixed(percent, 1, "%");
}

/// Injection pressure at the first break that the fluid made, Pa; not a number if there is none.
/// Bonds that break while the specimen settles say nothing of the fluid.
template <class Sim>
double first_break_pressure(const Sim& sim) {
  for (const auto& b : sim.breaks())
    if (b.time > 0) return b.pressure;
  return NAN;
}

/// How a run went, beyond what the simulator itself remembers.
struct RunRecord {
  std::string stopped;   ///< why it ended before its time; empty if it did not
  long unconverged = 0;  ///< fluid steps that ended before their tolerances were met
  double wall = 0;       ///< s
};

// What reports say most.
inline std::string metres(double v) { return observe::fixed(v, 3, "m"); }
inline std::string micrometres(double v) { return observe::fixed(v * 1e6, 1, "µm"); }
inline std::string megapascals(double v) { return observe::fixed(v / 1e6, 2, "MPa"); }

template <class Sim>
void add_run(observe::Report& page, const Sim& sim, const RunRecord& run, const Manifest& made) {
  const auto discs = static_cast<long>(sim.discs().size());
  const double disc_steps =
      static_cast<double>(discs) * static_cast<double>(sim.mechanical_steps());
  page.section("How the run went");
  page.facts(
      {{"ended", run.stopped.empty() ? "at its end time" : "early: " + run.stopped},
       {"discs", said(discs)},
       {"fluid steps", said(sim.fluid_steps())},
       {"unconverged fluid steps", said(run.unconverged) +
                                       ", which ended before their tolerances were met; "
                                       "what was unmet carried over to the next"},
       {"mechanical steps", said(sim.mechanical_steps())},
       {"settling steps",
        said(sim.settling_steps()) + ", before the injection began and not in the above"},
       {"mechanical time step", observe::fixed(sim.mechanical_dt() * 1e6, 3, "µs")},
       {"threads", std::to_string(made.threads)},
       {"wall time", observe::fixed(run.wall, 2, "s")},
       {"disc-steps per second", observe::fixed(disc_steps / run.wall / 1e6, 1) + " million"}});
}

template <class Tree>
void add_parameters(observe::Report& page, const Tree& tree, const Tree& defaults) {
  page.section("Parameters");
  const auto parameters = listed(tree, defaults);
  const bool usual = std::all_of(parameters.begin(), parameters.end(),
                                 [](const observe::Parameter& p) { return p.usual.empty(); });
  page.text((usual ? "All are at their defaults. "
                   : "A shaded row differs from the default, which stands below its value. ") +
            std::string("The file config.toml has the same in SI units, and repeats the run."));
  page.parameters(parameters);
}

inline void add_manifest(observe::Report& page, const Manifest& made) {
  page.section("Manifest");
  page.facts({{"program", made.program + " of hfdem " + made.version},
              {"compiler", made.compiler},
              {"flags", made.flags, true},
              {"build type", made.build_type},
              {"seed", made.seed},
              {"threads", std::to_string(made.threads) + "; the results do not depend on it"},
              {"command line", made.command_line, true},
              {"date", made.date}});
}

/// The end of a run's page: parameters beside their defaults, files, manifest.
template <class Tree>
void add_origin(observe::Report& page, const Tree& tree, const std::vector<observe::File>& files,
                const Manifest& made) {
  Tree defaults;
  defaults.simulator.scheme = resolved(defaults.simulator.scheme);
  add_parameters(page, tree, defaults);
  page.section("Files");
  page.files(files);
  add_manifest(page, made);
}

/// The page of a run that could not begin.
template <class Tree>
std::string unbegun_page(observe::Report& page, const Tree& tree, const std::string& reason,
                         const Manifest& made) {
  page.title = "No crack: the run could not begin";
  page.stopped = "Before the injection began: " + reason + ".";
  add_origin(page, tree,
             {{"config.toml", "every parameter; repeats the run with --config"},
              {"history.csv", "no row: nothing was injected"}},
             made);
  return page.html();
}

}  // namespace hfdem::support
