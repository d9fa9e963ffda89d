/// @file
/// What becomes of natural fractures: joints.csv over time, natural_fractures.csv at the end, their
/// part of the summary and of the report (the paper's Table 5).
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <hfdem/measure/microcracks.hpp>
#include <hfdem/measure/natural_fractures.hpp>
#include <hfdem/observe/chart.hpp>
#include <hfdem/observe/history.hpp>
#include <hfdem/observe/interval.hpp>
#include <hfdem/observe/report.hpp>

#include "support/growing_file.hpp"
#include "support/output_folder.hpp"
#include "support/paper.hpp"
#include "support/run_report.hpp"
#include "support/summary.hpp"

namespace hfdem::support {

/// An observer that measures all natural fractures every so often.
template <class Sim>
class JointRecord {
 public:
  /// @param interval s; a row follows the first fluid step at or after each multiple of it
  /// @param resumes whether the run goes on with what is in the folder
  JointRecord(const OutputFolder& folder, double interval, bool resumes)
      : folder_(folder), interval_(interval), file_(folder, "joints.csv", resumes) {
    if (resumes) return;
    file_.out() << "time_s,injection_pressure_Pa,microcracks,connected_microcracks,"
                   "broken_length_m,connected_length_m,mean_slip_m,largest_slip_m,"
                   "mean_opening_m,largest_opening_m\n";
  }

  void fluid_step(const Sim& sim) {
    if (!interval_.is_due(sim.time())) return;
    interval_.wait_from(sim.time());
    const auto now = measure::total(measure::fracture_activity(sim));
    times_.push_back(sim.time());
    totals_.push_back(now);
    observe::write_row(file_.out(), {sim.time(), sim.injection_pressure(), double(now.broken),
                                     double(now.connected), now.broken_length, now.connected_length,
                                     now.slip, now.largest_slip, now.opening, now.largest_opening});
  }

  /// @throws OutputFailed if anything written was lost
  void close() { file_.close(); }

  /// What the run has come to so far.
  void exchange(auto& archive) { archive(interval_, file_, times_, totals_); }

  /// Writes what there is at the end.
  void finish(const Sim& sim, const std::string& conditions) {
    close();
    folder_.write("natural_fractures.csv", each(sim));
    folder_.write("joints.svg", svg(motion(conditions)));
    folder_.write("joint_lengths.svg", svg(lengths(conditions)));
  }

  /// @param paper what is printed there of the run's case
  void summarise(Summary& s, const Sim& sim, const paper::Case& paper) const {
    const auto activity = measure::fracture_activity(sim);
    const auto sum = measure::total(activity);
    s.set("joints/fractures", static_cast<long>(activity.size()));
    s.set("joints/fractures_broken", count(activity, &Activity::broken));
    s.set("joints/fractures_reached", count(activity, &Activity::connected));
    s.set("joints/contacts", static_cast<long>(sim.joints().bonded()));
    for (const auto& [name, c] : table_5(sim)) {
      s.set("joints/" + name + "/tension", c.tension);
      s.set("joints/" + name + "/shear", c.shear);
    }
    s.set("joints/length_m", sum.length);
    s.set("joints/broken_length_m", sum.broken_length);
    s.set("joints/connected_length_m", sum.connected_length);
    s.set("joints/mean_slip_m", sum.slip);
    s.set("joints/largest_slip_m", sum.largest_slip);
    s.set("joints/mean_opening_m", sum.opening);
    s.set("joints/largest_opening_m", sum.largest_opening);
    if (std::isnan(paper.joint_microcracks)) return;
    s.compare("paper/joint_microcracks", sum.broken, paper.joint_microcracks);
    s.compare("paper/connected_joint_microcracks", sum.connected, paper.connected_microcracks);
  }

  /// @param paper what is printed there of the run's case
  void add_to(observe::Report& page, const Sim& sim, const std::string& conditions,
              const paper::Case& paper) const {
    page.section("Natural fractures");
    page.table(counts(sim, paper));
    page.figure(motion(conditions));
    page.figure(lengths(conditions));
    page.table(fractures(sim));
  }

  /// For the report's list of files.
  static const std::vector<observe::File>& said_files() {
    static const std::vector<observe::File> files{
        {"fractures.csv", "the natural fractures; for --fractures"},
        {"joints.csv", "what broke of them, slip and opening over time"},
        {"natural_fractures.csv", "the same of each fracture at the end"},
        {"joints.svg", "slip and opening over time"},
        {"joint_lengths.svg", "broken and connected length over time"}};
    return files;
  }

 private:
  using Activity = measure::FractureActivity;
  struct Row {
    std::string name;
    measure::MicrocrackCount count;
  };

  static long count(const std::vector<Activity>& all, int Activity::*value) {
    return std::count_if(all.begin(), all.end(), [&](const auto& a) { return a.*value > 0; });
  }

  /// Microcracks by place and fluid; the preset crack, which was cut, is not among them.
  static std::vector<Row> table_5(const Sim& sim) {
    const auto all = measure::microcracks(sim);
    const auto in = [&](bool joint) {
      return measure::count(all, [joint](const auto& m) { return m.mode && m.in_joint == joint; });
    };
    const auto rock = in(false), joints = in(true);
    return {{"in_rock_connected", rock.connected},
            {"in_rock_unconnected", rock.unconnected},
            {"in_joints_connected", joints.connected},
            {"in_joints_unconnected", joints.unconnected}};
  }

  static observe::Table counts(const Sim& sim, const paper::Case& paper) {
    const bool beside_paper = std::isfinite(paper.joint_microcracks);
    observe::Table table{.caption = "Microcracks at the end, as in the paper's Table 5.",
                         .header = {"", "in tension", "in shear", "together"}};
    if (beside_paper) table.header.push_back("paper");
    const auto add = [&](const std::string& name, int tension, int shear, double published) {
      table.rows.push_back(
          {name, std::to_string(tension), std::to_string(shear), std::to_string(tension + shear)});
      if (beside_paper)
        table.rows.back().push_back(std::isfinite(published) ? observe::fixed(published, 0)
                                                             : "\u2013");
    };
    const auto rows = table_5(sim);
    const auto &connected = rows[2].count, &unconnected = rows[3].count;
    add("in rock, connected", rows[0].count.tension, rows[0].count.shear, NAN);
    add("in rock, unconnected", rows[1].count.tension, rows[1].count.shear, NAN);
    add("in natural fractures, connected", connected.tension, connected.shear,
        paper.connected_microcracks);
    add("in natural fractures, unconnected", unconnected.tension, unconnected.shear, NAN);
    add("in natural fractures", connected.tension + unconnected.tension,
        connected.shear + unconnected.shear, paper.joint_microcracks);
    return table;
  }

  static observe::Table fractures(const Sim& sim) {
    observe::Table table{
        .caption = "Each natural fracture at the end. Means are over what broke of it.",
        .header = {"", "length", "broken", "connected", "mean slip", "largest", "mean opening",
                   "largest"}};
    const auto add = [&](const std::string& name, const Activity& a) {
      table.rows.push_back({name, metres(a.length), metres(a.broken_length),
                            metres(a.connected_length), micrometres(a.slip),
                            micrometres(a.largest_slip), micrometres(a.opening),
                            micrometres(a.largest_opening)});
    };
    const auto all = measure::fracture_activity(sim);
    for (std::size_t k = 0; k < all.size(); ++k)
      if (all[k].broken > 0) add(std::to_string(k + 1), all[k]);
    add("all " + std::to_string(all.size()), measure::total(all));
    return table;
  }

  static std::string each(const Sim& sim) {
    std::ostringstream out;
    out << "fracture,x1_m,y1_m,x2_m,y2_m,length_m,microcracks,connected_microcracks,"
           "broken_length_m,connected_length_m,mean_slip_m,largest_slip_m,mean_opening_m,"
           "largest_opening_m\n";
    const auto all = measure::fracture_activity(sim);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const auto& [from, to] = sim.joints().fractures()[k];
      const Activity& a = all[k];
      observe::write_row(
          out, {double(k + 1), from.x, from.y, to.x, to.y, a.length, double(a.broken),
                double(a.connected), a.broken_length, a.connected_length, a.slip, a.largest_slip,
                a.opening, a.largest_opening});
    }
    return out.str();
  }

  observe::Chart motion(const std::string& conditions) const {
    observe::Chart chart{.title = "Slip and opening of the natural fractures",
                         .x_label = "injection time (s)",
                         .y_label = "slip, opening (µm)",
                         .caption = "Means are over the length that has broken by then.",
                         .conditions = conditions};
    chart.series = {line("largest slip", 1e6, &Activity::largest_slip),
                    line("mean slip", 1e6, &Activity::slip),
                    line("largest opening", 1e6, &Activity::largest_opening),
                    line("mean opening", 1e6, &Activity::opening)};
    return chart;
  }

  observe::Chart lengths(const std::string& conditions) const {
    observe::Chart chart{.title = "How much of the natural fractures broke",
                         .x_label = "injection time (s)",
                         .y_label = "length (m)",
                         .caption = "Of " + metres(totals_.empty() ? 0 : totals_.back().length) +
                                    " in all. Connected: fluid reaches it from the injection.",
                         .conditions = conditions};
    chart.series = {line("broken", 1, &Activity::broken_length),
                    line("connected", 1, &Activity::connected_length)};
    return chart;
  }

  observe::Series line(const std::string& name, double factor, double Activity::*value) const {
    observe::Series s{.name = name, .x = times_};
    for (const auto& t : totals_) s.y.push_back(factor * (t.*value));
    return s;
  }

  const OutputFolder& folder_;
  observe::Interval interval_;
  GrowingFile file_;
  std::vector<double> times_;
  std::vector<Activity> totals_;
};

}  // namespace hfdem::support
