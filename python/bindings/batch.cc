// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/bindings/arrays.h"
#include "python/bindings/batch_docs.h"
#include "python/bindings/batch_operands.h"
#include "python/bindings/bindings.h"
#include "python/bindings/distance_batch.h"
#include "python/bindings/interrupt.h"
#include "python/bindings/poses.h"
#include "python/bindings/solving.h"
#include "python/bindings/workers.h"
#include "raygauge/exceptions.h"
#include "raygauge/queries/solver.h"

namespace raygauge::python {
namespace {

// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

/// Where the threads of a batch write: the arrays' memory.
struct BatchOutput {
  double* distance;
  double* lower;
  double* upper;
  std::int8_t* status;
  double* normal;
  double* contact;
  std::int64_t* pivots;
  int n;

  BatchOutput(DistanceBatch& batch, int dimension)
      : distance(batch.distance.mutable_data()),
        lower(batch.lower.mutable_data()),
        upper(batch.upper.mutable_data()),
        status(batch.status_code.mutable_data()),
        normal(batch.normal.mutable_data()),
        contact(batch.contact_data),
        pivots(batch.pivots.mutable_data()),
        n(dimension) {}

  void store(std::ptrdiff_t k, const DistanceResult& result) const {
    distance[k] = result.distance;
    lower[k] = result.lower;
    upper[k] = result.upper;
    status[k] = static_cast<std::int8_t>(result.status);
    pivots[k] = result.counters.pivots;
    store_vector(result.normal, normal + k * n);
    if (contact != nullptr) store_vector(result.contact_point, contact + k * n);
  }

 private:
  void store_vector(const Vector& vector, double* row) const {
    Eigen::Map<Eigen::VectorXd> target(row, n);
    if (vector.size() == n) {
      target = vector;
    } else {
      target.setConstant(DistanceResult::kUnset);
    }
  }
};

/// What all threads of a batch read.
struct BatchTask {
  const BatchSide& A;
  const BatchSide& Q;
  const DistanceOptions& options;
  const BatchOutput& output;
  const std::atomic<bool>& stop;
  std::atomic<bool>& replaced;  ///< whether a rotation was
  Effects effects = Effects::none;
  bool along_path = false;
};

/// Problem k, without the interpreter's lock. `warm` is what the problem before it left, or nullptr.
void solve_problem(const BatchTask& task, std::ptrdiff_t k, DistanceSolver& solver, WarmStart* warm) {
  const SetPointer object = task.A.operand.set(k);
  const SetPointer gauge = task.Q.operand.set(k);
  if (!task.A.poses.given() && !task.Q.poses.given() && warm == nullptr) {
    task.output.store(k, solver.solve(*object, *gauge, task.effects));
    return;
  }
  const std::optional<Pose> object_pose = task.A.poses.pose(k);
  const std::optional<Pose> gauge_pose = task.Q.poses.pose(k);
  for (const auto* pose : {&object_pose, &gauge_pose}) {
    if (*pose && (*pose)->replaced() > 0) task.replaced.store(true, std::memory_order_relaxed);
  }
  task.output.store(k,
                    solver.solve(posed(*object, object_pose), posed(*gauge, gauge_pose), task.effects, warm));
}

/// The work of one thread. Along a path the first of each row of items starts cold: which thread has it does
/// not change an answer.
void work_on(const BatchTask& task, const std::function<std::ptrdiff_t()>& next) {
  DistanceSolver solver(task.options);
  solver.set_stop([&task] { return task.stop.load(std::memory_order_relaxed); });
  WarmStart warm;
  for (std::ptrdiff_t k = next(); k >= 0; k = next()) {
    if (k % kItemsAtOnce == 0) warm.clear();
    naming_problem(k, [&] { solve_problem(task, k, solver, task.along_path ? &warm : nullptr); });
  }
}

// NOLINTNEXTLINE(readability-function-size): a parameter a keyword of the Python function
DistanceBatch distances(const SetsLike& A, const SetsLike& Q, double tolerance, const std::string& method,
                        const PoseLike& poses_A, const PoseLike& poses_Q, bool witness, bool along_path,
                        double time_limit, int threads) {
  const BatchSide a(A, "A", poses_A, "poses_A");
  const BatchSide q(Q, "Q", poses_Q, "poses_Q");
  const DistanceOptions options = options_of(method, tolerance, time_limit);
  const std::ptrdiff_t count = problem_count(a, q, "distance()");
  const int team = batch_threads(threads, count);
  const int n = a.operand.dimension();
  if (n != q.operand.dimension()) {
    throw DimensionMismatchError("A has n = " + std::to_string(n) +
                                 ", Q has n = " + std::to_string(q.operand.dimension()));
  }
  DistanceBatch batch(count, n, witness);
  const BatchOutput output(batch, n);
  std::atomic<bool> stop = false, replaced = false;
  const Effects effects = witness ? Effects::witness : Effects::none;
  const BatchTask task{a, q, options, output, stop, replaced, effects, along_path};
  run_interruptibly(
      stop, [&] { share_items(count, team, stop, [&task](const auto& next) { work_on(task, next); }); });
  if (replaced) warn_of_replaced_rotation();
  return batch;
}

}  // namespace

void bind_batches(py::module_& module) {
  bind_distance_batch(module);
  module.def("distances", &distances, kDistancesDoc, "A"_a, "Q"_a,
             "tolerance"_a = DistanceOptions().tolerance, "method"_a = "automatic", py::kw_only(),
             "poses_A"_a = py::none(), "poses_Q"_a = py::none(), "witness"_a = false, "along_path"_a = false,
             "time_limit"_a = std::numeric_limits<double>::infinity(), "threads"_a = 0);
}

}  // namespace raygauge::python
