// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

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
#include "raygauge/queries/membership.h"
#include "raygauge/queries/pair_batch.h"

namespace raygauge::python {
namespace {

// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

/// The points of A, one a column.
auto points_of(const BatchSide& A) {
  return Eigen::MatrixXd::Map(A.operand.single_points(), A.operand.dimension(), A.operand.count());
}

/// Whether the problems are points, and one set of which gauges() walks from facet to facet. Numbers that are
/// not finite are left to the queries that name the problem.
bool walks(const BatchSide& A, const BatchSide& Q) {
  return A.operand.single_points() != nullptr && Q.operand.is_shared() &&
         gauges_walk(*Q.operand.set(0), A.operand.count()) && points_of(A).allFinite();
}

/// How a distance within these bounds has ended; nothing if they leave it open.
std::optional<DistanceStatus> status_of(const GaugeBounds& b, double tolerance) {
  if (b.lower == kUnlimited) return DistanceStatus::unreachable;
  if (b.upper == 0) return DistanceStatus::contains_origin;
  if (b.lower > 0 && b.upper - b.lower <= tolerance * b.upper) return DistanceStatus::optimal;
  return std::nullopt;
}

/// What gauges() answers within the tolerance, without pivots. Returns the other problems.
std::vector<std::size_t> walk_over_facets(const BatchSide& A, const BatchSide& Q,
                                          const PointsOptions& options, const BatchAnswers& answers) {
  Eigen::MatrixXd normals;
  const std::vector<GaugeBounds> bounds = gauges(*Q.operand.set(0), points_of(A), options, &normals);
  std::copy_n(normals.data(), normals.size(), answers.normal.data());
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const GaugeBounds& b = bounds[i];
    answers.lower[i] = b.lower;
    answers.distance[i] = answers.upper[i] = b.upper;
    answers.pivots[i] = 0;
    if (const auto status = status_of(b, options.tolerance)) {
      answers.status[i] = *status;
    } else {
      open.push_back(i);
    }
  }
  return open;
}

/// The problems `open`, solved alone.
void solve_open(const std::vector<std::size_t>& open, PairBatch& solvers, const PairSource& pairs, int n,
                const BatchAnswers& answers) {
  const std::size_t size = static_cast<std::size_t>(n);
  std::vector<double> distance(open.size()), lower(open.size()), upper(open.size()),
      normal(open.size() * size);
  std::vector<DistanceStatus> status(open.size());
  std::vector<std::int64_t> pivots(open.size());
  BatchAnswers some;
  some.distance = distance, some.lower = lower, some.upper = upper, some.normal = normal;
  some.status = status, some.pivots = pivots;
  const auto source = [&](std::size_t k, int thread) { return pairs(open[k], thread); };
  solvers.gauge_distances(open.size(), source, n, some);
  for (std::size_t k = 0; k < open.size(); ++k) {
    const std::size_t i = open[k];
    answers.distance[i] = distance[k], answers.lower[i] = lower[k], answers.upper[i] = upper[k];
    answers.status[i] = status[k], answers.pivots[i] = pivots[k];
    std::copy_n(normal.data() + k * size, size, answers.normal.data() + i * size);
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
  const auto stopped = [&stop] { return stop.load(std::memory_order_relaxed); };
  solvers.set_stop(stopped);
  const bool plain = !witness && !along_path && !a.poses.given() && !q.poses.given() &&
                     options.method == DistanceMethod::automatic && options.time_limit == kUnlimited;
  run_interruptibly(stop, [&] {
    if (plain && walks(a, q)) {
      const auto open = walk_over_facets(a, q, {tolerance, team, stopped}, answers);
      solve_open(open, solvers, pairs.source(), n, answers);
    } else {
      solvers.gauge_distances(static_cast<std::size_t>(count), pairs.source(), n, answers, along_path);
    }
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
             "time_limit"_a = kUnlimited, "threads"_a = 0);
}

}  // namespace raygauge::python
