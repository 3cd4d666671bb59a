// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The inverse of a matrix by Gauss-Jordan elimination in place, several pivots at a time. Part of
// kernel_impl.h.
#pragma once

#include "engine/kernels/gram_kernels.h"
#include "engine/kernels/pack.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

inline void exchange(double* column, int p, int q) {
  const double kept = column[p];
  column[p] = column[q];
  column[q] = kept;
}

// The row of the largest entry of the column, from row p on.
inline int largest_row(const double* column, int p, int m) {
  int row = p;
  for (int i = p + 1; i < m; ++i) {
    if (absolute(column[i]) > absolute(column[row])) row = i;
  }
  return row;
}

// column += Σ_q W_q f_q over `count` columns W.
inline void add_columns(const double* W, std::ptrdiff_t ld, const double* f, int count, double* column) {
  for (std::ptrdiff_t r = 0; r < ld; r += kWidth) {
    Pack sum = load(column + r);
    for (int q = 0; q < count; ++q) sum = multiply_add(load(W + q * ld + r), broadcast(f[q]), sum);
    store(column + r, sum);
  }
}

// The same of kPivotsAtOnce columns for C columns side by side, so that each W_q is read once for all of
// them.
template <int C>
inline void add_all_columns(const double* W, std::ptrdiff_t ld, const double (*f)[kPivotsAtOnce],
                            double* columns) {
  for (std::ptrdiff_t r = 0; r < ld; r += kWidth) {
    Pack sum[C];
    for (int c = 0; c < C; ++c) sum[c] = load(columns + c * ld + r);
#pragma GCC unroll 8
    for (int q = 0; q < kPivotsAtOnce; ++q) {
      const Pack w = load(W + q * ld + r);
      for (int c = 0; c < C; ++c) sum[c] = multiply_add(w, broadcast(f[c][q]), sum[c]);
    }
    for (int c = 0; c < C; ++c) store(columns + c * ld + r, sum[c]);
  }
}

// Eliminates columns first … last - 1 within themselves. False at a pivot that is not above `smallest`.
bool eliminate_panel(double* M, std::ptrdiff_t ld, int m, int first, int last, double smallest,
                     int* exchanged) {
  for (int q = first; q < last; ++q) {
    double* column = M + q * ld;
    exchanged[q] = largest_row(column, q, m);
    if (!(absolute(column[exchanged[q]]) > smallest)) return false;
    for (int j = first; j < last; ++j) exchange(M + j * ld, q, exchanged[q]);
    const double inverse = 1 / column[q];
    const Pack factor = broadcast(-inverse);
    for (std::ptrdiff_t r = 0; r < ld; r += kWidth) store(column + r, load(column + r) * factor);
    column[q] = inverse;
    for (int j = first; j < last; ++j) {
      if (j == q) continue;
      double* other = M + j * ld;
      const double f = other[q];
      other[q] = 0;
      add_columns(column, ld, &f, 1, other);
    }
  }
  return true;
}

// What the panel does to a column outside: its entries in the rows of the panel are taken out, and returned.
inline void take_rows(double* column, int first, int last, const int* exchanged, double* f) {
  for (int q = first; q < last; ++q) exchange(column, q, exchanged[q]);
  for (int q = first; q < last; ++q) {
    f[q - first] = column[q];
    column[q] = 0;
  }
}

void apply_panel(double* M, std::ptrdiff_t ld, int first, int last, const int* exchanged, int begin,
                 int end) {
  constexpr int kTogether = 4;
  const double* W = M + first * ld;
  double f[kTogether][kPivotsAtOnce];
  int j = begin;
  for (; last - first == kPivotsAtOnce && j + kTogether <= end; j += kTogether) {
    for (int c = 0; c < kTogether; ++c) take_rows(M + (j + c) * ld, first, last, exchanged, f[c]);
    add_all_columns<kTogether>(W, ld, f, M + j * ld);
  }
  for (; j < end; ++j) {
    take_rows(M + j * ld, first, last, exchanged, f[0]);
    add_columns(W, ld, f[0], last - first, M + j * ld);
  }
}

void undo_exchanges(double* M, std::ptrdiff_t ld, int m, const int* exchanged) {
  for (int q = m - 1; q >= 0; --q) {
    if (exchanged[q] == q) continue;
    double* one = M + q * ld;
    double* other = M + exchanged[q] * ld;
    for (std::ptrdiff_t r = 0; r < ld; r += kWidth) {
      const Pack kept = load(one + r);
      store(one + r, load(other + r));
      store(other + r, kept);
    }
  }
}

bool invert(double* M, std::ptrdiff_t ld, int m, double smallest, int* exchanged) {
  for (int first = 0; first < m; first += kPivotsAtOnce) {
    const int last = first + kPivotsAtOnce < m ? first + kPivotsAtOnce : m;
    if (!eliminate_panel(M, ld, m, first, last, smallest, exchanged)) return false;
    apply_panel(M, ld, first, last, exchanged, 0, first);
    apply_panel(M, ld, first, last, exchanged, last, m);
  }
  undo_exchanges(M, ld, m, exchanged);
  return true;
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
