// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "results/run/run_writer.h"

namespace raygauge::bench {

/// A plan as a record has it.
struct PlanRecord {
  double resolution = 0;  ///< of the default of OMPL; 0: proven
  bool solved = false;
  bool collides = false;  ///< proven
  double seconds = 0;     ///< of the search and of shortening the path
  double length = 0;      ///< of the path, in the space of joints
};

/// Plans as a results file of a sweep, which `raygauge table`, `info`, `export` and `merge` read: a generator
/// is an environment, a repetition a problem, a method a validator of motions. n: joints, N: bodies of the
/// robot; `distance` is the length of the path; `agrees` is false for a plan that is proven to collide; a
/// search without a plan has the status time_limit.
class PlanResults {
 public:
  PlanResults(const std::string& path, const std::vector<std::string>& environments,
              const std::vector<double>& resolutions, int problems, double time_limit, int joints,
              int bodies);

  /// Whether an earlier session has stored the problem.
  bool has(std::size_t environment, int problem) const;

  /// All plans of one problem, durably.
  void store(std::size_t environment, int problem, const std::vector<PlanRecord>& plans);

  void finish() { run_->finish(); }

 private:
  Experiment experiment_;
  std::unique_ptr<RunWriter> run_;
  std::set<std::pair<std::uint64_t, int>> stored_;
};

}  // namespace raygauge::bench
