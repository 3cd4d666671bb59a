// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "baselines/exact_lp.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <span>
#include <string>

#include "baselines/exact_basis.h"
#include "baselines/exact_columns.h"
#include "baselines/float_start.h"
#include "engine/numerics/floating_point.h"
#include "raygauge/exceptions.h"

namespace raygauge {
namespace {

using Clock = std::chrono::steady_clock;
using ColumnRange = std::span<const std::ptrdiff_t>;

Clock::time_point deadline_after(double seconds) {
  const Clock::time_point now = Clock::now();
  const auto left = std::chrono::duration<double>(Clock::time_point::max() - now).count();
  if (!(seconds < left / 2)) return Clock::time_point::max();
  return now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// The primal simplex with artificial variables at a cost that exceeds every number: costs, and so duals and
/// reduced costs, are pairs (infeasibility, cost) compared lexicographically. One phase then does for all,
/// and artificial variables that stay basic at zero (columns of lower rank) need no special treatment.
class ExactSimplex {
 public:
  ExactSimplex(const ExactColumns& columns, Clock::time_point deadline)
      : columns_(columns),
        deadline_(deadline),
        basis_(columns.rows()),
        is_basic_(static_cast<std::size_t>(columns.count())) {}

  /// Pivots until no column of the range improves. False if the deadline passed first.
  bool optimize(ColumnRange range) {
    int stalled = 0;
    while (Clock::now() < deadline_) {
      update_duals();
      const bool bland = stalled > 2 * basis_.rows();
      const std::ptrdiff_t j = find_entering(range, bland);
      if (j < 0) return true;
      stalled = enter(j, bland) ? 0 : stalled + 1;
    }
    return false;
  }

  const ExactBasis& basis() const noexcept { return basis_; }
  std::int64_t pivots() const noexcept { return pivots_; }

  /// D·duals of the sum of artificial variables, then of the cost. The last entry (-D for the cost) completes
  /// the product with a column and its cost to -D times the reduced cost.
  const IntegerVector& infeasibility_dual() const noexcept { return infeasibility_dual_; }
  const IntegerVector& cost_dual() const noexcept { return cost_dual_; }

 private:
  void update_duals() {
    infeasibility_dual_.assign(static_cast<std::size_t>(basis_.rows()) + 1, 0);
    cost_dual_ = infeasibility_dual_;
    for (int row = 0; row < basis_.rows(); ++row) {
      const std::ptrdiff_t j = basis_.column(row);
      if (j == ExactBasis::kArtificial) {
        basis_.add_row(row, infeasibility_dual_);
      } else if (columns_.is_gauge(j)) {
        basis_.add_row(row, cost_dual_);
      }
    }
    cost_dual_.back() = -basis_.determinant();
  }

  /// The column with the most negative reduced cost, or with `bland` the first negative one; -1 if none is.
  std::ptrdiff_t find_entering(ColumnRange range, bool bland) const {
    ExactProduct infeasibility(columns_, infeasibility_dual_), cost(columns_, cost_dual_);
    std::ptrdiff_t best = -1;
    bool best_is_infeasibility = false;
    long double best_magnitude = 0;
    for (const std::ptrdiff_t j : range) {
      if (is_basic_[static_cast<std::size_t>(j)]) continue;
      ExactProduct::Sign gain = infeasibility.sign(j);
      const bool is_infeasibility = gain.sign != 0;
      if (!is_infeasibility) gain = cost.sign(j);
      if (gain.sign <= 0) continue;
      if (bland) return j;
      const bool better = best < 0 || (is_infeasibility && !best_is_infeasibility) ||
                          (is_infeasibility == best_is_infeasibility && gain.magnitude > best_magnitude);
      if (!better) continue;
      best = j;
      best_is_infeasibility = is_infeasibility;
      best_magnitude = gain.magnitude;
    }
    return best;
  }

  bool enter(std::ptrdiff_t j, bool bland) {
    columns_.copy(j, entering_);
    const ExactBasis::Step step = basis_.enter(j, entering_, bland);
    is_basic_[static_cast<std::size_t>(j)] = true;
    if (step.left != ExactBasis::kArtificial) is_basic_[static_cast<std::size_t>(step.left)] = false;
    ++pivots_;
    return step.moved;
  }

  const ExactColumns& columns_;
  Clock::time_point deadline_;
  ExactBasis basis_;
  std::vector<bool> is_basic_;
  IntegerVector infeasibility_dual_;
  IntegerVector cost_dual_;
  IntegerVector entering_;
  std::int64_t pivots_ = 0;
};

/// Reads the weights and their sums off the basis: Σβ to `value`, the sum of artificial variables is
/// returned.
Rational read_primal(const ExactColumns& columns, const ExactBasis& basis, ExactLpResult& result) {
  const std::ptrdiff_t size_A = columns.first_gauge();
  Integer infeasibility = 0, cost = 0;
  for (int row = 0; row < basis.rows(); ++row) {
    const std::ptrdiff_t j = basis.column(row);
    const Integer& scaled = basis.scaled_value(row);
    if (j == ExactBasis::kArtificial) {
      infeasibility += scaled;
      continue;
    }
    result.basis.push_back(j);
    if (columns.is_gauge(j)) cost += scaled;
    if (scaled == 0) continue;
    const Rational weight(scaled, basis.determinant());
    if (columns.is_gauge(j)) {
      result.beta.push_back({j - size_A, weight});
    } else {
      result.alpha.push_back({j, weight});
    }
  }
  std::sort(result.basis.begin(), result.basis.end());
  result.value = Rational(cost, basis.determinant());
  return {infeasibility, basis.determinant()};
}

/// The least K >= 0 at which the duals K·infeasibility + cost are feasible for every column. At an optimal
/// basis each column has a reduced cost that is lexicographically nonnegative, so that there is one.
Rational least_penalty(const ExactColumns& columns, const ExactSimplex& simplex) {
  ExactProduct infeasibility(columns, simplex.infeasibility_dual()), cost(columns, simplex.cost_dual());
  Rational K = 0;
  if (infeasibility.is_zero()) return K;
  for (std::ptrdiff_t j = 0; j < columns.count(); ++j) {
    if (cost.sign(j).sign <= 0 || infeasibility.sign(j).sign >= 0) continue;
    const Rational needed(cost.exact(j), -infeasibility.exact(j));
    if (needed > K) K = needed;
  }
  return K;
}

/// u and t from duals of the rows in integers: (p_1·2^shift_1, …, p_n·2^shift_n, p_{n+1}) / D.
void read_dual(const ExactColumns& columns, const std::vector<Rational>& p, ExactLpResult& result) {
  for (int k = 0; k + 1 < columns.rows(); ++k) {
    result.u.push_back(scaled_rational(p[static_cast<std::size_t>(k)], columns.shift(k)));
  }
  result.t = p[static_cast<std::size_t>(columns.rows()) - 1];
}

void read_optimal_dual(const ExactColumns& columns, const ExactSimplex& simplex, ExactLpResult& result) {
  const Rational K = least_penalty(columns, simplex);
  const Rational D(simplex.basis().determinant());
  std::vector<Rational> p;
  for (std::size_t k = 0; k + 1 < simplex.cost_dual().size(); ++k) {
    p.push_back((K * Rational(simplex.infeasibility_dual()[k]) + Rational(simplex.cost_dual()[k])) / D);
  }
  read_dual(columns, p, result);
}

void read_farkas(const ExactColumns& columns, const ExactSimplex& simplex, ExactLpResult& result) {
  const IntegerVector& dual = simplex.infeasibility_dual();
  read_dual(columns, {dual.begin(), dual.end()}, result);
}

ExactLpResult read_result(const ExactColumns& columns, const ExactSimplex& simplex, bool finished) {
  ExactLpResult result;
  result.pivots = simplex.pivots();
  const bool feasible = read_primal(columns, simplex.basis(), result) == 0;
  if (!feasible) {
    result.alpha.clear();
    result.beta.clear();
    result.rounded = {finished ? kInfinity : 0, kInfinity, kInfinity};
  } else {
    result.rounded = round_nonnegative(result.value);
    if (!finished) result.rounded.lower = 0;
  }
  if (!finished) {
    result.status = DistanceStatus::time_limit;
  } else if (!feasible) {
    result.status = DistanceStatus::unreachable;
    read_farkas(columns, simplex, result);
  } else {
    result.status = result.value == 0 ? DistanceStatus::contains_origin : DistanceStatus::optimal;
    read_optimal_dual(columns, simplex, result);
  }
  return result;
}

ExactLpResult run(const ExactColumns& columns, ColumnRange suggested, Clock::time_point deadline) {
  ExactSimplex simplex(columns, deadline);
  std::vector<std::ptrdiff_t> all(static_cast<std::size_t>(columns.count()));
  std::iota(all.begin(), all.end(), 0);
  const bool finished = simplex.optimize(suggested) && simplex.optimize(all);
  return read_result(columns, simplex, finished);
}

}  // namespace

ExactLpResult solve_exact_lp(const PointSet& A, const PointSet& Q, double time_limit) {
  const Clock::time_point deadline = deadline_after(time_limit);
  const ExactColumns columns(A, Q);
  return run(columns, float_start(columns, deadline), deadline);
}

}  // namespace raygauge
