// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The dual simplex over a list of points, from facet to facet, in single precision. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/support_kernels.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

constexpr float kSlack = 1e-6F;  // Harris: reduced costs below it count as it
constexpr float kLeastAlong =
    1e-5F;  // of α and of pivots, by the length of the row of R, for points of length 1
constexpr float kRoundedShare = 2e-6F;  // of Σ|x_i|: what rounding may make of a basic variable

using FloatPack = Vec<float>::Pack;

inline void store(float* p, FloatPack v) { *reinterpret_cast<FloatPack*>(p) = v; }

// 16 numbers: a block, or a column of R.
struct Sixteen {
  static constexpr int kPacks = kPacksPerBlock;
  FloatPack part[kPacks] = {};

  static Sixteen at(const float* p) {
    Sixteen s;
    for (int t = 0; t < kPacks; ++t) s.part[t] = load(p + t * Vec<float>::kCount);
    return s;
  }
  void to(float* p) const {
    for (int t = 0; t < kPacks; ++t) store(p + t * Vec<float>::kCount, part[t]);
  }
  void add(float s, const Sixteen& v) {
    for (int t = 0; t < kPacks; ++t) part[t] += s * v.part[t];
  }
  void add_products(const Sixteen& a, const Sixteen& b) {
    for (int t = 0; t < kPacks; ++t) part[t] += a.part[t] * b.part[t];
  }
  float largest() const {
    FloatPack top = part[0];
    for (int t = 1; t < kPacks; ++t) top = maximum(top, part[t]);
    return largest_lane(top);
  }
  unsigned equal(float value) const {
    unsigned lanes = 0;
    for (int t = 0; t < kPacks; ++t) lanes |= lanes_equal(part[t], value) << (t * Vec<float>::kCount);
    return lanes;
  }
  unsigned above(float value) const {
    unsigned lanes = 0;
    for (int t = 0; t < kPacks; ++t) lanes |= lanes_above(part[t], value) << (t * Vec<float>::kCount);
    return lanes;
  }
};

// Chosen lanes of a block become the columns after the last one. There is room for 16 more than `room`.
inline void keep_lanes(FacetWalk* walk, std::ptrdiff_t b, unsigned lanes, int n) {
  constexpr int kPoints = Vec<float>::kPoints;
  const float* block = walk->blocks + b * n * kPoints;
  const std::int32_t first = static_cast<std::int32_t>(b) * kPoints;
#if defined(__AVX512F__)
  const auto mask = static_cast<__mmask16>(lanes);
  float* to = walk->columns + walk->chosen;
  for (int k = 0; k < n; ++k) {
    const __m512 kept = _mm512_maskz_compress_ps(mask, _mm512_load_ps(block + k * kPoints));
    _mm512_storeu_ps(to + static_cast<std::ptrdiff_t>(k) * walk->stride, kept);
  }
  const __m512i places = _mm512_add_epi32(_mm512_set1_epi32(first),
                                          reinterpret_cast<__m512i>(lane_numbers<Vec<float>::Index>()));
  _mm512_storeu_si512(walk->place + walk->chosen, _mm512_maskz_compress_epi32(mask, places));
  walk->chosen += __builtin_popcount(lanes);
#else
  for (; lanes != 0; lanes &= lanes - 1) {
    const int lane = lowest_bit(lanes);
    float* to = walk->columns + walk->chosen;
    for (int k = 0; k < n; ++k) to[static_cast<std::ptrdiff_t>(k) * walk->stride] = block[k * kPoints + lane];
    walk->place[walk->chosen++] = first + lane;
  }
#endif
}

// Zeros to the end of the last 16 columns.
inline void fill_columns(FacetWalk* walk, int n) {
  for (int at = walk->chosen; at % Vec<float>::kPoints != 0; ++at) {
    for (int k = 0; k < n; ++k) walk->columns[static_cast<std::ptrdiff_t>(k) * walk->stride + at] = 0;
  }
}

// The points that are farthest along b become the columns.
template <int N>
inline void choose_columns(FacetWalk* walk, int n) {
  using F = Vec<float>;
  const std::ptrdiff_t stride = static_cast<std::ptrdiff_t>(N > 0 ? N : n) * F::kPoints;
  Sixteen top;
  for (std::ptrdiff_t b = 0; b < walk->listed; ++b) {
    Sixteen score;
    dot_block<N>(walk->blocks + b * stride, n, walk->target, score.part);
    score.to(walk->cost + b * F::kPoints);
    for (int t = 0; t < kPacksPerBlock; ++t) top.part[t] = maximum(top.part[t], score.part[t]);
  }
  const float least = walk->share_of_highest * top.largest();
  walk->chosen = 0;
  for (std::ptrdiff_t b = 0; b < walk->listed && walk->chosen < walk->room; ++b)
    keep_lanes(walk, b, Sixteen::at(walk->cost + b * F::kPoints).above(least), n);
  fill_columns(walk, n);
}

// v·p of 16 columns.
template <int N>
inline Sixteen products_of_columns(const FacetWalk& walk, int n, int first, const float* v) {
  Sixteen sum;
  for (int k = 0; k < (N > 0 ? N : n); ++k)
    sum.add(v[k], Sixteen::at(walk.columns + static_cast<std::ptrdiff_t>(k) * walk.stride + first));
  return sum;
}

// The least ratio d / -α so far in every lane, compared without dividing, with the block it stems from.
struct LaneRatios {
  using F = Vec<float>;
  FloatPack along[kPacksPerBlock] = {};
  FloatPack cost[kPacksPerBlock];
  F::Index block[kPacksPerBlock] = {};

  FloatPack least;  // α that count are below it

  explicit LaneRatios(float above) : least(FloatPack{} + above) {
    for (FloatPack& c : cost) c = FloatPack{} + 1.0F;
  }

  void take(int t, FloatPack d, FloatPack alpha, F::Index b) {
    const FloatPack e = (d > FloatPack{} ? d : FloatPack{}) + kSlack;
    const F::Index better = (alpha * cost[t] < along[t] * e) & (alpha < least);
    along[t] = better ? alpha : along[t];
    cost[t] = better ? e : cost[t];
    block[t] = better ? b : block[t];
  }

  void merge(const LaneRatios& other) {
    for (int t = 0; t < kPacksPerBlock; ++t) {
      const F::Index better = other.along[t] * cost[t] < along[t] * other.cost[t];
      along[t] = better ? other.along[t] : along[t];
      cost[t] = better ? other.cost[t] : cost[t];
      block[t] = better ? other.block[t] : block[t];
    }
  }

  // The column, or -1.
  int best() const {
    Sixteen ratio;
    for (int t = 0; t < kPacksPerBlock; ++t) ratio.part[t] = -along[t] / cost[t];
    const float value = ratio.largest();
    if (!(value > 0)) return -1;
    const int lane = lowest_bit(ratio.equal(value));
    return block[lane / F::kCount][lane % F::kCount] * F::kPoints + lane;
  }
};

// The last step is taken, d -= step α; then α = ρ·p for the next one, and its ratio test, of those below
// `least`.
template <int N>
inline int entering_column(FacetWalk* walk, int n, const float* rho, float step, float least) {
  using F = Vec<float>;
  const int blocks = (walk->chosen + F::kPoints - 1) / F::kPoints;
  LaneRatios even(least);
  LaneRatios odd(least);  // chains of comparisons that overlap
  const auto take = [&](int b, LaneRatios* ratios) {
    const Sixteen alpha = products_of_columns<N>(*walk, n, b * F::kPoints, rho);
    for (int t = 0; t < kPacksPerBlock; ++t) {
      const int at = b * F::kPoints + t * F::kCount;
      const FloatPack d = load(walk->cost + at) - broadcast(step) * load(walk->along + at);
      store(walk->cost + at, d);
      store(walk->along + at, alpha.part[t]);
      ratios->take(t, d, alpha.part[t], F::Index{} + b);
    }
  };
  int b = 0;
  for (; b + 1 < blocks; b += 2) {
    take(b, &even);
    take(b + 1, &odd);
  }
  if (b < blocks) take(b, &even);
  even.merge(odd);
  return even.best();
}

// d = 1 - y·p, and no α yet.
template <int N>
inline void form_costs(FacetWalk* walk, int n) {
  for (int first = 0; first < walk->chosen; first += Vec<float>::kPoints) {
    Sixteen d = products_of_columns<N>(*walk, n, first, walk->y);
    for (FloatPack& part : d.part) part = 1.0F - part;
    d.to(walk->cost + first);
    Sixteen{}.to(walk->along + first);
  }
}

// R v.
template <int N>
inline Sixteen multiply(const FacetWalk& walk, int n, const float* v, std::ptrdiff_t stride) {
  constexpr int kPoints = Vec<float>::kPoints;
  Sixteen even;
  Sixteen odd;
  int k = 0;
  for (; k + 1 < n; k += 2) {
    even.add(v[k * stride], Sixteen::at(walk.R + k * kPoints));
    odd.add(v[(k + 1) * stride], Sixteen::at(walk.R + (k + 1) * kPoints));
  }
  if (k < n) even.add(v[k * stride], Sixteen::at(walk.R + k * kPoints));
  for (int t = 0; t < kPacksPerBlock; ++t) even.part[t] += odd.part[t];
  return even;
}

// The dual steepest edge: of the negative x_i the one with the largest x_i² / ‖R_i‖². -1 if there is none.
template <int N>
inline int leaving_row_of(const FacetWalk& walk, int n, float least, float* squares) {
  constexpr int kPoints = Vec<float>::kPoints;
  Sixteen sum;
  Sixteen others;
  for (int k = 0; k < n; ++k) {
    const Sixteen R = Sixteen::at(walk.R + k * kPoints);
    (k % 2 == 0 ? sum : others).add_products(R, R);
  }
  const Sixteen x = Sixteen::at(walk.x);
  Sixteen score;
  for (int t = 0; t < kPacksPerBlock; ++t) {
    sum.part[t] += others.part[t];
    score.part[t] = x.part[t] < broadcast(least) ? x.part[t] * x.part[t] / sum.part[t] : FloatPack{};
  }
  sum.to(squares);
  const float best = score.largest();
  return best > 0 ? lowest_bit(score.equal(best)) : -1;
}

// 1 in row r.
inline Sixteen unit(int r) {
  alignas(64) static constexpr float kUnit[32] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  typedef float Unaligned __attribute__((vector_size(kWidth * 8), aligned(4), may_alias));
  Sixteen e;
  for (int t = 0; t < kPacksPerBlock; ++t)
    e.part[t] = *reinterpret_cast<const Unaligned*>(kUnit + 15 - r + t * Vec<float>::kCount);
  return e;
}

// Basic column r becomes column e, w = R p; ρ is row r of R. Returns the step of the reduced costs.
template <int N>
inline float exchange(FacetWalk* walk, int n, int r, int e, const float* rho, Sixteen w, float pivot) {
  constexpr int kPoints = Vec<float>::kPoints;
  const float inverse = 1 / pivot;
  w.add(-1, unit(r));
  const float cost = walk->cost[e];
  const float x_r = walk->x[r];
  for (int k = 0; k < n; ++k) {
    const float scaled = rho[k] * inverse;
    Sixteen R = Sixteen::at(walk->R + k * kPoints);
    R.add(-scaled, w);
    R.to(walk->R + k * kPoints);
    walk->y[k] += cost * scaled;
  }
  Sixteen x = Sixteen::at(walk->x);
  x.add(-x_r * inverse, w);
  x.to(walk->x);
  walk->id[r] = walk->place[e];
  return cost * inverse;
}

// 16 numbers in double.
struct SixteenDoubles {
  static constexpr int kPacks = 16 / kWidth;
  Pack part[kPacks] = {};

  template <class Real>
  static SixteenDoubles at(const Real* p) {
    SixteenDoubles s;
    for (int t = 0; t < kPacks; ++t) s.part[t] = load_wide(p + t * kWidth);
    return s;
  }
  void to(double* p) const {
    for (int t = 0; t < kPacks; ++t) store(p + t * kWidth, part[t]);
  }
  void add(double s, const SixteenDoubles& v) {
    for (int t = 0; t < kPacks; ++t) part[t] += s * v.part[t];
  }
  double dot(const SixteenDoubles& v) const {
    Pack sum = part[0] * v.part[0];
    for (int t = 1; t < kPacks; ++t) sum += part[t] * v.part[t];
    return reduce_lanes(sum, [](Pack a, Pack b) { return a + b; })[0];
  }
};

// Basic column i.
inline const double* point_of(const FacetWalk& walk, int i) {
  return walk.points + static_cast<std::ptrdiff_t>(walk.order[walk.id[i]]) * 16;
}

// b - B x.
inline SixteenDoubles rest_of(const FacetWalk& walk, int n) {
  SixteenDoubles rest = SixteenDoubles::at(walk.wanted);
  for (int i = 0; i < n; ++i) rest.add(-walk.share[i], SixteenDoubles::at(point_of(walk, i)));
  return rest;
}

// R += (I - R B) R, in single precision.
template <int N>
inline void improve_inverse(FacetWalk* walk, int n) {
  Sixteen errors[16];
  for (int j = 0; j < n; ++j) {
    const double* point = point_of(*walk, j);
    alignas(64) float numbers[16] = {};
    for (int k = 0; k < n; ++k) numbers[k] = static_cast<float>(-point[k]);
    Sixteen error = multiply<N>(*walk, n, numbers, 1);
    error.to(numbers);
    numbers[j] += 1;
    errors[j] = Sixteen::at(numbers);
  }
  for (int k = 0; k < n; ++k) {
    Sixteen R = Sixteen::at(walk->R + k * 16);
    alignas(64) float old[16];
    R.to(old);
    for (int j = 0; j < n; ++j) R.add(old[j], errors[j]);
    R.to(walk->R + k * 16);
  }
}

// Two steps of iterative refinement of x and of y, in double by the inverse in single precision.
template <int N>
inline void refine_walk(FacetWalk* walk, int n) {
  alignas(64) double numbers[16] = {};
  SixteenDoubles x = SixteenDoubles::at(walk->x);
  SixteenDoubles y = SixteenDoubles::at(walk->y);
  double drift = 0;
  for (int step = 0; step < 2; ++step) {
    x.to(walk->share);
    rest_of(*walk, n).to(numbers);
    for (int k = 0; k < n; ++k) x.add(numbers[k], SixteenDoubles::at(walk->R + k * 16));
    for (int i = 0; i < n; ++i) {
      const double error = 1 - y.dot(SixteenDoubles::at(point_of(*walk, i)));
      drift = step == 0 && absolute(error) > drift ? absolute(error) : drift;
      numbers[i] = error;
    }
    const SixteenDoubles errors = SixteenDoubles::at(numbers);
    for (int k = 0; k < n; ++k) walk->dual[k] = errors.dot(SixteenDoubles::at(walk->R + k * 16));
    for (int t = 0; t < SixteenDoubles::kPacks; ++t) y.part[t] += load(walk->dual + t * kWidth);
  }
  y.to(walk->dual);
  for (Pack& part : x.part) part = part > Pack{} ? part : Pack{};
  x.to(walk->share);
  rest_of(*walk, n).to(walk->rest);
  constexpr double kDrifted = 1e-5;
  if (drift > kDrifted) improve_inverse<N>(walk, n);
  for (int k = 0; k < n; ++k) walk->y[k] = static_cast<float>(walk->dual[k]);
}

template <int N>
WalkEnd walk_facets_n(FacetWalk* walk) {
  constexpr int kPoints = Vec<float>::kPoints;
  const int n = N > 0 ? N : walk->n;
  choose_columns<N>(walk, n);
  form_costs<N>(walk, n);
  multiply<N>(*walk, n, walk->target, 1).to(walk->x);
  float sum = 0;
  for (int i = 0; i < n; ++i) sum += __builtin_fabsf(walk->x[i]);
  alignas(64) float rho[kPoints];
  alignas(64) float squares[kPoints];
  float step = 0;
  for (walk->pivots = 0; walk->pivots < walk->pivot_limit; ++walk->pivots) {
    const int r = leaving_row_of<N>(*walk, n, -kRoundedShare * sum, squares);
    if (r < 0) {
      refine_walk<N>(walk, n);
      return WalkEnd::arrived;
    }
    for (int k = 0; k < n; ++k) rho[k] = walk->R[k * kPoints + r];
    const float least = -kLeastAlong * __builtin_sqrtf(squares[r]);
    const int e = entering_column<N>(walk, n, rho, step, least);
    if (e < 0) return WalkEnd::no_facet;
    const Sixteen w = multiply<N>(*walk, n, walk->columns + e, walk->stride);
    alignas(64) float shares[kPoints];
    w.to(shares);
    if (!(shares[r] < least)) return WalkEnd::no_facet;
    step = exchange<N>(walk, n, r, e, rho, w, shares[r]);
  }
  return WalkEnd::too_long;
}

// The column with the least d, where it is below -kSlack; else -1.
inline int cheapest_column(const FacetWalk& walk) {
  constexpr int kPoints = Vec<float>::kPoints;
  int best = -1;
  float least = -kSlack / 4;
  for (int b = 0; b < walk.chosen; b += kPoints) {
    Sixteen gain;
    const Sixteen cost = Sixteen::at(walk.cost + b);
    for (int t = 0; t < kPacksPerBlock; ++t) gain.part[t] = -cost.part[t];
    const float value = gain.largest();
    if (!(-value < least)) continue;
    least = -value;
    best = b + lowest_bit(gain.equal(value));
  }
  return best;
}

// The row with the least x_i / w_i of those with w_i > 0; -1 if there is none.
inline int blocking_row(const FacetWalk& walk, int n, const float* w) {
  int row = -1;
  float least = 0;
  for (int i = 0; i < n; ++i) {
    if (!(w[i] > kLeastAlong)) continue;
    const float ratio = (walk.x[i] > 0 ? walk.x[i] : 0) / w[i];
    if (row >= 0 && !(ratio < least)) continue;
    row = i;
    least = ratio;
  }
  return row;
}

template <int N>
WalkEnd add_to_walk_n(FacetWalk* walk, const std::int32_t* places, int count) {
  constexpr int kPoints = Vec<float>::kPoints;
  const int n = N > 0 ? N : walk->n;
  for (int i = 0; i < count; ++i) keep_lanes(walk, places[i] / kPoints, 1U << places[i] % kPoints, n);
  fill_columns(walk, n);
  alignas(64) float rho[kPoints];
  alignas(64) float shares[kPoints];
  for (int limit = walk->pivots + walk->pivot_limit; walk->pivots < limit; ++walk->pivots) {
    form_costs<N>(walk, n);
    const int e = cheapest_column(*walk);
    if (e < 0) {
      refine_walk<N>(walk, n);
      return WalkEnd::arrived;
    }
    const Sixteen w = multiply<N>(*walk, n, walk->columns + e, walk->stride);
    w.to(shares);
    const int r = blocking_row(*walk, n, shares);
    if (r < 0) return WalkEnd::no_facet;
    for (int k = 0; k < n; ++k) rho[k] = walk->R[k * kPoints + r];
    exchange<N>(walk, n, r, e, rho, w, shares[r]);
  }
  return WalkEnd::too_long;
}

WalkEnd walk_facets(FacetWalk* walk) {
  return with_dimension(walk->n, [=](auto N) { return walk_facets_n<decltype(N)::value>(walk); });
}

WalkEnd add_to_walk(FacetWalk* walk, const std::int32_t* places, int count) {
  return with_dimension(walk->n,
                        [=](auto N) { return add_to_walk_n<decltype(N)::value>(walk, places, count); });
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
