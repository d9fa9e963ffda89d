/// @file
/// What modulus and toughness of a rock predict for a run in it.
#pragma once

#include <cmath>
#include <optional>

#include <hfdem/observe/growth.hpp>

#include "support/growth_prediction.hpp"
#include "support/injected.hpp"
#include "support/random_toughness_model.hpp"
#include "support/rock_model.hpp"
#include "support/summary.hpp"

namespace hfdem::support {

/// The injection of a run, into a plate.
template <class Config>
PlateInjection plate_injection(const Config& c) {
  return {.width = c.specimen.width,
          .height = c.specimen.height,
          .boundary = c.simulator.boundary.kind,
          .in_situ = c.simulator.in_situ,
          .rate = c.simulator.injection.rate,
          .preset_length = c.simulator.crack.length.value_or(0)};
}

/// Whether it was measured in such a rock: its bonds and its grains; the plate takes care of size,
/// stress and boundary.
template <class Config>
bool same_rock(const MeasuredRock& measured, const Config& config) {
  const auto& there = measured.rock;
  const auto& contact = config.simulator.contact;
  bool same = !contact.weibull_modulus;
  for_each_field<LinearParallelBond::Params>([&](const auto& field) {
    same = same && there.contact.*(field.member) == contact.*(field.member);
  });
  const RandomPacking &a = there.specimen, &b = config.specimen;
  return same && a.radius_min == b.radius_min && a.radius_max == b.radius_max &&
         a.bonding_gap == b.bonding_gap;
}

/// Nothing without a measured rock.
/// @throws InvalidParameter if the specimen is no plate that the solution knows, or the injection
///   not at a constant rate through one point
template <class Config>
std::optional<GrowthPrediction> prediction_of(const std::optional<MeasuredRock>& measured,
                                              const Config& config) {
  if (!measured) return {};
  check_predictable(config.simulator.injection);
  return GrowthPrediction(measured->fracture, plate_injection(config));
}

/// The prediction for the moment at which a run ended, beside it.
inline void summarise(Summary& s, const GrowthPrediction& prediction, bool same_rock,
                      const observe::GrowthInstant& end) {
  s.set("predicted/same_rock", same_rock);
  s.set("predicted/splitting_time_s", prediction.splitting_time());
  s.set("predicted/splitting_length_m", prediction.splitting_length());
  const auto crack = prediction.at(end.time);
  if (!crack) return;
  s.compare("predicted/tip_distance_m", end.tip_distance, crack->full_length);
  s.compare("predicted/mean_opening_m", end.opening, crack->opening);
  s.compare("predicted/injection_pressure_Pa", end.pressure, crack->pressure);
}

}  // namespace hfdem::support
