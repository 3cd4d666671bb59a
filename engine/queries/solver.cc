// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/queries/solver.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/lp/scaling.h"
#include "engine/lp/weighted_points.h"
#include "engine/methods/column_generation/sifting.h"
#include "engine/methods/column_generation/support_column_generation.h"
#include "engine/methods/counters.h"
#include "engine/methods/nearest_point/nearest_point.h"
#include "engine/methods/newton/newton.h"
#include "engine/methods/zheng_yamane/zheng_yamane.h"
#include "engine/numerics/floating_point.h"
#include "engine/queries/object_pair.h"
#include "engine/sets/capability_queries.h"
#include "engine/sets/parameters.h"
#include "engine/sets/posed_view.h"
#include "raygauge/exceptions.h"
#include "raygauge/methods/validate.h"
#include "raygauge/sets/minkowski_difference.h"

namespace raygauge {
namespace {

// A = S - T, as far as A knows; T is nullptr for {0}.
struct Difference {
  const ConvexSet* S;
  const ConvexSet* T;
};

Difference difference(const ConvexSet& A) {
  if (const auto* sets = dynamic_cast<const MinkowskiDifference*>(&A))
    return {sets->A2().get(), sets->A1().get()};
  if (const auto* pair = dynamic_cast<const ObjectPair*>(&A)) return {&pair->A2(), &pair->A1()};
  return {&A, nullptr};
}

}  // namespace

DistanceMethod method_for(const ConvexSet& Q) noexcept {
  return Q.structure() == SupportStructure::smooth ? DistanceMethod::newton
                                                   : DistanceMethod::column_generation;
}

struct DistanceSolver::Workspace {
  enum class Concluded : std::uint8_t {
    sifting,
    support_column_generation,
    zheng_yamane,
    nearest_point,
    newton,
    quad_newton
  };

  DistanceOptions options;
  std::function<bool()> stop;
  DistanceResult result;
  Sifting sifting;
  SupportColumnGeneration support_column_generation;
  SupportOracle oracle_A;
  SupportOracle oracle_Q;
  Scaling scaling;  // of the oracles
  ZhengYamane zheng_yamane;
  NearestPoint nearest_point;
  Newton<double> newton;
  Newton<Quad> quad_newton;
  Concluded concluded = Concluded::sifting;
  DistanceMethod chosen = DistanceMethod::column_generation;  // the method of this solve

  AlignedBuffer<double> start;

  Stopwatch stopwatch;        // over all methods that take part
  DistanceCounters counters;  // of all of them

  void solve(const ConvexSet& A, const ConvexSet& Q, Effects effects, const double* first = nullptr);
  bool solve_iteratively(const ConvexSet& A, const ConvexSet& Q, Effects effects, const double* first);
  bool solve_by_nearest_point(const ConvexSet& A, const ConvexSet& Q, Effects effects, const double* first);
  void solve_by_columns(const ConvexSet& A, const ConvexSet& Q, Effects effects);
  void account(const DistanceCounters& of_method);
  bool is_unfinished() const;
  bool is_out_of_reach(const ConvexSet& A, const ConvexSet& Q);
  void refine(const ConvexSet& A, const ConvexSet& Q, Effects effects);
  template <class Method>
  bool refine_by(Method& method, const double* first, const ConvexSet& A, const ConvexSet& Q,
                 Effects effects);
  void bind_oracles(const ConvexSet& A, const ConvexSet& Q);
  void solve_by_support(const ConvexSet& A, const ConvexSet& Q);
  void report_contact_by_support(int n, Effects effects);
};

// `first`: a direction u to begin with, n doubles, where the method can use one.
void DistanceSolver::Workspace::solve(const ConvexSet& A, const ConvexSet& Q, Effects effects,
                                      const double* first) {
  stopwatch.start(options.time_limit, &stop);
  result.sigma = DistanceResult::kUnset;
  result.origin_weights.clear();
  counters = {};
  chosen = options.method == DistanceMethod::automatic ? method_for(Q) : options.method;
  if (!solve_iteratively(A, Q, effects, first)) {
    solve_by_columns(A, Q, effects);
    // Support points that crowd around a smooth contact spoil the linear program; Newton steps need no crowd.
    if (is_unfinished()) refine(A, Q, effects);
    if (concluded == Concluded::support_column_generation) report_contact_by_support(A.dimension(), effects);
  }
  result.counters = counters;
  result.seconds = stopwatch.seconds();
  // Proofs that contradict each other are none; a set that breaks its own promises can lead there.
  if (!(result.lower <= result.upper)) {
    result.status = DistanceStatus::precision_limit;
    result.lower = 0;
    result.upper = kInfinity;
  }
}

// By the method asked for, if that is not `column_generation`. False where it gives up.
bool DistanceSolver::Workspace::solve_iteratively(const ConvexSet& A, const ConvexSet& Q, Effects effects,
                                                  const double* first) {
  if (chosen == DistanceMethod::zheng_yamane) {
    concluded = Concluded::zheng_yamane;
    const bool done = zheng_yamane.solve(A, Q, options, stopwatch, effects, result);
    account(zheng_yamane.counters());
    return done;
  }
  if (chosen == DistanceMethod::newton) {
    if (solve_by_nearest_point(A, Q, effects, first)) return true;
    concluded = Concluded::newton;
    bool done = newton.solve(A, Q, options, stopwatch, effects, result, first);
    account(newton.counters());
    if (done && (first == nullptr || !is_unfinished())) return true;
    if (first != nullptr) return solve_iteratively(A, Q, effects, nullptr);  // a start that led nowhere
    concluded = Concluded::quad_newton;
    done = quad_newton.solve(A, Q, options, stopwatch, effects, result, newton.direction());
    account(quad_newton.counters());
    return done;
  }
  return false;
}

// The Euclidean distance of polytopes. False where it is another question, or was not answered.
bool DistanceSolver::Workspace::solve_by_nearest_point(const ConvexSet& A, const ConvexSet& Q,
                                                       Effects effects, const double* first) {
  const Difference sets = difference(A);
  if (!NearestPoint::suits(*sets.S, sets.T, Q)) return false;
  concluded = Concluded::nearest_point;
  const bool done = nearest_point.solve(*sets.S, sets.T, Q, options, stopwatch, effects, result, first);
  account(nearest_point.counters());
  return done;
}

// Adds what a method did. K is that of the first that did anything: the others did not scale Q again.
void DistanceSolver::Workspace::account(const DistanceCounters& of_method) {
  const std::int64_t scalings =
      counters.outer_iterations == 0 ? of_method.outer_iterations : counters.outer_iterations;
  for (const CounterInfo& counter : kCounters) counters.*counter.member += of_method.*counter.member;
  counters.outer_iterations = scalings;
}

void DistanceSolver::Workspace::solve_by_columns(const ConvexSet& A, const ConvexSet& Q, Effects effects) {
  const PointSet* points_A = as_point_set(A);
  const PointSet* points_Q = as_point_set(Q);
  if (points_A != nullptr && points_Q != nullptr) {
    sifting.solve(*points_A, *points_Q, options, stopwatch, effects, result);
    concluded = Concluded::sifting;
  } else {
    solve_by_support(A, Q);
  }
  account(result.counters);
}

// The tolerances of the linear program suit a gauge body of magnitude 1.
void DistanceSolver::Workspace::bind_oracles(const ConvexSet& A, const ConvexSet& Q) {
  const Kernels& kernels = kernels_for(options.instruction_set);
  oracle_A.bind(A, nullptr, kernels);
  oracle_Q.bind(Q, nullptr, kernels);
  scaling.compute_common(A, Q, oracle_Q.magnitude());
  if (scaling.trivial_A()) return;
  oracle_A.bind(A, scaling.factor_A(), kernels);
  oracle_Q.bind(Q, scaling.factor_Q(), kernels);
}

void DistanceSolver::Workspace::solve_by_support(const ConvexSet& A, const ConvexSet& Q) {
  concluded = Concluded::support_column_generation;
  const int n = A.dimension();
  bind_oracles(A, Q);
  support_column_generation.begin(oracle_A, oracle_Q, n, options, kernels_for(options.instruction_set));
  result.status = support_column_generation.run(stopwatch);
  result.lower = support_column_generation.lower();
  result.upper = support_column_generation.upper();
  // In this order an objective that is not a number gives way to the lower bound.
  result.distance = std::max(result.lower, std::min(support_column_generation.objective(), result.upper));
  result.normal = scaling.factor_A()[0] * Vector::Map(support_column_generation.normal(), n);
  result.counters = support_column_generation.counters();
}

// Once it is certain whose answer it is: room that is taken and given back would be allocated at every solve.
void DistanceSolver::Workspace::report_contact_by_support(int n, Effects effects) {
  if (double* contact = result.room_for_contact(effects, n)) {
    support_column_generation.contact_point(contact);
    const double share = result.status == DistanceStatus::contains_origin ? 0.0 : 1 / scaling.factor_A()[0];
    for (int k = 0; k < n; ++k) contact[k] *= share;
    ++counters.witness_evaluations;
  }
}

// At the limit of its precision, or of the iterations that are usually enough.
bool DistanceSolver::Workspace::is_unfinished() const {
  return result.status == DistanceStatus::precision_limit ||
         (result.status == DistanceStatus::iteration_limit && options.max_iterations == 0);
}

// The solve once more by `newton`, unless that was tried before, and then in quadruple precision, from what
// is known and from nothing.
void DistanceSolver::Workspace::refine(const ConvexSet& A, const ConvexSet& Q, Effects effects) {
  if (is_out_of_reach(A, Q)) return;
  if (chosen != DistanceMethod::newton && refine_by(newton, nullptr, A, Q, effects)) {
    concluded = Concluded::newton;
  }
  const int n = A.dimension();
  start.reserve(static_cast<std::size_t>(n));
  const double* known = result.lower > 0 && result.normal.size() == n ? start.data() : nullptr;
  if (known != nullptr) std::copy_n(result.normal.data(), n, start.data());
  for (const double* first : {known, static_cast<const double*>(nullptr)}) {
    if (!is_unfinished()) return;
    if (refine_by(quad_newton, first, A, Q, effects)) concluded = Concluded::quad_newton;
  }
}

// Where Q touches the origin, its multiples reach all that is strictly on their side of the tangent plane,
// and nothing else: A may lie in that plane, which no Farkas direction separates from them.
bool DistanceSolver::Workspace::is_out_of_reach(const ConvexSet& A, const ConvexSet& Q) {
  const int n = A.dimension();
  start.reserve(2 * static_cast<std::size_t>(n));
  double* u = start.data();
  if (!(result.lower > 0) || !touches_origin(Q, u)) return false;
  oracle_A.bind(A, nullptr, kernels_for(options.instruction_set));
  if (oracle_A.verify(u, -1.0, kInfinity, u + n).above() > 0) return false;
  result.status = DistanceStatus::unreachable;
  result.distance = result.lower = result.upper = kInfinity;
  result.normal = -Vector::Map(u, n);
  return true;
}

// True if the answer is now that of `method`, which concluded the solve or has the closer pair of bounds.
template <class Method>
bool DistanceSolver::Workspace::refine_by(Method& method, const double* first, const ConvexSet& A,
                                          const ConvexSet& Q, Effects effects) {
  const bool done = method.solve(A, Q, options, stopwatch, effects, result, first);
  const bool closer = !done && method.gap() < result.upper - result.lower;
  if (closer) method.report(DistanceStatus::precision_limit, effects, result);
  account(method.counters());
  return done || closer;
}

DistanceSolver::DistanceSolver(const DistanceOptions& options) : workspace_(std::make_unique<Workspace>()) {
  set_options(options);
}

DistanceSolver::~DistanceSolver() = default;
DistanceSolver::DistanceSolver(DistanceSolver&&) noexcept = default;
DistanceSolver& DistanceSolver::operator=(DistanceSolver&&) noexcept = default;

const DistanceOptions& DistanceSolver::options() const noexcept { return workspace_->options; }

void DistanceSolver::set_options(const DistanceOptions& options) {
  if (const std::string problem = validate(options); !problem.empty()) throw InvalidParameterError(problem);
  workspace_->options = options;
}

void DistanceSolver::set_stop(std::function<bool()> stop) { workspace_->stop = std::move(stop); }

const DistanceResult& DistanceSolver::solve(const ConvexSet& A, const ConvexSet& Q, Effects effects) {
  if (A.dimension() != Q.dimension()) {
    throw DimensionMismatchError("A lives in R^" + std::to_string(A.dimension()) + ", Q in R^" +
                                 std::to_string(Q.dimension()));
  }
  workspace_->solve(A, Q, effects);
  return workspace_->result;
}

const DistanceResult& DistanceSolver::solve(const Posed& A, const Posed& Q, Effects effects,
                                            WarmStart* warm) {
  check_dimension("distance", "Q", Q.dimension(), A.dimension());
  const InPose posed_A(A);
  const InPose posed_Q(Q);
  const double* first = warm != nullptr ? recorded_normal(*warm, A.dimension()) : nullptr;
  workspace_->solve(posed_A.set(), posed_Q.set(), effects, first);
  if (warm != nullptr) record_normal(workspace_->result.normal, *warm);
  return workspace_->result;
}

void DistanceSolver::keep_combination(bool keep) {
  workspace_->newton.keep_combination(keep);
  workspace_->quad_newton.keep_combination(keep);
}

bool DistanceSolver::contact_combination(WeightedPoints& combination) const {
  combination.clear(static_cast<int>(workspace_->result.normal.size()));
  switch (workspace_->concluded) {
    case Workspace::Concluded::sifting:
      break;
    case Workspace::Concluded::support_column_generation:
      workspace_->support_column_generation.contact_combination(combination);
      combination.scale(1 / workspace_->scaling.factor_A()[0]);
      break;
    case Workspace::Concluded::zheng_yamane:
      workspace_->zheng_yamane.contact_combination(combination);
      break;
    case Workspace::Concluded::nearest_point:
      break;
    case Workspace::Concluded::newton:
      workspace_->newton.contact_combination(combination);
      break;
    case Workspace::Concluded::quad_newton:
      workspace_->quad_newton.contact_combination(combination);
      break;
  }
  return combination.count() > 0;
}

bool DistanceSolver::nearest_points(Vector& of_A1, Vector& of_A2) const {
  if (workspace_->concluded != Workspace::Concluded::nearest_point) return false;
  const auto n = workspace_->result.normal.size();
  of_A1.resize(n);
  of_A2.resize(n);
  workspace_->nearest_point.nearest_points(of_A2.data(), of_A1.data());
  return true;
}

void DistanceSolver::set_threshold(double threshold) {
  workspace_->nearest_point.set_threshold(threshold);
  workspace_->newton.set_threshold(threshold);
  workspace_->quad_newton.set_threshold(threshold);
  workspace_->support_column_generation.set_threshold(threshold);
}

}  // namespace raygauge
