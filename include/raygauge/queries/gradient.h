// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "raygauge/methods/result.h"

namespace raygauge {

// Gradients of d_Q(A) = max_u -h_A(u)/h_Q(-u) with respect to translations, from the normal u of a result,
// which is scaled to h_Q(-u) = 1 (the envelope theorem: only the direct dependence on the translation
// counts). Where the normal is not unique, as at two vertices, d has a kink and this is one of its
// subgradients. The normal is as accurate as the square root of the gap allows, so ask for a tolerance of
// 1e-10 or less. All of them throw InvalidParameterError unless the result has a normal and a finite distance
// above zero.

/// ∇_t d_Q(A + t) at t = 0: -u.
Vector gradient_moving_A(const DistanceResult& result);

/// ∇_t d_{Q+t}(A) at t = 0, Q moved against the origin that it is scaled about: d u.
Vector gradient_moving_Q(const DistanceResult& result);

}  // namespace raygauge
