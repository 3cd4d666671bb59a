// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The vector kernels, written once and compiled once per instruction set: each including file defines
// RAYGAUGE_ISA (a namespace) and RAYGAUGE_WIDTH (doubles in a register). Nothing of the standard library is
// called from here, so that no inline function compiled for a newer machine can leak into the portable part
// of the program.

#include "engine/kernel/kernel.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

constexpr int kWidth = RAYGAUGE_WIDTH;
constexpr int kLanes = 8;  // points in a block
constexpr int kPacksPerBlock = kLanes / kWidth;
constexpr double kInfinity = __builtin_inf();

typedef double Pack __attribute__((vector_size(kWidth * 8), aligned(kWidth * 8), may_alias));
typedef long long IndexPack __attribute__((vector_size(kWidth * 8), aligned(kWidth * 8), may_alias));

inline Pack load(const double* p) { return *reinterpret_cast<const Pack*>(p); }
inline void store(double* p, Pack v) { *reinterpret_cast<Pack*>(p) = v; }
inline Pack broadcast(double a) { return Pack{} + a; }
inline IndexPack broadcast_index(long long a) { return IndexPack{} + a; }
inline Pack select(IndexPack mask, Pack a, Pack b) { return mask ? a : b; }
inline Pack maximum(Pack a, Pack b) { return a > b ? a : b; }
inline double absolute(double a) { return __builtin_fabs(a); }

// A reduction over the lanes by halving; every lane of the result holds the answer.
template <class V, class Op>
inline V reduce_lanes(V v, Op op) {
  if constexpr (kWidth == 8) {
    v = op(v, __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3));
    v = op(v, __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5));
    return op(v, __builtin_shufflevector(v, v, 1, 0, 3, 2, 5, 4, 7, 6));
  } else if constexpr (kWidth == 4) {
    v = op(v, __builtin_shufflevector(v, v, 2, 3, 0, 1));
    return op(v, __builtin_shufflevector(v, v, 1, 0, 3, 2));
  } else {
    return op(v, __builtin_shufflevector(v, v, 1, 0));
  }
}

inline double largest_lane(Pack v) {
  return reduce_lanes(v, [](Pack a, Pack b) { return a > b ? a : b; })[0];
}
inline double smallest_lane(Pack v) {
  return reduce_lanes(v, [](Pack a, Pack b) { return a < b ? a : b; })[0];
}
inline long long smallest_lane(IndexPack v) {
  return reduce_lanes(v, [](IndexPack a, IndexPack b) { return a < b ? a : b; })[0];
}

// 0, 1, 2, …
inline IndexPack lane_numbers() {
  IndexPack lanes;
  for (int lane = 0; lane < kWidth; ++lane) lanes[lane] = lane;
  return lanes;
}

constexpr long long kNoIndex = 0x7fffffffffffffff;

// ------------------------------ support queries

// Per-lane running maxima with the block each stems from.
struct LaneMaxima {
  Pack value[kPacksPerBlock];
  IndexPack block[kPacksPerBlock];

  LaneMaxima() {
    for (int t = 0; t < kPacksPerBlock; ++t) {
      value[t] = broadcast(-kInfinity);
      block[t] = IndexPack{};
    }
  }

  void take(const Pack* sum, long long b) {
    for (int t = 0; t < kPacksPerBlock; ++t) {
      const IndexPack better = sum[t] > value[t];
      value[t] = better ? sum[t] : value[t];
      block[t] = better ? broadcast_index(b) : block[t];
    }
  }

  // The maximum over all lanes, ties to the smallest point index.
  double reduce(std::ptrdiff_t* index) const {
    Pack top = value[0];
    for (int t = 1; t < kPacksPerBlock; ++t) top = maximum(top, value[t]);
    const double best = largest_lane(top);
    IndexPack where = broadcast_index(kNoIndex);
    for (int t = 0; t < kPacksPerBlock; ++t) {
      const IndexPack points = block[t] * kLanes + (lane_numbers() + t * kWidth);
      const IndexPack winners = value[t] == broadcast(best) ? points : broadcast_index(kNoIndex);
      where = winners < where ? winners : where;
    }
    *index = smallest_lane(where);
    return best;
  }
};

template <int N>
inline void dot_block(const double* p, int n, const double* u, Pack* sum) {
  for (int t = 0; t < kPacksPerBlock; ++t) sum[t] = Pack{};
  const int dimension = N > 0 ? N : n;
  for (int k = 0; k < dimension; ++k) {
    const Pack uk = broadcast(u[k]);
    for (int t = 0; t < kPacksPerBlock; ++t) sum[t] += uk * load(p + k * kLanes + t * kWidth);
  }
}

// Two blocks at once: twice the independent chains of additions where n is large.
inline void dot_two_blocks(const double* p, const double* q, int n, const double* u, Pack* sum_p,
                           Pack* sum_q) {
  for (int t = 0; t < kPacksPerBlock; ++t) sum_p[t] = sum_q[t] = Pack{};
  for (int k = 0; k < n; ++k) {
    const Pack uk = broadcast(u[k]);
    for (int t = 0; t < kPacksPerBlock; ++t) {
      sum_p[t] += uk * load(p + k * kLanes + t * kWidth);
      sum_q[t] += uk * load(q + k * kLanes + t * kWidth);
    }
  }
}

template <int N>
double price_n(const double* blocks, std::ptrdiff_t block_count, int n, const double* u,
               std::ptrdiff_t* index) {
  LaneMaxima maxima;
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(N > 0 ? N : n) * kLanes;
  std::ptrdiff_t b = 0;
  if (N == 0) {
    for (; b + 1 < block_count; b += 2) {
      Pack first[kPacksPerBlock];
      Pack second[kPacksPerBlock];
      dot_two_blocks(blocks + b * stride, blocks + (b + 1) * stride, n, u, first, second);
      maxima.take(first, b);
      maxima.take(second, b + 1);
    }
  }
  for (; b < block_count; ++b) {
    Pack sum[kPacksPerBlock];
    dot_block<N>(blocks + b * stride, n, u, sum);
    maxima.take(sum, b);
  }
  return maxima.reduce(index);
}

double price(const double* blocks, std::ptrdiff_t block_count, int n, const double* u,
             std::ptrdiff_t* index) {
  switch (n) {
    case 2:
      return price_n<2>(blocks, block_count, n, u, index);
    case 3:
      return price_n<3>(blocks, block_count, n, u, index);
    case 4:
      return price_n<4>(blocks, block_count, n, u, index);
    case 5:
      return price_n<5>(blocks, block_count, n, u, index);
    case 6:
      return price_n<6>(blocks, block_count, n, u, index);
    case 7:
      return price_n<7>(blocks, block_count, n, u, index);
    case 8:
      return price_n<8>(blocks, block_count, n, u, index);
    case 9:
      return price_n<9>(blocks, block_count, n, u, index);
    case 10:
      return price_n<10>(blocks, block_count, n, u, index);
    default:
      return price_n<0>(blocks, block_count, n, u, index);
  }
}

// Keeps the better half of a full collection and raises its threshold accordingly (quickselect on the
// values).
void halve(Collection* c) {
  std::ptrdiff_t low = 0;
  std::ptrdiff_t high = c->count - 1;
  const std::ptrdiff_t keep = c->count / 2;
  while (low < high) {
    const double pivot = c->value[low + (high - low) / 2];
    std::ptrdiff_t i = low;
    std::ptrdiff_t j = high;
    while (i <= j) {
      while (c->value[i] > pivot) ++i;
      while (c->value[j] < pivot) --j;
      if (i <= j) {
        const double v = c->value[i];
        c->value[i] = c->value[j];
        c->value[j] = v;
        const std::int64_t id = c->index[i];
        c->index[i++] = c->index[j];
        c->index[j--] = id;
      }
    }
    if (keep <= j) {
      high = j;
    } else if (keep >= i) {
      low = i;
    } else {
      break;
    }
  }
  c->threshold = c->value[keep];
  c->count = keep;
}

void collect_block(const Pack* sum, std::ptrdiff_t b, Collection* c) {
  for (int lane = 0; lane < kLanes; ++lane) {
    const double v = sum[lane / kWidth][lane % kWidth];
    if (v > c->threshold) {
      if (c->count == c->capacity) {
        halve(c);
        if (!(v > c->threshold)) continue;
      }
      c->index[c->count] = b * kLanes + lane;
      c->value[c->count++] = v;
    }
  }
}

inline bool any_above(Pack v, double threshold) { return largest_lane(v) > threshold; }

template <int N>
double collect_n(const double* blocks, std::ptrdiff_t first, std::ptrdiff_t last, int n, const double* u,
                 Collection* collection) {
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(N > 0 ? N : n) * kLanes;
  constexpr int kGroup = 4;  // blocks between two looks at the threshold
  Pack best = broadcast(-kInfinity);
  std::ptrdiff_t b = first;
  for (; b + kGroup <= last; b += kGroup) {
    Pack sum[kGroup][kPacksPerBlock];
    for (int g = 0; g < kGroup; ++g) dot_block<N>(blocks + (b + g) * stride, n, u, sum[g]);
    Pack top = sum[0][0];
    for (int g = 0; g < kGroup; ++g) {
      for (int t = 0; t < kPacksPerBlock; ++t) top = maximum(top, sum[g][t]);
    }
    best = maximum(best, top);
    if (any_above(top, collection->threshold)) [[unlikely]] {
      for (int g = 0; g < kGroup; ++g) collect_block(sum[g], b + g, collection);
    }
  }
  for (; b < last; ++b) {
    Pack sum[kPacksPerBlock];
    dot_block<N>(blocks + b * stride, n, u, sum);
    for (int t = 0; t < kPacksPerBlock; ++t) best = maximum(best, sum[t]);
    collect_block(sum, b, collection);
  }
  return largest_lane(best);
}

double collect(const double* blocks, std::ptrdiff_t first, std::ptrdiff_t last, int n, const double* u,
               Collection* collection) {
  switch (n) {
    case 2:
      return collect_n<2>(blocks, first, last, n, u, collection);
    case 3:
      return collect_n<3>(blocks, first, last, n, u, collection);
    case 4:
      return collect_n<4>(blocks, first, last, n, u, collection);
    case 5:
      return collect_n<5>(blocks, first, last, n, u, collection);
    case 6:
      return collect_n<6>(blocks, first, last, n, u, collection);
    case 7:
      return collect_n<7>(blocks, first, last, n, u, collection);
    case 8:
      return collect_n<8>(blocks, first, last, n, u, collection);
    case 9:
      return collect_n<9>(blocks, first, last, n, u, collection);
    case 10:
      return collect_n<10>(blocks, first, last, n, u, collection);
    default:
      return collect_n<0>(blocks, first, last, n, u, collection);
  }
}

// ------------------------------ the basis

// Pivots below this are rounding noise: data are scaled to magnitude 1.
constexpr double kPivotTolerance = 1e-10;
// Harris: how far a basic variable may be pushed below zero for a better pivot.
constexpr double kHarrisTolerance = 1e-11;

// Number of packs in a padded row vector: known at compile time for V > 0.
template <int V>
inline int packs(const BasisView& basis) {
  return V > 0 ? V * kRowPadding / kWidth : basis.P / kWidth;
}

template <int V>
inline void ftran(BasisView* basis, const double* column) {
  const int P = V > 0 ? V * kRowPadding : basis->P;
  if constexpr (V > 0) {
    constexpr int kPacks = V * kRowPadding / kWidth;
    Pack even[kPacks] = {};
    Pack odd[kPacks] = {};
    int k = 0;
    for (; k + 1 < basis->m; k += 2) {
      const Pack a = broadcast(column[k]);
      const Pack b = broadcast(column[k + 1]);
      for (int p = 0; p < kPacks; ++p) {
        even[p] += a * load(basis->R + k * P + p * kWidth);
        odd[p] += b * load(basis->R + (k + 1) * P + p * kWidth);
      }
    }
    if (k < basis->m) {
      const Pack a = broadcast(column[k]);
      for (int p = 0; p < kPacks; ++p) even[p] += a * load(basis->R + k * P + p * kWidth);
    }
    for (int p = 0; p < kPacks; ++p) store(basis->w + p * kWidth, even[p] + odd[p]);
  } else {
    const int count = packs<V>(*basis);
    for (int p = 0; p < count; ++p) store(basis->w + p * kWidth, Pack{});
    for (int k = 0; k < basis->m; ++k) {
      const Pack a = broadcast(column[k]);
      const double* Rk = basis->R + static_cast<std::ptrdiff_t>(k) * P;
      for (int p = 0; p < count; ++p) {
        store(basis->w + p * kWidth, load(basis->w + p * kWidth) + a * load(Rk + p * kWidth));
      }
    }
  }
}

// Harris' two-pass ratio test: the largest pivot among the rows that block within the tolerance. -1 if none
// blocks.
template <int V>
inline int ratio_test(const BasisView& basis) {
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

  Pack largest = broadcast(0.0);
  IndexPack where = broadcast_index(kNoIndex);
  for (int p = 0; p < count; ++p) {
    const Pack w = load(basis.w + p * kWidth);
    const IndexPack blocks =
        (load(x + p * kWidth) <= bound * w) & (w > broadcast(kPivotTolerance)) & (w > largest);
    largest = blocks ? w : largest;
    where = blocks ? lane_numbers() + static_cast<long long>(p) * kWidth : where;
  }
  const double pivot = largest_lane(largest);
  return static_cast<int>(smallest_lane(largest == broadcast(pivot) ? where : broadcast_index(kNoIndex)));
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

// Replaces basic column r by `column`; w = R column is in place. Returns the step length θ.
template <int V>
inline double replace(BasisView* basis, int r, const double* column, double cost, double reduced_cost,
                      std::int64_t id) {
  const int P = V > 0 ? V * kRowPadding : basis->P;
  const int count = packs<V>(*basis);
  const double inverse_pivot = 1.0 / basis->w[r];
  basis->w[r] -= 1.0;  // so that one formula updates row r too: R_rk - (R_rk/w_r)(w_r - 1) = R_rk/w_r
  for (int k = 0; k <= basis->m; ++k) {
    double* Rk = basis->R + static_cast<std::ptrdiff_t>(k) * P;
    const double scaled = Rk[r] * inverse_pivot;
    basis->row[k] = scaled;
    const Pack s = broadcast(scaled);
    for (int p = 0; p < count; ++p) {
      store(Rk + p * kWidth, load(Rk + p * kWidth) - s * load(basis->w + p * kWidth));
    }
  }
  const double theta = basis->row[basis->m];
  basis->row[basis->m] = 0.0;
  const Pack d = broadcast(reduced_cost);
  double* Br = basis->B + static_cast<std::ptrdiff_t>(r) * P;
  for (int p = 0; p < count; ++p) {
    store(basis->y + p * kWidth, load(basis->y + p * kWidth) + d * load(basis->row + p * kWidth));
    store(Br + p * kWidth, load(column + p * kWidth));
  }
  basis->cost[r] = cost;
  basis->id[r] = id;
  basis->objective += theta * reduced_cost;
  ++basis->pivots;
  return theta;
}

template <int V>
inline int enter(BasisView* basis, const double* column, double cost, double reduced_cost, std::int64_t id,
                 bool bland, std::int64_t* left, double* theta) {
  ftran<V>(basis, column);
  const int r = bland ? bland_ratio_test(*basis) : ratio_test<V>(*basis);
  if (r < 0) return -1;
  *left = basis->id[r];
  *theta = replace<V>(basis, r, column, cost, reduced_cost, id);
  return r;
}

template <int V>
PivotResult pivot_v(BasisView* basis, const double* column, double cost, double reduced_cost, std::int64_t id,
                    bool bland, std::int64_t* left) {
  double theta = 0;
  const int row = enter<V>(basis, column, cost, reduced_cost, id, bland, left, &theta);
  return row < 0 ? PivotResult::no_pivot : PivotResult::ok;
}

PivotResult pivot(BasisView* basis, const double* column, double cost, double reduced_cost, std::int64_t id,
                  bool bland, std::int64_t* left) {
  switch (basis->P / kRowPadding) {
    case 1:
      return pivot_v<1>(basis, column, cost, reduced_cost, id, bland, left);
    case 2:
      return pivot_v<2>(basis, column, cost, reduced_cost, id, bland, left);
    default:
      return pivot_v<0>(basis, column, cost, reduced_cost, id, bland, left);
  }
}

// ------------------------------ the direct loop

// One candidate to enter the basis: a point of A (cost 0, convexity 1) or of Q (negated, cost 1, convexity
// 0).
struct Candidate {
  const double* blocks;
  std::ptrdiff_t index;
  bool from_Q;
};

inline void form_column(const Candidate& candidate, int n, double* column) {
  const double* p = candidate.blocks + (candidate.index / kLanes) * n * kLanes + candidate.index % kLanes;
  if (candidate.from_Q) {
    for (int k = 0; k < n; ++k) column[k] = -p[k * kLanes];
    column[n] = 0.0;
  } else {
    for (int k = 0; k < n; ++k) column[k] = p[k * kLanes];
    column[n] = 1.0;
  }
}

inline double reduced_cost(const BasisView& basis, const double* column, double cost) {
  double sum = 0;
  for (int k = 0; k < basis.m; ++k) sum += basis.y[k] * column[k];
  return cost - sum;
}

template <int V, int N>
LoopEnd direct_loop_vn(BasisView* basis, DirectLoop* loop) {
  const int n = basis->m - 1;
  constexpr int kFixed = V > 0 ? V * kRowPadding : 1;
  alignas(64) double fixed_column[kFixed] = {};
  alignas(64) double fixed_negative[kFixed] = {};
  double* column = V > 0 ? fixed_column : basis->row + padded_rows(basis->m + 1);
  double* negative = V > 0 ? fixed_negative : column + basis->P;
  int idle = 0;
  const int patience = 8 * basis->m + 64;
  while (basis->pivots < loop->pivot_limit) {
    for (int k = 0; k < n; ++k) negative[k] = -basis->y[k];
    const double t = basis->y[n];
    Candidate from_A{loop->A.blocks, 0, false};
    Candidate from_Q{loop->Q.blocks, 0, true};
    const double h_A = price_n<N>(loop->A.blocks, loop->A.block_count, n, basis->y, &from_A.index);
    const double h_Q = price_n<N>(loop->Q.blocks, loop->Q.block_count, n, negative, &from_Q.index);
    loop->points_priced += (loop->A.block_count + loop->Q.block_count) * kLanes;
    ++loop->pricings;
    const double d_A = -(h_A + t);
    const double d_Q = loop->cost_of_Q - h_Q;
    const double tolerance_A = loop->cost_tolerance * (absolute(t) + absolute(h_A));
    const bool A_enters = d_A < -tolerance_A;
    const bool Q_enters = d_Q < -loop->cost_tolerance;
    if (!A_enters && !Q_enters) return LoopEnd::optimal;
    if (loop->artificials == 0 && h_Q > 0 &&
        basis->objective + h_A / h_Q <= loop->gap_tolerance * basis->objective) {
      return LoopEnd::gap;
    }
    // The larger promised gain first: α moves by at most 1, β by about the objective.
    const bool A_first = A_enters && (!Q_enters || d_A < d_Q * absolute(t));
    double gained = 0;
    for (int turn = 0; turn < 2; ++turn) {
      const bool take_A = (turn == 0) == A_first;
      if (!(take_A ? A_enters : Q_enters)) continue;
      const Candidate& candidate = take_A ? from_A : from_Q;
      form_column(candidate, n, column);
      const double cost = take_A ? 0.0 : loop->cost_of_Q;
      double d = take_A ? d_A : d_Q;
      if (turn == 1) {
        d = reduced_cost(*basis, column, cost);
        if (!(d < -(take_A ? tolerance_A : loop->cost_tolerance))) continue;
      }
      std::int64_t left = 0;
      double theta = 0;
      const std::int64_t id = take_A ? id_of_A(candidate.index) : id_of_Q(candidate.index);
      if (enter<V>(basis, column, cost, d, id, loop->bland, &left, &theta) < 0) return LoopEnd::unbounded;
      if (left < 0) --loop->artificials;
      gained -= theta * d;
    }
    if (gained > 1e-14 * absolute(basis->objective)) {
      idle = 0;
    } else if (++idle > patience && !loop->bland) {
      return LoopEnd::stalled;
    }
  }
  return LoopEnd::pivot_limit;
}

LoopEnd direct_loop(BasisView* basis, DirectLoop* loop) {
  switch (basis->m - 1) {
    case 2:
      return direct_loop_vn<1, 2>(basis, loop);
    case 3:
      return direct_loop_vn<1, 3>(basis, loop);
    case 4:
      return direct_loop_vn<1, 4>(basis, loop);
    case 5:
      return direct_loop_vn<1, 5>(basis, loop);
    case 6:
      return direct_loop_vn<1, 6>(basis, loop);
    case 7:
      return direct_loop_vn<1, 7>(basis, loop);
    case 8:
      return direct_loop_vn<2, 8>(basis, loop);
    case 9:
      return direct_loop_vn<2, 9>(basis, loop);
    case 10:
      return direct_loop_vn<2, 10>(basis, loop);
    default:
      break;
  }
  switch (basis->P / kRowPadding) {
    case 1:
      return direct_loop_vn<1, 0>(basis, loop);
    case 2:
      return direct_loop_vn<2, 0>(basis, loop);
    case 3:
      return direct_loop_vn<3, 0>(basis, loop);
    default:
      return direct_loop_vn<0, 0>(basis, loop);
  }
}

double inverse_residual(BasisView* basis) {
  const int P = basis->P;
  const int m = basis->m;
  const int count = P / kWidth;
  double* sum = basis->row;  // row sums of |I - R B|
  double* product = basis->w;
  for (int i = 0; i < P; ++i) sum[i] = 0;
  for (int j = 0; j < m; ++j) {
    const double* Bj = basis->B + static_cast<std::ptrdiff_t>(j) * P;
    for (int p = 0; p < count; ++p) store(product + p * kWidth, Pack{});
    product[j] = -1.0;
    for (int k = 0; k < m; ++k) {
      const Pack b = broadcast(Bj[k]);
      const double* Rk = basis->R + static_cast<std::ptrdiff_t>(k) * P;
      for (int p = 0; p < count; ++p) {
        store(product + p * kWidth, load(product + p * kWidth) + b * load(Rk + p * kWidth));
      }
    }
    for (int p = 0; p < count; ++p) {
      const Pack v = load(product + p * kWidth);
      store(sum + p * kWidth, load(sum + p * kWidth) + (v > Pack{} ? v : -v));
    }
  }
  double worst = 0;
  for (int i = 0; i < m; ++i) worst = sum[i] > worst ? sum[i] : worst;
  return worst;
}

}  // namespace

extern const Kernels kKernels;
const Kernels kKernels = {price, collect, pivot, direct_loop, inverse_residual};

}  // namespace raygauge::RAYGAUGE_ISA
