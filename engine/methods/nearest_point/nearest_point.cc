// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/nearest_point/nearest_point.h"

#include <algorithm>
#include <cmath>

#include "engine/methods/nearest_point/tuning.h"
#include "engine/numerics/floating_point.h"
#include "engine/numerics/vector_kernels.h"
#include "engine/sets/object_pair.h"
#include "raygauge/sets/ball.h"
#include "raygauge/sets/operations.h"

namespace raygauge {
namespace {

// Entries in a row that bring v no nearer: rounding has the say.
constexpr int kPatience = 16;
// Squares of larger or smaller coordinates leave the range of doubles.
constexpr double kLargestMagnitude = 0x1p300, kSmallestMagnitude = 0x1p-300;

bool is_polytope(const ConvexSet& S) {
  return S.structure() == SupportStructure::polytope || S.structure() == SupportStructure::point;
}

std::int64_t default_limit(int n) { return 1000 + 50 * std::int64_t{n}; }

}  // namespace

NearestPoint::Difference NearestPoint::difference(const ConvexSet& A) {
  if (const auto* sets = dynamic_cast<const MinkowskiDifference*>(&A))
    return {sets->A2().get(), sets->A1().get()};
  if (const auto* pair = dynamic_cast<const ObjectPair*>(&A)) return {&pair->A2(), &pair->A1()};
  return {&A, nullptr};
}

// The structure first: it is asked of every problem, and types are dear to ask.
bool NearestPoint::suits(const ConvexSet& A, const ConvexSet& Q) {
  if (!is_polytope(A)) return false;  // a difference is one if both operands are
  const auto* ball = dynamic_cast<const Ball*>(&Q);
  if (ball == nullptr || !(ball->radius() > 0)) return false;
  Scratch center(Q.dimension());
  ball->center_unchecked(center.data());
  return largest_magnitude(center.data(), Q.dimension()) == 0;
}

void NearestPoint::begin(const Difference& sets_of_A, const Problem& problem) {
  const auto [S, T] = sets_of_A;
  n_ = S->dimension();
  sides_ = T != nullptr ? 2 : 1;
  goal_ = problem.goal();
  radius_ = dynamic_cast<const Ball&>(problem.Q).radius();
  bounds_ = {};
  counters_.outer_iterations = 1;
  const auto size = static_cast<std::size_t>(n_);
  const std::size_t most = size + 3;
  for (auto* buffer : {&shift_, &v_, &u_, &normal_, &shifted_, &zero_, &contact_}) buffer->reserve(size);
  for (auto* buffer : {&weights_, &solution_}) buffer->reserve(most);
  points_.reserve(most * size);
  nearest_.reserve(2 * size);
  const ConvexSet* sets[2] = {S, T};
  kernels_ = &kernels_for(problem.options.instruction_set);
  magnitude_ = square_ = 0;
  std::fill_n(shift_.data(), n_, 0.0);
  std::fill_n(zero_.data(), n_, 0.0);
  for (int t = 0; t < sides_; ++t) {
    Side& side = side_[t];
    side.oracle.bind(*sets[t], nullptr, *kernels_);
    side.points = as_point_set(*sets[t]);
    side.sign = t == 0 ? 1.0 : -1.0;
    side.candidate.reserve(size);
    magnitude_ = std::max(magnitude_, side.oracle.magnitude());
  }
}

// The points of both sides that are farthest towards each other, seen from the centres.
bool NearestPoint::choose_first_points(const double* start) {
  double* u = u_.data();
  side_[0].oracle.center(u);
  if (sides_ == 2) {
    side_[1].oracle.center(shift_.data());
    for (int k = 0; k < n_; ++k) u[k] -= shift_[static_cast<std::size_t>(k)];
  }
  for (int k = 0; k < n_; ++k) u[k] = -u[k];
  if (start != nullptr) std::copy_n(start, n_, u);
  if (!(normalize(u, n_, u) > 0)) u[0] = 1;
  price(true);
  double sigma = 0;
  for (int t = 0; t < sides_; ++t)
    sigma = std::max(sigma, distance_between(side_[t].candidate.data(), shift_.data(), n_));
  if (!(sigma > 0)) return false;
  basis_.begin(n_, sides_, sigma, *kernels_);
  for (int t = 0; t < sides_; ++t) {
    if (!add_candidate(t)) return false;
    weights_[static_cast<std::size_t>(t)] = 1;
  }
  return basis_.solve(solution_.data(), v_.data());
}

// The best point of every side along u: of all, or (`pass` false) of those that the last pass kept.
void NearestPoint::price(bool pass) {
  for (int t = 0; t < sides_; ++t) {
    Side& side = side_[t];
    double* candidate = side.candidate.data();
    if (side.points == nullptr) {
      if (pass) side.best = side.oracle.query(u_.data(), side.sign, candidate);
      continue;
    }
    if (pass) side.oracle.pass(u_.data(), side.sign);
    side.best = side.oracle.query_shortlist(u_.data(), side.sign, candidate);
  }
  if (pass) ++counters_.ray_iterations;
}

// After a change of v: u = -v, and sign u·p of the points with weight, which is the same for all of a side.
void NearestPoint::turn() {
  for (int k = 0; k < n_; ++k) u_[static_cast<std::size_t>(k)] = -v_[static_cast<std::size_t>(k)];
  square_ = dot(v_.data(), v_.data(), n_);
  for (Side& side : side_) side.level = -kInfinity;
  for (int i = 0; i < basis_.count(); ++i) {
    Side& side = side_[basis_.side(i)];
    if (side.level == -kInfinity) side.level = side.sign * dot(u_.data(), point(i), n_);
  }
}

double NearestPoint::gap() const noexcept {
  double sum = 0;
  for (int t = 0; t < sides_; ++t) sum += std::max(side_[t].violation(), 0.0);
  return sum;
}

int NearestPoint::most_violated() const noexcept {
  return sides_ == 2 && side_[1].violation() > side_[0].violation() ? 1 : 0;
}

// What rounding may make of a violation.
double NearestPoint::noise() const noexcept {
  return 8 * kUnitRoundoff * std::sqrt(n_ * square_) * magnitude_;
}

bool NearestPoint::add_candidate(int t) {
  const double* candidate = side_[t].candidate.data();
  for (int k = 0; k < n_; ++k)
    shifted_[static_cast<std::size_t>(k)] =
        side_[t].sign * (candidate[k] - shift_[static_cast<std::size_t>(k)]);
  const int i = basis_.count();
  if (!basis_.add(shifted_.data(), t)) return false;
  std::copy_n(candidate, n_, points_.data() + std::ptrdiff_t{i} * n_);
  weights_[static_cast<std::size_t>(i)] = 0;
  ++counters_.pivots;
  return true;
}

void NearestPoint::remove(int i) {
  const int last = basis_.count() - 1;
  basis_.remove(i);
  std::copy(weights_.data() + i + 1, weights_.data() + last + 1, weights_.data() + i);
  double* points = points_.data();
  std::copy(points + std::ptrdiff_t{i + 1} * n_, points + std::ptrdiff_t{last + 1} * n_,
            points + std::ptrdiff_t{i} * n_);
  ++counters_.pivots;
}

// From the weights towards the nearest point of the affine hulls, as far as no weight becomes negative. False
// once that is all of the way.
bool NearestPoint::step_towards_solution() {
  double* w = weights_.data();
  const double* x = solution_.data();
  double share = 1;
  int blocking = -1;
  for (int i = 0; i < basis_.count(); ++i) {
    if (x[i] > 0) continue;
    const double here = w[i] > 0 ? w[i] / (w[i] - x[i]) : 0.0;
    if (here < share || blocking < 0) {
      share = here;
      blocking = i;
    }
  }
  if (blocking < 0) {
    std::copy_n(x, basis_.count(), w);
    return false;
  }
  for (int i = 0; i < basis_.count(); ++i) w[i] = std::max(w[i] + share * (x[i] - w[i]), 0.0);
  w[blocking] = 0;
  for (int i = basis_.count() - 1; i >= 0; --i) {
    if (w[i] == 0 && (i == blocking || !(x[i] > 0))) remove(i);
  }
  return true;
}

// False where the candidate cannot enter, or the factors have lost their meaning.
bool NearestPoint::enter(int t) {
  if (!add_candidate(t)) return false;
  const double before = square_;
  do {
    if (basis_.count() == 0 || !basis_.solve(solution_.data(), v_.data())) return false;
  } while (step_towards_solution());
  turn();
  idle_ = square_ < before ? 0 : idle_ + 1;
  return true;
}

// What the last pass found worth entering enters. False where nothing could.
bool NearestPoint::enter_shortlisted() {
  int t = most_violated();
  const double worth = tuned::kPointWorthEntering * side_[t].violation();
  if (!enter(t) && (sides_ == 1 || !(side_[1 - t].violation() > noise()) || !enter(1 - t))) return false;
  for (int entered = 1; entered < tuned::kPointsOfOnePass; ++entered) {
    price(false);
    t = most_violated();
    if (side_[t].points == nullptr || !(side_[t].violation() > std::max(worth, noise())) || !enter(t)) break;
  }
  return true;
}

DistanceStatus NearestPoint::iterate(const Problem& problem) {
  const std::int64_t asked = problem.options.max_iterations;
  const std::int64_t limit = asked > 0 ? asked : default_limit(n_);
  idle_ = 0;
  for (;;) {
    turn();
    price(true);
    const double estimate = (square_ - gap()) / (std::sqrt(square_) * radius_);
    const bool decided = estimate > goal_.threshold || std::sqrt(square_) < goal_.threshold * radius_;
    if (decided || gap() <= 0.5 * goal_.tolerance * square_ || gap() <= 2 * noise()) {
      prove();
      if (bounds_.reach(goal_)) return DistanceStatus::optimal;
    }
    if (!(gap() > noise()) || idle_ > kPatience) return DistanceStatus::precision_limit;
    const bool expired = problem.stopwatch.expired();
    if (expired || counters_.pivots >= limit) {
      prove();
      return expired ? DistanceStatus::time_limit : DistanceStatus::iteration_limit;
    }
    if (!enter_shortlisted()) return DistanceStatus::precision_limit;
  }
}

bool NearestPoint::solve(const Problem& problem, DistanceResult& result) {
  counters_ = {};
  if (!suits(problem.A, problem.Q)) return false;
  begin(difference(problem.A), problem);
  if (!(magnitude_ < kLargestMagnitude && magnitude_ > kSmallestMagnitude)) return false;
  if (!choose_first_points(problem.start)) return false;
  const DistanceStatus status = iterate(problem);
  const bool limited = status == DistanceStatus::time_limit ||
                       (status == DistanceStatus::iteration_limit && problem.options.max_iterations > 0);
  if (status != DistanceStatus::optimal && !limited) return false;
  report(status, problem.effects, result);
  return true;
}

void NearestPoint::nearest_points(double* of_S, double* of_T) const {
  std::copy_n(nearest_.data(), n_, of_S);
  std::copy_n(nearest_.data() + n_, n_, of_T);
}

}  // namespace raygauge
