// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Vectors of kWidth doubles, and what the kernels need of them. Part of kernel_impl.h.
#pragma once

#if defined(__AVX2__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "engine/kernels/kernel.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

constexpr int kWidth = RAYGAUGE_WIDTH;
constexpr int kLanes = 8;  // points in a block
constexpr int kPacksPerBlock = kLanes / kWidth;
constexpr double kInfinity = __builtin_inf();

// A register of Real (double or float) and one of integers as wide as Real.
template <class Real>
struct Vec;

template <>
struct Vec<double> {
  static constexpr int kCount = kWidth;
  static constexpr int kPoints = kLanes;  // points in a block
  using Integer = long long;
  typedef double Pack __attribute__((vector_size(kWidth * 8), aligned(kWidth * 8), may_alias));
  typedef long long Index __attribute__((vector_size(kWidth * 8), aligned(kWidth * 8), may_alias));
};

template <>
struct Vec<float> {
  static constexpr int kCount = 2 * kWidth;
  static constexpr int kPoints = 2 * kLanes;
  using Integer = int;
  typedef float Pack __attribute__((vector_size(kWidth * 8), aligned(kWidth * 8), may_alias));
  typedef int Index __attribute__((vector_size(kWidth * 8), aligned(kWidth * 8), may_alias));
};

using Pack = Vec<double>::Pack;
using IndexPack = Vec<double>::Index;

inline Pack load(const double* p) { return *reinterpret_cast<const Pack*>(p); }
inline Vec<float>::Pack load(const float* p) { return *reinterpret_cast<const Vec<float>::Pack*>(p); }
// kWidth numbers as doubles.
inline Pack load_wide(const double* p) { return load(p); }
inline Pack load_wide(const float* p) {
  typedef float Half __attribute__((vector_size(kWidth * 4), aligned(kWidth * 4), may_alias));
  return __builtin_convertvector(*reinterpret_cast<const Half*>(p), Pack);
}
inline void store(double* p, Pack v) { *reinterpret_cast<Pack*>(p) = v; }
// Less zero, not plus: -0.0 + 0.0 is another number, and the addition would be carried out.
inline Pack broadcast(double a) { return a - Pack{}; }
inline Vec<float>::Pack broadcast(float a) { return a - Vec<float>::Pack{}; }
inline IndexPack broadcast_index(long long a) { return a - IndexPack{}; }
// Of f(0), f(1), …, built in a register: one that was written lane by lane in memory would be waited for.
template <class F>
inline Pack pack_of(F f) {
  if constexpr (kWidth == 2) {
    return Pack{f(0), f(1)};
  } else if constexpr (kWidth == 4) {
    return Pack{f(0), f(1), f(2), f(3)};
  } else {
    return Pack{f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7)};
  }
}

template <class F>
inline Vec<float>::Pack floats_of(F f) {
  if constexpr (kWidth == 2) {
    return Vec<float>::Pack{f(0), f(1), f(2), f(3)};
  } else if constexpr (kWidth == 4) {
    return Vec<float>::Pack{f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7)};
  } else {
    return Vec<float>::Pack{f(0), f(1), f(2),  f(3),  f(4),  f(5),  f(6),  f(7),
                            f(8), f(9), f(10), f(11), f(12), f(13), f(14), f(15)};
  }
}

// b where one of them is NaN.
inline Pack maximum(Pack a, Pack b) { return a > b ? a : b; }
inline Vec<float>::Pack maximum(Vec<float>::Pack a, Vec<float>::Pack b) { return a > b ? a : b; }
inline Pack minimum(Pack a, Pack b) { return a < b ? a : b; }
inline Pack magnitude(Pack a) {
  return reinterpret_cast<Pack>(reinterpret_cast<IndexPack>(a) & broadcast_index(0x7fffffffffffffff));
}
inline double absolute(double a) { return __builtin_fabs(a); }

// v's last lane, in all lanes.
template <class V>
inline V last_lane(V v) {
  constexpr int kCount = sizeof(V) / sizeof(v[0]);
  if constexpr (kCount == 16) {
    return __builtin_shufflevector(v, v, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15);
  } else if constexpr (kCount == 8) {
    return __builtin_shufflevector(v, v, 7, 7, 7, 7, 7, 7, 7, 7);
  } else if constexpr (kCount == 4) {
    return __builtin_shufflevector(v, v, 3, 3, 3, 3);
  } else {
    return __builtin_shufflevector(v, v, 1, 1);
  }
}

// A reduction over the lanes by halving; every lane of the result holds the answer.
template <class V, class Op>
inline V reduce_lanes(V v, Op op) {
  constexpr int kCount = sizeof(V) / sizeof(v[0]);
  if constexpr (kCount == 16) {
    v = op(v, __builtin_shufflevector(v, v, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7));
    v = op(v, __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8, 9, 10, 11));
    v = op(v, __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14, 15, 12, 13));
    return op(v, __builtin_shufflevector(v, v, 1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12, 15, 14));
  } else if constexpr (kCount == 8) {
    v = op(v, __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3));
    v = op(v, __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5));
    return op(v, __builtin_shufflevector(v, v, 1, 0, 3, 2, 5, 4, 7, 6));
  } else if constexpr (kCount == 4) {
    v = op(v, __builtin_shufflevector(v, v, 2, 3, 0, 1));
    return op(v, __builtin_shufflevector(v, v, 1, 0, 3, 2));
  } else {
    return op(v, __builtin_shufflevector(v, v, 1, 0));
  }
}

template <class V>
inline auto largest_lane(V v) {
  return reduce_lanes(v, [](V a, V b) { return a > b ? a : b; })[0];
}

template <class V>
inline auto smallest_lane(V v) {
  return reduce_lanes(v, [](V a, V b) { return a < b ? a : b; })[0];
}

// A comparison of v's lanes with a, as bits: lane 0 is bit 0.
#if defined(__AVX512F__)
inline unsigned lanes_equal(Pack v, double a) { return _mm512_cmp_pd_mask(v, broadcast(a), _CMP_EQ_OQ); }
inline unsigned lanes_above(Pack v, double a) { return _mm512_cmp_pd_mask(v, broadcast(a), _CMP_GT_OQ); }
inline unsigned lanes_equal(Vec<float>::Pack v, float a) {
  return _mm512_cmp_ps_mask(v, broadcast(a), _CMP_EQ_OQ);
}
inline unsigned lanes_above(Vec<float>::Pack v, float a) {
  return _mm512_cmp_ps_mask(v, broadcast(a), _CMP_GT_OQ);
}
inline unsigned lanes_above(Vec<float>::Index v, int a) {
  return _mm512_cmpgt_epi32_mask(reinterpret_cast<__m512i>(v), _mm512_set1_epi32(a));
}
#elif defined(__AVX2__)
inline unsigned bits_of(__m256d mask) { return static_cast<unsigned>(_mm256_movemask_pd(mask)); }
inline unsigned bits_of(__m256 mask) { return static_cast<unsigned>(_mm256_movemask_ps(mask)); }
inline unsigned lanes_equal(Pack v, double a) { return bits_of(_mm256_cmp_pd(v, broadcast(a), _CMP_EQ_OQ)); }
inline unsigned lanes_above(Pack v, double a) { return bits_of(_mm256_cmp_pd(v, broadcast(a), _CMP_GT_OQ)); }
inline unsigned lanes_equal(Vec<float>::Pack v, float a) {
  return bits_of(_mm256_cmp_ps(v, broadcast(a), _CMP_EQ_OQ));
}
inline unsigned lanes_above(Vec<float>::Pack v, float a) {
  return bits_of(_mm256_cmp_ps(v, broadcast(a), _CMP_GT_OQ));
}
inline unsigned lanes_above(Vec<float>::Index v, int a) {
  return bits_of(_mm256_castsi256_ps(_mm256_cmpgt_epi32(reinterpret_cast<__m256i>(v), _mm256_set1_epi32(a))));
}
#elif defined(__SSE2__)
template <class Mask>
inline unsigned bits_of(Mask mask) {
  if constexpr (sizeof(mask[0]) == sizeof(double)) {
    return static_cast<unsigned>(_mm_movemask_pd(reinterpret_cast<__m128d>(mask)));
  } else {
    return static_cast<unsigned>(_mm_movemask_ps(reinterpret_cast<__m128>(mask)));
  }
}
template <class V, class Real>
inline unsigned lanes_equal(V v, Real a) {
  return bits_of(v == a - V{});
}
template <class V, class Real>
inline unsigned lanes_above(V v, Real a) {
  return bits_of(v > a - V{});
}
#else
template <class V, class Real>
inline unsigned lanes_equal(V v, Real a) {
  unsigned bits = 0;
  for (int lane = 0; lane < static_cast<int>(sizeof(V) / sizeof(Real)); ++lane) {
    bits |= static_cast<unsigned>(v[lane] == a) << lane;
  }
  return bits;
}
template <class V, class Real>
inline unsigned lanes_above(V v, Real a) {
  unsigned bits = 0;
  for (int lane = 0; lane < static_cast<int>(sizeof(V) / sizeof(Real)); ++lane) {
    bits |= static_cast<unsigned>(v[lane] > a) << lane;
  }
  return bits;
}
#endif

inline int lowest_bit(unsigned bits) { return __builtin_ctz(bits); }

// 0, 1, 2, …
template <class Index>
inline Index lane_numbers() {
  constexpr int kCount = sizeof(Index) / sizeof(Index{}[0]);
  Index lanes;
  for (int lane = 0; lane < kCount; ++lane) lanes[lane] = lane;
  return lanes;
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
