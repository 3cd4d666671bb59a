// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Residuals of the basic solution and of its duals as if in twice the precision: the compensated dot product
// Dot2 (T. Ogita, S. M. Rump, S. Oishi, Accurate sum and dot product, SIAM J. Sci. Comput. 26, 2005), one sum
// in every lane. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/certificate_kernels.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// The unevaluated sum high + low.
struct Twofold {
  Pack high{};
  Pack low{};
};

// Keeps a rounded product from being contracted into the sums that follow.
inline void keep_rounded([[maybe_unused]] Pack& v) {
#if defined(__AVX512F__)
  asm("" : "+v"(v));
#elif defined(__AVX2__)
  asm("" : "+x"(v));
#endif
}

// a b - p without error, p = a b rounded; barring underflow, and overflow of the parts.
inline Pack product_error(Pack a, Pack b, Pack p) {
#if defined(__AVX512F__)
  return _mm512_fmsub_pd(a, b, p);
#elif defined(__AVX2__)
  return _mm256_fmsub_pd(a, b, p);
#else
  constexpr double kSplitter = 134217729.0;  // 2^27 + 1 (Veltkamp)
  const Pack a_scaled = a * kSplitter;
  const Pack b_scaled = b * kSplitter;
  const Pack a_high = a_scaled - (a_scaled - a);
  const Pack b_high = b_scaled - (b_scaled - b);
  const Pack a_low = a - a_high;
  const Pack b_low = b - b_high;
  return ((a_high * b_high - p) + a_high * b_low + a_low * b_high) + a_low * b_low;
#endif
}

inline void add(Twofold* sum, Pack term) {
  const Pack s = sum->high + term;
  const Pack t = s - sum->high;
  sum->low += (sum->high - (s - t)) + (term - t);
  sum->high = s;
}

// sum += a (b + b_low)
inline void add_product(Twofold* sum, Pack a, Pack b, Pack b_low) {
  Pack p = a * b;
  keep_rounded(p);
  add(sum, p);
  sum->low += product_error(a, b, p) + a * b_low;
}

inline double total(const Twofold& sum) {
  Twofold all{Pack{}, Pack{}};
  for (int lane = 0; lane < kWidth; ++lane) add(&all, broadcast(sum.high[lane]));
  return all.high[0] + (all.low[0] + reduce_lanes(sum.low, [](Pack a, Pack c) { return a + c; })[0]);
}

// Of m + 1 terms: |computed - exact| <= u |computed| + kTwofold(m) Σ|terms|. 3 (m + 1) roundings meet in the
// low part, whose terms sum to at most (m + 3) u Σ|terms|.
inline double twofold_error(int m) { return 4.0 * (m + 4) * (m + 4) * 0x1p-106; }

// r = b - B (x + x_low), and Σ|terms| of each row.
inline void primal_residual(const BasisView* basis, const double* b, const double* x_low, double* r,
                            double* magnitudes) {
  constexpr int kChunk = 2;
  const double* x = basis->x();
  const int total_packs = basis->P / kWidth;
  for (int first = 0; first < total_packs; first += kChunk) {
    const int count = total_packs - first < kChunk ? total_packs - first : kChunk;
    Twofold sum[kChunk];
    Pack size[kChunk];
    for (int p = 0; p < count; ++p) {
      sum[p].high = load(b + (first + p) * kWidth);
      size[p] = magnitude(sum[p].high);
    }
    for (int k = 0; k < basis->m; ++k) {
      const Pack high = broadcast(-x[k]);
      const Pack low = broadcast(-x_low[k]);
      const double* column = basis->B + static_cast<std::ptrdiff_t>(k) * basis->P + first * kWidth;
      for (int p = 0; p < count; ++p) {
        const Pack entry = load(column + p * kWidth);
        add_product(&sum[p], entry, high, low);
        size[p] += magnitude(entry * high);
      }
    }
    for (int p = 0; p < count; ++p) {
      store(r + (first + p) * kWidth, sum[p].high + sum[p].low);
      store(magnitudes + (first + p) * kWidth, size[p]);
    }
  }
}

// c_j - B_j · (y + y_low), rounded once.
inline double dual_residual(const BasisView* basis, int j, const double* y_low) {
  const double* column = basis->B + static_cast<std::ptrdiff_t>(j) * basis->P;
  Twofold sum;
  sum.high[0] = basis->cost[j];
  for (int k = 0; k < basis->P; k += kWidth) {
    add_product(&sum, load(column + k), -load(basis->y + k), -load(y_low + k));
  }
  return total(sum);
}

// v + v_low += correction, and v the nearest double.
inline void correct(double* v, double* v_low, const double* correction, int P) {
  for (int p = 0; p < P; p += kWidth) {
    const Pack high = load(v + p);
    const Pack low = load(v_low + p) + load(correction + p);
    const Pack s = high + low;
    const Pack t = s - high;
    store(v + p, s);
    store(v_low + p, (high - (s - t)) + (low - t));
  }
}

double refine_twofold(BasisView* basis, const double* b, double* x_low, bool correcting) {
  subtract_changes(basis);
  const int P = basis->P;
  double* r = basis->w;
  double* bound = basis->scratch;
  double* result = bound + P;
  primal_residual(basis, b, x_low, r, bound);
  multiply<0>(basis->R, P, basis->m, r, result, unchanged);
  if (correcting) {
    correct(basis->x(), x_low, result, P);
    return 0;
  }
  const double gamma = 1.01 * (basis->m + 3) * 0x1p-53;
  const double lost = 1.01 * twofold_error(basis->m);
  constexpr double kUnderflow = 0x1p-1000;
  for (int p = 0; p < P; p += kWidth) {
    store(bound + p, lost * load(bound + p) + gamma * magnitude(load(r + p)) + kUnderflow);
  }
  double* uncertain = result + P;
  multiply<0>(basis->R, P, basis->m, bound, uncertain, magnitude);
  for (int p = 0; p < P; p += kWidth) store(result + p, magnitude(load(result + p)) + load(uncertain + p));
  return largest_entry(result, P) + kUnderflow;
}

double residual_twofold(const BasisView* basis, const double* b, const double* x_low) {
  double* r = basis->w;
  double* bound = basis->scratch;
  primal_residual(basis, b, x_low, r, bound);
  const double lost = 1.01 * twofold_error(basis->m);
  constexpr double kUnderflow = 0x1p-1000;
  for (int p = 0; p < basis->P; p += kWidth) {
    store(bound + p, lost * load(bound + p) + magnitude(load(r + p)) * (1 + 0x1p-52) + kUnderflow);
  }
  return largest_entry(bound, basis->P);
}

void duals_twofold(BasisView* basis, double* y_low) {
  subtract_changes(basis);
  double* residual = basis->w;
  double* change = basis->scratch;
  for (int i = 0; i < basis->P; ++i) residual[i] = change[i] = 0;
  for (int j = 0; j < basis->m; ++j) residual[j] = dual_residual(basis, j, y_low);
  transposed_multiply(basis->R, basis->P, basis->m, residual, change);
  correct(basis->y, y_low, change, basis->P);
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
