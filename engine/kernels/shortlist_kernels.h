// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Shortlists: the best points of a pass, one for every lane. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/support_kernels.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// Reduced costs below this, relative to the support value, are beyond single precision.
constexpr double kSingleTolerance = 1e-6;

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

// What a pass over a set found worth trying: the best point of every lane, copied side by side as columns of
// the linear program (points of Q negated). Pricing these again after every pivot costs next to nothing, and
// every second pass is spared (multiple pricing, Orchard-Hays 1968).
struct Shortlist {
  double* block = nullptr;            // a block of points
  std::ptrdiff_t index[kLanes] = {};  // of the points in the set
};

// Copies the points list->index side by side, times `sign`.
template <int N>
inline void copy_points(Shortlist* list, const PricedPoints& points, int n, double sign) {
  const int dimension = N > 0 ? N : n;
  const double* point[kLanes];
  for (int lane = 0; lane < kLanes; ++lane) {
    const std::ptrdiff_t i = list->index[lane];
    point[lane] = points.blocks + (i / kLanes) * dimension * kLanes + i % kLanes;
  }
  for (int k = 0; k < dimension; ++k) {
    for (int t = 0; t < kPacksPerBlock; ++t) {
      const auto coordinate = [&](int lane) { return point[t * kWidth + lane][k * kLanes]; };
      store(list->block + k * kLanes + t * kWidth, pack_of(coordinate) * sign);
    }
  }
}

// Of 16 lanes the better of each pair 8 apart.
template <int N, class Real>
inline void fill(Shortlist* list, const LaneMaxima<Real>& maxima, const PricedPoints& points, int n,
                 double sign) {
  for (int lane = 0; lane < kLanes; ++lane) {
    const std::ptrdiff_t found = maxima.better_of(lane, lane + Vec<Real>::kPoints - kLanes);
    list->index[lane] = found < points.size ? found : points.size - 1;
  }
  copy_points<N>(list, points, n, sign);
}

// The better of each pair comes first.
template <class Real>
inline double list_lanes(const LaneMaxima<Real>& maxima, const PricedPoints& points, LaneList* lanes) {
  constexpr int kCount = Vec<Real>::kPoints;
  const auto inside = [&](std::ptrdiff_t i) { return i < points.size ? i : points.size - 1; };
  for (int lane = 0; lane < kLanes; ++lane) {
    const int other = lane + kCount - kLanes;
    const std::ptrdiff_t better = maxima.better_of(lane, other);
    const std::ptrdiff_t worse = maxima.point_in(lane) + maxima.point_in(other) - better;
    lanes->index[other] = inside(worse);
    lanes->index[lane] = inside(better);
  }
  lanes->count = kCount;
  const Real best = maxima.best();
  lanes->best = inside(maxima.first_of(best));
  return best;
}

double price_lanes(const PricedPoints* points, int n, const double* u, float* single, LaneList* lanes) {
  return with_dimension(n, [=](auto N) -> double {
    constexpr int kN = decltype(N)::value;
    if (points->single_blocks == nullptr) {
      return list_lanes(pass_over<kN>(points->blocks, points->block_count, n, u), *points, lanes);
    }
    for (int k = 0; k < n; ++k) single[k] = static_cast<float>(u[k]);
    return list_lanes(pass_over<kN>(points->single_blocks, points->single_block_count, n, single), *points,
                      lanes);
  });
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

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
