/// @file
/// Where fluid is injected, and how fast: at a constant rate, or by a schedule of rates, and how
/// the pump comes to it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <tuple>
#include <vector>

#include <hfdem/base/fields.hpp>

namespace hfdem {

/// A step of the injection rate; in a parameter file the pair [time, rate].
struct RateChange {
  double time = 0;
  double rate = 0;

  static constexpr auto fields() {
    using P = RateChange;
    return std::tuple{
        Field{"time", &P::time, "s", non_negative, "injection time of the change"},
        Field{"rate", &P::rate, "m2/s", non_negative, "from then on; zero shuts the well in"}};
  }
};

/// Where the fluid goes in, and how fast.
///
/// All points belong to one well and share its rate equally. A scheme that knows one pressure only,
/// `UniformPressure`, has no friction in the well either: there each point takes what its crack
/// opens for. Every point has a preset crack of its own; a length or an aperture "at the
/// injection" is measured from the first point.
struct Injection {
  double rate = 0.5e-4;
  std::optional<Vec2> position{};  ///< the middle of the specimen if not given
  double rise = 0;
  std::vector<RateChange> schedule{};  ///< by increasing time; none if `rate` stays
  std::vector<Vec2> further_points{};  ///< beside `position`

  static constexpr auto fields() {
    using P = Injection;
    return std::tuple{
        Field{"rate", &P::rate, "m2/s", positive, "injection rate per m of thickness"},
        Field{"position", &P::position, "m", any_number,
              "where; the flow domain with the nearest centre receives the fluid"},
        Field{"rise", &P::rise, "s", non_negative,
              "the pump needs this long: until then the rate is what is planned, times t / rise"},
        Field{"schedule", &P::schedule, "s, m2/s", any_number,
              "[time, rate] from which on the rate is another; zero shuts the well in"},
        Field{"further_points", &P::further_points, "m", any_number,
              "where fluid is injected, too: all points share the rate equally"}};
  }

  /// Checks what its entries have to do with each other.
  /// @throws InvalidParameter if the times of the schedule do not increase
  void check() const {
    for (std::size_t k = 1; k < schedule.size(); ++k)
      if (!(schedule[k].time > schedule[k - 1].time))
        refuse("injection", entry_of("schedule", k) + ", time", to_text(schedule[k].time) + " s",
               "greater than " + to_text(schedule[k - 1].time) + " s, that of the entry before");
  }
};

/// The injection rate over time: as planned, until someone changes it.
class InjectionRate {
 public:
  /// @param planned validated
  explicit InjectionRate(const Injection& planned)
      : rate_(planned.rate), rise_(planned.rise), changes_(planned.schedule) {}

  /// Fluid injected in a step, m2 per m of thickness: the exact integral of the rate, whatever
  /// changes within the step.
  /// @param time at which the step begins, s
  /// @param dt its length, s
  double volume(double time, double dt) const {
    const double end = time + dt;
    double rate = rate_, from = time, volume = 0;
    for (const RateChange& change : changes_) {
      if (change.time >= end) break;
      if (change.time > from) {
        volume += constant(rate, from, change.time);
        from = change.time;
      }
      rate = change.rate;
    }
    // A constant rate takes the step as it is: end - time is rounded.
    if (from == time && time >= rise_) return rate * dt;
    return volume + constant(rate, from, end);
  }

  /// Keeps one rate from now on, m2/s, whatever was planned.
  void hold(double rate) {
    rate_ = rate;
    rise_ = 0;
    changes_.clear();
  }

  /// What is planned for the rest of the run.
  void exchange(auto& archive) { archive(rate_, rise_, changes_); }

 private:
  /// Injected from one time to another while one rate is planned, m2.
  double constant(double rate, double from, double to) const {
    const double risen = std::clamp(rise_, from, to);
    const double slow = risen > from ? (risen - from) * (risen + from) / (2 * rise_) : 0;
    return rate * (slow + (to - risen));
  }

  double rate_, rise_;
  std::vector<RateChange> changes_;
};

}  // namespace hfdem
