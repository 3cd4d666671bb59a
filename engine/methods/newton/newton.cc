// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/newton/newton.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "engine/lp/affords.h"
#include "engine/methods/newton/tuning.h"
#include "engine/numerics/floating_point.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/capability_queries.h"

namespace raygauge {
namespace {

constexpr double kShift = 4;      // δR in rounding errors of a combination
constexpr int kShortenings = 10;  // of one step, of which see tuning.h
constexpr int kGrowthEvaluations = 24;

// Whether it is worth going on: far from the end the ratio rises while the residual may even grow, close to
// it the residual falls.
template <class Real>
class Progress {
 public:
  bool is_made(Real ratio, Real residual) {
    constexpr double kHigher = 1.01, kSmaller = 0.5;
    constexpr int kPatience = 8;
    const bool higher = ratio > kHigher * highest_ratio_;
    idle_ = higher || residual < kSmaller * least_residual_ ? 0 : idle_ + 1;
    if (higher) highest_ratio_ = ratio;
    least_residual_ = std::min(least_residual_, residual);
    return idle_ <= kPatience;
  }

 private:
  Real highest_ratio_ = 0;
  Real least_residual_ = kInfinity;
  int idle_ = 0;
};

// Quadruple precision begins where doubles ended, and its evaluations take a hundred times as long.
template <class Real>
int default_evaluation_limit(int n) {
  return std::is_same_v<Real, double> ? 100 + 10 * n : 60;
}

// Of a quadratic program, for n³, in those of doubles in vectors.
template <class Real>
constexpr double kStepOperations = std::is_same_v<Real, double> ? 4 : 200;

template <class Real>
constexpr double kSetUpOperations = std::is_same_v<Real, double> ? 0 : 800;

// Where there is no time for a step: doubles are the first to be asked, and others may do better than
// quadruple precision in what is left.
template <class Real>
constexpr DistanceStatus kNoTime =
    std::is_same_v<Real, double> ? DistanceStatus::time_limit : DistanceStatus::precision_limit;

bool is_smooth(const ConvexSet& S) { return S.structure() == SupportStructure::smooth; }

}  // namespace

template <class Real>
bool ResidualBall<Real>::choose(const ConvexSet& Q, Real rounding) {
  const int n = Q.dimension();
  center_.reserve(static_cast<std::size_t>(n));
  shift_ = 0;
  std::fill_n(center_.data(), n, 0.0);
  radius_ = Q.inner_radius_unchecked(center_.data());
  if (radius_ > 0) return true;
  if constexpr (std::is_same_v<Real, double>) return false;
  Q.center_unchecked(center_.data());
  radius_ = Q.inner_radius_unchecked(center_.data());
  if (!(radius_ > 0)) return false;
  shift_ = kRoundoff<Real>;  // never zero, even if A is known exactly: a ball elsewhere covers nothing else
  enlarge_shift(rounding);
  return true;
}

template <class Real>
void ResidualBall<Real>::enlarge_shift(Real rounding) {
  shift_ = std::max(shift_, kShift * rounding / radius_);
}

template <class Real>
Real ResidualBall<Real>::shifted(Real value, const Real* u, int n) const {
  return shift_ > 0 ? value - shift_ * dot(u, center_.data(), n) : value;
}

template <class Real>
bool Newton<Real>::begin(const Problem& problem) {
  const ConvexSet& A = problem.A;
  const ConvexSet& Q = problem.Q;
  n_ = A.dimension();
  const auto size = static_cast<std::size_t>(n_);
  for (auto* buffer : {&center_, &normal_, &contact_, &point_}) buffer->reserve(size);
  for (auto* buffer : {&linear_, &target_, &residual_vector_, &descent_, &points_[0].u, &points_[1].u}) {
    buffer->reserve(size);
  }
  bounds_ = {};
  estimate_ = 0;
  residual_ = kInfinity;
  combination_.clear(n_);
  evaluations_ = 0;
  witness_evaluations_ = 0;
  facets_tried_ = 0;
  on_facet_ = false;
  goal_ = problem.goal();
  keeps_combination_ = problem.pairs != nullptr;
  const std::int64_t limit = problem.options.max_iterations;
  max_evaluations_ = limit > 0 ? limit : default_evaluation_limit<Real>(n_);
  program_.begin(n_);
  // Quadruple precision takes that long before its first step.
  if (!affords(problem.stopwatch, kSetUpOperations<Real> * cube(n_))) return false;
  if (!std::is_same_v<Real, double> && !is_smooth(A) && !is_smooth(Q)) return false;
  const Kernels& kernels = kernels_for(problem.options.instruction_set);
  if (!oracle_A_.bind(A, 1.0, kernels, problem.pairs) || !oracle_Q_.bind(Q, -1.0, kernels)) return false;
  if (!ball_.choose(Q, coordinate_rounding(0))) return false;
  now_ = &points_[0];
  next_ = &points_[1];
  A.center_unchecked(center_.data());
  graded_ = unconditional_ = pair_.bind(A, Q);
  if (problem.start != nullptr) {
    std::copy_n(problem.start, n_, now_->u.data());
  } else {
    choose_start(Q);
  }
  return normalize(now_->u.data(), n_, now_->u.data()) > 0;
}

// Against the normal of Q where the ray to the centre of A leaves it, if Q knows that, or against the ray.
template <class Real>
void Newton<Real>::choose_start(const ConvexSet& Q) {
  Real* u = now_->u.data();
  std::copy_n(center_.data(), n_, u);
  if constexpr (std::is_same_v<Real, double>) {
    if (unconditional_ && gauge_bound(Q, u, target_.data()) < kInfinity) std::copy_n(target_.data(), n_, u);
  } else {
    if (gauge_normal(Q, u, target_.data())) std::copy_n(target_.data(), n_, u);
  }
  for (int k = 0; k < n_; ++k) u[k] = -u[k];
}

// That of a combination, in length.
template <class Real>
Real Newton<Real>::coordinate_rounding(Real ratio) const {
  return std::sqrt(n_) * (oracle_A_.coordinate_error() + ratio * oracle_Q_.coordinate_error());
}

// Of the phase.
template <class Real>
Real Newton<Real>::ratio_of(const Point& point) const {
  const Real* u = point.u.data();
  const Real h_A = point.A.support.value, h_Q = point.Q.support.value;
  if (!growing_) return -ball_.shifted(h_A, u, n_) / h_Q;
  const Real along = -dot(u, center_.data(), n_);
  return along / (h_A + along + h_Q);
}

template <class Real>
bool Newton<Real>::evaluate(Point& point) {
  const Real* u = point.u.data();
  if (!oracle_A_.evaluate(u, point.A) || !oracle_Q_.evaluate(u, point.Q)) return false;
  if (graded_ && point.A.count + point.Q.count > 2) {
    graded_ = false;  // where pieces meet the system is not definite
    set_growing(growing_);
    return evaluate(point);
  }
  point.A.warm = point.Q.warm = false;
  ++evaluations_;
  point.ratio = ratio_of(point);
  if (ball_.shift() > 0) ball_.enlarge_shift(coordinate_rounding(point.ratio));
  bound_by_ratio(point);
  return true;
}

template <class Real>
void Newton<Real>::bound_by_ratio(const Point& point) {
  if (!bounds_.raise_lower(lower_bound(point.A.support, point.Q.support))) return;
  estimate_ = static_cast<double>(point.ratio);
  const Real length = 1 / point.Q.support.value;
  for (int k = 0; k < n_; ++k)
    normal_[static_cast<std::size_t>(k)] = static_cast<double>(point.u[static_cast<std::size_t>(k)] * length);
}

template <class Real>
void Newton<Real>::contact_combination(WeightedPoints& combination) const {
  for (int i = 0; i < combination_.count(); ++i)
    combination.add(combination_.point(i), combination_.weight(i));
}

template <class Real>
typename QuadraticProgram<Real>::Objective Newton<Real>::objective() {
  const Real ratio = now_->ratio;
  if (!growing_ && !(ball_.shift() > 0)) return {1, ratio, nullptr, graded_};
  const double* along = growing_ ? center_.data() : ball_.center();
  const Real factor = growing_ ? 1 - ratio : -ball_.shift();
  for (int k = 0; k < n_; ++k) linear_[static_cast<std::size_t>(k)] = factor * along[k];
  return {growing_ ? ratio : Real{1}, ratio, linear_.data(), graded_ && !growing_};
}

template <class Real>
bool Newton<Real>::accepts(const Point& candidate) const {
  const Real h_Q = candidate.Q.support.value;
  const Real noise = 2 * (candidate.A.support.error + candidate.ratio * candidate.Q.support.error) / h_Q;
  return candidate.ratio >= now_->ratio - (noise > 0 ? noise : Real{0}) ||
         (growing_ && candidate.A.support.above() < 0);
}

// The candidate becomes the current point; with its predecessor's weights if the pieces are the same.
template <class Real>
void Newton<Real>::keep(bool weights) {
  std::swap(now_, next_);
  on_facet_ = !weights;
  if (!weights) return;
  for (const auto list : {&Point::A, &Point::Q}) {
    const PieceList<Real>& old = next_->*list;
    PieceList<Real>& list_now = now_->*list;
    if (old.count > list_now.count) continue;
    std::fill_n(list_now.weight.data(), list_now.count, Real{0});
    std::copy_n(old.weight.data(), old.count, list_now.weight.data());
    list_now.warm = true;
  }
}

// next_->u, so far along the step.
template <class Real>
void Newton<Real>::move(const Real* step, Real share, bool flat) {
  const Real* u = now_->u.data();
  Real* next = next_->u.data();
  if (unconditional_ && !growing_) {
    pair_.advance(u, step, share, flat, next);
  } else {
    for (int k = 0; k < n_; ++k) next[k] = u[k] + share * step[k];
  }
  normalize(next, n_, next);
}

template <class Real>
bool Newton<Real>::advance(const Real* step, const Stopwatch& stopwatch) {
  if (on_facet_) {
    step = leave_facet();
  } else if (try_facet(step)) {
    return true;
  }
  const Real length = elementary::sqrt(dot(step, step, n_));
  Real share = length > tuned::kLongestNewtonStep ? tuned::kLongestNewtonStep / length : Real{1};
  bool flat = unconditional_ && pair_.has_flats();
  for (int trial = 0; trial < kShortenings; ++trial) {
    move(step, share, flat);
    if (!evaluate(*next_)) return false;
    if (accepts(*next_)) {
      keep(true);
      return true;
    }
    if (evaluations_ >= max_evaluations_ || stopwatch.expired()) return false;
    if (!flat) share *= tuned::kShorterNewtonStep;
    flat = false;
  }
  return false;
}

template <class Real>
void Newton<Real>::set_growing(bool growing) {
  growing_ = growing;
  oracle_A_.grade(graded_ && !growing);
  oracle_Q_.grade(graded_ && !growing);
}

template <class Real>
DistanceStatus Newton<Real>::iterate(const Stopwatch& stopwatch) {
  set_growing(false);
  if (!evaluate(*now_)) return DistanceStatus::precision_limit;
  set_growing(!(now_->ratio > 0));
  if (growing_) now_->ratio = ratio_of(*now_);
  Progress<Real> progress;
  for (;;) {
    if (bounds_.lower() > goal_.threshold) return DistanceStatus::optimal;
    if (unconditional_ && !growing_) {
      pair_.move_contact_along_faces(now_->u.data(), now_->ratio, ball_.shift(), ball_.center(), now_->A,
                                     now_->Q);
    }
    if (!affords(stopwatch, kStepOperations<Real> * cube(n_))) return kNoTime<Real>;
    const Real* step = program_.solve(now_->u.data(), objective(), now_->A, now_->Q);
    if (step == nullptr) return DistanceStatus::precision_limit;
    if (!growing_) {
      bound_by_weights();
      if (bounds_.reach(goal_)) return DistanceStatus::optimal;
      if (!progress.is_made(now_->ratio, residual_)) return DistanceStatus::precision_limit;
    } else if (evaluations_ > kGrowthEvaluations) {
      return DistanceStatus::precision_limit;
    }
    if (evaluations_ >= max_evaluations_) return DistanceStatus::iteration_limit;
    if (stopwatch.expired()) return DistanceStatus::time_limit;
    if (!advance(step, stopwatch)) {
      return stopwatch.expired() ? DistanceStatus::time_limit : DistanceStatus::precision_limit;
    }
    if (growing_ && now_->A.support.above() < 0) {
      set_growing(false);
      now_->ratio = ratio_of(*now_);
    }
  }
}

template <class Real>
bool Newton<Real>::solve(const Problem& problem, DistanceResult& result) {
  if (!begin(problem)) return false;
  const DistanceStatus status = iterate(problem.stopwatch);
  // The default limit is a guard: beyond it, and where nothing got better, column generation has other means.
  const bool limited = status == DistanceStatus::time_limit ||
                       (status == DistanceStatus::iteration_limit && problem.options.max_iterations > 0);
  if (status != DistanceStatus::optimal && !limited) return false;
  write(status, problem.effects, result);
  return true;
}

template <class Real>
void Newton<Real>::write(DistanceStatus status, Effects effects, DistanceResult& result) {
  write_bounds(bounds_, estimate_, status, result);
  result.normal.resize(n_);
  for (int k = 0; k < n_; ++k) {
    result.normal[k] = bounds_.lower() > 0 ? normal_[static_cast<std::size_t>(k)]
                                           : static_cast<double>(now_->u[static_cast<std::size_t>(k)]);
  }
  if (double* contact = result.room_for_contact(effects, n_)) {
    std::copy_n(contact_.data(), n_, contact);
    ++witness_evaluations_;
  }
  result.counters = counters();
}

template <class Real>
DistanceCounters Newton<Real>::counters() const {
  DistanceCounters counters;
  counters.outer_iterations = evaluations_ > 0 ? 1 : 0;
  counters.ray_iterations = evaluations_;
  counters.support_queries = 2 * evaluations_;
  counters.pivots = program_.systems();
  counters.witness_evaluations = witness_evaluations_;
  return counters;
}

template class Newton<double>;
template class Newton<Quad>;

}  // namespace raygauge
