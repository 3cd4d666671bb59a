// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "python/bindings/arrays.h"
#include "raygauge/methods/result.h"
#include "raygauge/sets/pose.h"

namespace raygauge::python {

/// R and t of a homogeneous matrix of R^n, unchecked.
struct RigidParts {
  Eigen::MatrixXd rotation;
  Eigen::VectorXd translation;
};

/// Of a homogeneous matrix of (n+1)² numbers in C order, the last row being 0 ... 0 1. Throws
/// InvalidParameterError if it is another.
RigidParts parts_of_rows(const double* matrix, int n, const char* name);

/// The pose of such a matrix. Throws InvalidParameterError and what Pose throws.
Pose pose_of_rows(const double* matrix, int n, const char* name);

/// Warns, as Python does once a place, that a rotation was replaced by the nearest one.
void warn_of_replaced_rotation();

/// A pose for a query: none for None, else that of an array of shape (n+1, n+1). Throws
/// DimensionMismatchError for one of another n.
std::optional<Pose> as_pose(py::handle object, int n, const char* name);

/// The set in the pose, if there is one; both must outlive it.
inline Posed posed(const ConvexSet& set, const std::optional<Pose>& pose) {
  return pose ? Posed(set, *pose) : Posed(set);
}

/// What a caller keeps from query to query; nullptr for None.
WarmStart* as_warm_start(py::handle object);

}  // namespace raygauge::python
