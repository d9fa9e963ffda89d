// Newton's law with local damping, against the closed forms of the difference scheme.
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include <hfdem/base/pack.hpp>
#include <hfdem/mechanics/motion.hpp>

#include <doctest/doctest.h>

#include "near.hpp"

namespace {

using hfdem::Index;
using hfdem::Pack;
using test::bits;
using test::near;

constexpr double R = 4e-3, density = 2500, dt = 1e-6;
constexpr double mass = density * std::numbers::pi * R * R, inertia = mass * R * R / 2;

/// Discs in a column; a force row is at hand between each two neighbours.
struct Column {
  hfdem::Discs discs;
  hfdem::ForceRows forces;
  hfdem::DiscMotion motion;

  Column(std::size_t count, double damping)
      : discs(specimen(count)), forces(count + 4), motion(discs, dt, damping) {
    std::vector<hfdem::ContactGeometry> contacts;
    for (Index i = 0; i + 1 < count; ++i) contacts.push_back({{i, i + 1}, {0, 1, R, 0}});
    forces.add(contacts, 0, contacts.size());
    forces.arrange();
  }

  const Pack& displacement(std::size_t i) const { return discs.displacement[i]; }
  const Pack& velocity(std::size_t i) const { return discs.velocity[i]; }
  double step() { return motion.step(discs, forces, 1).resultant; }

 private:
  static hfdem::Specimen specimen(std::size_t count) {
    hfdem::Specimen s;
    s.density = density;
    for (std::size_t i = 0; i < count; ++i) s.centre.push_back({0, 2 * R * static_cast<double>(i)});
    s.radius.assign(count, R);
    return s;
  }
};

}  // namespace

TEST_CASE("a constant force without damping accelerates evenly") {
  Column column(1, 0);
  column.discs.load[0] = hfdem::Vec2{6, -3};
  CHECK(column.motion.dt() == dt);
  constexpr int steps = 50;
  for (int n = 0; n < steps; ++n) CHECK(column.step() == near(std::sqrt(6.0 * 6 + 3 * 3)));
  const Pack &velocity = column.velocity(0), &displacement = column.displacement(0);
  constexpr double both = dt * dt * steps * (steps + 1) / 2;
  CHECK(velocity[0] == near(6 / mass * steps * dt));
  CHECK(velocity[1] == near(-3 / mass * steps * dt));
  CHECK(displacement[0] == near(6 / mass * both));
  CHECK(displacement[1] == near(-3 / mass * both));
  CHECK(displacement[2] == 0);
}

TEST_CASE("a torque is the sum of both its lanes and turns the disc by its inertia") {
  Column column(2, 0);
  constexpr double difference = 2e-3, sum = 5e-3;
  column.forces.rows()[0] = Pack{4, 7, difference, sum};
  column.step();
  const Pack &first = column.velocity(0), &second = column.velocity(1);
  CHECK(second[0] == near(4 / mass * dt));
  CHECK(second[1] == near(7 / mass * dt));
  CHECK(second[2] == near((sum + difference) / inertia * dt));
  CHECK(first[0] == near(-4 / mass * dt));
  CHECK(first[1] == near(-7 / mass * dt));
  CHECK(first[2] == near((sum - difference) / inertia * dt));
  for (const Index i : {0U, 1U}) {
    CHECK(bits(column.velocity(i)[2]) == bits(column.velocity(i)[3]));
    CHECK(bits(column.displacement(i)[2]) == bits(column.displacement(i)[3]));
    CHECK(column.displacement(i)[2] == near(column.velocity(i)[2] * dt));
  }
}

TEST_CASE("a disc at rest without force stays at rest, in every direction of its own") {
  Column column(2, 0.7);
  column.discs.load[1] = hfdem::Vec2{5, 0};
  for (int n = 0; n < 20; ++n) column.step();
  for (std::size_t lane = 0; lane < 4; ++lane) {
    CHECK(column.displacement(0)[lane] == 0);
    CHECK((column.displacement(1)[lane] != 0) == (lane == 0));
  }
}

TEST_CASE("damping takes its part of a force that drives, and adds it to one that brakes") {
  constexpr double d = 0.7;
  constexpr int steps = 30;
  const double gain = 6 / mass * dt;  // of velocity in a step without damping

  Column driven(1, d);  // from rest, where there is no direction to damp: the first step is free
  driven.discs.load[0] = hfdem::Vec2{6, -6};
  for (int n = 0; n < steps; ++n) driven.step();
  CHECK(driven.velocity(0)[0] == near(gain * (1 + (steps - 1) * (1 - d))));
  CHECK(driven.velocity(0)[1] == near(-gain * (1 + (steps - 1) * (1 - d))));

  Column braked(1, d);
  braked.discs.load[0] = hfdem::Vec2{6, -6};
  const double start = 100 * gain;
  braked.discs.velocity[0] = Pack{-start, start, 0, 0};
  for (int n = 0; n < steps; ++n) braked.step();
  CHECK(braked.velocity(0)[0] == near(-start + steps * (1 + d) * gain));
  CHECK(braked.velocity(0)[1] == near(start - steps * (1 + d) * gain));

  Column coasting(1, d);
  coasting.discs.velocity[0] = Pack{3, 0, 0, 0};
  for (int n = 0; n < steps; ++n) coasting.step();
  CHECK(coasting.velocity(0)[0] == 3);
}

TEST_CASE("damping works on rotation as on translation") {
  Column column(2, 0.7);
  column.forces.rows()[0] = Pack{0, 0, 0, 5e-3};
  for (int n = 0; n < 3; ++n) column.step();
  CHECK(column.velocity(0)[2] == near(5e-3 / inertia * dt * (1 + 2 * 0.3)));
}

TEST_CASE("each swing on a spring keeps sqrt((1 - d) / (1 + d)) of its amplitude") {
  // Driven inwards with 1 - d of the force, braked outwards with 1 + d: the energies are equal.
  constexpr double d = 0.3;
  Column column(1, d);
  const double k = mass * 4e-6 / (dt * dt);  // 3000 steps in a period
  column.discs.displacement[0] = Pack{1e-6, 0, 0, 0};
  double amplitude = 1e-6;
  for (int swing = 0; swing < 4; ++swing) {
    double furthest = 0;
    const auto moves_on = [&] {
      const double v = column.velocity(0)[0];
      return swing % 2 == 0 ? v <= 0 : v >= 0;
    };
    while (moves_on()) {
      furthest = std::abs(column.displacement(0)[0]);
      column.discs.load[0] = hfdem::Vec2{-k * column.displacement(0)[0], 0};
      column.step();
    }
    amplitude *= std::sqrt((1 - d) / (1 + d));
    CHECK(furthest == near(amplitude, 0.01));
  }
}

TEST_CASE("a step tells the largest resultant, wherever it is") {
  constexpr std::size_t count = 700;  // more discs than one thread takes at a time
  for (const std::size_t strongest : {0U, 255U, 256U, 699U}) {
    Column column(count, 0.7);
    for (std::size_t i = 0; i < count; ++i) column.discs.load[i] = hfdem::Vec2{1, 1};
    column.discs.load[strongest] = hfdem::Vec2{-3, 4};
    CHECK(column.step() == near(5));
  }
}

TEST_CASE("a step tells when any force or torque is not a finite number") {
  constexpr std::size_t count = 300;
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    for (const std::size_t disc : {0U, 255U, 298U})
      for (std::size_t lane = 0; lane < 4; ++lane) {
        Column column(count, 0.7);
        column.discs.load[count - 1] = hfdem::Vec2{2, 1};
        column.forces.rows()[disc][lane] = bad;
        CHECK_FALSE(std::isfinite(column.step()));
      }
}

TEST_CASE("platens are not moved by forces") {
  Column column(2, 0.7);
  column.discs.load[0] = hfdem::Vec2{2, 1};
  column.step();
  for (const hfdem::Side side : hfdem::all_sides)
    for (std::size_t lane = 0; lane < 4; ++lane)
      CHECK(column.displacement(column.discs.platen(side))[lane] == 0);
}
