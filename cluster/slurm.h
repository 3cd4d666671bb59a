// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace raygauge {

/// A sweep as a Slurm job array of shards, and the merge after it.
struct SlurmJob {
  std::string program;     ///< raygauge, absolute
  std::string experiment;  ///< path
  std::string output;      ///< results file
  std::string name;        ///< of the job
  int shards = 1;
  std::vector<std::string> run_options;     ///< words for `raygauge run`: --set …
  std::vector<std::string> sbatch_options;  ///< of the array: --time=…
};

/// The batch script of one task of the array: its shard, resumed where an earlier start left it. A minute
/// before the time limit Slurm signals it; it stores what is done and asks to be queued again. Throws
/// InvalidParameterError where a name, path or option cannot stand in a batch script (language::sbatch).
std::string array_script(const SlurmJob& job);

/// The batch script of the merge, for after the array.
std::string merge_script(const SlurmJob& job);

}  // namespace raygauge
