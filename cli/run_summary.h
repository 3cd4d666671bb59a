// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/sweep/experiment.h"
#include "engine/sweep/record.h"
#include "engine/sweep/sweep.h"

namespace raygauge::cli {

/// What a sweep has to say for itself when it ends: counts of what agreed and what failed, no statistics.
struct RunSummary {
  struct Method {
    std::string label;
    std::size_t records = 0;
    std::size_t disagreements = 0;
    std::size_t limits = 0;  ///< records that stopped at a limit instead of an answer
  };
  std::size_t records = 0;
  std::size_t disagreeing_instances = 0;
  std::vector<Method> methods;  ///< in the order of the experiment
};

RunSummary summarise(const Experiment& experiment, const std::vector<Record>& records);

/// Lines for people: agreement, failures by method, inflation.
std::string summary_text(const RunSummary& summary, const Calibration& calibration);

}  // namespace raygauge::cli
