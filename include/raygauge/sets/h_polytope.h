// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// {x : G x <= g}, a bounded polytope with interior, given by its m inequalities (an H-polytope).
///
///     h(u) = max{u·x : G x <= g},   s(u) a vertex: one linear program, by a simplex method from a stored
///     vertex; gauge(x) = max(0, max_i (G_i·x) / g_i)   where g > 0, that is where the origin is inside.
///
/// h(u) is a proven upper bound, whatever rounding does to the program. With multipliers λ >= 0 and a bound R
/// on the coordinates of points of S it is g·λ + |u - Gᵀλ|_1 R. s(u) is moved towards the centre until it
/// satisfies all inequalities.
///
/// Its centre is that of a largest ball inside (Chebyshev). A support query takes O(m n) a basis change.
/// Unlike those of the closed forms, it allocates room for an n × n matrix.
class HPolytope final : public ConvexSet, private GaugeFormula {
 public:
  /// `G` is m × n. Throws InvalidParameterError (no row, a zero row, not bounded or not provably so, no
  /// interior), EmptySetError, DimensionMismatchError or NonFiniteError.
  HPolytope(const Eigen::Ref<const Eigen::MatrixXd>& G, const ConstVectorRef& g);

  /// Defined in the library: Eigen's allocator depends on compiler flags, and the library made the matrices.
  ~HPolytope() override;

  /// The inequalities, each multiplied by a power of two.
  const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>& G() const noexcept;
  const Vector& g() const noexcept;

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  double do_gauge(const double* x, double* normal) const override;
  SupportStructure do_structure() const noexcept override { return SupportStructure::polytope; }
  const GaugeFormula* do_gauge_formula() const noexcept override { return this; }

  double rounding_of(Eigen::Index i, const ConstVectorRef& x) const;
  double bound_by_one_row(int k, double sign) const;
  void draw_inside(Vector& x) const;
  void find_center();
  void find_extent();

  struct Program;  // with the vertex that it starts from

  std::shared_ptr<Program> program_;
  Vector center_;
  Vector margins_;     // g - G center, at least
  double extent_ = 0;  // R
  Vector magnitude_;
};

}  // namespace raygauge
