// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Support queries over blocked points. Part of kernel_impl.h.
#pragma once

#include <type_traits>

#include "engine/kernels/pack.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// The best point so far in every lane of a block, with the block it stems from.
template <class Real>
struct LaneMaxima {
  using Pack = typename Vec<Real>::Pack;
  using Index = typename Vec<Real>::Index;

  Pack value[kPacksPerBlock];
  Index block[kPacksPerBlock];

  LaneMaxima() {
    for (int t = 0; t < kPacksPerBlock; ++t) {
      value[t] = Pack{} + static_cast<Real>(-kInfinity);
      block[t] = Index{};
    }
  }

  void take(const Pack* sum, Index b) {
    for (int t = 0; t < kPacksPerBlock; ++t) {
      const Index better = sum[t] > value[t];
      value[t] = better ? sum[t] : value[t];
      block[t] = better ? b : block[t];
    }
  }

  // Of points with the same product the first is kept.
  void merge(const LaneMaxima& other) {
    for (int t = 0; t < kPacksPerBlock; ++t) {
      const Index better =
          (other.value[t] > value[t]) | ((other.value[t] == value[t]) & (other.block[t] < block[t]));
      value[t] = better ? other.value[t] : value[t];
      block[t] = better ? other.block[t] : block[t];
    }
  }

  Real best() const {
    Pack top = value[0];
    for (int t = 1; t < kPacksPerBlock; ++t) top = value[t] > top ? value[t] : top;
    return largest_lane(top);
  }

  // The first of the points whose product is `best`.
  std::ptrdiff_t first_of(Real best) const {
    unsigned lanes = 0;
    for (int t = 0; t < kPacksPerBlock; ++t) lanes |= lanes_equal(value[t], best) << (t * Vec<Real>::kCount);
    std::ptrdiff_t first = lanes != 0 ? point_in(lowest_bit(lanes)) : 0;
    while ((lanes &= lanes - 1) != 0) {
      const std::ptrdiff_t other = point_in(lowest_bit(lanes));
      first = other < first ? other : first;
    }
    return first;
  }

  // The better of the best points of two lanes.
  std::ptrdiff_t better_of(int a, int b) const {
    constexpr int kCount = Vec<Real>::kCount;
    return point_in(value[b / kCount][b % kCount] > value[a / kCount][a % kCount] ? b : a);
  }

  std::ptrdiff_t point_in(int lane) const {
    constexpr int kCount = Vec<Real>::kCount;
    return static_cast<std::ptrdiff_t>(block[lane / kCount][lane % kCount]) * Vec<Real>::kPoints + lane;
  }
};

template <int N, class Real>
inline void dot_block(const Real* p, int n, const Real* u, typename Vec<Real>::Pack* sum) {
  using V = Vec<Real>;
  for (int t = 0; t < kPacksPerBlock; ++t) sum[t] = typename V::Pack{};
  const int dimension = N > 0 ? N : n;
  for (int k = 0; k < dimension; ++k) {
    const auto uk = broadcast(u[k]);
    for (int t = 0; t < kPacksPerBlock; ++t) sum[t] += uk * load(p + k * V::kPoints + t * V::kCount);
  }
}

// Products of C consecutive blocks. For a dimension that is known only at run time they advance together, so
// that the chains of additions overlap and each u_k is broadcast once.
template <int N, int C, class Real>
inline void dot_blocks(const Real* p, int n, const Real* u, typename Vec<Real>::Pack (*sum)[kPacksPerBlock]) {
  using V = Vec<Real>;
  if constexpr (N > 0) {
#pragma GCC unroll 8
    for (int c = 0; c < C; ++c) {
      dot_block<N>(p + static_cast<std::ptrdiff_t>(c) * N * V::kPoints, n, u, sum[c]);
    }
  } else {
    typename V::Pack local[C][kPacksPerBlock] = {};
    const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(n) * V::kPoints;
    for (int k = 0; k < n; ++k) {
      const auto uk = broadcast(u[k]);
#pragma GCC unroll 8
      for (int c = 0; c < C; ++c) {
        for (int t = 0; t < kPacksPerBlock; ++t) {
          local[c][t] += uk * load(p + c * stride + k * V::kPoints + t * V::kCount);
        }
      }
    }
#pragma GCC unroll 8
    for (int c = 0; c < C; ++c) {
      for (int t = 0; t < kPacksPerBlock; ++t) sum[c][t] = local[c][t];
    }
  }
}

// One chain of maxima waits for its own comparison and blend at every block; where a block is soon done, two
// side by side.
template <int N>
constexpr int kChains = N > 0 && N <= 4 ? 2 : 1;

// Inlined, because a result that returns in memory would be waited for.
template <int N, class Real>
[[gnu::always_inline]] inline LaneMaxima<Real> pass_over(const Real* blocks, std::ptrdiff_t block_count,
                                                         int n, const Real* u) {
  using V = Vec<Real>;
  constexpr int kTogether = N > 0 && N <= 6 ? 4 : 2;  // blocks whose chains of additions overlap
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(N > 0 ? N : n) * V::kPoints;
  LaneMaxima<Real> maxima[kChains<N>];
  typename V::Index number{};  // of the block; as a vector it need not be broadcast each time
  std::ptrdiff_t b = 0;
  for (; b + kTogether <= block_count; b += kTogether) {
    typename V::Pack sum[kTogether][kPacksPerBlock];
    dot_blocks<N, kTogether>(blocks + b * stride, n, u, sum);
#pragma GCC unroll 8
    for (int c = 0; c < kTogether; ++c) {
      maxima[c % kChains<N>].take(sum[c], number);
      number += 1;
    }
  }
  for (; b < block_count; ++b, number += 1) {
    typename V::Pack sum[kPacksPerBlock];
    dot_block<N>(blocks + b * stride, n, u, sum);
    maxima[0].take(sum, number);
  }
  for (int c = 1; c < kChains<N>; ++c) maxima[0].merge(maxima[c]);
  return maxima[0];
}

template <int N>
inline double price_n(const double* blocks, std::ptrdiff_t block_count, int n, const double* u,
                      std::ptrdiff_t* index) {
  const LaneMaxima<double> maxima = pass_over<N>(blocks, block_count, n, u);
  const double best = maxima.best();
  *index = maxima.first_of(best);
  return best;
}

// f(the dimension as a constant where there are kernels for it, else 0).
template <class F>
inline auto with_dimension(int n, F f) {
  switch (n) {
    case 2:
      return f(std::integral_constant<int, 2>{});
    case 3:
      return f(std::integral_constant<int, 3>{});
    case 4:
      return f(std::integral_constant<int, 4>{});
    case 5:
      return f(std::integral_constant<int, 5>{});
    case 6:
      return f(std::integral_constant<int, 6>{});
    case 7:
      return f(std::integral_constant<int, 7>{});
    case 8:
      return f(std::integral_constant<int, 8>{});
    case 9:
      return f(std::integral_constant<int, 9>{});
    case 10:
      return f(std::integral_constant<int, 10>{});
    default:
      return f(std::integral_constant<int, 0>{});
  }
}

double price(const double* blocks, std::ptrdiff_t block_count, int n, const double* u,
             std::ptrdiff_t* index) {
  return with_dimension(
      n, [=](auto N) { return price_n<decltype(N)::value>(blocks, block_count, n, u, index); });
}

template <int N>
inline void copy_of_point(const double* blocks, std::ptrdiff_t index, int n, double* point) {
  const int dimension = N > 0 ? N : n;
  const double* from = blocks + index / kLanes * dimension * kLanes + index % kLanes;
  for (int k = 0; k < dimension; ++k) point[k] = from[k * kLanes];
}

// The second pass starts while the first one's maxima are reduced.
template <int N>
inline double best_vertex_n(const PricedPoints* A, const PricedPoints* Q, int n, const double* u,
                            BestVertex* best) {
  const int dimension = N > 0 ? N : n;
  double* s = best->column;
  for (int k = 0; k < dimension; ++k) s[k] = -u[k];
  const LaneMaxima<double> maxima_A = pass_over<N>(A->blocks, A->block_count, n, u);
  const LaneMaxima<double> maxima_Q = pass_over<N>(Q->blocks, Q->block_count, n, s);
  best->value_A = maxima_A.best();
  best->value_Q = maxima_Q.best();
  double* a = best->point_A;
  double* q = best->point_Q;
  copy_of_point<N>(A->blocks, maxima_A.first_of(best->value_A), n, a);
  copy_of_point<N>(Q->blocks, maxima_Q.first_of(best->value_Q), n, q);
  double sum[2] = {};
  for (int k = 0; k < dimension; ++k) {
    s[k] = a[k] - best->center[k] - best->eta * q[k];
    sum[k % 2] += u[k] * s[k];
  }
  return sum[0] + sum[1];
}

double best_vertex(const PricedPoints* A, const PricedPoints* Q, int n, const double* u, BestVertex* best) {
  return with_dimension(n, [=](auto N) { return best_vertex_n<decltype(N)::value>(A, Q, n, u, best); });
}

// Keeps the better half of a full collection and raises its threshold accordingly (quickselect on the
// values).
void halve(Collection* c) {
  std::ptrdiff_t low = 0;
  std::ptrdiff_t high = c->count - 1;
  const std::ptrdiff_t keep = c->count / 2;
  while (low < high) {
    const double pivot = c->value[low + (high - low) / 2];
    std::ptrdiff_t i = low;
    std::ptrdiff_t j = high;
    while (i <= j) {
      while (c->value[i] > pivot) ++i;
      while (c->value[j] < pivot) --j;
      if (i <= j) {
        const double v = c->value[i];
        c->value[i] = c->value[j];
        c->value[j] = v;
        const std::int64_t id = c->index[i];
        c->index[i++] = c->index[j];
        c->index[j--] = id;
      }
    }
    if (keep <= j) {
      high = j;
    } else if (keep >= i) {
      low = i;
    } else {
      break;
    }
  }
  c->threshold = c->value[keep];
  c->count = keep;
}

// Adds those of one block's products that are above the threshold.
template <class Real>
inline void collect_block(const typename Vec<Real>::Pack* sum, std::ptrdiff_t b, Collection* c) {
  using V = Vec<Real>;
  for (int t = 0; t < kPacksPerBlock; ++t) {
    for (unsigned above = lanes_above(sum[t], static_cast<Real>(c->threshold)); above != 0;
         above &= above - 1) {
      const int lane = lowest_bit(above);
      const double v = sum[t][lane];
      if (c->count == c->capacity) halve(c);
      if (!(v > c->threshold)) continue;  // raised since
      c->index[c->count] = b * V::kPoints + t * V::kCount + lane;
      c->value[c->count++] = v;
    }
  }
}

template <int N, class Real>
double collect_n(const Real* blocks, std::ptrdiff_t first, std::ptrdiff_t last, int n, const Real* u,
                 Collection* collection) {
  using V = Vec<Real>;
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(N > 0 ? N : n) * V::kPoints;
  constexpr int kGroup = 4;  // blocks between two looks at the threshold
  auto best = broadcast(static_cast<Real>(-kInfinity));
  std::ptrdiff_t b = first;
  for (; b + kGroup <= last; b += kGroup) {
    typename V::Pack sum[kGroup][kPacksPerBlock];
    dot_blocks<N, kGroup>(blocks + b * stride, n, u, sum);
    auto top = sum[0][0];
    for (int g = 0; g < kGroup; ++g) {
      for (int t = 0; t < kPacksPerBlock; ++t) top = maximum(top, sum[g][t]);
    }
    best = maximum(best, top);
    if (lanes_above(top, static_cast<Real>(collection->threshold)) != 0) [[unlikely]] {
      for (int g = 0; g < kGroup; ++g) collect_block<Real>(sum[g], b + g, collection);
    }
  }
  for (; b < last; ++b) {
    typename V::Pack sum[kPacksPerBlock];
    dot_block<N>(blocks + b * stride, n, u, sum);
    for (int t = 0; t < kPacksPerBlock; ++t) best = maximum(best, sum[t]);
    collect_block<Real>(sum, b, collection);
  }
  return largest_lane(best);
}

template <class Real>
double collect(const Real* blocks, std::ptrdiff_t first, std::ptrdiff_t last, int n, const Real* u,
               Collection* collection) {
  return with_dimension(n, [=](auto N) -> double {
    return collect_n<decltype(N)::value>(blocks, first, last, n, u, collection);
  });
}

// Of points that are stored in double or in single precision, as many blocks at a time as have chains of
// additions that overlap.
template <class Stored>
constexpr int kBlocksTogether = 4 * kLanes / Vec<Stored>::kPoints;

template <int C, class Stored>
inline void products_of(const Stored* blocks, int n, const double* u, double* values) {
  constexpr int kPoints = Vec<Stored>::kPoints;
  constexpr int kPacks = kPoints / kWidth;
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(n) * kPoints;
  Pack sum[C][kPacks] = {};
  for (int k = 0; k < n; ++k) {
    const Pack uk = broadcast(u[k]);
#pragma GCC unroll 8
    for (int c = 0; c < C; ++c) {
#pragma GCC unroll 8
      for (int t = 0; t < kPacks; ++t)
        sum[c][t] += uk * load_wide(blocks + c * stride + k * kPoints + t * kWidth);
    }
  }
  for (int c = 0; c < C; ++c) {
    for (int t = 0; t < kPacks; ++t) store(values + c * kPoints + t * kWidth, sum[c][t]);
  }
}

// All products of u with the points, in their order.
template <class Stored>
void products(const Stored* blocks, std::ptrdiff_t block_count, int n, const double* u, double* values) {
  constexpr int kPoints = Vec<Stored>::kPoints;
  constexpr int kTogether = kBlocksTogether<Stored>;
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(n) * kPoints;
  std::ptrdiff_t b = 0;
  for (; b + kTogether <= block_count; b += kTogether)
    products_of<kTogether>(blocks + b * stride, n, u, values + b * kPoints);
  for (; b < block_count; ++b) products_of<1>(blocks + b * stride, n, u, values + b * kPoints);
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
