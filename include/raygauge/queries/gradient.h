// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "raygauge/methods/result.h"
#include "raygauge/numerics/vector3.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

// Gradients of d_Q(A) = max_u -h_A(u)/h_Q(-u) with respect to translations, from the normal u of a result,
// which is scaled to h_Q(-u) = 1 (the envelope theorem: only the direct dependence on the translation
// counts). Where the normal is not unique, as at two vertices, d has a kink and this is one of its
// subgradients. The normal is as accurate as the square root of the gap allows, so ask for a tolerance of
// 1e-10 or less. All of them throw InvalidParameterError unless the result has a normal and a finite distance
// above zero.

/// ∇_t d_Q(A + t) at t = 0: -u.
Vector gradient_moving_A(const DistanceResult& result);

/// ∇_t d_{Q+t}(A) at t = 0, Q moved against the origin that it is scaled about: d u.
Vector gradient_moving_Q(const DistanceResult& result);

/// The velocity of a body of R^2 or R^3 in the world, or a gradient with respect to it. A point x of the body
/// moves by
///
///     linear + angular × (x - o),      o where its pose takes the origin of its own frame
///
/// (Pose::translation(); the origin of the world without a pose). The axes are those of the world. In R^2
/// only linear.x, linear.y and angular.z count.
struct Twist {
  Vector3 linear, angular;
};

/// The derivative along a twist: the scalar product of the gradient and the twist.
inline double dot(const Twist& gradient, const Twist& twist) noexcept {
  return dot(gradient.linear, twist.linear) + dot(gradient.angular, twist.angular);
}

/// What is known of a derivative by pose.
enum class GradientKind : std::uint8_t {
  none,       ///< nothing: the value is not known, is 0 or infinite, or the space is not R^2 or R^3
  unique,     ///< the value is differentiable
  one_sided,  ///< it has a kink: PoseGradient::along() has its derivatives, one for each direction
  undecided,  ///< one of the gradients, if there are several: the metric is no ball, or bodies grow until
              ///< corners meet
};

/// The gradient of a distance, of minus a depth, or of a growth distance of two bodies with respect to the
/// twists of both. With n the gradient by a translation of A1 (ObjectDistance::gradient_1), and x1, x2 the
/// closest points or those in contact,
///
///     of A1: (n, (x1 - o1) × n),      of A2: -(n, (x2 - o2) × n)
///
/// by the envelope theorem. Where points or normals are not unique, as between parallel faces, the derivative
/// along a twist is the greatest over the normals of the least over the pairs of points (Danskin). Discs
/// count as polygons of 32 corners. Parallel means: to 1e-7.
struct PoseGradient {
  /// A pair of points with a normal; pairs with the same normal have the same number.
  struct Candidate {
    Twist body_1, body_2;
    int normal = 0;
  };

  GradientKind kind = GradientKind::none;
  Twist body_1, body_2;               ///< where `one_sided` or `undecided`: one of them
  std::vector<Candidate> candidates;  ///< of `one_sided`: the corners of all that are optimal

  /// lim (f(t) - f(0))/t for t > 0 to 0, where A1 and A2 move by these twists; NaN for `none` and
  /// `undecided`.
  double along(const Twist& twist_1, const Twist& twist_2) const noexcept;
};

}  // namespace raygauge
