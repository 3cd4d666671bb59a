// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bench/motionbench_plans.h"
#include "results/run/run_writer.h"

namespace raygauge::bench {

/// Plans as a results file of a sweep, which `raygauge table`, `plot`, `info`, `export` and `merge` read: a
/// generator is an environment, a repetition a problem, a method a validator of motions. n: joints, N: bodies
/// of the robot; `distance` is the length of the path; `agrees` is false for a plan that is proven to
/// collide; a search without a plan has the status time_limit.
///
/// The proof of each plan is a record of a method of its own, "proof of proven", "proof of samples 1", …, an
/// oracle: `seconds` of the proof; `upper` is how deep the plan is in contact, NaN where it is not or where
/// there is no plan; the status precision_limit says that it is undecided.
class PlanResults {
 public:
  PlanResults(const std::string& path, const std::vector<std::string>& environments,
              const std::vector<double>& resolutions, int problems, double time_limit, int threads,
              bool processor_time, int joints, int bodies);

  /// Whether an earlier session has stored the problem.
  bool has(std::size_t environment, int problem) const;

  /// All plans of one problem, planned by one of the threads, durably. Thread safe.
  void store(std::size_t environment, int problem, int thread, const std::vector<Plan>& plans);

  void finish() { run_->finish(); }

 private:
  Record record_of(std::size_t environment, int problem, std::size_t method) const;

  int threads_;
  Experiment experiment_;
  std::unique_ptr<RunWriter> run_;
  std::set<std::pair<std::uint64_t, int>> stored_;
};

}  // namespace raygauge::bench
