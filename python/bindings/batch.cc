// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <atomic>
#include <limits>
#include <string>

#include "python/bindings/arrays.h"
#include "python/bindings/batch_docs.h"
#include "python/bindings/batch_operands.h"
#include "python/bindings/bindings.h"
#include "python/bindings/distance_batch.h"
#include "python/bindings/interrupt.h"
#include "python/bindings/poses.h"
#include "python/bindings/solving.h"
#include "python/bindings/thread_count.h"
#include "raygauge/exceptions.h"
#include "raygauge/queries/pair_batch.h"

namespace raygauge::python {
namespace {

// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

// NOLINTNEXTLINE(readability-function-size): a parameter a keyword of the Python function
DistanceBatch distances(const SetsLike& A, const SetsLike& Q, double tolerance, const std::string& method,
                        const PoseLike& poses_A, const PoseLike& poses_Q, bool witness, bool along_path,
                        double time_limit, int threads) {
  const BatchSide a(A, "A", poses_A, "poses_A");
  const BatchSide q(Q, "Q", poses_Q, "poses_Q");
  const DistanceOptions options = options_of(method, tolerance, time_limit);
  const std::ptrdiff_t count = problem_count(a, q, "distance()");
  const int team = batch_threads(threads);
  const int n = a.operand.dimension();
  if (n != q.operand.dimension()) {
    throw DimensionMismatchError("A has n = " + std::to_string(n) +
                                 ", Q has n = " + std::to_string(q.operand.dimension()));
  }
  DistanceBatch batch(count, n, witness);
  const BatchAnswers answers = batch.answers();
  BatchPairs pairs(a, q, team);
  PairBatch solvers(options, team);
  std::atomic<bool> stop = false;
  solvers.set_stop([&stop] { return stop.load(std::memory_order_relaxed); });
  run_interruptibly(stop, [&] {
    solvers.gauge_distances(static_cast<std::size_t>(count), pairs.source(), n, answers, along_path);
  });
  if (pairs.replaced()) warn_of_replaced_rotation();
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
