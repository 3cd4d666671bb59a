// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>

#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/point_set.h"

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

/// conv{o, o + a_1 e_1, …, o + a_n e_n}, the simplex with a right-angled corner at o and legs a_k along the
/// axes (a_k of either sign, or 0). With o = 0 and a = 1 it is {x >= 0 : Σx_k <= 1}. Any other simplex is an
/// AffineImage of it, or a PointSet of its vertices.
///
///     h(u) = u·o + max(0, max_k a_k u_k),      s(u) = o + a_k e_k for the smallest maximising k, or o.
class Simplex final : public ConvexSet {
 public:
  /// Throws InvalidParameterError (n < 1), DimensionMismatchError or NonFiniteError.
  Simplex(const ConstVectorRef& corner, const ConstVectorRef& legs);

  const Vector& corner() const noexcept { return corner_; }
  const Vector& legs() const noexcept { return legs_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override;

  Vector corner_;
  Vector legs_;
  std::unique_ptr<const PointSet> vertices_;  // for n = 2 and 3, where they are doubles exactly
};

/// {c + Σ_i t_i g_i : |t_i| <= 1}, the zonotope with centre c and generators g_i: the Minkowski sum of the
/// segments [-g_i, g_i], about c.
///
///     h(u) = u·c + Σ_i |u·g_i|,      s(u) = c + Σ_i sign(u·g_i) g_i  (+ for 0).
///
/// Generators may be dependent, zero, or none: it is flat then, or the point c.
class Zonotope final : public ConvexSet {
 public:
  /// `generators` is n × m, one a column. Throws InvalidParameterError (n < 1), DimensionMismatchError or
  /// NonFiniteError.
  Zonotope(const ConstVectorRef& center, const Eigen::Ref<const Eigen::MatrixXd>& generators);

  const DenseMatrix& generators() const noexcept { return generators_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  double do_inner_radius(const double* c) const override;
  SupportStructure do_structure() const noexcept override { return SupportStructure::polytope; }

  Vector center_;
  DenseMatrix generators_;
  Vector magnitude_;
  double radius_ = 0;  // of a ball about c inside
};

}  // namespace raygauge
