// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// Points whose hull S is, one a column, for a polytope of R^2 or R^3; no column where none are known, or
/// where they would be more than 200000.
Eigen::MatrixXd known_points(const ConvexSet& S);

/// The simplices between the origin and the surface of the hull of points of R^n, n = 2 or 3: n points each,
/// one after the other, counterclockwise from outside. Empty for flat sets, and in R^3 without Qhull.
Eigen::MatrixXd surface_simplices(const Eigen::MatrixXd& points);

}  // namespace raygauge
