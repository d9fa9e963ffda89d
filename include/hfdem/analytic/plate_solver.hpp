/// @file
/// A central crack under uniform pressure in a rectangular plate, solved for one length.
///
/// The load is a pull of 1 across the crack: it opens a free crack as a pressure of 1 opens a crack
/// in the plate without it. What the sides prescribe is tested with the quantity of every field
/// that does work on it (Trefftz's method in Galerkin form), so that the errors of K_I, opening and
/// volume are quadratic in those on the sides.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include <hfdem/analytic/plate_fields.hpp>

namespace hfdem::analytic {

/// A crack in a plate relative to the same crack in an infinite plane, at the same net pressure p
/// and half-length a.
struct PlateFactors {
  double toughness;  ///< F_K = K_I / (p sqrt(pi a))
  double width;      ///< f_w = w(0) / (4 p a / E')
  double volume;     ///< f_V = V / (2 pi p a^2 / E')
};

namespace detail {

/// Solves a small full system by elimination with row exchange.
/// @param rows its equations, each followed by its right-hand side
inline std::vector<double> solve_linear(std::vector<std::vector<double>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t largest = k;
    for (std::size_t r = k + 1; r < n; ++r)
      if (std::abs(rows[r][k]) > std::abs(rows[largest][k])) largest = r;
    std::swap(rows[k], rows[largest]);
    for (std::size_t r = k + 1; r < n; ++r) {
      const double share = rows[r][k] / rows[k][k];
      for (std::size_t c = k; c <= n; ++c) rows[r][c] -= share * rows[k][c];
    }
  }
  std::vector<double> x(n);
  for (std::size_t k = n; k-- > 0;) {
    x[k] = rows[k][n];
    for (std::size_t c = k + 1; c < n; ++c) x[k] -= rows[k][c] * x[c];
    x[k] /= rows[k][k];
  }
  return x;
}

/// Solves plates of one rock; the factors do not depend on Poisson's ratio while the sides carry a
/// given mean stress.
class PlateSolver {
 public:
  /// @param height of the plate over its width
  /// @param rho E / (2 G) - nu
  /// @param rigid smooth rigid sides; otherwise sides under constant stress
  PlateSolver(double height, double rho, bool rigid) : height_(height), rho_(rho), rigid_(rigid) {}

  /// @param a half-length of the crack over half the width, 0 < a < 1
  PlateFactors solve(double a) const {
    auto [fields, wanted] = on_the_sides(a);
    separate(fields);
    std::vector<std::vector<double>> equations(fields.size());
    for (std::size_t e = 0; e < fields.size(); ++e) {
      const double* test = fields[e].data() + rows;
      for (const Column& field : fields) equations[e].push_back(dot(test, field.data()));
      equations[e].push_back(dot(test, wanted.data()));
    }
    const auto shares = solve_linear(std::move(equations));
    std::array<double, results> sum{};
    for (std::size_t f = 0; f < fields.size(); ++f)
      for (std::size_t r = 0; r < results; ++r) sum[r] += shares[f] * fields[f][2 * rows + r];
    // Rigid sides were moved apart by a given distance; this is the mean stress that it took.
    const double pull = rigid_ ? sum[tension] : 1;
    return {sum[toughness] / pull, sum[width] / pull, sum[volume] / pull};
  }

 private:
  static constexpr std::size_t points = 40, rows = 4 * points;
  /// A field at the points of the sides, first the quantities that the sides prescribe, then those
  /// that do work on them; and its results.
  using Column = std::vector<double>;
  enum Result : std::size_t { toughness, width, volume, tension, results };
  struct Sides {
    std::vector<Column> fields;
    Column wanted;
  };

  /// One quarter of the plate.
  Sides on_the_sides(double a) const {
    constexpr std::size_t terms = CrackFields::terms;
    const CrackFields crack(rho_, height_, a);
    Sides s{std::vector(2 * terms, Column(2 * rows + results, 0.0)), Column(rows, 0.0)};
    const double reach = std::asinh(height_ / (1 - a));
    for (std::size_t p = 0; p < points; ++p) {
      const auto [place, weight] = fejer(p);
      // Points on the side that ends the ligament crowd towards it as it gets short.
      const double y = (1 - a) * std::sinh(reach * place);
      const double y_weight = (1 - a) * std::cosh(reach * place) * reach * weight;
      const std::size_t right = 2 * p, top = 2 * (points + p);
      const auto at_right = crack.at(1, y), at_top = crack.at(place, height_);
      for (std::size_t f = 0; f < 2 * terms; ++f) {
        const auto &r = at_right[f], &t = at_top[f];
        enter(s.fields[f], right, std::sqrt(y_weight), {r.xx, r.xy, r.u, r.v});
        enter(s.fields[f], top, std::sqrt(weight), {t.yy, t.xy, t.v, t.u});
        s.fields[f][2 * rows + tension] += weight * t.yy;
      }
      s.wanted[top] = std::sqrt(weight) * (rigid_ ? height_ : 1);
    }
    const auto at_tip = crack.on_the_crack(a), at_middle = crack.on_the_crack(0);
    for (std::size_t j = 0; j < terms; ++j) {
      s.fields[j][2 * rows + toughness] = at_tip[j];
      s.fields[j][2 * rows + width] = at_middle[j];
    }
    // 4 / (pi a^2) int_0^a Q sqrt(a^2 - x^2) dx, by the Gauss-Chebyshev rule of the second kind.
    constexpr int half = 24;
    for (int k = 1; k <= half; ++k) {
      const double angle = k * std::numbers::pi / (2 * half + 1), sine = std::sin(angle);
      const auto Q = crack.on_the_crack(a * std::cos(angle));
      for (std::size_t j = 0; j < terms; ++j)
        s.fields[j][2 * rows + volume] += 4 * sine * sine / (2 * half + 1) * Q[j];
    }
    return s;
  }

  /// Stress normal to a side, shear, displacement normal to it and along it.
  struct AtSide {
    double stress, shear, normal, along;
  };
  void enter(Column& field, std::size_t row, double root_weight, const AtSide& s) const {
    field[row] = root_weight * (rigid_ ? s.normal : s.stress);
    field[rows + row] = root_weight * (rigid_ ? -s.stress : s.normal);
    field[row + 1] = root_weight * s.shear;
    field[rows + row + 1] = root_weight * s.along;
  }

  /// Place and weight on [0, 1], Fejer's first rule.
  static std::pair<double, double> fejer(std::size_t p) {
    constexpr int n = points;
    const double angle = (static_cast<double>(p) + 0.5) * std::numbers::pi / n;
    double weight = 1;
    for (int j = 1; j <= n / 2; ++j) weight -= 2 * std::cos(2 * j * angle) / (4 * j * j - 1);
    return {(1 - std::cos(angle)) / 2, weight / n};
  }

  /// Over what the sides prescribe.
  static double dot(const double* a, const double* b) {
    return std::inner_product(a, a + rows, b, 0.0);
  }

  /// Powers are nearly dependent: replaces the fields by combinations that differ in what the sides
  /// prescribe, the most different first, and leaves out what round-off hides.
  static void separate(std::vector<Column>& fields) {
    const auto size = [](const Column& f) { return std::sqrt(dot(f.data(), f.data())); };
    const auto shrink = [](Column& f, double by) {
      for (double& v : f) v /= by;
    };
    for (Column& f : fields) shrink(f, size(f));
    for (std::size_t k = 0; k < fields.size(); ++k) {
      std::size_t next = k;
      double largest = 0;
      for (std::size_t f = k; f < fields.size(); ++f)
        if (const double s = size(fields[f]); s > largest) largest = s, next = f;
      if (largest < 1e-13) return fields.resize(k);
      std::swap(fields[k], fields[next]);
      shrink(fields[k], largest);
      for (std::size_t f = k + 1; f < fields.size(); ++f) {
        const double share = dot(fields[k].data(), fields[f].data());
        for (std::size_t v = 0; v < fields[f].size(); ++v) fields[f][v] -= share * fields[k][v];
      }
    }
  }

  double height_, rho_;
  bool rigid_;
};

}  // namespace detail

}  // namespace hfdem::analytic
