// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/distance/newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/floating_point.h"
#include "engine/sets/vector_kernels.h"

namespace raygauge {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kLongestStep = 1.0;  // tangent of the angle that one step may turn u by
constexpr int kShortenings = 10;      // of one step, each to kShorter of it
constexpr double kShorter = 0.4;
constexpr int kFacetTrials = 6;  // in one solve
constexpr int kPatience = 4;     // steps without a better bound
constexpr int kGrowthEvaluations = 24;

int default_evaluation_limit(int n) { return 100 + 10 * n; }

// rᵀ(Σ weight_i ∇²h_i)r over the active pieces.
double curvature_along(const PieceList& list, const double* r) {
  if (!list.curved) return 0;
  double sum = 0;
  for (int a = 0; a < list.active_count; ++a) {
    const int i = list.active[static_cast<std::size_t>(a)];
    const double weight = list.weight[static_cast<std::size_t>(i)];
    for (int j = 0; j < list.n; ++j)
      sum += weight * r[j] * dot(list.hessian(i) + std::ptrdiff_t{j} * list.n, r, list.n);
  }
  return sum;
}

// Σ weight_i s_i over the active pieces; returns Σ weight_i |s_i|₁, the scale of its rounding errors.
double combine(const PieceList& list, double* point) {
  double size = 0;
  std::fill_n(point, list.n, 0.0);
  for (int a = 0; a < list.active_count; ++a) {
    const int i = list.active[static_cast<std::size_t>(a)];
    const double weight = list.weight[static_cast<std::size_t>(i)];
    for (int k = 0; k < list.n; ++k) {
      point[k] += weight * list.point(i)[k];
      size += weight * std::fabs(list.point(i)[k]);
    }
  }
  return size;
}

}  // namespace

bool Newton::begin(const ConvexSet& A, const ConvexSet& Q, const DistanceOptions& options) {
  n_ = A.dimension();
  const auto size = static_cast<std::size_t>(n_);
  for (auto* buffer : {&center_, &linear_, &target_, &normal_, &contact_, &residual_vector_, &descent_,
                       &points_[0].u, &points_[1].u}) {
    buffer->reserve(size);
  }
  lower_ = 0;
  upper_ = kInfinity;
  combination_.clear(n_);
  evaluations_ = 0;
  facets_tried_ = 0;
  on_facet_ = false;
  tolerance_ = options.tolerance;
  max_evaluations_ = options.max_iterations > 0 ? options.max_iterations : default_evaluation_limit(n_);
  program_.begin(n_);
  std::fill_n(target_.data(), n_, 0.0);
  inner_radius_ = Q.inner_radius_unchecked(target_.data());
  if (!(inner_radius_ > 0)) return false;
  const Kernels& kernels = kernels_for(options.instruction_set);
  if (!oracle_A_.bind(A, 1.0, kernels) || !oracle_Q_.bind(Q, -1.0, kernels)) return false;
  now_ = &points_[0];
  next_ = &points_[1];
  A.center_unchecked(center_.data());
  for (int k = 0; k < n_; ++k) now_->u[static_cast<std::size_t>(k)] = -center_[static_cast<std::size_t>(k)];
  return normalize(now_->u.data(), n_, now_->u.data()) > 0;
}

bool Newton::evaluate(Point& point) {
  const double* u = point.u.data();
  if (!oracle_A_.evaluate(u, point.A) || !oracle_Q_.evaluate(u, point.Q)) return false;
  point.A.warm = point.Q.warm = false;
  ++evaluations_;
  const double h_A = point.A.support.value;
  const double h_Q = point.Q.support.value;
  if (growing_) {
    const double along = -dot(center_.data(), u, n_);
    point.ratio = along / (h_A + along + h_Q);
  } else {
    point.ratio = -h_A / h_Q;
  }
  bound_from_below(point);
  return true;
}

void Newton::bound_from_below(const Point& point) {
  const double bound = lower_bound(point.A.support, point.Q.support);
  if (!(bound > lower_)) return;
  lower_ = bound;
  const double length = 1 / point.Q.support.value;
  for (int k = 0; k < n_; ++k)
    normal_[static_cast<std::size_t>(k)] = point.u[static_cast<std::size_t>(k)] * length;
}

// The combinations x of A and y of Q with the weights of the step leave r = x - ρy; x = ρy + r costs no more
// than ρ + gauge_Q(r), if ρ >= 0.
void Newton::bound_from_above() {
  if (!(now_->ratio >= 0)) return;
  double* x = target_.data();
  double* y = linear_.data();
  const double size = combine(now_->A, x) + now_->ratio * combine(now_->Q, y);
  for (int k = 0; k < n_; ++k) residual_vector_[static_cast<std::size_t>(k)] = x[k] - now_->ratio * y[k];
  residual_ = length(residual_vector_.data(), n_);
  const double rounding =
      std::sqrt(n_) * (oracle_A_.coordinate_error() + now_->ratio * oracle_Q_.coordinate_error()) +
      (n_ + now_->A.active_count + now_->Q.active_count + 8) * kEpsilon * size;
  const double bound = (now_->ratio + (residual_ + rounding) / inner_radius_) * (1 + (n_ + 16) * kEpsilon);
  if (!(bound < upper_)) return;
  upper_ = bound;
  std::copy_n(x, n_, contact_.data());
  if (!keeps_combination_) return;
  combination_.clear(n_);
  for (int a = 0; a < now_->A.active_count; ++a) {
    const int i = now_->A.active[static_cast<std::size_t>(a)];
    combination_.add(now_->A.point(i), now_->A.weight[static_cast<std::size_t>(i)]);
  }
}

void Newton::contact_combination(WeightedPoints& combination) const {
  for (int i = 0; i < combination_.count(); ++i)
    combination.add(combination_.point(i), combination_.weight(i));
}

bool Newton::is_closed() const noexcept {
  if (lower_ > threshold_ || upper_ < threshold_) return true;
  return raygauge::is_closed(lower_, upper_, tolerance_);
}

PieceProgram::Objective Newton::objective() {
  const double ratio = now_->ratio;
  if (!growing_) return {1.0, ratio, nullptr};
  for (int k = 0; k < n_; ++k) {
    linear_[static_cast<std::size_t>(k)] = (1 - ratio) * center_[static_cast<std::size_t>(k)];
  }
  return {ratio, ratio, linear_.data()};
}

bool Newton::accepts(const Point& candidate) const {
  const double h_Q = candidate.Q.support.value;
  const double noise = 2 * (candidate.A.support.error + candidate.ratio * candidate.Q.support.error) / h_Q;
  return candidate.ratio >= now_->ratio - (noise > 0 ? noise : 0.0) ||
         (growing_ && candidate.A.support.above() < 0);
}

// The candidate becomes the current point; with its predecessor's weights if the pieces are the same.
void Newton::keep(bool weights) {
  std::swap(now_, next_);
  on_facet_ = !weights;
  if (!weights) return;
  for (const auto list : {&Point::A, &Point::Q}) {
    const PieceList& old = next_->*list;
    PieceList& list_now = now_->*list;
    if (old.count > list_now.count) continue;
    std::fill_n(list_now.weight.data(), list_now.count, 0.0);
    std::copy_n(old.weight.data(), old.count, list_now.weight.data());
    list_now.warm = true;
  }
}

// The normal of a flat face near the way, and at it the point of the face that is nearest to where the other
// set touches.
bool Newton::try_facet(const double* step) {
  if (growing_ || facets_tried_ >= kFacetTrials) return false;
  double* end = linear_.data();
  for (int k = 0; k < n_; ++k) end[k] = now_->u[static_cast<std::size_t>(k)] + step[k];
  const bool of_A = oracle_A_.facet_normal(now_->u.data(), end, next_->u.data());
  if (!of_A && !oracle_Q_.facet_normal(now_->u.data(), end, next_->u.data())) return false;
  ++facets_tried_;
  normalize(next_->u.data(), n_, next_->u.data());
  if (!evaluate(*next_) || !(next_->ratio > 0) || !accepts(*next_)) return false;
  PieceList& touching = of_A ? next_->Q : next_->A;
  const double scale = of_A ? next_->ratio : 1 / next_->ratio;
  const double* touched = touching.point(touching.best);
  for (int k = 0; k < n_; ++k) end[k] = scale * touched[k];
  if (of_A) {
    oracle_A_.settle_on_facet(next_->u.data(), end, next_->A);
  } else {
    oracle_Q_.settle_on_facet(next_->u.data(), end, next_->Q);
  }
  keep(false);
  return true;
}

// At the normal of a face φ has a kink that no Hessian describes, but r, with the point of the face nearest
// to the other set, is its subgradient of least length: -r leads down, as far as the curvature along it says.
const double* Newton::leave_facet() {
  const double* r = residual_vector_.data();
  const double curvature = curvature_along(now_->A, r) + now_->ratio * curvature_along(now_->Q, r);
  const double length = curvature > 0 ? residual_ * residual_ / curvature : 1 / residual_;
  for (int k = 0; k < n_; ++k) descent_[static_cast<std::size_t>(k)] = -length * r[k];
  return descent_.data();
}

bool Newton::advance(const double* step) {
  if (on_facet_) {
    step = leave_facet();
  } else if (try_facet(step)) {
    return true;
  }
  const double length = std::sqrt(dot(step, step, n_));
  double share = length > kLongestStep ? kLongestStep / length : 1.0;
  for (int trial = 0; trial < kShortenings; ++trial) {
    for (int k = 0; k < n_; ++k) {
      next_->u[static_cast<std::size_t>(k)] = now_->u[static_cast<std::size_t>(k)] + share * step[k];
    }
    normalize(next_->u.data(), n_, next_->u.data());
    if (!evaluate(*next_)) return false;
    if (accepts(*next_)) {
      keep(true);
      return true;
    }
    if (evaluations_ >= max_evaluations_) return false;
    share *= kShorter;
  }
  return false;
}

DistanceStatus Newton::iterate(const Stopwatch& stopwatch) {
  growing_ = false;
  if (!evaluate(*now_)) return DistanceStatus::precision_limit;
  growing_ = !(now_->ratio > 0);
  if (growing_) {
    const double along = -dot(center_.data(), now_->u.data(), n_);
    now_->ratio = along / (now_->A.support.value + along + now_->Q.support.value);
  }
  int idle = 0;
  double least_residual = kInfinity;
  for (;;) {
    if (lower_ > threshold_) return DistanceStatus::optimal;
    const double* step = program_.solve(now_->u.data(), objective(), now_->A, now_->Q);
    if (step == nullptr) return DistanceStatus::precision_limit;
    if (!growing_) {
      bound_from_above();
      if (is_closed()) return DistanceStatus::optimal;
      idle = residual_ < 0.5 * least_residual ? 0 : idle + 1;
      least_residual = std::min(least_residual, residual_);
      if (idle > kPatience + 4) return DistanceStatus::precision_limit;
    } else if (evaluations_ > kGrowthEvaluations) {
      return DistanceStatus::precision_limit;
    }
    if (evaluations_ >= max_evaluations_) return DistanceStatus::iteration_limit;
    if (stopwatch.expired()) return DistanceStatus::time_limit;
    if (!advance(step)) return DistanceStatus::precision_limit;
    if (growing_ && now_->A.support.above() < 0) {
      growing_ = false;
      now_->ratio = -now_->A.support.value / now_->Q.support.value;
    }
  }
}

bool Newton::solve(const ConvexSet& A, const ConvexSet& Q, const DistanceOptions& options,
                   const Stopwatch& stopwatch, Effects effects, DistanceResult& result) {
  if (!begin(A, Q, options)) return false;
  const DistanceStatus status = iterate(stopwatch);
  // The default limit is a guard: beyond it, and where nothing got better, `direct` has other means.
  const bool limited = status == DistanceStatus::time_limit ||
                       (status == DistanceStatus::iteration_limit && options.max_iterations > 0);
  if (status != DistanceStatus::optimal && !limited) return false;
  report(status, effects, result);
  return true;
}

void Newton::report(DistanceStatus status, Effects effects, DistanceResult& result) const {
  result.status = status;
  result.lower = lower_;
  result.upper = upper_;
  result.distance = lower_;
  result.normal.resize(n_);
  std::copy_n(lower_ > 0 ? normal_.data() : now_->u.data(), n_, result.normal.data());
  DistanceCounters counters;
  counters.outer_iterations = 1;
  counters.ray_iterations = evaluations_;
  counters.support_queries = 2 * evaluations_;
  counters.pivots = program_.systems();
  if (double* contact = result.room_for_contact(effects, n_)) {
    std::copy_n(contact_.data(), n_, contact);
    ++counters.witness_evaluations;
  }
  result.counters = counters;
}

}  // namespace raygauge
