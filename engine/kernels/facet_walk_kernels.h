// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// The simplex over a list of points, from facet to facet, in single precision. Part of kernel_impl.h.
#pragma once

#include "engine/kernels/walk_refinement.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

// 1 in row r.
inline Sixteen unit(int r) {
  alignas(64) static constexpr float kUnit[32] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  Sixteen e;
  for (int t = 0; t < kPacksPerBlock; ++t)
    e.part[t] = *reinterpret_cast<const FloatsAnywhere*>(kUnit + 15 - r + t * Vec<float>::kCount);
  return e;
}

// A walk between two basis changes.
struct WalkStep {
  FacetWalk* walk = nullptr;
  int row = -1;        // that leaves
  int entering = -1;   // the column
  float step = 0;      // of the reduced costs, not yet taken
  float negative = 0;  // x_i that count are below it
  float least = 0;     // and so are α
  alignas(64) float rho[16] = {};
  Sixteen squares;  // ‖R_i‖²
};

// The known facet whose plane b is farthest beyond.
template <int N>
inline void begin_at_facet(const FacetList& known, int dimension, FacetWalk* walk) {
  const int n = N > 0 ? N : dimension;
  constexpr int kPoints = Vec<float>::kPoints;
  const LaneMaxima<float> maxima =
      pass_over<N>(known.normals, (known.count + kPoints - 1) / kPoints, n, walk->target);
  const std::ptrdiff_t first = maxima.first_of(maxima.best());
  const std::ptrdiff_t best = first < known.count ? first : known.count - 1;
  const float* from = known.inverses + best * (n + 1) * kPoints;
  for (int k = 0; k < n; ++k) Sixteen::at(from + k * kPoints).to(walk->R + k * kPoints);
  Sixteen::at(from + n * kPoints).to(walk->y);
  for (int i = 0; i < n; ++i) walk->id[i] = known.ids[best * n + i];
}

template <int N>
inline void begin_steps(int dimension, int columns, WalkStep* s) {
  const int n = N > 0 ? N : dimension;
  FacetWalk* walk = s->walk;
  fill_columns<N>(walk, n, columns);
  form_costs<N>(walk, n, columns);
  const Sixteen x = multiply<N>(*walk, n, walk->target, 1);
  x.to(walk->x);
  float sum = 0;
  for (int i = 0; i < n; ++i) sum += __builtin_fabsf(walk->x[i]);
  s->negative = -kRoundedShare * sum;
  for (int k = 0; k < n; ++k) {
    const Sixteen R = Sixteen::at(walk->R + k * Vec<float>::kPoints);
    s->squares.add_products(R, R);
  }
}

// The dual steepest edge: of the negative x_i the one with the largest x_i² / ‖R_i‖². False if there is none.
inline bool choose_row(WalkStep* s) {
  const Sixteen x = Sixteen::at(s->walk->x);
  Sixteen score;
  for (int t = 0; t < kPacksPerBlock; ++t) {
    const FloatPack squared = x.part[t] * x.part[t] / s->squares.part[t];
    score.part[t] = x.part[t] < broadcast(s->negative) ? squared : FloatPack{};
  }
  const float best = score.largest();
  s->row = best > 0 ? lowest_bit(score.equal(best)) : -1;
  return s->row >= 0;
}

// False where no column bounds the step.
template <int N>
inline bool choose_column(int dimension, int blocks, WalkStep* s) {
  const int n = N > 0 ? N : dimension;
  alignas(64) float squares[16];
  s->squares.to(squares);
  for (int k = 0; k < n; ++k) s->rho[k] = s->walk->R[k * Vec<float>::kPoints + s->row];
  s->least = -kLeastAlong * __builtin_sqrtf(squares[s->row]);
  s->entering = entering_column<N>(s->walk, n, blocks, s->rho, s->step, s->least);
  return s->entering >= 0;
}

// Basic column `row` becomes column `entering`, w = R p.
template <int N>
inline void exchange(int dimension, const Sixteen& column, float pivot, WalkStep* s) {
  const int n = N > 0 ? N : dimension;
  constexpr int kPoints = Vec<float>::kPoints;
  FacetWalk* walk = s->walk;
  const float inverse = 1 / pivot;
  Sixteen w = column;
  w.add(-1, unit(s->row));
  s->step = walk->cost[s->entering] * inverse;
  Sixteen y = Sixteen::at(walk->y);
  y.add(s->step, Sixteen::at(s->rho));
  y.to(walk->y);
  Sixteen even, odd;
  for (int k = 0; k < n; ++k) {
    Sixteen R = Sixteen::at(walk->R + k * kPoints);
    R.add(-s->rho[k] * inverse, w);
    R.to(walk->R + k * kPoints);
    (k % 2 == 0 ? even : odd).add_products(R, R);
  }
  for (int t = 0; t < kPacksPerBlock; ++t) s->squares.part[t] = even.part[t] + odd.part[t];
  Sixteen x = Sixteen::at(walk->x);
  x.add(-walk->x[s->row] * inverse, w);
  x.to(walk->x);
  walk->id[s->row] = walk->place[s->entering];
  ++walk->pivots;
}

// False where rounding is in the way.
template <int N>
inline bool enter_column(int n, WalkStep* s) {
  alignas(64) float shares[16];
  const Sixteen w = multiply<N>(*s->walk, n, s->walk->columns + s->entering, s->walk->stride);
  w.to(shares);
  if (!(shares[s->row] < s->least)) return false;
  exchange<N>(n, w, shares[s->row], s);
  return true;
}

// Of the walks those for which `go_on` holds; the others end as `end`.
template <class F>
inline int keep_walks(WalkStep** steps, int count, WalkEnd end, F go_on) {
  int kept = 0;
  for (int i = 0; i < count; ++i) {
    WalkStep* s = steps[i];
    if (go_on(s)) {
      steps[kept++] = s;
    } else {
      s->walk->end = end;
    }
  }
  return kept;
}

template <int N>
void walk_facets_n(const FacetWalkPoints& points, FacetWalk* const* walks, int count) {
  const int n = N > 0 ? N : points.n;
  WalkStep all[kWalksTogether];
  WalkStep* active[kWalksTogether];
  int columns = 0;
  for (int i = 0; i < count; ++i) {
    walks[i]->pivots = 0;
    all[i].walk = walks[i];
    active[i] = &all[i];
    begin_at_facet<N>(points.known, n, walks[i]);
  }
  choose_columns<N>(points, n, walks, count);
  for (int i = 0; i < count; ++i) {
    columns = walks[i]->chosen > columns ? walks[i]->chosen : columns;
  }
  columns = whole_blocks(columns);
  for (int i = 0; i < count; ++i) begin_steps<N>(n, columns, &all[i]);
  int left = count;
  while (left > 0) {
    left = keep_walks(active, left, WalkEnd::arrived, choose_row);
    left = keep_walks(active, left, WalkEnd::no_facet,
                      [=](WalkStep* s) { return choose_column<N>(n, columns / Vec<float>::kPoints, s); });
    left = keep_walks(active, left, WalkEnd::no_facet, [=](WalkStep* s) { return enter_column<N>(n, s); });
    left = keep_walks(active, left, WalkEnd::too_long,
                      [&](WalkStep* s) { return s->walk->pivots < points.pivot_limit; });
  }
  for (int i = 0; i < count; ++i) {
    if (walks[i]->end == WalkEnd::arrived) refine_walk<N>(points, n, walks[i]);
  }
}

// The column with the least d, where it is below -kSlack / 4; else -1.
inline int cheapest_column(const FacetWalk& walk) {
  constexpr int kPoints = Vec<float>::kPoints;
  LaneMaxima<float> gains;
  for (int b = 0; b * kPoints < walk.chosen; ++b) {
    Sixteen gain = Sixteen::at(walk.cost + b * kPoints);
    for (FloatPack& part : gain.part) part = -part;
    gains.take(gain.part, Vec<float>::Index{} + b);
  }
  const float best = gains.best();
  return best > kSlack / 4 ? static_cast<int>(gains.first_of(best)) : -1;
}

// The row with the least x_i / w_i of those with w_i > 0; -1 if there is none.
inline int blocking_row(const FacetWalk& walk, const Sixteen& w) {
  const Sixteen x = Sixteen::at(walk.x);
  Sixteen score;
  for (int t = 0; t < kPacksPerBlock; ++t) {
    const FloatPack ratio = maximum(x.part[t], FloatPack{}) / w.part[t];
    score.part[t] = w.part[t] > broadcast(kLeastAlong) ? -ratio : FloatPack{} - static_cast<float>(kInfinity);
  }
  const float best = score.largest();
  return best > -static_cast<float>(kInfinity) ? lowest_bit(score.equal(best)) : -1;
}

inline void add_column(const FacetWalkPoints& points, std::int32_t place, int n, FacetWalk* walk) {
  const double* point = points.points + static_cast<std::ptrdiff_t>(points.order[place]) * 16;
  float* to = walk->columns + walk->chosen;
  for (int k = 0; k < n; ++k)
    to[static_cast<std::ptrdiff_t>(k) * walk->stride] = static_cast<float>(point[k]);
  walk->place[walk->chosen++] = place;
}

template <int N>
WalkEnd add_to_walk_n(const FacetWalkPoints& points, FacetWalk* walk, const std::int32_t* places, int count) {
  constexpr int kPoints = Vec<float>::kPoints;
  const int n = N > 0 ? N : points.n;
  for (int i = 0; i < count; ++i) add_column(points, places[i], n, walk);
  const int columns = whole_blocks(walk->chosen);
  fill_columns<N>(walk, n, columns);
  WalkStep s;
  s.walk = walk;
  alignas(64) float shares[kPoints];
  for (const int limit = walk->pivots + points.pivot_limit; walk->pivots < limit;) {
    form_costs<N>(walk, n, columns);
    s.entering = cheapest_column(*walk);
    if (s.entering < 0) {
      refine_walk<N>(points, n, walk);
      return WalkEnd::arrived;
    }
    const Sixteen w = multiply<N>(*walk, n, walk->columns + s.entering, walk->stride);
    w.to(shares);
    s.row = blocking_row(*walk, w);
    if (s.row < 0) return WalkEnd::no_facet;
    for (int k = 0; k < n; ++k) s.rho[k] = walk->R[k * kPoints + s.row];
    exchange<N>(n, w, shares[s.row], &s);
  }
  return WalkEnd::too_long;
}

void walk_facets(const FacetWalkPoints* points, FacetWalk* const* walks, int count) {
  with_dimension(points->n, [=](auto N) { walk_facets_n<decltype(N)::value>(*points, walks, count); });
}

void add_to_walk(const FacetWalkPoints* points, FacetWalk* walk, const std::int32_t* places, int count) {
  walk->end = with_dimension(
      points->n, [=](auto N) { return add_to_walk_n<decltype(N)::value>(*points, walk, places, count); });
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
