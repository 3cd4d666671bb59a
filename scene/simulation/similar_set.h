// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raygauge/scene/motion.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// {scale x + shift : x in S}, scale > 0, of the same kind as S where that is possible.
std::shared_ptr<const ConvexSet> similar_set(const std::shared_ptr<const ConvexSet>& S, double scale,
                                             const SmallVector& shift);

}  // namespace raygauge
