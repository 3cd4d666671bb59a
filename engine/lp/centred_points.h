// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/lp/shared_gram.h"
#include "engine/numerics/stopwatch.h"

namespace raygauge {

/// Whether positive weights prove that the origin lies in the interior of the hull of the points of R^n.
/// Those of the least Σ exp(v·p_j), λ_j = exp(v·p_j), leave a sum Σ λ_j p_j =: r that is zero but for
/// rounding; some Newton steps find them. If a direction u, |u| = 1, had u·p_j <= 0 for all j, then
///
///     uᵀ G u = Σ λ_j (u·p_j)²  <=  max |p_j| Σ λ_j |u·p_j|  =  -max |p_j| u·r  <=  max |p_j| |r|,
///
/// G = Σ λ_j p_j p_jᵀ, which a least eigenvalue of G above max |p_j| |r| excludes. That is proven by a
/// Cholesky factor of G - αI (S. M. Rump, Verification of positive definiteness, BIT 46, 2006). False says
/// nothing.
bool are_centred(const PricedPoints& points, int n, const Kernels& kernels, const Stopwatch& stopwatch);

}  // namespace raygauge
