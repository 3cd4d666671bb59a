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

 protected:
  /// Throws InvalidParameterError unless dimension >= 1.
  explicit ConvexSet(int dimension);

 private:
  virtual double do_support(const double* u, double* point) const = 0;
  virtual void do_center(double* point) const = 0;

  int dimension_;
};

}  // namespace raygauge
