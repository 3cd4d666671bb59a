// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "raygauge/sweep.h"
#include "raygauge/sweep/experiment.h"
#include "raygauge/sweep/record.h"

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
  /// Set for an experiment that repeats adaptively: repetitions of the cells, and cells that used them all.
  struct Repetitions {
    int fewest = 0;
    int most = 0;
    std::size_t cells = 0;
    std::size_t cells_at_limit = 0;
  };
  std::optional<Repetitions> repetitions;
  std::vector<Method> methods;  ///< in the order of the experiment
};

RunSummary summarise(const Experiment& experiment, const std::vector<Record>& records);

/// Lines for people: agreement, failures by method, repetitions, slowdown.
std::string summary_text(const RunSummary& summary, const Calibration& calibration);

}  // namespace raygauge::cli
