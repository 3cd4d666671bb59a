// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// What a simplex in double-double arithmetic spends its time on: products with points and with an inverse
// M + M_low, and the rank-one changes of that inverse. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/twofold_kernels.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// Sums side by side: one alone would wait for the last addition to it.
constexpr int kSumsAtOnce = 4;

// a - s v, normalised.
inline Twofold minus_product(Twofold a, Twofold s, Twofold v) {
  Pack product = s.high * v.high;
  keep_rounded(product);
  const Pack product_low = product_error(s.high, v.high, product) + (s.high * v.low + s.low * v.high);
  const Pack difference = a.high - product;
  const Pack taken = difference - a.high;
  const Pack lost = (a.high - (difference - taken)) - (product + taken);
  const Pack low = lost + (a.low - product_low);
  const Pack high = difference + low;
  return {high, low - (high - difference)};
}

void products_twofold(const double* blocks, std::ptrdiff_t block_count, int n, const double* u,
                      const double* u_low, double* values) {
  const std::ptrdiff_t packs = block_count * kPacksPerBlock;
  const auto pack_at = [&](std::ptrdiff_t p) {
    return blocks + (p / kPacksPerBlock) * n * kLanes + (p % kPacksPerBlock) * kWidth;
  };
  for (std::ptrdiff_t first = 0; first < packs; first += kSumsAtOnce) {
    const double* points[kSumsAtOnce];
    for (int s = 0; s < kSumsAtOnce; ++s) points[s] = pack_at(first + s < packs ? first + s : packs - 1);
    Twofold sum[kSumsAtOnce];
    for (int k = 0; k < n; ++k) {
      const Pack high = broadcast(u[k]);
      const Pack low = broadcast(u_low[k]);
      for (int s = 0; s < kSumsAtOnce; ++s) add_product(&sum[s], load(points[s] + k * kLanes), high, low);
    }
    for (int s = 0; s < kSumsAtOnce && first + s < packs; ++s) {
      store(values + (first + s) * kWidth, sum[s].high + sum[s].low);
    }
  }
}

// kCount packs of rows of (M + M_low) v.
template <int kCount>
inline void multiply_rows(const double* M, const double* M_low, std::ptrdiff_t ld, int columns,
                          const double* v, double* out, double* out_low) {
  Twofold sum[kCount];
  for (int k = 0; k < columns; ++k) {
    const Pack factor = broadcast(v[k]);
    for (int s = 0; s < kCount; ++s) {
      const std::ptrdiff_t at = k * ld + s * kWidth;
      add_product(&sum[s], factor, load(M + at), load(M_low + at));
    }
  }
  for (int s = 0; s < kCount; ++s) {
    const Pack high = sum[s].high + sum[s].low;
    store(out + s * kWidth, high);
    store(out_low + s * kWidth, sum[s].low - (high - sum[s].high));
  }
}

void multiply_twofold(const double* M, const double* M_low, std::ptrdiff_t ld, int columns, const double* v,
                      double* out, double* out_low) {
  constexpr std::ptrdiff_t kChunk = kSumsAtOnce * kWidth;
  std::ptrdiff_t first = 0;
  for (; first + kChunk <= ld; first += kChunk) {
    multiply_rows<kSumsAtOnce>(M + first, M_low + first, ld, columns, v, out + first, out_low + first);
  }
  for (; first < ld; first += kWidth) {
    multiply_rows<1>(M + first, M_low + first, ld, columns, v, out + first, out_low + first);
  }
}

void subtract_product_twofold(double* M, double* M_low, std::ptrdiff_t ld, int columns, const double* v,
                              const double* v_low, const double* s, const double* s_low) {
  for (int k = 0; k < columns; ++k) {
    if (s[k] == 0) continue;
    const Twofold factor{broadcast(s[k]), broadcast(s_low[k])};
    double* high = M + k * ld;
    double* low = M_low + k * ld;
    for (std::ptrdiff_t p = 0; p < ld; p += kWidth) {
      const Twofold changed =
          minus_product({load(high + p), load(low + p)}, factor, {load(v + p), load(v_low + p)});
      store(high + p, changed.high);
      store(low + p, changed.low);
    }
  }
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
