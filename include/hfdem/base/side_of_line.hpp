/// @file
/// On which side of a line a point lies, free of rounding error. Source: J. R. Shewchuk, "Adaptive
/// precision floating-point arithmetic and fast robust geometric predicates", Discrete &
/// Computational Geometry 18 (1997), 305-363.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include <hfdem/base/vec2.hpp>

namespace hfdem {

namespace detail {

/// The sum of at most six products, exact: kept as numbers that share no bits (Shewchuk's
/// expansions), the greatest of them last. It is exact while no product under- or overflows.
class SumOfProducts {
 public:
  void add(double a, double b) {
    const double product = a * b;
    grow(std::fma(a, b, -product));
    grow(product);
  }

  /// 1, 0 or -1.
  int sign() const {
    for (std::size_t k = size_; k-- > 0;)
      if (part_[k] != 0) return part_[k] > 0 ? 1 : -1;
    return 0;
  }

 private:
  /// Adds one number to all parts; each keeps the rounding error of its sum.
  void grow(double carry) {
    for (std::size_t k = 0; k < size_; ++k) {
      const double sum = carry + part_[k], added = sum - carry;
      part_[k] = (carry - (sum - added)) + (part_[k] - added);
      carry = sum;
    }
    part_[size_++] = carry;
  }

  std::array<double, 12> part_{};
  std::size_t size_ = 0;
};

}  // namespace detail

/// The side of the line from `a` to `b` on which `p` lies.
/// @returns 1 on the left, -1 on the right, 0 exactly on the line
inline int side_of_line(Vec2 a, Vec2 b, Vec2 p) {
  const double along = (a.x - p.x) * (b.y - p.y), across = (a.y - p.y) * (b.x - p.x);
  const double twice_area = along - across;
  constexpr double rounding = 3.4e-16;  // (3 + 16 epsilon) epsilon, with epsilon = 2^-53
  if (std::abs(twice_area) > rounding * (std::abs(along) + std::abs(across)))
    return twice_area > 0 ? 1 : -1;
  detail::SumOfProducts exact;
  exact.add(a.x, b.y);
  exact.add(-a.y, b.x);
  exact.add(b.x, p.y);
  exact.add(-b.y, p.x);
  exact.add(p.x, a.y);
  exact.add(-p.y, a.x);
  return exact.sign();
}

}  // namespace hfdem
