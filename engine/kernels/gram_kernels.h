// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The matrix Σ w_p p pᵀ over many points, for the interior-point method. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/pack.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// A tile of the matrix stays in registers: 2 packs of rows by 6 columns.
template <class Real>
constexpr int kTileRowsOf = 2 * Vec<Real>::kCount;
constexpr int kTileRows = kTileRowsOf<double>;
constexpr int kTileColumns = 6;
constexpr int kGramDepth = 128;  // points at a time, so that their panels stay in the second-level cache

static_assert(kTileRowsOf<float> <= kGramRowPadding && kGramRowPadding % kTileRowsOf<float> == 0);
static_assert(kGramColumnPadding == kTileColumns && kGramPoints == kGramDepth);

// Rows and columns as the tiles read them: panel t holds kTileRowsOf<Real> resp. kTileColumns coordinates of
// one point after the other; those of the columns are multiplied by the weight.
template <class Real>
struct GramPanels {
  Real* rows;
  Real* columns;
  int depth = 0;
};

template <class Real>
inline GramPanels<Real> panels_in(double* scratch, std::ptrdiff_t ld) {
  Real* rows = reinterpret_cast<Real*>(scratch);
  return {rows, rows + ld * kGramDepth};
}

template <int kStride, class Real>
inline void add_to_panels(GramPanels<Real>* panels, const double* point, int n, double weight) {
  constexpr int kRows = kTileRowsOf<Real>;
  const int at = panels->depth++;
  Real* rows = panels->rows + at * kRows;
  for (int first = 0; first < n; first += kRows, rows += kRows * kGramDepth) {
    const int count = n - first < kRows ? n - first : kRows;
    for (int k = 0; k < count; ++k) rows[k] = static_cast<Real>(point[(first + k) * kStride]);
  }
  Real* columns = panels->columns + at * kTileColumns;
  for (int first = 0; first < n; first += kTileColumns, columns += kTileColumns * kGramDepth) {
    const int count = n - first < kTileColumns ? n - first : kTileColumns;
    for (int k = 0; k < count; ++k) columns[k] = static_cast<Real>(weight * point[(first + k) * kStride]);
  }
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

inline void add_to_column(double* M, Vec<double>::Pack sum) { store(M, load(M) + sum); }
inline void add_to_column(double* M, Vec<float>::Pack sum) {
  typedef float Half __attribute__((vector_size(kWidth * 4), aligned(kWidth * 4), may_alias));
  alignas(64) float values[Vec<float>::kCount];
  *reinterpret_cast<Vec<float>::Pack*>(values) = sum;
  for (int half = 0; half < 2; ++half) {
    const Half part = *reinterpret_cast<const Half*>(values + half * kWidth);
    add_to_column(M + half * kWidth, __builtin_convertvector(part, Pack));
  }
}

template <class Real>
inline void add_tile(const Real* rows, const Real* columns, int depth, double* M, std::ptrdiff_t ld) {
  using V = Vec<Real>;
  typename V::Pack sum[kTileColumns][2] = {};
  for (int p = 0; p < depth; ++p) {
    const auto low = load(rows + p * kTileRowsOf<Real>);
    const auto high = load(rows + p * kTileRowsOf<Real> + V::kCount);
#pragma GCC unroll 6
    for (int j = 0; j < kTileColumns; ++j) {
      const auto c = broadcast(columns[p * kTileColumns + j]);
      sum[j][0] = multiply_add(low, c, sum[j][0]);
      sum[j][1] = multiply_add(high, c, sum[j][1]);
    }
  }
  for (int j = 0; j < kTileColumns; ++j) {
    add_to_column(M + j * ld, sum[j][0]);
    add_to_column(M + j * ld + V::kCount, sum[j][1]);
  }
}

// The tiles that meet the lower triangle of the first n rows.
template <class Real>
inline void flush(GramPanels<Real>* panels, int n, double* M, std::ptrdiff_t ld) {
  constexpr int kRows = kTileRowsOf<Real>;
  for (int j = 0; j < n; j += kTileColumns) {
    for (int i = j / kRows * kRows; i < n; i += kRows) {
      add_tile(panels->rows + static_cast<std::ptrdiff_t>(i) * kGramDepth,
               panels->columns + static_cast<std::ptrdiff_t>(j) * kGramDepth, panels->depth, M + j * ld + i,
               ld);
    }
  }
  panels->depth = 0;
}

template <class Real>
inline void add_gram_in(const double* blocks, std::ptrdiff_t block_count, int n, const double* weight,
                        double* scratch, double* M) {
  const std::ptrdiff_t ld = gram_rows(n);
  GramPanels<Real> panels = panels_in<Real>(scratch, ld);
  for (std::ptrdiff_t b = 0; b < block_count; ++b) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const double w = weight[b * kLanes + lane];
      if (w == 0) continue;
      add_to_panels<kLanes>(&panels, blocks + b * n * kLanes + lane, n, w);
      if (panels.depth == kGramDepth) flush(&panels, n, M, ld);
    }
  }
  if (panels.depth > 0) flush(&panels, n, M, ld);
}

void add_gram(const double* blocks, std::ptrdiff_t block_count, int n, const double* weight, bool single,
              double* scratch, double* M) {
  if (single) return add_gram_in<float>(blocks, block_count, n, weight, scratch, M);
  add_gram_in<double>(blocks, block_count, n, weight, scratch, M);
}

// Columns that are factored one by one before the rest of the matrix is brought up to date: whole tiles.
constexpr int kCholeskyColumns = 48;
static_assert(kCholeskyColumns % kTileRows == 0 && kCholeskyColumns % kTileColumns == 0);
static_assert(kCholeskyColumns <= kGramDepth);

// Columns first … last of the factor, rows down to n, within the columns themselves. False at a pivot that is
// not positive.
inline bool factor_columns(double* M, std::ptrdiff_t ld, int n, int first, int last) {
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

bool cholesky(double* M, int n, double* scratch) {
  const std::ptrdiff_t ld = gram_rows(n);
  GramPanels<double> panels = panels_in<double>(scratch, ld);
  for (int first = 0; first < n; first += kCholeskyColumns) {
    const int last = first + kCholeskyColumns < n ? first + kCholeskyColumns : n;
    if (!factor_columns(M, ld, n, first, last)) return false;
    for (int j = first; j < last && last < n; ++j)
      add_to_panels<1>(&panels, M + j * ld + last, n - last, -1.0);
    if (last < n) flush(&panels, n - last, M + last * ld + last, ld);
  }
  return true;
}

// Sums of C blocks at a time, so that each u_k is read once for all of them.
template <int C>
inline void add_blocks(const double* blocks, int n, const double* weight, double* sums) {
  Pack w[C][kPacksPerBlock];
  for (int c = 0; c < C; ++c) {
    for (int t = 0; t < kPacksPerBlock; ++t) w[c][t] = load(weight + c * kLanes + t * kWidth);
  }
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(n) * kLanes;
  for (int k = 0; k < n; ++k) {
    Pack sum = load(sums + k * kWidth);
    for (int c = 0; c < C; ++c) {
      for (int t = 0; t < kPacksPerBlock; ++t)
        sum = multiply_add(w[c][t], load(blocks + c * stride + k * kLanes + t * kWidth), sum);
    }
    store(sums + k * kWidth, sum);
  }
}

void add_weighted(const double* blocks, std::ptrdiff_t block_count, int n, const double* weight,
                  double* scratch, double* sum) {
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(n) * kLanes;
  for (int k = 0; k < n * kWidth; ++k) scratch[k] = 0;
  std::ptrdiff_t b = 0;
  for (; b + 4 <= block_count; b += 4) add_blocks<4>(blocks + b * stride, n, weight + b * kLanes, scratch);
  for (; b < block_count; ++b) add_blocks<1>(blocks + b * stride, n, weight + b * kLanes, scratch);
  for (int k = 0; k < n; ++k)
    sum[k] += reduce_lanes(load(scratch + k * kWidth), [](Pack a, Pack c) { return a + c; })[0];
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
