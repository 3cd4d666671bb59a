// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/sweep/estimate.h"
#include "raygauge/sweep/experiment.h"

namespace raygauge::cli {

/// What `raygauge run --dry-run` prints: the grid, what runs on it, and the estimate.
std::string dry_run_text(const Experiment& experiment, const SweepEstimate& estimate);

/// The lines that --ranks adds: how long so many ranks, of one thread each, take, and what limits them.
/// `cell_seconds` by cell, from `source`: "the estimate", or a file.
std::string ranks_text(const Experiment& experiment, const std::vector<double>& cell_seconds, int ranks,
                       const std::string& source);

/// What each cell of the grid has taken in a finished run of the experiment. Throws ResultsError where the
/// file is not finished, OtherExperimentError where it holds another grid.
std::vector<double> measured_cell_seconds(const Experiment& experiment, const std::string& path);

}  // namespace raygauge::cli
