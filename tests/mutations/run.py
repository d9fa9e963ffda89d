"""Shows that the tests guard the physics: puts every constant and law term off by about 5 % (or
drops it), one at a time, and sees a test fail.

    python3 tests/mutations/run.py            all of them, some minutes
    python3 tests/mutations/run.py platen     those whose name contains a word

Works on a copy of the headers; exit status 1 if a fault stays unseen or no longer applies.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BOND = "contact/linear_parallel_bond.hpp"
KGD, PROFILE, TIP, GENERAL, REGIME, REGIONS = (f"analytic/kgd{s}.hpp" for s in ("", "_profile", "_tip", "_general", "_regime", "_regions"))
INJECTION = "state/injection.hpp"
LEDGER = "measure/energy_ledger.hpp"
JOINT = "contact/smooth_joint.hpp"
CRACK = "analytic/pressurised_crack.hpp"
PLATE, FIELDS, SOLVER, GROWTH = (f"analytic/plate{s}.hpp" for s in ("", "_fields", "_solver", "_growth"))
REGIME_MAP, REGIME_LAYOUT = "observe/regime_map.hpp", "observe/regime_layout.hpp"
STORED, EXPLICIT, IMPLICIT = (f"pressure/{s}.hpp" for s in ("stored_fluid", "conventional", "implicit"))
JOINTS, RANDOM_FRACTURES = "setup/joints.hpp", "setup/random_fractures.hpp"

# name, header, what stands there, what a careless hand writes, the tests that must see it
MUTATIONS = [
    ("normal stiffness of the particle", BOND, "{slenderness * E_,", "{1.05 * slenderness * E_,", "laws/parallel_bond"),
    ("normal stiffness of the bond", BOND, "slenderness * bond_E_,", "1.05 * slenderness * bond_E_,", "laws/parallel_bond"),
    ("shear stiffness of the particle", BOND, "shear_per_normal_(1 / p.st", "shear_per_normal_(1.05 / p.st", "laws/parallel_bond"),
    ("shear stiffness of the bond", BOND, "bond_shear_per_normal_(1 / p", "bond_shear_per_normal_(1.05 / p", "laws/parallel_bond"),
    ("moment stiffness of the bond", BOND, "(1.0 / 3.0) * k.bond", "(1.05 / 3.0) * k.bond", "laws/parallel_bond"),
    ("tension of the linear part", BOND, "max(T{}, k.normal", "max(T(-1e9 + T{}), k.normal", "laws/parallel_bond"),
    ("friction", BOND, "friction_(p.friction)", "friction_(1.05 * p.friction)", "laws/parallel_bond"),
    ("tensile strength", BOND, "tensile_strength_(2 * p.te", "tensile_strength_(2.1 * p.te", "laws/bond_strength"),
    ("moment in the tensile stress", BOND, "moment_factor_(3 * p.", "moment_factor_(3.15 * p.", "laws/bond_strength"),
    ("cohesion", BOND, "cohesion_(2 * p.cohesion)", "cohesion_(2.1 * p.cohesion)", "laws/bond_strength"),
    ("friction angle", BOND, "p.friction_angle * std", "1.05 * p.friction_angle * std", "laws/bond_strength"),
    ("bond radius", BOND, "std::fmin(a.radius, b.radius)", "0.5 * (a.radius + b.radius)", "laws/parallel_bond"),
    ("aperture under compression", "aperture/hyperbolic.hpp", "w0 * F0_ / (", "w0 * 1.05 * F0_ / (", "laws/aperture"),
    ("aperture of an open channel", "aperture/hyperbolic.hpp", "w0 + (gap > 0 ? gap : 0)", "w0 + 1.05 * (gap > 0 ? gap : 0)", "laws/aperture"),
    ("stiffness of the platens", "contact/smooth_platen.hpp", "return {2 * contact", "return {2.1 * contact", "laws/smooth_platen"),
    ("strain of the platens' half cells", "contact/smooth_platen.hpp", "return {2 * contact", "return {1 * contact", "physics/closed_forms"),
    ("push of the fluid", "setup/flow_domains.hpp", "-left_of(chord)", "-1.05 * left_of(chord)", "loops/flow_domains"),
    ("length of a channel", "setup/flow_domains.hpp", "length = norm(", "length = 1.05 * norm(", "loops/flow_domains"),
    ("volume of the crack", "state/network.hpp", "width_[c] - filled_width_[c]; });", "width_[c]; });", "loops/network"),
    ("volume of a domain", "state/network.hpp", "* width_[c] / 2;", "* width_[c] / 1.9;", "loops/network"),
    ("gain of the pressure", "pressure/uniform.hpp", "params_.alpha *", "1.05 * params_.alpha *", "schemes/uniform_pressure"),
    ("injected volume", INJECTION, "rise_) return rate * dt", "rise_) return 1.05 * rate * dt", "schemes/balances"),
    ("bits of a constant rate", INJECTION, "    if (from == time && time >= rise_) return rate * dt;\n", "", "schemes/injection"),
    ("rate before a change within the step", INJECTION, "volume += constant(rate, from", "volume += constant(change.rate, from", "schemes/injection"),
    ("rate after a change within the step", INJECTION, "volume + constant(rate, from, end)", "volume + rate * dt", "schemes/injection"),
    ("change that is still to come", INJECTION, "if (change.time >= end) break;", "", "schemes/injection"),
    ("changes that are past", INJECTION, "      rate = change.rate;\n", "      if (change.time > time) rate = change.rate;\n", "schemes/injection"),
    ("rise of the rate", INJECTION, "(2 * rise_)", "(2.1 * rise_)", "schemes/injection"),
    ("rise after the host has steered", INJECTION, "    rise_ = 0;\n", "", "schemes/injection"),
    ("plan after the host has steered", INJECTION, "    changes_.clear();\n", "", "schemes/injection"),
    ("order of the schedule", INJECTION, "if (!(schedule[k].time > ", "if (!(schedule[k].time >= ", "schemes/injection"),
    ("order of the schedule in a run's parameters", "simulator_params.hpp", "    injection.check();\n", "", "schemes/injection"),
    ("length of the fluid step that a scheme is told", "simulator.hpp", "injected, dt}", "injected, 1.05 * dt}", "schemes/injection"),
    ("two points in one domain", "setup/flow_domains.hpp", "if (std::find(all.begin(), all.end(), domain) != all.end())", "if (false)", "schemes/injection"),
    ("fluid at every point", "state/network.hpp", "for (const Index d : injection_domains_) wet(d);", "wet(injection_domain());", "schemes/injection"),
    ("preset crack that is cut once", "simulator.hpp", "if (std::find(preset_.begin(), preset_.end(), c) == preset_.end()) preset_", "preset_", "schemes/injection"),
    ("joints at a further point", "simulator_checks.hpp", "for (const Index d : network.injection_domains())", "for (const Index d : {network.injection_domain()})", "schemes/joints"),
    ("entries of lists", "base/fields.hpp", "k < value.size(); ++k)\n      check", "k + 1 < value.size(); ++k)\n      check", "loops/fields"),
    ("saved state without schedule", INJECTION, "archive(rate_, rise_, changes_)", "archive(rate_, rise_)", "schemes/saved_state"),
    ("saved state without the host's rate", INJECTION, "archive(rate_, rise_, changes_)", "archive(rise_, changes_)", "schemes/saved_state"),
    ("saved state without the end of a rise", INJECTION, "archive(rate_, rise_, changes_)", "archive(rate_, changes_)", "schemes/saved_state"),
    ("mass of a disc", "state/discs.hpp", "s.density * std", "1.05 * s.density * std", "loops/disc_motion"),
    ("inertia of a disc", "state/discs.hpp", "radius[disc] / 2;", "radius[disc] / 2.1;", "loops/disc_motion"),
    ("damping", "mechanics/motion.hpp", "return d * abs(force)", "return 1.05 * d * abs(force)", "loops/disc_motion"),
    ("damping in the stable step", "mechanics/stable_step.hpp", "std::sqrt(1 + damping)", "1", "loops/stable_step"),
    ("in-situ force on a side", "mechanics/loading.hpp", "stress_.xx * height_", "1.05 * stress_.xx * height_", "loops/loading"),
    ("coefficient of the KGD length", "analytic/kgd.hpp", "2 * std::numbers::sqrt2", "2.1 * std::numbers::sqrt2", "physics/closed_forms"),
    ("K' of the KGD solution", "analytic/kgd.hpp", "return 4 * std::sqrt", "return 4.2 * std::sqrt", "physics/closed_forms"),
    ("roots of the orthotropic plane", FIELDS, "std::sqrt((r - 1.0) / 2.0)", "std::sqrt((r - 1.0) / 2.1)", "analytic/plate"),
    ("shear of the crack's fields", FIELDS, "-d.real(),", "-1.05 * d.real(),", "analytic/plate"),
    ("stress across the crack's fields", FIELDS, "(F.at_2 - mu_2_ * d).real()", "(F.at_2 - 1.05 * mu_2_ * d).real()", "analytic/plate"),
    ("displacement across the crack's fields", FIELDS, "(mu_2_ * mu_2_ * e - (mu_1_", "(1.05 * mu_2_ * mu_2_ * e - (mu_1_", "analytic/plate"),
    ("displacement of the plate's other fields", FIELDS, "(i * (integral.at_2 - mu_2_ * e))", "(i * (integral.at_2 - 1.05 * mu_2_ * e))", "analytic/plate"),
    ("stress of the plate's other fields", FIELDS, "(i * ((mu_1_ + mu_2_) * A.at_2", "(i * (1.05 * (mu_1_ + mu_2_) * A.at_2", "analytic/plate"),
    ("tip of the crack in the plate", FIELDS, "std::sqrt(z - a_) *", "std::sqrt(z - 1.05 * a_) *", "analytic/plate"),
    ("images of the crack in the sides", FIELDS, "images_(2 - a)", "images_(1.2)", "analytic/plate"),
    ("pull on the plate", SOLVER, "(rigid_ ? height_ : 1);", "(rigid_ ? height_ : 1.05);", "analytic/plate"),
    ("sides of the plate free of shear", SOLVER, "field[row + 1] = root_weight", "field[row + 1] = 0 * root_weight", "analytic/plate"),
    ("mean stress of the platens", SOLVER, "+= weight * t.yy;", "+= 1.05 * weight * t.yy;", "analytic/plate"),
    ("volume of the plate's crack", SOLVER, "+= 4 * sine", "+= 4.2 * sine", "analytic/plate"),
    ("E' of the orthotropic plane", PLATE, "2 * E / std::sqrt(2 + 2 * rho())", "2 * E / std::sqrt(2.2 + 2 * rho())", "analytic/plate"),
    ("rho of the orthotropic plane", PLATE, "E / (2 * G) - poisson", "E / (2 * G) + poisson", "analytic/plate"),
    ("stiffness of the walls that hold a plate", PLATE, "(1 - rock.poisson * rock.poisson)", "1.05", "analytic/plate"),
    ("Poisson's ratio in plane strain", PLATE, "poisson / (1 - poisson)", "poisson", "analytic/plate"),
    ("energy release of the plate's crack", PLATE, "std::sqrt(volume + t * slope)", "std::sqrt(volume + 0.95 * t * slope)", "analytic/plate"),
    ("K_I in the plate", PLATE, "std::sqrt(std::numbers::pi * full_length / 2)", "std::sqrt(1.1 * std::numbers::pi * full_length / 2)", "analytic/plate"),
    ("opening in the plate", PLATE, "return 2 * net_pressure * full", "return 2.1 * net_pressure * full", "analytic/plate"),
    ("volume in the plate", PLATE, "return std::numbers::pi / 2 * net", "return std::numbers::pi / 2.1 * net", "analytic/plate"),
    ("toughness that grows with pressure", GROWTH, "- rock_.per_pressure;", "- 1.05 * rock_.per_pressure;", "analytic/plate"),
    ("length at which the plate splits", GROWTH, "extremum(to * step, step, 1);", "0.99 * extremum(to * step, step, 1);", "analytic/plate"),
    ("last length of the growth", GROWTH, "volume(std::fmin(n * step, plate_.longest()))", "volume(n * step)", "analytic/plate"),
    ("length of the M vertex", KGD, "0.615411", "0.6462", "analytic/kgd_vertices"),
    ("width of the M vertex", KGD, "1.125835", "1.1821", "analytic/kgd_vertices"),
    ("net pressure of the M vertex", KGD, "0.544817", "0.5721", "analytic/kgd_vertices"),
    ("shape of the M vertex", KGD, ".mouth = 0.588", ".mouth = 0.617", "analytic/kgd_general"),
    ("length of the K~ and M~ vertices", KGD, "(std::numbers::pi * s.leak_off)", "(1.05 * std::numbers::pi * s.leak_off)", "analytic/kgd_vertices"),
    ("width of the K vertex", KGD, "coefficient / 2", "coefficient / 2.1", "analytic/kgd_vertices"),
    ("net pressure of an ellipse", KGD, "/ (4 * half", "/ (4.2 * half", "analytic/kgd_vertices"),
    ("width of the K~ vertex", KGD, "std::sqrt(2 * std::numbers::pi * s", "std::sqrt(2.2 * std::numbers::pi * s", "analytic/kgd_vertices"),
    ("efficiency of the K~ vertex", KGD, "std::numbers::pi / 2 *", "std::numbers::pi / 2.1 *", "analytic/kgd_vertices"),
    ("width of the M~ vertex", KGD, "0.816389", "0.8572", "analytic/kgd_vertices"),
    ("net pressure of the M~ vertex", KGD, "0.751469", "0.7890", "analytic/kgd_vertices"),
    ("efficiency of the M~ vertex", KGD, "1.459991", "1.533", "analytic/kgd_vertices"),
    ("shape of the M~ vertex", KGD, ".mouth = 0.520", ".mouth = 0.546", "analytic/kgd_general"),
    ("mu' of the KGD solution", KGD, "12 * viscosity", "12.6 * viscosity", "analytic/kgd_vertices"),
    ("C' of the KGD solution", KGD, "2 * leak_off;", "2.1 * leak_off;", "analytic/kgd_vertices"),
    ("scale of the viscous pressure", KGD, "/ (2 * width)", "/ (2.1 * width)", "analytic/kgd_pressure"),
    ("leak-off in the flow", PROFILE, "(growth + 0.5)", "(growth + 0.45)", "analytic/kgd_pressure"),
    ("moving tip in the flow", PROFILE, "efficiency * growth * xi", "1.05 * efficiency * growth * xi", "analytic/kgd_pressure"),
    ("power of the viscous pressure", PROFILE, "return pressure_scale * 4", "return pressure_scale * 4.2", "analytic/kgd_pressure"),
    ("mean pressure of a profile", PROFILE, "s * s)) / 2;", "s * s)) / 2.1;", "analytic/kgd_pressure"),
    ("viscous tip", TIP, "2 * std::pow(3, 2.5)", "2.1 * std::pow(3, 2.5)", "analytic/kgd_general"),
    ("viscous tip with leak-off", TIP, "256 / (15", "256 / (15.8", "analytic/kgd_general"),
    ("first coefficient of the tip", TIP, "4 * (1 - 2 * d)", "4.2 * (1 - 2 * d)", "analytic/kgd_general"),
    ("second coefficient of the tip", TIP, "16 * (1 - 3 * d)", "16.8 * (1 - 3 * d)", "analytic/kgd_general"),
    ("exponent of the tip", TIP, "(1 + excess()) / 2", "(1 + excess()) / 2.1", "analytic/kgd_general"),
    ("strong leak-off at the tip", TIP, "factor * (1 - power) / k", "1.05 * factor * (1 - power) / k", "analytic/kgd_general"),
    ("leak-off at the tip", GENERAL, "2 * s.leak_off", "2.1 * s.leak_off", "analytic/kgd_general"),
    ("shape under viscosity and storage", GENERAL, "0.588", "0.617", "analytic/kgd_general"),
    ("shape under viscosity and leak-off", GENERAL, "0.520", "0.546", "analytic/kgd_general"),
    ("toughness in the shape", GENERAL, "f.tip.toughness, 3", "f.tip.toughness, 3.15", "analytic/kgd_general"),
    ("fluid in one wing", GENERAL, "std::log(2 * (f", "std::log(2.1 * (f", "analytic/kgd_general"),
    ("leaked volume", GENERAL, "tip_width * half_length * tip.", "1.05 * tip_width * half_length * tip.", "analytic/kgd_general"),
    ("growth in time", GENERAL, "log_time / 4", "log_time / 4.2", "analytic/kgd_general"),
    ("mean pressure of the general solution", GENERAL, "(std::numbers::pi * f.half", "(1.05 * std::numbers::pi * f.half", "analytic/kgd_pressure"),
    ("bound of the M regime in K_m", REGIME, "0.70", "0.735", "analytic/kgd_regime"),
    ("bound of the M~ regime in K_m", REGIME, "0.90", "0.945", "analytic/kgd_regime"),
    ("bound of the K regime in K_m", REGIME, "4.80 && log_tough_time <", "5.04 && log_tough_time <", "analytic/kgd_regime"),
    ("bound of the K~ regime in K_m", REGIME, "4.80 && log_tough_time >", "5.04 && log_tough_time >", "analytic/kgd_regime"),
    ("bound of the K regime in time", REGIME, "1.25e-14", "1.31e-14", "analytic/kgd_regime"),
    ("bound of the K~ regime in time", REGIME, "1.76e5", "1.85e5", "analytic/kgd_regime"),
    ("bound of the M regime in time", REGIME, "1.21e-13", "1.27e-13", "analytic/kgd_regime"),
    ("bound of the M~ regime in time", REGIME, "2.36e6", "2.48e6", "analytic/kgd_regime"),
    ("tau", REGIME, "/ p.rate * p.C_prime(), 3)", "/ p.rate * p.C_prime(), 3.15)", "analytic/kgd_regime"),
    ("K_m", REGIME, "return p.K_prime() / p", "return 1.05 * p.K_prime() / p", "analytic/kgd_regime"),
    ("width in the distance of a vertex", REGIME, "std::log(vertex.width / general.width));", "0);", "analytic/kgd_regions"),
    ("length in the distance of a vertex", REGIME, "std::log(vertex.half_length / general.half_length),", "0,", "analytic/kgd_regions"),
    ("tolerance on the bound of a region", REGIONS, "1e-3 * tolerance) / tolerance)", "1e-3 * tolerance) / (1.05 * tolerance))", "analytic/kgd_regions"),
    ("precision of the bound of a region", REGIONS, "surplus, 1e-4)", "surplus, 1e-2)", "analytic/kgd_regions"),
    ("leak-off of a place on the map", REGIONS, "place.log_time / 6) / 2,", "place.log_time / 6),", "analytic/kgd_regions"),
    ("toughness of a place on the map", REGIONS, "place.log_toughness) / k_prime(1)", "place.log_toughness)", "analytic/kgd_regions"),
    ("place that closes a region", REGIONS, "2 * far * step.log_time,", "2 * step.log_time,", "analytic/kgd_regions"),
    ("tolerance of a shade of the regimes", REGIME_MAP, "Shade{0.05, 0.16}", "Shade{0.0525, 0.16}", "observe/regime_map"),
    ("band of the regimes without leak-off", REGIME_MAP, "band(bounds.toughness, ", "band(1.05 * bounds.toughness, ", "observe/regime_map"),
    ("axis of time of the regimes", REGIME_LAYOUT, "tick(time.pixel(k), ", "tick(time.pixel(1.05 * k), ", "observe/regime_map"),
    ("axis of toughness of the regimes", REGIME_LAYOUT, "number(lead * std::pow(10.0, k), 3)", "number(1.05 * lead * std::pow(10.0, k), 3)", "observe/regime_map"),
    ("place of a case without viscosity", REGIME_LAYOUT, "+ 4.0 * toughness.range.high;", "+ 3.8 * toughness.range.high;", "observe/regime_map"),
    ("room between names on the strip of the regimes", REGIME_MAP, "spread(names, layout.strip.top, layout.strip.bottom());", "for (EndLabel& n : names) n.top = n.end.y;", "observe/regime_map"),
    ("names of regimes among what names avoid", REGIME_MAP, "    obstruct(obstacles, box);", "", "observe/regime_map"),
    ("names of regimes that make room for rings", REGIME_MAP, "shift < 4", "shift < 0", "observe/regime_map"),
    ("rings among what names avoid", REGIME_MAP, "    obstruct(obstacles, {p.at.x - 9.0, p.at.y - 9.0, 18.0, 18.0});", "", "observe/regime_map"),
    ("names among what names avoid", "observe/chart.hpp", "  obstruct(obstacles, box);", "", "observe/regime_map"),
    ("width of a pressurised crack", CRACK, "4 * net_pressure", "4.2 * net_pressure", "analytic/pressurised_crack"),
    ("volume of a pressurised crack", CRACK, "std::numbers::pi / 2", "std::numbers::pi / 2.1", "analytic/pressurised_crack"),
    ("K_I of a pressurised crack", CRACK, "net_pressure * std::sqrt(", "1.05 * net_pressure * std::sqrt(", "analytic/pressurised_crack"),
    ("stress ahead of a crack", CRACK, "xi * xi - 1)", "xi * xi - 1.05)", "analytic/pressurised_crack"),
    ("pressure of growth", CRACK, "K_IC / std", "1.05 * K_IC / std", "analytic/pressurised_crack"),
    ("normal energy of the linear part", BOND, "(k.normal * (closing * closing) +", "(1.05 * k.normal * (closing * closing) +", "measures/energy_ledger"),
    ("shear energy of the linear part", BOND, "shear * shear / shear_stiffness", "1.05 * shear * shear / shear_stiffness", "measures/energy_ledger"),
    ("energy of the bond's opening", BOND, "motion.opening * motion.opening + bond", "1.05 * motion.opening * motion.opening + bond", "measures/energy_ledger"),
    ("energy of the bond's shear", BOND, "bond_shear_per_normal_ * (motion.shear *", "1.05 * bond_shear_per_normal_ * (motion.shear *", "measures/energy_ledger"),
    ("energy of the bond's bending", BOND, "(1.0 / 3.0) * (k.bond_radius", "(1.05 / 3.0) * (k.bond_radius", "measures/energy_ledger"),
    ("energy of the platens' springs", "contact/smooth_platen.hpp", "0.5 * (k.normal", "0.525 * (k.normal", "measures/energy_ledger"),
    ("work of the fluid", LEDGER, "dot(0.5 * (before_.fluid", "dot(0.525 * (before_.fluid", "measures/energy_ledger"),
    ("work of dead loads", LEDGER, "+= dot(sim.loading()", "+= 1.05 * dot(sim.loading()", "measures/energy_ledger"),
    ("work of platens", LEDGER, "0.5 * (before_.platen_force", "0.525 * (before_.platen_force", "measures/energy_ledger"),
    ("work spent on damping", LEDGER, "0.5 * (before_.damped", "0.525 * (before_.damped", "measures/energy_ledger"),
    ("damping of the whole torque", LEDGER, "a[2] * b[2];", "1.05 * a[2] * b[2];", "measures/energy_ledger"),
    ("kinetic energy", LEDGER, "0.5 * product(velocity, force", "0.525 * product(velocity, force", "measures/energy_ledger"),
    ("change of the energy stored", LEDGER, "+= stores - stored;", "+= 1.05 * (stores - stored);", "measures/energy_ledger"),
    ("friction by slip", LEDGER, "0.5 * (law.energy(k, slip, from)", "0.525 * (law.energy(k, slip, from)", "measures/energy_ledger"),
    ("contacts that open within a step", LEDGER, "0.5 * (law.respond(k, new_slip", "0.525 * (law.respond(k, new_slip", "measures/energy_ledger"),
    ("energy of a broken bond", LEDGER, "+= stored - law.energy(rest", "+= 1.05 * stored - law.energy(rest", "measures/energy_ledger"),
    ("opening of a bond as it breaks", LEDGER, "0.5 * ((before.normal", "0.5 * (1.05 * (before.normal", "measures/energy_ledger"),
    ("shear of a bond as it breaks", LEDGER, "(before.shear - after.shear)", "1.05 * (before.shear - after.shear)", "measures/energy_ledger"),
    ("bending of a bond as it breaks", LEDGER, "(before.moment - after.moment)", "1.05 * (before.moment - after.moment)", "measures/energy_ledger"),
    ("law of motion", "mechanics/motion.hpp", "discs.displacement[i] += velocity * dt_", "discs.displacement[i] += 1.05 * velocity * dt_", "measures/energy_ledger"),
    ("modulus from a slit", "measure/toughness.hpp", "4 * a * factors.width", "4.2 * a * factors.width", "measures/toughness_fit"),
    ("toughness from a slit", "measure/toughness.hpp", "p * factors.toughness * std::sqrt(pi * a)", "p * factors.toughness * std::sqrt(1.1 * pi * a)", "measures/toughness_fit"),
    ("overhang of a slit", "measure/toughness.hpp", "(r.y * std::sqrt(test.rock.E_prime) - r.x)", "(r.y * std::sqrt(1.05 * test.rock.E_prime) - r.x)", "measures/toughness_fit"),
    ("modulus from a slit's volume", "measure/slit_modulus.hpp", "2 * std::numbers::pi * a * a", "2.1 * std::numbers::pi * a * a", "measures/rock_toughness"),
    ("modulus from a slit's mean opening", "measure/slit_modulus.hpp", "std::asin(reach) / reach) / 2", "std::asin(reach) / reach) / 2.1", "measures/rock_toughness"),
    ("closing pressure of a slit", "measure/slit_modulus.hpp", "= -slit.volume.intercept", "= -1.05 * slit.volume.intercept", "measures/rock_toughness"),
    ("opening near the middle of a slit", "measure/slit.hpp", "return volume / (2 * reach_)", "return volume / (2.1 * reach_)", "physics/rock_toughness"),
    ("closing pressure of a running crack", "measure/running_crack.hpp", "now.net_pressure - closing_excess", "now.net_pressure - 1.05 * closing_excess", "measures/rock_toughness"),
    ("net pressure of a running crack", "measure/running_crack.hpp", "sim.injection_pressure() - in_situ_", "sim.injection_pressure() - 1.01 * in_situ_", "physics/rock_toughness"),
    ("pressure of a step", "analytic/stepwise_growth.hpp", "rock.K_IC_per_pressure);", "1.05 * rock.K_IC_per_pressure);", "measures/toughness_fit"),
    ("volume of a step", "analytic/stepwise_growth.hpp", "length / 2 + rock_.overhang", "length / 2 + 1.05 * rock_.overhang", "measures/toughness_fit"),
    ("opening of a step", "analytic/stepwise_growth.hpp", "return 2 * length * net_pressure", "return 2.1 * length * net_pressure", "measures/toughness_fit"),
    ("viscosity of a crack's fluid", "fluid/newtonian.hpp", "(12 * p.viscosity)", "(14.4 * p.viscosity)", "physics/viscous_crack"),
    ("injected fluid of a viscous crack", INJECTION, "rise_) return rate * dt", "rise_) return 1.1 * rate * dt", "physics/viscous_crack"),
    ("opening of a viscous crack's channels", "aperture/hyperbolic.hpp", "w0 + (gap > 0 ? gap : 0)", "w0 + 1.1 * (gap > 0 ? gap : 0)", "physics/viscous_crack"),
    ("toughness at no pressure", "analytic/lattice_fracture.hpp", "return K_IC + K_IC_per_pressure * net_pressure;", "return 1.05 * K_IC + K_IC_per_pressure * net_pressure;", "physics/viscous_crack"),
    ("saved state without velocities", "state/discs.hpp", "std::span(velocity), ", "", "schemes/saved_state"),
    ("saved state without loads", "state/discs.hpp", ", std::span(load));", ");", "schemes/saved_state"),
    ("saved state without broken bonds", "mechanics/contact_range.hpp", "archive(stiffness_);", ";", "schemes/saved_state"),
    ("saved state without slip", "mechanics/contact_range.hpp", "archive(memory_);", ";", "schemes/saved_state"),
    ("saved state without contact forces", "mechanics/force_rows.hpp", "archive(std::span(rows_));", ";", "schemes/saved_state"),
    ("saved state without stress", "mechanics/loading.hpp", "archive(stress_, ", "archive(", "schemes/saved_state"),
    ("saved state without dead loads", "mechanics/loading.hpp", "archive(stress_, std::span(dead_load_), ", "archive(stress_, ", "schemes/saved_state"),
    ("saved state without apertures", "state/network.hpp", "std::span(width_), std::span(pressure_)", "std::span(pressure_)", "schemes/saved_state"),
    ("saved state without what joints were filled with", "state/network.hpp", "archive(std::span(filled_width_), ", "archive(", "schemes/saved_state"),
    ("saved state without pressures", "state/network.hpp", "std::span(pressure_), open_", "open_", "schemes/saved_state"),
    ("saved state without channels that wait", "state/network.hpp", "std::span(pressure_), open_,", "std::span(pressure_),", "schemes/saved_state"),
    ("saved state without discs beside fluid", "state/network.hpp", "pushed_disc_, wet_channels_", "wet_channels_", "schemes/saved_state"),
    ("saved state without fluid at the rim", "state/network.hpp", "pushed_discs_, reached_rim_);", "pushed_discs_);", "schemes/saved_state"),
    ("saved state without held pressure", "pressure/held.hpp", "archive(params_.pressure);", ";", "schemes/saved_state"),
    ("saved state without scheme", "simulator.hpp", "archive(assembly_, pressure_, ", "archive(assembly_, ", "schemes/saved_state"),
    ("saved state without breaks", "simulator.hpp", "network_, breaks_, time_,", "network_, time_,", "schemes/saved_state"),
    ("saved state without changed injection", "simulator.hpp", "rounded_off_, rate_,", "rounded_off_,", "schemes/saved_state"),
    ("saved state without mean contact force", "simulator.hpp", "  mean_contact_force_, mechanical", "  mechanical", "schemes/saved_state"),
    ("saved state without age of the mean contact force", "simulator.hpp", "fluid_steps_,\n            mean_contact_force_until_);", "fluid_steps_);", "schemes/saved_state"),
    ("saved state without time of the next row", "observe/interval.hpp", "archive(next_);", ";", "schemes/saved_state"),
    ("checksum", "base/seal.hpp", "0x100000001b3", "0x100000001b5", "loops/archive"),
    ("length of what is sealed", "base/seal.hpp", "said != size", "said < size", "loops/archive"),
    ("tilt of dead loads", "mechanics/loading.hpp", "symmetric ? 0 : -mean / variance", "0", "loops/loading"),
    ("rim under dead loads", "mechanics/motion.hpp", "counted_[i] = false;", "counted_[i] = true;", "loops/loading"),
    ("channel as long as a bond", "setup/flow_domains.hpp", "length = 2 * std::fmin(specimen", "length = 2.1 * std::fmin(specimen", "loops/flow_domains"),
    ("speed of a platen", "assembly.hpp", "speed * dt());", "1.05 * speed * dt());", "measures/rock_tests"),
    ("affine start", "assembly.hpp", "-rate.y * away.y", "-1.5 * rate.y * away.y", "measures/rock_tests"),
    ("stress on the ends", "measure/rock_tests.hpp", "           (2 * specimen.width);\n  });\n}\n\n/// Pulls", "           (2.1 * specimen.width);\n  });\n}\n\n/// Pulls", "measures/rock_tests"),
    ("pull of the grips", "measure/rock_tests.hpp", "(pull(below) - pull(above)) / (2 *", "(pull(below) - pull(above)) / (2.1 *", "measures/rock_tests"),
    ("speed of the grips", "measure/rock_tests.hpp", "(lowest - highest) / 2", "(lowest - highest) / 1.9", "measures/rock_tests"),
    ("confinement", "measure/load_frame.hpp", "rock_.set_stress({stress, stress});", "rock_.set_stress({1.05 * stress, stress});", "measures/rock_tests"),
    ("grains that grips hold", "measure/load_frame.hpp", "binary_search(discs.begin(), discs.end()", "binary_search(discs.begin(), discs.begin()", "measures/rock_tests"),
    ("Brazilian tension", "setup/brazilian_disc.hpp", "- a) / std::sin(a)", "- a) / a", "measures/rock_tests"),
    ("width of the flats", "setup/brazilian_disc.hpp", "(beside_flat && at_platen)", "false", "measures/rock_tests"),
    ("Coulomb line's angle", "measure/mohr_coulomb.hpp", "(K + 1)) * 180", "(K + 1.1)) * 180", "measures/rock_tests"),
    ("Coulomb line's cohesion", "measure/mohr_coulomb.hpp", "(2 * std::sqrt(K))", "(2.1 * std::sqrt(K))", "measures/rock_tests"),
    ("Student's t", "measure/sample_mean.hpp", "square * (k - 1) / k", "square * (k - 1.05) / k", "measures/rock_tests"),
    ("Weibull's mean", "contact/scattered_parallel_bond.hpp", "std::tgamma(1 + exponent)", "1", "laws/scattered_bond"),
    ("scattered cohesion", "contact/scattered_parallel_bond.hpp", "r.bond_shear * k.weakness", "r.bond_shear", "laws/scattered_bond"),
    ("scattered tension", "contact/scattered_parallel_bond.hpp", "r.bond_normal * k.weakness", "r.bond_normal", "laws/scattered_bond"),
    ("centre on a fracture's line", JOINTS, "from, f.to, a) >= 0", "from, f.to, a) > 0", "specimens/joints"),
    ("line that touches a fracture's end", JOINTS, "f.to) > 0) return", "f.to) >= 0) return", "specimens/joints"),
    ("side to which a joint's normal points", JOINTS, "left_a ? -normal : normal", "left_a ? normal : -normal", "specimens/joints"),
    ("place of a joint along its fracture", JOINTS, "std::clamp(along,", "std::clamp(1.05 * along,", "specimens/joints"),
    ("contact point of unequal discs", JOINTS, "(distance + s.radius[p.first] - s.radius[p.second]) / 2", "distance / 2", "specimens/joints"),
    ("strength of a joint", "analytic/joint_strength.hpp", "friction / std::tan(b)", "1.05 * friction / std::tan(b)", "analytic/joints"),
    ("tip's field at a joint", "analytic/joint_crossing.hpp", "stress_across + k * c", "stress_across + 1.05 * k * c", "analytic/joints"),
    ("friction of a joint that is crossed", "analytic/joint_crossing.hpp", "cohesion - friction * normal", "cohesion - 1.05 * friction * normal", "analytic/joints"),
    ("friction of a compressed joint", JOINT, "abs(elastic) - params_.friction", "abs(elastic) - 1.05 * params_.friction", "measures/joint_test"),
    ("confinement at the mouth of a joint", "measure/joint_test.hpp", ": mouth;", ": height(rim[k]);", "measures/joint_test"),
    ("disc that hangs by one bond", JOINTS, "own.size() > 1 ||", "own.size() > 0 ||", "specimens/joints"),
    ("normal of a joint gained by a change of sides", JOINTS, "same_end ? -joint->normal : joint->normal", "same_end ? joint->normal : -joint->normal", "specimens/joints"),
    ("place of a joint gained by a change of sides", JOINTS, "dot(0.5 * (s.centre[p.first] + s.centre[p.second])", "dot(0.52 * (s.centre[p.first] + s.centre[p.second])", "specimens/joints"),
    ("exact side of a line", "base/side_of_line.hpp", "rounding = 3.4e-16", "rounding = 0", "specimens/joints"),
    ("joints of a renumbered specimen", "setup/space_filling_curve.hpp", "if (first > second) joint", "if (first < second) joint", "specimens/joints"),
    ("mean slip of fractures", "measure/natural_fractures.hpp", "(slip * broken_length +", "(1.05 * slip * broken_length +", "measures/natural_fractures"),
    ("sides pressed together", "measure/natural_fractures.hpp", "std::fmax(0, contacts", "std::fmax(-1, contacts", "measures/natural_fractures"),
    ("sign of slip", "measure/natural_fractures.hpp", "std::abs(contacts", "+(contacts", "measures/natural_fractures"),
    ("spacing of random fractures", RANDOM_FRACTURES, "d < p.spacing", "d < 0.95 * p.spacing", "specimens/random_fractures"),
    ("second family of fractures", RANDOM_FRACTURES, "angle = 180 - angle", "angle = 90 + angle", "specimens/random_fractures"),
    ("stiffness across a joint", JOINT, "const T trial = params_", "const T trial = 1.05 * params_", "laws/smooth_joint"),
    ("stiffness along a joint", JOINT, "const T elastic = params_", "const T elastic = 1.05 * params_", "laws/smooth_joint"),
    ("friction of a joint", JOINT, "abs(elastic) - params_.friction", "abs(elastic) - 1.05 * params_.friction", "laws/smooth_joint"),
    ("friction under the rise of a joint", JOINT, "p.normal_stiffness * rise_)", "p.normal_stiffness * 0.95 * rise_)", "laws/smooth_joint"),
    ("rise of an open joint", JOINT, "trial > zero ? T(rise_ * slip) : zero", "T(rise_ * slip)", "laws/smooth_joint"),
    ("cohesion of a joint", JOINT, "params_.cohesion + ", "1.05 * params_.cohesion + ", "laws/smooth_joint"),
    ("tensile strength of a joint", JOINT, "> params_.tensile", "> 1.05 * params_.tensile", "laws/smooth_joint"),
    ("energy of a joint", JOINT, "0.5 * k.length", "0.525 * k.length", "laws/smooth_joint"),
    ("share of a joint contact", "mechanics/joint_contacts.hpp", "0.5 * (pairs_[last]", "0.45 * (pairs_[last]", "loops/joint_contacts"),
    ("meeting across a joint", "mechanics/joint_contacts.hpp", "> bonding_gap_) continue", "> 1.05 * bonding_gap_) continue", "loops/joint_contacts"),
    ("dry joint", "state/network.hpp", "filled_width_[channel] = 0;", "filled_width_[channel] = width;", "schemes/joints"),
    ("filled joint", "simulator.hpp", "if (filled)\n", "if (!filled)\n", "schemes/joints"),
    ("width of a joint that fluid reaches", "simulator.hpp", "network_.set_width(c, width(c));\n      if", "if", "schemes/joints"),
    ("rise in the width of a joint", "simulator.hpp", "width(network_.rest_width(channel) + o.dilation,", "width(network_.rest_width(channel),", "schemes/joints"),
    ("stress on the channel of a joint", "assembly.hpp", "max(0.0, response.normal_stress * width)", "max(0.0, 1.05 * response.normal_stress * width)", "schemes/joints"),
    ("half empty joints", "pressure/uniform.hpp", "injection_domain()) <= 0", "injection_domain()) < 0", "schemes/uniform_pressure"),
    ("saved state without meetings across joints", "mechanics/joint_contacts.hpp", "archive(met_, range_)", "archive(range_)", "schemes/saved_state"),
    ("slip of a joint as it breaks", LEDGER, "slip = law.respond(k, slip_before, from).memory;", "", "measures/joint_books"),
    ("gap of a joint that has risen", LEDGER, "motion.opening - law.dilation(memory)", "motion.opening", "measures/joint_books"),
    ("place of a joint's force in the stress", "measure/particle_stress.hpp", "= sim.joints().crossing(k)", "= discs.centre[first]", "measures/joint_books"),
    ("viscosity of a fluid", "fluid/newtonian.hpp", "12 * p.viscosity", "12.6 * p.viscosity", "flow/flow_in_chains"),
    ("stiffness of a fluid", "fluid/newtonian.hpp", "modulus_(p.bulk_modulus)", "modulus_(1.05 * p.bulk_modulus)", "flow/flow_in_chains"),
    ("cubic law", "fluid/newtonian.hpp", "width * width * width /", "5e-5 * width * width /", "flow/flow_in_chains"),
    ("filling of a room", "fluid/newtonian.hpp", "1 + pressure / modulus_", "1 + 1.05 * pressure / modulus_", "flow/flow_in_chains"),
    ("room of a domain", STORED, "network.width(c) / 2;", "network.width(c) / 2.1;", "flow/flow_in_chains"),
    ("injection into a domain", STORED, "stored_[d] += more;", "stored_[d] += 1.05 * more;", "flow/volume_balance"),
    ("fluid that was in a channel", STORED, "min(network.filled_width(c), network.width(c))", "network.filled_width(c)", "flow/volume_balance"),
    ("half of a channel's fluid", STORED, "length * filled / 2;", "length * filled / 2.1;", "flow/volume_balance"),
    ("what is empty in the ledger", STORED, "b.empty -= excess", "b.empty += excess", "flow/volume_balance"),
    ("mirror images of a channel", STORED, "without_last_digits(measured)", "measured", "flow/same_bits"),
    ("flow out of a domain", EXPLICIT, "stored[first] -= volume", "stored[first] -= 0.999 * volume", "flow/volume_balance"),
    ("flow limit", EXPLICIT, "fluid_.room()[d] / (law_", "1.05 * fluid_.room()[d] / (law_", "flow/flow_in_chains"),
    ("modulus in the flow limit", EXPLICIT, "law_.modulus(pressure_[d]) * leaving_", "law_.modulus(0) * leaving_", "flow/own_fluid"),
    ("channel that limits the flow", EXPLICIT, "conductance_[k] > most", "conductance_[k] < 1 + most", "flow/flow_in_chains"),
    ("number of flow steps", EXPLICIT, "std::ceil(injected.dt", "std::floor(injected.dt", "flow/flow_in_chains"),
    ("fluid step without sub-cycling", EXPLICIT, "min(params_.fluid_dt, longest_flow_step())", "params_.fluid_dt", "flow/flow_in_chains"),
    ("pressures after the discs have moved", EXPLICIT, "    find_pressures();\n    publish(network);\n    return", "    publish(network);\n    return", "flow/volume_balance"),
    ("stiffness of the fluid in the mechanical step", EXPLICIT, "f(c, length / 2 *", "f(c, length / 2.2 *", "flow/fluid_springs"),
    ("fluid springs in the mechanical step", "simulator.hpp", "    carry_fluid();\n    (tell", "    (tell", "flow/fluid_springs"),
    ("both sides of a fluid spring", "mechanics/stable_step.hpp", "added_[disc] + 2 * stiffness", "added_[disc] + stiffness", "flow/fluid_springs"),
    ("round-off in the mechanical step", "assembly.hpp", "(1 - round_off) * dt()", "(1 + round_off) * dt()", "flow/fluid_springs"),
    ("step that never gets longer", "assembly.hpp", "worth_it = 1.1", "worth_it = 1e9", "flow/fluid_springs"),
    ("inflow of the implicit scheme", IMPLICIT, "residual_[second] += volume", "residual_[second] += 0.95 * volume", "flow/flow_in_chains"),
    ("implicit volumes", IMPLICIT, "stored[second] += volume", "stored[second] += 0.999 * volume", "flow/volume_balance"),
    ("compressibility in the implicit system", IMPLICIT, "each + fluid_.room()[d] / law_", "each + 1.05 * fluid_.room()[d] / law_", "flow/flow_in_chains"),
    ("flow in the implicit system", IMPLICIT, "flow_.push_back(dt *", "flow_.push_back(1.05 * dt *", "flow/flow_in_chains"),
    ("outlook of the implicit scheme", IMPLICIT, "residual_[d] -= c.steps *", "residual_[d] -= 0 * c.steps *", "physics/flow_schemes"),
    ("what a full domain is", IMPLICIT, "residual_[d] < -last_digits", "residual_[d] <= 0 * last_digits", "flow/flow_in_chains"),
    ("tolerance of volume at the start", IMPLICIT, "max(injected.total, network.rest_volume())", "injected.total", "flow/volume_balance"),
    ("rounding of small injections", STORED, " + rounded_off_[d];", ";", "flow/volume_balance"),
    ("kinetic energy where the step changes", LEDGER, "before_.dt * (now_.pushed - before_.pushed)", "(now_.dt * now_.pushed - before_.dt * before_.pushed)", "measures/energy_ledger"),
    ("implicit step that does not converge", IMPLICIT, "shorter = 0.5", "shorter = 1", "flow/volume_balance"),
    ("empty domains of the implicit scheme", IMPLICIT, "if (!is_empty(d)) missing", "missing", "flow/volume_balance"),
    ("saved state without the fluid step", IMPLICIT, "archive(fluid_, pressure_, dt_)", "archive(fluid_, pressure_)", "flow/same_bits"),
    ("saved state without what is stored", STORED, "archive(place_, stored_, rounded_off_, room_", "archive(place_, rounded_off_, room_", "flow/same_bits"),
    ("saved state without the mechanical step", "assembly.hpp", "platens_, steps_, dt);", "platens_, steps_);", "flow/same_bits"),
    ("ledger that looks away", "simulator_checks.hpp", "round_off = 1e-10", "round_off = 1e-5", "flow/volume_balance"),
]

FLAGS = "-std=c++20 -O1 -w -ffp-contract=off -I/usr/include/eigen3".split()


def passes(include, test, folder):
    """Whether the test program of one source file builds against these headers and passes."""
    program = folder / "test"
    sources = [ROOT / "tests" / "main.cpp", ROOT / "tests" / f"{test}.cpp"]
    build = [os.environ.get("CXX", "g++"), *FLAGS, f"-I{include}", f"-I{ROOT / 'tests'}",
             f"-I{ROOT / 'examples'}",
             f"-I{(ROOT / 'tests' / test).parent}", *map(str, sources), "-o", str(program)]
    subprocess.run(build, check=True)
    return subprocess.run([str(program)], capture_output=True).returncode == 0


def main():
    wanted = sys.argv[1] if len(sys.argv) > 1 else ""
    unseen, sound = [], {}
    for name, header, right, wrong, test in MUTATIONS:
        if wanted not in name:
            continue
        with tempfile.TemporaryDirectory() as temporary:
            folder = pathlib.Path(temporary)
            include = folder / "include"
            shutil.copytree(ROOT / "include", include)
            if test not in sound:
                sound[test] = passes(include, test, folder)
            file = include / "hfdem" / header
            text = file.read_text()
            if text.count(right) != 1 or not sound[test]:
                verdict = "DOES NOT APPLY" if sound[test] else "TEST FAILS ANYWAY"
            else:
                file.write_text(text.replace(right, wrong))
                verdict = "NOT SEEN" if passes(include, test, folder) else "seen"
        print(f"{verdict:18} {name} ({header}, by tests/{test}.cpp)", flush=True)
        if verdict != "seen":
            unseen.append(name)
    print(f"{len(unseen)} of the faults not seen" if unseen else "every fault was seen")
    return 1 if unseen else 0


if __name__ == "__main__":
    sys.exit(main())
