// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/render/figures/figure.h"

namespace raygauge {

/// Figure 5 of the paper (`fig5`), A a truncated cone and Q an ellipsoid: (a) mean error, (b) mean time and
/// (c) mean N_rs against the tolerance, averages over all pairs; the paper's own error and N_rs in grey.
/// Throws FigureNeedsError without records of generator example1 in those roles at two or more tolerances.
Drawing figure5(const std::vector<Record>& records, const FigureOptions& options);

/// Figure 7 (`fig7`): the same with the roles swapped.
Drawing figure7(const std::vector<Record>& records, const FigureOptions& options);

}  // namespace raygauge
