/// @file
/// Every table of fields says everything about its parameters, and nothing out of range gets by.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include <hfdem/analytic/kgd.hpp>
#include <hfdem/analytic/lattice_fracture.hpp>
#include <hfdem/analytic/plate_growth.hpp>
#include <hfdem/analytic/rock_fracture.hpp>
#include <hfdem/aperture/hyperbolic.hpp>
#include <hfdem/base/units.hpp>
#include <hfdem/contact/jointed.hpp>
#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/contact/scattered_parallel_bond.hpp>
#include <hfdem/contact/smooth_joint.hpp>
#include <hfdem/leakoff/carter.hpp>
#include <hfdem/leakoff/matrix_flow.hpp>
#include <hfdem/leakoff/none.hpp>
#include <hfdem/measure/measurement_circle.hpp>
#include <hfdem/measure/rock_tests.hpp>
#include <hfdem/measure/running_crack.hpp>
#include <hfdem/measure/slit_modulus.hpp>
#include <hfdem/measure/toughness.hpp>
#include <hfdem/pressure/conventional.hpp>
#include <hfdem/pressure/dry.hpp>
#include <hfdem/pressure/held.hpp>
#include <hfdem/pressure/implicit.hpp>
#include <hfdem/pressure/leaky_uniform.hpp>
#include <hfdem/pressure/uniform.hpp>
#include <hfdem/setup/random_fractures.hpp>
#include <hfdem/setup/random_packing.hpp>
#include <hfdem/setup/square_array.hpp>
#include <hfdem/simulator_params.hpp>

#include <doctest/doctest.h>

#include "described.hpp"

using namespace hfdem;

namespace {

/// All parameters that describe themselves; the first test sees to it that none is forgotten.
using AllParams = std::tuple<
    LinearParallelBond::Params, HyperbolicAperture::Params, Dry::Params, HeldPressure::Params,
    UniformPressure::Params, Loading::Params, Mechanics, Stress, FlowChannels, PresetCrack,
    Injection, RateChange, NewtonianFluid::Params, SquareArray, RandomPacking, measure::SlitSeries,
    measure::CircleGrid, measure::LoadFrame, BrazilianDisc, ScatteredParallelBond::Params,
    analytic::KgdProblem, analytic::LatticeFracture, analytic::OrthotropicPlane,
    analytic::ToughnessLaw, analytic::RockFracture, measure::HeldSlits, measure::RunningRange,
    RandomFractures, SmoothJoint::Params, NoJoint::Params, ConventionalFlow<>::Params,
    ImplicitFlow<>::Params, NoLeakoff::Params, CarterLeakoff::Params, MatrixFlow::Params>;

/// Parameters in range: the defaults, but for descriptions of a rock, which have none.
template <class P>
const P sample{};
template <>
const analytic::KgdProblem sample<analytic::KgdProblem>{
    .E_prime = 30e9, .K_IC = 1e6, .viscosity = 1e-3, .rate = 1e-4, .time = 1};
template <>
const analytic::LatticeFracture sample<analytic::LatticeFracture>{
    .E = 30e9, .shear_modulus = 12e9, .E_prime = 30e9, .K_IC = 1e6};
template <>
const analytic::OrthotropicPlane sample<analytic::OrthotropicPlane>{.E = 30e9, .G = 12e9};
template <>
const analytic::ToughnessLaw sample<analytic::ToughnessLaw>{.K_IC = 1e6};

template <>
const analytic::RockFracture sample<analytic::RockFracture>{
    .E_prime = 30e9, .K_IC = 2e6, .K_IC_above_in_situ = 2e6};

using Tree = SimulatorParams<Jointed<LinearParallelBond>, HyperbolicAperture,
                             LeakyUniformPressure<CarterLeakoff>>;
using TreeWithoutJoints =
    SimulatorParams<LinearParallelBond, HyperbolicAperture, LeakyUniformPressure<CarterLeakoff>>;

TEST_CASE("every table of fields in the headers is tested here") {
  std::size_t tables = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(HFDEM_HEADERS)) {
    if (!entry.is_regular_file()) continue;
    std::stringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    for (std::string line; std::getline(text, line);)
      tables += line.find(" auto fields()") != std::string::npos;
  }
  CHECK(tables == std::tuple_size_v<AllParams>);
}

// ---- completeness -----------------------------------------------------------------------------

TEST_CASE("members of every type that a parameter may have are counted") {
  struct Sample {
    double number;
    int count;
    bool choice;
    BoundaryKind kind;
    Vec2 position;
    std::optional<double> given_number;
    std::optional<int> given_count;
    std::optional<Vec2> given_position;
    std::string text;
    std::vector<double> list;
    std::vector<RateChange> changes;
  };
  CHECK(member_count<Sample>() == 11);
}

template <auto table>
void check_that_names_are_members() {
  constexpr Names<table> names;
  CHECK(names.given == names.members);
  CHECK(std::set(names.given.begin(), names.given.end()).size() == names.size);
}

/// A base takes one value in the braces of an aggregate, and has members of its own.
template <class P>
constexpr std::size_t inherited_members = 0;
template <>
constexpr std::size_t inherited_members<ScatteredParallelBond::Params> =
    member_count<LinearParallelBond::Params>() - 1;

TEST_CASE_TEMPLATE_DEFINE("a table lists every member once, by its own name", P, complete) {
  CHECK(std::tuple_size_v<decltype(P::fields())> == member_count<P>() + inherited_members<P>);
  check_that_names_are_members<&P::fields>();
}
TEST_CASE_TEMPLATE_APPLY(complete, AllParams);

TEST_CASE("the tree lists every section once, by its own name") {
  CHECK(std::tuple_size_v<decltype(Tree::sections())> == member_count<Tree>());
  check_that_names_are_members<&Tree::sections>();
}

TEST_CASE("joints are a section of the tree only where the contact law has some") {
  constexpr auto whole = Tree::sections();
  CHECK(std::get<1>(whole).name == "joints");
  CHECK(std::tuple_size_v<decltype(TreeWithoutJoints::sections())> ==
        std::tuple_size_v<decltype(whole)> - 1);
  TreeWithoutJoints without;
  for_each_section(without, [](std::string_view name, auto&) { CHECK(name != "joints"); });
}

TEST_CASE("leak-off is a section of the tree only where the scheme has some") {
  const auto has = [](const auto& sections) {
    return std::apply([](const auto&... s) { return ((s.name == "leakoff") || ...); }, sections);
  };
  CHECK(has(Tree::sections()));
  using Tight = SimulatorParams<LinearParallelBond, HyperbolicAperture, UniformPressure>;
  CHECK(!has(Tight::sections()));
}

TEST_CASE("the names of a choice are its enumerators") {
  const auto& names = names_of<BoundaryKind>;
  REQUIRE(names.size() == 3);
  CHECK(names[0] == identifier<static_cast<BoundaryKind>(0)>());
  CHECK(names[1] == identifier<static_cast<BoundaryKind>(1)>());
  CHECK(names[2] == identifier<static_cast<BoundaryKind>(2)>());
  REQUIRE(names_of<JointContent>.size() == 2);
  CHECK(names_of<JointContent>[0] == identifier<static_cast<JointContent>(0)>());
  CHECK(names_of<JointContent>[1] == identifier<static_cast<JointContent>(1)>());
  // A value without a name is written as a cast.
  CHECK(identifier<static_cast<BoundaryKind>(3)>().find("BoundaryKind)3") == 0);
}

TEST_CASE_TEMPLATE_DEFINE("every field says what it means", P, meaning) {
  for_each_field<P>([](const auto& field) {
    CAPTURE(field.name);
    CHECK(field.meaning.size() > 5);
  });
}
TEST_CASE_TEMPLATE_APPLY(meaning, AllParams);

// ---- ranges -----------------------------------------------------------------------------------

TEST_CASE_TEMPLATE_DEFINE("the defaults are in range", P, defaults) {
  CHECK_NOTHROW(validate(sample<P>, "section"));
}
TEST_CASE_TEMPLATE_APPLY(defaults, AllParams);

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The neighbour of a bound in the direction of `towards`.
template <class T>
T next_to(double bound, double towards) {
  if constexpr (std::is_integral_v<T>)
    return static_cast<T>(bound + (towards > bound ? 1 : -1));
  else
    return std::nextafter(bound, towards);
}

/// The values beside the bounds of a range, on its inner side (those of least and greatest size
/// that are allowed) and on its outer side.
template <class T>
struct Edges {
  std::vector<T> inside, outside;

  explicit Edges(const Range& r) {
    if (std::isfinite(r.low)) add(r.low, r.open_low, -infinity);
    if (std::isfinite(r.high)) add(r.high, r.open_high, infinity);
    if constexpr (std::is_floating_point_v<T>)
      outside.insert(outside.end(), {std::nan(""), -infinity, infinity});
  }

 private:
  void add(double bound, bool open, double outwards) {
    const T itself = static_cast<T>(bound);
    inside.push_back(open ? next_to<T>(bound, -outwards) : itself);
    outside.push_back(open ? itself : next_to<T>(bound, outwards));
  }
};

/// Calls `f` with a reference to each number in a member that the range of its field is for.
template <class T, class F>
void for_each_number(T& member, F&& f) {
  if constexpr (is_optional<T>) {
    for_each_number(member.emplace(), f);
  } else if constexpr (is_list<T>) {
    for_each_number(member.emplace_back(), f);
  } else if constexpr (std::is_same_v<T, Vec2>) {
    f(member.x);
    f(member.y);
  } else if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
    f(member);
  }
}

/// The message of the refusal; empty if nothing is refused.
template <class F>
std::string refusal(F&& f) {
  try {
    f();
  } catch (const InvalidParameter& e) {
    return e.what();
  }
  return {};
}

/// Whether `text` has the phrase followed by this number and unit.
bool says(const std::string& text, const std::string& phrase, double number,
          std::string_view unit) {
  const auto at = text.find(phrase);
  if (at == std::string::npos) return false;
  const char* const digits = text.c_str() + at + phrase.size();
  char* end = nullptr;
  const double read = std::strtod(digits, &end);
  const std::string_view rest = end;
  const bool same_number = std::isnan(number) ? std::isnan(read) : read == number;
  const bool same_unit =
      unit.empty() || (rest.starts_with(' ') && rest.substr(1).starts_with(unit));
  return end != digits && same_number && same_unit;
}

/// The message names the field, its value and the allowed range.
void check_refusal(const std::string& message, const std::string& field, double value,
                   std::string_view unit, const Range& r) {
  CAPTURE(message);
  CAPTURE(field);
  CAPTURE(value);
  CHECK(message.starts_with(field + " = "));
  CHECK(says(message, " = ", value, unit));
  const auto rule = message.find("it must be ");
  REQUIRE(rule != std::string::npos);
  const std::string allowed = message.substr(rule);
  if (std::isfinite(r.low))
    CHECK(says(allowed, r.open_low ? "greater than " : "at least ", r.low, unit));
  if (std::isfinite(r.high))
    CHECK(says(allowed, r.open_high ? "less than " : "at most ", r.high, unit));
  if (!std::isfinite(r.low) && !std::isfinite(r.high))
    CHECK(allowed == "it must be any finite number");
}

/// Puts every number of `params` out of range, one at a time, and looks at what `validate` says.
template <class P, class F>
void check_ranges(P& params, const std::string& section, F&& validate) {
  for_each_field<P>([&](const auto& field) {
    auto& member = params.*(field.member);
    const bool list = is_list<std::remove_reference_t<decltype(member)>>;
    const std::string name =
        section + "." + (list ? entry_of(field.name, 0) : std::string(field.name));
    const auto usual_member = member;
    for_each_number(member, [&](auto& number) {
      const auto usual = number;
      const Edges<std::remove_reference_t<decltype(number)>> edges(field.range);
      for (const auto value : edges.outside) {
        number = value;
        check_refusal(refusal(validate), name, value, field.unit, field.range);
      }
      for (const auto value : edges.inside) {
        number = value;
        CHECK(refusal(validate) == "");
      }
      number = usual;
    });
    member = usual_member;
  });
}

TEST_CASE_TEMPLATE_DEFINE("a field out of its range is refused, at its bounds exactly", P, ranges) {
  P params = sample<P>;
  check_ranges(params, "section", [&] { validate(params, "section"); });
}
TEST_CASE_TEMPLATE_APPLY(ranges, AllParams);

TEST_CASE("the tree refuses a field under the name of its section") {
  Tree tree;
  CHECK_NOTHROW(tree.validate());
  for_each_section(tree, [&](std::string_view name, auto& section) {
    check_ranges(section, std::string(name), [&] { tree.validate(); });
  });
}

TEST_CASE("a refusal reads like this") {
  const auto message_of = [](const auto& params, const char* section) {
    return refusal([&] { validate(params, section); });
  };
  CHECK(message_of(Mechanics{.damping = 1}, "mechanics") ==
        "mechanics.damping = 1 is not allowed: it must be at least 0 and less than 1");
  CHECK(message_of(LinearParallelBond::Params{.E = -17_GPa}, "contact") ==
        "contact.E = -1.7e+10 Pa is not allowed: it must be greater than 0 Pa");
  CHECK(message_of(Injection{.position = Vec2{0.5, std::nan("")}}, "injection") ==
        "injection.position = nan m is not allowed: it must be any finite number");
  CHECK(message_of(Injection{.schedule = {{0.3, 1e-4}, {0.6, -1e-4}}}, "injection") ==
        "injection.schedule, entry 2, rate = -1e-04 m2/s is not allowed: it must be at least 0 "
        "m2/s");
  CHECK(refusal([] { square_array(20, 1, 5_mm); }) ==
        "specimen.rows = 1 is not allowed: it must be at least 2 and at most 10000");
}

// ---- designated initialisers ------------------------------------------------------------------

TEST_CASE("a run is written as a tree of designated initialisers") {
  const Tree tree{.contact = {.E = 17_GPa, .tensile_strength = 8_MPa, .cohesion = 15_MPa},
                  .in_situ = {.xx = 10_MPa, .yy = 15_MPa},
                  .injection = {.rate = 1e-4, .position = Vec2{0.3, 0.4}},
                  .scheme = {.equilibrium = true, .volume_tolerance = 1e-4}};
  CHECK(tree.contact.cohesion == 15e6);
  CHECK(tree.contact.friction == 0.5);
  CHECK(tree.in_situ.yy == 15e6);
  CHECK(tree.crack.contacts == 4);
  CHECK(tree.injection.position == Vec2{0.3, 0.4});
  CHECK(tree.scheme.volume_tolerance == 1e-4);
  CHECK(!tree.scheme.max_mechanical_steps);
  CHECK_NOTHROW(tree.validate());
}

}  // namespace
