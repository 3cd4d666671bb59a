// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// Primal simplex for  max u·x, G x <= g.  At a vertex n inequalities are active, B x = g_B; the multipliers
/// λ of u = Bᵀ λ choose the one that leaves, the ratio test along -B⁻¹e_i the one that enters. An entry of -1
/// in `active` marks an artificial plane x_k = const through a start that is not a vertex.
class InequalitySimplex {
 public:
  using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  struct Vertex {
    Vector x;
    std::vector<int> active;  ///< a row for each column of `edges`, or -1
    DenseMatrix edges;        ///< B⁻¹
  };
  enum class End : std::uint8_t {
    optimal,
    unbounded,  ///< an edge meets no inequality
    stalled,    ///< ended because of rounding; the point is perhaps not optimal
  };

  InequalitySimplex() = default;
  /// Every row and its bound are multiplied by a power of two first, which changes nothing.
  InequalitySimplex(const Eigen::Ref<const Eigen::MatrixXd>& G, const ConstVectorRef& g);

  /// The start at a point with G x <= g.
  Vertex start_at(const Vector& x) const;

  /// Starts from `at` and stores the maximiser there.
  End maximise(const ConstVectorRef& u, Vertex& at) const;

  /// λ of u = Bᵀ λ, to rounding; entries of unit vectors among them.
  Vector multipliers(const ConstVectorRef& u, const Vertex& at) const;

  const RowMatrix& G() const noexcept { return G_; }
  const Vector& g() const noexcept { return g_; }

 private:
  struct Edge {
    int leaving = -1;    ///< a column of `edges`; -1: none leads up
    double sign = -1.0;  ///< of the column, so that it leads up
  };
  Edge choose_edge(const Vector& multipliers, const Vertex& at, bool bland) const;
  int first_met(const Vector& direction, const Vector& slack, bool bland, double& step) const;
  void exchange(Vertex& at, int leaving, int row) const;
  bool factorise(Vertex& at) const;
  RowMatrix G_;
  Vector g_;
};

}  // namespace raygauge
