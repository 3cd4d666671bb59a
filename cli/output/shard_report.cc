// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/output/shard_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <map>
#include <utility>

#include "cli/input/experiment_file.h"
#include "cli/input/registries.h"
#include "cli/output/build_report.h"
#include "cli/output/terminal.h"
#include "results/disk/run_directory.h"
#include "results/run/results_file.h"
#include "results/run/shards.h"
#include "results/run/stored_cells.h"
#include "results/text/language.h"

namespace raygauge::cli {
namespace fs = std::filesystem;
namespace {

std::string name_of(ShardState state) {
  switch (state) {
    case ShardState::missing:
      return "missing";
    case ShardState::unfinished:
      return "unfinished";
    case ShardState::running:
      return "running";
    case ShardState::done:
      return "done";
  }
  return "";
}

std::uint64_t instances_of(const std::vector<CellPiece>& pieces) {
  std::uint64_t count = 0;
  for (const CellPiece& piece : pieces) count += static_cast<std::uint64_t>(piece.last - piece.first);
  return count;
}

ShardProgress progress_of(const Experiment& experiment, const fs::path& target, const Shard& shard) {
  ShardProgress progress;
  progress.shard = shard;
  progress.path = shard_path(target, shard);
  const std::vector<Cell> grid = grid_of(experiment);
  progress.instances = instances_of(pieces_of_shard(experiment, grid, {}, shard));
  const bool running = is_being_written(progress.path);
  DoneCells done;
  if (fs::exists(progress.path) || !list_parts(progress.path).sessions.empty()) {
    const ResultsFile results = read_results(progress.path.string());
    done = done_repetitions({&results.records}, results.provenance.identity);
    progress.state = ShardState::unfinished;
  }
  const std::uint64_t left = instances_of(pieces_of_shard(experiment, grid, done, shard));
  progress.instances_done = progress.instances - left;
  if (left == 0) progress.state = ShardState::done;
  if (running) progress.state = ShardState::running;
  return progress;
}

/// "1 3 4" of the shards that nobody works on and that are not done.
std::vector<int> idle(const std::vector<ShardProgress>& shards) {
  std::vector<int> numbers;
  for (const ShardProgress& shard : shards) {
    if (shard.state == ShardState::missing || shard.state == ShardState::unfinished) {
      numbers.push_back(shard.shard.index);
    }
  }
  return numbers;
}

/// Where Slurm did it, Slurm goes on: `submit` has left its scripts.
std::string completion_of(const fs::path& target, const std::vector<ShardProgress>& shards) {
  const std::string program = language::shell(program_invocation_name);
  const std::string count = std::to_string(shards.size());
  const std::vector<int> left = idle(shards);
  const fs::path array = target.string() + ".array.sbatch";
  const fs::path merge = target.string() + ".merge.sbatch";
  const std::string parts = language::shell((target.parent_path() / target.stem()).string()) +
                            ".shard-*-of-" + count + target.extension().string();
  if (!left.empty() && fs::exists(array) && fs::exists(merge)) {
    return fmt::format("sbatch -d afterany:$(sbatch --parsable --array={} {}) {}", fmt::join(left, ","),
                       language::shell(array.string()), language::shell(merge.string()));
  }
  std::string merging = fmt::format("{} merge -o {} {}", program, language::shell(target.string()), parts);
  if (left.empty()) return merging;
  return fmt::format("for i in {}; do {} run EXPERIMENT.toml -o {} --shard $i/{} --resume; done; {}",
                     fmt::join(left, " "), program, language::shell(target.string()), count, merging);
}

}  // namespace

std::optional<ShardReport> shard_report(const fs::path& target) {
  std::map<int, int> files;
  const std::vector<ShardFile> found = list_shards(target);
  for (const ShardFile& file : found) ++files[file.shard.count];
  if (files.empty()) return std::nullopt;
  const auto most = std::max_element(files.begin(), files.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  const auto readable = std::find_if(found.begin(), found.end(), [&](const ShardFile& file) {
    return file.shard.count == most->first &&
           (fs::exists(file.path) || !list_parts(file.path).sessions.empty());
  });
  if (readable == found.end()) return std::nullopt;  // begun, and nothing stored yet
  const std::string text = read_results(readable->path.string()).provenance.experiment_text;
  const Experiment experiment =
      experiment_from_text(text, readable->path.string(), sweep_generators(""), sweep_methods());
  ShardReport report;
  report.experiment = experiment.name;
  for (int i = 1; i <= most->first; ++i) {
    report.shards.push_back(progress_of(experiment, target, {i, most->first}));
  }
  report.completion = completion_of(target, report.shards);
  return report;
}

std::string shards_text(const ShardReport& report) {
  constexpr std::size_t kMostLines = 20;
  std::map<ShardState, int> states;
  std::string lines;
  std::size_t listed = 0;
  for (const ShardProgress& shard : report.shards) {
    ++states[shard.state];
    if (shard.state == ShardState::done || ++listed > kMostLines) continue;
    lines += labelled(
        fmt::format("  {}/{}", shard.shard.index, shard.shard.count),
        fmt::format("{}, {} of {} instances", name_of(shard.state), shard.instances_done, shard.instances));
  }
  if (listed > kMostLines) lines += labelled("  …", fmt::format("{} more", listed - kMostLines));
  std::string text;
  for (const auto& [state, count] : states) text += fmt::format(", {} {}", count, name_of(state));
  return labelled("shards", std::to_string(report.shards.size()) + ": " + text.substr(2)) + lines +
         labelled("complete", report.completion);
}

Json shards_json(const ShardReport& report) {
  Json shards = Json::array();
  for (const ShardProgress& shard : report.shards) {
    shards.push_back({{"shard", fmt::format("{}/{}", shard.shard.index, shard.shard.count)},
                      {"file", shard.path.string()},
                      {"state", name_of(shard.state)},
                      {"instances_done", shard.instances_done},
                      {"instances", shard.instances}});
  }
  return {{"shards", shards}, {"complete", report.completion}};
}

}  // namespace raygauge::cli
