// The bound on the largest frequency against eigenvalues of a stiffness matrix assembled here, and
// runs on both sides of the stability limit.
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include <hfdem/base/pack.hpp>
#include <hfdem/mechanics/motion.hpp>
#include <hfdem/mechanics/stable_step.hpp>
#include <hfdem/setup/square_array.hpp>

#include <doctest/doctest.h>

#include "laws/random.hpp"
#include "loops/assembly.hpp"
#include "near.hpp"

namespace {

using hfdem::Index;
using hfdem::Vec2;
using test::near;
using Law = hfdem::LinearParallelBond;

constexpr Law::Params rock{};  // the defaults, whose fastest mode is mostly a displacement
constexpr Law::Params stiff_in_shear{.stiffness_ratio = 0.4, .bond_stiffness_ratio = 0.4};
constexpr Law::Params stiff_in_bending{.E = 1, .bond_stiffness_ratio = 1e3};

/// A square matrix, and just enough algebra to find its largest eigenvalue.
struct Matrix {
  std::size_t size;
  std::vector<double> entries = std::vector<double>(size * size, 0.0);

  double& operator()(std::size_t row, std::size_t column) { return entries[row * size + column]; }
  double operator()(std::size_t row, std::size_t column) const {
    return entries[row * size + column];
  }
  /// Of a symmetric matrix.
  Matrix squared() const {
    Matrix result{size};
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        result(i, j) = result(j, i) = std::inner_product(
            &entries[i * size], &entries[i * size] + size, &entries[j * size], 0.0);
    return result;
  }
  void normalise() {
    double trace = 0;
    for (std::size_t i = 0; i < size; ++i) trace += (*this)(i, i);
    for (double& e : entries) e /= trace;
  }
};

/// How a spring is stretched by the coordinates of the discs: (x, y, rotation) of each.
using Strain = std::vector<std::pair<std::size_t, double>>;

/// Stiffness over mass in the coordinates sqrt(mass) x, sqrt(mass) y and sqrt(inertia) rotation,
/// from the definitions: springs between the points of two discs that meet at a contact.
Matrix dynamic_matrix(const hfdem::Specimen& s, const Law::Params& p, bool platens) {
  Matrix K{3 * s.size()};
  const auto scale = [&](std::size_t coordinate) {
    const double R = s.radius[coordinate / 3], m = s.density * std::acos(-1.0) * R * R;
    return 1 / std::sqrt(coordinate % 3 == 2 ? m * R * R / 2 : m);
  };
  const auto add_spring = [&](double k, const Strain& strain) {
    for (const auto& [a, by_a] : strain)
      for (const auto& [b, by_b] : strain) K(a, b) += k * by_a * scale(a) * by_b * scale(b);
  };
  for (std::size_t j = 0; j < s.size(); ++j)
    for (std::size_t i = 0; i < j; ++i) {
      const Vec2 between = s.centre[j] - s.centre[i];
      const double d = norm(between), R1 = s.radius[i], R2 = s.radius[j], L = R1 + R2;
      if (d - L > s.bonding_gap) continue;
      const Vec2 n = (1 / d) * between, t{-n.y, n.x};
      const double arm_i = R1 + (d - L) / 2, arm_j = d - arm_i, Rb = std::fmin(R1, R2);
      const double area = 2 * Rb, inertia = 2.0 / 3 * Rb * Rb * Rb;
      const double k_s = area / L * (p.E / p.stiffness_ratio + p.bond_E / p.bond_stiffness_ratio);
      add_spring(area / L * (p.E + p.bond_E),
                 {{3 * i, -n.x}, {3 * i + 1, -n.y}, {3 * j, n.x}, {3 * j + 1, n.y}});
      add_spring(k_s, {{3 * i, -t.x},
                       {3 * i + 1, -t.y},
                       {3 * i + 2, -arm_i},
                       {3 * j, t.x},
                       {3 * j + 1, t.y},
                       {3 * j + 2, -arm_j}});
      add_spring(p.bond_E / L * inertia, {{3 * i + 2, -1}, {3 * j + 2, 1}});
    }
  for (Index i = 0; platens && i < s.size(); ++i)
    for (const hfdem::Side side : hfdem::all_sides)
      if (s.touches(i, side))
        add_spring(2 * (p.E + p.bond_E), {{3 * i + (hfdem::is_vertical(side) ? 0U : 1U), 1}});
  return K;
}

struct Mode {
  double frequency;            // 1/s
  std::vector<double> motion;  // x, y and rotation of each disc
};

/// A matrix that is squared over and over comes down to its largest eigenvalue's eigenvectors.
Mode fastest_mode(const hfdem::Specimen& s, const Law::Params& p, bool platens) {
  const Matrix K = dynamic_matrix(s, p, platens);
  Matrix power = K;
  for (int n = 0; n < 25; ++n) {
    power.normalise();
    power = power.squared();
  }
  const std::size_t size = K.size;
  std::size_t best = 0;
  for (std::size_t i = 0; i < size; ++i)
    if (power(i, i) > power(best, best)) best = i;
  const auto row = [&](const Matrix& m, std::size_t i) { return &m.entries[i * size]; };
  const double* v = row(power, best);
  double vKv = 0;
  for (std::size_t i = 0; i < size; ++i)
    vKv += v[i] * std::inner_product(v, v + size, row(K, i), 0.0);
  Mode mode{std::sqrt(vKv / std::inner_product(v, v + size, v, 0.0)), {v, v + size}};
  for (std::size_t k = 0; k < size; ++k) {
    const double R = s.radius[k / 3];
    mode.motion[k] /= k % 3 == 2 ? R * R / std::sqrt(2.0) : R;  // masses go as R^2
  }
  return mode;
}

double bound(const test::Assembly<Law>& a) {
  hfdem::FrequencyBound result(a.discs);
  for (std::size_t c = 0; c < a.rock.size(); ++c)
    result.add(a.contacts[c], a.rock.law().springs(a.rock.stiffness(c)));
  for (std::size_t c = 0; c < a.platens.size(); ++c)
    result.add(a.touching[c], a.platens.law().springs(a.platens.stiffness(c)));
  return result.value();
}

/// How far free vibration in the fastest mode grows within a hundred steps that are `share` of the
/// stable one. Bonds alone: they are linear both ways.
double growth(double share, double damping) {
  Law::Params bonds = rock;
  bonds.E = 1;
  test::Random random(1);
  test::Assembly a(test::jittered_discs(5, 5, random), Law(bonds));
  const Mode mode = fastest_mode(a.specimen, bonds, false);
  double size = 0;
  for (std::size_t i = 0; i < a.discs.size(); ++i) {
    const double *m = &mode.motion[3 * i], scale = 1e-9;
    a.discs.displacement[i] = scale * hfdem::Pack{m[0], m[1], m[2], m[2]};
    for (std::size_t lane = 0; lane < 3; ++lane) size = std::fmax(size, std::abs(scale * m[lane]));
  }
  hfdem::DiscMotion motion(a.discs, share * hfdem::stable_step(mode.frequency, damping), damping);
  double largest = 0;
  for (int step = 0; step < 100; ++step) {
    a.rock.evaluate(a.discs.displacement, a.forces.rows(), 1);
    motion.step(a.discs, a.forces, 1);
    for (const hfdem::Pack& row : a.discs.displacement)
      for (std::size_t lane = 0; lane < 3; ++lane)
        largest = std::fmax(largest, std::abs(row[lane]));
  }
  return largest / size;
}

}  // namespace

TEST_CASE("the frequency bound of a square array is above the largest frequency, and close") {
  for (const int size : {2, 3, 6})
    for (const auto& params : {rock, stiff_in_shear, stiff_in_bending}) {
      const test::Assembly a(hfdem::square_array(size, size + 1, 5e-3), Law(params));
      const double exact = fastest_mode(a.specimen, params, true).frequency;
      CHECK(bound(a) >= exact);
      CHECK(bound(a) < 1.25 * exact);
    }
}

TEST_CASE("the frequency bound of irregular discs is above the largest frequency") {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U})
    for (const auto& params : {rock, stiff_in_shear, stiff_in_bending}) {
      test::Random random(seed);
      const test::Assembly a(test::jittered_discs(4, 4, random), Law(params));
      const double exact = fastest_mode(a.specimen, params, true).frequency;
      CHECK(bound(a) >= exact);
      CHECK(bound(a) < 2 * exact);
    }
}

TEST_CASE("the frequency bound of two discs is above the largest frequency, whatever their sizes") {
  // With so few neighbours there is little to spare in the bound.
  for (const double size : {1.0, 0.4, 2.5})
    for (const double angle : {0.0, 0.6, std::acos(-1.0) / 2})
      for (const auto& params : {rock, stiff_in_shear, stiff_in_bending}) {
        constexpr double R = 4e-3;
        const Vec2 first{0.5, 0.5}, along{std::cos(angle), std::sin(angle)};
        const test::Assembly a({.width = 1,
                                .height = 1,
                                .density = 2500,
                                .centre = {first, first + (1 + size) * R * along},
                                .radius = {R, size * R},
                                .bonding_gap = 1e-9,
                                .pairs = {{0, 1}}},
                               Law(params));
        CHECK(bound(a) >= fastest_mode(a.specimen, params, false).frequency);
      }
}

TEST_CASE("the frequency of a single disc between two platens is exact") {
  constexpr double R = 5e-3, density = 3000;
  const test::Assembly a({.width = 2 * R,
                          .height = 1,
                          .density = density,
                          .centre = {{R, 0.5}},
                          .radius = {R},
                          .bonding_gap = 1e-9,
                          .pairs = {}},
                         Law(rock));
  const double k = 2 * (rock.E + rock.bond_E), m = density * std::acos(-1.0) * R * R;
  CHECK(bound(a) == near(std::sqrt(2 * k / m)));
}

TEST_CASE("free vibration stays bounded just below the stable step and explodes just above") {
  for (const double damping : {0.0, 0.7}) {
    CAPTURE(damping);
    CHECK(growth(0.99, damping) < 10);
    CHECK(growth(1.01, damping) > 1e4);
  }
}
