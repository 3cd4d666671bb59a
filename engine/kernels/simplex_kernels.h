// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The simplex loop of the primal simplex. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/basis_kernels.h"
#include "engine/kernels/certificate_kernels.h"
#include "engine/kernels/minor_iterations.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

inline double dual_length(const BasisView& basis) {
  double sum = 0;
  for (int k = 0; k < basis.m - 1; ++k) sum += absolute(basis.y[k]);
  return sum;
}

// A pass over both sets at the present duals.
struct Pricing {
  double h_A = 0;
  double h_Q = 0;
  Candidates best;
};

template <class Real>
struct Blocks {
  const Real* data;
  std::ptrdiff_t count;
};

template <int N, class Real, class Lists>
inline Pricing price_both(const BasisView& basis, const SimplexLoop& loop, Blocks<Real> A, Blocks<Real> Q,
                          double cost_tolerance, Real* u, Lists* lists) {
  const int n = N > 0 ? N : basis.m - 1;
  const double t = basis.y[n];
  // A column that enters for a reduced cost made of rounding can lead the pivots in circles. Summed before
  // the passes, whose loads hide it.
  const double length = dual_length(basis);
  Real* negative = u + basis.P;
  for (int k = 0; k < n; ++k) {
    u[k] = static_cast<Real>(basis.y[k]);
    negative[k] = -u[k];
  }
  const LaneMaxima<Real> maxima_A = pass_over<N>(A.data, A.count, n, u);
  const LaneMaxima<Real> maxima_Q = pass_over<N>(Q.data, Q.count, n, negative);
  const double h_A = maxima_A.best();
  const double h_Q = maxima_Q.best();
  const Candidates best = {-(h_A + t), loop.cost_of_Q - h_Q,
                           cost_tolerance * (absolute(t) + absolute(h_A)) + length * loop.noise_A,
                           cost_tolerance + length * loop.noise_Q};
  if (best.any_enters()) lists->keep(maxima_A, maxima_Q, basis, loop);
  return {h_A, h_Q, best};
}

// A pass over both sets, in single precision or in double; what it found is noted in the loop.
template <int N, class Lists>
inline Pricing price_pass(bool single, const BasisView& basis, SimplexLoop* loop, double* u, Lists* lists) {
  const PricedPoints& A = loop->A;
  const PricedPoints& Q = loop->Q;
  const Pricing pricing =
      single ? price_both<N, float>(basis, *loop, {A.single_blocks, A.single_block_count},
                                    {Q.single_blocks, Q.single_block_count}, kSingleTolerance,
                                    reinterpret_cast<float*>(u), lists)
             : price_both<N, double>(basis, *loop, {A.blocks, A.block_count}, {Q.blocks, Q.block_count},
                                     loop->cost_tolerance, u, lists);
  loop->points_priced += (A.block_count + Q.block_count) * kLanes;
  ++loop->pricings;
  loop->h_A = pricing.h_A;
  loop->h_Q = pricing.h_Q;
  return pricing;
}

inline bool gap_is_closed(const BasisView& basis, const SimplexLoop& loop, const Pricing& pricing) {
  return loop.artificials == 0 && pricing.h_Q > 0 &&
         basis.objective + pricing.h_A / pricing.h_Q <= loop.gap_tolerance * basis.objective;
}

// What the passes of a loop have gained. Half the bytes and twice the lanes are priced while there is much to
// gain; every column's own arithmetic is in double.
struct Progress {
  bool single = false;
  int idle = 0;

  // After a pass and its pivots, whose number was `pivots` before. False where the loop stalls: even by
  // Bland's rule, where a column enters that cannot, one that is no number.
  bool note(double gained, const BasisView& basis, const SimplexLoop& loop, std::int64_t pivots) {
    if (gained > 1e-14 * absolute(basis.objective)) {
      idle = 0;
    } else if (single) {
      single = ++idle <= basis.m && gained > 0;
      if (!single) idle = 0;
    } else {
      const int patience = 8 * basis.m + 64;
      return ++idle <= patience || (loop.bland && basis.pivots != pivots);
    }
    return true;
  }
};

// Over the columns that a guess of the normal gave. The first normal lies off that guess, at a corner of its
// bounds, where a pass would find worse ones.
template <class Lists>
inline bool first_iterations(BasisView* basis, SimplexLoop* loop, Lists* lists, double* column) {
  if (loop->first_A.count == 0 || loop->bland) return true;
  lists->keep_first(*basis, *loop);
  loop->first_A.count = 0;
  const Candidates worth = {0, 0, kSingleTolerance * absolute(basis->y[basis->m - 1]), kSingleTolerance};
  double gained = 0;
  return lists->iterate(basis, loop, worth, column, &gained);
}

// Of bases of V rows of vectors (0: any) in R^N (0: any). Those of few rows keep the column, u and -u, and
// the shortlists on the stack.
template <int V, int N>
LoopEnd simplex_loop_vn(BasisView* basis, SimplexLoop* loop) {
  constexpr int kRows = V > 0 ? V * kRowPadding : 1;
  alignas(64) double fixed_column[kRows] = {};  // padded with zeros
  alignas(64) double fixed_u[2 * kRows];
  alignas(64) double fixed_lists[2][kRows * kLanes];
  double* column = V > 0 ? fixed_column : basis->columns;
  double* u = V > 0 ? fixed_u : column + basis->P;
  double* block_A = V > 0 ? fixed_lists[0] : u + static_cast<std::ptrdiff_t>(2) * basis->P;
  double* block_Q = V > 0 ? fixed_lists[1] : block_A + static_cast<std::ptrdiff_t>(basis->P) * kLanes;
  MinorIterations<V, N> lists(*basis, block_A, block_Q);
  if (!first_iterations(basis, loop, &lists, column)) return LoopEnd::unbounded;
  Progress progress;
  progress.single = loop->A.single_blocks != nullptr && loop->Q.single_blocks != nullptr && !loop->bland;
  while (basis->pivots < loop->pivot_limit) {
    const std::int64_t pivots = basis->pivots;
    const Pricing pricing = price_pass<N>(progress.single, *basis, loop, u, &lists);
    const bool enters = pricing.best.any_enters();
    if (!progress.single) {
      if (!enters) return LoopEnd::optimal;
      if (gap_is_closed(*basis, *loop, pricing)) return LoopEnd::gap;
    }
    double gained = 0;
    if (enters && !lists.iterate(basis, loop, pricing.best, column, &gained)) {
      return LoopEnd::unbounded;
    }
    if (!progress.note(gained, *basis, *loop, pivots)) return LoopEnd::stalled;
  }
  return LoopEnd::pivot_limit;
}

LoopEnd simplex_loop(BasisView* basis, SimplexLoop* loop) {
  return with_size(*basis, [&](auto V, auto N) {
    return simplex_loop_vn<decltype(V)::value, decltype(N)::value>(basis, loop);
  });
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
