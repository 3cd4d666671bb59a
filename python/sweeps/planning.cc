// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/sweeps/planning.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <atomic>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/bindings/interrupt.h"
#include "python/bindings/robot_problem.h"
#include "raygauge/exceptions.h"
#include "scene/commands/plan_motion.h"

namespace raygauge::python {
namespace {

namespace py = pybind11;

/// One configuration a row.
py::array_t<double> rows_of(const DenseMatrix& values) {
  py::array_t<double> rows(
      {static_cast<py::ssize_t>(values.cols()), static_cast<py::ssize_t>(values.rows())});
  std::copy_n(values.data(), values.size(), rows.mutable_data());
  return rows;
}

/// path, times, length, search_seconds, shorten_seconds, proof_seconds, edges, undecided.
py::tuple plan_of(const PlannedPath& path, const JointTrajectory& trajectory) {
  const py::array_t<double> times(static_cast<py::ssize_t>(trajectory.times.size()), trajectory.times.data());
  return py::make_tuple(rows_of(trajectory.values), times, path.length, path.search_seconds,
                        path.shorten_seconds, path.proof_seconds, path.motions, path.undecided);
}

py::tuple plan(const RobotProblem& problem, const std::vector<std::pair<double, double>>& limits,
               std::vector<double> start, std::vector<double> goal, const std::optional<std::string>& planner,
               std::optional<double> time_limit, std::optional<std::int64_t> seed) {
  for (const Body& body : problem.obstacles)
    if (!body.motion->is_static())
      throw InvalidParameterError("'" + body.name + "' moves; a path is planned among bodies that stand");
  PlanRequest request;
  request.robot = problem.robot;
  request.obstacles = problem.obstacles;
  request.options = problem.options;
  for (const auto& [lower, upper] : limits) {
    request.lower.push_back(lower);
    request.upper.push_back(upper);
  }
  request.start = std::move(start);
  request.goal = std::move(goal);
  if (planner) request.planner = *planner;
  if (time_limit) request.time_limit = *time_limit;
  if (seed) request.seed = *seed;
  std::atomic<bool> stop = false;
  request.stop = &stop;
  PlannedPath path;
  run_interruptibly(stop, [&] { path = plan_path(request); });
  JointTrajectory trajectory{{}, path.values};
  if (!path.found()) trajectory.values.resize(problem.robot.joints, 0);
  for (Eigen::Index k = 0; k < path.values.cols(); ++k) trajectory.times.push_back(static_cast<double>(k));
  return plan_of(path, trajectory);
}

py::tuple plan_scene(const cli::SceneSource& source, const std::optional<std::string>& planner,
                     std::optional<double> time_limit, std::optional<std::int64_t> seed) {
  cli::SceneSource own = source;  // whose bodies will move
  std::atomic<bool> stop = false;
  const cli::PlanOptions options{planner, time_limit, seed, &stop};
  cli::PlannedMotion motion;
  run_interruptibly(stop, [&] { motion = cli::plan_motion(own, options); });
  if (!motion.path.found())
    motion.trajectory.values.resize(static_cast<Eigen::Index>(own.plan->standing.size()), 0);
  return plan_of(motion.path, motion.trajectory);
}

}  // namespace

void bind_planning(py::module_& module) {
  module.def("plan", &plan, py::arg("problem"), py::arg("limits"), py::arg("start"), py::arg("goal"),
             py::arg("planner"), py::arg("time_limit"), py::arg("seed"), "See raygauge.plan.");
  module.def("plan_scene", &plan_scene, py::arg("scene"), py::arg("planner"), py::arg("time_limit"),
             py::arg("seed"), "See raygauge.plan.");
}

}  // namespace raygauge::python
