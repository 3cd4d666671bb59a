// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// The most dimensions a scene may have: 2 and 3 for bodies that move, 6 for wrenches.
inline constexpr int kMostSceneDimensions = 6;

/// Vectors and matrices of at most six rows, which need no heap.
using SmallVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostSceneDimensions, 1>;
using SmallMatrix =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostSceneDimensions, kMostSceneDimensions>;

/// x ↦ R x + t: where a body stands, R its rotation and t the place of its origin.
struct Placement {
  SmallMatrix R;
  SmallVector t;
  double defect = kUnchecked;  ///< Pose::defect of a pose with this R and t, where one was made

  static constexpr double kUnchecked = -1;

  static Placement identity(int n);

  int dimension() const noexcept { return static_cast<int>(t.size()); }

  /// R u, and Rᵀ u.
  SmallVector turned(const SmallVector& u) const;
  SmallVector turned_back(const SmallVector& u) const;

  /// The placement that applies first `inner`, then this.
  Placement operator*(const Placement& inner) const;
};

/// The placement with this R and t, R replaced by nearest_rotation() and made orthonormal. Throws
/// DimensionMismatchError, NonFiniteError, or InvalidParameterError where nearest_rotation() does.
Placement make_placement(const Eigen::Ref<const Eigen::MatrixXd>& R, const ConstVectorRef& t);

/// The rotation of 3-space by |r| radians about r.
SmallMatrix rotation_about(const Eigen::Vector3d& r);

/// The rotation of the plane by `angle` radians.
SmallMatrix plane_rotation(double angle);

}  // namespace raygauge
