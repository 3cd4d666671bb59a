// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "python/sweeps/loading.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/input/mesh_object_file.h"
#include "cli/input/set_source.h"
#include "python/bindings/arrays.h"
#include "python/bindings/scene_answers.h"
#include "python/bindings/simulated_columns.h"
#include "raygauge/exceptions.h"
#include "raygauge/scene/motion.h"
#include "scene/input/robot_file.h"
#include "scene/input/scene_source.h"

namespace raygauge::python {
namespace {

using cli::Robot;
using cli::SceneSource;
using Folders = std::map<std::string, std::string>;
using MutableSet = std::shared_ptr<ConvexSet>;

MutableSet for_python(const SetPointer& set) { return std::const_pointer_cast<ConvexSet>(set); }

MutableSet load_set(const std::string& source, bool skip_header) {
  cli::PointFormat format;
  format.skip_header = skip_header;
  return for_python(cli::read_set_source(source, format));
}

MutableSet load_mesh(const std::string& source, bool solid) {
  return for_python(cli::read_mesh_as(source, solid ? "solid" : "surface"));
}

std::vector<std::string> link_names(const Robot& robot) {
  std::vector<std::string> names;
  for (const cli::RobotLink& link : robot.links) names.push_back(link.name);
  return names;
}

std::vector<std::vector<MutableSet>> shapes(const Robot& robot) {
  std::vector<std::vector<MutableSet>> all;
  for (const cli::RobotLink& link : robot.links) {
    all.emplace_back();
    for (const SetPointer& shape : link.shapes) all.back().push_back(for_python(shape));
  }
  return all;
}

/// What was left out of the file, and what its meshes are taken for.
std::vector<std::string> notes(const Robot& robot) {
  std::vector<std::string> lines = cli::lines_of_left_out(robot);
  lines.insert(lines.end(), robot.notes.begin(), robot.notes.end());
  return lines;
}

/// Pairs of links that a joint joins.
std::vector<std::pair<int, int>> joined(const Robot& robot) {
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t i = 0; i < robot.tree.links.size(); ++i) {
    if (robot.tree.links[i].parent >= 0) pairs.emplace_back(robot.tree.links[i].parent, static_cast<int>(i));
  }
  return pairs;
}

void check_values(const Robot& robot, const std::vector<double>& values) {
  if (values.size() != robot.joints.size())
    throw DimensionMismatchError("values: " + std::to_string(robot.joints.size()) +
                                 " joints need a value each, got " + std::to_string(values.size()));
}

/// The twists of the links by each joint, shape (links, joints, 6).
py::array_t<double> twists(const Robot& robot, const std::vector<double>& values) {
  check_values(robot, values);
  const auto tree = std::make_shared<const KinematicTree>(robot.tree);
  const auto count = static_cast<py::ssize_t>(robot.links.size()),
             joints = static_cast<py::ssize_t>(robot.joints.size());
  py::array_t<double> all({count, joints, py::ssize_t{6}});
  double* out = all.mutable_data();
  for (int link = 0; link < static_cast<int>(count); ++link) {
    for (const Twist& twist : joint_twists(tree, values, link)) {
      for (const Vector3& part : {twist.linear, twist.angular}) {
        for (const double each : {part.x, part.y, part.z}) *out++ = each;
      }
    }
  }
  return all;
}

/// Where the links are: homogeneous matrices, shape (links, 4, 4).
py::array_t<double> poses(const Robot& robot, const std::vector<double>& values) {
  check_values(robot, values);
  const auto tree = std::make_shared<const KinematicTree>(robot.tree);
  const auto still = std::make_shared<JointTrajectory>();
  still->times = {0, 1};
  still->values =
      Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size())).replicate(1, 2);
  const auto count = static_cast<py::ssize_t>(robot.links.size());
  constexpr py::ssize_t kSize = 4;
  py::array_t<double> matrices({count, kSize, kSize});
  for (py::ssize_t k = 0; k < count; ++k) {
    const Placement place = LinkMotion(tree, still, Placement::identity(3), static_cast<int>(k)).at(0);
    for (py::ssize_t i = 0; i < kSize; ++i) {
      for (py::ssize_t j = 0; j < kSize; ++j) {
        const double last = i == 3 ? (j == 3 ? 1.0 : 0.0) : 0.0;
        *matrices.mutable_data(k, i, j) = i == 3 ? last : (j == 3 ? place.t[i] : place.R(i, j));
      }
    }
  }
  return matrices;
}

template <class Things>
std::vector<std::string> names_of(const Things& things) {
  std::vector<std::string> names;
  for (const auto& thing : things) names.push_back(thing.name);
  return names;
}

/// The joints of the links, as raygauge.EdgeChecker takes them.
py::list tree(const Robot& robot) {
  py::list links;
  for (const TreeLink& step : robot.tree.links) {
    Eigen::Matrix4d origin = Eigen::Matrix4d::Identity();
    origin.topLeftCorner<3, 3>() = step.origin.R;
    origin.topRightCorner<3, 1>() = step.origin.t;
    py::array_t<double> matrix({4, 4});
    for (int k = 0; k < 16; ++k) matrix.mutable_data()[k] = origin(k / 4, k % 4);
    py::dict link;
    link["parent"] = step.parent;
    link["origin"] = matrix;
    link["kind"] = step.kind == JointKind::fixed      ? "fixed"
                   : step.kind == JointKind::revolute ? "revolute"
                                                      : "prismatic";
    link["axis"] = py::array_t<double>(3, step.axis.data());
    link["joint"] = step.joint;
    link["scale"] = step.scale;
    link["offset"] = step.offset;
    links.append(link);
  }
  return links;
}

/// (lower, upper) of each joint; infinite where it is shifted without limits.
std::vector<std::pair<double, double>> limits(const Robot& robot, const std::vector<double>& start,
                                              const std::vector<double>& goal) {
  std::vector<std::pair<double, double>> ranges;
  const std::vector<cli::JointLimits> own = cli::limits_of(robot);
  if (start.size() != own.size() || goal.size() != own.size())
    throw DimensionMismatchError("start and goal need a value for each of the " + std::to_string(own.size()) +
                                 " joints");
  for (std::size_t i = 0; i < own.size(); ++i) {
    const cli::JointLimits range = cli::planning_limits(own[i], start[i], goal[i]);
    ranges.emplace_back(range.lower, range.upper);
  }
  return ranges;
}

void bind_robots(py::module_& module) {
  py::class_<Robot>(module, "RobotFile", "A robot as its file has it; see raygauge.load_robot.")
      .def_readonly("name", &Robot::name)
      .def_readonly("joints", &Robot::joints)
      .def_property_readonly("links", &link_names)
      .def_property_readonly("notes", &notes)
      .def_property_readonly("joined", &joined)
      .def("shapes", &shapes)
      .def("tree", &tree)
      .def("limits", &limits, py::arg("start"), py::arg("goal"))
      .def("poses", &poses, py::arg("values"))
      .def("twists", &twists, py::arg("values"));
  module.def(
      "load_robot",
      [](const std::string& path, const Folders& packages, const std::string& meshes) {
        if (!meshes.empty()) cli::check_way_to_take_a_mesh(meshes, "meshes", "");
        return cli::read_robot(path, {packages, false, meshes});
      },
      py::arg("path"), py::arg("packages"), py::arg("meshes"));
}

void bind_scene_files(py::module_& module) {
  py::class_<SceneSource>(module, "SceneFile", "A scene as its file has it; see raygauge.load_scene.")
      .def_property_readonly("name", [](const SceneSource& source) { return source.scene.name; })
      .def_property_readonly("instants", [](const SceneSource& source) { return source.scene.instants; })
      .def_property_readonly("bodies",
                             [](const SceneSource& source) { return names_of(source.scene.bodies); })
      .def_property_readonly("queries",
                             [](const SceneSource& source) { return names_of(source.scene.queries); })
      .def("explain", [](const SceneSource& source) { return scene_lines(source.scene); })
      .def(
          "columns",
          [](const SceneSource& source, int threads) {
            if (source.dynamics)
              throw InvalidParameterError("scene '" + source.scene.name + "' has [dynamics]: use simulate");
            return scene_columns(source.scene, threads);
          },
          py::arg("threads"))
      .def(
          "simulation",
          [](const SceneSource& source, int threads) {
            if (!source.dynamics)
              throw InvalidParameterError("scene '" + source.scene.name + "' has no [dynamics]: use run");
            return simulated_columns(source.scene, *source.dynamics, threads);
          },
          py::arg("threads"));
  module.def(
      "load_scene",
      [](const std::string& path, const std::vector<std::string>& overrides, const Folders& packages) {
        return cli::read_scene(path, overrides, {packages});
      },
      py::arg("path"), py::arg("overrides"), py::arg("packages"));
}

}  // namespace

void bind_loading(py::module_& module) {
  module.def("load_set", &load_set, py::arg("source"), py::arg("skip_header"));
  module.def("load_mesh", &load_mesh, py::arg("source"), py::arg("solid"));
  bind_robots(module);
  bind_scene_files(module);
}

}  // namespace raygauge::python
