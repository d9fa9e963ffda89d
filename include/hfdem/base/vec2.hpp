/// @file
/// Plane vectors.
#pragma once

#include <cmath>

namespace hfdem {

/// A vector in the plane: x to the right, y upwards.
struct Vec2 {
  double x = 0, y = 0;  ///< component; its unit is that of what the vector means

  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
  friend constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
  friend constexpr bool operator==(Vec2, Vec2) = default;
};

/// Scalar product.
constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
/// Positive when b lies to the left of a.
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// a turned by a quarter, counter-clockwise.
constexpr Vec2 left_of(Vec2 a) { return {-a.y, a.x}; }
/// Length.
inline double norm(Vec2 a) { return std::sqrt(dot(a, a)); }

}  // namespace hfdem
