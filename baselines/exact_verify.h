// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "baselines/exact_lp.h"

namespace raygauge {

/// Whether `result` proves the distance it claims, checked from the sets alone in exact rational arithmetic
/// and with none of the solver's code:
///
///     optimal, contains_origin   α, β >= 0, Σα = 1, Σα a = Σβ q, Σβ = value (primal), u·a <= -t over all of
///     A,
///                                -u·q <= 1 over all of Q, t = value (dual), and the status tells whether
///                                value = 0;
///     unreachable                u·a <= -t < 0 over all of A and -u·q <= 0 over all of Q;
///
/// and whether `rounded` are the doubles around the value. False for any other status: nothing is claimed.
/// Throws DimensionMismatchError where the sets differ in dimension.
bool verify(const PointSet& A, const PointSet& Q, const ExactLpResult& result);

}  // namespace raygauge
