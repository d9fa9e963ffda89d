/// @file
/// The linear system of an implicit fluid step on the wet network,
///
///   [diag(own) + L(flow) + together 1 1^T] change = residual,
///
/// L being the Laplacian of the network. Without the last term it is sparse, symmetric and positive
/// definite; for that one, of rank one, Sherman and Morrison's formula stands. Domains are
/// eliminated from the tips inwards: a crack without loops fills nothing in, and the mirror images
/// of a symmetric one get the same bits.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/base/graph_system.hpp>
#include <hfdem/pressure/stored_fluid.hpp>

namespace hfdem {

/// Keeps the pattern of the matrix while no channel joins.
class FlowSystem {
 public:
  /// The matrix, in the numbering of the wet network.
  struct Coefficients {
    std::span<const double> own;   ///< one per domain, m2/Pa
    std::span<const double> flow;  ///< volume that flows per pressure drop, one per channel, m2/Pa
    double together;               ///< by how much all domains answer one another, m2/Pa
  };

  /// Solves for the change of pressure in the domains that take part; others keep theirs.
  /// @param fluid which domains its channels join
  /// @param matrix its coefficients
  /// @param residual right side, m2, one per domain
  /// @param takes_part one per domain, at least one of them true
  /// @param pressure to which the change is added, Pa, one per domain
  /// @throws RunStopped if there is no solution
  void add_solution(const StoredFluid& fluid, const Coefficients& matrix,
                    std::span<const double> residual, const std::vector<bool>& takes_part,
                    std::span<double> pressure) {
    const std::size_t n = fluid.size();
    const bool found = system_.factorise(fluid.channels(), {matrix.own, matrix.flow}, takes_part);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n)), ones = right;
    for (std::size_t d = 0; d < n; ++d)
      if (takes_part[d]) right[system_.row(d)] = residual[d], ones[system_.row(d)] = 1;
    const Eigen::VectorXd change = system_.solve(right), even = system_.solve(ones);
    double all_change = 0, all_even = 0;
    for (Eigen::Index k = 0; k < ones.size(); ++k)
      all_change += ones[k] * change[k], all_even += ones[k] * even[k];
    const double less = matrix.together * all_change / (1 + matrix.together * all_even);
    // A maximum loses what is not a number; a sum keeps it.
    if (!found || !std::isfinite(less + all_change))
      throw RunStopped(
          "the pressures have no solution: a width or a pressure is not a finite number");
    for (std::size_t d = 0; d < n; ++d)
      pressure[d] = pressure[d] + change[system_.row(d)] - less * even[system_.row(d)];
  }

 private:
  GraphSystem<> system_;
};

}  // namespace hfdem
