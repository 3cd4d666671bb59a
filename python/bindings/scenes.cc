// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/interrupt.h"
#include "python/bindings/poses.h"
#include "python/bindings/workers.h"
#include "raygauge/exceptions.h"
#include "raygauge/scene/scene_run.h"

namespace raygauge::python {
namespace {

using py::literals::operator""_a;

/// The placement that a homogeneous matrix of R^n describes.
Placement placement_of_rows(const double* matrix, int n, const char* name) {
  const RigidParts parts = parts_of_rows(matrix, n, name);
  const NearestRotation nearest = nearest_rotation(name, parts.rotation);
  if (nearest.off > 0) warn_of_replaced_rotation();
  return make_placement(nearest.R, parts.translation);
}

Placement placement(py::handle object, int n) {
  if (object.is_none()) return Placement::identity(n);
  const auto matrix = as_doubles(object, "pose");
  if (matrix.ndim() != 2 || matrix.shape(0) != n + 1 || matrix.shape(1) != n + 1) {
    throw DimensionMismatchError("pose: a homogeneous matrix of R^" + std::to_string(n) + " is needed, got " +
                                 described(object));
  }
  return placement_of_rows(matrix.data(), n, "pose");
}

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

Body body_of(const py::dict& body, double start) {
  std::vector<SetPointer> parts;
  for (const py::handle part : body["parts"]) parts.push_back(as_set(part, "parts"));
  if (parts.empty()) throw EmptySetError("parts: a body needs one");
  const int n = parts.front()->dimension();
  return make_body(body["name"].cast<std::string>(), parts, motion_of(body, n, start));
}

constexpr std::array kEffects{std::pair{"separated", SceneEffects::separated},
                              std::pair{"distance", SceneEffects::distance},
                              std::pair{"closest_points", SceneEffects::closest_points},
                              std::pair{"gradient", SceneEffects::gradient},
                              std::pair{"growth", SceneEffects::growth},
                              std::pair{"time_of_impact", SceneEffects::time_of_impact},
                              std::pair{"clearance", SceneEffects::clearance}};

SceneEffects effects_of(const std::vector<std::string>& names) {
  SceneEffects effects = SceneEffects::none;
  for (const std::string& name : names) {
    const auto* const found = std::find_if(kEffects.begin(), kEffects.end(),
                                           [&](const auto& entry) { return name == entry.first; });
    if (found == kEffects.end()) {
      std::vector<std::string> known;
      for (const auto& entry : kEffects) known.emplace_back(entry.first);
      throw UnknownNameError("effect", name, known);
    }
    effects = effects | found->second;
  }
  return effects;
}

SceneQuery query_of(const py::dict& asked) {
  SceneQuery query;
  query.name = asked["name"].cast<std::string>();
  query.group_1 = asked["group_1"].cast<std::vector<int>>();
  query.group_2 = asked["group_2"].cast<std::vector<int>>();
  query.effects = effects_of(asked["effects"].cast<std::vector<std::string>>());
  if (const py::object metric = asked["metric"]; !metric.is_none()) query.metric.Q = as_set(metric, "metric");
  query.metric.body = asked["metric_body"].cast<int>();
  query.within = asked["within"].cast<double>();
  query.nearest = asked["nearest"].cast<int>();
  query.tolerance = asked["tolerance"].cast<double>();
  query.contact = asked["contact"].cast<double>();
  query.clearance_tolerance = asked["clearance_tolerance"].cast<double>();
  query.every_instant = asked["every_instant"].cast<bool>();
  return query;
}

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

/// The cells of a scene as they are done; in their order at the end.
class CellCollector final : public SceneSink {
 public:
  void store(const SceneCellResult& cell) override {
    const std::lock_guard lock(mutex_);
    cells_.push_back(cell);
  }
  std::vector<SceneRecord> records() {
    std::sort(cells_.begin(), cells_.end(), [](const auto& a, const auto& b) { return a.cell < b.cell; });
    std::vector<SceneRecord> all;
    for (const SceneCellResult& cell : cells_) {
      all.insert(all.end(), cell.records.begin(), cell.records.end());
    }
    return all;
  }

 private:
  std::mutex mutex_;
  std::vector<SceneCellResult> cells_;
};

template <class Value, class Get>
py::array_t<Value> column(const std::vector<SceneRecord>& records, Get get) {
  py::array_t<Value> array(static_cast<py::ssize_t>(records.size()));
  std::transform(records.begin(), records.end(), array.mutable_data(), get);
  return array;
}

template <class Get>
py::array_t<double> vectors(const std::vector<SceneRecord>& records, int n, Get get) {
  py::array_t<double> array({static_cast<py::ssize_t>(records.size()), static_cast<py::ssize_t>(n)});
  Eigen::Map<Eigen::MatrixXd> rows(array.mutable_data(), n, static_cast<Eigen::Index>(records.size()));
  rows.setConstant(SceneRecord::kNone);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const SmallVector& vector = get(records[i]);
    if (vector.size() == n) rows.col(static_cast<Eigen::Index>(i)) = vector;
  }
  return array;
}

template <class Get>
py::array texts(const std::vector<SceneRecord>& records, Get get) {
  py::list names;
  for (const SceneRecord& record : records) names.append(py::str(std::string(to_string(get(record)))));
  return py::module_::import("numpy").attr("array")(names, "dtype"_a = py::str("U16"));
}

py::dict columns_of(const std::vector<SceneRecord>& records, int n) {
  using R = const SceneRecord&;
  py::dict c;
  c["query"] = column<std::int32_t>(records, [](R r) { return r.query; });
  c["body_a"] = column<std::int32_t>(records, [](R r) { return r.body_a; });
  c["body_b"] = column<std::int32_t>(records, [](R r) { return r.body_b; });
  c["kind"] = texts(records, [](R r) { return r.kind; });
  c["instant"] = column<std::int64_t>(records, [](R r) { return r.instant; });
  c["time"] = column<double>(records, [](R r) { return r.time; });
  c["time_lower"] = column<double>(records, [](R r) { return r.time_lower; });
  c["time_upper"] = column<double>(records, [](R r) { return r.time_upper; });
  c["status"] = texts(records, [](R r) { return r.status; });
  c["decided"] = texts(records, [](R r) { return r.decided; });
  c["distance"] = column<double>(records, [](R r) { return r.distance; });
  c["lower"] = column<double>(records, [](R r) { return r.lower; });
  c["upper"] = column<double>(records, [](R r) { return r.upper; });
  c["growth"] = column<double>(records, [](R r) { return r.growth; });
  c["growth_lower"] = column<double>(records, [](R r) { return r.growth_lower; });
  c["growth_upper"] = column<double>(records, [](R r) { return r.growth_upper; });
  c["point_a"] = vectors(records, n, [](R r) -> const SmallVector& { return r.point_a; });
  c["point_b"] = vectors(records, n, [](R r) -> const SmallVector& { return r.point_b; });
  c["gradient"] = vectors(records, n, [](R r) -> const SmallVector& { return r.gradient; });
  c["solves"] = column<std::int64_t>(records, [](R r) { return r.solves; });
  c["seconds"] = column<double>(records, [](R r) { return r.seconds; });
  return c;
}

py::dict answers(const py::list& bodies, py::handle instants, const std::vector<std::pair<int, int>>& ignored,
                 const py::list& queries, int threads) {
  const Scene scene = scene_of(bodies, instants, ignored, queries);
  const ScenePlan plan = plan_scene(scene);
  const int team = batch_threads(threads, std::numeric_limits<std::ptrdiff_t>::max() / 2);
  CellCollector cells;
  std::atomic<bool> stop = false;
  SceneHooks hooks;
  hooks.stop = [&] { return stop.load(); };
  run_interruptibly(stop, [&] { run_scene(scene, plan, team, {}, cells, hooks); });
  return columns_of(cells.records(), scene.dimension());
}

std::vector<std::vector<std::string>> explanation(const py::list& bodies, py::handle instants,
                                                  const std::vector<std::pair<int, int>>& ignored,
                                                  const py::list& queries) {
  const Scene scene = scene_of(bodies, instants, ignored, queries);
  const ScenePlan plan = plan_scene(scene);
  std::vector<std::vector<std::string>> lines;
  for (std::size_t i = 0; i < scene.queries.size(); ++i) {
    lines.push_back(explain_query(scene, plan, static_cast<int>(i)));
  }
  return lines;
}

}  // namespace

void bind_scenes(py::module_& module) {
  module.def("scene_answers", &answers, "The columns of a scene's answers; use raygauge.Scene.", "bodies"_a,
             "instants"_a, "ignored"_a, "queries"_a, "threads"_a);
  module.def("scene_explanation", &explanation, "What will be computed; use raygauge.Scene.", "bodies"_a,
             "instants"_a, "ignored"_a, "queries"_a);
}

}  // namespace raygauge::python
