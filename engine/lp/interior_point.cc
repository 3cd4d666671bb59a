// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/interior_point.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>

#include "engine/lp/affords.h"
#include "engine/lp/tuning.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

constexpr int kIterations = 60;
constexpr int kIterationsOfFew = 35;  // separates by then, or nears an optimum
// x·s per unit of t where the solve ends: if just n + 1 columns carry weight, and at the latest.
constexpr double kDecided = 1e-5;
constexpr double kConverged = 1e-11;
// The same where a few columns stay undecided: one for so many dimensions.
constexpr double kNearlyConverged = 1e-8;
constexpr int kForEachTie = 200;
// Where both sets have magnitude 1: t and x·s below which they do not, and t above.
constexpr double kMostlyZero = 1e-3;
constexpr double kMostlyFar = 1e3;
// Where both sets have magnitude 1: a t, and x·s, that may be those of the distance 0; a t that may be on its
// way to infinity, and how much farther it goes between two pauses.
constexpr double kNearZero = 1e-5;
constexpr double kFar = 1e5;
constexpr double kFarther = 100;
constexpr double kShortest = 1e-6;  // a step below makes no progress
constexpr double kFirstSupport = 0.5;
// Points of both sets for each dimension, from which on Q mostly reaches A. Of fewer the question is
// whether it does: what takes the way along the centre sooner to an optimum shows that there is none later.
constexpr double kSpread = 4;
constexpr double kLeastSum = 1.0;
constexpr double kMostSum = 1e6;
// Columns that weigh less than this share of the (n + 1)st heaviest are left out of the matrix: a little of
// each step is lost, and made up for by the next. Where steps become short, more is kept.
constexpr double kLeastNegligible = 1e-5;
constexpr double kShortStep = 0.1;
constexpr double kMoreKept = 0.1;

// From the products of the points with the guess g in s: a μ so large that weights μ / s within a factor of 2
// of each other can move the mean of Q's points to where A is, Σβ of some |mean g·a| / rms g·q. That saves
// 3 of 24 iterations at n = 400, N = 1200, but where no weights do it, it hides that there are none.
double central_weight(const InteriorSide& A, const InteriorSide& Q) {
  double mean_A = 0;
  double square_Q = 0;
  for (std::size_t i = 0; i < A.size; ++i) mean_A += A.s[i];
  for (std::size_t j = 0; j < Q.size; ++j) square_Q += Q.s[j] * Q.s[j];
  const auto size_Q = static_cast<double>(Q.size);
  const double far = std::fabs(mean_A) / static_cast<double>(A.size);
  const double rms = std::sqrt(square_Q / size_Q);
  return std::clamp(kSpread * far / rms, kLeastSum, kMostSum) / size_Q;
}

// Of a pair x, s one goes to zero: compared in the units of each, x about 1 in A and s about d, and the
// other way round in Q. Above 1: the column carries weight.
double weight_over_slack(const InteriorSide& side, std::size_t i, double unit) {
  const double ratio = side.x[i] / side.s[i];
  return side.is_A() ? ratio * unit : ratio / unit;
}

}  // namespace

InteriorPoint::End InteriorPoint::solve_whitened(const WhitenedPoints& points, int n, const double* guess,
                                                 const Kernels& kernels, const Stopwatch& stopwatch) {
  std::vector<double> turned(guess, guess + n);
  points.turn(turned.data());
  begin(points.A(), points.Q(), n, turned.data(), kernels);
  whitened_ = &points;
  return run(stopwatch);
}

InteriorPoint::End InteriorPoint::solve(const PricedPoints& A, const PricedPoints& Q, int n,
                                        const double* guess, const Kernels& kernels,
                                        const Stopwatch& stopwatch) {
  begin(A, Q, n, guess, kernels);
  whitened_ = nullptr;
  return run(stopwatch);
}

InteriorPoint::End InteriorPoint::go_on(const Stopwatch& stopwatch) { return run(stopwatch); }

void InteriorPoint::begin(const PricedPoints& A, const PricedPoints& Q, int n, const double* guess,
                          const Kernels& kernels) {
  n_ = n;
  width_ = kernels.width;
  iterations_ = 0;
  paused_at_zero_ = false;
  next_pause_ = kFar;
  sides_[0].bind(A, 1.0);
  sides_[1].bind(Q, -1.0);
  count_ = A.size + Q.size;
  many_ = count_ >= tuned::kManyPointsInside * n;
  negligible_ = tuned::kNegligibleColumns;
  const auto size = static_cast<std::size_t>(n) + 1;
  y_.reserve(size);
  duals_.reserve(size);
  passes_.begin(n, many_, kernels);
  step_.begin(n, kernels, sides_);
  start(guess);
}

InteriorPoint::End InteriorPoint::run(const Stopwatch& stopwatch) {
  const End end = iterate(stopwatch);
  std::copy_n(y_.data(), n_ + 1, duals_.data());
  if (whitened_ == nullptr) return end;
  whitened_->turn_back(duals_.data());
  return Eigen::Map<const Eigen::VectorXd>(duals_.data(), n_).allFinite() ? end : End::failed;
}

InteriorPoint::End InteriorPoint::iterate(const Stopwatch& stopwatch) {
  const double& t = y_[static_cast<std::size_t>(n_)];
  const int limit = many_ ? kIterations : kIterationsOfFew;
  const double operations = static_cast<double>(n_) * n_ * (0.5 * static_cast<double>(count_) + n_) / width_;
  StepTimes steps;
  const auto nears_an_optimum = [&] { return t > 0 && complementarity(sides_) < t; };
  while (iterations_ < limit || (iterations_ < kIterations && nears_an_optimum())) {
    ++iterations_;
    if (stopwatch.expired() || !steps.affords_next(stopwatch, operations)) return End::failed;
    const double negligible = many_ ? negligible_ : 0.0;
    if (passes_.is_single() && !step_.factor(sides_, passes_, negligible))
      passes_.leave_single(sides_, y_.data());
    if (!passes_.is_single() && !step_.factor(sides_, passes_, negligible)) {
      const bool close = t > 0 && complementarity(sides_) <= kDecided * t;
      return close ? End::converged : End::failed;
    }
    const double length = step_.take(sides_, passes_, y_.data(), many_);
    if (length < kShortStep) negligible_ = std::max(kLeastNegligible, kMoreKept * negligible_);
    if (!(length > kShortest) && passes_.is_single()) {
      passes_.leave_single(sides_, y_.data());
      continue;
    }
    if (!(length > kShortest) || !(t < kInfinity)) return End::failed;
    if (is_separating()) return End::separated;
    const double gap = complementarity(sides_);
    const double scale = std::fabs(t);
    const bool moderate = scale + gap > kMostlyZero && t < std::min(kMostlyFar, enough_);
    if (!(gap > tuned::kCoarseProducts * scale) || !moderate) passes_.leave_single(sides_, y_.data());
    if (!moderate) negligible_ = 0;  // on the way to 0 or to infinity every column counts
    if (t >= enough_) return End::converged;
    if (gap <= kConverged * scale) return End::converged;
    if (gap <= kDecided * scale && undecided() <= (gap <= kNearlyConverged * scale ? most_undecided() : 0))
      return End::converged;
    if (may_pause_ && pauses(gap)) return End::paused;
  }
  return End::failed;
}

// How many columns more or fewer than n + 1 carry weight.
int InteriorPoint::undecided() const {
  const double unit = std::fabs(y_[static_cast<std::size_t>(n_)]);
  int count = 0;
  for (const InteriorSide& side : sides_) {
    for (std::size_t i = 0; i < side.size; ++i) count += weight_over_slack(side, i, unit) > 1 ? 1 : 0;
  }
  return std::abs(count - (n_ + 1));
}

// As many may be near ties, which dual simplex steps decide.
int InteriorPoint::most_undecided() const { return many_ ? n_ / kForEachTie : 0; }

// Whether the iterate is close to zero, for the first time, or has come so far that no distance may exist.
bool InteriorPoint::pauses(double gap) {
  const double t = y_[static_cast<std::size_t>(n_)];
  if (t >= next_pause_) {
    while (t >= next_pause_) next_pause_ *= kFarther;
    return true;
  }
  if (paused_at_zero_ || !(std::fabs(t) + gap < kNearZero)) return false;
  paused_at_zero_ = true;
  return true;
}

// The guess g, scaled so that Q keeps half of its bound, t below what A allows, and weights x = μ / s.
void InteriorPoint::start(const double* guess) {
  double* u = y_.data();
  auto& [A, Q] = sides_;
  for (InteriorSide& side : sides_) passes_.price(side, guess, side.s.data());
  double h_A = -kInfinity;
  double h_Q = -kInfinity;  // h_Q(-g)
  for (std::size_t i = 0; i < A.size; ++i) h_A = std::max(h_A, A.s[i]);
  for (std::size_t j = 0; j < Q.size; ++j) h_Q = std::max(h_Q, -Q.s[j]);
  double largest = 0;
  for (int k = 0; k < n_; ++k) largest = std::max(largest, std::fabs(guess[k]));
  const double length = kFirstSupport / std::max(h_Q, 1e-3 * largest);
  for (int k = 0; k < n_; ++k) u[k] = length * guess[k];
  const auto size_A = static_cast<double>(A.size);
  double mu = many_ ? central_weight(A, Q) : 0.0;
  u[n_] = -length * h_A - (many_ ? mu * size_A : std::max(1.0, 0.1 * std::fabs(length * h_A)));
  for (InteriorSide& side : sides_) passes_.compute_slacks(side, u);
  for (std::size_t i = 0; i < A.size && !many_; ++i) mu += A.s[i] / (size_A * size_A);
  for (InteriorSide& side : sides_) {
    for (std::size_t i = 0; i < side.lanes; ++i) side.x[i] = i < side.size ? mu / side.s[i] : 0.0;
  }
}

// u·q > 0 for every q, by a margin far above rounding errors, and u·a < 0: t > 0 means it. Half of the sets
// of n + 2 points leave 1e-8.
bool InteriorPoint::is_separating() const {
  const double margin = passes_.is_single() ? 1e-6 : 1e-10;
  const double t = y_[static_cast<std::size_t>(n_)];
  if (!(t > 0)) return false;
  double least = kInfinity;
  const InteriorSide& Q = sides_[1];
  for (std::size_t j = 0; j < Q.size; ++j) least = std::min(least, Q.s[j]);
  double largest = 0;
  for (int k = 0; k < n_; ++k) largest = std::max(largest, std::fabs(y_[static_cast<std::size_t>(k)]));
  return least - 1 > margin * largest;
}

void InteriorPoint::carriers(double unit, std::vector<Carrier>& carriers) const {
  carriers.clear();
  for (const InteriorSide& side : sides_) {
    for (std::size_t i = 0; i < side.size; ++i) {
      if (weight_over_slack(side, i, unit) > 1) carriers.push_back({side.id(i), side.x[i]});
    }
  }
}

void InteriorPoint::columns(std::vector<std::int64_t>& ids) {
  const double unit = std::fabs(y_[static_cast<std::size_t>(n_)]);
  order_.clear();
  for (const InteriorSide& side : sides_) {
    for (std::size_t i = 0; i < side.size; ++i)
      order_.emplace_back(weight_over_slack(side, i, unit), side.id(i));
  }
  const auto count = std::min<std::ptrdiff_t>(n_ + 1, std::ssize(order_));
  std::partial_sort(order_.begin(), order_.begin() + count, order_.end(), std::greater<>());
  ids.clear();
  for (std::ptrdiff_t i = 0; i < count; ++i) ids.push_back(order_[static_cast<std::size_t>(i)].second);
}

}  // namespace raygauge
