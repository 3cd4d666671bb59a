// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/real.h"

namespace raygauge {

/// The positive definite matrix  M = H + λ  of the plane across a unit vector u, as C Cᵀ with a lower
/// triangular C in the coordinates of two tangents.
struct TangentMetric {
  TangentMetric(const Vector3& u, const Matrix3& H, double lambda);

  /// The same of two tangents t_k, orthogonal unit vectors, and h = (t_0·H t_0, t_0·H t_1, t_1·H t_1).
  TangentMetric(const Vector3& t0, const Vector3& t1, const double* h, double lambda);

  /// C⁻¹ g of a tangential vector g by its two coordinates; d is C⁻ᵀ y of a step of the program below.
  template <class Real>
  void image(const Real& g0, const Real& g1, Real* y) const {
    y[0] = g0 * inverse[0];
    y[1] = (g1 - y[0] * below) * inverse[1];
  }
  template <class Real>
  void step(const Real* y, Real* d) const {
    d[1] = y[1] * inverse[1];
    d[0] = (y[0] - d[1] * below) * inverse[0];
  }

  Vector3 tangent[2];
  double inverse[2] = {0, 0};  // of the diagonal of C
  double below = 0;            // that
  double trace = 0;

 private:
  void factorise(const double* h, double lambda);
};

/// A smooth piece of a support function near u: its height u·s and its slope, the image of s.
template <class Real>
struct ContactPiece {
  Real height{};
  Real slope[2] = {};
};

/// The step  min over y in R^2 of  max_l (h_l + g_l·y) + |y|²/2  and its multipliers: y = -Σ c_l g_l, c >= 0,
/// Σ c_l = 1, at most three of them positive.
template <class Real>
struct ContactStep {
  int count = 0;
  int piece[3] = {0, 0, 0};
  Real weight[3] = {};
  Real y[2] = {};
};

/// Which pieces are active is found in doubles, from heights relative to the greatest; the step of these is
/// computed in Real. `count` in 1 … kMostContactPieces.
inline constexpr int kMostContactPieces = 8;
template <class Real>
ContactStep<Real> contact_step(const ContactPiece<Real>* pieces, int count);

template <>
ContactStep<double> contact_step(const ContactPiece<double>* pieces, int count);
template <>
ContactStep<DoubleDouble> contact_step(const ContactPiece<DoubleDouble>* pieces, int count);

}  // namespace raygauge
