/// @file
/// Finds the flow domains: the bounded faces of the planar graph whose vertices are disc centres
/// and whose edges are contacts.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include <hfdem/base/fields.hpp>
#include <hfdem/state/contact.hpp>
#include <hfdem/state/injection.hpp>
#include <hfdem/state/network.hpp>
#include <hfdem/state/specimen.hpp>

namespace hfdem {

namespace detail {

/// The graph's directed edges: 2 c runs from the first to the second disc of contact c, 2 c + 1
/// back. A face lies to the left of its edges.
class HalfEdges {
 public:
  HalfEdges(std::size_t discs, std::span<const ContactGeometry> contacts) : contacts_(contacts) {
    begin_.assign(discs + 1, 0);
    for (const auto& c : contacts) ++begin_[c.bodies.first + 1], ++begin_[c.bodies.second + 1];
    for (std::size_t i = 0; i < discs; ++i) begin_[i + 1] += begin_[i];
    leaving_.resize(2 * contacts.size());
    place_.resize(2 * contacts.size());
    std::vector<Index> next_free(begin_.begin(), begin_.end() - 1);
    for (Index h = 0; h < leaving_.size(); ++h) leaving_[next_free[origin(h)]++] = h;
    for (std::size_t i = 0; i < discs; ++i) sort_by_angle(begin_[i], begin_[i + 1]);
  }

  std::size_t size() const { return leaving_.size(); }
  static Index twin(Index h) { return h ^ 1U; }
  Index origin(Index h) const {
    const Pair bodies = contacts_[h / 2].bodies;
    return h % 2 == 0 ? bodies.first : bodies.second;
  }
  /// From the origin's centre to the contact point, m.
  Vec2 arm(Index h) const {
    const Frame<double>& f = contacts_[h / 2].frame;
    const Vec2 normal{f.normal_x, f.normal_y};
    return h % 2 == 0 ? (f.arm_mean - f.arm_half_difference) * normal
                      : (f.arm_mean + f.arm_half_difference) * -normal;
  }
  /// The edge that follows on the same face: at the target, the one clockwise of the way back.
  Index next(Index h) const {
    const Index back = twin(h), disc = origin(back), place = place_[back];
    return leaving_[place == begin_[disc] ? begin_[disc + 1] - 1 : place - 1];
  }
  /// Angle of the face at the edge's origin, between it and the edge before.
  double corner(Index h) const {
    const Index place = place_[h], disc = origin(h);
    const Vec2 out = arm(h),
               in = arm(leaving_[place + 1 == begin_[disc + 1] ? begin_[disc] : place + 1]);
    const double angle = std::atan2(cross(out, in), dot(out, in));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
  }
  /// The edges that leave a disc, counter-clockwise from the direction -pi.
  std::span<const Index> leaving(Index disc) const {
    return std::span(leaving_).subspan(begin_[disc], begin_[disc + 1] - begin_[disc]);
  }

 private:
  void sort_by_angle(Index begin, Index end) {
    const auto angle = [&](Index h) { return std::atan2(arm(h).y, arm(h).x); };
    std::sort(leaving_.begin() + begin, leaving_.begin() + end,
              [&](Index a, Index b) { return angle(a) < angle(b); });
    for (Index k = begin; k < end; ++k) place_[leaving_[k]] = k;
  }

  std::span<const ContactGeometry> contacts_;
  std::vector<Index> begin_, leaving_, place_;
};

}  // namespace detail

/// What counts as the length l_p of a channel: `FlowChannels` says what each is.
enum class ChannelLength { centroids, bond };
/// Their names in a parameter file.
template <>
inline constexpr auto names_of<ChannelLength> = std::to_array<std::string_view>({"centroids",
                                                                                 "bond"});

/// How the channels of the fluid network are measured.
struct FlowChannels {
  ChannelLength length = ChannelLength::centroids;

  static constexpr auto fields() {
    return std::tuple{Field{"length", &FlowChannels::length, "", any_number,
                            "l_p: centroids, the distance between the centres of the two domains "
                            "that a channel joins; bond, the width of its bond"}};
  }
};

/// Builds the fluid network of a bonded specimen.
/// @param specimen gives the discs' centres and radii
/// @param contacts all bonded contacts between discs; channel c belongs to contact c.
/// @param measured what counts as the length of a channel
inline FlowDomains flow_domains(const Specimen& specimen, std::span<const ContactGeometry> contacts,
                                ChannelLength measured = ChannelLength::centroids) {
  const detail::HalfEdges edges(specimen.size(), contacts);
  FlowDomains result;
  std::vector<Index> face(edges.size(), nothing);
  std::vector<bool> visited(edges.size(), false);
  result.channels_begin = result.discs_begin = {0};

  for (Index start = 0; start < edges.size(); ++start) {
    if (visited[start]) continue;
    std::vector<Index> loop;
    for (Index h = start; !visited[h]; h = edges.next(h)) {
      visited[h] = true;
      loop.push_back(h);
    }
    // Seen from one of its own discs, to lose no digits.
    const Vec2 seen_from = specimen.centre[edges.origin(start)];
    double twice_area = 0;
    Vec2 moment;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec2 a = specimen.centre[edges.origin(loop[k])] - seen_from;
      const Vec2 b = specimen.centre[edges.origin(loop[(k + 1) % loop.size()])] - seen_from;
      twice_area += cross(a, b);
      moment = moment + cross(a, b) * (a + b);
    }
    if (!(twice_area > 0)) continue;  // the outside
    double sectors = 0;
    for (const Index h : loop)
      sectors += edges.corner(h) / 2 * std::pow(specimen.radius[edges.origin(h)], 2);
    result.area.push_back(twice_area / 2);
    result.void_area.push_back(twice_area / 2 - sectors);
    const auto domain = static_cast<Index>(result.centre.size());
    result.centre.push_back(seen_from + (1 / (3 * twice_area)) * moment);
    for (const Index h : loop) {
      face[h] = domain;
      result.channels_of.push_back(h / 2);
      result.discs_of.push_back(edges.origin(h));
    }
    result.channels_begin.push_back(static_cast<Index>(result.channels_of.size()));
    result.discs_begin.push_back(static_cast<Index>(result.discs_of.size()));
  }

  result.channels.reserve(contacts.size());
  for (Index c = 0; c < contacts.size(); ++c) {
    const Index left = face[2 * c], right = face[2 * c + 1];
    double length = 0;
    if (measured == ChannelLength::bond) {
      const auto [first, second] = contacts[c].bodies;
      length = 2 * std::fmin(specimen.radius[first], specimen.radius[second]);
    } else if (left != nothing && right != nothing) {
      length = norm(result.centre[left] - result.centre[right]);
    } else if (left != nothing || right != nothing) {  // on the rim: as if mirrored there
      const Vec2 point = specimen.centre[edges.origin(2 * c)] + edges.arm(2 * c);
      length = 2 * norm(result.centre[left != nothing ? left : right] - point);
    }
    result.channels.push_back({{left, right}, length});
  }

  result.corners_begin.push_back(0);
  for (Index disc = 0; disc < specimen.size(); ++disc) {
    const auto leaving = edges.leaving(disc);
    for (std::size_t k = 0; k < leaving.size(); ++k) {
      // The face to the left of an edge fills the corner up to the next edge counter-clockwise.
      const Index domain = face[leaving[k]];
      if (domain == nothing) continue;
      const Vec2 chord = edges.arm(leaving[k]) - edges.arm(leaving[(k + 1) % leaving.size()]);
      result.corners.push_back({domain, -left_of(chord)});
    }
    result.corners_begin.push_back(static_cast<Index>(result.corners.size()));
  }
  return result;
}

namespace detail {

/// The domain whose centre is nearest to an injection point.
inline Index nearest_domain(const FlowDomains& domains, const Specimen& specimen,
                            std::string_view field, Vec2 at) {
  const bool inside = at.x > 0 && at.x < specimen.width && at.y > 0 && at.y < specimen.height;
  if (!inside || domains.centre.empty())
    refuse("injection", field, to_text(at) + " m",
           "inside the specimen, which is " + to_text(specimen.width) + " m by " +
               to_text(specimen.height) + " m and has " + std::to_string(domains.centre.size()) +
               " flow domains");
  Index nearest = 0;
  for (Index d = 1; d < domains.centre.size(); ++d)
    if (norm(domains.centre[d] - at) < norm(domains.centre[nearest] - at)) nearest = d;
  return nearest;
}

}  // namespace detail

/// The domains that receive the fluid: those whose centres are nearest to the injection points.
/// @param domains of the specimen
/// @param specimen whose box the points must be in
/// @param injection its points; the middle of the specimen if no position is given
/// @throws InvalidParameter if a point is not inside the specimen, or in the same domain as another
inline std::vector<Index> injection_domains(const FlowDomains& domains, const Specimen& specimen,
                                            const Injection& injection) {
  const Vec2 middle{specimen.width / 2, specimen.height / 2};
  std::vector<Index> all{
      detail::nearest_domain(domains, specimen, "position", injection.position.value_or(middle))};
  for (std::size_t k = 0; k < injection.further_points.size(); ++k) {
    const std::string entry = entry_of("further_points", k);
    const Vec2 at = injection.further_points[k];
    const Index domain = detail::nearest_domain(domains, specimen, entry, at);
    if (std::find(all.begin(), all.end(), domain) != all.end())
      refuse("injection", entry, to_text(at) + " m",
             "in another flow domain than injection.position and the entries before");
    all.push_back(domain);
  }
  return all;
}

}  // namespace hfdem
