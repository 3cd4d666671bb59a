// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/numerics/threshold.h"

/// What was found by measurement for loops of kernels.
namespace raygauge::tuned {

/// Basis changes between two passes of the simplex: by shortlists of both sets, and by a tableau.
inline constinit const Threshold<int> kChangesByShortlist{8};
inline constinit const Threshold<int> kChangesByTableau{24};

/// In dimensions that have no fixed-size code, basis changes are dear: a column that promises less than this
/// share of what the pass's best one promised waits for the next pass.
inline constinit const Threshold<double> kColumnWorthEntering{0.4};

}  // namespace raygauge::tuned
