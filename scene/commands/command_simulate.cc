// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/commands/command_simulate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "cli/console/exit_status.h"
#include "cli/console/interrupt.h"
#include "cli/input/hull_note.h"
#include "cli/output/counted.h"
#include "cli/output/progress.h"
#include "cli/output/terminal.h"
#include "raygauge/exceptions.h"
#include "raygauge/scene/scene_run.h"
#include "results/provenance/provenance.h"
#include "results/run/output_place.h"
#include "results/text/language.h"
#include "scene/commands/scene_input.h"
#include "scene/file/scene_batch.h"
#include "scene/file/simulated_tables.h"
#include "scene/friction/loaded_friction.h"

namespace raygauge::cli {
namespace {

struct SimulateArguments {
  SceneInput input;
  std::string output;
  double step = 0;
  double tolerance = 0;
  bool force = false;
  bool quiet = false;
};

/// The cells of a scene, kept in memory.
class MemorySink final : public SceneSink {
 public:
  explicit MemorySink(SceneFile& file) : file_(file) {}
  void store(const SceneCellResult& cell) override {
    const std::scoped_lock lock(mutex_);
    append_cell(file_, cell, 0);
  }

 private:
  SceneFile& file_;
  std::mutex mutex_;
};

SceneSource source_to_simulate(const SimulateArguments& arguments) {
  SceneSource source = source_of(arguments.input);
  if (!source.dynamics)
    throw InvalidParameterError(arguments.input.path +
                                ": a scene without [dynamics]; `raygauge scene run` answers it");
  if (arguments.step > 0) source.dynamics->step = arguments.step;
  if (arguments.tolerance > 0) source.dynamics->tolerance = arguments.tolerance;
  check_dynamics(source.scene, *source.dynamics);
  return source;
}

void print_end(const SceneFile& file, bool contact, const std::string& path, double seconds) {
  const SimulationTables& tables = *file.simulation;
  double residual = 0, least = 0;
  std::size_t unproven = 0, cuts = 0, impacts = 0;
  for (const StepRow& row : tables.steps) {
    residual = std::max(residual, row.residual);
    unproven += std::isinf(row.least_distance) ? 1U : 0U;
    if (!std::isinf(row.least_distance)) least = std::min(least, row.least_distance);
    cuts += static_cast<std::size_t>(row.substeps - 1);
    impacts += static_cast<std::size_t>(row.impacts);
  }
  std::printf("%s: %s in %s; %s, %s, %s\n", language::printable(file.name).c_str(),
              counted(tables.steps.size(), "step").c_str(), duration_text(seconds).c_str(),
              counted(impacts, "impact").c_str(), counted(cuts, "cut").c_str(),
              counted(tables.contacts.size(), "contact").c_str());
  if (!contact) std::printf("  contact    not asked for: bodies pass through each other\n");
  if (contact) std::printf("  proven     no pair closer than %.3g at any time", least);
  if (unproven > 0) std::printf(", but for %s", counted(unproven, "step").c_str());
  if (contact) std::printf("\n");
  std::printf("  residual   %.2g at most\n  results    %s\n", residual, path.c_str());
  std::printf("  next       %s report %s -o %s.html\n", language::shell(program_invocation_name).c_str(),
              language::shell(path).c_str(), language::shell(path.substr(0, path.rfind(".h5"))).c_str());
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

SimulationHooks hooks_of(ProgressDisplay& display, bool quiet) {
  SimulationHooks hooks;
  hooks.stop = [] { return InterruptGuard::signal() != 0; };
  if (quiet) return hooks;
  hooks.progress = [&display, begin = std::chrono::steady_clock::now(), shown = 0.0](double share) mutable {
    constexpr std::uint64_t kParts = 1000;
    const double seconds = seconds_since(begin);
    if (seconds < shown + 1) return;
    shown = seconds;
    display.show({static_cast<std::uint64_t>(share * kParts), kParts, shown, shown * (1 - share) / share});
  };
  return hooks;
}

/// The simulation with the answers to the queries; nothing where it was interrupted.
std::optional<SceneFile> results_of(SceneSource& source, FrictionSolver* friction,
                                    const SimulationHooks& hooks) {
  Simulation simulation = simulate(source.scene, *source.dynamics, friction, hooks);
  if (simulation.stopped) return std::nullopt;
  source.scene = simulation.scene;
  const ScenePlan plan = plan_scene(source.scene);
  SceneFile file = head_of(source, plan);
  file.sessions.push_back(describe_session(Experiment(), 1, {}));
  file.simulation = tables_of(simulation);
  MemorySink sink(file);
  SceneHooks query_hooks;
  query_hooks.stop = hooks.stop;
  if (run_scene(source.scene, plan, 1, {}, sink, query_hooks).stopped) return std::nullopt;
  file.sessions.back().finished_at = utc_now();
  sort_scene(file);
  return file;
}

int simulate_file(const SimulateArguments& arguments) {
  SceneSource source = source_to_simulate(arguments);
  if (!arguments.quiet) print_notes(source.notes);
  const std::string path = arguments.output.empty() ? "out/" + source.scene.name + ".h5" : arguments.output;
  const OutputPlace place =
      output_place({path, OutputKind::results, {".h5", ".hdf5"}, {arguments.input.path}, arguments.force});
  if (std::filesystem::exists(place.path) && !(arguments.force && is_scene_file(place.path)))
    throw ResultsExistError(path + ": exists already; --force replaces results of a scene");
  const std::unique_ptr<FrictionSolver> friction =
      source.dynamics->has_friction() ? loaded_friction() : nullptr;
  const InterruptGuard guard(nullptr);
  ProgressDisplay display(stderr, 0);
  const auto begin = std::chrono::steady_clock::now();
  const auto file = results_of(source, friction.get(), hooks_of(display, arguments.quiet));
  display.clear();
  if (!file) {
    std::fprintf(stderr, "interrupted: nothing was written\n");
    return kInterrupted;
  }
  write_output(place, encode_scene(*file));
  if (!arguments.quiet) print_end(*file, source.dynamics->contact.has_value(), path, seconds_since(begin));
  return kAnswered;
}

}  // namespace

void add_simulate_command(Command& scene, int& status) {
  const auto arguments = std::make_shared<SimulateArguments>();
  Command command = scene.add_subcommand(
      "simulate", "Let the bodies of a scene react, and answer its queries of that motion");
  add_source_options(command, arguments->input);
  command
      .add_option("-o,--output", arguments->output,
                  "Results file; default: out/NAME.h5, NAME being the scene's")
      .type_name("FILE.h5");
  command.add_option("--step", arguments->step, "Longest step in time, in place of dynamics.step")
      .type_name("H");
  command
      .add_option("--tolerance", arguments->tolerance,
                  "How deep bodies may overlap, relative to the smallest one, in place of dynamics.tolerance")
      .type_name("D");
  command.add_flag("--force", arguments->force, "Replace an existing results file of a scene");
  command.add_flag("-q,--quiet", arguments->quiet, "Print errors only");
  command.callback([arguments, &status] { status = simulate_file(*arguments); });
}

}  // namespace raygauge::cli
