/// @file
/// A run as ParaView shows it: discs, contacts, broken contacts and pores at chosen times.
///
/// The folder holds, for every step that is written, `particles_0000.vtp`, `contacts_0000.vtp` and
/// `cracks_0000.vtp`, and `pores_0000.vtp` where fluid flows through the rock; open
/// `particles.pvd`, `contacts.pvd`, `cracks.pvd` and `pores.pvd`, which list them with their times.
/// The names of the arrays give their units.
///
/// - particles: a point at the present centre (where it was bonded, plus the displacement) of every
///   disc. Its stress is that of measure/particle_stress.hpp, a tensor of nine numbers whose third
///   row and column are zeros; the principal stresses are those in the plane.
/// - contacts: a line between the present centres of the two discs of every contact, bonded or
///   broken. The shear force is that on the second end along the line's direction turned left; the
///   moment resists the rotation of the second disc relative to the first. Joints feel normal and
///   shear forces across and along their fracture, whatever the line's direction.
/// - cracks: a line as long as the bond was wide, across every broken contact at the place where it
///   was bonded, or the piece of fracture for which a broken joint stands; the preset ones first,
///   then in the order of breaking. The pressure is the mean of the two flow domains that the
///   contact separates. What is broken but not connected to the injection holds no fluid: not wet,
///   no aperture. The preset contacts broke at time 0.
/// - pores: a polygon between the present centres of the discs around every flow domain, where
///   fluid flows through the rock.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <hfdem/base/fields.hpp>
#include <hfdem/base/whole_file.hpp>
#include <hfdem/measure/crack.hpp>
#include <hfdem/measure/particle_stress.hpp>
#include <hfdem/measure/pores.hpp>
#include <hfdem/observe/interval.hpp>
#include <hfdem/observe/vtk_xml.hpp>
#include <hfdem/state/discs.hpp>
#include <hfdem/state/network.hpp>
#include <hfdem/state/step.hpp>

namespace hfdem::observe {

/// What has become of a bond; the numbers stand in the files.
enum class BondState : std::uint8_t { intact = 0, tension = 1, shear = 2, preset = 3 };
/// The array of bond states, with what its numbers mean.
inline constexpr std::string_view bond_state_name =
    "state (0 intact, 1 tension, 2 shear, 3 preset)";
/// The array that tells joints from rock.
inline constexpr std::string_view place_name = "place (0 rock, 1 joint)";

/// An observer that writes the run into a folder every `interval` seconds of simulated time. All
/// files are complete at any time, the lists after each step.
class ParaView {
 public:
  /// @param folder is made if it does not exist
  /// @param interval s; a step is written at the first fluid step at or after each multiple of it
  /// @throws InvalidParameter if the interval is not positive
  /// @throws WriteFailed if the folder cannot be made
  ParaView(std::filesystem::path folder, double interval)
      : folder_(std::move(folder)), interval_(interval) {
    hfdem::detail::check_range("paraview", "interval", "s", positive, interval);
    make_folder(folder_);
  }

  /// Writes the present state if it is time to.
  /// @throws WriteFailed if a file cannot be written
  template <class Sim>
  void fluid_step(const Sim& sim, const FluidStep&) {
    if (interval_.is_due(sim.time())) write(sim);
  }

  /// Writes the present state: before the run for its first, after it for its last. What was
  /// written for the same time is replaced.
  /// @throws WriteFailed if a file cannot be written
  template <class Sim>
  void write(const Sim& sim) {
    if (times_.empty() || times_.back() != sim.time()) times_.push_back(sim.time());
    interval_.wait_from(sim.time());
    const std::vector<Broken> broken = broken_contacts(sim);
    put("particles", particles(sim));
    put("contacts", contacts(sim, broken));
    put("cracks", cracks(sim, broken));
    if constexpr (FlowsThroughRock<std::remove_cvref_t<decltype(sim.pressure_scheme())>>)
      put("pores", pores(sim));
  }

  /// When was written, and when to write again.
  void exchange(auto& archive) { archive(interval_, times_); }

 private:
  struct Broken {
    Index contact;
    BondState state;
    double time;
  };

  template <class Sim>
  static std::vector<Broken> broken_contacts(const Sim& sim) {
    std::vector<Broken> broken;
    for (const Index c : sim.preset_contacts()) broken.push_back({c, BondState::preset, 0});
    for (const auto& b : sim.breaks())
      broken.push_back(
          {b.contact, b.mode == Mode::tension ? BondState::tension : BondState::shear, b.time});
    return broken;
  }

  static std::array<std::uint8_t, 1> code(auto value) { return {static_cast<std::uint8_t>(value)}; }

  static void add_centres(VtkPolyData& file, const Discs& discs) {
    for (std::size_t i = 0; i < discs.size(); ++i)
      file.add_point(discs.centre[i] + Vec2{discs.displacement[i][0], discs.displacement[i][1]});
  }

  template <class Sim>
  static VtkPolyData particles(const Sim& sim) {
    const Discs& discs = sim.discs();
    const auto stress = measure::particle_stress(sim);
    VtkPolyData file(sim.time());
    add_centres(file, discs);
    file.show_points();
    file.add_to_points("radius (m)", [&](Index i) { return reals(discs.radius[i]); });
    file.add_to_points("displacement (m)", [&](Index i) {
      return reals(discs.displacement[i][0], discs.displacement[i][1], 0);
    });
    file.add_to_points("rotation (rad)", [&](Index i) { return reals(discs.displacement[i][2]); });
    file.add_to_points("stress (Pa, compression positive)", [&](Index i) {
      const auto& [xx, yy, xy] = stress[i];
      return reals(xx, xy, 0, xy, yy, 0, 0, 0, 0);
    });
    file.add_to_points("major principal stress (Pa, compression positive)",
                       [&](Index i) { return reals(stress[i].major()); });
    file.add_to_points("minor principal stress (Pa, compression positive)",
                       [&](Index i) { return reals(stress[i].minor()); });
    return file;
  }

  template <class Sim>
  static VtkPolyData contacts(const Sim& sim, const std::vector<Broken>& broken) {
    const auto contacts = static_cast<Index>(sim.contacts().size() + sim.joints().bonded());
    std::vector<BondState> state(contacts, BondState::intact);
    for (const Broken& b : broken) state[b.contact] = b.state;
    std::vector<Reaction<double>> reaction;
    VtkPolyData file(sim.time());
    add_centres(file, sim.discs());
    for (Index c = 0; c < contacts; ++c) {
      const auto [first, second] = sim.contact_geometry(c).bodies;
      file.add_line(first, second);
      reaction.push_back(sim.reaction(c));
    }
    file.add_to_lines("normal force (N/m, compression positive)",
                      [&](Index c) { return reals(reaction[c].normal); });
    file.add_to_lines("shear force (N/m)", [&](Index c) { return reals(reaction[c].shear); });
    file.add_to_lines("bond moment (N m/m)", [&](Index c) { return reals(reaction[c].moment); });
    file.add_to_lines(bond_state_name, [&](Index c) { return code(state[c]); });
    file.add_to_lines(place_name, [&](Index c) { return code(sim.is_joint(c)); });
    return file;
  }

  template <class Sim>
  static VtkPolyData cracks(const Sim& sim, const std::vector<Broken>& broken) {
    const Network& network = sim.network();
    VtkPolyData file(sim.time());
    for (std::size_t k = 0; k < broken.size(); ++k) {
      const auto [from, to] = measure::facet(sim, broken[k].contact);
      file.add_point(from);
      file.add_point(to);
      file.add_line(2 * k, 2 * k + 1);
    }
    file.add_to_lines("aperture (m)",
                      [&](Index k) { return reals(network.width(broken[k].contact)); });
    file.add_to_lines("pressure (Pa)",
                      [&](Index k) { return reals(pressure(network, broken[k].contact)); });
    file.add_to_lines("wet (0 dry, 1 wet)",
                      [&](Index k) { return code(network.is_wet(broken[k].contact)); });
    file.add_to_lines(bond_state_name, [&](Index k) { return code(broken[k].state); });
    file.add_to_lines(place_name, [&](Index k) { return code(sim.is_joint(broken[k].contact)); });
    file.add_to_lines("time of break (s)", [&](Index k) { return reals(broken[k].time); });
    return file;
  }

  template <class Sim>
  static VtkPolyData pores(const Sim& sim) {
    const std::vector<measure::Pore> all = measure::pores(sim);
    VtkPolyData file(sim.time());
    add_centres(file, sim.discs());
    for (const measure::Pore& p : all) file.add_polygon(sim.network().discs_of(p.domain));
    file.add_to_polygons("pressure (Pa)", [&](Index k) { return reals(all[k].pressure); });
    file.add_to_polygons("filling (1 full)", [&](Index k) { return reals(all[k].filling); });
    file.add_to_polygons("place (0 pore, 1 crack)", [&](Index k) { return code(all[k].in_crack); });
    return file;
  }

  static double pressure(const Network& network, Index channel) {
    double sum = 0;
    int sides = 0;
    for (const Index d : network.geometry().channels[channel].domain)
      if (d != nothing) sum += network.pressure(d), ++sides;
    return sides == 0 ? 0 : sum / sides;
  }

  static std::string step_name(const std::string& what, std::size_t step) {
    const std::string digits = std::to_string(step);
    return what + "_" + std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits +
           ".vtp";
  }

  void put(const std::string& what, const VtkPolyData& file) const {
    write_whole_file(folder_ / step_name(what, times_.size() - 1), file.text());
    std::vector<TimedFile> files;
    for (std::size_t k = 0; k < times_.size(); ++k)
      files.push_back({times_[k], step_name(what, k)});
    write_whole_file(folder_ / (what + ".pvd"), paraview_collection(files));
  }

  std::filesystem::path folder_;
  Interval interval_;
  std::vector<double> times_;
};

}  // namespace hfdem::observe
