// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Products with the basis and its inverse that the certificate needs. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/basis_kernels.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// Rows of one matrix: packs known at compile time for V > 0, else at most kMostPacks at a time.
template <int V>
struct Rows {
  static constexpr int kMostPacks = V > 0 ? V* kRowPadding / kWidth : 4;
  Pack value[kMostPacks];
};

// out = M v for a column-major matrix of `columns` columns, all rows; v is read with stride `stride`.
template <int V, class Transform>
inline void multiply(const double* M, int P, int columns, const double* v, double* out, Transform transform) {
  const int total = P / kWidth;
  constexpr int kChunk = Rows<V>::kMostPacks;
  for (int first = 0; first < total; first += kChunk) {
    const int count = V > 0 ? kChunk : (total - first < kChunk ? total - first : kChunk);
    Rows<V> sum{};
    for (int k = 0; k < columns; ++k) {
      const Pack a = broadcast(v[k]);
      const double* column = M + static_cast<std::ptrdiff_t>(k) * P + first * kWidth;
      for (int p = 0; p < count; ++p) sum.value[p] += transform(a * load(column + p * kWidth));
    }
    for (int p = 0; p < count; ++p) store(out + (first + p) * kWidth, sum.value[p]);
  }
}

inline Pack unchanged(Pack v) { return v; }

// The largest entry; NaN if one of them is NaN or infinite, which the maximum alone may pass over: bounds on
// rounding must not forget an overflow.
inline double largest_entry(const double* v, int P) {
  Pack top = load(v);
  Pack zero = top - top;  // NOLINT(misc-redundant-expression)
  for (int p = kWidth; p < P; p += kWidth) {
    const Pack entry = load(v + p);
    top = maximum(top, entry);
    zero += entry - entry;  // NOLINT(misc-redundant-expression)
  }
  return largest_lane(top) + reduce_lanes(zero, [](Pack a, Pack c) { return a + c; })[0];
}

template <int V>
double refine_v(BasisView* basis, const double* b, bool correct) {
  const int P = basis->P;
  const int m = basis->m;
  double* r = basis->w;
  double* bound = basis->scratch;
  double* result = bound + P;
  multiply<V>(basis->B, P, m, basis->x(), r, unchanged);
  for (int p = 0; p < P; p += kWidth) store(r + p, load(b + p) - load(r + p));
  if (correct) {
    multiply<V>(basis->R, P, m, r, result, unchanged);
    for (int p = 0; p < P; p += kWidth) store(basis->x() + p, load(basis->x() + p) + load(result + p));
    return 0;
  }
  const double gamma = 1.01 * (m + 2) * 0x1p-53;
  // What products below the normal range lose; more than (m + 2) 2^-1074, because subnormals are slow.
  constexpr double kUnderflow = 0x1p-1022;
  multiply<V>(basis->B, P, m, basis->x(), bound, magnitude);
  for (int p = 0; p < P; p += kWidth) {
    store(bound + p,
          gamma * (magnitude(load(b + p)) + load(bound + p) + magnitude(load(r + p))) + kUnderflow);
  }
  double* uncertain = result + P;
  multiply<V>(basis->R, P, m, r, result, unchanged);
  multiply<V>(basis->R, P, m, bound, uncertain, magnitude);
  for (int p = 0; p < P; p += kWidth) store(result + p, magnitude(load(result + p)) + load(uncertain + p));
  return largest_entry(result, P) + kUnderflow;
}

// Σ_i v_i M_ik for every column k, added to out_k.
inline void transposed_multiply(const double* M, int P, int columns, const double* v, double* out) {
  for (int k = 0; k < columns; ++k) {
    const double* column = M + static_cast<std::ptrdiff_t>(k) * P;
    Pack sum = load(v) * load(column);
    for (int p = kWidth; p < P; p += kWidth) sum += load(v + p) * load(column + p);
    out[k] += reduce_lanes(sum, [](Pack a, Pack c) { return a + c; })[0];
  }
}

// yᵀ = c_Bᵀ R, as accurate as the inverse.
inline void plain_duals(BasisView* basis) {
  for (int i = 0; i < basis->P; ++i) basis->y[i] = 0;
  transposed_multiply(basis->R, basis->P, basis->m, basis->cost, basis->y);
}

void duals(BasisView* basis) {
  subtract_changes(basis);
  const int P = basis->P;
  double* y = basis->y;
  double* residual = basis->w;
  plain_duals(basis);
  for (int i = 0; i < P; ++i) residual[i] = 0;
  transposed_multiply(basis->B, P, basis->m, y, residual);
  for (int p = 0; p < P; p += kWidth) store(residual + p, load(basis->cost + p) - load(residual + p));
  transposed_multiply(basis->R, P, basis->m, residual, y);
}

// Of the sums over k in I - R B: so many terms are added up before they join the others. An entry is then in
// error by less than (kTerms + m / kTerms + 4) u of the sum of its terms' magnitudes, where a sum of m terms
// in a row would have m + 2.
constexpr int kTerms = 32;

// |I - R B| over kPacks packs of rows from `first` and kColumns columns from j, added to sum.
template <int kPacks, int kColumns>
inline void add_residual_tile(const BasisView& basis, int first, int j, Pack* sum) {
  const double* B = basis.B + static_cast<std::ptrdiff_t>(j) * basis.P;
  const double* R = basis.R + first * kWidth;
  Pack product[kColumns][kPacks] = {};
  for (int k = 0; k < basis.m;) {
    const int end = basis.m - k < kTerms ? basis.m : k + kTerms;
    Pack part[kColumns][kPacks] = {};
    for (; k < end; ++k, R += basis.P) {
      Pack r[kPacks];
      for (int p = 0; p < kPacks; ++p) r[p] = load(R + p * kWidth);
      for (int c = 0; c < kColumns; ++c) {
        const Pack b = broadcast(B[c * static_cast<std::ptrdiff_t>(basis.P) + k]);
        for (int p = 0; p < kPacks; ++p) part[c][p] += r[p] * b;
      }
    }
    for (int c = 0; c < kColumns; ++c) {
      for (int p = 0; p < kPacks; ++p) product[c][p] += part[c][p];
    }
  }
  for (int c = 0; c < kColumns; ++c) {
    for (int p = 0; p < kPacks; ++p) {
      const IndexPack lanes = lane_numbers<IndexPack>() + static_cast<long long>(first + p) * kWidth;
      sum[p] += magnitude(lanes == broadcast_index(j + c) ? product[c][p] - 1.0 : product[c][p]);
    }
  }
}

template <int kPacks>
inline void norms_of_rows(const BasisView& basis, int first, double* sum_E, double* sum_R, double* sum_B) {
  constexpr int kColumns = 6;
  Pack E[kPacks] = {};
  Pack R[kPacks] = {};
  Pack B[kPacks] = {};
  int j = 0;
  for (; j + kColumns <= basis.m; j += kColumns) add_residual_tile<kPacks, kColumns>(basis, first, j, E);
  for (; j < basis.m; ++j) add_residual_tile<kPacks, 1>(basis, first, j, E);
  for (j = 0; j < basis.m; ++j) {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(j) * basis.P + first * kWidth;
    for (int p = 0; p < kPacks; ++p) {
      R[p] += magnitude(load(basis.R + at + p * kWidth));
      B[p] += magnitude(load(basis.B + at + p * kWidth));
    }
  }
  for (int p = 0; p < kPacks; ++p) {
    store(sum_E + (first + p) * kWidth, E[p]);
    store(sum_R + (first + p) * kWidth, R[p]);
    store(sum_B + (first + p) * kWidth, B[p]);
  }
}

void subtract_collected(BasisView* basis) { subtract_changes(basis); }

// Tiles in registers, so that R and B are not read once for every column.
void sum_rows(BasisView* basis, int begin, int end) {
  double* sum_E = basis->scratch;
  double* sum_R = sum_E + basis->P;
  double* sum_B = sum_R + basis->P;
  const int total = end / kWidth;
  int first = begin / kWidth;
  for (; first + 2 <= total; first += 2) norms_of_rows<2>(*basis, first, sum_E, sum_R, sum_B);
  for (; first < total; ++first) norms_of_rows<1>(*basis, first, sum_E, sum_R, sum_B);
}

MatrixNorms largest_sums(BasisView* basis) {
  const int P = basis->P;
  const int m = basis->m;
  double* sum_E = basis->scratch;
  double* sum_R = sum_E + P;
  double* sum_B = sum_R + P;
  const double norm_of_R = largest_entry(sum_R, P);
  // What rounding may have hidden, row by row: in |R| |B| of ones, where the norms' product is far more.
  const int additions = kTerms + m / kTerms + 4;
  const double gamma = 1.01 * additions * 0x1p-53;
  double* magnitudes = sum_R;
  multiply<0>(basis->R, P, m, sum_B, magnitudes, magnitude);
  for (int p = 0; p < P; p += kWidth) store(sum_E + p, load(sum_E + p) + gamma * load(magnitudes + p));
  return {1.01 * largest_entry(sum_E, P), norm_of_R};
}

MatrixNorms norms(BasisView* basis) {
  subtract_changes(basis);
  sum_rows(basis, 0, basis->P);
  return largest_sums(basis);
}

double refine(BasisView* basis, const double* b, bool correct) {
  subtract_changes(basis);
  switch (basis->P / kRowPadding) {
    case 1:
      return refine_v<1>(basis, b, correct);
    case 2:
      return refine_v<2>(basis, b, correct);
    default:
      return refine_v<0>(basis, b, correct);
  }
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
