/// @file
/// What passes between the simulator and a pressure scheme in a fluid step.
#pragma once

namespace hfdem {

/// What one mechanical step tells a pressure scheme. Everything is measured at the start of the
/// step, except the network's widths, which are those of its end.
struct Relaxed {
  double unbalanced_ratio;   ///< largest resultant on a disc over the mean contact force
  int breaks;                ///< bonds broken in this step
  double joined_volume = 0;  ///< of dry joints that the fluid reached in this step, m2
};

/// Injection so far and in the present fluid step, m2 (per m of thickness).
struct Injected {
  double total;   ///< up to the end of this step: V_f
  double step;    ///< in this step
  double dt = 0;  ///< length of this step, s
};

/// How the rock answers, roughly: what a scheme that guesses ahead starts from.
struct RockResponse {
  double modulus;    ///< plane modulus, Pa
  double wave_step;  ///< how far a wave travels in a mechanical step, m
};

/// How a fluid step went.
struct FluidStep {
  int mechanical_steps = 0;     ///< made in this fluid step
  bool converged = true;        ///< the scheme's own tolerances were met
  double volume_error = 0;      ///< |V_f - V_c| / V_f
  double unbalanced_ratio = 0;  ///< at the last mechanical step
  long flow_steps = 0;          ///< explicit steps of the flow, or systems of equations solved
};

}  // namespace hfdem
