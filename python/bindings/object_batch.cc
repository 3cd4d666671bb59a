// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "python/bindings/batch_docs.h"
#include "python/bindings/batch_operands.h"
#include "python/bindings/interrupt.h"
#include "python/bindings/results.h"
#include "python/bindings/workers.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge::python {
namespace {

// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

using Rows = py::array_t<double>;

Rows rows(std::ptrdiff_t count, int n) { return Rows({count, static_cast<std::ptrdiff_t>(n)}); }

/// The answers of a batch of pairs, a NumPy array each.
struct ObjectDistanceBatch {
  Rows distance, lower, upper;  // signed where that was asked for
  py::array_t<std::int8_t> status_code;
  Rows normal;
  std::optional<Rows> point_1, point_2;

  ObjectDistanceBatch(std::ptrdiff_t count, int n, bool points)
      : distance(count), lower(count), upper(count), status_code(count), normal(rows(count, n)) {
    if (!points) return;
    point_1 = rows(count, n);
    point_2 = rows(count, n);
  }
};

/// Where the threads of a batch write: the arrays' memory.
struct ObjectBatchOutput {
  double *distance, *lower, *upper, *normal;
  double *point_1 = nullptr, *point_2 = nullptr;
  std::int8_t* status;
  int n;

  ObjectBatchOutput(ObjectDistanceBatch& batch, int dimension)
      : distance(batch.distance.mutable_data()),
        lower(batch.lower.mutable_data()),
        upper(batch.upper.mutable_data()),
        normal(batch.normal.mutable_data()),
        status(batch.status_code.mutable_data()),
        n(dimension) {
    if (!batch.point_1) return;
    point_1 = batch.point_1->mutable_data();
    point_2 = batch.point_2->mutable_data();
  }

  void store(std::ptrdiff_t k, const ObjectDistance& r) const {
    const bool inside = r.depth.evaluations > 0;
    distance[k] = r.signed_distance();
    lower[k] = inside ? -r.depth.upper : r.distance.lower;
    upper[k] = inside ? -r.depth.lower : r.distance.upper;
    status[k] = static_cast<std::int8_t>(inside ? r.depth.status : r.distance.status);
    store_vector(inside ? r.depth.normal : r.distance.normal, normal, k);
    if (point_1 == nullptr) return;
    store_vector(inside ? r.depth.point_1 : r.closest_point_1, point_1, k);
    store_vector(inside ? r.depth.point_2 : r.closest_point_2, point_2, k);
  }

 private:
  void store_vector(const Vector& vector, double* all, std::ptrdiff_t k) const {
    if (vector.size() == n) {
      std::copy_n(vector.data(), n, all + k * n);
    } else {
      std::fill_n(all + k * n, n, std::numeric_limits<double>::quiet_NaN());
    }
  }
};

/// What all threads of a batch read.
struct ObjectBatchTask {
  const BatchSide &A1, &A2;
  const ConvexSet& Q;
  const DistanceOptions& options;
  ObjectEffects effects;
  const ObjectBatchOutput& output;
  const std::atomic<bool>& stop;
  std::atomic<bool>& replaced;  ///< whether a rotation was
};

void work_on(const ObjectBatchTask& task, const std::function<std::ptrdiff_t()>& next) {
  ObjectDistanceSolver solver(task.options);
  solver.set_stop([&task] { return task.stop.load(std::memory_order_relaxed); });
  for (std::ptrdiff_t k = next(); k >= 0; k = next()) {
    naming_problem(k, [&] {
      const SetPointer first = task.A1.operand.set(k), second = task.A2.operand.set(k);
      const std::optional<Pose> pose_1 = task.A1.poses.pose(k), pose_2 = task.A2.poses.pose(k);
      for (const auto* pose : {&pose_1, &pose_2}) {
        if (*pose && (*pose)->replaced() > 0) task.replaced.store(true, std::memory_order_relaxed);
      }
      task.output.store(k, solver.solve(posed(*first, pose_1), posed(*second, pose_2), task.Q, task.effects));
    });
  }
}

// NOLINTNEXTLINE(readability-function-size): a parameter a keyword of the Python function
ObjectDistanceBatch object_distances(const SetsLike& A1, const SetsLike& A2, const SetLike& Q,
                                     double tolerance, const std::string& method, const PoseLike& poses_1,
                                     const PoseLike& poses_2, bool closest_points, bool is_signed,
                                     double time_limit, int threads) {
  const BatchSide first(A1, "A1", poses_1, "poses_1");
  const BatchSide second(A2, "A2", poses_2, "poses_2");
  const SetPointer metric = as_set(Q, "Q");
  const DistanceOptions options = options_of(method, tolerance, time_limit);
  const std::ptrdiff_t count = problem_count(first, second, "object_distance()");
  const int team = batch_threads(threads, count), n = metric->dimension();
  for (const BatchSide* side : {&first, &second}) {
    if (side->operand.dimension() == n) continue;
    throw DimensionMismatchError(std::string(side->name) +
                                 " has n = " + std::to_string(side->operand.dimension()) +
                                 ", Q has n = " + std::to_string(n));
  }
  ObjectEffects effects = closest_points ? ObjectEffects::closest_points : ObjectEffects::none;
  if (is_signed) effects = effects | ObjectEffects::depth;
  ObjectDistanceBatch batch(count, n, closest_points);
  const ObjectBatchOutput output(batch, n);
  std::atomic<bool> stop = false, replaced = false;
  const ObjectBatchTask task{first, second, *metric, options, effects, output, stop, replaced};
  run_interruptibly(
      stop, [&] { share_items(count, team, stop, [&task](const auto& next) { work_on(task, next); }); });
  if (replaced) warn_of_replaced_rotation();
  return batch;
}

py::object status_texts(const ObjectDistanceBatch& batch) {
  const py::object names = py::module_::import("numpy").attr("array")(py::cast(status_names()));
  return names.attr("__getitem__")(batch.status_code);
}

}  // namespace

void bind_object_batches(py::module_& module) {
  py::class_<ObjectDistanceBatch>(module, "ObjectDistances", kObjectDistanceBatchDoc)
      .def_readonly("distance", &ObjectDistanceBatch::distance)
      .def_readonly("lower", &ObjectDistanceBatch::lower)
      .def_readonly("upper", &ObjectDistanceBatch::upper)
      .def_readonly("status_code", &ObjectDistanceBatch::status_code)
      .def_property_readonly("status", &status_texts)
      .def_readonly("normal", &ObjectDistanceBatch::normal)
      .def_readonly("point_1", &ObjectDistanceBatch::point_1)
      .def_readonly("point_2", &ObjectDistanceBatch::point_2)
      .def("__len__", [](const ObjectDistanceBatch& batch) { return batch.distance.size(); })
      .def("__repr__", [](const ObjectDistanceBatch& batch) {
        return "<raygauge.ObjectDistances of " + std::to_string(batch.distance.size()) + " problems>";
      });
  module.def("object_distances", &object_distances, kObjectDistancesDoc, "A1"_a, "A2"_a, "Q"_a,
             "tolerance"_a = DistanceOptions().tolerance, "method"_a = "automatic", py::kw_only(),
             "poses_1"_a = py::none(), "poses_2"_a = py::none(), "closest_points"_a = false,
             "signed"_a = false, "time_limit"_a = std::numeric_limits<double>::infinity(), "threads"_a = 0);
}

}  // namespace raygauge::python
