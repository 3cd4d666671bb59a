// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The simplex loop of the primal simplex. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/basis_kernels.h"
#include "engine/kernels/certificate_kernels.h"
#include "engine/kernels/support_kernels.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// Reduced costs below this, relative to the support value, are beyond single precision.
constexpr double kSingleTolerance = 1e-6;

inline double dual_length(const BasisView& basis) {
  double sum = 0;
  for (int k = 0; k < basis.m - 1; ++k) sum += absolute(basis.y[k]);
  return sum;
}

// What a pass over a set found worth trying: the best point of every lane, copied side by side as columns of
// the linear program (points of Q negated). Pricing these again after every pivot costs next to nothing, and
// every second pass is spared (multiple pricing, Orchard-Hays 1968).
struct Shortlist {
  double* block = nullptr;            // a block of points
  std::ptrdiff_t index[kLanes] = {};  // of the points in the set
};

// Of 16 lanes the better of each pair 8 apart.
template <int N, class Real>
inline void fill(Shortlist* list, const LaneMaxima<Real>& maxima, const PricedPoints& points, int n,
                 double sign) {
  const int dimension = N > 0 ? N : n;
  const double* point[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    const std::ptrdiff_t found = maxima.better_of(lane, lane + Vec<Real>::kPoints - kLanes);
    const std::ptrdiff_t i = found < points.size ? found : points.size - 1;
    list->index[lane] = i;
    point[lane] = points.blocks + (i / kLanes) * dimension * kLanes + i % kLanes;
  }
  for (int k = 0; k < dimension; ++k) {
    for (int t = 0; t < kPacksPerBlock; ++t) {
      const auto coordinate = [&](int lane) { return point[t * kWidth + lane][k * kLanes]; };
      store(list->block + k * kLanes + t * kWidth, pack_of(coordinate) * sign);
    }
  }
}

void best_of_lanes(const PricedPoints* points, int n, const double* u, float* single, double* block) {
  Shortlist list;
  list.block = block;
  if (points->single_blocks == nullptr) {
    return fill<0>(&list, pass_over<0>(points->blocks, points->block_count, n, u), *points, n, 1.0);
  }
  for (int k = 0; k < n; ++k) single[k] = static_cast<float>(u[k]);
  fill<0>(&list, pass_over<0>(points->single_blocks, points->single_block_count, n, single), *points, n, 1.0);
}

// max y · column over the shortlist, without the columns' last entries.
template <int N>
inline double price_shortlist(const Shortlist& list, int n, const double* y, int* lane) {
  Pack products[kPacksPerBlock];
  dot_block<N>(list.block, n, y, products);
  Pack top = products[0];
  for (int t = 1; t < kPacksPerBlock; ++t) top = maximum(top, products[t]);
  const double best = largest_lane(top);
  unsigned lanes = 0;
  for (int t = 0; t < kPacksPerBlock; ++t) lanes |= lanes_equal(products[t], best) << (t * kWidth);
  *lane = lanes != 0 ? lowest_bit(lanes) : 0;
  return best;
}

// Reduced costs of the best columns of both sets, and what is rounding in them.
struct Candidates {
  double d_A = 0;
  double d_Q = 0;
  double tolerance_A = 0;
  double tolerance_Q = 0;

  bool A_enters() const { return d_A < -tolerance_A; }
  bool Q_enters() const { return d_Q < -tolerance_Q; }
  bool any_enters() const { return A_enters() || Q_enters(); }
};

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

template <int N, class Real>
inline Pricing price_both(const BasisView& basis, const SimplexLoop& loop, Blocks<Real> A, Blocks<Real> Q,
                          double cost_tolerance, Real* u, Shortlist* list_A, Shortlist* list_Q) {
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
  if (best.any_enters()) {
    fill<N>(list_A, maxima_A, loop.A, n, 1.0);
    fill<N>(list_Q, maxima_Q, loop.Q, n, -1.0);
  }
  return {h_A, h_Q, best};
}

// Pivots between two passes.
constexpr int kMinorPivots = 8;

// Many dimensions make basis changes dear: a column that promises less than this share of what the pass's
// best one promised waits for the next pass. That leaves out a fifth of the changes at n = 150, a quarter at
// 200.
constexpr double kWorthEntering = 0.4;

// Pivots over the shortlists while something of them prices out. False if a column finds no pivot. *gained is
// the fall of the objective.
template <int V, int N>
inline bool minor_iterations(BasisView* basis, SimplexLoop* loop, Candidates best, const Shortlist& A,
                             const Shortlist& Q, double* column, double* gained) {
  const int n = N > 0 ? N : basis->m - 1;
  double promised = 0;  // by the first
  for (int turn = 0; turn < kMinorPivots && basis->pivots < loop->pivot_limit; ++turn) {
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
      if (promise < kWorthEntering * promised) return true;
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

// A pass over both sets, in single precision or in double; what it found is noted in the loop.
template <int N>
inline Pricing price_pass(bool single, const BasisView& basis, SimplexLoop* loop, double* u,
                          Shortlist* list_A, Shortlist* list_Q) {
  const PricedPoints& A = loop->A;
  const PricedPoints& Q = loop->Q;
  const Pricing pricing =
      single ? price_both<N, float>(basis, *loop, {A.single_blocks, A.single_block_count},
                                    {Q.single_blocks, Q.single_block_count}, kSingleTolerance,
                                    reinterpret_cast<float*>(u), list_A, list_Q)
             : price_both<N, double>(basis, *loop, {A.blocks, A.block_count}, {Q.blocks, Q.block_count},
                                     loop->cost_tolerance, u, list_A, list_Q);
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
  Shortlist list_A;
  Shortlist list_Q;
  list_A.block = V > 0 ? fixed_lists[0] : u + static_cast<std::ptrdiff_t>(2) * basis->P;
  list_Q.block = V > 0 ? fixed_lists[1] : list_A.block + static_cast<std::ptrdiff_t>(basis->P) * kLanes;
  Progress progress;
  progress.single = loop->A.single_blocks != nullptr && loop->Q.single_blocks != nullptr && !loop->bland;
  while (basis->pivots < loop->pivot_limit) {
    const std::int64_t pivots = basis->pivots;
    const Pricing pricing = price_pass<N>(progress.single, *basis, loop, u, &list_A, &list_Q);
    const bool enters = pricing.best.any_enters();
    if (!progress.single) {
      if (!enters) return LoopEnd::optimal;
      if (gap_is_closed(*basis, *loop, pricing)) return LoopEnd::gap;
    }
    double gained = 0;
    if (enters && !minor_iterations<V, N>(basis, loop, pricing.best, list_A, list_Q, column, &gained)) {
      return LoopEnd::unbounded;
    }
    if (!progress.note(gained, *basis, *loop, pivots)) return LoopEnd::stalled;
  }
  return LoopEnd::pivot_limit;
}

LoopEnd simplex_loop(BasisView* basis, SimplexLoop* loop) {
  switch (basis->m - 1) {
    case 2:
      return simplex_loop_vn<1, 2>(basis, loop);
    case 3:
      return simplex_loop_vn<1, 3>(basis, loop);
    case 4:
      return simplex_loop_vn<1, 4>(basis, loop);
    case 5:
      return simplex_loop_vn<1, 5>(basis, loop);
    case 6:
      return simplex_loop_vn<1, 6>(basis, loop);
    case 7:
      return simplex_loop_vn<1, 7>(basis, loop);
    case 8:
      return simplex_loop_vn<2, 8>(basis, loop);
    case 9:
      return simplex_loop_vn<2, 9>(basis, loop);
    case 10:
      return simplex_loop_vn<2, 10>(basis, loop);
    default:
      break;
  }
  switch (basis->P / kRowPadding) {
    case 1:
      return simplex_loop_vn<1, 0>(basis, loop);
    case 2:
      return simplex_loop_vn<2, 0>(basis, loop);
    case 3:
      return simplex_loop_vn<3, 0>(basis, loop);
    default:
      return simplex_loop_vn<0, 0>(basis, loop);
  }
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
