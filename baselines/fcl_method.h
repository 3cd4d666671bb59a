// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/method.h"

namespace raygauge {

/// Adds `fcl_libccd` and `fcl_indep`: the distance of two convex bodies of R^3 (RigidBody)
/// by FCL's narrow phase, as pair_component() has them. The tolerance of a request is handed to FCL.
void register_fcl_methods(MethodRegistry& registry);

}  // namespace raygauge
