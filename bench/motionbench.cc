// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
// What does accuracy cost in planning? Every problem of a MotionBenchMaker set is planned by RRT-Connect with
// proven motions, and again with OMPL's check of motions at samples, finer and finer; every plan is then
// proven, or proven to collide.
#include <ompl/base/PlannerTerminationCondition.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "bench/motionbench_problems.h"
#include "bench/motionbench_results.h"
#include "bench/program.h"
#include "bench/timed_medians.h"
#include "raygauge/ompl.h"
#include "results/text/language.h"

namespace raygauge::bench {
namespace {

namespace fs = std::filesystem;
namespace ob = ompl::base;
namespace og = ompl::geometric;

struct Settings {
  std::string folder;
  int problems = 5;
  double time_limit = 10;
  std::string csv = "motionbench.csv";
  std::string output;  ///< HDF5; resumed where it is there
};

/// Shares of the default resolution at which OMPL checks motions; 0: proven.
constexpr double kResolutions[] = {0, 1, 0.5, 0.25, 0.125};

/// Times of edges, by outcome.
struct EdgeTimes {
  std::vector<double> free, contact;
  std::int64_t undecided = 0;
};

/// As ProvenMotionValidity, timed.
class TimedValidity final : public ob::MotionValidator {
 public:
  TimedValidity(const ob::SpaceInformationPtr& space, std::shared_ptr<EdgeCheckers> checkers,
                EdgeTimes& times)
      : MotionValidator(space), checkers_(std::move(checkers)), times_(times) {}

  bool checkMotion(const ob::State* s1, const ob::State* s2) const override {
    if (!si_->satisfiesBounds(s2)) return false;
    const int joints = checkers_->joints();
    EdgeOutcome outcome = EdgeOutcome::undecided;
    const double seconds = seconds_of([&] {
      outcome = checkers_->mine()
                    .edge(ompl_detail::values_of(s1, joints), ompl_detail::values_of(s2, joints))
                    .outcome;
    });
    if (outcome == EdgeOutcome::free) times_.free.push_back(seconds);
    if (outcome == EdgeOutcome::contact) times_.contact.push_back(seconds);
    if (outcome == EdgeOutcome::undecided) ++times_.undecided;
    return outcome == EdgeOutcome::free;
  }

  bool checkMotion(const ob::State* s1, const ob::State* s2,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(s1, s2)) return true;
    last_valid.second = 0;
    if (last_valid.first != nullptr) si_->copyState(last_valid.first, s1);
    return false;
  }

 private:
  std::shared_ptr<EdgeCheckers> checkers_;
  EdgeTimes& times_;
};

/// One plan of one problem, and its proof.
struct Row {
  std::string environment, problem, status = "unsolved";
  double resolution = 0;  ///< 0: proven
  double search_seconds = 0, plan_seconds = 0, proof_seconds = 0;
  JointTrajectory path;
  std::string proof;  ///< of the whole plan
  EdgeResult contact;
  std::string body_a, body_b;
};

ob::SpaceInformationPtr space_of(const Problem& problem, double resolution,
                                 const std::shared_ptr<EdgeCheckers>& checkers, EdgeTimes& times) {
  const auto joints = static_cast<unsigned>(problem.lower.size());
  const auto space = std::make_shared<ob::RealVectorStateSpace>(joints);
  ob::RealVectorBounds bounds(joints);
  bounds.low = problem.lower;
  bounds.high = problem.upper;
  space->setBounds(bounds);
  if (resolution > 0)
    space->setLongestValidSegmentFraction(space->getLongestValidSegmentFraction() * resolution);
  auto information = std::make_shared<ob::SpaceInformation>(space);
  information->setStateValidityChecker(std::make_shared<ProvenStateValidity>(information, checkers));
  if (resolution == 0)
    information->setMotionValidator(std::make_shared<TimedValidity>(information, checkers, times));
  information->setup();
  return information;
}

JointTrajectory trajectory_of(const og::PathGeometric& path, std::size_t joints) {
  JointTrajectory trajectory;
  trajectory.values.resize(static_cast<Eigen::Index>(joints),
                           static_cast<Eigen::Index>(path.getStateCount()));
  for (std::size_t k = 0; k < path.getStateCount(); ++k) {
    const auto values =
        ompl_detail::values_of(path.getState(static_cast<unsigned>(k)), static_cast<int>(joints));
    trajectory.times.push_back(static_cast<double>(k));
    for (std::size_t i = 0; i < joints; ++i)
      trajectory.values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = values[i];
  }
  return trajectory;
}

/// RRT-Connect, then shortened, with this resolution.
void plan(const Problem& problem, const Settings& settings, EdgeTimes& times, Row& row) {
  const auto checkers = std::make_shared<EdgeCheckers>(problem.robot, problem.obstacles);
  const ob::SpaceInformationPtr space = space_of(problem, row.resolution, checkers, times);
  const auto definition = std::make_shared<ob::ProblemDefinition>(space);
  ob::ScopedState<ob::RealVectorStateSpace> start(space), goal(space);
  std::copy(problem.start.begin(), problem.start.end(), start->values);
  std::copy(problem.goal.begin(), problem.goal.end(), goal->values);
  definition->setStartAndGoalStates(start, goal);
  og::RRTConnect planner(space);
  planner.setProblemDefinition(definition);
  planner.setup();
  bool solved = false;
  row.search_seconds = seconds_of([&] {
    solved = planner.solve(ob::timedPlannerTerminationCondition(settings.time_limit)) ==
             ob::PlannerStatus::EXACT_SOLUTION;
  });
  row.plan_seconds = row.search_seconds;
  if (!solved) return;
  row.status = "solved";
  og::PathGeometric path(static_cast<const og::PathGeometric&>(*definition->getSolutionPath()));
  row.plan_seconds += seconds_of([&] {
    og::PathSimplifier simplifier(space);
    simplifier.reduceVertices(path);
    simplifier.shortcutPath(path);
  });
  row.path = trajectory_of(path, problem.start.size());
}

/// By a checker that knows nothing of the search.
void prove(const Problem& problem, Row& row) {
  EdgeOptions options;
  options.witness = true;
  EdgeChecker checker(problem.robot, problem.obstacles, options);
  row.proof_seconds = seconds_of([&] { row.contact = checker.path(row.path); });
  const EdgeOutcome outcome = row.contact.outcome;
  row.proof =
      outcome == EdgeOutcome::free ? "free" : (outcome == EdgeOutcome::contact ? "contact" : "undecided");
  if (outcome == EdgeOutcome::free) return;
  row.body_a = checker.name(row.contact.body_a);
  row.body_b = checker.name(row.contact.body_b);
}

/// "" where start and goal are free; else what is wrong with them.
std::string wrong_end(const Problem& problem) {
  EdgeChecker checker(problem.robot, problem.obstacles);
  for (const bool is_start : {true, false}) {
    const std::vector<double>& q = is_start ? problem.start : problem.goal;
    const EdgeResult& result = checker.configuration(q);
    if (result.outcome == EdgeOutcome::free) continue;
    return std::string(is_start ? "start" : "goal") +
           (result.outcome == EdgeOutcome::contact ? " in contact" : " undecided") + ": " +
           checker.name(result.body_a) + " and " + checker.name(result.body_b);
  }
  return "";
}

double length_of(const JointTrajectory& path) {
  double length = 0;
  for (Eigen::Index k = 0; k + 1 < path.values.cols(); ++k)
    length += (path.values.col(k + 1) - path.values.col(k)).norm();
  return length;
}

constexpr const char* kHeader =
    "environment,problem,validator,resolution,status,search_seconds,plan_seconds,configurations,length,proof,"
    "proof_seconds,contact_time,contact_depth,body_a,body_b\n";

std::string csv_of(const Row& row) {
  char numbers[200];
  std::string text = language::csv(row.environment) + "," + row.problem + "," +
                     (row.resolution == 0 ? "proven" : "discrete");
  std::snprintf(numbers, sizeof numbers, ",%g,%s,%.6g,%.6g,%zu,%.6g,%s,%.6g", row.resolution,
                row.status.c_str(), row.search_seconds, row.plan_seconds, row.path.times.size(),
                length_of(row.path), row.proof.c_str(), row.proof_seconds);
  text += numbers;
  std::snprintf(numbers, sizeof numbers, ",%.9g,%.6g,", row.contact.time, row.contact.depth);
  return text + numbers + language::csv(row.body_a) + "," + language::csv(row.body_b) + "\n";
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

void print(const std::vector<Row>& rows, const EdgeTimes& times) {
  std::printf("%-12s %8s %14s %14s %14s %10s %10s %12s\n", "resolution", "solved", "search (ms)", "plan (ms)",
              "proof (ms)", "in contact", "undecided", "deepest (mm)");
  for (const double resolution : kResolutions) {
    std::vector<double> search, whole, proof;
    int all = 0, contacts = 0, undecided = 0;
    double deepest = 0;
    for (const Row& row : rows) {
      if (row.resolution != resolution) continue;
      ++all;
      if (row.status != "solved") continue;
      search.push_back(row.search_seconds);
      whole.push_back(row.plan_seconds + row.proof_seconds);
      proof.push_back(row.proof_seconds);
      if (row.proof == "contact") ++contacts;
      if (row.proof == "undecided") ++undecided;
      if (row.contact.depth > deepest) deepest = row.contact.depth;
    }
    char name[32] = "proven";
    if (resolution > 0) std::snprintf(name, sizeof name, "%g", resolution);
    std::printf("%-12s %4zu/%-3d %14.3f %14.3f %14.3f %10d %10d %12.3f\n", name, search.size(), all,
                1e3 * median(search), 1e3 * median(whole), 1e3 * median(proof), contacts, undecided,
                1e3 * deepest);
  }
  std::printf(
      "edges of the proven searches: %zu free, median %.4f ms; %zu in contact, median %.4f ms; %lld "
      "undecided\n",
      times.free.size(), 1e3 * median(times.free), times.contact.size(), 1e3 * median(times.contact),
      static_cast<long long>(times.undecided));
}

PlanRecord record_of(const Row& row) {
  return {row.resolution, row.status == "solved", row.proof == "contact", row.plan_seconds,
          length_of(row.path)};
}

std::unique_ptr<PlanResults> results_of(const Settings& settings, const std::vector<fs::path>& environments) {
  if (settings.output.empty() || environments.empty()) return nullptr;
  std::vector<std::string> names;
  for (const fs::path& environment : environments) names.push_back(environment.filename().string());
  const Problem first =
      problem_of(robot_of(settings.folder), Problems::sorted(environments.front(), "request").front());
  return std::make_unique<PlanResults>(
      settings.output, names, std::vector<double>(std::begin(kResolutions), std::end(kResolutions)),
      settings.problems, settings.time_limit, static_cast<int>(first.start.size()),
      static_cast<int>(first.robot.bodies.size()));
}

/// A plan of each resolution, and its proof.
std::vector<Row> plans_of(const Problem& problem, const Settings& settings, EdgeTimes& times) {
  std::vector<Row> rows;
  for (const double resolution : kResolutions) {
    ompl::RNG::setSeed(1);
    Row row;
    row.environment = problem.environment;
    row.problem = problem.name;
    row.resolution = resolution;
    plan(problem, settings, times, row);
    if (row.status == "solved") prove(problem, row);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Every plan of the proven searches is proven again.
bool run_all(const Settings& settings) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  const BenchRobot bench = robot_of(settings.folder);
  const Problems problems(settings.folder);
  const std::vector<fs::path> environments = Problems::sorted(problems.folder(), "");
  const std::unique_ptr<PlanResults> results = results_of(settings, environments);
  std::ofstream csv(settings.csv);
  csv << kHeader;
  std::vector<Row> rows;
  EdgeTimes times;
  bool proven = true;
  for (std::size_t e = 0; e < environments.size(); ++e) {
    std::vector<fs::path> requests = Problems::sorted(environments[e], "request");
    requests.resize(std::min(requests.size(), static_cast<std::size_t>(settings.problems)));
    for (std::size_t k = 0; k < requests.size(); ++k) {
      if (results && results->has(e, static_cast<int>(k))) continue;
      const Problem problem = problem_of(bench, requests[k]);
      const std::string wrong = wrong_end(problem);
      if (!wrong.empty()) {
        std::printf("left out: %s %s: %s\n", problem.environment.c_str(), problem.name.c_str(),
                    wrong.c_str());
        continue;
      }
      std::vector<PlanRecord> records;
      for (Row& row : plans_of(problem, settings, times)) {
        if (row.resolution == 0 && row.status == "solved" && row.proof != "free") proven = false;
        csv << csv_of(row) << std::flush;
        records.push_back(record_of(row));
        rows.push_back(std::move(row));
      }
      if (results) results->store(e, static_cast<int>(k), records);
    }
  }
  if (results) results->finish();
  print(rows, times);
  if (!csv) throw InvalidParameterError("could not write " + settings.csv);
  return proven;
}

void add_options(CLI::App& app, Settings& settings) {
  app.add_option("folder", settings.folder, "of a robot: URDF, SRDF, meshes/ and problems.tar.bz2")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_option("--problems", settings.problems, "of each environment")->check(CLI::PositiveNumber);
  app.add_option("--time-limit", settings.time_limit, "seconds for a search")->check(CLI::PositiveNumber);
  app.add_option("--csv", settings.csv, "a line for each plan of this session");
  app.add_option(
      "-o,--output", settings.output,
      "also an HDF5 file for raygauge table, info and export; problems that it has are not planned again");
}

void run(const Settings& settings) {
  if (!run_all(settings)) throw Error("a plan of the proven search is not proven");
}

}  // namespace
}  // namespace raygauge::bench

int main(int argc, char** argv) {
  return raygauge::bench::run_with_options("raygauge_motionbench",
                                           "Plans of MotionBenchMaker problems: proven, and at samples.",
                                           raygauge::bench::add_options, raygauge::bench::run, argc, argv);
}
