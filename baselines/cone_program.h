// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "raygauge/sweep/instance.h"

namespace raygauge {

/// The convex program (5) of Zheng & Yamane for sets that are given by second-order cones,
///
///     minimize λ   over y = (λ, x) in R^(1+n)   subject to   |J_i y + j_i| <= g_i·y + γ_i for all i,   λ >=
///     0.
///
/// A set {x : |F x + f| <= g·x + γ} contributes itself as A, and {|F x + λf| <= g·x + λγ} as Q. A half-space
/// has no rows in F. Known are
///
///     ellipsoid         |L⁻¹(x - c)| <= 1                                  (square factor L of full rank)
///     ball              |x - c| <= r                                        (r > 0)
///     box               ±(x_k - c_k) <= h_k
///     truncated cone    |x_⊥ - p_b⊥| <= r_b + (r_t - r_b) t,  0 <= t <= 1,  t = a·(x - p_b)/|p_t - p_b|.
class ConeProgram {
 public:
  /// `method` names the asker in messages. Throws InvalidParameterError for a set of another kind or a flat
  /// one, and DimensionMismatchError where the sets live in different spaces.
  ConeProgram(const Instance& instance, const std::string& method);

  /// 1 + n.
  int variables() const noexcept { return variables_; }
  int constraints() const noexcept { return static_cast<int>(constraints_.size()); }

  /// (λ, s_A(-a_c)): the point of A that lies farthest from its centre towards the origin, with the least λ
  /// for which the constraints hold, to a millionth (1 where no multiple of Q reaches it). There every |w|
  /// has a derivative.
  const Vector& start() const noexcept { return start_; }

  /// c_i(y) = |J_i y + j_i| - g_i·y - γ_i, convex, at most 0 where the constraint holds; its gradient (at a
  /// zero of the norm the one without it) is written to `gradient`, variables() doubles, unless that is
  /// nullptr. Not for two threads at once: scratch is kept.
  double value(int i, const double* y, double* gradient);

 private:
  /// |J y + j| <= g·y + γ. Jᵀ is stored, so that a row of J is contiguous.
  struct Constraint {
    Eigen::MatrixXd J_transposed;
    Vector j;
    Vector g;
    double gamma = 0;
  };
  struct Cone;

  static std::vector<Cone> cones_of(const ConvexSet& set, const std::string& name, const std::string& method);
  static Constraint unscaled(const Cone& cone);
  static Constraint scaled(const Cone& cone);

  bool holds(const Vector& y);
  void make_start_feasible();

  /// w = J y + j in w_, Jᵀw in Jw_; returns |w|.
  double residual(const Constraint& constraint, const double* y);

  int variables_ = 0;
  std::vector<Constraint> constraints_;
  Vector start_;
  Vector w_;
  Vector Jw_;
};

}  // namespace raygauge
