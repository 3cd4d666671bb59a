// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// A simplex tableau of the shortlists, in single precision. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/basis_kernels.h"
#include "engine/kernels/shortlist_kernels.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// W = R C and the reduced costs d = c - yᵀC of the columns C of two shortlists, in rows of kColumns lanes:
// those of A, those of Q; only the last lane is none of them but the basic solution x.
//
// It proposes basis changes by the fall of the objective, |d_j| min_i x_i / W_ij, which takes a fifth fewer
// of them than the reduced costs alone, and is updated after each. The column that enters is computed again
// in double precision, and with it the row that leaves and all that is kept. Nothing here waits for that, so
// that both computations overlap.
template <int N, class Real>
struct Tableau {
  using F = Vec<float>;
  static constexpr int kRows = N + 1;
  static constexpr int kOfSet = Vec<Real>::kPoints;
  static constexpr int kColumns = 2 * kOfSet;
  static constexpr int kPacks = kColumns / F::kCount;

  alignas(64) float row[kRows + 1][kColumns];  // W, then d
  alignas(64) float column[kRows][kColumns];   // C; its last row is 1 for points of A, 0 for those of Q
  alignas(64) float limit[kColumns];           // reduced costs below it are no rounding
  alignas(64) int most[kColumns];              // bits of max_i W_ij / x_i, marked with i
  alignas(64) typename Vec<Real>::Integer offset[kColumns];  // of the points among the numbers of their sets
};

// A basis change that the tableau proposes.
struct Proposal {
  int column = -1;  // -1: none
  int row = 0;
};

using FloatBits = Vec<float>::Index;

// The bits of a number that is not negative order as it does; the last ones can say where it comes from.
inline FloatBits marked(Vec<float>::Pack v, int mask, FloatBits mark) {
#if defined(__AVX512F__)
  constexpr int kSelect = 0xBA;  // (a & ~b) | c
  return reinterpret_cast<FloatBits>(_mm512_ternarylogic_epi32(
      reinterpret_cast<__m512i>(v), _mm512_set1_epi32(mask), reinterpret_cast<__m512i>(mark), kSelect));
#else
  return (reinterpret_cast<FloatBits>(v) & ~mask) | mark;
#endif
}

// Of numbers that are not both negative.
inline FloatBits larger(FloatBits a, FloatBits b) { return a > b ? a : b; }
inline FloatBits bits_of_all(float a) { return reinterpret_cast<FloatBits>(Vec<float>::Pack{} + a); }

// The ratio tests of all columns at once: the bits of max_i W_ij / x_i, marked with the row i.
template <int N, class Real>
struct RatioTests {
  using F = Vec<float>;
  static constexpr int kPacks = Tableau<N, Real>::kPacks;
  static constexpr int kRowMask = 15;
  static_assert(N <= kRowMask);
  static constexpr float kLeast = 1e-10F;  // basic variables at zero, or below for rounding, count as this
  F::Index most[kPacks] = {};

  void take(const F::Pack* W, int i) {
    const auto x = reinterpret_cast<F::Index>(last_lane(W[kPacks - 1]));
    const F::Pack inverse = 1.0F / reinterpret_cast<F::Pack>(larger(x, bits_of_all(kLeast)));
    for (int t = 0; t < kPacks; ++t)
      most[t] = larger(marked(W[t] * inverse, kRowMask, F::Index{} + i), most[t]);
  }
};

// Of the columns that price out the one with the largest fall of the objective; by Dantzig's rule where that
// is asked for.
template <int N, class Real>
inline Proposal propose(Tableau<N, Real>* tableau, const RatioTests<N, Real>& tests, bool dantzig) {
  using F = Vec<float>;
  constexpr int kRows = Tableau<N, Real>::kRows;
  constexpr int kColumns = Tableau<N, Real>::kColumns;
  constexpr int kNoMark = ~RatioTests<N, Real>::kRowMask;
  const F::Index unbounded = bits_of_all(1e-20F) & kNoMark;  // where no row blocks, row 0 stands in
  F::Index best{};
  for (int t = 0; t < Tableau<N, Real>::kPacks; ++t) {
    const F::Index most = larger(tests.most[t], unbounded);
    *reinterpret_cast<F::Index*>(tableau->most + t * F::kCount) = most;
    const F::Pack d = load(tableau->row[kRows] + t * F::kCount);
    const F::Pack fall = dantzig ? -d : -d / reinterpret_cast<F::Pack>(most);
    const F::Pack worth = d < load(tableau->limit + t * F::kCount) ? fall : F::Pack{};
    const F::Index lanes = lane_numbers<F::Index>() + t * F::kCount;
    best = larger(marked(worth, kColumns - 1, lanes), best);
  }
  const int winner = largest_lane(best);
  if (winner < kColumns) return {};
  const int column = winner % kColumns;
  return {column, tableau->most[column] & RatioTests<N, Real>::kRowMask};
}

// d = c - yᵀC.
template <int N, class Real>
inline void form_reduced_costs(Tableau<N, Real>* tableau, const BasisView& basis, double cost_of_Q) {
  using F = Vec<float>;
  constexpr int kRows = Tableau<N, Real>::kRows;
  const auto cost = static_cast<float>(cost_of_Q);
  for (int t = 0; t < Tableau<N, Real>::kPacks; ++t) {
    const int at = t * F::kCount;
    F::Pack d = cost - cost * load(tableau->column[N] + at);
    for (int k = 0; k < kRows; ++k) d -= static_cast<float>(basis.y[k]) * load(tableau->column[k] + at);
    *reinterpret_cast<F::Pack*>(tableau->row[kRows] + at) = d;
  }
}

// W = R C, and x; d is in place.
template <int V, int N, class Real>
inline Proposal form(Tableau<N, Real>* tableau, const BasisView& basis, bool dantzig) {
  using F = Vec<float>;
  constexpr int kRows = Tableau<N, Real>::kRows;
  constexpr int kPacks = Tableau<N, Real>::kPacks;
  constexpr int kColumns = Tableau<N, Real>::kColumns;
  constexpr int kStride = V * kRowPadding;
  typedef float Half __attribute__((vector_size(kWidth * 4), aligned(kWidth * 4), may_alias));
  alignas(64) float R[kRows + 1][kStride];  // and x
  for (int k = 0; k <= kRows; ++k) {
    for (int p = 0; p < kStride; p += kWidth) {
      *reinterpret_cast<Half*>(R[k] + p) = __builtin_convertvector(load(basis.R + k * kStride + p), Half);
    }
  }
  for (int t = 0; t < kPacks; ++t) {
    const int at = t * F::kCount;
    F::Pack W[kRows] = {};
    for (int k = 0; k < kRows; ++k) {
      const F::Pack c = load(tableau->column[k] + at);
#pragma GCC unroll 16
      for (int i = 0; i < kRows; ++i) W[i] += broadcast(R[k][i]) * c;
    }
    const F::Index is_x = lane_numbers<F::Index>() + at == F::Index{} + (kColumns - 1);
#pragma GCC unroll 16
    for (int i = 0; i < kRows; ++i) {
      *reinterpret_cast<F::Pack*>(tableau->row[i] + at) = is_x ? broadcast(R[kRows][i]) : W[i];
    }
  }
  RatioTests<N, Real> tests;
#pragma GCC unroll 16
  for (int i = 0; i < kRows; ++i) {
    F::Pack W[kPacks];
#pragma GCC unroll 8
    for (int t = 0; t < kPacks; ++t) W[t] = load(tableau->row[i] + t * F::kCount);
    tests.take(W, i);
  }
  return propose(tableau, tests, dantzig);
}

// The proposed change is made: W_i - (W_ij / W_rj) W_r, and W_r / W_rj. The next one.
template <int N, class Real>
inline Proposal change(Tableau<N, Real>* tableau, Proposal made, bool dantzig) {
  using F = Vec<float>;
  constexpr int kRows = Tableau<N, Real>::kRows;
  constexpr int kPacks = Tableau<N, Real>::kPacks;
  // Less 1 in row r, so that one formula updates it too.
  alignas(64) static constexpr float kUnit[32] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  const float* unit = kUnit + 15 - made.row;
  const float inverse = 1.0F / tableau->row[made.row][made.column];
  F::Pack pivot_row[kPacks];
  for (int t = 0; t < kPacks; ++t) pivot_row[t] = load(tableau->row[made.row] + t * F::kCount) * inverse;
  const auto subtract = [&](int i, float share, F::Pack* W) {
    float* row = tableau->row[i];
#pragma GCC unroll 8
    for (int t = 0; t < kPacks; ++t) {
      W[t] = load(row + t * F::kCount) - broadcast(share) * pivot_row[t];
      *reinterpret_cast<F::Pack*>(row + t * F::kCount) = W[t];
    }
  };
  RatioTests<N, Real> tests;
  F::Pack W[kPacks];
#pragma GCC unroll 16
  for (int i = 0; i < kRows; ++i) {
    subtract(i, tableau->row[i][made.column] - unit[i], W);
    tests.take(W, i);
  }
  subtract(kRows, tableau->row[kRows][made.column], W);
  return propose(tableau, tests, dantzig);
}

// The first of the columns of a set are at `first`. The point that a column is made of.
template <int N, class Real>
inline std::ptrdiff_t point_of(const Tableau<N, Real>& tableau, int column, std::ptrdiff_t size) {
  constexpr std::ptrdiff_t kBlock = N * Vec<Real>::kPoints;
  const auto offset = static_cast<std::ptrdiff_t>(tableau.offset[column]);
  const std::ptrdiff_t point = offset / kBlock * Vec<Real>::kPoints + offset % kBlock;
  return point < size ? point : size - 1;
}

// The last column of Q gives way to x: where it is better than another one, that one's place is taken.
template <class Real>
inline void spare_last(LaneMaxima<Real>* maxima, typename Vec<Real>::Index* offset) {
  using Index = typename Vec<Real>::Index;
  constexpr int kLast = kPacksPerBlock - 1;
  constexpr int kSpare = Vec<Real>::kCount / 2 - 1;
  auto& value = maxima->value[kLast];
  const auto last = last_lane(value);
  const Index better = (lane_numbers<Index>() == Index{} + kSpare) & (last > value);
  value = better ? last : value;
  offset[kLast] = better ? last_lane(offset[kLast]) : offset[kLast];
}

// Notes where the best points of the lanes are, at `first`, and their reduced costs c - s·u for the products
// s.
template <int N, class Real>
inline void take_lanes(Tableau<N, Real>* tableau, int first, LaneMaxima<Real> maxima, Real cost) {
  using V = Vec<Real>;
  using Index = typename V::Index;
  typedef float Floats __attribute__((vector_size(V::kCount * 4), aligned(V::kCount * 4), may_alias));
  Index offset[kPacksPerBlock];
  for (int t = 0; t < kPacksPerBlock; ++t) {
    using Integer = typename V::Integer;
    const Index lane = lane_numbers<Index>() + static_cast<Integer>(t * V::kCount);
    offset[t] = maxima.block[t] * static_cast<Integer>(N * V::kPoints) + lane;
  }
  if (first > 0) spare_last(&maxima, offset);
  for (int t = 0; t < kPacksPerBlock; ++t) {
    const int at = first + t * V::kCount;
    *reinterpret_cast<Index*>(tableau->offset + at) = offset[t];
    *reinterpret_cast<Floats*>(tableau->row[N + 1] + at) =
        __builtin_convertvector(cost - maxima.value[t], Floats);
  }
}

// C, from the places noted.
template <int N, class Real>
inline void gather(Tableau<N, Real>* tableau, const Real* A, const Real* Q) {
  using F = Vec<float>;
  using T = Tableau<N, Real>;
  for (int t = 0; t < T::kPacks; ++t) {
    const Real* point[F::kCount];
    for (int lane = 0; lane < F::kCount; ++lane) {
      const int column = t * F::kCount + lane;
      point[lane] = (column < T::kOfSet ? A : Q) + tableau->offset[column];
    }
    const F::Index of_A = lane_numbers<F::Index>() + t * F::kCount < F::Index{} + T::kOfSet;
    for (int k = 0; k < N; ++k) {
      const F::Pack p =
          floats_of([&](int lane) { return static_cast<float>(point[lane][k * Vec<Real>::kPoints]); });
      *reinterpret_cast<F::Pack*>(tableau->column[k] + t * F::kCount) = of_A ? p : -p;
    }
    *reinterpret_cast<F::Pack*>(tableau->column[N] + t * F::kCount) = of_A ? F::Pack{} + 1.0F : F::Pack{};
  }
}

// What reduced costs have to be below to be no rounding, neither of the pass nor of the updates.
template <int N, class Real>
inline void set_limits(Tableau<N, Real>* tableau, const Candidates& worth) {
  using F = Vec<float>;
  using T = Tableau<N, Real>;
  constexpr double kOfUpdates = 1e-5;  // relative to the largest reduced cost that enters
  constexpr double kRounded = 1 - 1e-6;
  const double largest_A = worth.A_enters() ? -worth.d_A : 0.0;
  const double largest_Q = worth.Q_enters() ? -worth.d_Q : 0.0;
  const double updates = kOfUpdates * (largest_A > largest_Q ? largest_A : largest_Q);
  const auto limit_of = [=](double tolerance) {
    return static_cast<float>(-kRounded * (tolerance > updates ? tolerance : updates));
  };
  const float of_A = limit_of(worth.tolerance_A);
  const float of_Q = limit_of(worth.tolerance_Q);
  for (int t = 0; t < T::kPacks; ++t) {
    const F::Index lane = lane_numbers<F::Index>() + t * F::kCount;
    const F::Pack limit = lane < F::Index{} + T::kOfSet ? F::Pack{} + of_A : F::Pack{} + of_Q;
    *reinterpret_cast<F::Pack*>(tableau->limit + t * F::kCount) =
        lane == F::Index{} + (T::kColumns - 1) ? F::Pack{} - __builtin_inff() : limit;
  }
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
