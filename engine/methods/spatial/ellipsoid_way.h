// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "raygauge/numerics/vector3.h"

namespace raygauge {

/// The signed distance of a point x from {Σ z_i c_i : |z| <= 1}, for c_i at right angles: with a_i = |c_i|,
/// y_i = c_i·x/a_i and μ at most the least a_i², the ball about x inside the ellipsoid with the radius ρ,
///
///     ρ² = μ (1 - Σ y_i²/(a_i² - μ)),
///
/// is known by any μ > 0 (S-lemma). The best one is the root of  Σ q_i² = 1,  q_i = a_i y_i/(a_i² - μ):  then
/// Σ q_i c_i is the point of the surface that is the nearest to x, and μ < 0 where x is outside. In t = a² -
/// μ, a the least of the a_i, nothing is cancelled. An x in the plane across the shortest axis is taken as
/// one a hair beside it, where one of its two nearest points is a little nearer.
struct EllipsoidWay {
  [[gnu::always_inline]] inline EllipsoidWay(const Matrix3& axes, const Vector3& x) noexcept {
    constexpr double kHair = 1e-17, kClosed = 1e-13;
    constexpr int kMostSteps = 12;
    const Vector3* c = axes.column;
    const double along[3] = {dot(c[0], x), dot(c[1], x), dot(c[2], x)};
    for (int i = 0; i < 3; ++i) square[i] = dot(c[i], c[i]);
    least = std::min({square[0], square[1], square[2]});
    double p[3];
    for (int i = 0; i < 3; ++i) {
      p[i] = std::copysign(std::max(std::fabs(along[i]), kHair * least), along[i]);
      t = std::max(t, std::fabs(p[i]) - (square[i] - least));
    }
    // By Newton's method on (Σ q_i²)^(-1/2) = 1, which is almost linear, from the left (Moré & Sorensen).
    for (int step = 0;; ++step) {
      double sum = 0, slope = 0;
      for (int i = 0; i < 3; ++i) {
        const double inverse = 1 / (square[i] - least + t);
        q[i] = p[i] * inverse;
        sum += q[i] * q[i];
        slope += q[i] * q[i] * inverse;
      }
      root = std::sqrt(sum);
      if (!(root - 1 > kClosed && step < kMostSteps)) break;
      t += sum / slope * (root - 1);
    }
    double norm = 0;
    for (int i = 0; i < 3; ++i) {
      const double share = q[i] / square[i];
      outward = outward + c[i] * share;
      height += share * p[i];
      norm += share * q[i];
    }
    scale = 1 / std::sqrt(norm);
  }

  /// Signed: proven along outward × scale, of length 1; and by the ball, or by the nearest point.
  double lower() const noexcept { return (height - root) * scale; }
  double upper(const Matrix3& axes, const Vector3& x) const noexcept {
    const double mu = least - t;
    return mu > 0 && height <= 1 ? -std::sqrt(mu * (1 - height))
                                 : length(x - axes * Vector3{q[0], q[1], q[2]} * (1 / root));
  }

  double square[3], least = 0, t = 0, q[3], root = 1, height = 0, scale = 0;
  Vector3 outward;
};

}  // namespace raygauge
