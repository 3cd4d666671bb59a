// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <malloc.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands/commands.h"
#include "cli/commands/dry_run.h"
#include "cli/commands/run_setup.h"
#include "cli/console/input_options.h"
#include "cli/console/interrupt.h"
#include "cli/input/experiment_file.h"
#include "cli/input/registries.h"
#include "cli/output/progress.h"
#include "cluster/ranks.h"
#include "engine/sweep/estimate.h"
#include "raygauge/exceptions.h"
#include "raygauge/sweep.h"
#include "results/text/words.h"

namespace raygauge::cli {
namespace {

/// Sweeps into the run's writer, with a bar if wanted. An error tells what is safe already.
SweepSummary sweep_into(const OpenRun& run, const RunArguments& arguments, const Experiment& experiment,
                        const GeneratorRegistry& generators, const MethodRegistry& methods) {
  ProgressDisplay display(stderr, run.done.whole().size());
  std::uint64_t cells_done = 0;
  SweepHooks hooks;
  hooks.stop = [] { return InterruptGuard::signal() != 0; };
  hooks.progress = [&](const SweepProgress& progress) {
    cells_done = progress.cells_done;
    if (!arguments.quiet) display.show(progress);
  };
  SweepShare share;
  if (arguments.shard) share.shard = *arguments.shard;
  try {
    return run_sweep(experiment, generators, methods, *run.writer, run.done, hooks, share);
  } catch (const Error& error) {
    const std::uint64_t stored = run.writer->done().size() + cells_done;
    if (stored == 0) throw;
    throw Error(std::string(error.what()) + " (" + counted(stored, "cell") + (stored == 1 ? " is" : " are") +
                " safe; --resume continues with the others)");
  }
}

int run_experiment(const RunArguments& arguments, const Experiment& experiment,
                   const GeneratorRegistry& generators, const MethodRegistry& methods) {
  const std::vector<Cell> grid = grid_of(experiment);
  OpenRun run =
      open_run(arguments, experiment, {session_of(experiment, sweep_threads(experiment, grid.size()))});
  SweepShare share;
  if (arguments.shard) share.shard = *arguments.shard;
  if (pieces_to_do(experiment, grid, run.done, share).empty()) return report_done(arguments, experiment, run);
  const InterruptGuard guard(arguments.quiet ? nullptr : kInterruptNotice);
  const SweepSummary sweep = sweep_into(run, arguments, experiment, generators, methods);
  run.writer->finish(sweep.calibration);
  return report_end(arguments, experiment, run, sweep);
}

void print_dry_run(const RunArguments& arguments, const Experiment& experiment,
                   const SweepEstimate& estimate) {
  std::string text = dry_run_text(experiment, estimate);
  if (arguments.ranks && arguments.times.empty()) {
    text += ranks_text(experiment, estimate.cell_seconds, *arguments.ranks, "the estimate");
  } else if (arguments.ranks) {
    const std::vector<double> seconds = measured_cell_seconds(experiment, arguments.times);
    text += ranks_text(experiment, seconds, *arguments.ranks, "the times in " + arguments.times);
  }
  std::fputs(text.c_str(), stdout);
}

/// Bytes that are allocated; 0 where the C library does not say.
double bytes_in_use() {
#ifdef __GLIBC__
  const auto in_use = ::mallinfo2();
  return static_cast<double>(in_use.uordblks) + static_cast<double>(in_use.hblkhd);
#else
  return 0;
#endif
}

void refuse_idle_options(const RunArguments& arguments) {
  if (arguments.ranks && !arguments.dry_run) {
    throw InvalidParameterError("--ranks is for --dry-run; ranks are started by mpirun -n K raygauge run …");
  }
  if (!arguments.times.empty() && !arguments.ranks) throw InvalidParameterError("--times needs --ranks");
}

int run(const RunArguments& arguments) {
  refuse_idle_options(arguments);
  if (const std::unique_ptr<Ranks> ranks = ranks_of_this_job()) return run_on_ranks(*ranks, arguments);
  const GeneratorRegistry generators = sweep_generators(arguments.experiment_path);
  const MethodRegistry methods = sweep_methods();
  Experiment experiment =
      read_experiment(arguments.experiment_path, arguments.overrides, generators, methods);
  if (arguments.threads) experiment.threads = *arguments.threads;
  if (arguments.dry_run) {
    constexpr double kProbing = 1.2;  // seconds
    print_dry_run(arguments, experiment,
                  estimate_sweep(experiment, generators, methods, kProbing, bytes_in_use));
    return kAnswered;
  }
  return run_experiment(arguments, experiment, generators, methods);
}

void add_experiment_options(Command& command, RunArguments& arguments) {
  command
      .add_option("experiment", arguments.experiment_path, "Experiment file (TOML; see docs/experiments.md)")
      .required()
      .type_name("EXPERIMENT.toml");
  command
      .add_option("-o,--output", arguments.output,
                  "Results file; default: out/NAME.h5, NAME being the experiment's")
      .type_name("FILE.h5");
  command
      .add_option("--set", arguments.overrides,
                  "Replace a value of the experiment, as in --set sweep.n=3,4; may be repeated")
      .type_name("KEY=VALUE")
      .default_str("")
      .expected(1)
      .take_all();
  command
      .add_option("--threads", arguments.threads,
                  "Threads; 0: one for each core; default: the experiment's run.threads")
      .range(0, 65536)
      .type_name("K");
  command
      .add_option("--stop-when-within", arguments.stop_when_within,
                  "End a cell once the 95 % interval of each method's median time is no wider than this "
                  "fraction of the median, as in 0.05; short for --set sweep.stop_when_within=FRACTION")
      .type_name("FRACTION");
  command
      .add_option_function(
          "--shard", [&arguments](const std::string& text) { arguments.shard = shard_from(text); },
          "Do part I of K parts of the cells, into FILE.shard-I-of-K.h5; `raygauge merge` joins them")
      .type_name("I/K");
}

void add_ways_to_run(Command& command, RunArguments& arguments) {
  const Option resume = command.add_flag("--resume", arguments.resume,
                                         "Continue a run that was killed, interrupted or has failed");
  command.add_flag("--force", arguments.force, "Replace an existing results file").excludes(resume);
  command.add_flag("--dry-run", arguments.dry_run,
                   "Print the grid and an estimate of the time; store nothing");
  command
      .add_option("--ranks", arguments.ranks,
                  "With --dry-run: predict the time and efficiency of so many MPI ranks or shards")
      .range(1, 10000000)
      .type_name("K");
  command
      .add_option("--times", arguments.times,
                  "With --ranks: the times of the cells from a finished run, not from an estimate")
      .type_name("FILE.h5");
  command.add_flag("-q,--quiet", arguments.quiet, "Print errors only");
}

}  // namespace

void add_run_command(Command& app, int& status) {
  const auto arguments = std::make_shared<RunArguments>();  // kept by the callback
  Command command = app.add_subcommand("run", "Run the sweep that an experiment file describes");
  add_experiment_options(command, *arguments);
  add_ways_to_run(command, *arguments);
  add_max_input_option(command);
  command.callback([arguments, &status] {
    if (arguments->stop_when_within) {
      const ParameterValue fraction = *arguments->stop_when_within;
      arguments->overrides.push_back("sweep.stop_when_within=" + to_string(fraction));
    }
    status = run(*arguments);
  });
}

}  // namespace raygauge::cli
