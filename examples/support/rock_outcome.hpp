/// @file
/// What a run in random rock came to.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <hfdem/measure/crack_path.hpp>
#include <hfdem/measure/elastic_moduli.hpp>
#include <hfdem/measure/microcracks.hpp>
#include <hfdem/observe/growth.hpp>

#include "support/rock_model.hpp"
#include "support/run_report.hpp"
#include "support/schemes.hpp"
#include "support/summary.hpp"

namespace hfdem::support {

/// SI; what a run did not come to is not a number.
struct RockOutcome {
  observe::GrowthInstant end{};       ///< the last fluid step, or the moment the rim was reached
  measure::CrackPath crack{};         ///< at the end
  measure::MicrocrackCounts count{};  ///< at the end
  measure::MicrocrackCounts in_joints{};  ///< those of them in natural fractures
  double first_break = NAN, breakdown = 0, propagation = NAN;  ///< pressures
  double balance_error = 0;          ///< of the ledger of volumes, at worst
  double pressure_drop = 0;          ///< of the injection, over the mean of the wet domains
  std::optional<double> rim_time{};  ///< if the crack reached the rim
  measure::ElasticModuli moduli{NAN, NAN};
  RunRecord run{};

  int preset() const { return count.connected.preset + count.unconnected.preset; }  ///< microcracks
};

template <class Config>
void summarise(Summary& s, const Config& config, const typename Config::Sim& sim,
               const RockOutcome& o, const observe::Growth& growth) {
  const double closing = config.closing_stress();
  s.set("time_s", o.end.time);
  s.set("first_break_pressure_Pa", o.first_break);
  s.set("breakdown_pressure_Pa", o.breakdown);
  s.set("propagation_pressure_Pa", o.propagation);
  s.set("pressure_drop_Pa", o.pressure_drop);
  s.set("tip_distance_m", o.end.tip_distance);
  s.set("tip_up_m", o.end.tip_up);
  s.set("tip_down_m", o.end.tip_down);
  s.set("crack_path_length_m", o.end.path_length);
  s.set("connected_length_m", o.end.connected_length);
  s.set("total_length_m", o.end.total_length);
  s.set("tortuosity", o.end.tortuosity);
  s.set("mean_tortuosity_of_wings", o.crack.mean_tortuosity());
  s.set("asymmetry", o.end.asymmetry);
  s.set("branches", static_cast<long>(o.crack.branches.size()));
  const auto& [connected, unconnected] = o.count;
  s.set("microcracks/rock", o.count.total() - o.preset() - o.in_joints.total());
  s.set("microcracks/joints", o.in_joints.total());
  s.set("microcracks/connected_joints", o.in_joints.connected.total());
  s.set("microcracks/tension", connected.tension + unconnected.tension);
  s.set("microcracks/shear", connected.shear + unconnected.shear);
  s.set("microcracks/preset", o.preset());
  s.set("microcracks/unconnected", unconnected.total());
  long settling = 0;
  for (const BondBreak& b : sim.breaks()) settling += b.time > 0 ? 0 : 1;
  s.set("microcracks/broken_while_settling", settling);
  s.set("reached_rim_at_s", o.rim_time.value_or(NAN));
  s.set("mean_aperture_m", o.end.aperture);
  s.set("mean_opening_m", o.end.opening);
  s.set("injection_pressure_Pa", o.end.pressure);
  s.set("net_pressure_Pa", o.end.pressure - closing);
  s.set("fluid_volume_m2", o.end.fluid_volume);
  s.set("crack_volume_m2", o.end.crack_volume);
  for (const double time : {0.3, 0.6, 0.9, 1.2, 1.5}) {
    const auto* then = time <= o.end.time * (1 + 1e-9) ? growth.at(time) : nullptr;
    if (then == nullptr) continue;
    const std::string at = "growth/" + to_text(time) + "_s/";
    s.set(at + "tip_distance_m", then->tip_distance);
    s.set(at + "total_length_m", then->total_length);
    s.set(at + "tortuosity", then->tortuosity);
    s.set(at + "mean_aperture_m", then->aperture);
    s.set(at + "injection_pressure_Pa", then->pressure);
  }
  s.set("discs", static_cast<long>(sim.discs().size()));
  s.set("bonds", static_cast<long>(sim.contacts().size()));
  s.set("seed", config.specimen.seed);
  s.set("E_Pa", o.moduli.young);
  s.set("poisson_ratio", o.moduli.poisson);
  s.set("rule", std::string(words_of(config.simulator.scheme).rule));
  s.set("scheme", std::string(words_of(config.simulator.scheme).name));
  s.set("viscosity_Pa_s", config.simulator.fluid.viscosity);
  s.set("fluid_balance_relative_error", o.balance_error);
  s.set("fluid_steps", sim.fluid_steps());
  s.set("unconverged_fluid_steps", o.run.unconverged);
  s.set("mechanical_steps", sim.mechanical_steps());
  s.set("settling_steps", sim.settling_steps());
  s.set("mechanical_dt_s", sim.mechanical_dt());
  s.set("wall_s", o.run.wall);
  s.set("particle_steps_per_s", static_cast<double>(sim.discs().size()) *
                                    static_cast<double>(sim.mechanical_steps()) / o.run.wall);
  if (!o.run.stopped.empty()) s.set("stopped", o.run.stopped);
}

}  // namespace hfdem::support
