// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace raygauge {

using Vector = Eigen::VectorXd;
using ConstVectorRef = Eigen::Ref<const Eigen::VectorXd>;
using VectorRef = Eigen::Ref<Eigen::VectorXd>;

/// A nonempty compact convex set S in R^n, known through its support function and support mapping, equation
/// (6) of Zheng & Yamane:
///
///     h_S(u) = max_{x in S} u·x,      s_S(u) = a maximiser of u·x over S.
///
/// Assumptions stated here once, for every set: S is closed, bounded and nonempty; u need not be a unit
/// vector and may be zero (then h = 0 and any point of S is a maximiser); where several points maximise, any
/// one of them may be returned, but always the same one for the same u. Sets are immutable after construction
/// and may be shared between threads.
///
/// As the object A of a distance, no more is needed. As the gauge body Q, the origin should lie in the
/// interior of S; where it does not, the distance may be infinite (DistanceStatus::unreachable).
class ConvexSet {
 public:
  virtual ~ConvexSet() = default;
  ConvexSet(const ConvexSet&) = delete;
  ConvexSet& operator=(const ConvexSet&) = delete;

  /// n, the dimension of the space.
  int dimension() const noexcept { return dimension_; }

  /// h_S(u). Throws DimensionMismatchError or NonFiniteError.
  double support_function(const ConstVectorRef& u) const;

  /// s_S(u). Throws DimensionMismatchError or NonFiniteError.
  Vector support_mapping(const ConstVectorRef& u) const;

  /// A point deep inside S: the centre a_c of (7). It lies in S, and in the interior where S has one.
  Vector center() const;

  /// h_S(u), with s_S(u) written to `point`; both are arrays of dimension() doubles. The hot path: nothing is
  /// checked and nothing is allocated.
  double support_unchecked(const double* u, double* point) const { return do_support(u, point); }

  /// center() written to `point`, dimension() doubles; nothing is allocated.
  void center_unchecked(double* point) const { do_center(point); }

  /// Writes the sizes m_k of the numbers that coordinate k of a support point is computed from, dimension()
  /// doubles: for c + r u/|u| that is |c_k| + r, however small the sum of the two may be. It is the scale of
  /// rounding errors,
  ///
  ///     |computed h(u) - h(u)| <= rounding_error(n) Σ_k |u_k| m_k,
  ///     each coordinate of the computed s(u) within rounding_error(n) m_k of that of a point of S.
  void magnitude_unchecked(double* magnitude) const { do_magnitude(magnitude); }

  /// (2n + 8) rounding units: what a support function of R^n may lose, see magnitude_unchecked.
  static constexpr double rounding_error(int n) noexcept { return (2 * n + 8) * 0x1p-53; }

 protected:
  /// Throws InvalidParameterError unless dimension >= 1.
  explicit ConvexSet(int dimension);

 private:
  virtual double do_support(const double* u, double* point) const = 0;
  virtual void do_center(double* point) const = 0;

  /// By default max |x_k| over S, from 2n support queries, and that of the centre: right where nothing larger
  /// than the set itself cancels.
  virtual void do_magnitude(double* magnitude) const;

  int dimension_;
};

}  // namespace raygauge
