// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cluster/slurm.h"

#include <filesystem>

#include "results/run/shards.h"

namespace raygauge {
namespace {

constexpr const char* kSafe = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789@%+=:,./_-";

std::string head(const SlurmJob& job, const std::string& suffix) {
  return "#!/bin/bash\n#SBATCH --job-name=" + job.name + suffix + "\n";
}

/// Started again this often at most: a cell that no time limit admits must not be tried for ever.
constexpr const char* kMostRestarts = "100";

}  // namespace

std::string quoted(const std::string& text) {
  if (!text.empty() && text.find_first_not_of(kSafe) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

std::string array_script(const SlurmJob& job) {
  const std::string count = std::to_string(job.shards);
  std::string script = head(job, "") + "#SBATCH --array=1-" + count + "\n" +
                       "#SBATCH --requeue\n#SBATCH --open-mode=append\n#SBATCH --signal=B:USR1@60\n" +
                       "#SBATCH --output=" + job.output + ".slurm-%A_%a.log\n";
  for (const std::string& option : job.sbatch_options) script += "#SBATCH " + option + "\n";
  std::string run = quoted(job.program) + " run " + quoted(job.experiment) + " -o " + quoted(job.output) +
                    " --shard \"$SLURM_ARRAY_TASK_ID/" + count +
                    "\" --resume --threads \"${SLURM_CPUS_PER_TASK:-1}\"";
  for (const std::string& option : job.run_options) run += " " + quoted(option);
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
    parts += " \\\n  " + quoted(shard_path(job.output, {i, job.shards}).string());
  }
  return head(job, "-merge") + "#SBATCH --output=" + job.output + ".slurm-merge-%j.log\n" + "exec " +
         quoted(job.program) + " merge -o " + quoted(job.output) + parts + "\n";
}

}  // namespace raygauge
