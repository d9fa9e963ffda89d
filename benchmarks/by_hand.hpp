/// @file
/// The mechanical step as one would write it by hand for `LinearParallelBond` alone: plain arrays
/// in the library's layout, no policy, no template. The contact loop does the same arithmetic to
/// the last bit and takes the two short cuts that a special case allows: it leaves out the return
/// mapping where nothing slips, and multiplies the constants beforehand where that rounds nothing.
/// Discs gather their rows in the order of the contacts; nothing is broken and there are no
/// platens. Contacts come first, then discs.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include <hfdem/contact/linear_parallel_bond.hpp>
#include <hfdem/mechanics/contact_range.hpp>
#include <hfdem/state/discs.hpp>

using Four = double __attribute__((vector_size(32)));
using Bits = decltype(Four{} < Four{});

struct ContactsByHand {
  using Law = hfdem::LinearParallelBond;
  static constexpr std::size_t blocks_per_note = 64;

  std::vector<std::uint32_t> bodies;        // per block of four: the first ones, the second ones
  std::vector<Four> frame, spring, offset;  // per block: four, three and one
  std::vector<char> failed;                 // per 64 blocks, as in the library
  double shear_ratio, bond_shear_ratio, friction, three_beta, two_tensile, two_cohesion, tan_angle;

  ContactsByHand(const hfdem::ContactRange<Law>& range, const Law::Params& p)
      : bodies(2 * range.padded_size()),
        frame(range.padded_size()),
        spring(range.padded_size() / 4 * 3),
        offset(range.padded_size() / 4),
        failed((offset.size() + blocks_per_note - 1) / blocks_per_note),
        shear_ratio(1 / p.stiffness_ratio),
        bond_shear_ratio(1 / p.bond_stiffness_ratio),
        friction(p.friction),
        three_beta(3 * p.moment_factor),
        two_tensile(2 * p.tensile_strength),
        two_cohesion(2 * p.cohesion),
        tan_angle(std::tan(p.friction_angle * std::numbers::pi / 180)) {
    for (std::size_t c = 0; c < range.size(); ++c) {
      const std::size_t b = c / 4, lane = c % 4;
      bodies[8 * b + lane] = range.bodies(c).first;
      bodies[8 * b + 4 + lane] = range.bodies(c).second;
      frame[4 * b][lane] = range.frame(c).normal_x;
      frame[4 * b + 1][lane] = range.frame(c).normal_y;
      frame[4 * b + 2][lane] = range.frame(c).arm_mean;
      frame[4 * b + 3][lane] = range.frame(c).arm_half_difference;
      spring[3 * b][lane] = range.stiffness(c).normal;
      spring[3 * b + 1][lane] = range.stiffness(c).bond;
      spring[3 * b + 2][lane] = range.stiffness(c).bond_radius;
      offset[b][lane] = range.memory(c).shear_offset;
    }
  }

  void evaluate(const Four* displacement, Four* force) {
    constexpr long long magnitude = std::numeric_limits<long long>::max();
    const Four first = {-1, -1, -1, 1};
    const Four zero = {};
    const std::uint32_t* i = bodies.data();
    const Four *f = frame.data(), *k = spring.data();
    Four *off = offset.data(), *row = force;
    for (std::size_t note = 0; note < failed.size(); ++note) {
      Bits any_failed = {};
      const std::size_t end = std::min(offset.size(), (note + 1) * blocks_per_note);
      for (std::size_t b = note * blocks_per_note; b < end;
           ++b, i += 8, f += 4, k += 3, ++off, row += 4) {
        const Four d0 = hfdem::plus_signed(displacement[i[4]], first, displacement[i[0]]);
        const Four d1 = hfdem::plus_signed(displacement[i[5]], first, displacement[i[1]]);
        const Four d2 = hfdem::plus_signed(displacement[i[6]], first, displacement[i[2]]);
        const Four d3 = hfdem::plus_signed(displacement[i[7]], first, displacement[i[3]]);
        const Four even01 = __builtin_shufflevector(d0, d1, 0, 4, 2, 6);
        const Four even23 = __builtin_shufflevector(d2, d3, 0, 4, 2, 6);
        const Four odd01 = __builtin_shufflevector(d0, d1, 1, 5, 3, 7);
        const Four odd23 = __builtin_shufflevector(d2, d3, 1, 5, 3, 7);
        const Four dx = __builtin_shufflevector(even01, even23, 0, 1, 4, 5);
        const Four dy = __builtin_shufflevector(odd01, odd23, 0, 1, 4, 5);
        const Four rotation = __builtin_shufflevector(even01, even23, 2, 3, 6, 7);
        const Four rotation_sum = __builtin_shufflevector(odd01, odd23, 2, 3, 6, 7);

        const Four nx = f[0], ny = f[1], arm = f[2], half = f[3];
        const Four closing = -(dx * nx + dy * ny);
        const Four slide = (dy * nx - dx * ny) - (arm * rotation_sum + half * rotation);

        const Four pressed = k[0] * closing;
        const Four normal = hfdem::max(zero, pressed);
        const Four limit = friction * normal;
        Four shear = *off - (k[0] * shear_ratio) * slide;
        if (hfdem::any((Four)((Bits)shear & magnitude) >= limit)) [[unlikely]] {
          const Four elastic = shear;
          shear = hfdem::max(-limit, hfdem::min(elastic, limit));
          *off += shear - elastic;
        }
        const Four bond_normal = k[1] * closing;
        const Four minus_bond_shear = (k[1] * bond_shear_ratio) * slide;
        const Four moment = ((1.0 / 3.0) * k[1] * (k[2] * k[2])) * rotation;

        const Four n = normal + bond_normal, s = shear - minus_bond_shear;
        const Four x = n * nx - s * ny, y = n * ny + s * nx;
        const Four torque_difference = -(half * s + moment), torque_sum = -(arm * s);
        const Four even_xy = __builtin_shufflevector(x, y, 0, 4, 2, 6);
        const Four odd_xy = __builtin_shufflevector(x, y, 1, 5, 3, 7);
        const Four even_t = __builtin_shufflevector(torque_difference, torque_sum, 0, 4, 2, 6);
        const Four odd_t = __builtin_shufflevector(torque_difference, torque_sum, 1, 5, 3, 7);
        row[0] = __builtin_shufflevector(even_xy, even_t, 0, 1, 4, 5);
        row[1] = __builtin_shufflevector(odd_xy, odd_t, 0, 1, 4, 5);
        row[2] = __builtin_shufflevector(even_xy, even_t, 2, 3, 6, 7);
        row[3] = __builtin_shufflevector(odd_xy, odd_t, 2, 3, 6, 7);

        const Four tension = three_beta * (Four)((Bits)moment & magnitude) - bond_normal * k[2];
        const Four strength = two_cohesion * k[2] + tan_angle * hfdem::max(zero, bond_normal);
        any_failed |= (tension > (two_tensile * k[2]) * k[2]) |
                      ((Four)((Bits)minus_bond_shear & magnitude) > strength);
      }
      failed[note] = hfdem::any(any_failed);
    }
  }
};

struct DiscsByHand {
  static Four sign(unsigned first) { return first ? Four{-1, -1, -1, 1} : Four{1, 1, 1, 1}; }

  std::vector<std::uint32_t> entries;          // six of each disc: row + 1 or 0, times four
  std::vector<std::uint8_t> signs;             // of these, a bit each; the last one: there are more
  std::vector<std::uint32_t> more, more_from;  // of discs with more contacts, their sign in bit 0
  Four signs_of_rows[64][6];                   // what each pattern of signs means
  std::vector<Four> displacement, velocity;
  std::vector<double> load, translation, rotation;  // load: x, y; time step over mass and inertia
  double dt, damping;

  DiscsByHand(const hfdem::Discs& discs, std::span<const hfdem::ContactGeometry> contacts,
              double time_step, double damping_)
      : displacement(discs.displacement),
        velocity(discs.velocity),
        load(2 * discs.size(), 0),
        translation(discs.size()),
        rotation(discs.size()),
        dt(time_step),
        damping(damping_) {
    std::vector<std::vector<std::uint32_t>> rows(discs.size());
    for (std::uint32_t c = 0; c < contacts.size(); ++c) {
      rows[contacts[c].bodies.first].push_back(2 * (c + 1) + 1);
      rows[contacts[c].bodies.second].push_back(2 * (c + 1));
    }
    for (std::size_t i = 0; i < discs.size(); ++i) {
      translation[i] = dt / discs.mass[i];
      rotation[i] = dt / discs.inertia(i);
      more_from.push_back(static_cast<std::uint32_t>(more.size()));
      unsigned pattern = rows[i].size() > 6 ? 128 : 0;
      for (std::size_t k = 0; k < 6; ++k) {
        const std::uint32_t entry = k < rows[i].size() ? rows[i][k] : 0;
        entries.push_back(4 * (entry >> 1));
        pattern |= (entry & 1) << k;
      }
      signs.push_back(static_cast<std::uint8_t>(pattern));
      for (std::size_t k = 6; k < rows[i].size(); ++k) more.push_back(rows[i][k]);
    }
    for (unsigned pattern = 0; pattern < 64; ++pattern)
      for (unsigned k = 0; k < 6; ++k) signs_of_rows[pattern][k] = sign(pattern >> k & 1);
    more_from.push_back(static_cast<std::uint32_t>(more.size()));
  }

  /// Moves every disc; the square of the largest resultant.
  /// @param row a row of zeros, then those of the contacts
  double step(const Four* row) {
    constexpr long long magnitude = std::numeric_limits<long long>::max();
    const Four zero = {};
    const double* rows = reinterpret_cast<const double*>(row);
    Four largest = {};
    for (std::size_t i = 0; i + 1 < more_from.size(); ++i) {
      Four sum = {load[2 * i], load[2 * i + 1], 0, 0};
      const std::uint32_t* e = &entries[6 * i];
      const Four* s = signs_of_rows[signs[i] & 63];
      for (unsigned k = 0; k < 6; ++k)
        sum = hfdem::plus_signed(sum, s[k], *reinterpret_cast<const Four*>(rows + e[k]));
      if (signs[i] >= 128)
        for (std::uint32_t m = more_from[i]; m < more_from[i + 1]; ++m)
          sum = hfdem::plus_signed(sum, sign(more[m] & 1), row[more[m] >> 1]);
      const Four square = sum * sum;
      const Four both = square + __builtin_shufflevector(square, square, 1, 0, 3, 2);
      largest = hfdem::max(largest, both);
      const Four pull = sum + __builtin_shufflevector(sum, zero, 4, 5, 3, 2);
      const Four damped =
          pull - hfdem::with_sign(damping * (Four)((Bits)pull & magnitude), velocity[i]);
      const double t = translation[i], r = rotation[i];
      velocity[i] += damped * Four{t, t, r, r};
      displacement[i] += velocity[i] * dt;
    }
    return largest[0];
  }
};
