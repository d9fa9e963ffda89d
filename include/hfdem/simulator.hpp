/// @file
/// The simulator: four policies, composed at compile time, over one assembly of discs.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <hfdem/assembly.hpp>
#include <hfdem/setup/bonding.hpp>
#include <hfdem/setup/flow_domains.hpp>
#include <hfdem/setup/preset_crack.hpp>
#include <hfdem/simulator_checks.hpp>
#include <hfdem/simulator_observers.hpp>
#include <hfdem/simulator_params.hpp>
#include <hfdem/state/concepts.hpp>
#include <hfdem/state/injection.hpp>

namespace hfdem {

/// Bonded discs with a fluid network.
///
/// The constructor bonds the specimen, cuts the preset cracks and lets the in-situ stress settle;
/// from then on `step` makes one fluid step, with as many mechanical steps as the pressure scheme
/// wants. The simulator does no input or output and has no globals; several may live side by side.
/// The bits of every result depend only on the parameters, never on the number of threads, if the
/// compiler fuses no multiplications and additions (`-ffp-contract=off`).
///
/// @tparam Contact law between bonded discs, e.g. `LinearParallelBond`
/// @tparam Aperture law of the flow channels, e.g. `HyperbolicAperture`
/// @tparam Pressure update of the fluid, e.g. `UniformPressure`
/// @tparam Neighbours search that proposes the pairs to bond, e.g. `FixedPairs`
template <ContactLaw Contact, ApertureLaw Aperture, PressureScheme Pressure,
          NeighbourSearch Neighbours>
class Simulator {
 public:
  using Params = SimulatorParams<Contact, Aperture, Pressure>;  ///< sections of a parameter file
  using ContactPolicy = Contact;                                ///< as composed
  using NeighbourPolicy = Neighbours;                           ///< as composed

  /// Bonds, cuts the preset crack, settles.
  /// @throws InvalidParameter naming the field that is wrong
  /// @throws RunStopped if the specimen finds no equilibrium under the in-situ stress
  Simulator(const Specimen& specimen, const Params& params)
      : Simulator(Unsettled{}, specimen, params) {
    set_in_situ(params.in_situ);
  }

  /// Takes up a run where it was saved; nothing settles again. From there on every bit is that of
  /// the run without a break.
  /// @tparam Archive that gives back what was saved, `Loader`
  /// @param specimen of the run that was saved
  /// @param params of the run that was saved
  /// @param saved where `saver(simulator)` is the next that was put in
  /// @throws InvalidParameter naming the field that is wrong, or the byte of what does not fit
  template <class Archive>
  Simulator(const Specimen& specimen, const Params& params, Archive& saved)
      : Simulator(Unsettled{}, specimen, params) {
    saved(*this);
  }

  // ---- verbs ----------------------------------------------------------------------------------

  /// Makes one fluid step. An observer's member `mechanical_step(simulator)` is called in each of
  /// its mechanical steps that it wants to hear of, before anything moves.
  /// @throws RunStopped when the run cannot go on; everything stays readable
  template <class... Observers>
  FluidStep step(Observers&&... observers) {
    const double dt = pressure_.fluid_dt(assembly_.dt());
    const double injected = rate_.volume(time_, dt);
    time_ += dt;
    const double before = injected_;
    injected_ += injected;
    rounded_off_ += injected - (injected_ - before);
    ++fluid_steps_;
    if (mechanical_steps_ >= measured_until_) {
      mean_contact_force_ = mean_contact_force();
      if constexpr (FlowsThroughRock<Pressure>) measure_intact_channels();
      measured_until_ = mechanical_steps_ + lifetime_of_measurements;
    }
    const FluidStep result = pressure_.advance(network_, Injected{injected_, injected, dt},
                                               [&] { return relax(false, observers...); });
    if constexpr (BalancesVolume<Pressure>) detail::stop_unless_balanced(volume_balance(), time_);
    return result;
  }

  /// Steps until `end_time`, s. An observer is told after every fluid step through
  /// `observer(simulator)` or, where it has one, its member `fluid_step(simulator, FluidStep)`;
  /// an answer of false ends the run. A member `bond_break(simulator, BondBreak)` hears of breaks,
  /// and `mechanical_step(simulator)` of mechanical steps, if it wants to.
  /// @returns whether the end time was reached
  /// @throws RunStopped when the run cannot go on
  template <class... Observers>
  bool run_until(double end_time, Observers&&... observers) {
    while (time_ + 1e-6 * pressure_.fluid_dt(assembly_.dt()) < end_time) {
      const std::size_t told = breaks_.size();
      [[maybe_unused]] const FluidStep result = step(observers...);
      for (std::size_t b = told; b < breaks_.size(); ++b)
        (tell_bond_break(observers, *this, breaks_[b]), ...);
      bool go_on = true;
      ((go_on = tell_fluid_step(observers, *this, result) && go_on), ...);
      if (!go_on) return false;
    }
    return true;
  }

  /// Changes the in-situ stress and lets the specimen settle, without fluid flow.
  /// @throws RunStopped if it finds no equilibrium
  void set_in_situ(Stress stress) {
    assembly_.set_stress(stress);
    for (Index i = 0; i < discs().size(); ++i) push(i);
    settle();
  }

  /// Relaxes at the present pressures until the largest unbalanced force is below
  /// `mechanics.settle_tolerance` of the mean contact force.
  /// @throws RunStopped if it finds no equilibrium
  void settle() {
    constexpr int between_checks = 20;
    for (int steps = 0; steps < params_.mechanics.max_settle_steps; steps += between_checks) {
      Relaxed last{};
      for (int k = 0; k < between_checks; ++k) last = relax(true);
      mean_contact_force_ = mean_contact_force();
      const double worst = std::fmax(last.unbalanced_ratio, assembly_.worst_platen_error());
      if (worst < params_.mechanics.settle_tolerance) return;
    }
    throw RunStopped("the specimen found no equilibrium in " +
                     std::to_string(params_.mechanics.max_settle_steps) +
                     " mechanical steps (mechanics.max_settle_steps) while settling");
  }

  /// Changes the injection rate, m2/s, from the next step on; zero shuts the well in. What is left
  /// of `injection.schedule` and of `injection.rise` no longer counts.
  /// @throws InvalidParameter if the rate is negative or not finite
  void inject(double rate) {
    detail::check_range("injection", "rate", "m2/s", non_negative, rate);
    rate_.hold(rate);
  }
  /// Number of threads for the loops; the results do not depend on it.
  void use_threads(int threads) { threads_ = threads; }

  // ---- what can be read -----------------------------------------------------------------------

  double time() const { return time_; }             ///< fluid time since injection began, s
  const Params& params() const { return params_; }  ///< as given
  const Specimen& specimen() const { return assembly_.specimen(); }  ///< before it was bonded
  const Discs& discs() const { return assembly_.discs(); }           ///< bodies and their motion
  /// Between discs of the rock; the flow channel of contact c is channel c.
  const ContactRange<RockLawOf<Contact>>& contacts() const { return assembly_.contacts(); }
  /// Between discs with a natural fracture between them; none if the contact law has no joints.
  const JointContacts<JointLawOf<Contact>>& joints() const { return assembly_.joints(); }
  /// Whether a contact, or its flow channel, is a joint: the number of joint 0 is
  /// `contacts().size()`.
  bool is_joint(Index contact) const { return assembly_.is_joint(contact); }
  /// Between discs and platens.
  const ContactRange<SmoothPlaten>& platens() const { return assembly_.platens(); }
  /// Bodies and normals of these.
  std::span<const ContactGeometry> platen_geometry() const { return assembly_.platen_geometry(); }
  const Network& network() const { return network_; }             ///< pressures and widths
  const Loading& loading() const { return assembly_.loading(); }  ///< platens or dead loads
  const ForceRows& forces() const { return assembly_.forces(); }  ///< of the last mechanical step
  /// For hosts that steer their scheme between steps, as through `HeldPressure::hold`.
  Pressure& pressure_scheme() { return pressure_; }
  const Pressure& pressure_scheme() const { return pressure_; }  ///< to be read
  /// Bonds that broke so far, in order; the preset crack is not among them.
  std::span<const BondBreak> breaks() const { return breaks_; }
  std::span<const Index> preset_contacts() const { return preset_; }  ///< cut before the run
  double injected_volume() const { return injected_; }                ///< V_f, m2
  /// Where the fluid is; only with a scheme that keeps account of it. After a step that threw it
  /// may lack what that step injected.
  template <BalancesVolume = Pressure>
  VolumeBalance volume_balance() const {
    return pressure_.balance(network_, injected_ + rounded_off_);
  }
  /// Pressure of the domain that receives the fluid, Pa; with several, of the first.
  double injection_pressure() const { return network_.pressure(network_.injection_domain()); }
  /// Direction of the preset crack.
  Vec2 crack_direction() const { return hfdem::crack_direction(params_.in_situ); }
  double mechanical_dt() const { return assembly_.dt(); }      ///< mechanical step, s
  long mechanical_steps() const { return mechanical_steps_; }  ///< of all fluid steps so far
  long settling_steps() const { return settling_steps_; }      ///< without fluid flow, so far
  long fluid_steps() const { return fluid_steps_; }            ///< so far

  /// Where a contact is: its contact point, m.
  Vec2 contact_point(Index contact) const {
    const auto& [bodies, f] = contact_geometry(contact);
    return discs().centre[bodies.first] +
           (f.arm_mean - f.arm_half_difference) * Vec2{f.normal_x, f.normal_y};
  }
  /// A contact's bodies, normal and arms.
  const ContactGeometry& contact_geometry(Index contact) const {
    return assembly_.geometry()[contact];
  }

  /// The present force of a contact between two discs; of a joint, across and along its fracture.
  Reaction<double> reaction(Index contact) const {
    return is_joint(contact) ? joints()
                                   .contacts()
                                   .response(contact - contacts().size(), discs().displacement)
                                   .reaction()
                             : contacts().response(contact, discs().displacement).reaction();
  }

  /// Mean size of the force in the contacts between discs at the last mechanical step, N per m.
  double mean_contact_force() const { return assembly_.mean_contact_force(); }

  /// Everything that evolves; the number of threads is no part of it.
  void exchange(auto& archive) {
    archive(assembly_, pressure_, network_, breaks_, time_, injected_, rounded_off_, rate_,
            mean_contact_force_, mechanical_steps_, settling_steps_, fluid_steps_, measured_until_);
  }

 private:
  // ---- setting up -----------------------------------------------------------------------------

  struct Unsettled {};

  Simulator(Unsettled, const Specimen& specimen, const Params& params)
      : params_((params.validate(), params)),
        assembly_(specimen, bonded_contacts<Neighbours>(specimen), contact_law(params),
                  params.boundary, params.mechanics.damping, params.mechanics.step_fraction),
        aperture_(params.aperture),
        pressure_(make_pressure()) {
    make_network();
  }

  static Contact contact_law(const Params& params) {
    if constexpr (HasJoints<Contact>)
      return Contact(params.contact, params.joints);
    else
      return Contact(params.contact);
  }

  Pressure make_pressure() const {
    if constexpr (names_leakoff<Pressure>)
      return Pressure(params_.scheme, FluidOf<Pressure>(params_.fluid), assembly_.response(),
                      LeakoffOf<Pressure>(params_.leakoff));
    else if constexpr (FlowScheme<Pressure>)
      return Pressure(params_.scheme, FluidOf<Pressure>(params_.fluid), assembly_.response());
    else
      return Pressure(params_.scheme);
  }

  void make_network() {
    FlowDomains domains = flow_domains(specimen(), assembly_.geometry(), params_.channels.length);
    std::vector<Index> points = injection_domains(domains, specimen(), params_.injection);
    network_ = Network(std::move(domains), std::move(points), aperture_.rest_width());
    for (Index k = 0; k < joints().bonded(); ++k)
      network_.set_rest_width(assembly_.number_of(k), joints().contacts().law().rest_width());
    for (const Index point : network_.injection_domains())
      for (const Index c : preset_crack(params_.crack, specimen(), assembly_.geometry(),
                                        network_.geometry().centre[point], crack_direction()))
        if (std::find(preset_.begin(), preset_.end(), c) == preset_.end()) preset_.push_back(c);
    detail::keep_joints_away(assembly_, network_, preset_);
    for (const Index c : preset_) {
      assembly_.break_bond(c);
      network_.open(c);
    }
    if (Pressure::holds_fluid) detail::refuse_short_crack(network_, params_.crack);
    if (Pressure::holds_fluid) detail::stop_at_rim(network_, time_);
  }

  // ---- one mechanical step --------------------------------------------------------------------

  template <class... Observers>
  Relaxed relax(bool settling, Observers&... observers) {
    const std::size_t broken_before = breaks_.size(), wet_before = network_.wet_channels().size();
    const auto note = [&](Index contact, Mode mode) {
      breaks_.push_back({time_, contact, mode, injection_pressure()});
      network_.open(contact);
    };
    const bool heard = (wants_mechanical_steps(observers, *this) || ...);
    heard ? assembly_.find_forces(threads_, note) : assembly_.begin_step(threads_, note);
    const std::size_t broken = breaks_.size() - broken_before;
    if (broken > 0 && Pressure::holds_fluid) detail::stop_at_rim(network_, time_);
    const double joined = flood_joints(wet_before);
    for (const Index i : network_.pushed_discs()) push(i);
    carry_fluid();
    if (heard) (tell_mechanical_step(observers, *this), ...);
    const double largest = assembly_.move(settling, threads_);
    detail::stop_unless_finite(largest, time_);
    refresh_widths();
    ++(settling ? settling_steps_ : mechanical_steps_);
    return {largest == 0 ? 0 : largest / mean_contact_force_, static_cast<int>(broken), joined};
  }

  /// A fluid that is squeezed between discs before it can flow is a spring there.
  void carry_fluid() {
    if constexpr (requires { pressure_.for_each_spring([](Index, double) {}); })
      assembly_.carry([&](auto&& add) {
        pressure_.for_each_spring(
            [&](Index c, double stiffness) { add(c, stiffness * steepness(c)); });
      });
  }

  /// How much faster a channel's width changes than its gap, at least 1.
  double steepness(Index channel) const {
    const auto o = assembly_.opening(channel);
    if (o.compression <= 0) return 1;
    constexpr double nearer = 1e-9;  // m
    const double w0 = network_.rest_width(channel) + o.dilation;
    const double more = o.compression + nearer * assembly_.closing_stiffness(channel);
    return max(1.0,
               (aperture_.width(w0, o.compression, 0) - aperture_.width(w0, more, 0)) / nearer);
  }

  void push(Index disc) { assembly_.push(disc, network_.force_on(disc)); }

  void refresh_widths() {
    for (const Index c : network_.wet_channels()) network_.set_width(c, width(c));
  }
  void measure_intact_channels() {
    for (Index c = 0; c < network_.geometry().channels.size(); ++c)
      if (!network_.is_wet(c)) network_.set_width(c, width(c));
  }
  double width(Index channel) const {
    const auto o = assembly_.opening(channel);
    return aperture_.width(network_.rest_width(channel) + o.dilation, o.compression, o.gap);
  }

  /// Joints that fluid has just reached are as wide as they are, and filled before or not.
  /// @returns the volume that was not, m2
  double flood_joints(std::size_t wet_before) {
    const bool filled = joints().contacts().law().initially() == JointContent::filled;
    double joined = 0;
    for (const Index c : network_.wet_channels().subspan(wet_before)) {
      if (!is_joint(c)) continue;
      network_.set_width(c, width(c));
      if (filled)
        network_.set_filled_width(c, network_.width(c));
      else
        joined += network_.geometry().channels[c].length * network_.width(c);
    }
    return joined;
  }

  Params params_;
  Assembly<Contact> assembly_;
  Aperture aperture_;
  Pressure pressure_;
  Network network_;
  std::vector<Index> preset_;
  std::vector<BondBreak> breaks_;
  double time_ = 0, injected_ = 0, rounded_off_ = 0, mean_contact_force_ = 0;
  InjectionRate rate_{params_.injection};
  long mechanical_steps_ = 0, settling_steps_ = 0, fluid_steps_ = 0;
  /// The mean contact force and the widths of intact channels change slowly, and take as long to
  /// measure as a mechanical step.
  static constexpr long lifetime_of_measurements = 100;
  long measured_until_ = 0;
  int threads_ = 1;
};

}  // namespace hfdem
