// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/lp/primal_simplex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/lp/affords.h"
#include "engine/numerics/floating_point.h"

namespace raygauge {
namespace {

// Between two looks at the clock, and at the drift of the basis: so many pivots, or so many entries of the
// inverse and of the points passed over, some 10 ms.
constexpr std::int64_t kPivotsBetweenLooks = 512;
constexpr double kEntriesBetweenLooks = 2e7;
constexpr int kCostRaises = 14;  // 8^14 = 2^42: beyond, the first phase decides
constexpr double kLargeCost = 0x1p42;
constexpr int kRepairs = 3;
constexpr int kIdlePivots = 32;  // that an impatient solve allows, and half as many more as there are rows
// Margins of Farkas directions, tried in turn: far above the rounding in u·q, and far below most margins that
// random points leave.
constexpr double kMargins[] = {0x1p-24, 0x1p-36};
constexpr double kDrift = 1e-9;      // of the equations, after which the inverse is computed afresh
constexpr double kProgress = 1e-12;  // of the objective, relative, between two looks
constexpr double kNoise = 1e-14;     // of an objective, in units where both sets have magnitude 1
constexpr int kIdleLooks = 4;        // without progress: rounding leads the pivots in circles

std::int64_t default_pivot_limit(int n) { return 2000 + 400 * static_cast<std::int64_t>(n); }

std::int64_t pivots_between_looks(int m, std::ptrdiff_t points) {
  const double entries = static_cast<double>(m) * (m + 0.25 * static_cast<double>(points));
  return std::clamp(static_cast<std::int64_t>(kEntriesBetweenLooks / entries), std::int64_t{8},
                    kPivotsBetweenLooks);
}

// Whether the distance of A from the cone outweighs the margin: the objective is -h_A(u).
bool is_separated(Basis& basis) {
  basis.refresh_duals();
  return basis.view().objective > 0;
}

// Now and then in a long solve: whether the objective still falls.
struct Progress {
  std::int64_t pivots = 0;
  double least = kInfinity;
  int idle_looks = 0;

  bool has_ended(const BasisView& basis) noexcept {
    if (basis.pivots - pivots < kPivotsBetweenLooks) return false;
    pivots = basis.pivots;
    idle_looks = basis.objective < least * (1 - kProgress) ? 0 : idle_looks + 1;
    least = std::min(least, basis.objective);
    return idle_looks >= kIdleLooks;
  }
};

}  // namespace

bool is_final(PrimalSimplex::End end) noexcept {
  return end == PrimalSimplex::End::failed || end == PrimalSimplex::End::pivot_limit ||
         end == PrimalSimplex::End::time_limit;
}

void PrimalSimplex::begin(int n, double gap_tolerance, std::int64_t max_pivots, const Kernels& kernels,
                          bool impatient) {
  n_ = n;
  kernels_ = &kernels;
  stage_ = Stage::optimise;
  raises_ = separations_ = repairs_ = 0;
  refactorisations_ = 0;
  impatient_ = impatient;
  max_pivots_ = max_pivots > 0 ? max_pivots : default_pivot_limit(n);
  loop_ = {};
  loop_.gap_tolerance = gap_tolerance;
  loop_.cost_tolerance = 4 * std::numeric_limits<double>::epsilon() * (n + 1);
  column_.reserve(static_cast<std::size_t>(padded_rows(n + 1)));
  first_.begin(n, kernels);
}

bool PrimalSimplex::start_from(const ColumnPool& A, const ColumnPool& Q, std::span<const std::int64_t> ids,
                               const Stopwatch& stopwatch) {
  if (std::ssize(ids) != n_ + 1) return false;
  ++refactorisations_;
  loop_.artificials = 0;
  loop_.first_A.count = 0;
  return first_.choose(A, Q, ids, stopwatch, basis_);
}

bool PrimalSimplex::enter(const ColumnPool& pool, std::int64_t id, double reduced_cost) {
  basis_.form_column(pool, id, column_.data());
  std::int64_t left = 0;
  const double cost = is_from_Q(id) ? loop_.cost_of_Q : 0.0;
  if (kernels_->pivot(&basis_.view(), column_.data(), cost, reduced_cost, id, false, &left) !=
      PivotResult::ok) {
    return false;
  }
  if (is_artificial(left)) --loop_.artificials;
  return true;
}

PrimalSimplex::End PrimalSimplex::solve(const ColumnPool& A, const ColumnPool& Q,
                                        const Stopwatch& stopwatch) {
  const End end = optimise(A, Q, stopwatch);
  if (end == End::solved) basis_.refresh_duals();
  return end;
}

// Whether the objective has fallen from `before`. One that is zero but for rounding cannot: it is no negative
// number.
bool PrimalSimplex::gains(double before) const {
  const double now = basis_.view().objective;
  if (stage_ == Stage::optimise && now < kNoise) return false;
  return now < before - kProgress * std::fabs(before);
}

void PrimalSimplex::bind(const ColumnPool& A, const ColumnPool& Q) {
  loop_.A = A.view();
  loop_.Q = Q.view();
  loop_.noise_A = kUnitRoundoff * A.magnitude();
  loop_.noise_Q = kUnitRoundoff * Q.magnitude();
}

PrimalSimplex::End PrimalSimplex::optimise(const ColumnPool& A, const ColumnPool& Q,
                                           const Stopwatch& stopwatch) {
  BasisView& view = basis_.view();
  bind(A, Q);
  Progress progress{view.pivots};
  std::int64_t between_looks = pivots_between_looks(n_ + 1, A.size() + Q.size());
  if (impatient_) between_looks = std::min<std::int64_t>(between_looks, kIdlePivots + n_ / 2);
  for (;;) {
    loop_.pivot_limit = std::min(max_pivots_, view.pivots + between_looks);
    const double objective = view.objective;
    const LoopEnd end = kernels_->simplex_loop(&view, &loop_);
    if (end == LoopEnd::pivot_limit) {
      const bool out_of_pivots = view.pivots >= max_pivots_;
      if (!out_of_pivots && !stopwatch.expired()) {
        if (impatient_ && !gains(objective)) return End::stalled;
        if (!(basis_.drift() <= kDrift) && !invert()) return End::failed;
        if (progress.has_ended(view)) return End::failed;
        continue;
      }
      basis_.refresh_duals();
      return out_of_pivots ? End::pivot_limit : End::time_limit;
    }
    if (stage_ == Stage::separate && (end != LoopEnd::optimal || !is_separated(basis_))) {
      if (!separate()) enter_stage(Stage::reach);
      continue;
    }
    if (end == LoopEnd::stalled && impatient_) return End::stalled;
    const bool no_time_to_invert = stopwatch.expired() || !affords_inverse(stopwatch, n_ + 1, *kernels_);
    if (end == LoopEnd::unbounded || end == LoopEnd::stalled) {
      if (no_time_to_invert) return End::time_limit;
      if (!repair()) return End::failed;
      loop_.bland = end == LoopEnd::stalled;
      continue;
    }
    const bool artificial = basis_.has_artificial_weight();
    if (!artificial && !stopwatch.expired() && stage_ == Stage::optimise) return End::solved;
    basis_.refresh_duals();
    if (no_time_to_invert) return End::time_limit;
    if (artificial) return stage_ == Stage::optimise ? End::bounded : End::unreachable;
    enter_stage(Stage::optimise);
  }
}

bool PrimalSimplex::repair() {
  if (++repairs_ > kRepairs) return false;
  loop_.gap_tolerance = 0;
  return invert();
}

void PrimalSimplex::raise_bounds() {
  if (++raises_ > kCostRaises) return enter_stage(Stage::reach);
  BasisView& view = basis_.view();
  for (int i = 0; i < view.m; ++i) {
    if (is_artificial(view.id[i])) view.cost[i] = 8 * (view.cost[i] + 0.125);
  }
  basis_.refresh_duals();
}

bool PrimalSimplex::separate() {
  if (separations_ >= static_cast<int>(std::size(kMargins))) return false;
  ++separations_;
  enter_stage(Stage::separate);
  return true;
}

void PrimalSimplex::enter_stage(Stage stage) {
  stage_ = stage;
  const double costs[] = {1.0, 0.0, separations_ > 0 ? -kMargins[separations_ - 1] : 0.0};
  loop_.cost_of_Q = costs[static_cast<int>(stage)];
  BasisView& view = basis_.view();
  for (int i = 0; i < view.m; ++i) {
    if (is_artificial(view.id[i])) {
      view.cost[i] = stage == Stage::optimise ? kLargeCost : 1.0;
    } else {
      view.cost[i] = is_from_Q(view.id[i]) ? loop_.cost_of_Q : 0.0;
    }
  }
  if (!invert()) basis_.refresh_duals();
}

PrimalSimplex::Thresholds PrimalSimplex::thresholds() const noexcept {
  const double t = basis_.view().y[n_], length = basis_.dual_length();
  return {-t + 2 * loop_.cost_tolerance * std::fabs(t) + length * loop_.noise_A,
          loop_.cost_of_Q + loop_.cost_tolerance + length * loop_.noise_Q};
}

}  // namespace raygauge
