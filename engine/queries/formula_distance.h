// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/sets/spatial_shape.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge {

/// The whole answer for two bodies of R^3 for which it is a formula (RoundPair), in a ball about the origin:
/// the distance, or the depth if it is asked for and they meet, and the gradient by pose. In one go, for what
/// takes less time than a pair to be placed: all calls are the last ones of their functions and have the same
/// arguments, which stay in registers. Where there is no formula, or what it finds is not as precise as the
/// ladder's options ask for, the answer is that of distance_by_search().
const ObjectDistance& distance_by_formula(Ladder& ladder, const Posed& A1, const Posed& A2,
                                          const ConvexSet& metric, ObjectEffects effects, WarmStart* warm);

/// By a formula where the ladder's options and the warm start leave it to one, or by search.
const ObjectDistance& distance_of_objects(Ladder& ladder, const Posed& A1, const Posed& A2,
                                          const ConvexSet& metric, ObjectEffects effects, WarmStart* warm);

/// The answer of the ladder.
const ObjectDistance& distance_by_search(Ladder& ladder, const Posed& A1, const Posed& A2,
                                         const ConvexSet& metric, ObjectEffects effects, WarmStart* warm);

}  // namespace raygauge
