// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/studies/compare/compare.h"
#include "results/provenance/provenance.h"

namespace raygauge::cli {

/// Two builds of this program, and what they are to run.
struct RerunPlan {
  std::string experiment_path;
  std::vector<std::string> overrides;  ///< as of `run --set`
  std::string base_program;
  std::string new_program;
  int pairs = 5;
};

/// The records of every pair of runs; provenances of the first.
struct RerunResult {
  Runs base;
  Runs fresh;
  Provenance base_provenance;
  Provenance new_provenance;
};

/// Runs both programs in turn, pair by pair and within a pair by (n, N) of the grid, so that a disturbance of
/// the machine meets both. Which of the two goes first is drawn at random each time: the test of the pairs
/// rests on that. Tells its progress on standard error unless `quiet`. Throws Error if a program fails, or
/// the user interrupts.
RerunResult run_pairs(const RerunPlan& plan, bool quiet);

}  // namespace raygauge::cli
