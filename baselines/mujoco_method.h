// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "raygauge/sweep/method.h"

namespace raygauge {

/// Adds `mujoco`: whether two convex bodies of R^3 (RigidBody) are separated, and the deepest of the contacts
/// that MuJoCo finds, by closed forms and by libccd's portal refinement. It has no cones; it keeps vertices
/// of hulls in single precision.
void register_mujoco_method(MethodRegistry& registry);

std::string mujoco_library_version();

}  // namespace raygauge
