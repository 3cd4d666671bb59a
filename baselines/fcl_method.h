// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/sweep/method.h"

namespace raygauge {

/// Adds `fcl_libccd` and `fcl_indep`: the Euclidean distance of convex bodies of R^3 by FCL's narrow phase. Q
/// is a ball about the origin and A = A2 - A1 a MinkowskiDifference of bodies that FCL has (FclBody::of), or
/// one such body, whose distance from the origin is asked for. Loading makes FCL's bodies, hulls with their
/// faces; a solve is one call, nearest points included. `distance` and `status` are FCL's claim: 0 and
/// contains_origin where it finds the bodies to meet. `lower` is certified by raygauge from the direction
/// between FCL's nearest points, 0 where that proves nothing; `upper` is NaN, for a point that FCL names need
/// not be in its body. The tolerance of a request is handed to FCL; it has no time limit.
void register_fcl_methods(MethodRegistry& registry);

}  // namespace raygauge
