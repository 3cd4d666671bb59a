// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "engine/numerics/aligned_buffer.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// Powers of two that bring a pair of point sets to magnitude 1 without rounding. With S_A = diag(factor_A)
/// and S_Q = diag(factor_Q) = 2^-shift S_A,
///
///     d_{S_Q Q}(S_A A) = 2^shift_d · d_Q(A),      shift_d as returned by distance_shift(),
///
/// because a common linear map leaves d unchanged and a scaling of one set scales d. Coordinates keep a
/// common factor unless their magnitudes in Q differ by more than 2^kRowSpread. Where no such factors scale
/// both sets without rounding (coordinates that span most of the range of doubles) the sets are left alone.
class Scaling {
 public:
  static constexpr int kRowSpread = 12;
  /// Sets whose magnitudes lie within 2^±kTolerated of 1 are left alone, and so can be used in place.
  static constexpr int kTolerated = 4;

  void compute(const PointSet& A, const PointSet& Q);

  /// One power of two for all coordinates of any two sets, which brings Q to magnitude 1, and another one
  /// for an A that would be much smaller than that: rounding errors of points of A must not be compared with
  /// those of Q.
  void compute_common(const ConvexSet& A, const ConvexSet& Q, double magnitude_A, double magnitude_Q);

  bool trivial_A() const noexcept { return trivial_A_; }
  bool trivial_Q() const noexcept { return trivial_Q_; }
  const double* factor_A() const noexcept { return factor_A_.data(); }
  const double* factor_Q() const noexcept { return factor_Q_.data(); }

  /// s with (scaled distance) = 2^s · d.
  int distance_shift() const noexcept { return distance_shift_; }

  /// factor · y_k, the component of a direction in the sets' own units. It must be the same direction for
  /// both sets, so nothing may be rounded: components too small for that are zero instead, for either set.
  static double direction_component(double factor, double y_k) noexcept {
    return std::fabs(y_k) < 0x1p-200 ? 0.0 : factor * y_k;
  }

 private:
  void leave_alone(int n);

  AlignedBuffer<double> factor_A_;
  AlignedBuffer<double> factor_Q_;
  AlignedBuffer<int> exponent_;
  int distance_shift_ = 0;
  bool trivial_A_ = true;
  bool trivial_Q_ = true;
};

}  // namespace raygauge
