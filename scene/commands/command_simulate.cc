// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/console/exit_status.h"
#include "cli/console/interrupt.h"
#include "cli/input/hull_note.h"
#include "cli/output/progress.h"
#include "cli/output/terminal.h"
#include "raygauge/exceptions.h"
#include "raygauge/scene/scene_run.h"
#include "results/provenance/provenance.h"
#include "results/run/output_place.h"
#include "results/text/language.h"
#include "results/text/words.h"
#include "scene/commands/command_scene.h"
#include "scene/commands/scene_input.h"
#include "scene/commands/scene_text.h"
#include "scene/engines/loaded_engine.h"
#include "scene/file/scene_writer.h"
#include "scene/file/simulated_tables.h"
#include "scene/file/simulation_store.h"
#include "scene/friction/loaded_friction.h"
#include "scene/page/scene_drawing.h"

namespace raygauge::cli {
namespace {

struct SimulateArguments : RunArguments {
  std::string steps, tolerances, engines;
};

SceneInput input_of(const SimulateArguments& arguments) {
  SceneInput input = arguments.input;
  if (!arguments.steps.empty()) input.overrides.push_back("dynamics.step=" + arguments.steps);
  if (!arguments.tolerances.empty()) input.overrides.push_back("dynamics.tolerance=" + arguments.tolerances);
  if (!arguments.engines.empty()) input.overrides.push_back("dynamics.engine=" + arguments.engines);
  return input;
}

/// What is to be simulated: other engines take each step once, with the finest tolerance.
struct Wanted {
  std::string engine;
  SimulationAccuracy accuracy;
};

std::vector<Wanted> wanted_of(const SceneSource& source) {
  std::vector<Wanted> all;
  const double finest = source.accuracies.back().tolerance;
  for (const std::string& engine : source.engines) {
    for (const SimulationAccuracy& one : source.accuracies) {
      if (engine == kOwnEngine || one.tolerance == finest) all.push_back({engine, one});
    }
  }
  return all;
}

SceneSource source_to_simulate(const SimulateArguments& arguments) {
  SceneSource source = source_of(input_of(arguments));
  if (!source.dynamics)
    throw InvalidParameterError(arguments.input.path +
                                ": a scene without [dynamics]; `raygauge scene run` answers it");
  return source;
}

// Refuses what cannot begin, before an earlier file goes.
void check_start(const SceneSource& source, const std::string& path) {
  Dynamics dynamics = *source.dynamics;
  dynamics.tolerance = source.accuracies.back().tolerance;
  SimulationHooks hooks;
  hooks.stop = [] { return true; };
  try {
    simulate(source.scene, dynamics, nullptr, hooks);
    for (const std::string& engine : source.engines) {
      if (engine != kOwnEngine) EngineSteps(engine, source.scene, dynamics);
    }
  } catch (const InvalidParameterError& error) {
    throw InvalidParameterError(path + ": " + error.what());
  }
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// The simulations of a scene, one for each accuracy, and the answers to its queries of the finest one. All
/// that is done is stored on the way.
class SimulateJob {
 public:
  explicit SimulateJob(const SimulateArguments& arguments)
      : arguments_(arguments), source_(source_to_simulate(arguments)) {
    if (!arguments.quiet) print_notes(source_.notes);
    path_ = arguments.output.empty() ? "out/" + source_.scene.name + ".h5" : arguments.output;
    output_place({path_, OutputKind::results, {".h5", ".hdf5"}, {arguments.input.path}, arguments.force});
    check_start(source_, arguments.input.path);
    const bool own = source_.engines.back() == kOwnEngine;
    if (own && source_.dynamics->has_friction()) friction_ = loaded_friction();
    SceneFile head = head_of(source_, plan_scene(source_.scene));
    head.sessions.push_back(describe_session(Experiment(), threads_, {}));
    const RunMode usual = arguments.force ? RunMode::force : RunMode::create;
    const RunMode mode = arguments.resume ? RunMode::resume : usual;
    writer_.emplace(path_, head, mode);
    target_ = behind_links(path_);
    if (mode == RunMode::resume) finished_ = std::filesystem::exists(target_);
    if (mode == RunMode::force) writer_->make_room();
    store_.emplace(target_, head.identity);
  }

  int run() {
    const InterruptGuard guard(arguments_.quiet ? nullptr : "\ninterrupted: storing what is done\n");
    if (!finished_ && !(simulate_all() && answer())) return say_interrupted();
    writer_->finish();
    store_->clear();
    if (!arguments_.quiet) print_end();
    if (!ended_by_.empty()) throw Error(ended_by_);
    return kAnswered;
  }

 private:
  bool simulate_all() {
    ProgressDisplay display(stderr, 0, "part");
    SimulationTables tables;
    Scene moved;
    for (std::int32_t number = 0; number < static_cast<std::int32_t>(wanted_.size()); ++number) {
      const Wanted& wanted = wanted_[static_cast<std::size_t>(number)];
      Dynamics dynamics = *source_.dynamics;
      dynamics.step = wanted.accuracy.step;
      dynamics.tolerance = wanted.accuracy.tolerance;
      double seconds = 0;
      Simulation found = until_end(dynamics, wanted.engine, number, hooks_of(display, number), seconds);
      if (found.stopped) return false;
      moved_at_start_ = std::max(moved_at_start_, found.moved_at_start);
      add_simulation(found, dynamics, seconds, wanted.engine, tables);
      moved = std::move(found.scene);
      if (!ended_by_.empty()) break;
    }
    if (ended_by_.empty()) compare_with_finest(tables);
    source_.scene = std::move(moved);
    plan_ = plan_scene(source_.scene);
    writer_->set_simulated(std::move(tables), drawing_of(source_.scene), plan_.cells.size());
    return true;
  }

  // Or until it cannot go on: what is done by then is stored and answered as if it were all.
  Simulation until_end(const Dynamics& dynamics, const std::string& engine, std::int32_t number,
                       const SimulationHooks& hooks, double& seconds) {
    try {
      return simulate_one(dynamics, engine, number, hooks, seconds);
    } catch (const SimulationError& error) {
      if (error.done().steps.empty()) {
        store_->clear();
        throw;
      }
      ended_by_ = error.what();
      return error.done();
    }
  }

  // Steps of other engines are taken anew by a session that goes on.
  Simulation simulate_one(const Dynamics& dynamics, const std::string& engine, std::int32_t number,
                          SimulationHooks hooks, double& seconds) {
    if (engine != kOwnEngine) {
      EngineSteps steps(engine, source_.scene, dynamics);
      hooks.store = nullptr;
      hooks.advance = [&steps](double end, std::vector<BodyState>& bodies) { steps.advance(end, bodies); };
      Simulation found = simulate(source_.scene, dynamics, nullptr, hooks);
      seconds = steps.seconds();
      return found;
    }
    const auto begin = std::chrono::steady_clock::now();
    const std::vector<SimulationPart> before = store_->parts_of(number);
    Simulation found = simulate(source_.scene, dynamics, friction_.get(), hooks, before);
    seconds = store_->seconds_of(number) + seconds_since(begin);
    return found;
  }

  bool answer() {
    SceneHooks hooks;
    hooks.stop = [] { return InterruptGuard::signal() != 0; };
    return !run_scene(source_.scene, plan_, 1, writer_->done(), *writer_, hooks).stopped;
  }

  SimulationHooks hooks_of(ProgressDisplay& display, std::int32_t number) {
    SimulationHooks hooks;
    hooks.threads = threads_;
    hooks.stop = [] { return InterruptGuard::signal() != 0; };
    hooks.due = [this] { return store_->due(); };
    hooks.store = [this, number](const SimulationPart& part) { store_->store(number, part); };
    if (arguments_.quiet) return hooks;
    const auto count = static_cast<double>(wanted_.size());
    hooks.progress = [this, &display, number, count](double share) {
      constexpr std::uint64_t kParts = 100;
      const double seconds = seconds_since(begin_), done = (number + share) / count;
      if (seconds < shown_ + 1) return;
      shown_ = seconds;
      display.show({static_cast<std::uint64_t>(done * kParts), kParts, shown_, shown_ * (1 - done) / done});
    };
    return hooks;
  }

  int say_interrupted() const {
    std::fprintf(stderr, "interrupted: all steps that were done are safe; continue with\n  %s\n",
                 (command_line_of("simulate", input_of(arguments_), path_) + " --resume").c_str());
    return interrupted_status();
  }

  void print_end() const {
    const SceneFile& file = writer_->results();
    std::printf("%s: %s", language::printable(file.name).c_str(),
                simulations_text(*file.simulation, source_.dynamics->contact.has_value()).c_str());
    if (moved_at_start_ > 0)
      std::printf("  start      bodies moved apart by %.3g at most\n", moved_at_start_);
    print_place(path_);
  }

  const SimulateArguments& arguments_;
  int threads_ = arguments_.threads > 0 ? arguments_.threads : omp_get_num_procs();
  SceneSource source_;
  std::vector<Wanted> wanted_ = wanted_of(source_);
  std::string path_;
  std::filesystem::path target_;
  std::unique_ptr<FrictionSolver> friction_;
  std::optional<SceneWriter> writer_;
  std::optional<SimulationStore> store_;
  ScenePlan plan_;
  bool finished_ = false;  ///< before this session
  double moved_at_start_ = 0;
  std::string ended_by_;  ///< why a simulation could not go on
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double shown_ = 0;  ///< when progress was shown last
};

}  // namespace

void add_simulate_command(Command& scene, int& status) {
  const auto arguments = std::make_shared<SimulateArguments>();
  Command command = scene.add_subcommand(
      "simulate", "Let the bodies of a scene react, and answer its queries of that motion");
  add_source_options(command, arguments->input);
  add_run_options(command, *arguments);
  command
      .add_option(
          "--step", arguments->steps,
          "Longest step in time, in place of dynamics.step; of a list, as 1e-2,1e-3, a simulation each")
      .type_name("H");
  command
      .add_option("--tolerance", arguments->tolerances,
                  "How deep bodies may overlap, relative to the smallest one, in place of dynamics.tolerance")
      .type_name("D");
  command
      .add_option("--engine", arguments->engines,
                  "raygauge, bullet, ode, mujoco, or a list of them, in place of dynamics.engine; of other "
                  "engines' motions the least signed distance is proven")
      .type_name("NAME");
  const Option resume =
      command.add_flag("--resume", arguments->resume, "Continue a simulation that was killed or interrupted");
  command.add_flag("--force", arguments->force, "Replace an existing results file of a scene")
      .excludes(resume);
  command.callback([arguments, &status] { status = SimulateJob(*arguments).run(); });
}

}  // namespace raygauge::cli
