// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/general_methods.h"

#include <algorithm>
#include <utility>

#include "engine/methods/counters.h"
#include "engine/numerics/floating_point.h"
#include "raygauge/queries/solver.h"

namespace raygauge {
namespace {

constexpr unsigned kStarts = 4;  // of a method: Start

// Of either bound the better one, with what belongs to it; true where the upper one is that of `from`.
bool take_better(const DistanceResult& from, DistanceResult& to) {
  if (from.upper - from.lower < to.upper - to.lower) to.distance = from.distance;
  if (from.lower > to.lower) {
    to.lower = from.lower;
    to.normal = from.normal;  // no memory changes hands, so that no later solve lacks it
  }
  const bool closer = from.upper < to.upper;
  if (closer) {
    to.upper = from.upper;
    to.contact_point = from.contact_point;
  }
  to.distance = std::max(to.lower, std::min(to.distance, to.upper));
  return closer;
}

// Every point of the combination is a difference that was asked for on the way, and its parts were noted.
void take_apart(const WeightedPoints& combination, const SupportPairs& pairs, Vector& of_A1, Vector& of_A2) {
  double sum = 0;
  for (int i = 0; i < combination.count(); ++i) sum += combination.weight(i);
  of_A1.setZero();
  of_A2.setZero();
  for (int i = 0; i < combination.count(); ++i) {
    const double weight = combination.weight(i) / sum;
    const double* difference = combination.point(i);
    const double* a1 = pairs.partner(difference);
    for (int k = 0; k < of_A1.size(); ++k) {
      of_A1[k] += weight * a1[k];
      of_A2[k] += weight * (a1[k] + difference[k]);
    }
  }
}

}  // namespace

void GeneralMethods::begin(const Problem& problem, DistanceResult& result) {
  problem_ = &problem;
  result_ = &result;
  result.sigma = DistanceResult::kUnset;
  result.origin_weights.clear();
  counters_ = {};
  asked_ = 0;
  has_bounds_ = false;
  kept_.lower = 0;
  kept_.upper = kInfinity;
  const DistanceMethod asked = problem.options.method;
  chosen_ = asked == DistanceMethod::automatic ? method_for(problem.Q) : asked;
}

bool GeneralMethods::has_normal() const noexcept {
  return result_->lower > 0 && result_->normal.size() == problem_->A.dimension();
}

const double* GeneralMethods::direction(Start start) {
  if (start == Start::given) return problem_->start;
  if (start == Start::of_newton) return newton_.direction();
  if (start == Start::afresh) return nullptr;
  const auto n = static_cast<std::size_t>(problem_->A.dimension());
  start_.reserve(n);  // not the result's own: a method may write there
  std::copy_n(result_->normal.data(), n, start_.data());
  return start_.data();
}

bool GeneralMethods::is_new(MethodId id, const Problem& from, Start start) {
  const auto where = static_cast<unsigned>(from.start == nullptr ? Start::afresh : start);
  static_assert(kStarts * std::tuple_size_v<decltype(methods_)> <= 64);
  const std::uint64_t bit = std::uint64_t{1} << (kStarts * static_cast<unsigned>(id) + where);
  return (std::exchange(asked_, asked_ | bit) & bit) == 0;
}

bool GeneralMethods::ask(MethodId id, Start start) {
  Problem from = *problem_;
  from.start = direction(start);
  if (!is_new(id, from, start)) return false;
  Method& asked = method(id);
  const bool refines = has_bounds_ && (id == MethodId::newton || id == MethodId::quad_newton);
  const bool done = asked.solve(from, refines ? refined_ : *result_);
  account(asked.counters());
  if (!done || refines) {
    keep(asked, done);
    return done;
  }
  has_bounds_ = true;
  concluded_ = &asked;
  combination_ = nullptr;
  // It always answers, but may stop short of the tolerance.
  return id != MethodId::column_generation || is_finished();
}

// Bounds of a method that gave up, or came after others, better those at hand, or are kept for the end as
// long as there are none.
void GeneralMethods::keep(Method& method, bool done) {
  if (!done && !(method.bounds().gap() < kInfinity)) return;
  if (!done) method.write(DistanceStatus::precision_limit, problem_->effects, refined_);
  if (has_bounds_) result_->status = refined_.status;
  if (!take_better(refined_, has_bounds_ ? *result_ : kept_)) return;
  WeightedPoints& combination = has_bounds_ ? refined_combination_ : kept_combination_;
  combination.clear(problem_->A.dimension());
  if (problem_->pairs != nullptr) method.contact_combination(combination);
  if (has_bounds_) use(combination, !done);
}

// What proves the upper bound of the result from now on; whether its contact point is not accounted for yet.
void GeneralMethods::use(const WeightedPoints& combination, bool is_new) {
  concluded_ = nullptr;
  combination_ = &combination;
  if (is_new && has_effect(problem_->effects, Effects::witness)) ++counters_.witness_evaluations;
}

// Where those that went on were short of time or of precision.
void GeneralMethods::adopt_kept() {
  const bool is_short = result_->status == DistanceStatus::time_limit ||
                        result_->status == DistanceStatus::precision_limit ||
                        result_->status == DistanceStatus::iteration_limit;
  if (is_short && take_better(kept_, *result_)) use(kept_combination_, true);
  const Bounds bounds(result_->lower, result_->upper);
  if (is_short && bounds.lower() > 0 && bounds.close(problem_->options.tolerance))
    result_->status = DistanceStatus::optimal;
}

void GeneralMethods::finish() {
  adopt_kept();
  if (concluded_ == &column_generation_ && column_generation_.report_contact(*problem_, *result_))
    ++counters_.witness_evaluations;
  result_->counters = counters_;
  result_->seconds = problem_->stopwatch.seconds();
  if (result_->status == DistanceStatus::iteration_limit && problem_->options.max_iterations == 0)
    result_->status = DistanceStatus::precision_limit;  // of a method's own number of iterations
  // Proofs that contradict each other are none; a set that breaks its own promises can lead there.
  if (!(result_->lower <= result_->upper)) {
    result_->status = DistanceStatus::precision_limit;
    result_->lower = 0;
    result_->upper = kInfinity;
  }
}

// Adds what a method did. K is that of the first that did anything: the others did not scale Q again.
void GeneralMethods::account(const DistanceCounters& of_method) {
  const std::int64_t scalings =
      counters_.outer_iterations == 0 ? of_method.outer_iterations : counters_.outer_iterations;
  for (const CounterInfo& counter : kCounters) counters_.*counter.member += of_method.*counter.member;
  counters_.outer_iterations = scalings;
}

// Not at the limit of a method's precision, nor of the iterations that are usually enough.
bool GeneralMethods::is_finished() const noexcept {
  return result_->status != DistanceStatus::precision_limit &&
         (result_->status != DistanceStatus::iteration_limit || problem_->options.max_iterations > 0);
}

bool GeneralMethods::closest_points(const SupportPairs& pairs, Vector& of_A1, Vector& of_A2) {
  const int n = problem_->A.dimension();
  of_A1.resize(n);
  of_A2.resize(n);
  if (concluded_ == &nearest_point_) {
    nearest_point_.nearest_points(of_A2.data(), of_A1.data());
    return true;
  }
  if (concluded_ != nullptr) {
    refined_combination_.clear(n);
    concluded_->contact_combination(refined_combination_);
    combination_ = &refined_combination_;
  }
  if (combination_->count() > 0) take_apart(*combination_, pairs, of_A1, of_A2);
  return combination_->count() > 0;
}

}  // namespace raygauge
