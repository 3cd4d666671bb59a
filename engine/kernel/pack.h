// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Vectors of kWidth doubles, and what the kernels need of them. Part of kernel_impl.h.
#pragma once

#include "engine/kernel/kernel.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

constexpr int kWidth = RAYGAUGE_WIDTH;
constexpr int kLanes = 8;  // points in a block
constexpr int kPacksPerBlock = kLanes / kWidth;
constexpr double kInfinity = __builtin_inf();

typedef double Pack __attribute__((vector_size(kWidth * 8), aligned(kWidth * 8), may_alias));
typedef long long IndexPack __attribute__((vector_size(kWidth * 8), aligned(kWidth * 8), may_alias));

inline Pack load(const double* p) { return *reinterpret_cast<const Pack*>(p); }
inline void store(double* p, Pack v) { *reinterpret_cast<Pack*>(p) = v; }
inline Pack broadcast(double a) { return Pack{} + a; }
inline IndexPack broadcast_index(long long a) { return IndexPack{} + a; }
inline Pack select(IndexPack mask, Pack a, Pack b) { return mask ? a : b; }
inline Pack maximum(Pack a, Pack b) { return a > b ? a : b; }
inline double absolute(double a) { return __builtin_fabs(a); }

// A reduction over the lanes by halving; every lane of the result holds the answer.
template <class V, class Op>
inline V reduce_lanes(V v, Op op) {
  if constexpr (kWidth == 8) {
    v = op(v, __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3));
    v = op(v, __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5));
    return op(v, __builtin_shufflevector(v, v, 1, 0, 3, 2, 5, 4, 7, 6));
  } else if constexpr (kWidth == 4) {
    v = op(v, __builtin_shufflevector(v, v, 2, 3, 0, 1));
    return op(v, __builtin_shufflevector(v, v, 1, 0, 3, 2));
  } else {
    return op(v, __builtin_shufflevector(v, v, 1, 0));
  }
}

inline double largest_lane(Pack v) {
  return reduce_lanes(v, [](Pack a, Pack b) { return a > b ? a : b; })[0];
}
inline double smallest_lane(Pack v) {
  return reduce_lanes(v, [](Pack a, Pack b) { return a < b ? a : b; })[0];
}
inline long long smallest_lane(IndexPack v) {
  return reduce_lanes(v, [](IndexPack a, IndexPack b) { return a < b ? a : b; })[0];
}

// 0, 1, 2, …
inline IndexPack lane_numbers() {
  IndexPack lanes;
  for (int lane = 0; lane < kWidth; ++lane) lanes[lane] = lane;
  return lanes;
}

constexpr long long kNoIndex = 0x7fffffffffffffff;

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
