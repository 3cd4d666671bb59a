// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <cerrno>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "baselines/registry.h"
#include "cli/commands/commands.h"
#include "cli/commands/dry_run.h"
#include "cli/input/experiment_file.h"
#include "cli/input/registries.h"
#include "cli/interrupt.h"
#include "cli/output/counted.h"
#include "cli/output/progress.h"
#include "cli/output/run_summary.h"
#include "cli/output/terminal.h"
#include "engine/exceptions.h"
#include "engine/sweep/estimate.h"
#include "engine/sweep/sweep.h"
#include "results/run/output_place.h"
#include "results/run/run_writer.h"

namespace raygauge::cli {
namespace {

constexpr const char* kInterruptNotice =
    "\ninterrupted: finishing the solves in flight (once more: end at once)\n";

struct RunArguments {
  std::string experiment_path;
  std::string output;
  std::vector<std::string> overrides;
  std::optional<int> threads;
  std::optional<double> stop_when_within;
  bool resume = false;
  bool force = false;
  bool dry_run = false;
  bool quiet = false;
};

std::string program() { return shell_word(program_invocation_name); }

/// The command that continues this run. A run that has stored nothing yet is begun again, so that under
/// --force what it was to replace, and is still there, is not taken for its own.
std::string resume_command(const RunArguments& arguments, bool anything_stored) {
  std::string command = program() + " run " + shell_word(arguments.experiment_path);
  if (!arguments.output.empty()) command += " -o " + shell_word(arguments.output);
  for (const std::string& text : arguments.overrides) command += " --set " + shell_word(text);
  if (arguments.threads) command += " --threads " + std::to_string(*arguments.threads);
  return command + (arguments.force && !anything_stored ? " --force" : " --resume");
}

std::string output_path(const RunArguments& arguments, const Experiment& experiment) {
  return arguments.output.empty() ? "out/" + experiment.name + ".h5" : arguments.output;
}

RunMode run_mode(const RunArguments& arguments) {
  if (arguments.resume) return RunMode::resume;
  return arguments.force ? RunMode::force : RunMode::create;
}

Session session_of(const Experiment& experiment, std::size_t cells) {
  std::vector<ComponentVersion> solvers;
  for (const auto& [name, version] : solver_versions()) solvers.push_back({name, version});
  return describe_session(experiment, sweep_threads(experiment, cells), solvers);
}

/// The command that shows the results: Table III, or a row for each point of the grid.
std::string table_command(const Experiment& experiment, const std::string& path) {
  const std::string command = program() + " table " + shell_word(path);
  if (experiment.name == "example2") return command + " --paper table3";
  std::string rows = "n,N";
  if (experiment.generators.size() > 1) rows = "generator,generator_parameters," + rows;
  if (experiment.tolerance.size() > 1) rows += ",tolerance";
  return command + " --rows " + rows + " --cols method";
}

void print_end(const Experiment& experiment, const std::string& path, const SweepSummary& sweep,
               const std::vector<Record>& records) {
  const RunSummary summary = summarise(experiment, records);
  const auto words = [](std::uint64_t count, const char* noun) {
    return counted(static_cast<std::int64_t>(count), noun);
  };
  std::printf("%s: %s in %s on %s; %s\n", experiment.name.c_str(), words(sweep.cells_done, "cell").c_str(),
              duration_text(sweep.wall_seconds).c_str(), counted(sweep.threads, "thread").c_str(),
              words(summary.records, "record").c_str());
  std::fputs(summary_text(summary, sweep.calibration).c_str(), stdout);
  std::printf("  results    %s\n  next       %s\n", path.c_str(), table_command(experiment, path).c_str());
}

/// Sweeps into `writer`, with a bar if wanted. An error tells what is safe already.
SweepSummary sweep_into(RunWriter& writer, const RunArguments& arguments, const Experiment& experiment,
                        const GeneratorRegistry& generators, const MethodRegistry& methods) {
  ProgressDisplay display(stderr, writer.done().size());
  std::uint64_t cells_done = 0;
  SweepHooks hooks;
  hooks.stop = [] { return InterruptGuard::signal() != 0; };
  hooks.progress = [&](const SweepProgress& progress) {
    cells_done = progress.cells_done;
    if (!arguments.quiet) display.show(progress);
  };
  try {
    return run_sweep(experiment, generators, methods, writer, writer.done(), hooks);
  } catch (const Error& error) {
    const std::uint64_t stored = writer.done().size() + cells_done;
    if (stored == 0) throw;
    throw Error(std::string(error.what()) + " (" + std::to_string(stored) +
                " cells are safe; --resume continues with the others)");
  }
}

int run_experiment(const RunArguments& arguments, const Experiment& experiment,
                   const GeneratorRegistry& generators, const MethodRegistry& methods) {
  const std::string path = output_path(arguments, experiment);
  output_place({path, OutputKind::results, {".h5", ".hdf5"}, {arguments.experiment_path}, arguments.force});
  const std::size_t cells = grid_of(experiment).size();
  RunWriter writer(path, experiment, run_mode(arguments), session_of(experiment, cells));
  if (writer.done().size() == cells) {
    writer.finish();
    if (!arguments.quiet) {
      std::printf("%s: all %zu cells are done already\n  results    %s\n  next       %s\n",
                  experiment.name.c_str(), cells, path.c_str(), table_command(experiment, path).c_str());
    }
    return kAnswered;
  }
  const InterruptGuard guard(arguments.quiet ? nullptr : kInterruptNotice);
  const SweepSummary sweep = sweep_into(writer, arguments, experiment, generators, methods);
  writer.finish(sweep.calibration);
  if (sweep.stopped) {
    const std::size_t stored = writer.done().size() + static_cast<std::size_t>(sweep.cells_done);
    const std::string place = stored == 0 ? "done" : "in " + path;
    std::fprintf(stderr, "interrupted: %zu of %zu cells are %s; continue with\n  %s\n", stored, cells,
                 place.c_str(), resume_command(arguments, stored > 0).c_str());
    return kInterrupted + InterruptGuard::signal() - SIGINT;
  }
  if (!arguments.quiet) print_end(experiment, path, sweep, writer.results().records);
  return kAnswered;
}

int run(const RunArguments& arguments) {
  const GeneratorRegistry generators = all_generators();
  const MethodRegistry methods = sweep_methods();
  Experiment experiment =
      read_experiment(arguments.experiment_path, arguments.overrides, generators, methods);
  if (arguments.threads) experiment.threads = *arguments.threads;
  if (arguments.dry_run) {
    const SweepEstimate estimate = estimate_sweep(experiment, generators, methods);
    std::fputs(dry_run_text(experiment, estimate).c_str(), stdout);
    return kAnswered;
  }
  return run_experiment(arguments, experiment, generators, methods);
}

}  // namespace

void add_run_command(CLI::App& app, int& status) {
  const auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand("run", "Run the sweep that an experiment file describes");
  command
      ->add_option("experiment", arguments->experiment_path,
                   "Experiment file (TOML; see docs/experiments.md)")
      ->required()
      ->type_name("EXPERIMENT.toml");
  command
      ->add_option("-o,--output", arguments->output,
                   "Results file; default: out/NAME.h5, NAME being the experiment's")
      ->type_name("FILE.h5");
  command
      ->add_option("--set", arguments->overrides,
                   "Replace a value of the experiment, as in --set sweep.n=3,4; may be repeated")
      ->type_name("KEY=VALUE")
      ->default_str("")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--threads", arguments->threads,
                   "Threads; 0: one for each core; default: the experiment's run.threads")
      ->check(CLI::Range(0, 65536))
      ->type_name("K");
  command
      ->add_option("--stop-when-within", arguments->stop_when_within,
                   "End a cell once the 95 % interval of each method's median time is no wider than this "
                   "fraction of the median, as in 0.05; short for --set sweep.stop_when_within=FRACTION")
      ->type_name("FRACTION");
  CLI::Option* resume = command->add_flag("--resume", arguments->resume,
                                          "Continue a run that was killed, interrupted or has failed");
  command->add_flag("--force", arguments->force, "Replace an existing results file")->excludes(resume);
  command->add_flag("--dry-run", arguments->dry_run,
                    "Print the grid and an estimate of the time; store nothing");
  command->add_flag("-q,--quiet", arguments->quiet, "Print errors only");
  command->callback([arguments, &status] {
    if (arguments->stop_when_within) {
      const ParameterValue fraction = *arguments->stop_when_within;
      arguments->overrides.push_back("sweep.stop_when_within=" + to_string(fraction));
    }
    status = run(*arguments);
  });
}

}  // namespace raygauge::cli
