// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "raygauge/scene/placement.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// The moments of a body S of density 1 in R^2 or R^3,
///
///     V = ∫ dx,   c = ∫ x dx / V,   C = ∫ (x - c)(x - c)ᵀ dx,
///
/// V its volume, in the plane its area. Under x ↦ M x + t they become |det M| V, M c + t and |det M| M C Mᵀ.
struct Moments {
  double measure = 0;
  SmallVector center;
  SmallMatrix covariance;

  /// ∫ (|y|² 1 - y yᵀ) dx with y = x - c; in the plane its last entry alone, ∫ |y|² dx.
  Eigen::Matrix3d inertia() const;
};

/// The moments of S. Closed forms of balls, ellipsoids, p-norm balls, boxes, simplices, capsules, cylinders
/// and truncated cones, and affine images of all. Sums over the simplices of the hull for every set that is
/// the hull of known points, sums of such sets among them. Throws InvalidParameterError for other sets, for
/// sets without volume, for spaces of other dimensions, and for hulls in R^3 of a library without Qhull.
Moments moments_of(const ConvexSet& S);

/// Those of several parts together; where parts overlap, the common region counts twice. Throws as above.
Moments moments_of(const std::vector<std::shared_ptr<const ConvexSet>>& parts);

}  // namespace raygauge
