// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "python/bindings/batch_docs.h"
#include "python/bindings/batch_operands.h"
#include "python/bindings/interrupt.h"
#include "python/bindings/results.h"
#include "python/bindings/thread_count.h"
#include "raygauge/queries/object_distance.h"
#include "raygauge/queries/pair_batch.h"

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
  std::optional<Rows> pose_gradient_1, pose_gradient_2;
  std::optional<py::array_t<bool>> is_unique;
  std::vector<GradientKind> kinds;

  ObjectDistanceBatch(std::ptrdiff_t count, int n, bool points, bool gradient)
      : distance(count), lower(count), upper(count), status_code(count), normal(rows(count, n)) {
    if (gradient) {
      pose_gradient_1 = rows(count, 3 * n - 3);
      pose_gradient_2 = rows(count, 3 * n - 3);
      is_unique = py::array_t<bool>(count);
      kinds.resize(static_cast<std::size_t>(count));
    }
    if (!points) return;
    point_1 = rows(count, n);
    point_2 = rows(count, n);
  }

  /// Where PairBatch writes them: the arrays' memory.
  BatchAnswers answers() {
    BatchAnswers answers;
    answers.distance = numbers_of(distance);
    answers.lower = numbers_of(lower);
    answers.upper = numbers_of(upper);
    answers.status = statuses(status_code);
    answers.normal = numbers_of(normal);
    if (point_1) answers.closest_points_1 = numbers_of(*point_1);
    if (point_2) answers.closest_points_2 = numbers_of(*point_2);
    if (pose_gradient_1) answers.pose_gradients_1 = numbers_of(*pose_gradient_1);
    if (pose_gradient_2) answers.pose_gradients_2 = numbers_of(*pose_gradient_2);
    answers.gradient_kind = kinds;
    return answers;
  }

  /// Which gradients are the only ones.
  void name_kinds() {
    if (!is_unique) return;
    std::transform(kinds.begin(), kinds.end(), is_unique->mutable_data(),
                   [](GradientKind kind) { return kind == GradientKind::unique; });
  }
};

// NOLINTNEXTLINE(readability-function-size): a parameter a keyword of the Python function
ObjectDistanceBatch object_distances(const SetsLike& A1, const SetsLike& A2, const SetLike& Q,
                                     double tolerance, const std::string& method, const PoseLike& poses_1,
                                     const PoseLike& poses_2, bool closest_points, bool gradient,
                                     bool is_signed, double time_limit, int threads) {
  const BatchSide first(A1, "A1", poses_1, "poses_1");
  const BatchSide second(A2, "A2", poses_2, "poses_2");
  const SetPointer metric = as_set(Q, "Q");
  const DistanceOptions options = options_of(method, tolerance, time_limit);
  const std::ptrdiff_t count = problem_count(first, second, "object_distance()");
  const int team = batch_threads(threads), n = metric->dimension();
  for (const BatchSide* side : {&first, &second}) {
    if (side->operand.dimension() == n) continue;
    throw DimensionMismatchError(std::string(side->name) +
                                 " has n = " + std::to_string(side->operand.dimension()) +
                                 ", Q has n = " + std::to_string(n));
  }
  if (gradient && n != 2 && n != 3)
    throw InvalidParameterError("gradient: of objects of R^2 or R^3, got n = " + std::to_string(n));
  ObjectDistanceBatch batch(count, n, closest_points, gradient);
  const BatchAnswers answers = batch.answers();
  BatchPairs pairs(first, second, team);
  PairBatch solvers(options, team);
  std::atomic<bool> stop = false;
  solvers.set_stop([&stop] { return stop.load(std::memory_order_relaxed); });
  const ObjectEffects effects = is_signed ? ObjectEffects::depth : ObjectEffects::none;
  run_interruptibly(stop, [&] {
    solvers.distances(static_cast<std::size_t>(count), pairs.source(), *metric, answers, effects);
  });
  batch.name_kinds();
  if (pairs.replaced()) warn_of_replaced_rotation();
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
      .def_readonly("pose_gradient_1", &ObjectDistanceBatch::pose_gradient_1)
      .def_readonly("pose_gradient_2", &ObjectDistanceBatch::pose_gradient_2)
      .def_readonly("is_unique", &ObjectDistanceBatch::is_unique)
      .def("__len__", [](const ObjectDistanceBatch& batch) { return batch.distance.size(); })
      .def("__repr__", [](const ObjectDistanceBatch& batch) {
        return "<raygauge.ObjectDistances of " + std::to_string(batch.distance.size()) + " problems>";
      });
  module.def("object_distances", &object_distances, kObjectDistancesDoc, "A1"_a, "A2"_a, "Q"_a,
             "tolerance"_a = DistanceOptions().tolerance, "method"_a = "automatic", py::kw_only(),
             "poses_1"_a = py::none(), "poses_2"_a = py::none(), "closest_points"_a = false,
             "gradient"_a = false, "signed"_a = false,
             "time_limit"_a = std::numeric_limits<double>::infinity(), "threads"_a = 0);
}

}  // namespace raygauge::python
