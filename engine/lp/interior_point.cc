// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/interior_point.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

using Matrix = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;
using VectorMap = Eigen::Map<Eigen::VectorXd>;

constexpr int kIterations = 60;
// x·s per unit of t where the solve ends: if just n + 1 columns carry weight, and at the latest.
constexpr double kDecided = 1e-5;
constexpr double kConverged = 1e-11;
constexpr double kStep = 0.995;     // of the way to the boundary
constexpr double kShortest = 1e-6;  // a step below makes no progress
constexpr double kFirstSupport = 0.5;
// Columns that weigh less than this share of the (n + 1)st heaviest are left out of the matrix: a little of
// each step is lost, and made up for by the next.
constexpr double kNegligible = 1e-5;

constexpr std::ptrdiff_t kLanes = PointSet::kLanes;

}  // namespace

InteriorPoint::End InteriorPoint::solve(const ColumnPool& A, const ColumnPool& Q, int n, const double* guess,
                                        const Kernels& kernels, const Stopwatch& stopwatch) {
  n_ = n;
  kernels_ = &kernels;
  iterations_ = 0;
  bind(A_, A, 1.0);
  bind(Q_, Q, -1.0);
  count_ = A_.points.size + Q_.points.size;
  ranked_.reserve(static_cast<std::size_t>(A_.count + Q_.count));
  const auto size = static_cast<std::size_t>(n);
  y_.reserve(size + 1);
  dy_.reserve(size + 1);
  border_.reserve(2 * size);
  direction_.reserve(size);
  matrix_.reserve(static_cast<std::size_t>(gram_rows(n)) * static_cast<std::size_t>(gram_columns(n)));
  scratch_.reserve(static_cast<std::size_t>(gram_rows(n) + gram_columns(n)) * kGramPoints);
  start(guess);
  for (iterations_ = 1; iterations_ <= kIterations; ++iterations_) {
    if (stopwatch.expired() || !factor()) return End::failed;
    const double length = step();
    if (!(length > kShortest) || !(y_[size] < kInfinity)) return End::failed;
    if (is_separating()) return End::separated;
    const double gap = complementarity(0, 0);
    const double scale = std::fabs(y_[size]);
    if (gap <= kConverged * scale || (gap <= kDecided * scale && columns_with_weight() == n + 1)) {
      return End::converged;
    }
  }
  return End::failed;
}

void InteriorPoint::bind(Side& side, const ColumnPool& pool, double sign) {
  side.points = pool.view();
  side.count = side.points.block_count * kLanes;
  side.sign = sign;
  side.last = sign > 0 ? 1.0 : 0.0;
  const auto count = static_cast<std::size_t>(side.count);
  side.x.reserve(count);
  side.s.reserve(count);
  side.dx.reserve(count);
  side.ds.reserve(count);
  side.weight.reserve(count);
  side.index.reserve(count);
}

// u·p for every point.
// NOLINTNEXTLINE(readability-non-const-parameter): the kernel writes the products
void InteriorPoint::price(Side& side, const double* u, double* products) {
  double* direction = direction_.data();
  std::copy_n(u, n_, direction);
  Collection all{side.index.data(), products, side.count, 0, -kInfinity};
  kernels_->collect(side.points.blocks, 0, side.points.block_count, n_, direction, &all);
}

// s = c - Aᵀy.
void InteriorPoint::slacks(Side& side, double cost) {
  price(side, y_.data(), side.s.data());
  const double t = side.last * y_[static_cast<std::size_t>(n_)];
  for (std::ptrdiff_t i = 0; i < side.count; ++i) {
    double& s = side.s[static_cast<std::size_t>(i)];
    s = cost - side.sign * s - t;
  }
}

// The guess, scaled so that Q keeps half of its bound, and t below what A allows.
void InteriorPoint::start(const double* guess) {
  std::ptrdiff_t index = 0;
  double* u = y_.data();
  for (int k = 0; k < n_; ++k) direction_[static_cast<std::size_t>(k)] = -guess[k];
  const double h_Q = kernels_->price(Q_.points.blocks, Q_.points.block_count, n_, direction_.data(), &index);
  double largest = 0;
  for (int k = 0; k < n_; ++k) largest = std::max(largest, std::fabs(guess[k]));
  const double length = kFirstSupport / std::max(h_Q, 1e-3 * largest);
  for (int k = 0; k < n_; ++k) u[k] = length * guess[k];
  const double h_A = kernels_->price(A_.points.blocks, A_.points.block_count, n_, u, &index);
  u[n_] = -h_A - std::max(1.0, 0.1 * std::fabs(h_A));
  slacks(A_, 0.0);
  slacks(Q_, 1.0);
  const double share = 1.0 / static_cast<double>(A_.points.size);
  double mu = 0;
  for (std::ptrdiff_t i = 0; i < A_.points.size; ++i) mu += share * share * A_.s[static_cast<std::size_t>(i)];
  for (Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      side->x[at] = i < side->points.size ? mu / side->s[at] : 0.0;
    }
  }
}

void InteriorPoint::weigh() {
  double* weights = ranked_.data();
  for (Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      side->weight[at] = i < side->points.size ? side->x[at] / side->s[at] : 0.0;
      *weights++ = side->weight[at];
    }
  }
  double* nth = ranked_.data() + std::min<std::ptrdiff_t>(n_, weights - ranked_.data() - 1);
  std::nth_element(ranked_.data(), nth, weights, std::greater<>());
  for (Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->count; ++i) {
      double& weight = side->weight[static_cast<std::size_t>(i)];
      if (weight < kNegligible * *nth) weight = 0;
    }
  }
}

// sum += Σ weight_i p_i.
void InteriorPoint::add_weighted(const Side& side, double* sum) const {
  for (std::ptrdiff_t b = 0; b < side.points.block_count; ++b) {
    const double* weight = side.weight.data() + b * kLanes;
    for (int k = 0; k < n_; ++k) {
      const double* p = side.points.blocks + (b * n_ + k) * kLanes;
      double part = 0;
      for (int lane = 0; lane < kLanes; ++lane) part += weight[lane] * p[lane];
      sum[k] += part;
    }
  }
}

// G = Σ d p pᵀ over both sets by Cholesky; the convexity row borders it.
bool InteriorPoint::factor() {
  const int ld = gram_rows(n_);
  std::fill_n(matrix_.data(), static_cast<std::size_t>(ld) * static_cast<std::size_t>(gram_columns(n_)), 0.0);
  weigh();
  for (Side* side : {&A_, &Q_}) {
    kernels_->add_gram(side->points.blocks, side->points.block_count, n_, side->weight.data(),
                       scratch_.data(), matrix_.data());
  }
  Matrix G(matrix_.data(), n_, n_, Eigen::OuterStride<>(ld));
  Eigen::LLT<Eigen::Ref<Eigen::MatrixXd, 0, Eigen::OuterStride<>>> cholesky(G);
  if (cholesky.info() != Eigen::Success) return false;
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
  const Matrix G(matrix_.data(), n_, n_, Eigen::OuterStride<>(gram_rows(n_)));
  VectorMap v(rhs, n_);
  const VectorMap solved(border_.data() + n_, n_);
  const double last = (rhs[n_] - solved.dot(v)) / pivot_;
  const auto lower = G.triangularView<Eigen::Lower>();
  lower.solveInPlace(v);
  lower.transpose().solveInPlace(v);
  v -= last * solved;
  rhs[n_] = last;
}

// ds = -Aᵀdy and dx = S⁻¹ (centre - dx_a ds_a) - x - S⁻¹ X ds; with `corrector`, dx and ds hold those of the
// affine step.
void InteriorPoint::directions(Side& side, double centre, bool corrector) {
  double* products = side.weight.data();
  for (std::ptrdiff_t i = 0; i < side.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    side.dx[at] = (centre - (corrector ? side.dx[at] * side.ds[at] : 0.0)) / side.s[at];
  }
  price(side, dy_.data(), products);
  const double dt = side.last * dy_[static_cast<std::size_t>(n_)];
  for (std::ptrdiff_t i = 0; i < side.count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    side.ds[at] = -side.sign * products[at] - dt;
    side.dx[at] += -side.x[at] - side.x[at] / side.s[at] * side.ds[at];
    if (i >= side.points.size) side.dx[at] = side.ds[at] = 0;
  }
}

double InteriorPoint::longest_step(const Side& side, const AlignedBuffer<double>& value,
                                   const AlignedBuffer<double>& change) {
  double rate = 0;  // the fastest fall, relative
  for (std::ptrdiff_t i = 0; i < side.points.size; ++i) {
    const auto at = static_cast<std::size_t>(i);
    rate = std::max(rate, -change[at] / value[at]);
  }
  return rate > 0 ? 1 / rate : kInfinity;
}

// x·s after steps of these lengths.
double InteriorPoint::complementarity(double step_x, double step_s) const {
  double sum = 0;
  for (const Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->points.size; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double x = side->x[at] + (step_x > 0 ? step_x * side->dx[at] : 0.0);
      const double s = side->s[at] + (step_s > 0 ? step_s * side->ds[at] : 0.0);
      sum += x * s;
    }
  }
  return sum;
}

// Predictor (M dy = b), centre, corrector. The shorter of the two step lengths.
double InteriorPoint::step() {
  const auto last = static_cast<std::size_t>(n_);
  std::fill_n(dy_.data(), n_, 0.0);
  dy_[last] = 1;
  solve_for(dy_.data());
  for (Side* side : {&A_, &Q_}) directions(*side, 0, false);
  const auto limit = [&](bool of_x) {
    double length = 1;
    for (const Side* side : {&A_, &Q_}) {
      const double longest =
          of_x ? longest_step(*side, side->x, side->dx) : longest_step(*side, side->s, side->ds);
      length = std::min(length, kStep * longest);
    }
    return length;
  };
  const double now = complementarity(0, 0);
  const double affine = complementarity(limit(true), limit(false));
  const double ratio = affine / now;
  const double centre = ratio * ratio * ratio * now / static_cast<double>(count_);

  // M dy = b - A S⁻¹ (centre - dx ds)
  std::fill_n(dy_.data(), n_ + 1, 0.0);
  double sum_of_A = 0;
  for (Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double weight =
          i < side->points.size ? (centre - side->dx[at] * side->ds[at]) / side->s[at] : 0.0;
      side->weight[at] = -side->sign * weight;
      if (side == &A_) sum_of_A += weight;
    }
    add_weighted(*side, dy_.data());
  }
  dy_[last] = 1 - sum_of_A;
  solve_for(dy_.data());
  for (Side* side : {&A_, &Q_}) directions(*side, centre, true);
  const double step_x = limit(true);
  const double step_s = limit(false);
  for (Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->points.size; ++i) {
      side->x[static_cast<std::size_t>(i)] += step_x * side->dx[static_cast<std::size_t>(i)];
    }
  }
  for (int k = 0; k <= n_; ++k) y_[static_cast<std::size_t>(k)] += step_s * dy_[static_cast<std::size_t>(k)];
  slacks(A_, 0.0);
  slacks(Q_, 1.0);
  return std::min(step_x, step_s);
}

// u·q > 0 for every q, by a margin, and u·a < 0: t > 0 means it.
bool InteriorPoint::is_separating() const {
  constexpr double kMargin = 1e-6;
  const double t = y_[static_cast<std::size_t>(n_)];
  if (!(t > 0)) return false;
  double least = kInfinity;
  for (std::ptrdiff_t j = 0; j < Q_.points.size; ++j)
    least = std::min(least, Q_.s[static_cast<std::size_t>(j)]);
  double largest = 0;
  for (int k = 0; k < n_; ++k) largest = std::max(largest, std::fabs(y_[static_cast<std::size_t>(k)]));
  return least - 1 > kMargin * largest;
}

// Of a pair x, s one goes to zero: compared in the units of each, x about 1 in A and s about t, and the
// other way round in Q. Above 1: the column carries weight.
double InteriorPoint::weight_over_slack(const Side& side, std::size_t at) const {
  const double t = std::fabs(y_[static_cast<std::size_t>(n_)]);
  const double ratio = side.x[at] / side.s[at];
  return &side == &A_ ? ratio * t : ratio / t;
}

int InteriorPoint::columns_with_weight() const {
  int count = 0;
  for (const Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->points.size; ++i) {
      count += weight_over_slack(*side, static_cast<std::size_t>(i)) > 1 ? 1 : 0;
    }
  }
  return count;
}

void InteriorPoint::columns(std::vector<std::int64_t>& ids) {
  order_.clear();
  for (const Side* side : {&A_, &Q_}) {
    for (std::ptrdiff_t i = 0; i < side->points.size; ++i) {
      const double ratio = weight_over_slack(*side, static_cast<std::size_t>(i));
      order_.emplace_back(ratio, side == &A_ ? id_of_A(i) : id_of_Q(i));
    }
  }
  const auto count = std::min<std::ptrdiff_t>(n_ + 1, std::ssize(order_));
  std::partial_sort(order_.begin(), order_.begin() + count, order_.end(), std::greater<>());
  ids.clear();
  for (std::ptrdiff_t i = 0; i < count; ++i) ids.push_back(order_[static_cast<std::size_t>(i)].second);
}

}  // namespace raygauge
