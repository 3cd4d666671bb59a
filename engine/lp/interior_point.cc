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
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

using Matrix = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using VectorMap = Eigen::Map<Eigen::VectorXd>;

constexpr int kIterations = 60;
constexpr int kIterationsOfFew = 35;  // separates by then, or nears an optimum
// x·s per unit of t where the solve ends: if just n + 1 columns carry weight, and at the latest.
constexpr double kDecided = 1e-5;
constexpr double kConverged = 1e-11;
// The same where a few columns stay undecided: one for so many dimensions.
constexpr double kNearlyConverged = 1e-8;
constexpr int kForEachTie = 200;
// x·s per unit of t down to which products in single precision suffice.
constexpr double kCoarse = 1e-3;
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
constexpr std::ptrdiff_t kManyPoints = 4;
constexpr double kSpread = 4;
constexpr double kLeastSum = 1.0;
constexpr double kMostSum = 1e6;
// Columns that weigh less than this share of the (n + 1)st heaviest are left out of the matrix: a little of
// each step is lost, and made up for by the next. Where steps become short, more is kept.
constexpr double kNegligible = 1e-3;
constexpr double kLeastNegligible = 1e-5;
constexpr double kShortStep = 0.1;
constexpr double kMoreKept = 0.1;

constexpr std::ptrdiff_t kLanes = PointSet::kLanes;

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
  kernels_ = &kernels;
  iterations_ = 0;
  paused_at_zero_ = false;
  next_pause_ = kFar;
  bind(A_, A, 1.0);
  bind(Q_, Q, -1.0);
  count_ = A_.points.size + Q_.points.size;
  many_ = count_ >= kManyPoints * n;
  single_ = many_;
  negligible_ = kNegligible;
  ranked_.reserve(static_cast<std::size_t>(A_.count + Q_.count));
  const auto size = static_cast<std::size_t>(n);
  y_.reserve(size + 1);
  duals_.reserve(size + 1);
  dy_.reserve(size + 1);
  border_.reserve(2 * size);
  direction_.reserve(size);
  reserve_passes();
  start(guess);
}

InteriorPoint::End InteriorPoint::run(const Stopwatch& stopwatch) {
  const End end = iterate(stopwatch);
  std::copy_n(y_.data(), n_ + 1, duals_.data());
  if (whitened_ == nullptr) return end;
  whitened_->turn_back(duals_.data());
  return VectorMap(duals_.data(), n_).allFinite() ? end : End::failed;
}

InteriorPoint::End InteriorPoint::iterate(const Stopwatch& stopwatch) {
  const double& t = y_[static_cast<std::size_t>(n_)];
  const int limit = many_ ? kIterations : kIterationsOfFew;
  const double operations =
      static_cast<double>(n_) * n_ * (0.5 * static_cast<double>(count_) + n_) / kernels_->width;
  StepTimes steps;
  const auto nears_an_optimum = [&] { return t > 0 && complementarity(0, 0) < t; };
  while (iterations_ < limit || (iterations_ < kIterations && nears_an_optimum())) {
    ++iterations_;
    if (stopwatch.expired() || !steps.affords_next(stopwatch, operations)) return End::failed;
    if (single_ && !factor(true)) leave_single();
    if (!single_ && !factor(false)) {
      const bool close = t > 0 && complementarity(0, 0) <= kDecided * t;
      return close ? End::converged : End::failed;
    }
    const double length = step();
    if (length < kShortStep) negligible_ = std::max(kLeastNegligible, kMoreKept * negligible_);
    if (!(length > kShortest) && single_) {
      leave_single();
      continue;
    }
    if (!(length > kShortest) || !(t < kInfinity)) return End::failed;
    if (is_separating()) return End::separated;
    const double gap = complementarity(0, 0);
    const double scale = std::fabs(t);
    const bool moderate = scale + gap > kMostlyZero && t < std::min(kMostlyFar, enough_);
    if (!(gap > kCoarse * scale) || !moderate) leave_single();
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
int InteriorPoint::undecided() const { return std::abs(columns_with_weight() - (n_ + 1)); }

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

void InteriorPoint::bind(Side& side, const PricedPoints& points, double sign) {
  side.points = points;
  side.count = points.single_blocks == nullptr ? points.block_count * kLanes
                                               : points.single_block_count * PointSet::kSingleLanes;
  side.sign = sign;
  side.last = sign > 0 ? 1.0 : 0.0;
  const auto count = static_cast<std::size_t>(side.count);
  side.x.reserve(count);
  side.s.reserve(count);
  side.dx.reserve(count);
  side.ds.reserve(count);
  side.kept_dx.reserve(count);
  side.kept_ds.reserve(count);
  side.target.reserve(count);
  side.weight.reserve(count);
}

// The guess g, scaled so that Q keeps half of its bound, t below what A allows, and weights x = μ / s.
void InteriorPoint::start(const double* guess) {
  double* u = y_.data();
  price(A_, guess, A_.s.data());
  price(Q_, guess, Q_.s.data());
  double h_A = -kInfinity;
  double h_Q = -kInfinity;  // h_Q(-g)
  for (std::ptrdiff_t i = 0; i < A_.points.size; ++i) h_A = std::max(h_A, A_.s[static_cast<std::size_t>(i)]);
  for (std::ptrdiff_t j = 0; j < Q_.points.size; ++j) h_Q = std::max(h_Q, -Q_.s[static_cast<std::size_t>(j)]);
  double largest = 0;
  for (int k = 0; k < n_; ++k) largest = std::max(largest, std::fabs(guess[k]));
  const double length = kFirstSupport / std::max(h_Q, 1e-3 * largest);
  for (int k = 0; k < n_; ++k) u[k] = length * guess[k];
  const auto size_A = static_cast<double>(A_.points.size);
  double mu = many_ ? central_weight() : 0.0;
  u[n_] = -length * h_A - (many_ ? mu * size_A : std::max(1.0, 0.1 * std::fabs(length * h_A)));
  slacks(A_, 0.0);
  slacks(Q_, 1.0);
  if (!many_) {
    for (std::ptrdiff_t i = 0; i < A_.points.size; ++i)
      mu += A_.s[static_cast<std::size_t>(i)] / (size_A * size_A);
  }
  for (Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      side->x[at] = i < side->points.size ? mu / side->s[at] : 0.0;
    }
  }
}

// From the products of the points with the guess g in s: a μ so large that weights μ / s within a factor of 2
// of each other can move the mean of Q's points to where A is, Σβ of some |mean g·a| / rms g·q. That saves
// 3 of 24 iterations at n = 400, N = 1200, but where no weights do it, it hides that there are none.
double InteriorPoint::central_weight() const {
  double mean_A = 0;
  double square_Q = 0;
  for (std::ptrdiff_t i = 0; i < A_.points.size; ++i) mean_A += A_.s[static_cast<std::size_t>(i)];
  for (std::ptrdiff_t j = 0; j < Q_.points.size; ++j) {
    const double product = Q_.s[static_cast<std::size_t>(j)];
    square_Q += product * product;
  }
  const auto size_Q = static_cast<double>(Q_.points.size);
  const double far = std::fabs(mean_A) / static_cast<double>(A_.points.size);
  const double rms = std::sqrt(square_Q / size_Q);
  return std::clamp(kSpread * far / rms, kLeastSum, kMostSum) / size_Q;
}

// The weights x / s of the matrix. Those of A count (Σβ)² times as much: compared in the units of each, x
// about 1 in A and s about Σβ, and the other way round in Q.
void InteriorPoint::weigh() {
  double beta = 0;
  for (Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      side->weight[at] = i < side->points.size ? side->x[at] / side->s[at] : 0.0;
      if (side == &Q_) beta += side->x[at];
    }
  }
  if (many_) leave_out_negligible(beta * beta);
}

// As counted, those of A `unit` times as much.
void InteriorPoint::leave_out_negligible(double unit) {
  double* ranks = ranked_.data();
  for (const Side* side : {&A_, &Q_}) {
    const double factor = side == &A_ ? unit : 1.0;
    for (std::ptrdiff_t i = 0; i < side->count; ++i)
      *ranks++ = factor * side->weight[static_cast<std::size_t>(i)];
  }
  double* nth = ranked_.data() + std::min<std::ptrdiff_t>(n_, ranks - ranked_.data() - 1);
  std::nth_element(ranked_.data(), nth, ranks, std::greater<>());
  for (Side* side : {&A_, &Q_}) {
    const double least = negligible_ * *nth / (side == &A_ ? unit : 1.0);
    for (std::ptrdiff_t i = 0; i < side->count; ++i) {
      double& weight = side->weight[static_cast<std::size_t>(i)];
      if (weight < least) weight = 0;
    }
  }
}

// G = Σ d p pᵀ over both sets by Cholesky; the convexity row borders it.
bool InteriorPoint::factor(bool single) {
  gram_.begin(n_, *kernels_, helpers_);
  weigh();
  for (Side* side : {&A_, &Q_}) gram_.add(side->points, side->weight.data(), single);
  if (!gram_.factor()) return false;
  const Matrix G(gram_.data(), n_, n_, Eigen::OuterStride<>(gram_.rows()));
  double* g = border_.data();
  std::fill_n(g, n_, 0.0);
  add_weighted(A_, g);
  corner_ = 0;
  for (std::ptrdiff_t i = 0; i < A_.points.size; ++i) corner_ += A_.weight[static_cast<std::size_t>(i)];
  const VectorMap border(g, n_);
  VectorMap solved(g + n_, n_);
  solved = border;
  const auto lower = G.triangularView<Eigen::Lower>();
  lower.solveInPlace(solved);
  pivot_ = corner_ - solved.squaredNorm();
  lower.transpose().solveInPlace(solved);
  return pivot_ > 0;
}

// rhs (n + 1 numbers) becomes M⁻¹ rhs.
void InteriorPoint::solve_for(double* rhs) {
  const Matrix G(gram_.data(), n_, n_, Eigen::OuterStride<>(gram_.rows()));
  VectorMap v(rhs, n_);
  const VectorMap solved(border_.data() + n_, n_);
  const double last = (rhs[n_] - solved.dot(v)) / pivot_;
  if ((v.array() != 0).any()) {  // zero without targets
    const auto lower = G.triangularView<Eigen::Lower>();
    lower.solveInPlace(v);
    lower.transpose().solveInPlace(v);
  }
  v -= last * solved;
  rhs[n_] = last;
}

// u·q > 0 for every q, by a margin far above rounding errors, and u·a < 0: t > 0 means it. Half of the sets
// of n + 2 points leave 1e-8.
bool InteriorPoint::is_separating() const {
  const double margin = single_ ? 1e-6 : 1e-10;
  const double t = y_[static_cast<std::size_t>(n_)];
  if (!(t > 0)) return false;
  double least = kInfinity;
  for (std::ptrdiff_t j = 0; j < Q_.points.size; ++j)
    least = std::min(least, Q_.s[static_cast<std::size_t>(j)]);
  double largest = 0;
  for (int k = 0; k < n_; ++k) largest = std::max(largest, std::fabs(y_[static_cast<std::size_t>(k)]));
  return least - 1 > margin * largest;
}

// Of a pair x, s one goes to zero: compared in the units of each, x about 1 in A and s about d, and the
// other way round in Q. Above 1: the column carries weight.
double InteriorPoint::weight_over_slack(const Side& side, std::size_t at, double unit) const {
  const double ratio = side.x[at] / side.s[at];
  return &side == &A_ ? ratio * unit : ratio / unit;
}

void InteriorPoint::carriers(double unit, std::vector<Carrier>& carriers) const {
  carriers.clear();
  for (const Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->points.size; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (!(weight_over_slack(*side, at, unit) > 1)) continue;
      carriers.push_back({side == &A_ ? id_of_A(i) : id_of_Q(i), side->x[at]});
    }
  }
}

int InteriorPoint::columns_with_weight() const {
  const double unit = std::fabs(y_[static_cast<std::size_t>(n_)]);
  int count = 0;
  for (const Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->points.size; ++i) {
      count += weight_over_slack(*side, static_cast<std::size_t>(i), unit) > 1 ? 1 : 0;
    }
  }
  return count;
}

void InteriorPoint::columns(std::vector<std::int64_t>& ids) {
  const double unit = std::fabs(y_[static_cast<std::size_t>(n_)]);
  order_.clear();
  for (const Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->points.size; ++i) {
      const double ratio = weight_over_slack(*side, static_cast<std::size_t>(i), unit);
      order_.emplace_back(ratio, side == &A_ ? id_of_A(i) : id_of_Q(i));
    }
  }
  const auto count = std::min<std::ptrdiff_t>(n_ + 1, std::ssize(order_));
  std::partial_sort(order_.begin(), order_.begin() + count, order_.end(), std::greater<>());
  ids.clear();
  for (std::ptrdiff_t i = 0; i < count; ++i) ids.push_back(order_[static_cast<std::size_t>(i)].second);
}

}  // namespace raygauge
