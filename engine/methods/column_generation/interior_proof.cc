// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/column_generation/interior_proof.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/lp/affords.h"
#include "engine/methods/column_generation/face_proof.h"
#include "engine/methods/column_generation/plane_proof.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// A distance that small, in units where both sets have magnitude 1, may be zero.
constexpr double kMaybeZero = 1e-4;

// A method that fails so soon fails for the condition of the points, not of the problem.
constexpr std::int64_t kFewIterations = 12;

// Of the relative gap that is asked for: where a known upper bound is met.
constexpr double kShareOfTolerance = 0.25;

// Of an upper bound: the gap of a method whose columns make a good basis all the same.
constexpr double kNearUpperBound = 1e-3;

// Of the normal that it ends with, where its columns make no basis.
constexpr double kErrorOfNormal = 1e-3;

// Of points of Q with -u·q <= 1, which all are, those with |u·q| up to here may lie in the plane of u on its
// way to infinity.
constexpr double kNearPlane = 30;

// max u·q.
double farthest_of_Q(WorkingSets& sets, const double* u) {
  const double* products = sets.products(sets.Q().pool, u);
  return *std::max_element(products, products + sets.Q().pool.size());
}

}  // namespace

void InteriorProof::begin(WorkingSets& sets) {
  state_ = State::untried;
  separated_ = false;
  ray_.forget();
  method_.share_with(sets.helpers());
}

void InteriorProof::run(const SiftingSolve& solve, const double* guess) {
  const WorkingSets& sets = solve.sets;
  const ColumnPool &A = sets.A().pool, &Q = sets.Q().pool;
  ray_.find(A, Q, sets.n());
  method_.may_pause(sets.is_complete() && !sets.is_restricted());
  method_.end_at((1 - kShareOfTolerance * solve.tolerance) * ray_.upper());
  InteriorPoint::End end =
      method_.solve(A.view(), Q.view(), sets.n(), guess, sets.kernels(), solve.stopwatch);
  const bool soon = method_.iterations() < kFewIterations && !solve.stopwatch.expired();
  if (end == InteriorPoint::End::failed && soon && whitened_.compute(A, Q, sets.n(), solve.stopwatch))
    end = method_.solve_whitened(whitened_, sets.n(), guess, sets.kernels(), solve.stopwatch);
  note(end);
}

void InteriorProof::note(InteriorPoint::End end) {
  separated_ = end == InteriorPoint::End::separated;
  switch (end) {
    case InteriorPoint::End::failed:
      state_ = State::failed;
      break;
    case InteriorPoint::End::paused:
      state_ = State::paused;
      break;
    default:
      state_ = State::converged;
  }
}

bool InteriorProof::certify_separated(const SiftingSolve& solve) {
  if (!separated_ || solve.sets.bound(method_.normal()) != kInfinity) return false;
  write_answer(solve, DistanceStatus::unreachable, kInfinity, kInfinity);
  return true;
}

bool InteriorProof::may_certify(const WorkingSets& sets) const {
  if (!sets.is_complete() || sets.is_restricted()) return false;
  const double upper = ray_.upper();
  if (state_ == State::failed)
    return upper < kInfinity && method_.duals()[sets.n()] >= (1 - kNearUpperBound) * upper;
  return state_ == State::paused ||
         (state_ == State::converged && (upper < kInfinity || method_.is_degenerate()));
}

bool InteriorProof::certify(const SiftingSolve& solve) {
  while (!certify_at_hand(solve)) {
    if (state_ != State::paused) return false;
    note(method_.go_on(solve.stopwatch));
    if (certify_separated(solve)) return true;
  }
  return true;
}

bool InteriorProof::certify_at_hand(const SiftingSolve& solve) {
  const double* y = method_.duals();
  const double distance = std::fabs(y[solve.sets.n()]);
  if (certify_ray(solve)) return true;
  if (distance < kMaybeZero && certify_carriers(solve, 0)) return true;
  if (certify_carriers(solve, distance)) return true;
  if (distance < 1 / kMaybeZero) return false;
  solve.plane.take(y, solve.sets.n());
  return solve.plane.certify(solve, kNearPlane / farthest_of_Q(solve.sets, y)) || solve.plane.certify(solve);
}

// The point of A on a ray with one of Q, where the normal proves that there is no better one.
bool InteriorProof::certify_ray(const SiftingSolve& solve) {
  const double upper = ray_.upper();
  if (!(upper < kInfinity) || !(method_.duals()[solve.sets.n()] >= (1 - solve.tolerance) * upper))
    return false;
  const double lower = bound(solve, 0);
  if (!solve.closes(lower, upper)) return false;
  write_ray(solve, DistanceStatus::optimal, lower);
  return true;
}

// The carriers where d is about `distance`, those of A alone where that is 0.
bool InteriorProof::certify_carriers(const SiftingSolve& solve, double distance) {
  method_.carriers(distance > 0 ? distance : 1.0, carriers_);
  const std::span<const double> duals(method_.duals(), static_cast<std::size_t>(solve.sets.n()) + 1);
  return solve.face.certify(solve, distance, duals, carriers_);
}

void InteriorProof::write_ray(const SiftingSolve& solve, DistanceStatus status, double lower) const {
  write_answer(solve, status, lower, ray_.upper());
  write_estimate(solve, ray_.ratio());
  double* contact = solve.result.room_for_contact(solve.effects, solve.sets.n());
  if (contact == nullptr) return;
  solve.sets.A().pool.copy_point(ray_.point_of_A(), contact);
  solve.sets.to_own_units(contact);
}

double InteriorProof::bound(const SiftingSolve& solve, double lower) const {
  if (state_ == State::untried) return lower;
  const std::vector<double> nothing(static_cast<std::size_t>(solve.sets.n()) + 1, 0.0);
  std::int64_t best_A = 0;
  std::int64_t best_Q = 0;
  const double inside = solve.sets.bound_twofold(method_.duals(), nothing.data(), &best_A, &best_Q);
  if (inside > lower && inside < kInfinity) return inside;
  return solve.sets.bound_twofold(solve.program.normal(), nothing.data(), &best_A, &best_Q);
}

void InteriorProof::start(const SiftingSolve& solve) {
  method_.columns(columns_);
  if (!separated_ && affords_inverse(solve.stopwatch, solve.sets.n() + 1, solve.sets.kernels()) &&
      solve.program.start_from(solve.sets.A().pool, solve.sets.Q().pool, columns_, solve.stopwatch))
    return;
  start_at_normal(solve);
}

void InteriorProof::start_at_normal(const SiftingSolve& solve) const {
  const int n = solve.sets.n();
  double* guess = solve.sets.direction();
  double largest = 0;
  for (int k = 0; k < n; ++k) largest = std::max(largest, std::fabs(method_.normal()[k]));
  for (int k = 0; k < n; ++k) guess[k] = method_.normal()[k] / largest;
  solve.program.start(solve.sets.A().pool, solve.sets.Q().pool, {guess, kErrorOfNormal});
}

}  // namespace raygauge
