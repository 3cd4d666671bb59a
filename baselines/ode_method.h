// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/method.h"

namespace raygauge {

/// Adds `ode`: whether two convex bodies of R^3 (RigidBody) are separated, and the deepest of the contacts
/// that the Open Dynamics Engine finds. It has no ellipsoids and no cones.
void register_ode_method(MethodRegistry& registry);

}  // namespace raygauge
