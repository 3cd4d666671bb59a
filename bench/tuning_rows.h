// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "bench/timed_medians.h"
#include "bench/tuned_threshold.h"
#include "bench/tuning_workloads.h"

namespace raygauge::bench {

/// A threshold, and what it is measured on.
struct TuningRow {
  TunedThreshold threshold;
  std::vector<double> values;  ///< beside the one that stands
  std::string on;              ///< the workload in words
  Workload workload;
  Clock clock = Clock::processor;
};

/// Those of a method, or of one of its jobs.
struct TunedMethod {
  std::string name;
  std::vector<TuningRow> rows;
};

/// Every threshold that stands in a tuning.h.
std::vector<TunedMethod> tuned_methods();

/// Those for bodies of R^2 and R^3.
std::vector<TunedMethod> tuned_methods_of_bodies();

}  // namespace raygauge::bench
