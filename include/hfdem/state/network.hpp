/// @file
/// The fluid network: domains between the discs, a channel at every contact, and which of them
/// hold fluid.
///
/// Source: the paper's Section 2.1 (domains and channels), its Eqs. 2 and 3 (volumes); P. A.
/// Cundall's domain formulation as in PFC2D.
#pragma once

#include <array>
#include <cassert>
#include <span>
#include <utility>
#include <vector>

#include <hfdem/base/vec2.hpp>
#include <hfdem/state/contact.hpp>

namespace hfdem {

/// A flow channel at a contact: joins the domains to its left and right.
struct Channel {
  std::array<Index, 2> domain;  ///< `nothing` for the outside of the specimen
  double length;                ///< l_p: distance between the two domain centres, m
};

/// What unit pressure of a domain does to one disc beside it.
struct Corner {
  Index domain;  ///< whose pressure acts
  Vec2 push;     ///< the chord between the disc's two contact points, turned outwards, m
};

/// The network's geometry: that of the bonded specimen, for ever (small strain).
struct FlowDomains {
  std::vector<Vec2> centre;                  ///< area centroid of each domain, m
  std::vector<double> area;                  ///< of the polygon of disc centres around each, m2
  std::vector<double> void_area;             ///< of that, what the discs leave: maybe less than 0
  std::vector<Channel> channels;             ///< one per contact
  std::vector<Index> channels_begin;         ///< per domain, into `channels_of`
  std::vector<Index> channels_of;            ///< the channels around each domain
  std::vector<Index> corners_begin;          ///< per disc, into `corners`
  std::vector<Corner> corners;               ///< around each disc, counter-clockwise
  std::vector<Index> discs_begin, discs_of;  ///< the discs around each domain, in the same way
};

/// Pressures and widths on the network, and the spreading of fluid through broken contacts.
///
/// A contact whose bond is intact is closed. A broken one is *open*; it is *wet* once it connects,
/// through wet channels, to an injection point. Open channels that do not connect wait. A domain
/// beside a wet channel is wet, the end domains of a crack included.
class Network {
 public:
  Network() = default;
  /// @param geometry domains, channels and corners; kept
  /// @param injection_domains wet from the beginning; one at least, and none twice
  /// @param rest_width width of a channel at zero contact force, w0, m
  Network(FlowDomains geometry, std::vector<Index> injection_domains, double rest_width)
      : geometry_(std::move(geometry)),
        injection_domains_(std::move(injection_domains)),
        rest_width_(geometry_.channels.size(), rest_width),
        filled_width_(rest_width_),
        width_(geometry_.channels.size(), 0),
        pressure_(geometry_.centre.size(), 0),
        open_(geometry_.channels.size(), false),
        wet_channel_(geometry_.channels.size(), false),
        wet_domain_(geometry_.centre.size(), false),
        pushed_disc_(geometry_.corners_begin.size() - 1, false) {
    for (const Index d : injection_domains_) wet(d);
  }

  const FlowDomains& geometry() const { return geometry_; }  ///< that of the bonded specimen
  /// That receive the fluid, one for each injection point.
  std::span<const Index> injection_domains() const { return injection_domains_; }
  Index injection_domain() const { return injection_domains_.front(); }  ///< of the first point
  /// Channels that hold fluid, in the order in which they got it.
  std::span<const Index> wet_channels() const { return wet_channels_; }
  /// Domains that hold fluid, the injection domains first, in the order in which they got it.
  std::span<const Index> wet_domains() const { return wet_domains_; }
  /// Discs that touch a domain whose pressure counts: a wet one, or a pore.
  std::span<const Index> pushed_discs() const { return pushed_discs_; }
  /// Whether the channel's bond has broken.
  bool is_open(Index channel) const { return open_[channel]; }
  /// Whether the channel holds fluid.
  bool is_wet(Index channel) const { return wet_channel_[channel]; }
  /// Whether a wet channel lies on the rim: the fluid would leave the specimen there.
  bool reached_rim() const { return reached_rim_; }

  /// Fluid pressure of a domain, Pa; zero while it is dry. That of a pore, if the rock leaks.
  double pressure(Index domain) const { return pressure_[domain]; }
  /// Fluid pressures, Pa, one per domain.
  std::span<const double> pressures() const { return pressure_; }
  /// Hydraulic aperture w of a channel, m; zero while it is dry, unless the rock leaks.
  double width(Index channel) const { return width_[channel]; }
  /// Aperture at zero contact force, w0, m.
  double rest_width(Index channel) const { return rest_width_[channel]; }
  /// How wide the fluid that was there before reaches when the channel turns wet, m: w0 in rock.
  double filled_width(Index channel) const { return filled_width_[channel]; }

  /// Gives a channel that is not yet wet an aperture at zero contact force of its own, m, and none
  /// of it filled: that of a dry joint.
  void set_rest_width(Index channel, double width) {
    rest_width_[channel] = width;
    filled_width_[channel] = 0;
  }
  /// Sets how much of a wet channel is taken as filled from the beginning, m.
  void set_filled_width(Index channel, double width) { filled_width_[channel] = width; }
  /// Sets the hydraulic aperture of a channel that conducts, m.
  void set_width(Index channel, double width) { width_[channel] = width; }
  /// Sets the pressure of a wet domain, Pa.
  void set_pressure(Index domain, double pressure) {
    assert(wet_domain_[domain]);
    pressure_[domain] = pressure;
  }

  /// Sets the pressure of a pore of the rock, Pa, which pushes its discs. A domain that has turned
  /// wet meanwhile is none: it keeps the pressure of the crack.
  void soak(Index domain, double pressure) {
    if (wet_domain_[domain]) return;
    if (pressure > 0) push_discs(domain);
    pressure_[domain] = pressure;
  }

  /// The channel's bond has broken: it conducts from now on if fluid can reach it, and so do all
  /// open channels that it connects.
  void open(Index channel) {
    open_[channel] = true;
    for (const Index d : geometry_.channels[channel].domain)
      if (d != nothing && wet_domain_[d]) return flood(channel);
  }

  /// V_c, Eq. 2, m2 (per m of thickness): what the crack has opened beyond its filled width.
  /// Slightly negative while the crack is still pressed shut.
  double crack_volume() const {
    return sum([&](Index c) { return width_[c] - filled_width_[c]; });
  }
  /// V_t, Eq. 3: the whole volume of the wet channels, m2.
  double total_volume() const {
    return sum([&](Index c) { return width_[c]; });
  }
  /// What was filled in the wet channels before the injected fluid came, m2.
  double filled_volume() const {
    return sum([&](Index c) { return filled_width_[c]; });
  }
  /// The volume that the wet channels have at zero contact force, m2.
  double rest_volume() const {
    return sum([&](Index c) { return rest_width_[c]; });
  }
  /// V_d: half the volume of each wet channel beside a domain, m2. They sum up to V_t.
  double domain_volume(Index domain) const {
    double volume = 0;
    for (const Index c : channels_of(domain))
      if (wet_channel_[c]) volume += geometry_.channels[c].length * width_[c] / 2;
    return volume;
  }

  /// The channels around a domain, counter-clockwise.
  std::span<const Index> channels_of(Index domain) const {
    return slice(geometry_.channels_begin, geometry_.channels_of, domain);
  }
  /// The discs around a domain, counter-clockwise.
  std::span<const Index> discs_of(Index domain) const {
    return slice(geometry_.discs_begin, geometry_.discs_of, domain);
  }

  /// Force of the fluid on a disc, N per m. Neighbouring corners are added first, so that mirror
  /// images receive mirrored bits.
  Vec2 force_on(Index disc) const {
    const auto corners = slice(geometry_.corners_begin, geometry_.corners, disc);
    Vec2 total;
    for (std::size_t k = 0; k < corners.size(); k += 2) {
      Vec2 pair = pressure_[corners[k].domain] * corners[k].push;
      if (k + 1 < corners.size())
        pair = pair + pressure_[corners[k + 1].domain] * corners[k + 1].push;
      total = total + pair;
    }
    return total;
  }

  /// Where the fluid is, its pressure, and the widths.
  void exchange(auto& archive) {
    archive(std::span(filled_width_), std::span(width_), std::span(pressure_), open_, wet_channel_,
            wet_domain_, pushed_disc_, wet_channels_, wet_domains_, pushed_discs_, reached_rim_);
  }

 private:
  template <class T>
  static std::span<const T> slice(const std::vector<Index>& begin, const std::vector<T>& of,
                                  Index i) {
    return std::span<const T>(of).subspan(begin[i], begin[i + 1] - begin[i]);
  }

  template <class F>
  double sum(F&& width_of) const {
    double volume = 0;
    for (const Index c : wet_channels_) volume += geometry_.channels[c].length * width_of(c);
    return volume;
  }

  void wet(Index domain) {
    wet_domain_[domain] = true;
    wet_domains_.push_back(domain);
    push_discs(domain);
  }

  void push_discs(Index domain) {
    for (const Index disc : discs_of(domain)) {
      if (pushed_disc_[disc]) continue;
      pushed_disc_[disc] = true;
      pushed_discs_.push_back(disc);
    }
  }

  void flood(Index start) {
    std::vector<Index> front{start};
    while (!front.empty()) {
      const Index c = front.back();
      front.pop_back();
      if (wet_channel_[c]) continue;
      wet_channel_[c] = true;
      wet_channels_.push_back(c);
      width_[c] = rest_width_[c];
      for (const Index d : geometry_.channels[c].domain) {
        if (d == nothing) {
          reached_rim_ = true;
        } else if (!wet_domain_[d]) {
          wet(d);
          for (const Index next : channels_of(d))
            if (open_[next] && !wet_channel_[next]) front.push_back(next);
        }
      }
    }
  }

  FlowDomains geometry_;
  std::vector<Index> injection_domains_;
  std::vector<double> rest_width_, filled_width_, width_, pressure_;
  std::vector<bool> open_, wet_channel_, wet_domain_, pushed_disc_;
  std::vector<Index> wet_channels_, wet_domains_, pushed_discs_;
  bool reached_rim_ = false;
};

}  // namespace hfdem
