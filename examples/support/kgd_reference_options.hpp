/// @file
/// The command line of kgd_reference: one option per number of the problem, read strictly.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string>

#include <hfdem/analytic/kgd.hpp>
#include <hfdem/analytic/plate.hpp>

#include <CLI/CLI.hpp>

namespace hfdem::support {

/// Reads all of `text` as a number in `range`.
/// @throws InvalidParameter naming the option, its value and the range
inline double read_number(const std::string& option, const std::string& text, const Range& range,
                          std::string_view unit) {
  const std::string allowed = "it must be a number, " + to_text(range, unit);
  if (text.empty()) throw InvalidParameter(option + " is missing: " + allowed);
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value) || !range.contains(value))
    throw InvalidParameter(option + " = " + text + " is not allowed: " + allowed);
  return value;
}

/// A finite square specimen around the fracture.
struct PlateOptions {
  std::string sides;  ///< as the user calls them
  analytic::CrackedPlate plate;
};

class KgdReferenceOptions {
 public:
  static constexpr int most_points = 10000;
  static constexpr std::array<std::string_view, 3> sides{"stress", "rigid", "fixed"};

  void add_to(CLI::App& app) {
    std::size_t k = 0;
    for_each_field<analytic::KgdProblem>([&](const auto& field) {
      const std::string meaning = std::string(field.meaning) + ", " + std::string(field.unit);
      app.add_option(option_name(field.name), texts_[k++], meaning)->type_name("NUMBER");
    });
    app.add_option("--plate", plate_,
                   "also the growth in a square plate of this width, m, at K_I = K_IC without "
                   "viscosity and leak-off")
        ->type_name("NUMBER");
    app.add_option("--sides", sides_,
                   "of the plate: stress (constant), rigid (platens under constant mean stress) or "
                   "fixed (walls that do not move)")
        ->type_name("NAME");
    app.add_option("--poisson", poisson_, "Poisson's ratio of the rock, for fixed sides; 0.3")
        ->type_name("NUMBER");
    app.add_option("--profile", profile_,
                   "also the profiles, at N points from the injection to the tip")
        ->type_name("N");
    app.add_option("--map", map_, "also a picture: the fracture on the map of regimes (SVG)")
        ->type_name("FILE");
  }

  /// @throws InvalidParameter naming the option, its value and the range
  analytic::KgdProblem problem() const {
    analytic::KgdProblem p;
    std::size_t k = 0;
    for_each_field<analytic::KgdProblem>([&](const auto& field) {
      p.*(field.member) =
          read_number(option_name(field.name), texts_[k++], field.range, field.unit);
    });
    return p;
  }

  /// The plate, if one is asked for.
  /// @throws InvalidParameter naming the option, its value and the range
  std::optional<PlateOptions> plate(const analytic::KgdProblem& p) const {
    if (plate_.empty() && sides_.empty() && poisson_.empty()) return std::nullopt;
    const double width = read_number("--plate", plate_, {.low = 1e-20, .high = 1e20}, "m");
    const auto named = std::find(sides.begin(), sides.end(), sides_);
    if (named == sides.end())
      throw InvalidParameter(
          (sides_.empty() ? "--sides is missing" : "--sides = " + sides_ + " is not allowed") +
          ": it must be stress, rigid or fixed");
    constexpr Range compressible{.low = 0, .high = 0.5, .open_high = true};
    const double poisson =
        poisson_.empty() ? 0.3 : read_number("--poisson", poisson_, compressible, "");
    if (p.K_IC < 1e-20)
      throw InvalidParameter("--K-IC = " + to_text(p.K_IC) +
                             " is not allowed with --plate: it must be at least 1e-20 Pa m^0.5");
    return PlateOptions{
        sides_, analytic::CrackedPlate(width, analytic::isotropic_plane(p.E_prime, poisson),
                                       static_cast<analytic::PlateSides>(named - sides.begin()))};
  }

  /// Points of the profiles; 0 if none are wanted.
  /// @throws InvalidParameter naming the option, its value and the range
  int profile_points() const {
    if (profile_.empty()) return 0;
    const double points = read_number("--profile", profile_, {.low = 2, .high = most_points}, "");
    if (points != std::floor(points))
      throw InvalidParameter("--profile = " + profile_ +
                             " is not allowed: it must be a whole number, at least 2 and at most " +
                             std::to_string(most_points));
    return static_cast<int>(points);
  }

  /// Where the map of regimes goes; empty if none is wanted.
  const std::string& map_file() const { return map_; }

 private:
  static std::string option_name(std::string_view field) {
    std::string name = "--" + std::string(field);
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
  }

  std::array<std::string, std::tuple_size_v<decltype(analytic::KgdProblem::fields())>> texts_;
  std::string plate_, sides_, poisson_, profile_, map_;
};

}  // namespace hfdem::support
