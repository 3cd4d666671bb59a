// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cluster/slurm.h"

#include <filesystem>

#include "results/run/shards.h"
#include "results/text/language.h"

namespace raygauge {
namespace {

/// A line of a batch script that holds an option of sbatch.
std::string option_line(const std::string& option) { return "#SBATCH " + language::sbatch(option) + "\n"; }

std::string head(const SlurmJob& job, const std::string& suffix) {
  return "#!/bin/bash\n" + option_line("--job-name=" + job.name + suffix);
}

/// The log beside the results file; a % of a path is none of the signs that Slurm replaces.
std::string log_line(const SlurmJob& job, const std::string& name) {
  std::string path;
  for (const char c : job.output) path += c == '%' ? std::string("%%") : std::string(1, c);
  return option_line("--output=" + path + name);
}

/// Started again this often at most: a cell that no time limit admits must not be tried for ever.
constexpr const char* kMostRestarts = "100";

}  // namespace

std::string array_script(const SlurmJob& job) {
  const std::string count = std::to_string(job.shards);
  std::string script = head(job, "") + "#SBATCH --array=1-" + count + "\n" +
                       "#SBATCH --requeue\n#SBATCH --open-mode=append\n#SBATCH --signal=B:USR1@60\n" +
                       log_line(job, ".slurm-%A_%a.log");
  for (const std::string& option : job.sbatch_options) script += option_line(option);
  std::string run = language::shell(job.program) + " run " + language::shell(job.experiment) + " -o " +
                    language::shell(job.output) + R"( --shard "$SLURM_ARRAY_TASK_ID/)" + count +
                    R"(" --resume --threads "${SLURM_CPUS_PER_TASK:-1}")";
  for (const std::string& option : job.run_options) run += " " + language::shell(option);
  return script + "time_is_up=\n" + run +
         " &\nrun=$!\n"
         "trap 'kill -TERM \"$run\"' TERM\n"
         "trap 'time_is_up=1; kill -TERM \"$run\"' USR1\n"
         "wait \"$run\"; status=$?\n"
         "while kill -0 \"$run\" 2>/dev/null; do wait \"$run\"; status=$?; done\n"
         "if [[ -n $time_is_up && $status -gt 128 && ${SLURM_RESTART_COUNT:-0} -lt " +
         std::string(kMostRestarts) +
         " ]]; then\n"
         "  scontrol requeue \"${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}\" && sleep 60\n"
         "fi\nexit \"$status\"\n";
}

std::string merge_script(const SlurmJob& job) {
  std::string parts;
  for (int i = 1; i <= job.shards; ++i) {
    parts += " \\\n  " + language::shell(shard_path(job.output, {i, job.shards}).string());
  }
  return head(job, "-merge") + log_line(job, ".slurm-merge-%j.log") + "exec " + language::shell(job.program) +
         " merge -o " + language::shell(job.output) + parts + "\n";
}

}  // namespace raygauge
