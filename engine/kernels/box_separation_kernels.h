// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// Several pairs of boxes to a vector. Part of kernel_impl.h; rounding as in separation_kernels.h.
//
// With a_i, b_j the generators of both boxes, the facets of Z = Σ [-1, 1] a_i + Σ [-1, 1] b_j are across
// cross products n of two generators. Where Σ |n·g_k| < |n·p| for one of these 15 axes, the boxes are apart
// (S. Gottschalk, M. C. Lin & D. Manocha, OBBTree, 1996); where Σ |n·g_k| > |n·p| for all of them, p is in Z,
// and they meet. This needs no orthogonality, so that defects of R do not matter.
//
// Edges that are parallel, a_i and b_j with |a_i × b_j| <= ε |a_i||b_j|, ε = 2⁻²⁹, have no such axis that
// rounding leaves. Let Z' be Z with b_j replaced by its part along a_i, for all such pairs; it is within ε S
// of Z. A facet of Z' is across an axis of Z that is not of such a pair, or its normal is within 2.1 ε
// |b_j||b_l| of b_j × b_l. Where Σ |n·g_k| - |n·p| > κ S |g||h| for all axes n = g×h but those of such pairs,
// p is deeper than (κ - 4 ε) S in Z', so that it is in Z for κ = 2⁻²⁰. Half edges below 2⁻⁶⁰ S are not asked
// about: nothing underflows in the others.
#pragma once

#include "engine/kernels/separation_kernels.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

constexpr double kParallel = 0x1p-30;  // of a coefficient of a_i along b_k; twice that is ε
constexpr double kDeep = 0x1p-20;      // κ
constexpr double kThin = 0x1p-60;

// The products of three generators that all axes share: with A_0 = a_1 × a_2 and so on,
//     across_one[i][j] = A_i·b_j,  across_two[j][i] = B_j·a_i.
struct BoxPair {
  BoxPair(const SeparationLanes& lanes, int at) : placed(lanes, at) {
    for (int i = 0; i < 3; ++i) {
      const Pack h1 = lanes_at(lanes.half[0][i], at), h2 = lanes_at(lanes.half[1][i], at);
      a[i] = lanes_at(lanes.rotation[0] + 3 * i, at) * h1;
      b[i] = lanes_at(lanes.rotation[1] + 3 * i, at) * h2;
      size_one[i] = h1;
      size_two[i] = h2;
    }
    for (int i = 0; i < 3; ++i) {
      normal_one[i] = cross(a[(i + 1) % 3], a[(i + 2) % 3]);
      normal_two[i] = cross(b[(i + 1) % 3], b[(i + 2) % 3]);
    }
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        across_one[i][j] = magnitude(dot(normal_one[i], b[j]));
        across_two[i][j] = magnitude(dot(normal_two[i], a[j]));
      }
    }
  }

  Placed placed;
  Triple a[3], b[3], normal_one[3], normal_two[3];
  Pack size_one[3], size_two[3];
  Pack across_one[3][3], across_two[3][3];
};

// Axes in turn. The normal is the first that proves the boxes apart, whatever other lanes look at.
template <bool kNormals>
class AxisSearch {
 public:
  explicit AxisSearch(Pack error) : error_(error) {}

  // n·p is `along`, Σ |n·g_k| `height`, and |g||h| `scale` for n = g×h, which is made where it is needed.
  template <class Normal>
  void look(Pack height, Pack along, Pack scale, const Normal& normal) {
    const Pack margin = height - magnitude(along), error = error_ * scale + broadcast(kSmallest);
    const Pack beyond = -margin - error;
    if constexpr (kNormals) {
      const Triple n = normal();
      const auto first = (beyond > Pack{}) & (beyond_ <= Pack{});
      const auto back = along < Pack{};
      normal_.x = first ? (back ? -n.x : n.x) : normal_.x;
      normal_.y = first ? (back ? -n.y : n.y) : normal_.y;
      normal_.z = first ? (back ? -n.z : n.z) : normal_.z;
    }
    beyond_ = maximum(beyond, beyond_);
    least_ = minimum(margin - error, least_);
    margin_[looked_++] = margin;
  }

  unsigned are_apart() const { return lanes_above(beyond_, 0.0); }
  unsigned do_meet() const { return lanes_above(least_, 0.0); }
  const Triple& normal() const { return normal_; }
  Pack margin(int axis) const { return margin_[axis]; }

 private:
  Pack error_;
  Pack beyond_ = broadcast(-1.0);
  Pack least_ = broadcast(kInfinity);
  Triple normal_{};
  Pack margin_[15];
  int looked_ = 0;
};

template <bool kNormals>
inline void look_across_faces(const BoxPair& pair, AxisSearch<kNormals>& search) {
  for (int i = 0; i < 3; ++i) {
    const Triple& n = pair.normal_one[i];
    const Pack* other = pair.across_one[i];
    search.look(magnitude(dot(n, pair.a[i])) + (other[0] + other[1] + other[2]), dot(n, pair.placed.p),
                pair.size_one[(i + 1) % 3] * pair.size_one[(i + 2) % 3], [&] { return n; });
  }
  for (int j = 0; j < 3; ++j) {
    const Triple& n = pair.normal_two[j];
    const Pack* other = pair.across_two[j];
    search.look(magnitude(dot(n, pair.b[j])) + (other[0] + other[1] + other[2]), dot(n, pair.placed.p),
                pair.size_two[(j + 1) % 3] * pair.size_two[(j + 2) % 3], [&] { return n; });
  }
}

// |(a_i × b_j)·a_k| = |A_m·b_j| for the third index m; likewise of b_k.
template <bool kNormals>
inline void look_across_edges(const BoxPair& pair, AxisSearch<kNormals>& search) {
  for (int j = 0; j < 3; ++j) {
    const Triple turned = cross(pair.b[j], pair.placed.p);
    for (int i = 0; i < 3; ++i) {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const Pack height = (pair.across_one[i1][j] + pair.across_one[i2][j]) +
                          (pair.across_two[j1][i] + pair.across_two[j2][i]);
      search.look(height, dot(pair.a[i], turned), pair.size_one[i] * pair.size_two[j],
                  [&] { return cross(pair.a[i], pair.b[j]); });
    }
  }
}

// The lanes that meet by the second argument above. a_i = Σ α_k b_k, |α_k| = |B_k·a_i| / |det b|, so that
// |a_i × b_j| <= Σ_{k≠j} |α_k||b_k||b_j|.
template <bool kNormals>
inline unsigned meet_with_parallel_edges(const BoxPair& pair, const AxisSearch<kNormals>& search) {
  const Pack deep = broadcast(kDeep) * pair.placed.size, thin = broadcast(kThin) * pair.placed.size;
  const Pack *one = pair.size_one, *two = pair.size_two;
  Pack least = broadcast(kInfinity);
  for (int i = 0; i < 3; ++i) {
    const int i1 = (i + 1) % 3, i2 = (i + 2) % 3;
    least = minimum(least, search.margin(i) - deep * (one[i1] * one[i2]));
    least = minimum(least, search.margin(3 + i) - deep * (two[i1] * two[i2]));
    least = minimum(least, minimum(one[i], two[i]) - thin);
  }
  const Pack volume = broadcast(kParallel) * (two[0] * two[1] * two[2]);
  for (int j = 0; j < 3; ++j) {
    const int j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    for (int i = 0; i < 3; ++i) {
      const Pack largest = maximum(pair.across_two[j1][i] * two[j1], pair.across_two[j2][i] * two[j2]);
      const Pack margin = search.margin(6 + 3 * j + i) - deep * (one[i] * two[j]);
      least = minimum(least, maximum(volume * one[i] - largest, margin));
    }
  }
  return lanes_above(least, 0.0);
}

template <bool kNormals>
inline void separate_boxes_at(SeparationLanes* lanes, int at) {
  constexpr unsigned kAll = (1U << kWidth) - 1;
  const BoxPair pair(*lanes, at);
  AxisSearch<kNormals> search(pair.placed.error);
  look_across_faces(pair, search);
  unsigned do_meet = 0;
  if ((search.are_apart() & kAll) != kAll) {
    look_across_edges(pair, search);
    do_meet = search.do_meet();
    if (((search.are_apart() | do_meet) & kAll) != kAll)
      do_meet |= meet_with_parallel_edges(pair, search) & ~search.are_apart();
  }
  note(lanes, at, search.are_apart() & pair.placed.in_range, do_meet & pair.placed.in_range);
  if constexpr (kNormals) note_normal(lanes, at, search.normal());
}

void separate_boxes(SeparationLanes* lanes) {
  lanes->are_apart = lanes->do_meet = 0;
  for (int at = 0; at < kLanes; at += kWidth) {
    if (lanes->with_normals) {
      separate_boxes_at<true>(lanes, at);
    } else {
      separate_boxes_at<false>(lanes, at);
    }
  }
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
