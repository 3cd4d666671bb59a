// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The simplex loop of the direct method. Part of kernel_impl.h.
#pragma once

#include "engine/kernel/basis_kernels.h"
#include "engine/kernel/certificate_kernels.h"
#include "engine/kernel/support_kernels.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// One candidate to enter the basis: a point of A (cost 0, convexity 1) or of Q (negated, cost 1, convexity
// 0).
struct Candidate {
  const double* blocks;
  std::ptrdiff_t index;
  bool from_Q;
};

// Reduced costs below this, relative to the support value, are beyond single precision.
constexpr double kSingleTolerance = 1e-6;

// Duals and objective anew from the inverse: columns chosen in single precision entered with rounded reduced
// costs.
inline void refresh(BasisView* basis) {
  plain_duals(basis);
  basis->objective = 0;
  for (int i = 0; i < basis->m; ++i) basis->objective += basis->cost[i] * basis->x()[i];
}

inline void form_column(const Candidate& candidate, int n, double* column) {
  const double* p = candidate.blocks + (candidate.index / kLanes) * n * kLanes + candidate.index % kLanes;
  if (candidate.from_Q) {
    for (int k = 0; k < n; ++k) column[k] = -p[k * kLanes];
    column[n] = 0.0;
  } else {
    for (int k = 0; k < n; ++k) column[k] = p[k * kLanes];
    column[n] = 1.0;
  }
}

inline double dual_length(const BasisView& basis) {
  double sum = 0;
  for (int k = 0; k < basis.m - 1; ++k) sum += absolute(basis.y[k]);
  return sum;
}

inline double reduced_cost(const BasisView& basis, const double* column, double cost) {
  double sum = 0;
  for (int k = 0; k < basis.m; ++k) sum += basis.y[k] * column[k];
  return cost - sum;
}

// The best point of each set at the present duals.
struct Pricing {
  Candidate from_A;
  Candidate from_Q;
  double h_A;
  double h_Q;
};

template <int N, class Real>
inline Pricing price_both(const BasisView& basis, const DirectLoop& loop, const Real* A,
                          std::ptrdiff_t count_A, const Real* Q, std::ptrdiff_t count_Q, Real* u,
                          Real* negative) {
  const int n = basis.m - 1;
  for (int k = 0; k < n; ++k) {
    u[k] = static_cast<Real>(basis.y[k]);
    negative[k] = -u[k];
  }
  Pricing best{{loop.A.blocks, 0, false}, {loop.Q.blocks, 0, true}, 0, 0};
  best.h_A = price_n<N>(A, count_A, n, u, &best.from_A.index);
  best.h_Q = price_n<N>(Q, count_Q, n, negative, &best.from_Q.index);
  return best;
}

template <int V, int N>
LoopEnd direct_loop_vn(BasisView* basis, DirectLoop* loop) {
  const int n = basis->m - 1;
  constexpr int kFixed = V > 0 ? V * kRowPadding : 1;
  alignas(64) double fixed[3][kFixed] = {};
  double* column = V > 0 ? fixed[0] : basis->row + padded_rows(basis->m + 1);
  double* u = V > 0 ? fixed[1] : column + basis->P;
  double* negative = V > 0 ? fixed[2] : u + basis->P;
  // Half the bytes and twice the lanes while there is much to gain; every column's own arithmetic is in
  // double.
  bool single = loop->A.single_blocks != nullptr && loop->Q.single_blocks != nullptr && !loop->bland;
  int idle = 0;
  const int patience = 8 * basis->m + 64;
  while (basis->pivots < loop->pivot_limit) {
    const double t = basis->y[n];
    // A column that enters for a reduced cost made of rounding can lead the pivots in circles. Summed before
    // the pricing, whose loads hide it.
    const double length = dual_length(*basis);
    const Pricing best = single
                             ? price_both<N>(*basis, *loop, loop->A.single_blocks, loop->A.single_block_count,
                                             loop->Q.single_blocks, loop->Q.single_block_count,
                                             reinterpret_cast<float*>(u), reinterpret_cast<float*>(negative))
                             : price_both<N>(*basis, *loop, loop->A.blocks, loop->A.block_count,
                                             loop->Q.blocks, loop->Q.block_count, u, negative);
    loop->points_priced += (loop->A.block_count + loop->Q.block_count) * kLanes;
    ++loop->pricings;
    const double cost_tolerance = single ? kSingleTolerance : loop->cost_tolerance;
    const double d_A = -(best.h_A + t);
    const double d_Q = loop->cost_of_Q - best.h_Q;
    const double tolerance_A = cost_tolerance * (absolute(t) + absolute(best.h_A)) + length * loop->noise_A;
    const double tolerance_Q = cost_tolerance + length * loop->noise_Q;
    const bool A_enters = d_A < -tolerance_A;
    const bool Q_enters = d_Q < -tolerance_Q;
    if (!A_enters && !Q_enters) {
      if (!single) {
        loop->h_A = best.h_A;
        loop->h_Q = best.h_Q;
        return LoopEnd::optimal;
      }
      single = false;
      refresh(basis);
      continue;
    }
    if (!single && loop->artificials == 0 && best.h_Q > 0 &&
        basis->objective + best.h_A / best.h_Q <= loop->gap_tolerance * basis->objective) {
      loop->h_A = best.h_A;
      loop->h_Q = best.h_Q;
      return LoopEnd::gap;
    }
    // The larger promised gain first: α moves by at most 1, β by about the objective.
    const bool A_first = A_enters && (!Q_enters || d_A < d_Q * absolute(t));
    double gained = 0;
    for (int turn = 0; turn < 2; ++turn) {
      const bool take_A = (turn == 0) == A_first;
      if (!(take_A ? A_enters : Q_enters)) continue;
      const Candidate& candidate = take_A ? best.from_A : best.from_Q;
      form_column(candidate, n, column);
      const double cost = take_A ? 0.0 : loop->cost_of_Q;
      double d = take_A ? d_A : d_Q;
      if (turn == 1) {
        d = reduced_cost(*basis, column, cost);
        if (!(d < -(take_A ? tolerance_A : tolerance_Q))) continue;
      }
      std::int64_t left = 0;
      double theta = 0;
      const std::int64_t id = take_A ? id_of_A(candidate.index) : id_of_Q(candidate.index);
      if (enter<V>(basis, column, cost, d, id, loop->bland, &left, &theta) < 0) return LoopEnd::unbounded;
      if (left < 0) --loop->artificials;
      gained -= theta * d;
    }
    if (gained > 1e-14 * absolute(basis->objective)) {
      idle = 0;
    } else if (++idle > (single ? basis->m : patience) && !loop->bland) {
      if (!single) return LoopEnd::stalled;
      single = false;
      idle = 0;
      refresh(basis);
    }
  }
  return LoopEnd::pivot_limit;
}

LoopEnd direct_loop(BasisView* basis, DirectLoop* loop) {
  switch (basis->m - 1) {
    case 2:
      return direct_loop_vn<1, 2>(basis, loop);
    case 3:
      return direct_loop_vn<1, 3>(basis, loop);
    case 4:
      return direct_loop_vn<1, 4>(basis, loop);
    case 5:
      return direct_loop_vn<1, 5>(basis, loop);
    case 6:
      return direct_loop_vn<1, 6>(basis, loop);
    case 7:
      return direct_loop_vn<1, 7>(basis, loop);
    case 8:
      return direct_loop_vn<2, 8>(basis, loop);
    case 9:
      return direct_loop_vn<2, 9>(basis, loop);
    case 10:
      return direct_loop_vn<2, 10>(basis, loop);
    default:
      break;
  }
  switch (basis->P / kRowPadding) {
    case 1:
      return direct_loop_vn<1, 0>(basis, loop);
    case 2:
      return direct_loop_vn<2, 0>(basis, loop);
    case 3:
      return direct_loop_vn<3, 0>(basis, loop);
    default:
      return direct_loop_vn<0, 0>(basis, loop);
  }
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
