// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Basis changes: one column enters, one leaves, the explicit inverse is updated. Part of kernel_impl.h.
#pragma once

#include <type_traits>

#include "engine/kernels/support_kernels.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// Pivots below this are rounding noise: data are scaled to magnitude 1.
constexpr double kPivotTolerance = 1e-10;
// Harris: how far a basic variable may be pushed below zero for a better pivot.
constexpr double kHarrisTolerance = 1e-11;

// Number of packs in a padded row vector: known at compile time for V > 0.
template <int V>
inline int packs(const BasisView& basis) {
  return V > 0 ? V * kRowPadding / kWidth : basis.P / kWidth;
}

// Number of equations: known at compile time for N > 0 dimensions.
template <int N>
inline int rows(const BasisView& basis) {
  return N > 0 ? N + 1 : basis.m;
}

// f(V, N), both as constants where there are kernels for them, else 0.
template <class F>
inline auto with_size(const BasisView& basis, F f) {
  return with_dimension(basis.m - 1, [&](auto N) {
    constexpr int kDimension = decltype(N)::value;
    using std::integral_constant;
    if constexpr (kDimension > 0) {
      return f(integral_constant<int, (kDimension + kRowPadding) / kRowPadding>{}, N);
    } else {
      switch (basis.P / kRowPadding) {
        case 1:
          return f(integral_constant<int, 1>{}, N);
        case 2:
          return f(integral_constant<int, 2>{}, N);
        case 3:
          return f(integral_constant<int, 3>{}, N);
        default:
          return f(integral_constant<int, 0>{}, N);
      }
    }
  });
}

// w = (R - G ρᵀ) column, rows of R in registers.
inline void ftran_pending(BasisView* basis, const double* column) {
  constexpr int kChunk = 8;
  const int m = basis->m;
  double factor[kMostPending];
  for (int j = 0; j < basis->pending; ++j) {
    const double* row = basis->change_rows + static_cast<std::ptrdiff_t>(j) * basis->P;
    Pack sum = load(row) * load(column);
    for (int p = kWidth; p < basis->P; p += kWidth) sum += load(row + p) * load(column + p);
    factor[j] = reduce_lanes(sum, [](Pack a, Pack c) { return a + c; })[0];
  }
  const int total = basis->P / kWidth;
  const auto rows_from = [&](int first, auto count_as_constant) {
    constexpr int kCount = decltype(count_as_constant)::value;
    Pack sum[kCount] = {};
    const double* R = basis->R + first * kWidth;
    for (int k = 0; k < m; ++k, R += basis->P) {
      const Pack a = broadcast(column[k]);
      for (int p = 0; p < kCount; ++p) sum[p] += a * load(R + p * kWidth);
    }
    for (int j = 0; j < basis->pending; ++j) {
      const Pack a = broadcast(factor[j]);
      const double* G = basis->changes + static_cast<std::ptrdiff_t>(j) * basis->P + first * kWidth;
      for (int p = 0; p < kCount; ++p) sum[p] -= a * load(G + p * kWidth);
    }
    for (int p = 0; p < kCount; ++p) store(basis->w + (first + p) * kWidth, sum[p]);
  };
  int first = 0;
  for (; first + kChunk <= total; first += kChunk) rows_from(first, std::integral_constant<int, kChunk>{});
  for (; first + 2 <= total; first += 2) rows_from(first, std::integral_constant<int, 2>{});
  for (; first < total; ++first) rows_from(first, std::integral_constant<int, 1>{});
}

// R -= G ρᵀ over kPacks packs of rows from `first` and kColumns columns from k.
template <int kPacks, int kColumns>
inline void subtract_tile(BasisView* basis, int first, int k) {
  double* R = basis->R + static_cast<std::ptrdiff_t>(k) * basis->P + first * kWidth;
  Pack sum[kColumns][kPacks];
  for (int c = 0; c < kColumns; ++c) {
    for (int p = 0; p < kPacks; ++p)
      sum[c][p] = load(R + static_cast<std::ptrdiff_t>(c) * basis->P + p * kWidth);
  }
  for (int j = 0; j < basis->pending; ++j) {
    const double* G = basis->changes + static_cast<std::ptrdiff_t>(j) * basis->P + first * kWidth;
    const double* row = basis->change_rows + static_cast<std::ptrdiff_t>(j) * basis->P + k;
    Pack g[kPacks];
    for (int p = 0; p < kPacks; ++p) g[p] = load(G + p * kWidth);
    for (int c = 0; c < kColumns; ++c) {
      const Pack a = broadcast(row[c]);
      for (int p = 0; p < kPacks; ++p) sum[c][p] -= a * g[p];
    }
  }
  for (int c = 0; c < kColumns; ++c) {
    for (int p = 0; p < kPacks; ++p)
      store(R + static_cast<std::ptrdiff_t>(c) * basis->P + p * kWidth, sum[c][p]);
  }
}

// Brings R up to date.
inline void subtract_changes(BasisView* basis) {
  if (basis->pending == 0) return;
  const int total = basis->P / kWidth;
  int k = 0;
  for (; k + 4 <= basis->m; k += 4) {
    int first = 0;
    for (; first + 2 <= total; first += 2) subtract_tile<2, 4>(basis, first, k);
    for (; first < total; ++first) subtract_tile<1, 4>(basis, first, k);
  }
  for (; k < basis->m; ++k) {
    for (int first = 0; first < total; ++first) subtract_tile<1, 1>(basis, first, k);
  }
  basis->pending = 0;
}

// Records the change of basic column r for one whose w is in place; y follows. Returns 1 / w_r.
inline double collect_change(BasisView* basis, int r, double reduced_cost) {
  if (basis->pending == kMostPending) subtract_changes(basis);
  const int P = basis->P;
  const double inverse_pivot = 1.0 / basis->w[r];
  basis->w[r] -= 1.0;
  double* row = basis->change_rows + static_cast<std::ptrdiff_t>(basis->pending) * P;
  for (int k = 0; k < basis->m; ++k) row[k] = basis->R[static_cast<std::ptrdiff_t>(k) * P + r];
  for (int k = basis->m; k < P; ++k) row[k] = 0;
  for (int j = 0; j < basis->pending; ++j) {
    const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(j) * P;
    const Pack a = broadcast(basis->changes[at + r]);
    for (int p = 0; p < P; p += kWidth) store(row + p, load(row + p) - a * load(basis->change_rows + at + p));
  }
  double* G = basis->changes + static_cast<std::ptrdiff_t>(basis->pending) * P;
  for (int p = 0; p < P; p += kWidth) {
    store(G + p, load(basis->w + p) * inverse_pivot);
    store(basis->y + p, load(basis->y + p) + reduced_cost * inverse_pivot * load(row + p));
  }
  ++basis->pending;
  return inverse_pivot;
}

template <int V, int N>
inline void ftran(BasisView* basis, const double* column) {
  const int P = V > 0 ? V * kRowPadding : basis->P;
  const int m = rows<N>(*basis);
  if constexpr (V > 0) {
    constexpr int kPacks = V * kRowPadding / kWidth;
    Pack even[kPacks] = {};
    Pack odd[kPacks] = {};
    int k = 0;
    for (; k + 1 < m; k += 2) {
      const Pack a = broadcast(column[k]);
      const Pack b = broadcast(column[k + 1]);
      for (int p = 0; p < kPacks; ++p) {
        even[p] += a * load(basis->R + k * P + p * kWidth);
        odd[p] += b * load(basis->R + (k + 1) * P + p * kWidth);
      }
    }
    if (k < m) {
      const Pack a = broadcast(column[k]);
      for (int p = 0; p < kPacks; ++p) even[p] += a * load(basis->R + k * P + p * kWidth);
    }
    for (int p = 0; p < kPacks; ++p) store(basis->w + p * kWidth, even[p] + odd[p]);
  } else {
    ftran_pending(basis, column);
  }
}

// Harris' two-pass ratio test: the largest pivot among the rows that block within the tolerance. -1 if none
// blocks.
// Inlined, because w has just been stored.
template <int V>
[[gnu::always_inline]] inline int ratio_test(const BasisView& basis) {
  const int count = packs<V>(basis);
  const double* x = basis.x();
  Pack smallest = broadcast(kInfinity);
  for (int p = 0; p < count; ++p) {
    const Pack w = load(basis.w + p * kWidth);
    const Pack xp = load(x + p * kWidth);
    const Pack positive = xp > Pack{} ? xp : Pack{};
    const Pack ratio = (positive + kHarrisTolerance) / w;
    const Pack candidate = w > broadcast(kPivotTolerance) ? ratio : broadcast(kInfinity);
    smallest = candidate < smallest ? candidate : smallest;
  }
  const double bound = smallest_lane(smallest);
  if (!(bound < kInfinity)) return -1;

  const auto blocking = [&](int p) {
    const Pack w = load(basis.w + p * kWidth);
    return (load(x + p * kWidth) <= bound * w) & (w > broadcast(kPivotTolerance)) ? w : Pack{};
  };
  Pack largest{};
  for (int p = 0; p < count; ++p) largest = maximum(largest, blocking(p));
  const double pivot = largest_lane(largest);
  if (!(pivot > 0)) return -1;  // x so large that rounding swallows the tolerance
  if constexpr (V > 0) {
    // Without a branch that depends on the row, which no processor foresees.
    unsigned rows = 0;
    for (int p = 0; p < count; ++p) rows |= lanes_equal(blocking(p), pivot) << (p * kWidth);
    return lowest_bit(rows);
  }
  int p = 0;
  unsigned rows = 0;
  while ((rows = lanes_equal(blocking(p), pivot)) == 0) ++p;
  return p * kWidth + lowest_bit(rows);
}

// Bland: of the rows with the exact smallest ratio, the one with the smallest identity.
inline int bland_ratio_test(const BasisView& basis) {
  const double* x = basis.x();
  int row = -1;
  double bound = kInfinity;
  for (int i = 0; i < basis.m; ++i) {
    if (basis.w[i] <= kPivotTolerance) continue;
    const double ratio = (x[i] > 0 ? x[i] : 0.0) / basis.w[i];
    if (ratio < bound || (ratio == bound && basis.id[i] < basis.id[row])) {
      bound = ratio;
      row = i;
    }
  }
  return row;
}

template <int V>
inline int leaving_row(const BasisView& basis, bool bland) {
  return bland ? bland_ratio_test(basis) : ratio_test<V>(basis);
}

// Replaces basic column r by `column`; w = R column is in place. Returns the step length θ.
template <int V, int N>
inline double replace(BasisView* basis, int r, const double* column, double cost, double reduced_cost,
                      std::int64_t id) {
  const int P = V > 0 ? V * kRowPadding : basis->P;
  const int count = packs<V>(*basis);
  const double inverse_pivot = V > 0 ? 1.0 / basis->w[r] : collect_change(basis, r, reduced_cost);
  // Less 1 in row r, so that one formula updates it too: R_rk - (R_rk/w_r)(w_r - 1) = R_rk/w_r.
  Pack fixed[V > 0 ? V * kRowPadding / kWidth : 1];
  if constexpr (V > 0) {
    // In registers: a vector that is read just after one of its lanes was written waits for the write.
    for (int p = 0; p < count; ++p) {
      const IndexPack lanes = lane_numbers<IndexPack>() + static_cast<long long>(p) * kWidth;
      const Pack w = load(basis->w + p * kWidth);
      fixed[p] = lanes == broadcast_index(r) ? w - 1.0 : w;
    }
  }
  const auto update = [&](int k) {
    double* Rk = basis->R + static_cast<std::ptrdiff_t>(k) * P;
    const double scaled = Rk[r] * inverse_pivot;
    const Pack s = broadcast(scaled);
    for (int p = 0; p < count; ++p) {
      const Pack w = V > 0 ? fixed[V > 0 ? p : 0] : load(basis->w + p * kWidth);
      store(Rk + p * kWidth, load(Rk + p * kWidth) - s * w);
    }
    return scaled;
  };
  const int m = rows<N>(*basis);
  if constexpr (V > 0) {
    for (int k = 0; k < m; ++k) basis->y[k] += reduced_cost * update(k);
  }
  const double theta = update(m);
  double* Br = basis->B + static_cast<std::ptrdiff_t>(r) * P;
  for (int p = 0; p < count; ++p) store(Br + p * kWidth, load(column + p * kWidth));
  basis->cost[r] = cost;
  basis->id[r] = id;
  basis->objective += theta * reduced_cost;
  ++basis->pivots;
  return theta;
}

template <int V, int N>
inline int enter(BasisView* basis, const double* column, double cost, double reduced_cost, std::int64_t id,
                 bool bland, std::int64_t* left, double* theta) {
  ftran<V, N>(basis, column);
  const int r = leaving_row<V>(*basis, bland);
  if (r < 0) return -1;
  *left = basis->id[r];
  *theta = replace<V, N>(basis, r, column, cost, reduced_cost, id);
  return r;
}

template <int V, int N>
PivotResult pivot_vn(BasisView* basis, const double* column, double cost, double reduced_cost,
                     std::int64_t id, bool bland, std::int64_t* left) {
  double theta = 0;
  const int row = enter<V, N>(basis, column, cost, reduced_cost, id, bland, left, &theta);
  return row < 0 ? PivotResult::no_pivot : PivotResult::ok;
}

PivotResult pivot(BasisView* basis, const double* column, double cost, double reduced_cost, std::int64_t id,
                  bool bland, std::int64_t* left) {
  return with_size(*basis, [&](auto V, auto N) {
    return pivot_vn<decltype(V)::value, decltype(N)::value>(basis, column, cost, reduced_cost, id, bland,
                                                            left);
  });
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
