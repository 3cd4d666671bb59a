// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Many points against one set.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "engine/kernels/kernel.h"
#include "engine/numerics/aligned_buffer.h"
#include "engine/numerics/floating_point.h"
#include "engine/proof/certificate.h"
#include "engine/queries/point_gauges.h"
#include "engine/sets/capability_queries.h"
#include "engine/sets/parameters.h"
#include "raygauge/queries/membership.h"
#include "raygauge/queries/pair_batch.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/pose.h"

namespace raygauge {
namespace {

using Points = PointGauges::Points;
using Indices = PointGauges::Indices;

constexpr std::size_t kFirstBlock = 256, kBlock = 65536;  // points after which new normals are kept
constexpr std::size_t kFirstGauges = 4096;
constexpr std::ptrdiff_t kMostNormals = 1024;  // kept, and half as many as S has points: a solve
                                               // takes some ten passes over S

// What single solves proved about a point set S, for all points. S is seen from near its centre c: S' holds
// the rounded differences, whose errors are covered by a bound on the gauge of any small vector.
class KnownHull {
 public:
  KnownHull(const PointSet& S, const PointsOptions& options) : S_(&S), c_(S.center()) {
    const int n = S.dimension();
    Eigen::MatrixXd shifted(n, S.size());
    Vector p(n);
    for (std::ptrdiff_t j = 0; j < S.size(); ++j) {
      S.copy_point(j, p.data());
      shifted.col(j) = p - c_;
    }
    if (!shifted.allFinite()) return;
    rounding_ = kUnitRoundoff * shifted.cwiseAbs().maxCoeff() + kUnderflow;
    shifted_.emplace(shifted);
    gauges_.emplace(*shifted_, options);
    measure_axes();
  }

  // Decides `which` points where it can; the others are left in `which`.
  void decide(const Points& X, Indices& which, std::vector<Membership>& answers) {
    drop(which, [&](std::size_t i) {
      const auto x = X.col(static_cast<Eigen::Index>(i));
      if (is_deep(x)) return note(answers[i], Membership::inside);
      return is_beyond(x) && note(answers[i], Membership::outside);
    });
    if (!(per_residual_ < kInfinity)) return;
    ask(X, which, answers);
  }

 private:
  template <class Decided>
  static void drop(Indices& which, const Decided& decided) {
    Indices rest;
    for (const std::size_t i : which) {
      if (!decided(i)) rest.push_back(i);
    }
    which = std::move(rest);
  }

  // By the gauges of S'.
  void ask(const Points& X, Indices& which, std::vector<Membership>& answers) {
    const int n = S_->dimension();
    Eigen::MatrixXd seen(n, std::ssize(which));
    for (std::size_t i = 0; i < which.size(); ++i)
      seen.col(static_cast<Eigen::Index>(i)) = X.col(static_cast<Eigen::Index>(which[i])) - c_;
    Indices all(which.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    gauges_->solve(seen, all, nullptr, true);
    std::size_t k = 0;
    drop(which, [&](std::size_t i) {
      const std::size_t at = k++;
      const auto x = seen.col(static_cast<Eigen::Index>(at));
      if (is_at_most_one(gauges_->upper[at], x)) return note(answers[i], Membership::inside);
      if (!(gauges_->lower[at] > 1)) return false;
      const Vector w = -Vector::Map(gauges_->normal.data() + at * static_cast<std::size_t>(n), n);
      return separates(w, X.col(static_cast<Eigen::Index>(i))) && note(answers[i], Membership::outside);
    });
  }

  static bool note(Membership& answer, Membership proven) {
    answer = proven;
    return true;
  }

  // The gauges of ±e_k in S', and G with gauge_{S-c}(r) <= G |r|∞. With e the rounding of S',
  // e_k = Σβ p' = Σβ (p - c) + r, |r|∞ <= e Σβ, so that G <= G' / (1 - e G').
  void measure_axes() {
    axis_gauge_ = gauges_->axis_gauges();
    const int n = S_->dimension();
    const double sum = axis_gauge_.sum() * (1 + (n + 1) * kUnitRoundoff);
    if (rounding_ * sum < 0.5) per_residual_ = sum / (1 - rounding_ * sum) * (1 + 8 * kUnitRoundoff);
  }

  // Whether a gauge of at most `upper` in S' at the rounded difference x proves one of at most 1 in S - c.
  template <class Column>
  bool is_at_most_one(double upper, const Column& x) const {
    const double residual = upper * rounding_ + kUnitRoundoff * x.cwiseAbs().maxCoeff() + kUnderflow;
    return (upper + residual * per_residual_) * (1 + 8 * kUnitRoundoff) <= 1;
  }

  // gauge(Σ x_k e_k) <= Σ |x_k| gauge(±e_k).
  template <class Column>
  bool is_deep(const Column& x) const {
    if (!(per_residual_ < kInfinity)) return false;
    const Vector seen = x - c_;
    const double sum = seen.cwiseAbs().dot(axis_gauge_);
    return is_at_most_one(sum * (1 + (static_cast<double>(seen.size()) + 2) * kUnitRoundoff), seen);
  }

  // w·x, rounded down.
  template <class Column>
  static double least_product(const Vector& w, const Column& x) {
    const double size = w.cwiseAbs().dot(x.cwiseAbs());
    return w.dot(x) - 1.01 * (static_cast<double>(w.size()) + 2) * kUnitRoundoff * size - kUnderflow;
  }

  // Of the plane w·x = h that x is farthest beyond, by w·x/h.
  template <class Column>
  bool is_beyond(const Column& x) const {
    if (planes_.empty()) return false;
    const auto blocks = static_cast<std::ptrdiff_t>(planes_.size() + PointSet::kLanes - 1) / PointSet::kLanes;
    std::ptrdiff_t best = 0;
    best_kernels().price(shares_.data(), blocks, S_->dimension(), x.data(), &best);
    if (best >= std::ssize(planes_)) return false;
    const auto& [w, above] = planes_[static_cast<std::size_t>(best)];
    return least_product(w, x) > above;
  }

  // Planes with h > 0, with w/h in blocks of PointSet; lanes beyond are 0.
  void keep(const Vector& w, double above) {
    constexpr std::size_t kLanes = PointSet::kLanes;
    const auto n = static_cast<std::size_t>(w.size());
    if (!(above > 0) || std::ssize(planes_) >= std::min(kMostNormals, S_->size() / 2)) return;
    const std::size_t at = planes_.size(), block = at / kLanes * n * kLanes;
    if (at % kLanes == 0) {
      shares_.reserve(block + n * kLanes);
      std::fill_n(shares_.data() + block, n * kLanes, 0.0);
    }
    for (std::size_t k = 0; k < n; ++k)
      shares_[block + k * kLanes + at % kLanes] = w[static_cast<Eigen::Index>(k)] / above;
    planes_.emplace_back(w, above);
  }

  // Whether w·x > h_S(w). What does is kept, while there is room.
  template <class Column>
  bool separates(const Vector& w, const Column& x) {
    const SupportValue h = support_value(best_kernels(), *S_, w.data());
    const double above = h.above() + 2 * kUnitRoundoff * std::fabs(h.value);
    if (!(least_product(w, x) > above)) return false;
    keep(w, above);
    return true;
  }

  const PointSet* S_;
  Vector c_;
  std::optional<PointSet> shifted_;
  std::optional<PointGauges> gauges_;
  double rounding_ = 0;              // of any coordinate of S'
  double per_residual_ = kInfinity;  // G
  Vector axis_gauge_;
  std::vector<std::pair<Vector, double>> planes_;  // w, and at least h_S(w)
  AlignedBuffer<double> shares_;                   // of both
};

void check_points(const char* query, const ConvexSet& S, const Points& X, const PointsOptions& options) {
  check_dimension(query, "X", X.rows(), S.dimension());
  check_finite_matrix(query, "X", X);
  const PairBatch checked(options_of_membership(S, options.tolerance), options.threads);
}

// Consecutive numbers, one block after the other: the first ones are short, so that later ones profit.
class Blocks {
 public:
  Blocks(std::size_t count, std::size_t first) : count_(count), size_(first) {}

  bool next(Indices& which) {
    const std::size_t size = std::min(size_, count_ - first_);
    which.resize(size);
    std::iota(which.begin(), which.end(), first_);
    first_ += size;
    size_ = std::min(4 * size_, kBlock);
    return size > 0;
  }

 private:
  std::size_t count_, first_ = 0, size_;
};

}  // namespace

bool gauges_walk(const ConvexSet& S, std::ptrdiff_t K) noexcept { return PointGauges::may_walk(S, K); }

std::vector<GaugeBounds> gauges(const ConvexSet& S, const Points& X, const PointsOptions& options,
                                Eigen::MatrixXd* normals) {
  check_points("gauges", S, X, options);
  const auto count = static_cast<std::size_t>(X.cols());
  std::vector<GaugeBounds> bounds(count, {0, kInfinity});
  PointGauges solver(S, options);
  Vector normal(S.dimension());
  if (normals != nullptr)
    normals->setConstant(S.dimension(), X.cols(), std::numeric_limits<double>::quiet_NaN());
  Blocks blocks(count, kFirstGauges);
  for (Indices which; blocks.next(which);) {
    if (options.stop && options.stop()) break;
    solver.solve(X, which, nullptr, normals != nullptr);
    if (normals != nullptr) {
      const auto first = static_cast<Eigen::Index>(which.front());  // of columns that follow each other
      normals->middleCols(first, std::ssize(which)) =
          Eigen::MatrixXd::Map(solver.normal.data(), S.dimension(), std::ssize(which));
    }
    for (std::size_t k = 0; k < which.size(); ++k) {
      GaugeBounds& b = bounds[which[k]];
      b = {solver.lower[k], solver.upper[k]};
      if (as_point_set(S) != nullptr) continue;
      const Vector x = X.col(static_cast<Eigen::Index>(which[k]));
      const double formula = gauge_bound(S, x.data(), normal.data());
      if (formula >= b.lower && formula < b.upper) b.upper = formula;
    }
  }
  return bounds;
}

std::vector<Membership> memberships(const ConvexSet& S, const Points& X, const PointsOptions& options) {
  check_points("memberships", S, X, options);
  const auto count = static_cast<std::size_t>(X.cols());
  const int n = S.dimension();
  std::vector<Membership> answers(count, Membership::undecided);
  const Pose from_center(Eigen::MatrixXd::Identity(n, n), -S.center());
  PointGauges solver(S, options);
  std::optional<KnownHull> known;
  if (const PointSet* points = as_point_set(S); points != nullptr && X.cols() > 4 * X.rows())
    known.emplace(*points, options);
  Blocks blocks(count, kFirstBlock);
  for (Indices which; blocks.next(which);) {
    if (options.stop && options.stop()) break;
    if (known) known->decide(X, which, answers);
    if (which.empty()) continue;
    solver.solve(X, which, &from_center, false);
    for (std::size_t k = 0; k < which.size(); ++k) {
      if (solver.lower[k] > 1) answers[which[k]] = Membership::outside;
      if (solver.upper[k] <= 1) answers[which[k]] = Membership::inside;
    }
  }
  return answers;
}

}  // namespace raygauge
