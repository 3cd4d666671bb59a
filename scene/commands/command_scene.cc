// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/commands/command_scene.h"

#include <omp.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "cli/console/exit_status.h"
#include "cli/console/input_options.h"
#include "cli/console/interrupt.h"
#include "cli/console/rank_job.h"
#include "cli/output/json_text.h"
#include "cli/output/progress.h"
#include "cli/output/terminal.h"
#include "raygauge/exceptions.h"
#include "raygauge/scene/scene_run.h"
#include "results/run/output_place.h"
#include "results/run/shards.h"
#include "results/text/language.h"
#include "results/text/words.h"
#include "scene/commands/plan_motion.h"
#include "scene/commands/scene_input.h"
#include "scene/commands/scene_text.h"
#include "scene/file/scene_writer.h"

namespace raygauge::cli {
namespace {

struct SceneArguments : RunArguments {
  std::optional<Shard> shard;
  bool json = false;
  bool plan = false;  ///< of a path, before the queries are answered
  PlanOptions planning;
};

std::string resume_command(const SceneArguments& arguments, const std::string& output) {
  std::string command = command_line_of("run", arguments.input, output);
  if (arguments.shard) {
    command +=
        " --shard " + std::to_string(arguments.shard->index) + "/" + std::to_string(arguments.shard->count);
  }
  return command + " --resume";
}

void print_end(const SceneFile& file, const SceneSummary& summary, const std::string& path) {
  std::printf("%s: %llu cells in %s on %d %s; %zu records\n", language::printable(file.name).c_str(),
              static_cast<unsigned long long>(summary.cells_done),
              duration_text(summary.wall_seconds).c_str(), summary.threads,
              summary.threads == 1 ? "thread" : "threads", file.records.size());
  std::fputs(tally_text(file).c_str(), stdout);
  std::fputs(event_text(file).c_str(), stdout);
  print_place(path);
}

/// The processes that work on a scene: this one alone, or the ranks of a job.
class SceneJob {
 public:
  SceneJob(const SceneArguments& arguments, std::unique_ptr<Ranks> ranks)
      : arguments_(arguments), ranks_(std::move(ranks)) {}

  int run() {
    together([this] {
      source_ = source_of(arguments_.input);
      if (source_.dynamics)
        throw InvalidParameterError(
            arguments_.input.path +
            ": [dynamics] is for `raygauge scene simulate`, which answers the queries too");
      if (arguments_.plan) moved_ = plan_motion(source_, arguments_.planning);
      plan_ = plan_scene(source_.scene);
    });
    if (moved_ && !moved_->path.found()) return say_no_path();
    open();
    if (moved_) store_path();
    if (writer_ && !arguments_.quiet) print_notes(source_.notes);
    const InterruptGuard guard(
        arguments_.quiet || !writer_ ? nullptr : "\ninterrupted: storing the cells that are done\n");
    ProgressDisplay display(stderr, done_.size());
    SceneSummary summary;
    together([&] { summary = work(display); });
    display.clear();
    return writer_ ? finish(summary) : kAnswered;
  }

 private:
  int say_no_path() const {
    std::fprintf(stderr,
                 "raygauge: no path was found within %s; give --time-limit more, or another --planner\n",
                 duration_text(source_.plan->request.time_limit).c_str());
    return kLimitReached;
  }

  void store_path() const {
    const std::string path = std::filesystem::path(path_).replace_extension(".path.csv").string();
    const OutputPlace place =
        output_place({path, OutputKind::text, {".csv"}, {arguments_.input.path}, arguments_.force});
    write_output(place, moved_->csv);
    if (arguments_.quiet) return;
    std::printf("path: %s\n  trajectory %s\n", moved_->summary.c_str(), language::printable(path).c_str());
  }

  void together(const std::function<void()>& work) {
    if (ranks_) return all_or_none(*ranks_, work);
    work();
  }

  /// The process with the lock opens the run; the others learn what is done and which sessions are theirs.
  void open() {
    const int asked = arguments_.threads;
    std::vector<MachineInfo> machines = {machine_info()};
    duties_ = {RankDuty{asked > 0 ? asked : omp_get_num_procs(), 1, {}, false}};
    if (ranks_) {
      RankMachines all = gather_machines(*ranks_);
      duties_ = rank_duties(all.places, asked, false);
      machines = std::move(all.machines);
    }
    std::string orders;
    together([&] {
      head_ = head_of(source_, plan_);
      path_ = arguments_.output.empty() ? "out/" + source_.scene.name + ".h5" : arguments_.output;
      target_ = path_;
      if (arguments_.shard) path_ = shard_path(path_, *arguments_.shard).string();
      if (!ranks_ || ranks_->rank() == 0) orders = open_writer(machines);
    });
    if (ranks_) {
      orders = ranks_->broadcast(orders);
      duties_ = duties_from_text(ranks_->broadcast(to_text(duties_)));
    }
    std::istringstream in(orders);
    in >> session_;
    for (std::uint64_t cell = 0; in >> cell;) done_.insert(cell);
    if (ranks_ && !writer_) sink_.emplace(path_, head_, session_ + ranks_->rank());
  }

  std::string open_writer(const std::vector<MachineInfo>& machines) {
    output_place({path_, OutputKind::results, {".h5", ".hdf5"}, {arguments_.input.path}, arguments_.force});
    for (std::size_t i = 0; i < machines.size(); ++i) {
      head_.sessions.push_back(describe_session(Experiment(), duties_[i].threads, {}));
      head_.sessions.back().machine = machines[i];
      head_.sessions.back().rank = static_cast<int>(i);
    }
    RunMode mode = arguments_.force ? RunMode::force : RunMode::create;
    if (arguments_.resume) mode = RunMode::resume;
    writer_.emplace(path_, head_, mode);
    if (ranks_) writer_->begin();
    std::string orders = std::to_string(writer_->session());
    for (const std::uint64_t cell : writer_->done()) orders += " " + std::to_string(cell);
    return orders;
  }

  SceneSummary work(ProgressDisplay& display) {
    SceneHooks hooks;
    const pid_t parent = ::getppid();  // another one, once mpirun or the daemon that started us has died
    const auto orphaned = [this, parent] { return ranks_ && ::getppid() != parent; };
    hooks.stop = [orphaned] { return InterruptGuard::signal() != 0 || orphaned(); };
    hooks.progress = [&](const SceneProgress& progress) {
      if (arguments_.quiet || !writer_) return;
      display.show({progress.cells_done, progress.cells_total, progress.seconds, progress.seconds_left});
    };
    std::optional<RankCounter> counter;
    if (ranks_) {
      counter.emplace(*ranks_);
      hooks.next = [&counter] { return counter->next(); };
    }
    std::set<std::uint64_t> skipped = done_;
    if (arguments_.shard) {
      const auto count = static_cast<std::uint64_t>(arguments_.shard->count);
      for (std::uint64_t cell = 0; cell < plan_.cells.size(); ++cell) {
        if (cell % count != static_cast<std::uint64_t>(arguments_.shard->index) - 1) skipped.insert(cell);
      }
    }
    SceneSink& sink = writer_ ? static_cast<SceneSink&>(*writer_) : *sink_;
    const int threads = duties_.at(ranks_ ? static_cast<std::size_t>(ranks_->rank()) : 0).threads;
    SceneSummary summary;
    try {
      summary = run_scene(source_.scene, plan_, threads, skipped, sink, hooks);
    } catch (...) {
      if (counter) counter->abandon();
      throw;
    }
    if (orphaned()) ::_exit(kInterrupted);  // nobody is left to meet
    left_ = plan_.cells.size() - skipped.size();
    return summary;
  }

  int finish(SceneSummary summary) {
    if (ranks_) {  // it counts its own cells alone
      const std::uint64_t stored = read_scene_file(path_).cells.size();
      summary.cells_done = stored - std::min<std::uint64_t>(stored, done_.size());
      summary.stopped = summary.cells_done < left_;
      summary.threads = 0;
      for (const RankDuty& duty : duties_) summary.threads += duty.threads;
    }
    if (summary.stopped) {
      std::fprintf(stderr, "interrupted: %zu of %zu cells are safe; continue with\n  %s\n",
                   done_.size() + static_cast<std::size_t>(summary.cells_done), plan_.cells.size(),
                   resume_command(arguments_, target_).c_str());
      return interrupted_status();
    }
    writer_->finish();
    if (!arguments_.quiet) print_end(writer_->results(), summary, path_);
    return kAnswered;
  }

  const SceneArguments& arguments_;
  std::unique_ptr<Ranks> ranks_;  ///< null: one process
  SceneSource source_;
  ScenePlan plan_;
  std::optional<PlannedMotion> moved_;
  SceneFile head_;
  std::string target_;  ///< of the whole scene
  std::string path_;
  std::vector<RankDuty> duties_;
  std::int32_t session_ = 0;
  std::set<std::uint64_t> done_;
  std::uint64_t left_ = 0;
  std::optional<SceneWriter> writer_;  ///< of the process with the lock
  std::optional<SceneRankSink> sink_;  ///< of the others
};

int run_scene_file(const SceneArguments& arguments) {
  try {
    return SceneJob(arguments, arguments.plan ? nullptr : ranks_of_this_job()).run();
  } catch (const JobFailed&) {
    return kBadInput;
  }
}

int explain(const SceneArguments& arguments) {
  const SceneSource source = source_of(arguments.input);
  print_notes(source.notes);
  const ScenePlan plan = plan_scene(source.scene);
  Json json;
  json["scene"] = source.scene.name;
  json["bodies"] = source.scene.bodies.size();
  json["instants"] = source.scene.instants.size();
  json["cells"] = plan.cells.size();
  std::string text = language::printable(source.scene.name) + ": " +
                     counted(source.scene.bodies.size(), "body", "bodies") + ", " +
                     counted(source.scene.instants.size(), "instant") + ", " +
                     counted(plan.cells.size(), "cell") + " of work\n";
  if (source.dynamics) {
    text += "dynamics\n";
    for (const std::string& line : explain_dynamics(source.scene, *source.dynamics, source.accuracies)) {
      text += "  " + language::printable(line) + "\n";
      json["dynamics"].push_back(line);
    }
    for (const std::string& engine : source.engines) {
      if (engine == kOwnEngine) continue;
      text += "  engine " + engine + ": each step once; the least signed distance of its motion is proven\n";
      json["engines"].push_back(engine);
    }
  }
  for (std::size_t q = 0; q < source.scene.queries.size(); ++q) {
    const SceneQuery& asked = source.scene.queries[q];
    Json query;
    query["name"] = asked.name;
    query["effects"] = to_string(asked.effects);
    query["pairs"] = pairs_of(source.scene, asked).size();
    text += language::printable(asked.name) + " (" + to_string(asked.effects) + ")\n";
    for (const std::string& line : explain_query(source.scene, plan, static_cast<int>(q))) {
      text += "  " + language::printable(line) + "\n";
      query["plan"].push_back(line);
    }
    json["queries"].push_back(query);
  }
  std::fputs(arguments.json ? (json_text(json) + "\n").c_str() : text.c_str(), stdout);
  return kAnswered;
}

void add_plan_command(Command& scene, const std::shared_ptr<SceneArguments>& arguments, int& status) {
  Command plan = scene.add_subcommand(
      "plan", "Find a path for the robot of [plan], proven at every time, and answer the queries along it");
  add_source_options(plan, arguments->input);
  add_run_options(plan, *arguments);
  add_planning_options(plan, arguments->planning);
  plan.add_flag("--force", arguments->force, "Replace existing files");
  plan.callback([arguments, &status] {
    arguments->plan = true;
    status = run_scene_file(*arguments);
  });
}

}  // namespace

void add_scene_command(Command& app, int& status) {
  const auto arguments = std::make_shared<SceneArguments>();
  Command scene = app.add_subcommand("scene", "Bodies that move: answer what a scene file asks, with proof");
  scene.require_subcommand();
  Command run = scene.add_subcommand("run", "Answer every query of a scene and store the answers");
  add_source_options(run, arguments->input);
  add_run_options(run, *arguments);
  run.add_option_function(
         "--shard", [arguments](const std::string& text) { arguments->shard = shard_from(text); },
         "Do part I of K parts of the cells, into FILE.shard-I-of-K.h5; `raygauge merge` joins them")
      .type_name("I/K");
  const Option resume =
      run.add_flag("--resume", arguments->resume, "Continue a run that was killed or interrupted");
  run.add_flag("--force", arguments->force, "Replace an existing results file").excludes(resume);
  run.callback([arguments, &status] { status = run_scene_file(*arguments); });
  add_plan_command(scene, arguments, status);
  add_simulate_command(scene, status);
  add_collisions_command(scene, status);
  Command plan =
      scene.add_subcommand("explain", "Print what will be computed for which pairs, what never, and why");
  add_source_options(plan, arguments->input);
  plan.add_flag("--json", arguments->json, "Print one JSON object");
  plan.callback([arguments, &status] { status = explain(*arguments); });
}

}  // namespace raygauge::cli
