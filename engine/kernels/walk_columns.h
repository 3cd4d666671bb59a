// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Of walks from facet to facet: the points near by, as columns. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/support_kernels.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

constexpr float kSlack = 1e-6F;  // Harris: reduced costs below it count as it
constexpr float kLeastAlong =
    1e-5F;  // of α and of pivots, by the length of the row of R, for points of length 1
constexpr float kRoundedShare = 2e-6F;  // of Σ|x_i|: what rounding may make of a basic variable

using FloatPack = Vec<float>::Pack;

inline void store(float* p, FloatPack v) { *reinterpret_cast<FloatPack*>(p) = v; }

typedef float FloatsAnywhere __attribute__((vector_size(kWidth * 8), aligned(4), may_alias));
inline void store_anywhere(float* p, FloatPack v) { *reinterpret_cast<FloatsAnywhere*>(p) = v; }

// 16 numbers: a block, or a column of R.
struct Sixteen {
  static constexpr int kPacks = kPacksPerBlock;
  FloatPack part[kPacks] = {};

  static Sixteen at(const float* p) {
    Sixteen s;
    for (int t = 0; t < kPacks; ++t) s.part[t] = load(p + t * Vec<float>::kCount);
    return s;
  }
  void to(float* p) const {
    for (int t = 0; t < kPacks; ++t) store(p + t * Vec<float>::kCount, part[t]);
  }
  void add(float s, const Sixteen& v) {
    for (int t = 0; t < kPacks; ++t) part[t] += s * v.part[t];
  }
  void add_products(const Sixteen& a, const Sixteen& b) {
    for (int t = 0; t < kPacks; ++t) part[t] += a.part[t] * b.part[t];
  }
  float largest() const {
    FloatPack top = part[0];
    for (int t = 1; t < kPacks; ++t) top = maximum(top, part[t]);
    return largest_lane(top);
  }
  unsigned equal(float value) const {
    unsigned lanes = 0;
    for (int t = 0; t < kPacks; ++t) lanes |= lanes_equal(part[t], value) << (t * Vec<float>::kCount);
    return lanes;
  }
  unsigned above(float value) const {
    unsigned lanes = 0;
    for (int t = 0; t < kPacks; ++t) lanes |= lanes_above(part[t], value) << (t * Vec<float>::kCount);
    return lanes;
  }
};

// Chosen lanes of a pair of blocks, fewer than 17 of them, become the columns after the last one. There is
// room for 48 more than `room`.
inline void keep_lanes(const FacetWalkPoints& points, std::ptrdiff_t pair, unsigned lanes, int n,
                       FacetWalk* walk) {
  constexpr int kPoints = Vec<float>::kPoints;
  const float* block = points.blocks + pair * 2 * n * kPoints;
  const std::int32_t first = static_cast<std::int32_t>(pair) * 2 * kPoints;
#if defined(__AVX512F__)
  const __m512i numbers = reinterpret_cast<__m512i>(lane_numbers<Vec<float>::Index>());
  const auto low = static_cast<__mmask16>(lanes), high = static_cast<__mmask16>(lanes >> 16);
  const __m512i of_second =
      _mm512_maskz_compress_epi32(high, _mm512_add_epi32(numbers, _mm512_set1_epi32(kPoints)));
  const auto behind = static_cast<__mmask16>(0xFFFFU << __builtin_popcount(low));
  const __m512i kept = _mm512_mask_expand_epi32(_mm512_maskz_compress_epi32(low, numbers), behind, of_second);
  float* to = walk->columns + walk->chosen;
  for (int k = 0; k < n; ++k) {
    const __m512 row = _mm512_permutex2var_ps(_mm512_load_ps(block + k * kPoints), kept,
                                              _mm512_load_ps(block + (n + k) * kPoints));
    _mm512_storeu_ps(to + static_cast<std::ptrdiff_t>(k) * walk->stride, row);
  }
  _mm512_storeu_si512(walk->place + walk->chosen, _mm512_add_epi32(_mm512_set1_epi32(first), kept));
  walk->chosen += __builtin_popcount(lanes);
#else
  for (; lanes != 0; lanes &= lanes - 1) {
    const int lane = lowest_bit(lanes);
    float* to = walk->columns + walk->chosen;
    const float* from = block + lane / kPoints * n * kPoints + lane % kPoints;
    for (int k = 0; k < n; ++k) to[static_cast<std::ptrdiff_t>(k) * walk->stride] = from[k * kPoints];
    walk->place[walk->chosen++] = first + lane;
  }
#endif
}

// Zeros from the last column to column `end`, a multiple of 16, and up to 15 more.
template <int N>
inline void fill_columns(FacetWalk* walk, int n, int end) {
  for (int k = 0; k < (N > 0 ? N : n); ++k) {
    float* row = walk->columns + static_cast<std::ptrdiff_t>(k) * walk->stride;
    for (int at = walk->chosen; at < end; at += Vec<float>::kCount) store_anywhere(row + at, FloatPack{});
  }
}

constexpr int whole_blocks(int columns) {
  return (columns + Vec<float>::kPoints - 1) / Vec<float>::kPoints * Vec<float>::kPoints;
}

// What points along b have to be above, for them to become columns.
template <int N>
inline float least_of_columns(const FacetWalkPoints& points, int n, const float* target) {
  constexpr int kFirst = 4;  // blocks that tell how high points are
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(N > 0 ? N : n) * Vec<float>::kPoints;
  Sixteen top, score;
  for (int b = 0; b < kFirst && b < points.listed; ++b) {
    dot_block<N>(points.blocks + b * stride, n, target, score.part);
    for (int t = 0; t < kPacksPerBlock; ++t) top.part[t] = maximum(top.part[t], score.part[t]);
  }
  return points.share_of_highest * top.largest();
}

// The points that are farthest along b become the columns, each pair of blocks for all walks while it is at
// hand.
template <int N>
inline void choose_columns(const FacetWalkPoints& points, int n, FacetWalk* const* walks, int count) {
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(N > 0 ? N : n) * Vec<float>::kPoints;
  float least[kWalksTogether];
  for (int i = 0; i < count; ++i) {
    walks[i]->chosen = 0;
    least[i] = least_of_columns<N>(points, n, walks[i]->target);
  }
  for (std::ptrdiff_t pair = 0; pair < points.listed / 2; ++pair) {
    for (int i = 0; i < count; ++i) {
      if (walks[i]->chosen >= points.room) continue;
      Sixteen score[2];
      dot_block<N>(points.blocks + 2 * pair * stride, n, walks[i]->target, score[0].part);
      dot_block<N>(points.blocks + (2 * pair + 1) * stride, n, walks[i]->target, score[1].part);
      const unsigned low = score[0].above(least[i]), high = score[1].above(least[i]) << 16;
      const int dimension = N > 0 ? N : n;
      if (__builtin_popcount(low | high) <= 16) {
        keep_lanes(points, pair, low | high, dimension, walks[i]);
      } else {
        keep_lanes(points, pair, low, dimension, walks[i]);
        keep_lanes(points, pair, high, dimension, walks[i]);
      }
    }
  }
}

// v·p of 16 columns.
template <int N>
inline Sixteen products_of_columns(const FacetWalk& walk, int n, int first, const float* v) {
  Sixteen sum;
  for (int k = 0; k < (N > 0 ? N : n); ++k)
    sum.add(v[k], Sixteen::at(walk.columns + static_cast<std::ptrdiff_t>(k) * walk.stride + first));
  return sum;
}

// The least ratio d / -α so far in every lane, compared without dividing, with the block it stems from.
struct LaneRatios {
  using F = Vec<float>;
  FloatPack along[kPacksPerBlock] = {};
  FloatPack cost[kPacksPerBlock];
  F::Index block[kPacksPerBlock] = {};

  FloatPack least;  // α that count are below it

  explicit LaneRatios(float above) : least(FloatPack{} + above) {
    for (FloatPack& c : cost) c = FloatPack{} + 1.0F;
  }

  void take(int t, FloatPack d, FloatPack alpha, F::Index b) {
    const FloatPack e = (d > FloatPack{} ? d : FloatPack{}) + kSlack;
    const F::Index better = (alpha * cost[t] < along[t] * e) & (alpha < least);
    along[t] = better ? alpha : along[t];
    cost[t] = better ? e : cost[t];
    block[t] = better ? b : block[t];
  }

  // The column, or -1.
  int best() const {
    Sixteen ratio;
    for (int t = 0; t < kPacksPerBlock; ++t) ratio.part[t] = -along[t] / cost[t];
    const float value = ratio.largest();
    if (!(value > 0)) return -1;
    const int lane = lowest_bit(ratio.equal(value));
    return block[lane / F::kCount][lane % F::kCount] * F::kPoints + lane;
  }
};

// The last step is taken, d -= step α; then α = ρ·p for the next one, and its ratio test, of those below
// `least`.
template <int N>
inline int entering_column(FacetWalk* walk, int n, int blocks, const float* rho, float step, float least) {
  using F = Vec<float>;
  LaneRatios ratios(least);
  for (int b = 0; b < blocks; ++b) {
    const Sixteen alpha = products_of_columns<N>(*walk, n, b * F::kPoints, rho);
    for (int t = 0; t < kPacksPerBlock; ++t) {
      const int at = b * F::kPoints + t * F::kCount;
      const FloatPack d = load(walk->cost + at) - broadcast(step) * load(walk->along + at);
      store(walk->cost + at, d);
      store(walk->along + at, alpha.part[t]);
      ratios.take(t, d, alpha.part[t], F::Index{} + b);
    }
  }
  return ratios.best();
}

// d = 1 - y·p, and no α yet.
template <int N>
inline void form_costs(FacetWalk* walk, int n, int columns) {
  for (int first = 0; first < columns; first += Vec<float>::kPoints) {
    Sixteen d = products_of_columns<N>(*walk, n, first, walk->y);
    for (FloatPack& part : d.part) part = 1.0F - part;
    d.to(walk->cost + first);
    Sixteen{}.to(walk->along + first);
  }
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
