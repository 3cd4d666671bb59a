// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// A pass over points for several planes at once, in integers. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/support_kernels.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

using Integers = Vec<float>::Index;

inline Integers load(const std::int32_t* p) { return *reinterpret_cast<const Integers*>(p); }

// a_1 b_1 + a_2 b_2 of the two halves of each lane.
inline Integers products_of_halves(Integers a, Integers b) {
#if defined(__AVX512BW__)
  return reinterpret_cast<Integers>(
      _mm512_madd_epi16(reinterpret_cast<__m512i>(a), reinterpret_cast<__m512i>(b)));
#elif defined(__AVX2__)
  return reinterpret_cast<Integers>(
      _mm256_madd_epi16(reinterpret_cast<__m256i>(a), reinterpret_cast<__m256i>(b)));
#elif defined(__SSE2__)
  return reinterpret_cast<Integers>(
      _mm_madd_epi16(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#else
  return (a << 16 >> 16) * (b << 16 >> 16) + (a >> 16) * (b >> 16);
#endif
}

inline void note_places(unsigned lanes, std::int32_t first, FacetWalk* walk) {
  for (; lanes != 0; lanes &= lanes - 1) {
    if (walk->found_count < kMostFound) walk->found[walk->found_count] = first + lowest_bit(lanes);
    ++walk->found_count;
  }
}

// The products of two blocks with the normals of P walks: pairs of coordinates, those of all walks together.
template <int N, int P>
inline void look_beyond(const FacetWalkPoints& points, const std::int32_t* normals, std::ptrdiff_t b,
                        FacetWalk* const* walks) {
  constexpr int kPoints = Vec<float>::kPoints, kCount = Vec<float>::kCount, kPacks = 2 * kPacksPerBlock;
  const int pairs = ((N > 0 ? N : points.n) + 1) / 2;
  const auto* block = points.rounded + b * pairs * kPoints;
  Integers sum[kPacks][P];  // less the threshold and 1: not negative where it is exceeded
#pragma GCC unroll 8
  for (int t = 0; t < kPacks; ++t) {
#pragma GCC unroll 8
    for (int p = 0; p < P; ++p) sum[t][p] = (-1 - walks[p]->threshold) - Integers{};
  }
#pragma GCC unroll 1  // else sums are reordered, for which there are not enough registers
  for (int k = 0; k < pairs; ++k) {
#pragma GCC unroll 8
    for (int t = 0; t < kPacks; ++t) {
      const std::int32_t* of_block = block + t / kPacksPerBlock * pairs * kPoints;
      const Integers row = load(of_block + k * kPoints + t % kPacksPerBlock * kCount);
#pragma GCC unroll 8
      for (int p = 0; p < P; ++p) sum[t][p] += products_of_halves(row, normals[k * P + p] - Integers{});
    }
  }
  Integers signs = sum[0][0];
#pragma GCC unroll 8
  for (int t = 0; t < kPacks; ++t) {
#pragma GCC unroll 8
    for (int p = 0; p < P; ++p) signs &= sum[t][p];
  }
  if (lanes_above(signs, -1) == 0) return;
  const auto first = static_cast<std::int32_t>(b) * kPoints;
#pragma GCC unroll 8
  for (int t = 0; t < kPacks; ++t) {
#pragma GCC unroll 8
    for (int p = 0; p < P; ++p) note_places(lanes_above(sum[t][p], -1), first + t * kCount, walks[p]);
  }
}

template <int N, int P>
void find_beyond_n(const FacetWalkPoints& points, std::ptrdiff_t block_count, FacetWalk* const* walks) {
  alignas(64) std::int32_t normals[8 * P];
  for (int p = 0; p < P; ++p) {
    walks[p]->found_count = 0;
    for (int k = 0; k < 8; ++k) normals[k * P + p] = walks[p]->rounded[k];
  }
  for (std::ptrdiff_t b = 0; b < block_count; b += 2) look_beyond<N, P>(points, normals, b, walks);
}

void find_beyond(const FacetWalkPoints* points, std::ptrdiff_t block_count, FacetWalk* const* walks,
                 int count) {
  with_dimension(points->n, [=](auto N) {
    constexpr int kN = decltype(N)::value;
    constexpr int kMost = kPacksPerBlock == 1 ? 8 : 2;  // as many as there are registers for
    int i = 0;
    for (; i + kMost <= count; i += kMost) find_beyond_n<kN, kMost>(*points, block_count, walks + i);
    if constexpr (kMost > 4) {
      for (; i + 4 <= count; i += 4) find_beyond_n<kN, 4>(*points, block_count, walks + i);
    }
    for (; i + 2 <= count; i += 2) find_beyond_n<kN, 2>(*points, block_count, walks + i);
    if (i < count) find_beyond_n<kN, 1>(*points, block_count, walks + i);
  });
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
