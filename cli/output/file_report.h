// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "cli/output/json_text.h"
#include "results/run/results_file.h"

namespace raygauge::cli {

/// What `raygauge info FILE.h5` tells of a results file: the experiment, how much of it is done, what was
/// varied, the outcomes counted, and the sessions that made it.
Json results_json(const std::string& path, const ResultsFile& results);
std::string results_text(const std::string& path, const ResultsFile& results);

}  // namespace raygauge::cli
