// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/sets/truncated_cone.h"

#include "engine/sets/parameters.h"

namespace raygauge {

TruncatedCone::TruncatedCone(const ConstVectorRef& base, double base_radius, const ConstVectorRef& top,
                             double top_radius)
    : Frustum("truncated cone", base, checked_nonnegative("truncated cone", "base_radius", base_radius), top,
              checked_nonnegative("truncated cone", "top_radius", top_radius)) {}

}  // namespace raygauge
