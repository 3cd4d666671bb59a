// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/commands/rerun.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <utility>

#include "cli/console/interrupt.h"
#include "cli/input/experiment_file.h"
#include "cli/input/registries.h"
#include "raygauge/exceptions.h"
#include "results/disk/atomic_file.h"
#include "results/run/results_file.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace raygauge::cli {
namespace {

/// A folder of our own for the results, removed in the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "raygauge-rerun-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
      throw Error("no temporary folder can be made: " + system_reason(errno));
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// Runs a program to its end, its output in files. Returns its status as waitpid() gives it.
int run_program(std::vector<std::string> words, const std::string& out, const std::string& err) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  constexpr int kNewFile = O_WRONLY | O_CREAT | O_TRUNC;
  constexpr mode_t kOwner = 0600;
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), kNewFile, kOwner);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), kNewFile, kOwner);
  pid_t child = 0;
  const int failure = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) throw Error(words.front() + " cannot be started: " + system_reason(failure));
  int status = 0;
  while (waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) throw Error(words.front() + " cannot be waited for: " + system_reason(errno));
  }
  return status;
}

/// What the program said last before it failed, or else how it ended.
std::string reason_of(int status, std::string said) {
  while (!said.empty() && said.back() == '\n') said.pop_back();
  if (!said.empty()) return said.substr(said.rfind('\n') + 1);
  return WIFEXITED(status) ? "exit status " + std::to_string(WEXITSTATUS(status))
                           : "signal " + std::to_string(WTERMSIG(status));
}

/// One run of one program over one block of the grid.
ResultsFile run_block(const RerunPlan& plan, const std::string& program, const std::string& block,
                      const TemporaryFolder& folder) {
  const std::string results = folder.file("results.h5");
  const std::string out = folder.file("out.txt");
  const std::string err = folder.file("err.txt");
  std::vector<std::string> words = {program,   "run",    plan.experiment_path, "-o", results,
                                    "--quiet", "--force"};
  for (const std::string& text : plan.overrides) words.insert(words.end(), {"--set", text});
  if (const std::size_t space = block.find(' '); space != std::string::npos) {
    words.insert(words.end(), {"--set", block.substr(0, space), "--set", block.substr(space + 1)});
  }
  const int status = run_program(words, out, err);
  if (InterruptGuard::signal() != 0) throw Error("interrupted");
  if (status != 0) throw Error(program + " failed: " + reason_of(status, file_bytes(err)));
  ResultsFile file = read_results(results);
  std::filesystem::remove(results);
  return file;
}

/// The (n, N) of the grid as "sweep.n=3 sweep.N=200"; one block "" where --set cannot take them apart.
std::vector<std::string> blocks_of(const Experiment& experiment) {
  const bool own_axes = std::any_of(experiment.generators.begin(), experiment.generators.end(),
                                    [](const auto& each) { return !each.n.empty() || !each.N.empty(); });
  if (own_axes || experiment.grid != GridMode::cartesian) return {""};
  std::vector<std::string> blocks;
  for (const int n : experiment.n)
    for (const int N : experiment.N)
      blocks.push_back("sweep.n=" + std::to_string(n) + " sweep.N=" + std::to_string(N));
  return blocks;
}

void append(std::vector<Record>& records, std::vector<Record>&& more) {
  records.insert(records.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

RerunResult run_pairs(const RerunPlan& plan, bool quiet) {
  const Experiment experiment = read_experiment(plan.experiment_path, plan.overrides,
                                                sweep_generators(plan.experiment_path), sweep_methods());
  const std::vector<std::string> blocks = blocks_of(experiment);
  const TemporaryFolder folder;
  const InterruptGuard guard(nullptr);
  std::random_device random;
  RerunResult result;
  for (int k = 0; k < plan.pairs; ++k) {
    if (!quiet) std::fprintf(stderr, "pair %d of %d\n", k + 1, plan.pairs);
    result.base.emplace_back();
    result.fresh.emplace_back();
    for (const std::string& block : blocks) {
      const bool new_first = random() % 2 == 1;
      for (const bool is_new : {new_first, !new_first}) {
        ResultsFile file = run_block(plan, is_new ? plan.new_program : plan.base_program, block, folder);
        append((is_new ? result.fresh : result.base).back(), std::move(file.records));
        (is_new ? result.new_provenance : result.base_provenance) = std::move(file.provenance);
      }
    }
  }
  return result;
}

}  // namespace raygauge::cli
