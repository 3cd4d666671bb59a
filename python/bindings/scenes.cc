// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/poses.h"
#include "python/bindings/scene_answers.h"
#include "python/bindings/scene_bodies.h"
#include "raygauge/exceptions.h"
#include "raygauge/scene/motion.h"
#include "raygauge/scene/scene.h"

namespace raygauge::python {
namespace {

// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

/// The placement that a homogeneous matrix of R^n describes.
Placement placement_of_rows(const double* matrix, int n, const char* name) {
  const RigidParts parts = parts_of_rows(matrix, n, name);
  const NearestRotation nearest = nearest_rotation(name, parts.rotation);
  if (nearest.off > 0) warn_of_replaced_rotation();
  return make_placement(nearest.R, parts.translation);
}

}  // namespace

Placement placement(py::handle object, int n) {
  if (object.is_none()) return Placement::identity(n);
  const auto matrix = as_doubles(object, "pose");
  if (matrix.ndim() != 2 || matrix.shape(0) != n + 1 || matrix.shape(1) != n + 1) {
    throw DimensionMismatchError("pose: a homogeneous matrix of R^" + std::to_string(n) + " is needed, got " +
                                 described(object));
  }
  return placement_of_rows(matrix.data(), n, "pose");
}

namespace {

MotionPointer keyframes(py::handle times, py::handle poses, int n) {
  const Vector at = as_vector(times, "times");
  const auto matrices = as_doubles(poses, "poses");
  if (matrices.ndim() != 3 || matrices.shape(0) != at.size() || matrices.shape(1) != n + 1 ||
      matrices.shape(2) != n + 1) {
    throw DimensionMismatchError("poses: a homogeneous matrix of R^" + std::to_string(n) +
                                 " for each time is needed, got " + described(poses));
  }
  std::vector<Placement> frames;
  for (Eigen::Index k = 0; k < at.size(); ++k) {
    frames.push_back(placement_of_rows(matrices.data() + k * (n + 1) * (n + 1), n, "poses"));
  }
  return std::make_shared<KeyframeMotion>(std::vector<double>(at.begin(), at.end()), std::move(frames));
}

/// A vector of n numbers, zeros for None.
Vector rate(py::handle object, int n, const char* name) {
  if (object.is_none()) return Vector::Zero(n);
  Vector numbers = as_vector(object, name);
  if (numbers.size() != n) {
    throw DimensionMismatchError(std::string(name) + ": " + std::to_string(n) + " numbers are needed, got " +
                                 std::to_string(numbers.size()));
  }
  return numbers;
}

/// The spin about the origin of the body: a number in the plane, three of them in space.
Eigen::Vector3d spin_of(py::handle object, int n) {
  if (object.is_none()) return Eigen::Vector3d::Zero();
  if (n == 2) return {0, 0, rate(py::make_tuple(object), 1, "spin")[0]};
  return rate(object, 3, "spin");
}

MotionPointer motion_of(const py::dict& body, int n, double start) {
  const py::object times = body["times"];
  if (!times.is_none()) return keyframes(times, py::object(body["poses"]), n);
  const Placement first = placement(py::object(body["pose"]), n);
  const py::object velocity = body["velocity"], acceleration = body["acceleration"], spin = body["spin"];
  if (velocity.is_none() && acceleration.is_none() && spin.is_none()) {
    return std::make_shared<StaticMotion>(first);
  }
  TwistMotion::Rates rates;
  rates.velocity = rate(velocity, n, "velocity");
  rates.acceleration = rate(acceleration, n, "acceleration");
  rates.spin = spin_of(spin, n);
  return std::make_shared<TwistMotion>(first, rates, start);
}

}  // namespace

Body body_of(const py::dict& body, double start) {
  std::vector<SetPointer> parts;
  for (const py::handle part : body["parts"]) parts.push_back(as_set(part, "parts"));
  if (parts.empty()) throw EmptySetError("parts: a body needs one");
  const int n = parts.front()->dimension();
  return make_body(value_of<std::string>(body, "name"), parts, motion_of(body, n, start));
}

namespace {

SceneEffects effects_of(const std::vector<std::string>& names) {
  SceneEffects effects = SceneEffects::none;
  for (const std::string& name : names) effects = effects | effect_named(name);
  return effects;
}

SceneQuery query_of(const py::dict& asked) {
  SceneQuery query;
  query.name = value_of<std::string>(asked, "name");
  query.group_1 = value_of<std::vector<int>>(asked, "group_1");
  query.group_2 = value_of<std::vector<int>>(asked, "group_2");
  query.effects = effects_of(value_of<std::vector<std::string>>(asked, "effects"));
  if (const py::object metric = asked["metric"]; !metric.is_none()) query.metric.Q = as_set(metric, "metric");
  query.metric.body = value_of<int>(asked, "metric_body");
  query.within = value_of<double>(asked, "within");
  query.nearest = value_of<int>(asked, "nearest");
  query.tolerance = value_of<double>(asked, "tolerance");
  query.contact = value_of<double>(asked, "contact");
  query.clearance_tolerance = value_of<double>(asked, "clearance_tolerance");
  query.every_instant = value_of<bool>(asked, "every_instant");
  return query;
}

}  // namespace

Scene scene_of(const py::list& bodies, py::handle instants, const std::vector<std::pair<int, int>>& ignored,
               const py::list& queries) {
  Scene scene;
  const Vector at = as_vector(instants, "instants");
  scene.instants.assign(at.begin(), at.end());
  const double start = at.size() == 0 ? 0.0 : at[0];
  for (const py::handle body : bodies) scene.bodies.push_back(body_of(body.cast<py::dict>(), start));
  scene.ignored = ignored;
  for (const py::handle query : queries) scene.queries.push_back(query_of(query.cast<py::dict>()));
  check_scene(scene);
  return scene;
}

namespace {

py::dict answers(const py::list& bodies, py::handle instants, const std::vector<std::pair<int, int>>& ignored,
                 const py::list& queries, int threads) {
  return scene_columns(scene_of(bodies, instants, ignored, queries), threads);
}

std::vector<std::vector<std::string>> explanation(const py::list& bodies, py::handle instants,
                                                  const std::vector<std::pair<int, int>>& ignored,
                                                  const py::list& queries) {
  return scene_lines(scene_of(bodies, instants, ignored, queries));
}

}  // namespace

void bind_scenes(py::module_& module) {
  module.def("scene_answers", &answers, "The columns of a scene's answers; use raygauge.Scene.", "bodies"_a,
             "instants"_a, "ignored"_a, "queries"_a, "threads"_a);
  module.def("scene_explanation", &explanation, "What will be computed; use raygauge.Scene.", "bodies"_a,
             "instants"_a, "ignored"_a, "queries"_a);
}

}  // namespace raygauge::python
