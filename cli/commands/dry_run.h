// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/sweep/estimate.h"
#include "engine/sweep/experiment.h"

namespace raygauge::cli {

/// What `raygauge run --dry-run` prints: the grid, what runs on it, and the estimate.
std::string dry_run_text(const Experiment& experiment, const SweepEstimate& estimate);

}  // namespace raygauge::cli
