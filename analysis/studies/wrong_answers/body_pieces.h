// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// A convex body of R^n as every reader can have it: conv ∪_i {c_i + F_i z : |z| <= 1}. Its support function
/// is max_i (c_i·u + |F_i^T u|).
struct BodyPieces {
  Eigen::MatrixXd centers;               ///< c_i, one a column
  std::vector<Eigen::MatrixXd> factors;  ///< F_i, n × n; or one for all pieces

  /// h(u), evaluated as it stands there.
  double support(const Vector& u) const;
};

/// A point Σ w_i (c_i + F_i z) of a body: w >= 0, Σ w_i = 1, |z| <= 1.
struct PointOfPieces {
  Vector weights;
  Vector z;

  Vector in(const BodyPieces& body) const;
};

/// The pieces of a ball, box (its corners), capsule, cone, cylinder, truncated cone, ellipsoid, point set, or
/// of an affine image of one. Empty for other sets, and for boxes of more than 10 dimensions.
std::optional<BodyPieces> pieces_of(const ConvexSet& S);

/// The point of a body of pieces_of() near x: x itself where it is in the body; of a point set, where it is
/// strictly inside, or one of the points. Empty where x is not found to be inside; weights are clamped to
/// what a point of the body has.
std::optional<PointOfPieces> point_near(const ConvexSet& S, const Vector& x);

}  // namespace raygauge
