// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The matrix Σ w_p p pᵀ over many points, for the interior-point method. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/pack.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// A tile of the matrix stays in registers: 2 packs of rows by 6 columns.
constexpr int kTileRows = 2 * kWidth;
constexpr int kTileColumns = 6;
constexpr int kGramDepth = 128;  // points at a time, so that their panels stay in the second-level cache

static_assert(kTileRows <= kGramRowPadding && kGramRowPadding % kTileRows == 0);
static_assert(kGramColumnPadding == kTileColumns && kGramPoints == kGramDepth);

// Rows and columns as the tiles read them: panel t holds kTileRows resp. kTileColumns coordinates of one
// point after the other; those of the columns are multiplied by the weight.
struct GramPanels {
  double* rows;
  double* columns;
  int depth = 0;
};

inline void add_to_panels(GramPanels* panels, const double* point, int n, double weight) {
  const int at = panels->depth++;
  double* rows = panels->rows + at * kTileRows;
  for (int first = 0; first < n; first += kTileRows, rows += kTileRows * kGramDepth) {
    const int count = n - first < kTileRows ? n - first : kTileRows;
    for (int k = 0; k < count; ++k) rows[k] = point[(first + k) * kLanes];
  }
  double* columns = panels->columns + at * kTileColumns;
  for (int first = 0; first < n; first += kTileColumns, columns += kTileColumns * kGramDepth) {
    const int count = n - first < kTileColumns ? n - first : kTileColumns;
    for (int k = 0; k < count; ++k) columns[k] = weight * point[(first + k) * kLanes];
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

inline void add_tile(const double* rows, const double* columns, int depth, double* M, std::ptrdiff_t ld) {
  Pack sum[kTileColumns][2];
  for (int j = 0; j < kTileColumns; ++j) {
    sum[j][0] = load(M + j * ld);
    sum[j][1] = load(M + j * ld + kWidth);
  }
  for (int p = 0; p < depth; ++p) {
    const Pack low = load(rows + p * kTileRows);
    const Pack high = load(rows + p * kTileRows + kWidth);
    for (int j = 0; j < kTileColumns; ++j) {
      const Pack c = broadcast(columns[p * kTileColumns + j]);
      sum[j][0] = multiply_add(low, c, sum[j][0]);
      sum[j][1] = multiply_add(high, c, sum[j][1]);
    }
  }
  for (int j = 0; j < kTileColumns; ++j) {
    store(M + j * ld, sum[j][0]);
    store(M + j * ld + kWidth, sum[j][1]);
  }
}

// The tiles that meet the lower triangle.
inline void flush(GramPanels* panels, int n, double* M) {
  const std::ptrdiff_t ld = gram_rows(n);
  for (int j = 0; j < n; j += kTileColumns) {
    for (int i = j / kTileRows * kTileRows; i < n; i += kTileRows) {
      add_tile(panels->rows + static_cast<std::ptrdiff_t>(i) * kGramDepth,
               panels->columns + static_cast<std::ptrdiff_t>(j) * kGramDepth, panels->depth, M + j * ld + i,
               ld);
    }
  }
  panels->depth = 0;
}

void add_gram(const double* blocks, std::ptrdiff_t block_count, int n, const double* weight, double* scratch,
              double* M) {
  GramPanels panels{scratch, scratch + static_cast<std::ptrdiff_t>(gram_rows(n)) * kGramDepth};
  for (std::ptrdiff_t b = 0; b < block_count; ++b) {
    for (int lane = 0; lane < kLanes; ++lane) {
      const double w = weight[b * kLanes + lane];
      if (w == 0) continue;
      add_to_panels(&panels, blocks + b * n * kLanes + lane, n, w);
      if (panels.depth == kGramDepth) flush(&panels, n, M);
    }
  }
  if (panels.depth > 0) flush(&panels, n, M);
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
