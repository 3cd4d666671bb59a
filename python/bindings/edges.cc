// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/robot_problem.h"
#include "python/bindings/scene_bodies.h"
#include "raygauge/exceptions.h"
#include "raygauge/scene/edge_checker.h"

namespace raygauge::python {
namespace {

// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

TreeLink link_of(const py::dict& given) {
  TreeLink link;
  link.parent = given["parent"].cast<int>();
  link.origin = placement(py::object(given["origin"]), 3);
  const auto kind = given["kind"].cast<std::string>();
  if (kind == "revolute") link.kind = JointKind::revolute;
  if (kind == "prismatic") link.kind = JointKind::prismatic;
  link.axis = as_vector(py::object(given["axis"]), "axis");
  link.joint = given["joint"].cast<int>();
  link.scale = given["scale"].cast<double>();
  link.offset = given["offset"].cast<double>();
  return link;
}

RobotModel model_of(const py::dict& robot) {
  RobotModel model;
  for (const py::handle link : robot["links"]) model.tree.links.push_back(link_of(link.cast<py::dict>()));
  model.joints = robot["joints"].cast<int>();
  model.base = placement(py::object(robot["base"]), 3);
  for (const py::handle given : robot["bodies"]) {
    const auto body = given.cast<py::dict>();
    RobotBody own;
    own.name = body["name"].cast<std::string>();
    own.link = body["link"].cast<int>();
    own.origin = placement(py::object(body["pose"]), 3);
    for (const py::handle part : body["parts"]) own.parts.push_back(as_set(part, "parts"));
    model.bodies.push_back(std::move(own));
  }
  model.ignored = robot["ignored"].cast<std::vector<std::pair<int, int>>>();
  return model;
}

RobotProblem make_problem(const py::dict& robot, const py::list& obstacles, double margin, double contact,
                          std::int64_t max_looks) {
  RobotProblem problem;
  problem.robot = model_of(robot);
  for (const py::handle body : obstacles) problem.obstacles.push_back(body_of(body.cast<py::dict>(), 0));
  problem.options.margin = margin;
  problem.options.contact = contact;
  problem.options.max_looks = max_looks;
  return problem;
}

std::unique_ptr<EdgeChecker> make_checker(const RobotProblem& problem) {
  EdgeOptions options = problem.options;
  options.witness = true;
  return std::make_unique<EdgeChecker>(problem.robot, problem.obstacles, options);
}

const char* word_of(EdgeOutcome outcome) {
  if (outcome == EdgeOutcome::free) return "free";
  return outcome == EdgeOutcome::contact ? "contact" : "undecided";
}

py::object point_of(const SmallVector& point) {
  if (point.size() == 0) return py::none();
  return py::array_t<double>(point.size(), point.data());
}

/// outcome, time, bodies, parts, lower, upper, point_a, point_b, depth.
py::tuple verdict(const EdgeResult& result) {
  return py::make_tuple(word_of(result.outcome), result.time, py::make_tuple(result.body_a, result.body_b),
                        py::make_tuple(result.part_a, result.part_b), result.lower, result.upper,
                        point_of(result.point_a), point_of(result.point_b), result.depth);
}

std::span<const double> span_of(const Vector& q) { return {q.data(), static_cast<std::size_t>(q.size())}; }

py::tuple edge(EdgeChecker& checker, py::handle q0, py::handle q1, double from, double to) {
  const Vector first = as_vector(q0, "q0"), last = as_vector(q1, "q1");
  return verdict(checker.edge(span_of(first), span_of(last), from, to));
}

py::tuple configuration(EdgeChecker& checker, py::handle q, double time) {
  const Vector values = as_vector(q, "q");
  return verdict(checker.configuration(span_of(values), time));
}

py::tuple path(EdgeChecker& checker, py::handle times, py::handle values) {
  JointTrajectory trajectory;
  const Vector at = as_vector(times, "times");
  const auto rows = as_doubles(values, "path");
  if (rows.ndim() != 2) throw DimensionMismatchError("path: a row of joint values for each time is needed");
  trajectory.times.assign(at.begin(), at.end());
  const auto count = static_cast<Eigen::Index>(rows.shape(0)),
             joints = static_cast<Eigen::Index>(rows.shape(1));
  trajectory.values = Eigen::MatrixXd::Map(rows.data(), joints, count);
  return verdict(checker.path(trajectory));
}

}  // namespace

void bind_edges(py::module_& module) {
  py::class_<RobotProblem>(module, "RobotProblem", "A robot among obstacles; use raygauge.EdgeChecker.")
      .def(py::init(&make_problem), "robot"_a, "obstacles"_a, "margin"_a, "contact"_a, "max_looks"_a);
  py::class_<EdgeChecker>(module, "EdgeProofs", "Edges of a robot; use raygauge.EdgeChecker.")
      .def(py::init(&make_checker), "problem"_a)
      .def("edge", &edge, "q0"_a, "q1"_a, "start"_a, "stop"_a)
      .def("configuration", &configuration, "q"_a, "time"_a)
      .def("path", &path, "times"_a, "values"_a)
      .def("name", &EdgeChecker::name, "body"_a);
}

}  // namespace raygauge::python
