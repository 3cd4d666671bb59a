// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/sweep/pieces.h"
#include "results/run/results_file.h"

namespace raygauge {

/// The repetitions that the lists of records hold, of an experiment of that identity.
DoneCells done_repetitions(const std::vector<const std::vector<Record>*>& lists, const std::string& identity);

/// Adds the sessions and records of `more`; those to an empty file as they are. Of repetitions that both have
/// `results` keeps its own.
void append_results(ResultsFile& results, const ResultsFile& more);

}  // namespace raygauge
