// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "raygauge/sweep/method.h"

namespace raygauge {

/// Adds `bullet`: the distance of two convex bodies of R^3 (RigidBody) by Bullet's pair
/// detector, GJK with the expanding polytope, in double precision, as pair_component() has them. Its
/// tolerances are fixed. Ellipsoids, which Bullet has none of, are a shape with a support function.
void register_bullet_method(MethodRegistry& registry);

std::string bullet_library_version();

}  // namespace raygauge
