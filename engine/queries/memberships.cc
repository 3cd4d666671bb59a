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
#include "engine/numerics/floating_point.h"
#include "engine/proof/certificate.h"
#include "engine/queries/membership_options.h"
#include "engine/sets/capability_queries.h"
#include "engine/sets/parameters.h"
#include "raygauge/queries/membership.h"
#include "raygauge/queries/pair_batch.h"
#include "raygauge/sets/point_set.h"
#include "raygauge/sets/pose.h"

namespace raygauge {
namespace {

using Points = Eigen::Ref<const Eigen::MatrixXd>;
using Indices = std::vector<std::size_t>;

constexpr std::size_t kBlock = 4096;         // points after which new normals are kept
constexpr std::ptrdiff_t kMostNormals = 32;  // kept: a normal costs 2 n operations a point, a solve some 1e4

// Bounds of the gauges of S at single points, in the numbers of X that are asked for. The batch keeps its
// solvers.
class PointGauges {
 public:
  PointGauges(const ConvexSet& S, const PointsOptions& options)
      : S_(&S),
        batch_(options_of_membership(S, options.tolerance), options.threads),
        points_(static_cast<std::size_t>(std::max(options.threads, 1))) {
    if (options.stop) batch_.set_stop(options.stop);
  }

  // The gauges of X's columns `which`; both sets in `pose`, if there is one. Normals, of n doubles, if asked.
  void solve(const Points& X, const Indices& which, const Pose* pose, bool with_normals) {
    const int n = S_->dimension();
    lower.assign(which.size(), 0.0);
    upper.assign(which.size(), kInfinity);
    normal.assign(with_normals ? which.size() * static_cast<std::size_t>(n) : 0, 0.0);
    BatchAnswers answers;
    answers.lower = lower;
    answers.upper = upper;
    answers.normal = normal;
    const auto pair = [&](std::size_t i, int thread) {
      std::optional<PointSet>& point = points_[static_cast<std::size_t>(thread)];
      point.emplace(Eigen::MatrixXd(X.col(static_cast<Eigen::Index>(which[i]))));
      return pose == nullptr ? PosedPair{*point, *S_} : PosedPair{{*point, *pose}, {*S_, *pose}};
    };
    batch_.gauge_distances(which.size(), pair, n, answers);
  }

  std::vector<double> lower, upper, normal;

 private:
  const ConvexSet* S_;
  PairBatch batch_;
  std::vector<std::optional<PointSet>> points_;  // of each thread
};

// What single solves proved about a point set S, for all points. S is seen from near its centre c: S' holds
// the rounded differences, whose errors are covered by a bound on the gauge of any small vector.
class KnownHull {
 public:
  KnownHull(const PointSet& S, const PointsOptions& options) : S_(&S), options_(options), c_(S.center()) {
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
    if (which.empty() || !(per_residual_ < kInfinity)) return;
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

 private:
  template <class Decided>
  static void drop(Indices& which, const Decided& decided) {
    Indices rest;
    for (const std::size_t i : which) {
      if (!decided(i)) rest.push_back(i);
    }
    which = std::move(rest);
  }

  static bool note(Membership& answer, Membership proven) {
    answer = proven;
    return true;
  }

  // The gauges of ±e_k in S', and G with gauge_{S-c}(r) <= G |r|∞. With e the rounding of S',
  // e_k = Σβ p' = Σβ (p - c) + r, |r|∞ <= e Σβ, so that G <= G' / (1 - e G').
  void measure_axes() {
    const int n = S_->dimension();
    Eigen::MatrixXd axes(n, 2 * n);
    axes << Eigen::MatrixXd::Identity(n, n), -Eigen::MatrixXd::Identity(n, n);
    Indices all(static_cast<std::size_t>(2 * n));
    std::iota(all.begin(), all.end(), std::size_t{0});
    gauges_->solve(axes, all, nullptr, false);
    axis_gauge_.resize(n);
    for (int k = 0; k < n; ++k) {
      const auto at = static_cast<std::size_t>(k);
      axis_gauge_[k] = std::max(gauges_->upper[at], gauges_->upper[at + static_cast<std::size_t>(n)]);
    }
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

  template <class Column>
  bool is_beyond(const Column& x) const {
    return std::any_of(planes_.begin(), planes_.end(), [&](const std::pair<Vector, double>& plane) {
      return least_product(plane.first, x) > plane.second;
    });
  }

  // Whether w·x > h_S(w). What does is kept, while there is room.
  template <class Column>
  bool separates(const Vector& w, const Column& x) {
    const SupportValue h = support_value(best_kernels(), *S_, w.data());
    const double above = h.above() + 2 * kUnitRoundoff * std::fabs(h.value);
    if (!(least_product(w, x) > above)) return false;
    if (std::ssize(planes_) < kMostNormals) planes_.emplace_back(w, above);
    return true;
  }

  const PointSet* S_;
  const PointsOptions& options_;
  Vector c_;
  std::optional<PointSet> shifted_;
  std::optional<PointGauges> gauges_;
  double rounding_ = 0;              // of any coordinate of S'
  double per_residual_ = kInfinity;  // G
  Vector axis_gauge_;
  std::vector<std::pair<Vector, double>> planes_;  // w, and at least h_S(w)
};

void check_points(const char* query, const ConvexSet& S, const Points& X, const PointsOptions& options) {
  check_dimension(query, "X", X.rows(), S.dimension());
  check_finite_matrix(query, "X", X);
  const PairBatch checked(options_of_membership(S, options.tolerance), options.threads);
}

Indices block_from(std::size_t first, std::size_t count) {
  Indices which(std::min(kBlock, count - first));
  std::iota(which.begin(), which.end(), first);
  return which;
}

}  // namespace

std::vector<GaugeBounds> gauges(const ConvexSet& S, const Points& X, const PointsOptions& options) {
  check_points("gauges", S, X, options);
  const auto count = static_cast<std::size_t>(X.cols());
  std::vector<GaugeBounds> bounds(count, {0, kInfinity});
  PointGauges solver(S, options);
  Vector normal(S.dimension());
  for (std::size_t first = 0; first < count; first += kBlock) {
    if (options.stop && options.stop()) break;
    const Indices which = block_from(first, count);
    solver.solve(X, which, nullptr, false);
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
  for (std::size_t first = 0; first < count; first += kBlock) {
    if (options.stop && options.stop()) break;
    Indices which = block_from(first, count);
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
