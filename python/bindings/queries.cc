// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include <pybind11/numpy.h>

#include <atomic>
#include <limits>
#include <memory>
#include <string_view>

#include "python/bindings/arrays.h"
#include "python/bindings/bindings.h"
#include "python/bindings/interrupt.h"
#include "python/bindings/poses.h"
#include "python/bindings/query_docs.h"
#include "python/bindings/solving.h"
#include "python/bindings/thread_count.h"
#include "raygauge/exceptions.h"
#include "raygauge/queries/gradient.h"
#include "raygauge/queries/growth_distance.h"
#include "raygauge/queries/membership.h"
#include "raygauge/queries/object_distance.h"

namespace raygauge::python {
namespace {

// NOLINTNEXTLINE(misc-unused-using-decls): clang-tidy 14 sees no use of a literal
using py::literals::operator""_a;

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
const double kTolerance = DistanceOptions().tolerance;

// NOLINTNEXTLINE(readability-function-size): a parameter a keyword of the Python function
DistanceResult distance(const SetLike& A, const SetLike& Q, double tolerance, std::string_view method,
                        const PoseLike& pose_A, const PoseLike& pose_Q, const WarmStartLike& warm,
                        bool witness, double time_limit, std::int64_t max_iterations, int threads) {
  const SetPointer a = as_set(A, "A");
  const SetPointer q = as_set(Q, "Q");
  const auto a_pose = as_pose(pose_A, a->dimension(), "pose_A");
  const auto q_pose = as_pose(pose_Q, q->dimension(), "pose_Q");
  WarmStart* const kept = as_warm_start(warm);
  DistanceOptions options = options_of(method, tolerance, time_limit);
  options.max_iterations = max_iterations;
  options.threads = threads;
  const Lease<DistanceSolver> solver;
  SignalWatch signals;
  solver->set_options(options);
  solver->set_stop(signals.function());
  const Effects effects = witness ? Effects::witness : Effects::none;
  return signals.run(
      [&] { return DistanceResult(solver->solve(posed(*a, a_pose), posed(*q, q_pose), effects, kept)); });
}

// NOLINTNEXTLINE(readability-function-size): a parameter a keyword of the Python function
ObjectDistance object_distance(const SetLike& A1, const SetLike& A2, const SetLike& Q, double tolerance,
                               std::string_view method, const PoseLike& pose_1, const PoseLike& pose_2,
                               const WarmStartLike& warm, bool closest_points, bool gradient, bool is_signed,
                               double time_limit) {
  const SetPointer first = as_set(A1, "A1");
  const SetPointer second = as_set(A2, "A2");
  const SetPointer metric = as_set(Q, "Q");
  const auto first_pose = as_pose(pose_1, first->dimension(), "pose_1");
  const auto second_pose = as_pose(pose_2, second->dimension(), "pose_2");
  WarmStart* const kept = as_warm_start(warm);
  ObjectEffects effects = ObjectEffects::none;
  if (closest_points) effects = effects | ObjectEffects::closest_points;
  if (gradient) effects = effects | ObjectEffects::gradient | ObjectEffects::pose_gradient;
  if (is_signed) effects = effects | ObjectEffects::depth;
  SignalWatch signals;
  ObjectDistanceSolver solver(options_of(method, tolerance, time_limit));
  solver.set_stop(signals.function());
  return signals.run([&] {
    ObjectDistance answer =
        solver.solve(posed(*first, first_pose), posed(*second, second_pose), *metric, effects, kept);
    if (!closest_points) {
      answer.closest_point_1.resize(0);
      answer.closest_point_2.resize(0);
    }
    return answer;
  });
}

DistanceResult growth_distance(const SetLike& A, const SetLike& Q, double tolerance, std::string_view method,
                               const PoseLike& pose_A, const PoseLike& pose_Q, const WarmStartLike& warm,
                               double time_limit) {
  const SetPointer a = as_set(A, "A");
  const SetPointer q = as_set(Q, "Q");
  const auto a_pose = as_pose(pose_A, a->dimension(), "pose_A");
  const auto q_pose = as_pose(pose_Q, q->dimension(), "pose_Q");
  WarmStart* const kept = as_warm_start(warm);
  SignalWatch signals;
  GrowthDistanceSolver solver(options_of(method, tolerance, time_limit));
  solver.set_stop(signals.function());
  return signals.run(
      [&] { return DistanceResult(solver.solve(posed(*a, a_pose), posed(*q, q_pose), kept)); });
}

SeparationResult separation(const SetLike& A1, const SetLike& A2, double tolerance, std::string_view method,
                            const PoseLike& pose_1, const PoseLike& pose_2, const WarmStartLike& warm,
                            double time_limit) {
  const SetPointer first = as_set(A1, "A1");
  const SetPointer second = as_set(A2, "A2");
  const auto first_pose = as_pose(pose_1, first->dimension(), "pose_1");
  const auto second_pose = as_pose(pose_2, second->dimension(), "pose_2");
  WarmStart* const kept = as_warm_start(warm);
  SignalWatch signals;
  GrowthDistanceSolver solver(options_of(method, tolerance, time_limit));
  solver.set_stop(signals.function());
  return signals.run([&] {
    return SeparationResult(solver.separation(posed(*first, first_pose), posed(*second, second_pose), kept));
  });
}

py::object contains_origin_inside(const SetLike& Q, double time_limit) {
  const SetPointer q = as_set(Q, "Q");
  const PointSet* points = as_point_set(*q);
  if (points == nullptr) {
    throw InvalidParameterError("Q: an array of points or a PointSet is needed, got " + described(Q));
  }
  OriginInInterior::Answer answer{};
  {
    const py::gil_scoped_release release;
    answer = origin_in_interior(*points, time_limit).answer;
  }
  if (answer == OriginInInterior::Answer::unknown) return py::none();
  return py::bool_(answer == OriginInInterior::Answer::holds);
}

// The rows of x on `threads`, with Ctrl-C: what `ask` returns of them as columns.
template <class Ask>
auto of_rows(const ArrayLike& x, double tolerance, int threads, const Ask& ask) {
  const Eigen::MatrixXd X = as_matrix(x, "x").transpose();
  std::atomic<bool> stop = false;
  const PointsOptions options{tolerance, batch_threads(threads),
                              [&stop] { return stop.load(std::memory_order_relaxed); }};
  decltype(ask(X, options)) answers;
  run_interruptibly(stop, [&] { answers = ask(X, options); });
  return answers;
}

bool is_one_point(const ArrayLike& x) { return as_doubles(x, "x").ndim() != 2; }

py::object gauge_bounds(const SetLike& S, const ArrayLike& x, double tolerance, int threads) {
  const SetPointer set = as_set(S, "S");
  if (is_one_point(x)) {
    const Vector point = as_vector(x, "x");
    GaugeBounds bounds;
    {
      const py::gil_scoped_release release;
      bounds = gauge(*set, point, tolerance);
    }
    return py::make_tuple(bounds.lower, bounds.upper);
  }
  const auto bounds = of_rows(x, tolerance, threads, [&](const auto& X, const PointsOptions& options) {
    return gauges(*set, X, options);
  });
  py::array_t<double> lower(std::ssize(bounds)), upper(std::ssize(bounds));
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    lower.mutable_data()[i] = bounds[i].lower;
    upper.mutable_data()[i] = bounds[i].upper;
  }
  return py::make_tuple(lower, upper);
}

// Masked where nothing is proven.
py::object whether_contains(const SetLike& S, const ArrayLike& x, double tolerance, int threads) {
  const SetPointer set = as_set(S, "S");
  if (is_one_point(x)) {
    const Vector point = as_vector(x, "x");
    Membership membership{};
    {
      const py::gil_scoped_release release;
      membership = contains(*set, point, tolerance);
    }
    if (membership == Membership::undecided) return py::none();
    return py::bool_(membership == Membership::inside);
  }
  const auto found = of_rows(x, tolerance, threads, [&](const auto& X, const PointsOptions& options) {
    return memberships(*set, X, options);
  });
  py::array_t<bool> inside(std::ssize(found)), undecided(std::ssize(found));
  for (std::size_t i = 0; i < found.size(); ++i) {
    inside.mutable_data()[i] = found[i] == Membership::inside;
    undecided.mutable_data()[i] = found[i] == Membership::undecided;
  }
  return py::module_::import("numpy").attr("ma").attr("MaskedArray")(inside, "mask"_a = undecided);
}

}  // namespace

void bind_queries(py::module_& module) {
  module.def("distance", &distance, kDistanceDoc, "A"_a, "Q"_a, "tolerance"_a = kTolerance,
             "method"_a = "automatic", py::kw_only(), "pose_A"_a = py::none(), "pose_Q"_a = py::none(),
             "warm"_a = py::none(), "witness"_a = false, "time_limit"_a = kNoLimit, "max_iterations"_a = 0,
             "threads"_a = 1);
  module.def("object_distance", &object_distance, kObjectDistanceDoc, "A1"_a, "A2"_a, "Q"_a,
             "tolerance"_a = kTolerance, "method"_a = "automatic", py::kw_only(), "pose_1"_a = py::none(),
             "pose_2"_a = py::none(), "warm"_a = py::none(), "closest_points"_a = false, "gradient"_a = false,
             "signed"_a = false, "time_limit"_a = kNoLimit);
  module.def("growth_distance", &growth_distance, kGrowthDistanceDoc, "A"_a, "Q"_a,
             "tolerance"_a = kTolerance, "method"_a = "newton", py::kw_only(), "pose_A"_a = py::none(),
             "pose_Q"_a = py::none(), "warm"_a = py::none(), "time_limit"_a = kNoLimit);
  module.def("separation", &separation, kSeparationQueryDoc, "A1"_a, "A2"_a, "tolerance"_a = kTolerance,
             "method"_a = "newton", py::kw_only(), "pose_1"_a = py::none(), "pose_2"_a = py::none(),
             "warm"_a = py::none(), "time_limit"_a = kNoLimit);
  module.def("origin_in_interior", &contains_origin_inside, kOriginInInteriorDoc, "Q"_a, py::kw_only(),
             "time_limit"_a = kNoLimit);
  module.def("gauge", &gauge_bounds, kGaugeDoc, "S"_a, "x"_a, "tolerance"_a = kTolerance, py::kw_only(),
             "threads"_a = 0);
  module.def("contains", &whether_contains, kContainsDoc, "S"_a, "x"_a, "tolerance"_a = kTolerance,
             py::kw_only(), "threads"_a = 0);
  module.def(
      "gradient_moving_A", [](const DistanceResult& r) { return readonly_array(gradient_moving_A(r)); },
      kGradientMovingADoc, "result"_a);
  module.def(
      "gradient_moving_Q", [](const DistanceResult& r) { return readonly_array(gradient_moving_Q(r)); },
      kGradientMovingQDoc, "result"_a);
}

}  // namespace raygauge::python
