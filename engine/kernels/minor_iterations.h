// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The basis changes between two passes. Part of kernel_impl.h.
#pragma once

#include <type_traits>

#include "engine/kernels/shortlist_kernels.h"
#include "engine/kernels/tableau_kernels.h"
#include "engine/kernels/tuning.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// Of any dimension: shortlists of eight points of each set, whose reduced costs are computed again after
// every basis change.
template <int V, int N>
class Shortlists {
 public:
  Shortlists(const BasisView& basis, double* block_A, double* block_Q) : n_(basis.m - 1) {
    A_.block = block_A;
    Q_.block = block_Q;
  }

  template <class Real>
  void keep(const LaneMaxima<Real>& A, const LaneMaxima<Real>& Q, const BasisView& /*basis*/,
            const SimplexLoop& loop) {
    fill<N>(&A_, A, loop.A, n_, 1.0);
    fill<N>(&Q_, Q, loop.Q, n_, -1.0);
  }

  void keep_first(const BasisView& /*basis*/, const SimplexLoop& loop) {
    for (int lane = 0; lane < kLanes; ++lane) {
      A_.index[lane] = loop.first_A.index[lane];
      Q_.index[lane] = loop.first_Q.index[lane];
    }
    copy_points<N>(&A_, loop.A, n_, 1.0);
    copy_points<N>(&Q_, loop.Q, n_, -1.0);
  }

  // Pivots while something prices out. False if a column finds no pivot. *gained is the fall of the
  // objective.
  bool iterate(BasisView* basis, SimplexLoop* loop, Candidates best, double* column, double* gained) {
    // Copies, which stores through other pointers leave in registers.
    const int n = N > 0 ? N : n_;
    const Shortlist A = A_;
    const Shortlist Q = Q_;
    double promised = 0;  // by the first
    const int changes = tuned::kChangesByShortlist;
    for (int turn = 0; turn < changes && basis->pivots < loop->pivot_limit; ++turn) {
      const double t = basis->y[n];
      int lane_A = 0;
      int lane_Q = 0;
      best.d_A = -(price_shortlist<N>(A, n, basis->y, &lane_A) + t);
      best.d_Q = loop->cost_of_Q - price_shortlist<N>(Q, n, basis->y, &lane_Q);
      if (!best.any_enters()) return true;
      // The larger promised gain: α moves by at most 1, β by about the objective.
      const bool take_A = best.A_enters() && (!best.Q_enters() || best.d_A < best.d_Q * absolute(t));
      if (V == 0) {
        const double promise = take_A ? -best.d_A : -best.d_Q * absolute(t);
        if (promise < tuned::kColumnWorthEntering * promised) return true;
        if (turn == 0) promised = promise;
      }
      const Shortlist& list = take_A ? A : Q;
      const int lane = take_A ? lane_A : lane_Q;
      for (int k = 0; k < n; ++k) column[k] = list.block[k * kLanes + lane];
      column[n] = take_A ? 1.0 : 0.0;
      const double cost = take_A ? 0.0 : loop->cost_of_Q;
      const double d = take_A ? best.d_A : best.d_Q;
      const std::int64_t id = take_A ? id_of_A(list.index[lane]) : id_of_Q(list.index[lane]);
      std::int64_t left = 0;
      double theta = 0;
      if (enter<V, N>(basis, column, cost, d, id, loop->bland, &left, &theta) < 0) return false;
      if (left < 0) --loop->artificials;
      *gained -= theta * d;
    }
    return true;
  }

 private:
  int n_;
  Shortlist A_;
  Shortlist Q_;
};

// What sets the columns of A and of Q apart, as numbers: a branch would be foreseen every other time.
struct ColumnsOfSet {
  const double* blocks;
  std::ptrdiff_t size;
  double sign;
  double last;  // entry of a column
  double cost;
  double limit;  // a reduced cost below it is no rounding
};

// A column that may enter, made of a point: w = R column, and its reduced cost d. As ftran and replace, but
// for few rows of a known number, and in registers.
template <int V, int N>
struct Entering {
  static constexpr int kPacks = V * kRowPadding / kWidth;
  static constexpr int kStride = V * kRowPadding;
  // For a row that was found in single precision.
  static constexpr double kSafePivot = 0x1p-10;
  static constexpr double kMuchLarger = 1.5;

  Pack w[kPacks];
  double d;

  Entering(const BasisView& basis, const ColumnsOfSet& set, const double* point) {
    const double* R = basis.R;
    const double* y = basis.y;
    Pack sum[2][kPacks] = {};
    double product = 0;  // summed as in a pass, so that both agree on what prices out
#pragma GCC unroll 16
    for (int k = 0; k < N; ++k, R += kStride) {
      const double p = point[k * kLanes];
      for (int t = 0; t < kPacks; ++t) sum[k % 2][t] += broadcast(p) * load(R + t * kWidth);
      product += p * y[k];
    }
    for (int t = 0; t < kPacks; ++t) {
      w[t] = set.sign * (sum[0][t] + sum[1][t]) + set.last * load(R + t * kWidth);
      store(basis.w + t * kWidth, w[t]);
    }
    d = set.cost - (set.sign * product + set.last * y[N]);
  }

  // Whether no basic variable falls below zero, but for Harris' tolerance, where this one leaves; and whether
  // none that falls to zero as well has a much larger pivot, as in the ratio test.
  bool may_replace(const BasisView& basis, int r) const {
    const double* x = basis.x();
    const double pivot = basis.w[r];
    const Pack theta = broadcast(x[r] / pivot);
    constexpr unsigned kAllLanes = (1U << kWidth) - 1;
    unsigned lanes = pivot > kSafePivot ? kAllLanes : 0;  // where nothing falls below; NaN does
    for (int t = 0; t < kPacks; ++t) {
      const Pack left = load(x + t * kWidth) - theta * w[t];
      const Pack larger = left < broadcast(kHarrisTolerance) ? w[t] : Pack{};
      lanes &= lanes_above(left, -kHarrisTolerance) & ~lanes_above(larger, kMuchLarger * pivot);
    }
    return lanes == kAllLanes;
  }

  // Basic column r gives way. Returns the step length θ.
  double replace(BasisView* basis, int r, const ColumnsOfSet& set, const double* point,
                 std::int64_t id) const {
    const double inverse = 1.0 / basis->w[r];
    const double step = d * inverse;
    Pack fixed[kPacks];  // less 1 in row r, so that one formula updates it too
    for (int t = 0; t < kPacks; ++t) {
      const IndexPack lanes = lane_numbers<IndexPack>() + static_cast<long long>(t) * kWidth;
      fixed[t] = (lanes == broadcast_index(r) ? w[t] - 1.0 : w[t]) * inverse;
    }
    double* R = basis->R;
    double* y = basis->y;
    double* B = basis->B + r * kStride;
    const double theta = basis->x()[r] * inverse;
#pragma GCC unroll 16
    for (int k = 0; k <= N + 1; ++k, R += kStride) {
      const double share = R[r];
      if (k <= N) y[k] += step * share;
      for (int t = 0; t < kPacks; ++t)
        store(R + t * kWidth, load(R + t * kWidth) - broadcast(share) * fixed[t]);
    }
#pragma GCC unroll 16
    for (int k = 0; k < N; ++k) B[k] = set.sign * point[k * kLanes];
    B[N] = set.last;
    basis->cost[r] = set.cost;
    basis->id[r] = id;
    basis->objective += theta * d;
    ++basis->pivots;
    return theta;
  }

  // For the general kernels, which find w in the basis.
  static void copy_column(const ColumnsOfSet& set, const double* point, double* column) {
    for (int k = 0; k < N; ++k) column[k] = set.sign * point[k * kLanes];
    column[N] = set.last;
  }
};

// Of few dimensions N: a tableau of the points of all lanes.
template <int V, int N>
class Tableaux {
 public:
  Tableaux(const BasisView& /*basis*/, double* /*block_A*/, double* /*block_Q*/) {}

  template <class Real>
  void keep(const LaneMaxima<Real>& A, const LaneMaxima<Real>& Q, const BasisView& basis,
            const SimplexLoop& loop) {
    auto& tableau = start<Real>();
    take_lanes<N>(&tableau, 0, A, static_cast<Real>(-basis.y[N]));
    take_lanes<N>(&tableau, tableau.kOfSet, Q, static_cast<Real>(loop.cost_of_Q));
    gather<N>(&tableau, numbers<Real>(loop.A), numbers<Real>(loop.Q));
  }

  void keep_first(const BasisView& basis, const SimplexLoop& loop) {
    if (loop.first_A.count > kLanes && loop.first_Q.count > kLanes) return keep_listed<float>(basis, loop);
    keep_listed<double>(basis, loop);
  }

  bool iterate(BasisView* basis, SimplexLoop* loop, const Candidates& worth, double* column, double* gained) {
    return is_single_ ? iterate(&single_, basis, loop, worth, column, gained)
                      : iterate(&double_, basis, loop, worth, column, gained);
  }

 private:
  template <class Real>
  Tableau<N, Real>& start() {
    is_single_ = std::is_same_v<Real, float>;
    if constexpr (std::is_same_v<Real, float>) {
      return single_;
    } else {
      return double_;
    }
  }

  template <class Real>
  static const Real* numbers(const PricedPoints& points) {
    if constexpr (std::is_same_v<Real, float>) {
      return points.single_blocks;
    } else {
      return points.blocks;
    }
  }

  template <class Real>
  void keep_listed(const BasisView& basis, const SimplexLoop& loop) {
    auto& tableau = start<Real>();
    constexpr std::ptrdiff_t kPoints = Vec<Real>::kPoints;
    const auto offset = [](std::ptrdiff_t i) { return i / kPoints * (N * kPoints) + i % kPoints; };
    for (int lane = 0; lane < kPoints; ++lane) {
      tableau.offset[lane] = static_cast<typename Vec<Real>::Integer>(offset(loop.first_A.index[lane]));
      tableau.offset[kPoints + lane] =
          static_cast<typename Vec<Real>::Integer>(offset(loop.first_Q.index[lane]));
    }
    // The last one gives way to x.
    if (loop.first_Q.best == loop.first_Q.index[kPoints - 1]) {
      tableau.offset[2 * kPoints - 2] = tableau.offset[2 * kPoints - 1];
    }
    gather<N>(&tableau, numbers<Real>(loop.A), numbers<Real>(loop.Q));
    form_reduced_costs<N>(&tableau, basis, loop.cost_of_Q);
  }

  template <class Real>
  static bool iterate(Tableau<N, Real>* tableau, BasisView* basis, SimplexLoop* loop, const Candidates& worth,
                      double* column, double* gained) {
    const bool dantzig = loop->bland;
    set_limits(tableau, worth);
    const ColumnsOfSet sets[2] = {
        {loop->A.blocks, loop->A.size, 1.0, 1.0, 0.0, -worth.tolerance_A},
        {loop->Q.blocks, loop->Q.size, -1.0, 0.0, loop->cost_of_Q, -worth.tolerance_Q}};
    Proposal next = form<V>(tableau, *basis, dantzig);
    const int changes = tuned::kChangesByTableau;
    for (int turn = 0; turn < changes && next.column >= 0 && basis->pivots < loop->pivot_limit; ++turn) {
      const int of_Q = next.column >= tableau->kOfSet ? 1 : 0;
      const ColumnsOfSet& set = sets[of_Q];
      const std::ptrdiff_t i = point_of(*tableau, next.column, set.size);
      const double* point = set.blocks + i / kLanes * (N * kLanes) + i % kLanes;
      const Proposal made = next;
      next = change(tableau, made, dantzig);
      const Entering<V, N> entering(*basis, set, point);
      if (!(entering.d < set.limit)) return true;
      const std::int64_t id = id_of_A(i) + of_Q;
      if (!loop->bland && entering.may_replace(*basis, made.row)) [[likely]] {
        loop->artificials -= basis->id[made.row] < 0 ? 1 : 0;
        *gained -= entering.replace(basis, made.row, set, point, id) * entering.d;
        continue;
      }
      entering.copy_column(set, point, column);
      const int row = leaving_row<V>(*basis, loop->bland);
      if (row < 0) return false;
      loop->artificials -= basis->id[row] < 0 ? 1 : 0;
      *gained -= replace<V, N>(basis, row, column, set.cost, entering.d, id) * entering.d;
      form_reduced_costs<N>(tableau, *basis, loop->cost_of_Q);
      next = form<V>(tableau, *basis, dantzig);
    }
    return true;
  }

  bool is_single_ = false;
  Tableau<N, float> single_;
  Tableau<N, double> double_;
};

// With registers of two doubles the rows of more dimensions take longer than the basis changes that they
// spare.
template <int V, int N>
using MinorIterations = std::conditional_t<(N > 0 && kWidth > 2), Tableaux<V, N>, Shortlists<V, N>>;

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
