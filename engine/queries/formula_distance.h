// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/round_pair.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge {

/// What is asked of a formula.
struct FormulaGoal {
  double radius = 1;  ///< of the ball about the origin that measures
  double tolerance = 0;
  ObjectEffects effects = ObjectEffects::none;
};

/// The whole answer by `round` for two bodies of R^3, where there is a formula: the distance, or the depth if
/// it is asked for and they meet, and the gradient by pose. In one go, for what takes less time than a pair
/// to be placed. False where there is no formula, or what it finds is not as precise as was asked for.
bool distance_by_formula(RoundPair& round, const Posed& A1, const Posed& A2, const FormulaGoal& goal,
                         WarmStart* warm, ObjectDistance& result);

}  // namespace raygauge
