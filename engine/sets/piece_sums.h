// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/sets/convex_set.h"

namespace raygauge {

/// The pieces of a sum, h_i + h_j for every pair, from those of its operands: `second` stands right behind
/// `first` in memory and enters with its gradients times `sign` (-1 for the reflected operand of a
/// difference). Either operand may have one piece only, or both two; otherwise, and beyond `capacity`, none
/// are offered (first.count = 0).
void add_pieces(SupportPieces& first, const SupportPieces& second, double sign, int capacity);

/// The radius of a ball in a sum of sets, from two balls around points that add up to c up to rounding;
/// 0 unless both are known. `part` is one of the two points.
double sum_of_radii(double first, double second, const double* c, const double* part, int n);

}  // namespace raygauge
