// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/method.h"

namespace raygauge {

/// Adds `libccd_gjk` (GJK, and EPA for depths) and `libccd_mpr` (portal refinement): whether two convex
/// bodies of R^3 (RigidBody) are separated, and their depth, by libccd called directly. It knows no distance.
void register_libccd_methods(MethodRegistry& registry);

}  // namespace raygauge
