// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/method_chain.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/methods/counters.h"
#include "engine/numerics/floating_point.h"
#include "engine/queries/proven_bounds.h"
#include "engine/queries/spatial_solve.h"
#include "engine/sets/posed_view.h"
#include "raygauge/exceptions.h"
#include "raygauge/methods/validate.h"
#include "raygauge/queries/solver.h"
#include "raygauge/sets/ball.h"

namespace raygauge {
namespace {

Problem afresh(const Problem& problem) {
  Problem again = problem;
  again.start = nullptr;
  return again;
}

}  // namespace

// Each turn is taken where none before it has finished the solve. Column generation always answers, but may
// stop short of the tolerance: the turns after it narrow the bounds that it leaves.
const MethodChain::Turn MethodChain::kTurns[] = {
    {&MethodChain::is_newton_asked_for, &MethodChain::by_spatial_gauge},
    // The Euclidean distance of polytopes needs no gauge body; a start that leads nowhere is forgotten.
    {&MethodChain::is_newton_asked_for_with_start, &MethodChain::by_nearest_point},
    {&MethodChain::is_newton_asked_for_with_start, &MethodChain::by_newton},
    {&MethodChain::is_newton_asked_for, &MethodChain::by_nearest_point_afresh},
    {&MethodChain::is_newton_asked_for, &MethodChain::by_newton_afresh},
    // Whether 0 is in a set of points is one exact question, asked once where no method is sure of d > 0.
    {&MethodChain::is_newton_near_origin, &MethodChain::by_origin_question},
    {&MethodChain::is_newton_asked_for, &MethodChain::by_quad_newton_after_newton},
    {&MethodChain::is_zheng_yamane_asked_for, &MethodChain::by_zheng_yamane},
    {&MethodChain::always, &MethodChain::by_column_generation},
    {&MethodChain::is_near_origin, &MethodChain::by_origin_question},
    {&MethodChain::is_distant, &MethodChain::by_tangent_plane},
    // Support points that crowd around a smooth contact spoil the linear program; Newton steps need no crowd.
    {&MethodChain::is_newton_untried, &MethodChain::refined_by_newton},
    {&MethodChain::has_normal, &MethodChain::refined_by_quad_newton},
    {&MethodChain::always, &MethodChain::refined_by_quad_newton_afresh},
    // Whether a difference of bodies of R^2 or R^3 holds the origin: a question without a metric.
    {&MethodChain::may_hold_origin, &MethodChain::by_overlap},
};

bool MethodChain::is_newton_asked_for_with_start(const Problem& problem) const {
  return chosen_ == DistanceMethod::newton && problem.start != nullptr;
}

// Not where it is a method for other sets.
bool MethodChain::is_newton_near_origin(const Problem& problem) const {
  return chosen_ == DistanceMethod::newton && newton_.direction() == nullptr &&
         method_for(problem.Q) == DistanceMethod::newton;
}

bool MethodChain::has_normal(const Problem& problem) const {
  return result_.lower > 0 && result_.normal.size() == problem.A.dimension();
}

void MethodChain::set_options(const DistanceOptions& options) {
  if (const std::string problem = validate(options); !problem.empty()) throw InvalidParameterError(problem);
  options_ = options;
}

const DistanceResult& MethodChain::solve(const ConvexSet& A, const ConvexSet& Q, Effects effects,
                                         const double* start, const Aim& aim) {
  stopwatch_.start(std::min(options_.time_limit, aim.time_limit), &stop_);
  result_.sigma = DistanceResult::kUnset;
  result_.origin_weights.clear();
  counters_ = {};
  is_origin_asked_ = is_newton_tried_ = false;
  chosen_ = options_.method == DistanceMethod::automatic ? method_for(Q) : options_.method;
  const Problem problem{A, Q, options_, stopwatch_, effects, start, aim.threshold, aim.pairs};
  for (const Turn& turn : kTurns) {
    if ((this->*turn.is_due)(problem) && (this->*turn.solve)(problem)) break;
  }
  keep_newton_bounds(effects);
  if (concluded_ == Concluded::column_generation && column_generation_.report_contact(problem, result_)) {
    ++counters_.witness_evaluations;
  }
  result_.counters = counters_;
  result_.seconds = stopwatch_.seconds();
  if (result_.status == DistanceStatus::iteration_limit && options_.max_iterations == 0)
    result_.status = DistanceStatus::precision_limit;  // of a method's own number of iterations
  // Proofs that contradict each other are none; a set that breaks its own promises can lead there.
  if (!(result_.lower <= result_.upper)) {
    result_.status = DistanceStatus::precision_limit;
    result_.lower = 0;
    result_.upper = kInfinity;
  }
  return result_;
}

// Where `newton` was asked for and the methods after it, short of time or of precision, ended farther apart.
void MethodChain::keep_newton_bounds(Effects effects) {
  const bool short_of_tolerance = result_.status == DistanceStatus::time_limit ||
                                  result_.status == DistanceStatus::precision_limit ||
                                  result_.status == DistanceStatus::iteration_limit;
  if (chosen_ != DistanceMethod::newton || !is_newton_tried_ || !short_of_tolerance) return;
  if (concluded_ == Concluded::newton || !(newton_.gap() < result_.upper - result_.lower)) return;
  newton_.report(result_.status, effects, result_);
  concluded_ = Concluded::newton;
}

const DistanceResult& MethodChain::solve(const Posed& A, const Posed& Q, Effects effects, WarmStart* warm,
                                         const Aim& aim) {
  const InPose posed_A(A);
  const InPose posed_Q(Q);
  const double* start = warm != nullptr ? recorded_normal(*warm, A.dimension()) : nullptr;
  solve(posed_A.set(), posed_Q.set(), effects, start, aim);
  if (warm != nullptr) record_normal(result_.normal, *warm);
  return result_;
}

// False where the method gives up: the result is what it was then.
template <class Method>
bool MethodChain::answers(Method& method, Concluded name, const Problem& problem) {
  concluded_ = name;
  const bool done = method.solve(problem, result_);
  account(method.counters());
  return done;
}

bool MethodChain::by_spatial_gauge(const Problem& problem) {
  return answers(spatial_gauge_, Concluded::spatial_gauge, problem);
}

bool MethodChain::by_nearest_point(const Problem& problem) {
  return answers(nearest_point_, Concluded::nearest_point, problem);
}

bool MethodChain::by_nearest_point_afresh(const Problem& problem) {
  return by_nearest_point(afresh(problem));
}

bool MethodChain::by_newton(const Problem& problem) {
  is_newton_tried_ = true;
  return answers(newton_, Concluded::newton, problem);
}

bool MethodChain::by_newton_afresh(const Problem& problem) { return by_newton(afresh(problem)); }

bool MethodChain::by_quad_newton_after_newton(const Problem& problem) {
  Problem from_there = problem;
  from_there.start = newton_.direction();
  return answers(quad_newton_, Concluded::quad_newton, from_there);
}

bool MethodChain::by_zheng_yamane(const Problem& problem) {
  return answers(zheng_yamane_, Concluded::zheng_yamane, problem);
}

bool MethodChain::by_column_generation(const Problem& problem) {
  answers(column_generation_, Concluded::column_generation, problem);
  return is_finished();
}

bool MethodChain::by_tangent_plane(const Problem& problem) { return tangent_plane_.solve(problem, result_); }

bool MethodChain::by_origin_question(const Problem& problem) {
  if (is_origin_asked_) return false;
  is_origin_asked_ = true;
  const bool inside = origin_question_.solve(problem, result_);
  account(origin_question_.counters());
  if (inside) concluded_ = Concluded::origin_question;
  return inside;
}

bool MethodChain::refined_by_newton(const Problem& problem) {
  refine(newton_, Concluded::newton, afresh(problem));
  return is_finished();
}

// From the normal of the bounds at hand.
bool MethodChain::refined_by_quad_newton(const Problem& problem) {
  const int n = problem.A.dimension();
  start_.reserve(static_cast<std::size_t>(n));
  std::copy_n(result_.normal.data(), n, start_.data());
  Problem from_there = problem;
  from_there.start = start_.data();
  refine(quad_newton_, Concluded::quad_newton, from_there);
  return is_finished();
}

bool MethodChain::refined_by_quad_newton_afresh(const Problem& problem) {
  refine(quad_newton_, Concluded::quad_newton, afresh(problem));
  return is_finished();
}

bool MethodChain::may_hold_origin(const Problem& problem) const {
  return problem.A.dimension() <= 3 && result_.status == DistanceStatus::precision_limit &&
         !(result_.lower > 0);
}

bool MethodChain::by_overlap(const Problem& problem) {
  constexpr double kAny = 0.5;  // the distance itself is not asked for
  const auto [S, T] = NearestPoint::difference(problem.A);
  const Ball origin(Vector::Zero(problem.A.dimension()), 0.0);
  SpatialSolve solve;
  if (!solve.bind(T != nullptr ? *T : origin, *S, options_.instruction_set) || !solve.place({}, {}))
    return false;
  solve.distance(kAny, nullptr);
  counters_.support_queries += solve.support_queries();
  if (solve.answer().end != SpatialEnd::intersecting) return false;
  set_overlap(result_);
  return true;
}

// The answer is that of `method` from now on if it concluded the solve or has the closer pair of bounds.
template <class Method>
void MethodChain::refine(Method& method, Concluded name, const Problem& problem) {
  const bool done = method.solve(problem, result_);
  const bool closer = !done && method.gap() < result_.upper - result_.lower;
  if (closer) method.report(DistanceStatus::precision_limit, problem.effects, result_);
  account(method.counters());
  if (done || closer) concluded_ = name;
}

// Adds what a method did. K is that of the first that did anything: the others did not scale Q again.
void MethodChain::account(const DistanceCounters& of_method) {
  const std::int64_t scalings =
      counters_.outer_iterations == 0 ? of_method.outer_iterations : counters_.outer_iterations;
  for (const CounterInfo& counter : kCounters) counters_.*counter.member += of_method.*counter.member;
  counters_.outer_iterations = scalings;
}

// Not at the limit of a method's precision, nor of the iterations that are usually enough.
bool MethodChain::is_finished() const {
  return result_.status != DistanceStatus::precision_limit &&
         (result_.status != DistanceStatus::iteration_limit || options_.max_iterations > 0);
}

bool MethodChain::contact_combination(WeightedPoints& combination) const {
  combination.clear(static_cast<int>(result_.normal.size()));
  switch (concluded_) {
    case Concluded::nearest_point:
    case Concluded::spatial_gauge:
    case Concluded::origin_question:
      break;
    case Concluded::column_generation:
      column_generation_.contact_combination(combination);
      break;
    case Concluded::zheng_yamane:
      zheng_yamane_.contact_combination(combination);
      break;
    case Concluded::newton:
      newton_.contact_combination(combination);
      break;
    case Concluded::quad_newton:
      quad_newton_.contact_combination(combination);
      break;
  }
  return combination.count() > 0;
}

bool MethodChain::nearest_points(Vector& of_A1, Vector& of_A2) const {
  if (concluded_ != Concluded::nearest_point) return false;
  const auto n = result_.normal.size();
  of_A1.resize(n);
  of_A2.resize(n);
  nearest_point_.nearest_points(of_A2.data(), of_A1.data());
  return true;
}

}  // namespace raygauge
