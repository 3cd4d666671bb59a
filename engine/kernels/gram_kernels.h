// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The matrix Σ w_p p pᵀ over many points, for the interior-point method. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/support_kernels.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// A tile of the matrix stays in registers: 2 packs of rows by as many columns as there are registers for.
template <class Real>
constexpr int kTileRowsOf = 2 * Vec<Real>::kCount;
constexpr int kTileRows = kTileRowsOf<double>;
constexpr int kTileColumns = kWidth == 8 ? 8 : 4;

static_assert(kGramStripe % kTileRowsOf<float> == 0 && kTileRows % kTileColumns == 0);
static_assert(kGramColumnPadding % kTileColumns == 0);

// Panels hold kTileRowsOf<Real> coordinates of one point after the other, kGramPoints of them.
template <class Real>
inline std::ptrdiff_t in_panels(int slot, int k) {
  constexpr int kRows = kTileRowsOf<Real>;
  return (static_cast<std::ptrdiff_t>(k / kRows) * kGramPoints + slot) * kRows + k % kRows;
}

inline void place(double* to, Pack v) { store(to, v); }
inline void place(float* to, Pack v) {
  typedef float Half __attribute__((vector_size(kWidth * 4), aligned(kWidth * 4), may_alias));
  *reinterpret_cast<Half*>(to) = __builtin_convertvector(v, Half);
}

// Lane l of row r changes places with lane r of row l, kWidth rows.
template <int kCount>
inline void transpose(Pack* row) {
  const auto exchange = [row](int apart, auto low, auto high) {
    for (int r = 0; r < kCount; ++r) {
      if ((r & apart) != 0) continue;
      const auto a = row[r];
      const auto b = row[r + apart];
      row[r] = low(a, b);
      row[r + apart] = high(a, b);
    }
  };
  if constexpr (kCount == 8) {
    exchange(
        1, [](auto a, auto b) { return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14); },
        [](auto a, auto b) { return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15); });
    exchange(
        2, [](auto a, auto b) { return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13); },
        [](auto a, auto b) { return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15); });
    exchange(
        4, [](auto a, auto b) { return __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11); },
        [](auto a, auto b) { return __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15); });
  } else if constexpr (kCount == 4) {
    exchange(
        1, [](auto a, auto b) { return __builtin_shufflevector(a, b, 0, 4, 2, 6); },
        [](auto a, auto b) { return __builtin_shufflevector(a, b, 1, 5, 3, 7); });
    exchange(
        2, [](auto a, auto b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5); },
        [](auto a, auto b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7); });
  } else {
    exchange(
        1, [](auto a, auto b) { return __builtin_shufflevector(a, b, 0, 2); },
        [](auto a, auto b) { return __builtin_shufflevector(a, b, 1, 3); });
  }
}

// Zeros in the rows of the last stripe that no coordinate fills, from a whole pack on.
template <class Real>
inline void clear_padding(Real* panels, int slot, int first, int n) {
  for (int k = first; k < gram_rows(n); k += kWidth) place(panels + in_panels<Real>(slot, k), Pack{});
}

// The points of one block in slots first … last - 1.
template <class Real>
inline void pack_block(const double* block, int n, const GramPoint* points, int first, int last,
                       Real* panels) {
  alignas(64) Pack row[kWidth];
  for (int k = 0; k < n; k += kWidth) {
    for (int part = 0; part < kPacksPerBlock; ++part) {
      for (int r = 0; r < kWidth; ++r)
        row[r] = k + r < n ? load(block + (k + r) * kLanes + part * kWidth) : Pack{};
      transpose<kWidth>(row);
      for (int slot = first; slot < last; ++slot) {
        const auto lane = static_cast<int>(points[slot].index % kLanes);
        if (lane / kWidth != part) continue;
        place(panels + in_panels<Real>(slot, k), row[lane % kWidth] * broadcast(points[slot].factor));
      }
    }
  }
  const int filled = (n + kWidth - 1) / kWidth * kWidth;
  for (int slot = first; slot < last; ++slot) clear_padding(panels, slot, filled, n);
}

template <class Real>
inline void pack_in(const double* blocks, int n, const GramPoint* points, int first, int last, Real* panels) {
  int end = first;
  for (int slot = first; slot < last; slot = end) {
    const std::ptrdiff_t block = points[slot].index / kLanes;
    while (end < last && points[end].index / kLanes == block) ++end;
    pack_block(blocks + block * n * kLanes, n, points, slot, end, panels);
  }
}

void pack_points(const double* blocks, int n, const GramPoint* points, int first, int last, bool single,
                 double* panels) {
  if (single) return pack_in(blocks, n, points, first, last, reinterpret_cast<float*>(panels));
  pack_in(blocks, n, points, first, last, panels);
}

// a b + c in one rounding where the machine can: nothing is proven from this matrix.
inline Pack multiply_add(Pack a, Pack b, Pack c) {
#if defined(__AVX512F__)
  return _mm512_fmadd_pd(a, b, c);
#elif defined(__AVX2__) && defined(__FMA__)
  return _mm256_fmadd_pd(a, b, c);
#else
  return a * b + c;
#endif
}
inline Vec<float>::Pack multiply_add(Vec<float>::Pack a, Vec<float>::Pack b, Vec<float>::Pack c) {
#if defined(__AVX512F__)
  return _mm512_fmadd_ps(a, b, c);
#elif defined(__AVX2__) && defined(__FMA__)
  return _mm256_fmadd_ps(a, b, c);
#else
  return a * b + c;
#endif
}

inline void add_to_column(double* M, Vec<double>::Pack sum, double sign) {
  store(M, multiply_add(sum, broadcast(sign), load(M)));
}
inline void add_to_column(double* M, Vec<float>::Pack sum, double sign) {
  typedef float Half __attribute__((vector_size(kWidth * 4), aligned(kWidth * 4), may_alias));
  alignas(64) float values[Vec<float>::kCount];
  *reinterpret_cast<Vec<float>::Pack*>(values) = sum;
  for (int half = 0; half < 2; ++half) {
    const Half part = *reinterpret_cast<const Half*>(values + half * kWidth);
    add_to_column(M + half * kWidth, __builtin_convertvector(part, Pack), sign);
  }
}

// Both are panels: rows, and the first of the columns in theirs.
template <class Real>
inline void add_tile(const Real* rows, const Real* columns, int depth, double sign, double* M,
                     std::ptrdiff_t ld) {
  using V = Vec<Real>;
  constexpr int kRows = kTileRowsOf<Real>;
  typename V::Pack sum[kTileColumns][2] = {};
  for (int p = 0; p < depth; ++p) {
    const auto low = load(rows + p * kRows);
    const auto high = load(rows + p * kRows + V::kCount);
#pragma GCC unroll 8
    for (int j = 0; j < kTileColumns; ++j) {
      const auto c = broadcast(columns[p * kRows + j]);
      sum[j][0] = multiply_add(low, c, sum[j][0]);
      sum[j][1] = multiply_add(high, c, sum[j][1]);
    }
  }
  for (int j = 0; j < kTileColumns; ++j) {
    add_to_column(M + j * ld, sum[j][0], sign);
    add_to_column(M + j * ld + V::kCount, sum[j][1], sign);
  }
}

// The tiles of rows first … last - 1 that meet the lower triangle of the first n rows: a panel of rows stays
// in the first-level cache while those of the columns stream by.
template <class Real>
inline void add_tiles(const Real* panels, int depth, int n, int first, int last, double sign, double* M,
                      std::ptrdiff_t ld) {
  constexpr int kRows = kTileRowsOf<Real>;
  for (int i = first; i < last && i < n; i += kRows) {
    const int columns = i + kRows < n ? i + kRows : n;
    for (int j = 0; j < columns; j += kTileColumns) {
      add_tile(panels + in_panels<Real>(0, i), panels + in_panels<Real>(0, j), depth, sign, M + j * ld + i,
               ld);
    }
  }
}

void add_panels(const double* panels, const GramPart& part, bool single, double sign, double* M) {
  const auto [depth, n, first, last, ld] = part;
  if (single) return add_tiles(reinterpret_cast<const float*>(panels), depth, n, first, last, sign, M, ld);
  add_tiles(panels, depth, n, first, last, sign, M, ld);
}

static_assert(kCholeskyColumns % kTileRows == 0 && kCholeskyColumns <= kGramPoints);

// Columns first … last of the factor, rows down to n, within the columns themselves. False at a pivot that is
// not positive.
bool factor_columns(double* M, std::ptrdiff_t ld, int n, int first, int last) {
  for (int j = first; j < last; ++j) {
    double* column = M + j * ld;
    if (!(column[j] > 0)) return false;
    const double root = __builtin_sqrt(column[j]);
    const Pack inverse = broadcast(1 / root);
    const int begin = j / kWidth * kWidth;
    for (int i = begin; i < n; i += kWidth) store(column + i, load(column + i) * inverse);
    column[j] = root;
    for (int c = j + 1; c < last; ++c) {
      double* other = M + c * ld;
      const Pack factor = broadcast(-column[c]);
      for (int i = c / kWidth * kWidth; i < n; i += kWidth)
        store(other + i, multiply_add(load(column + i), factor, load(other + i)));
    }
  }
  return true;
}

// `count` columns of n rows into the slots of the panels.
void pack_columns(const double* columns, std::ptrdiff_t ld, int count, int n, double* panels) {
  for (int slot = 0; slot < count; ++slot) {
    int k = 0;
    for (; k < n; k += kWidth) place(panels + in_panels<double>(slot, k), load(columns + slot * ld + k));
    clear_padding(panels, slot, k, n);
  }
}

// Sums of C blocks at a time, so that each of them is read once for all of them.
template <int C, class Stored>
inline void add_blocks(const Stored* blocks, int n, const double* weight, double* sums) {
  constexpr int kPoints = Vec<Stored>::kPoints;
  constexpr int kPacks = kPoints / kWidth;
  Pack w[C][kPacks];
  for (int c = 0; c < C; ++c) {
    for (int t = 0; t < kPacks; ++t) w[c][t] = load(weight + c * kPoints + t * kWidth);
  }
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(n) * kPoints;
  for (int k = 0; k < n; ++k) {
    Pack sum = load(sums + k * kWidth);
    for (int c = 0; c < C; ++c) {
      for (int t = 0; t < kPacks; ++t)
        sum = multiply_add(w[c][t], load_wide(blocks + c * stride + k * kPoints + t * kWidth), sum);
    }
    store(sums + k * kWidth, sum);
  }
}

template <class Stored>
void add_weighted(const Stored* blocks, std::ptrdiff_t block_count, int n, const double* weight,
                  double* scratch, double* sum) {
  constexpr int kPoints = Vec<Stored>::kPoints;
  constexpr int kTogether = kBlocksTogether<Stored>;
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(n) * kPoints;
  for (int k = 0; k < n * kWidth; ++k) scratch[k] = 0;
  std::ptrdiff_t b = 0;
  for (; b + kTogether <= block_count; b += kTogether)
    add_blocks<kTogether>(blocks + b * stride, n, weight + b * kPoints, scratch);
  for (; b < block_count; ++b) add_blocks<1>(blocks + b * stride, n, weight + b * kPoints, scratch);
  for (int k = 0; k < n; ++k)
    sum[k] += reduce_lanes(load(scratch + k * kWidth), [](Pack a, Pack c) { return a + c; })[0];
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
