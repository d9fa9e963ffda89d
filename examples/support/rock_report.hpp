/// @file
/// The report of a run in random rock.
#pragma once

#include <string>
#include <vector>

#include <hfdem/observe/report.hpp>

#include "support/energy_record.hpp"
#include "support/joint_record.hpp"
#include "support/leak_record.hpp"
#include "support/rock_figures.hpp"
#include "support/rock_outcome.hpp"
#include "support/run_report.hpp"

namespace hfdem::support {

template <class Config>
class RockReport {
 public:
  using Sim = typename Config::Sim;

  RockReport(const Config& config, const Manifest& manifest)
      : config_(config), manifest_(manifest) {
    page_.program = "hfdem " + manifest.version + ", program " + manifest.program;
  }

  /// The page of a run, whatever ended it.
  /// @param energy where the work went; null if no books were kept
  /// @param joints what became of natural fractures; null if there are none
  /// @param leak what the crack has lost; null if it loses nothing
  std::string html(const Sim& sim, const RockOutcome& o, const RockFigures<Config>& figures,
                   const EnergyRecord<Sim>* energy, const JointRecord<Sim>* joints,
                   const LeakRecord<Sim>* leak) {
    page_.title =
        "A crack of " + metres(o.end.tip_distance) + " after " + observe::fixed(o.end.time, 3, "s");
    page_.lead = "A crack driven by " + std::string(words_of(config_.simulator.scheme).driven_by) +
                 " through bonded discs of random size and place" +
                 (joints ? " with " + said(static_cast<long>(sim.joints().fractures().size())) +
                               " natural fractures: "
                         : std::string(": ")) +
                 described(config_, static_cast<long>(sim.discs().size()));
    if (!o.run.stopped.empty())
      page_.stopped = "At " + observe::fixed(o.end.time, 4, "s") + " of " +
                      said(config_.run.end_time, "s").both() + ": " + o.run.stopped +
                      ". What follows is the state at that moment.";
    add_answer(o);
    page_.figure(figures.fracture());
    page_.figure(figures.apertures());
    page_.figure(figures.net_pressures());
    page_.section("Growth of the crack");
    page_.figure(figures.pressure());
    page_.figure(figures.tips());
    page_.figure(figures.length());
    page_.figure(figures.aperture());
    if (leak) leak->add_to(page_, sim, described(config_, static_cast<long>(sim.discs().size())));
    page_.section("Stress around the crack");
    page_.figure(figures.stress());
    add_comparison(o);
    add_numbers(sim, o);
    if (joints)
      joints->add_to(page_, sim, described(config_, static_cast<long>(sim.discs().size())), paper_);
    if (energy)
      energy->add_to(page_, sim, described(config_, static_cast<long>(sim.discs().size())));
    add_run(page_, sim, o.run, manifest_);
    std::vector<observe::File> beside{
        {"summary.json", "the answer in numbers, with the references beside them"},
        {"history.csv", "pressure, tips, lengths, aperture and volumes over time"},
        {"profile.csv", "aperture, opening and net pressure along the path at the end"},
        {"cracks.csv", "time, place, length and mode of every bond that broke"},
        {"specimen.txt", "the discs as they were bonded; for --specimen"},
        {"paraview/particles.pvd", "discs over time, for ParaView: displacement, stress"},
        {"paraview/contacts.pvd", "contacts over time: force, moment, state"},
        {"paraview/cracks.pvd", "broken contacts over time: aperture, pressure"},
        {"config.toml", "every parameter; repeats the run with --config"},
        {"fracture.svg", "the crack, for other documents"},
        {"aperture_map.svg", "aperture along the crack"},
        {"pressure_map.svg", "net pressure along the crack"},
        {"pressure.svg", "injection pressure over time"},
        {"tips.svg", "both tips over time"},
        {"length.svg", "length over time"},
        {"aperture.svg", "aperture over time"},
        {"stress.svg", "minimum principal stress"}};
    if (joints)
      beside.insert(beside.end(), joints->said_files().begin(), joints->said_files().end());
    if (leak)
      for (const observe::File& file : leak->said_files()) beside.push_back(file);
    add_origin(page_, config_, beside, manifest_);
    return page_.html();
  }

  /// The page of a run that could not begin.
  std::string html(const std::string& reason) {
    return unbegun_page(page_, config_, reason, manifest_);
  }

 private:
  /// A line with a published number, where there is one.
  template <class Words>
  static std::string published(double value, Words&& words) {
    return std::isfinite(value) ? "paper " + words(value) : "";
  }

  void add_answer(const RockOutcome& o) {
    const auto plain = [](double v) { return observe::fixed(v, 2); };
    page_.numbers(
        {{"breakdown pressure", megapascals(o.breakdown), published(paper_.breakdown, megapascals)},
         {"propagation pressure", megapascals(o.propagation),
          "mean from " + observe::fixed(config_.readings.propagation_from, 2) + " to " +
              observe::fixed(config_.readings.propagation_to, 2, "s")},
         {"tortuosity", plain(o.end.tortuosity), published(paper_.tortuosity, plain)},
         {o.rim_time ? "reached the rim at" : "injection time", observe::fixed(o.end.time, 3, "s"),
          "of " + said(config_.run.end_time, "s").both()}});
  }

  void add_comparison(const RockOutcome& o) {
    using paper::Intact;
    page_.section("Comparison");
    const auto kgd = paper_kgd(config_, o.end.time);
    observe::Table table{.header = {"at t = " + observe::fixed(o.end.time, 3, "s"), "hfdem",
                                    "KGD, the paper's K_{IC}", "difference"}};
    const auto row = [&](const std::string& name, double ours, double theirs, auto&& words) {
      table.rows.push_back({name, words(ours), words(theirs), difference(ours, theirs)});
    };
    row("distance between the tips", o.end.tip_distance, kgd.full_length(), metres);
    row("mean aperture at the injection, w", o.end.aperture, kgd.width, micrometres);
    row("of which opened, w − w_{0}", o.end.opening, kgd.width, micrometres);
    row("net pressure", o.end.pressure - config_.closing_stress(), kgd.net_pressure, megapascals);
    page_.table(table);
    page_.text("KGD is the " + std::string(flows<Sim> ? "" : "toughness-dominated ") +
               "fracture in an infinite plane, for E' = " + said(Intact::E_prime, "Pa").both() +
               " and K_{IC} = " + in_words(Intact::K_IC / 1e6) +
               " MPa·m^{1/2}, with which the paper computed it. The paper's specimen is one of "
               "many: compare means over seeds, as the option --seeds does.");
    if (config_.simulator.channels.length == ChannelLength::bond)
      page_.text(
          "This run uses the channel length l_{p} = 2 R_{b}, found by trial to come closer "
          "to the paper's numbers together with fluid steps of 1 ms of at most ten "
          "mechanical steps and dead loads on the rim. It is no physical finding: on the "
          "square array two of these choices fail, and the fluid steps end before "
          "equilibrium.");
    if (!std::isfinite(paper_.tip_distance)) return;
    page_.text("The paper prints for its specimen at 1.5 s: tips " + metres(paper_.tip_distance) +
               " apart, microcracks of " + metres(paper_.total_length) +
               " in all, a tortuosity of " + observe::fixed(paper_.tortuosity, 2) +
               " and an aperture of " + micrometres(paper_.aperture) +
               ". In equilibrium, a crack of this toughness leaves a specimen of 1 m before that "
               "time: reaching the rim is what is to be expected.");
  }

  void add_numbers(const Sim& sim, const RockOutcome& o) {
    const auto& [connected, unconnected] = o.count;
    page_.section("The crack in numbers");
    page_.facts(
        {{"tips", metres(o.end.tip_up) + " and " + metres(o.end.tip_down) +
                      " from the injection, " + metres(o.end.tip_distance) + " apart"},
         {"path from tip to tip", metres(o.end.path_length)},
         {"connected microcracks", metres(o.end.connected_length) + " in all"},
         {"all microcracks", metres(o.end.total_length)},
         {"tortuosity of the wings, mean", observe::fixed(o.crack.mean_tortuosity(), 2)},
         {"asymmetry", observe::fixed(o.end.asymmetry, 2)},
         {"branches", said(static_cast<long>(o.crack.branches.size()))},
         {"microcracks", said(static_cast<long>(connected.total() + unconnected.total())) +
                             ", of which " + said(static_cast<long>(unconnected.total())) +
                             " hold no fluid"},
         {"in tension and in shear",
          said(static_cast<long>(connected.tension + unconnected.tension)) + " and " +
              said(static_cast<long>(connected.shear + unconnected.shear))},
         {"pressure at the first break", megapascals(o.first_break)},
         {"injected",
          observe::fixed(o.end.fluid_volume * 1e6, 2, "mL") + " per metre of thickness"},
         {"bonds", said(static_cast<long>(sim.contacts().size()))},
         {"contacts of the preset crack", said(static_cast<long>(sim.preset_contacts().size()))},
         {"Young's modulus of the specimen", observe::fixed(o.moduli.young / 1e9, 2, "GPa")},
         {"Poisson's ratio of the specimen", observe::fixed(o.moduli.poisson, 3)},
         {"a fluid step ends", std::string(words_of(config_.simulator.scheme).ends)}});
  }

  const Config& config_;
  const Manifest& manifest_;
  const paper::Case paper_ = paper_case(config_);
  observe::Report page_;
};

}  // namespace hfdem::support
