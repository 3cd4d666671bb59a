// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace raygauge {

/// The processes that mpirun or srun has started together, and what a sweep asks of them. All calls but those
/// of the counters are collective: every rank makes them in the same order. Waiting takes no processor time,
/// so that ranks that are done do not disturb the times of those that are not. Failures of MPI end the job.
class Ranks {
 public:
  virtual ~Ranks() = default;

  virtual int rank() const = 0;
  virtual int count() const = 0;

  /// The text that rank 0 gives.
  virtual std::string broadcast(const std::string& text) = 0;

  /// At rank 0 every rank's text; elsewhere nothing.
  virtual std::vector<std::string> gather(const std::string& text) = 0;

  /// Returns when all ranks have called it.
  virtual void barrier() = 0;

  /// Adds to one of kCounters numbers that all ranks share, which begin at 0, and returns what it was before.
  /// From any thread.
  virtual std::uint64_t fetch_and_add(int counter, std::uint64_t summand) = 0;
  static constexpr int kCounters = 3;
};

/// The ranks of this job; null for a process that was started alone. MPI is loaded here and nowhere else, so
/// that a program without ranks starts as fast as one without MPI. Throws Error where several ranks were
/// started, but raygauge was built without MPI or its part raygauge_mpi.so is missing.
std::unique_ptr<Ranks> ranks_of_this_job();

}  // namespace raygauge
