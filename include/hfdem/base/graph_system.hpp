/// @file
/// Sparse systems on a graph, [diag(own) + L(flow)] x = b, L being the graph's Laplacian: what flow
/// through a network of channels comes to in an implicit step. Symmetric and positive definite.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

namespace hfdem {

/// Keeps the pattern of the matrix while nodes and edges stay.
/// @tparam Ordering in which nodes are eliminated; with the natural one, from the last to the first
template <class Ordering = Eigen::NaturalOrdering<int>>
class GraphSystem {
 public:
  using Vector = Eigen::VectorXd;  ///< one entry per node, in the order of `row`

  GraphSystem() = default;
  GraphSystem(const GraphSystem&) {}  ///< finds its pattern anew
  /// Finds its pattern anew.
  GraphSystem& operator=(const GraphSystem&) {
    forget_pattern();
    return *this;
  }

  /// Coefficients of the matrix.
  struct Coefficients {
    std::span<const double> own;   ///< one per node
    std::span<const double> flow;  ///< one per edge
  };

  /// Factorises.
  /// @param edges with members `first` and `second`, the numbers of two nodes
  /// @param matrix its coefficients
  /// @param takes_part one per node: the others stay what they are, and their x is b
  /// @returns whether it could be done
  template <class Edges>
  bool factorise(const Edges& edges, const Coefficients& matrix,
                 const std::vector<bool>& takes_part) {
    const std::size_t n = matrix.own.size();
    if (matrix_.rows() != static_cast<Eigen::Index>(n) || edges_ != edges.size())
      make_pattern(n, edges);
    matrix_.coeffs().setZero();
    for (std::size_t d = 0; d < n; ++d)
      matrix_.coeffRef(row(d), row(d)) = takes_part[d] ? matrix.own[d] : 1;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      const bool first = takes_part[edges[k].first], second = takes_part[edges[k].second];
      const Eigen::Index a = row(edges[k].first), b = row(edges[k].second);
      if (first) matrix_.coeffRef(a, a) += matrix.flow[k];
      if (second) matrix_.coeffRef(b, b) += matrix.flow[k];
      if (first && second) matrix_.coeffRef(std::max(a, b), std::min(a, b)) -= matrix.flow[k];
    }
    factor_.factorize(matrix_);
    return factor_.info() == Eigen::Success;
  }

  /// @param right b, in the order of `row`
  Vector solve(const Vector& right) const { return factor_.solve(right); }

  /// Where a node is among the unknowns, against the order of their numbers.
  Eigen::Index row(std::size_t node) const {
    return matrix_.rows() - 1 - static_cast<Eigen::Index>(node);
  }
  /// Call it when edges have changed, but not their number.
  void forget_pattern() { edges_ = 0, matrix_.resize(0, 0); }

 private:
  /// The lower triangle.
  template <class Edges>
  void make_pattern(std::size_t n, const Edges& edges) {
    matrix_.resize(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t d = 0; d < n; ++d) entries.emplace_back(row(d), row(d), 1.0);
    for (const auto& edge : edges) {
      const Eigen::Index a = row(edge.first), b = row(edge.second);
      entries.emplace_back(std::max(a, b), std::min(a, b), 0.0);
    }
    matrix_.setFromTriplets(entries.begin(), entries.end());
    edges_ = edges.size();
    factor_.analyzePattern(matrix_);
  }

  using Matrix = Eigen::SparseMatrix<double>;

  Matrix matrix_;
  std::size_t edges_ = 0;
  Eigen::SimplicialLDLT<Matrix, Eigen::Lower, Ordering> factor_;
};

}  // namespace hfdem
