// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "raygauge/scene/placement.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

/// {scale x + shift : x in S}, scale > 0, of the same kind as S where that is possible.
std::shared_ptr<const ConvexSet> similar_set(const std::shared_ptr<const ConvexSet>& S, double scale,
                                             const SmallVector& shift);

/// A set S' ⊆ S with h_S(u) - h_S'(u) <= margin for every unit vector u: bodies whose S' are disjoint overlap
/// by the sum of their margins at most. A ball and a capsule lose `margin` of the radius, a box margin/√n at
/// every face, other sets are scaled about their centres. Throws InvalidParameterError where S is too small.
std::shared_ptr<const ConvexSet> shrunk_set(const std::shared_ptr<const ConvexSet>& S, double margin);

}  // namespace raygauge
