// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "raygauge/sweep/method.h"

namespace raygauge {

/// Adds `libsvm_smo`: the Euclidean distance of two point sets by LIBSVM's sequential minimal optimisation,
/// the dual of a support vector machine with linear kernel and hard margin,
///
///     minimize  ½ |Σ α_i a2_i - Σ β_j a1_j|² - Σ α_i - Σ β_j   subject to   Σ α_i = Σ β_j,  α, β >= 0,
///
/// whose margin 2/|w| is the distance. Q is a ball about the origin, A = A2 - A1 a MinkowskiDifference of
/// point sets, or one point set, whose distance from the origin is asked for. Parameters (docs/baselines.md
/// has the reasons):
///
///     eps        0     LIBSVM's tolerance of the optimality conditions; 0: that of the request
///     shrinking  false
///
/// Loading makes LIBSVM's sparse vectors; a solve is one call of svm_train. `lower` and `upper` are certified
/// by raygauge, from w by weak duality and from the combination of support vectors. LIBSVM has no time limit,
/// and where the hulls meet it goes on to its greatest number of iterations (10^7 at least).
void register_libsvm_methods(MethodRegistry& registry);

/// "3.24", of the library that is linked.
std::string libsvm_library_version();

}  // namespace raygauge
