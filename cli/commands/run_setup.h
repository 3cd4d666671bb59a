// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/sweep/share.h"
#include "results/run/run_writer.h"

namespace raygauge {
class Ranks;
}

namespace raygauge::cli {

/// What `raygauge run` was asked.
struct RunArguments {
  std::string experiment_path;
  std::string output;
  std::vector<std::string> overrides;
  std::optional<int> threads;
  std::optional<double> stop_when_within;
  std::optional<Shard> shard;
  std::optional<int> ranks;  ///< of a dry run
  std::string times;         ///< file whose times a dry run takes; "" for an estimate
  bool resume = false;
  bool force = false;
  bool dry_run = false;
  bool quiet = false;
};

inline constexpr const char* kInterruptNotice =
    "\ninterrupted: finishing the solves in flight (once more: end at once)\n";

/// Where the results go: for a shard its own file, else what shards are merged into.
std::string output_path(const RunArguments& arguments, const Experiment& experiment);

/// This process's session, on `threads` threads.
Session session_of(const Experiment& experiment, int threads);

/// A run that is open for writing.
struct OpenRun {
  std::string path;
  std::unique_ptr<RunWriter> writer;
  DoneCells done;  ///< here, and in other files of the run
};

/// Opens the results file, and looks at other files of the same run: shards beside it, or what a shard is
/// beside. What they hold is not done again; a run of all cells takes it in. Throws what RunWriter throws,
/// and RunLockedError where another process does the same cells now.
OpenRun open_run(const RunArguments& arguments, const Experiment& experiment, std::vector<Session> sessions);

/// Prints how the run ended, or the command that continues it, and returns the exit status.
int report_end(const RunArguments& arguments, const Experiment& experiment, const OpenRun& run,
               const SweepSummary& sweep);

/// A run that has nothing to do.
int report_done(const RunArguments& arguments, const Experiment& experiment, OpenRun& run);

/// `raygauge run` as one of the MPI ranks of a job.
int run_on_ranks(Ranks& ranks, const RunArguments& arguments);

}  // namespace raygauge::cli
