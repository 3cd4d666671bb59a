// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "raygauge/sweep/method.h"

namespace raygauge {

/// Adds `cgal`: distance, depth, growth and separation of two polytopes of R^3 (RigidBody: boxes and hulls)
/// in exact arithmetic, from the facets of the convex hull of all differences of their vertices. The vertices
/// are doubles: those of turned boxes are rounded.
void register_cgal_method(MethodRegistry& registry);

std::string cgal_library_version();

}  // namespace raygauge
