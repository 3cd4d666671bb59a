// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What does accuracy cost in planning? Every problem of a MotionBenchMaker set is planned by RRT-Connect with
// proven motions, and again with OMPL's check of motions at samples, finer and finer; every plan is then
// proven, or proven to collide.
#include <ompl/util/Console.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>

#include "bench/motionbench_plans.h"
#include "bench/motionbench_results.h"
#include "bench/program.h"
#include "engine/threads/team.h"
#include "results/text/language.h"

namespace raygauge::bench {
namespace {

namespace fs = std::filesystem;

struct Settings {
  std::string folder;
  int problems = 5;
  double time_limit = 10;
  int threads = 1;
  bool proven_only = false;
  bool processor_time = false;
  std::string csv = "motionbench.csv";
  std::string output;  ///< HDF5; resumed where it is there

  /// Shares of the default resolution at which OMPL checks motions; 0: proven.
  std::vector<double> resolutions() const {
    return proven_only ? std::vector<double>{0} : std::vector<double>{0, 1, 0.5, 0.25, 0.125};
  }
};

constexpr const char* kHeader =
    "environment,problem,validator,resolution,status,search_seconds,plan_seconds,configurations,length,proof,"
    "proof_seconds,contact_time,contact_depth,body_a,body_b\n";

std::string csv_of(const PlannedProblem& problem, const Plan& plan) {
  char numbers[200];
  std::string text = language::csv(problem.environment) + "," + problem.name + "," +
                     (plan.resolution == 0 ? "proven" : "discrete");
  std::snprintf(numbers, sizeof numbers, ",%g,%s,%.6g,%.6g,%zu,%.9g,%s,%.6g", plan.resolution,
                plan.solved ? "solved" : "unsolved", plan.search_seconds, plan.plan_seconds,
                plan.path.times.size(), plan.length(), plan.solved ? word_of(plan.proof.outcome) : "",
                plan.proof_seconds);
  text += numbers;
  std::snprintf(numbers, sizeof numbers, ",%.9g,%.6g,", plan.proof.time, plan.proof.depth);
  return text + numbers + language::csv(plan.body_a) + "," + language::csv(plan.body_b) + "\n";
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// What all problems of a session come to.
class Totals {
 public:
  void add(const PlannedProblem& problem) {
    const EdgeTimes& edges = problem.edges;
    free_.insert(free_.end(), edges.free.begin(), edges.free.end());
    contact_.insert(contact_.end(), edges.contact.begin(), edges.contact.end());
    undecided_ += edges.undecided;
    if (!problem.left_out.empty()) ++left_out_;
    for (const Plan& plan : problem.plans) plans_.push_back(plan);
  }

  bool all_proven() const {
    return std::all_of(plans_.begin(), plans_.end(), [](const Plan& plan) {
      return plan.resolution > 0 || !plan.solved || plan.proof.outcome == EdgeOutcome::free;
    });
  }

  void print(const std::vector<double>& resolutions) const {
    std::printf("%-12s %9s %14s %14s %14s %10s %10s %12s\n", "resolution", "solved", "search (ms)",
                "plan (ms)", "proof (ms)", "in contact", "undecided", "deepest (mm)");
    for (const double resolution : resolutions) print(resolution);
    std::printf(
        "edges of the proven searches: %zu free, median %.4f ms; %zu in contact, median %.4f ms; %lld "
        "undecided\n",
        free_.size(), 1e3 * median(free_), contact_.size(), 1e3 * median(contact_),
        static_cast<long long>(undecided_));
    std::printf("left out, for start or goal is not free: %d\n", left_out_);
  }

 private:
  void print(double resolution) const {
    std::vector<double> search, whole, proof;
    int all = 0, contacts = 0, undecided = 0;
    double deepest = 0;
    for (const Plan& plan : plans_) {
      if (plan.resolution != resolution) continue;
      ++all;
      if (!plan.solved) continue;
      search.push_back(plan.search_seconds);
      whole.push_back(plan.plan_seconds + plan.proof_seconds);
      proof.push_back(plan.proof_seconds);
      if (plan.collides()) ++contacts;
      if (plan.proof.outcome == EdgeOutcome::undecided) ++undecided;
      if (plan.proof.depth > deepest) deepest = plan.proof.depth;
    }
    char name[32] = "proven";
    if (resolution > 0) std::snprintf(name, sizeof name, "%g", resolution);
    std::printf("%-12s %4zu/%-4d %14.3f %14.3f %14.3f %10d %10d %12.3f\n", name, search.size(), all,
                1e3 * median(search), 1e3 * median(whole), 1e3 * median(proof), contacts, undecided,
                1e3 * deepest);
  }

  std::vector<double> free_, contact_;
  std::int64_t undecided_ = 0;
  int left_out_ = 0;
  std::vector<Plan> plans_;
};

/// A problem that is to be planned.
struct Task {
  std::size_t environment = 0;
  int problem = 0;
  fs::path request;
};

/// The tasks of a session: threads take them in turn, and what they find is written in the order of the
/// tasks, but for the HDF5 file, which takes each at once.
class Session {
 public:
  explicit Session(const Settings& settings)
      : settings_(settings),
        robot_(robot_of(settings.folder)),
        problems_(settings.folder),
        environments_(Problems::sorted(problems_.folder(), "")),
        csv_(settings.csv) {
    open_results();
    take_tasks();
    csv_ << kHeader;
  }

  void run() {
    done_.resize(tasks_.size());
    std::atomic<std::size_t> next{0};
    run_team(settings_.threads, {}, [&](int thread, int) {
      for (std::size_t k = next++; k < tasks_.size(); k = next++) {
        PlannedProblem planned =
            plan_problem(problem_of(robot_, tasks_[k].request), settings_.resolutions(), settings_.time_limit,
                         settings_.processor_time ? Clock::processor : Clock::wall);
        if (results_ && planned.left_out.empty())
          results_->store(tasks_[k].environment, tasks_[k].problem, thread, planned.plans);
        const std::scoped_lock lock(mutex_);
        done_[k] = std::move(planned);
        write_in_order();
      }
    });
    if (results_) results_->finish();
    totals_.print(settings_.resolutions());
    if (!csv_) throw InvalidParameterError("could not write " + settings_.csv);
    if (!totals_.all_proven()) throw Error("a plan of the proven search is not proven");
  }

 private:
  void open_results() {
    if (settings_.output.empty() || environments_.empty()) return;
    std::vector<std::string> names;
    for (const fs::path& environment : environments_) names.push_back(environment.filename().string());
    const Problem first = problem_of(robot_, Problems::sorted(environments_.front(), "request").front());
    results_ = std::make_unique<PlanResults>(settings_.output, names, settings_.resolutions(),
                                             settings_.problems, settings_.time_limit, settings_.threads,
                                             settings_.processor_time, static_cast<int>(first.start.size()),
                                             static_cast<int>(first.robot.bodies.size()));
  }

  void take_tasks() {
    for (std::size_t e = 0; e < environments_.size(); ++e) {
      std::vector<fs::path> requests = Problems::sorted(environments_[e], "request");
      requests.resize(std::min(requests.size(), static_cast<std::size_t>(settings_.problems)));
      for (std::size_t k = 0; k < requests.size(); ++k) {
        const auto problem = static_cast<int>(k);
        if (!results_ || !results_->has(e, problem)) tasks_.push_back({e, problem, requests[k]});
      }
    }
  }

  void write_in_order() {
    for (; written_ < done_.size() && done_[written_]; ++written_) {
      const PlannedProblem& problem = *done_[written_];
      if (!problem.left_out.empty())
        std::printf("left out: %s %s: %s\n", problem.environment.c_str(), problem.name.c_str(),
                    problem.left_out.c_str());
      for (const Plan& plan : problem.plans) csv_ << csv_of(problem, plan);
      csv_ << std::flush;
      totals_.add(problem);
      done_[written_]->plans.clear();
    }
  }

  const Settings& settings_;
  BenchRobot robot_;
  Problems problems_;
  std::vector<fs::path> environments_;
  std::unique_ptr<PlanResults> results_;
  std::ofstream csv_;
  std::vector<Task> tasks_;
  std::mutex mutex_;  ///< guards what follows
  std::vector<std::optional<PlannedProblem>> done_;
  std::size_t written_ = 0;
  Totals totals_;
};

void add_options(CLI::App& app, Settings& settings) {
  app.add_option("folder", settings.folder, "of a robot: URDF, SRDF, meshes/ and problems.tar.bz2")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_option("--problems", settings.problems, "of each environment")->check(CLI::PositiveNumber);
  app.add_option("--time-limit", settings.time_limit, "seconds for a search")->check(CLI::PositiveNumber);
  app.add_option("--threads", settings.threads, "problems at once; plans do not depend on it")
      ->check(CLI::Range(1, 1024));
  app.add_flag("--proven-only", settings.proven_only, "no plans whose motions are checked at samples");
  app.add_flag("--processor-time", settings.processor_time,
               "times and the limit are of the thread's processor time: for a machine that others use, too");
  app.add_option("--csv", settings.csv, "a line for each plan of this session");
  app.add_option(
      "-o,--output", settings.output,
      "also an HDF5 file for raygauge table, plot and export; problems that it has are not planned again");
}

void run(const Settings& settings) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  Session(settings).run();
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  return raygauge::bench::run_with_options("raygauge_motionbench",
                                           "Plans of MotionBenchMaker problems: proven, and at samples.",
                                           raygauge::bench::add_options, raygauge::bench::run, argc, argv);
}
