// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/commands/run_setup.h"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "baselines/registry.h"
#include "cli/commands/commands.h"
#include "cli/console/interrupt.h"
#include "cli/output/run_summary.h"
#include "cli/output/terminal.h"
#include "engine/sweep/share.h"
#include "raygauge/exceptions.h"
#include "results/exceptions.h"
#include "results/run/identity.h"
#include "results/run/output_place.h"
#include "results/run/shards.h"
#include "results/run/stored_cells.h"
#include "results/text/language.h"
#include "results/text/words.h"

namespace raygauge::cli {
namespace {

std::string to_text(const Shard& shard) {
  return std::to_string(shard.index) + "/" + std::to_string(shard.count);
}

std::string program() { return language::shell(program_invocation_name); }

/// The command that continues this run. A run that has stored nothing yet is begun again, so that under
/// --force what it was to replace, and is still there, is not taken for its own.
std::string resume_command(const RunArguments& arguments, bool anything_stored) {
  std::string command = program() + " run " + language::shell(arguments.experiment_path);
  if (!arguments.output.empty()) command += " -o " + language::shell(arguments.output);
  for (const std::string& text : arguments.overrides) command += " --set " + language::shell(text);
  if (arguments.threads) command += " --threads " + std::to_string(*arguments.threads);
  if (arguments.shard) command += " --shard " + to_text(*arguments.shard);
  return command + (arguments.force && !anything_stored ? " --force" : " --resume");
}

RunMode run_mode(const RunArguments& arguments) {
  if (arguments.resume) return RunMode::resume;
  return arguments.force ? RunMode::force : RunMode::create;
}

/// The command that shows the results: Table III, or a row for each point of the grid.
std::string table_command(const Experiment& experiment, const std::string& path) {
  const std::string command = program() + " table " + language::shell(path);
  if (experiment.name == "example2") return command + " --paper table3";
  std::string rows = "n,N";
  if (experiment.generators.size() > 1) rows = "generator,generator_parameters," + rows;
  if (experiment.tolerance.size() > 1) rows += ",tolerance";
  return command + " --rows " + rows + " --cols method";
}

void print_end(const Experiment& experiment, const std::string& path, const SweepSummary& sweep,
               const std::vector<Record>& records) {
  const RunSummary summary = summarise(experiment, records);
  std::printf("%s: %s in %s on %s; %s\n", language::printable(experiment.name).c_str(),
              counted(sweep.cells_done, "cell").c_str(), duration_text(sweep.wall_seconds).c_str(),
              counted(sweep.threads, "thread").c_str(), counted(summary.records, "record").c_str());
  std::fputs(summary_text(summary, sweep.calibration).c_str(), stdout);
  std::printf("  results    %s\n  next       %s\n", path.c_str(), table_command(experiment, path).c_str());
}

/// The file of the whole run.
std::string target_path(const RunArguments& arguments, const Experiment& experiment) {
  return arguments.output.empty() ? "out/" + experiment.name + ".h5" : arguments.output;
}

bool is_there(const std::filesystem::path& path) {
  return std::filesystem::exists(path) || !list_parts(path).empty();
}

/// Other files of the run whose cells may be those that this process is to do: shards of the same count hold
/// other ones.
std::vector<std::filesystem::path> related_files(const RunArguments& arguments,
                                                 const std::filesystem::path& target) {
  std::vector<std::filesystem::path> files;
  if (arguments.shard && is_there(target)) files.push_back(target);
  for (const ShardFile& file : list_shards(target)) {
    const bool disjoint = arguments.shard && arguments.shard->count == file.shard.count;
    if (!disjoint && is_there(file.path)) files.push_back(file.path);
  }
  return files;
}

void refuse_related(const std::filesystem::path& file, bool resume) {
  if (is_being_written(file)) {
    throw RunLockedError(file.string() + ": another process is writing these cells");
  }
  if (!resume) {
    throw ResultsExistError(file.string() + ": holds cells of this run; --resume goes on with the others");
  }
}

/// One of more shards than there are cells; `merge` wants its file as well.
bool is_shard_without_cells(const RunArguments& arguments, const Experiment& experiment) {
  SweepShare share;
  if (arguments.shard) share.shard = *arguments.shard;
  return pieces_to_do(experiment, grid_of(experiment), {}, share).empty();
}

}  // namespace

std::string output_path(const RunArguments& arguments, const Experiment& experiment) {
  const std::string target = target_path(arguments, experiment);
  return arguments.shard ? shard_path(target, *arguments.shard).string() : target;
}

Session session_of(const Experiment& experiment, int threads) {
  std::vector<ComponentVersion> solvers;
  for (const auto& [name, version] : solver_versions()) solvers.push_back({name, version});
  return describe_session(experiment, threads, solvers);
}

OpenRun open_run(const RunArguments& arguments, const Experiment& experiment, std::vector<Session> sessions) {
  OpenRun run;
  run.path = output_path(arguments, experiment);
  output_place(
      {run.path, OutputKind::results, {".h5", ".hdf5"}, {arguments.experiment_path}, arguments.force});
  std::vector<ResultsFile> others;
  std::vector<std::filesystem::path> files;
  if (!arguments.force) files = related_files(arguments, target_path(arguments, experiment));
  for (const std::filesystem::path& file : files) {
    refuse_related(file, arguments.resume);
    others.push_back(read_results(file.string()));
  }
  run.writer = std::make_unique<RunWriter>(run.path, experiment, run_mode(arguments), std::move(sessions));
  std::vector<const std::vector<Record>*> records = {&run.writer->results().records};
  for (std::size_t i = 0; i < others.size(); ++i) {
    run.writer->require_same_experiment(others[i].provenance, files[i].string());
    if (!arguments.shard) run.writer->take_in(others[i]);
    records.push_back(&others[i].records);
  }
  run.done = done_repetitions(records, experiment_identity(experiment));
  return run;
}

int report_done(const RunArguments& arguments, const Experiment& experiment, OpenRun& run) {
  const bool no_cells = is_shard_without_cells(arguments, experiment);
  if (no_cells && (arguments.force || !std::filesystem::exists(run.path))) run.writer->begin();
  run.writer->finish();
  if (arguments.quiet) return kAnswered;
  const std::size_t cells = grid_of(experiment).size();
  const std::string all = cells == 1 ? "the only cell" : "all " + counted(cells, "cell");
  const std::string what = no_cells ? "this shard has no cells"
                                    : all + (arguments.shard ? " of this shard" : "") +
                                          (cells == 1 ? " is" : " are") + " done already";
  std::printf("%s: %s\n  results    %s\n  next       %s\n", language::printable(experiment.name).c_str(),
              what.c_str(), run.path.c_str(), table_command(experiment, run.path).c_str());
  return kAnswered;
}

int report_end(const RunArguments& arguments, const Experiment& experiment, const OpenRun& run,
               const SweepSummary& sweep) {
  if (!sweep.stopped) {
    if (!arguments.quiet) print_end(experiment, run.path, sweep, run.writer->results().records);
    return kAnswered;
  }
  const std::size_t stored = run.writer->results().cells().size();
  const std::string place = stored == 0 ? "done" : "in " + run.path;
  const std::size_t cells = grid_of(experiment).size();
  std::fprintf(stderr, "interrupted: %zu of %s %s %s; continue with\n  %s\n", stored,
               counted(cells, "cell").c_str(), cells == 1 ? "is" : "are", place.c_str(),
               resume_command(arguments, stored > 0).c_str());
  return interrupted_status();
}

}  // namespace raygauge::cli
