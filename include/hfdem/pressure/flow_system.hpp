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

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <hfdem/base/errors.hpp>
#include <hfdem/pressure/stored_fluid.hpp>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

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
    Eigen::VectorXd right = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n)), ones = right;
    for (std::size_t d = 0; d < n; ++d)
      if (takes_part[d]) right[row(d, n)] = residual[d], ones[row(d, n)] = 1;
    assemble(fluid, matrix, takes_part);
    const Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factor(matrix_);
    const Eigen::VectorXd change = factor.solve(right), even = factor.solve(ones);
    double all_change = 0, all_even = 0;
    for (Eigen::Index k = 0; k < ones.size(); ++k)
      all_change += ones[k] * change[k], all_even += ones[k] * even[k];
    const double less = matrix.together * all_change / (1 + matrix.together * all_even);
    // A maximum loses what is not a number; a sum keeps it.
    if (factor.info() != Eigen::Success || !std::isfinite(less + all_change))
      throw RunStopped(
          "the pressures have no solution: a width or a pressure is not a finite number");
    for (std::size_t d = 0; d < n; ++d)
      pressure[d] = pressure[d] + change[row(d, n)] - less * even[row(d, n)];
  }

 private:
  using Matrix = Eigen::SparseMatrix<double>;

  /// Unknowns are numbered against the order in which domains turned wet.
  static Eigen::Index row(std::size_t domain, std::size_t domains) {
    return static_cast<Eigen::Index>(domains - 1 - domain);
  }

  void assemble(const StoredFluid& fluid, const Coefficients& matrix,
                const std::vector<bool>& takes_part) {
    const std::size_t n = fluid.size();
    const auto channels = fluid.channels();
    if (matrix_.rows() != static_cast<Eigen::Index>(n) || joined_ != channels.size())
      make_pattern(fluid);
    matrix_.coeffs().setZero();
    for (std::size_t d = 0; d < n; ++d)
      matrix_.coeffRef(row(d, n), row(d, n)) = takes_part[d] ? matrix.own[d] : 1;
    for (std::size_t k = 0; k < channels.size(); ++k) {
      const bool first = takes_part[channels[k].first], second = takes_part[channels[k].second];
      const Eigen::Index a = row(channels[k].first, n), b = row(channels[k].second, n);
      if (first) matrix_.coeffRef(a, a) += matrix.flow[k];
      if (second) matrix_.coeffRef(b, b) += matrix.flow[k];
      if (first && second) matrix_.coeffRef(std::max(a, b), std::min(a, b)) -= matrix.flow[k];
    }
  }

  /// The lower triangle.
  void make_pattern(const StoredFluid& fluid) {
    const std::size_t n = fluid.size();
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t d = 0; d < n; ++d) entries.emplace_back(row(d, n), row(d, n), 1.0);
    for (const WetChannel& c : fluid.channels()) {
      const Eigen::Index a = row(c.first, n), b = row(c.second, n);
      entries.emplace_back(std::max(a, b), std::min(a, b), 0.0);
    }
    matrix_.resize(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    matrix_.setFromTriplets(entries.begin(), entries.end());
    joined_ = fluid.channels().size();
  }

  Matrix matrix_;
  std::size_t joined_ = 0;  // channels in the matrix
};

}  // namespace hfdem
