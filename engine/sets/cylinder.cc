// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/truncated_cone.h"

#include "engine/sets/parameters.h"

namespace raygauge {

Cylinder::Cylinder(const ConstVectorRef& p, const ConstVectorRef& q, double radius)
    : Frustum("cylinder", p, checked_nonnegative("cylinder", "radius", radius), q, radius) {}

}  // namespace raygauge
