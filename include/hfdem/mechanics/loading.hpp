/// @file
/// What holds the specimen: rigid smooth platens (servo-controlled, frozen once settled, or
/// driven), or dead loads on the discs of the rim.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include <hfdem/base/fields.hpp>
#include <hfdem/mechanics/force_rows.hpp>
#include <hfdem/state/discs.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

/// What holds the specimen: `Loading::Params` says what each kind does.
enum class BoundaryKind { servo, frozen, dead_loads };
/// Their names in a parameter file.
template <>
inline constexpr auto names_of<BoundaryKind> = std::to_array<std::string_view>({"servo", "frozen",
                                                                                "dead_loads"});

/// The boundary of one specimen under a given in-situ stress.
class Loading {
 public:
  /// Kind of boundary, and the servo's gain.
  struct Params {
    BoundaryKind kind = BoundaryKind::servo;
    double servo_gain = 0.5;

    static constexpr auto fields() {
      using P = Params;
      return std::tuple{
          Field{"kind", &P::kind, "", any_number,
                "servo: platens hold the in-situ stress; frozen: platens stop once settled; "
                "dead_loads: no platens, constant forces on the rim"},
          Field{"servo_gain", &P::servo_gain, "", Range{0, 1, true},
                "part of the force error that a platen takes back in one mechanical step"}};
    }
  };

  /// Free of stress until `set_stress`. Dead loads are shared out by the radii of the rim's discs,
  /// tilted so that their resultant acts in the middle of the side: an irregular rim would spin.
  Loading(const Params& params, const Specimen& specimen)
      : params_(params),
        width_(specimen.width),
        height_(specimen.height),
        dead_load_(specimen.size()) {
    if (has_platens()) return;
    for (const Side side : all_sides) {
      auto& rim = rim_[static_cast<std::size_t>(side)];
      for (Index i = 0; i < specimen.size(); ++i)
        if (specimen.touches(i, side)) rim.push_back({i, specimen.radius[i]});
      share_out(rim, specimen, side);
    }
  }

  const Params& params() const { return params_; }                               ///< as given
  bool has_platens() const { return params_.kind != BoundaryKind::dead_loads; }  ///< or dead loads
  Stress stress() const { return stress_; }  ///< that the boundary holds, Pa
  double width() const { return width_; }    ///< of the specimen when it was bonded, m
  double height() const { return height_; }  ///< of the specimen when it was bonded, m

  /// The force that the in-situ stress exerts on one side, N per m.
  double target(Side side) const {
    return is_vertical(side) ? stress_.xx * height_ : stress_.yy * width_;
  }

  /// A platen's stiffness: the sum of its contacts' springs, N/m per m.
  void add_stiffness(Side side, double stiffness) {
    stiffness_[static_cast<std::size_t>(side)] += stiffness;
  }

  /// Changes the forces that platens are to hold, or the dead loads.
  void set_stress(Stress stress) {
    stress_ = stress;
    dead_load_.assign(dead_load_.size(), {});
    for (const Side side : all_sides)
      for (const auto& [disc, share] : rim_[static_cast<std::size_t>(side)])
        dead_load_[disc] = dead_load_[disc] - (target(side) * share) * outward(side);
  }

  /// From now on a platen moves inwards by so much in every step, m, whatever its force; 0 stops
  /// it.
  void drive(Side side, double advance) { advance_[static_cast<std::size_t>(side)] = advance; }

  /// The constant force on a disc of the rim, N per m; zero where platens hold the specimen.
  Vec2 dead_load(Index disc) const { return dead_load_[disc]; }

  /// The discs that carry the dead loads of a side.
  std::vector<Index> rim(Side side) const {
    std::vector<Index> discs;
    for (const RimDisc& d : rim_[static_cast<std::size_t>(side)]) discs.push_back(d.disc);
    return discs;
  }

  /// How far a platen's force is from its target, relative to it; a driven one has none.
  double error(Side side, const Discs& discs, const ForceRows& forces) const {
    const double goal = target(side);
    const bool driven = advance_[static_cast<std::size_t>(side)].has_value();
    return goal == 0 || driven ? 0
                               : std::abs(compression(side, discs, forces) - goal) / std::abs(goal);
  }

  /// The force of the discs on a platen, N per m, compression positive.
  static double compression(Side side, const Discs& discs, const ForceRows& forces) {
    const Pack total = forces.total(discs.platen(side));
    return dot({total[0], total[1]}, outward(side));
  }

  /// One mechanical step of the platens: each moves as it is driven, or by a part of what would
  /// correct its force.
  void step(Discs& discs, const ForceRows& forces, bool settling) const {
    if (!has_platens() || (params_.kind == BoundaryKind::frozen && !settling)) return;
    for (const Side side : all_sides) {
      const auto& advance = advance_[static_cast<std::size_t>(side)];
      const double outwards = advance ? -*advance : correction(side, discs, forces);
      const Vec2 out = outward(side);
      discs.displacement[discs.platen(side)] += Pack{out.x, out.y, 0, 0} * outwards;
    }
  }

  /// What the boundary holds at present.
  void exchange(auto& archive) {
    archive(stress_, std::span(dead_load_), std::span<std::optional<double>>(advance_));
  }

 private:
  double correction(Side side, const Discs& discs, const ForceRows& forces) const {
    const double excess = compression(side, discs, forces) - target(side);
    return params_.servo_gain * excess / stiffness_[static_cast<std::size_t>(side)];
  }

  struct RimDisc {
    Index disc;
    double share;  ///< of the side's force
  };

  /// Makes shares of radii.
  static void share_out(std::vector<RimDisc>& rim, const Specimen& specimen, Side side) {
    const bool vertical = is_vertical(side);
    const double middle = (vertical ? specimen.height : specimen.width) / 2;
    const auto from_middle = [&](const RimDisc& d) {
      return (vertical ? specimen.centre[d.disc].y : specimen.centre[d.disc].x) - middle;
    };
    double sum = 0, first = 0, second = 0;
    for (const RimDisc& d : rim) {
      sum += d.share;
      first += d.share * from_middle(d);
      second += d.share * from_middle(d) * from_middle(d);
    }
    const double mean = first / sum, variance = second / sum - mean * mean;
    // What rounding makes of a symmetric rim must not disturb its symmetry.
    const bool symmetric = std::abs(mean) < 1e-12 * middle;
    const double tilt = symmetric ? 0 : -mean / variance;
    for (RimDisc& d : rim) d.share *= (1 + tilt * (from_middle(d) - mean)) / sum;
  }

  Params params_;
  double width_, height_;
  Stress stress_{0, 0};
  std::array<double, 4> stiffness_{};
  std::array<std::optional<double>, 4> advance_{};  ///< of driven platens
  std::array<std::vector<RimDisc>, 4> rim_;
  std::vector<Vec2> dead_load_;
};

}  // namespace hfdem
