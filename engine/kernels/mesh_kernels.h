// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
//
// How far apart are pairs of boxes, and pairs of triangles, at least? Several to a vector, in single
// precision. Part of kernel_impl.h.
//
// Boxes. With a_j, b_k the axes of both, d the way between the centres and gap_j = |a_j·d| - h_j -
// Σ_k |a_j·b_k| h_k, no two points are nearer than √Σ max(gap_j, 0)², and likewise of b: the distance of one
// box and a box around the other one. Where all gaps are negative, the largest says how deep they overlap.
//
// Triangles. The way between the nearest of the points that the nine pairs of edges and the six pairs of a
// corner and a face have is a guess v, and nothing depends on how it was found: what is proven is
//
//     distance >= (min_c v·b_c - max_c v·a_c) / |v|
//
// for the corners. Rounding, with u = 2⁻²⁴: corners a are within u, b within 11 u of what they stand for
// (once for themselves, 1.8 and 7 for the turn, 1 for the offset); each product with v/|v|, which is
// longer than 1 by less than 4 u, within 3.2 u, and their difference 2 u: 21 u in all, less than kNoise.
#pragma once

#include "engine/kernels/mesh_lanes.h"
#include "engine/kernels/pack.h"

namespace raygauge::RAYGAUGE_ISA {
namespace {

constexpr float kNoise = 0x1p-18F;
constexpr float kShrunk = 1 - 0x1p-20F;  // for lengths that are off by some units
constexpr float kLeastSquare = 1e-30F;   // of v: with room for the squares of its coordinates
constexpr float kLeastProduct = 1e-34F, kMostProduct = 1e37F;
constexpr float kOfRoundAxes = 1 - 5e-6F;  // for axes that are orthonormal to BoxNode::kAxisError

constexpr int kBoxWidth = 2 * kWidth < BoxLanes::kCount ? 2 * kWidth : BoxLanes::kCount;
typedef float BoxPack __attribute__((vector_size(kBoxWidth * 4), aligned(kBoxWidth * 4), may_alias));
typedef int BoxMask __attribute__((vector_size(kBoxWidth * 4), aligned(kBoxWidth * 4), may_alias));
using FloatPack = Vec<float>::Pack;
using FloatMask = Vec<float>::Index;

template <class V>
inline V rows_at(const float* row) {
  return *reinterpret_cast<const V*>(row);
}
template <class V>
inline V all(float a) {
  return a - V{};
}
template <class V>
inline V larger(V a, V b) {
  return a > b ? a : b;
}
template <class V>
inline V smaller(V a, V b) {
  return a < b ? a : b;
}
inline BoxPack size_of(BoxPack a) {
  return reinterpret_cast<BoxPack>(reinterpret_cast<BoxMask>(a) & (0x7fffffff - BoxMask{}));
}

template <class V>
inline V square_root(V a) {
  for (int lane = 0; lane < static_cast<int>(sizeof(V) / sizeof(float)); ++lane)
    a[lane] = __builtin_sqrtf(a[lane]);
  return a;
}
#if defined(__AVX512F__)
inline FloatPack square_root(FloatPack a) { return _mm512_maskz_sqrt_ps(0xffff, a); }
#endif
#if defined(__AVX2__)
inline BoxPack square_root(BoxPack a) { return _mm256_sqrt_ps(a); }
#endif

#if defined(__AVX2__)
inline unsigned lanes_below(BoxPack a, float b) {
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(a, all<BoxPack>(b), _CMP_NGE_UQ)));
}
#else
inline unsigned lanes_below(BoxPack a, float b) {
  unsigned bits = 0;
  for (int lane = 0; lane < kBoxWidth; ++lane) bits |= static_cast<unsigned>(!(a[lane] >= b)) << lane;
  return bits;
}
#endif

// What two boxes have in common: d the way between their centres along the axes of the single one, and the
// other one's axes along these, also without their signs.
struct BoxGaps {
  BoxPack d[3], half[3], along[3][3], share[3][3];

  BoxGaps(const BoxLanes& boxes, const PlacedBox& box, int at) {
    const auto turned = [&](const BoxLanes::Row* rows, int j) {
      const float* turn = box.turn[j];
      return turn[0] * rows_at<BoxPack>(rows[0] + at) + turn[1] * rows_at<BoxPack>(rows[1] + at) +
             turn[2] * rows_at<BoxPack>(rows[2] + at);
    };
    for (int j = 0; j < 3; ++j) {
      half[j] = rows_at<BoxPack>(boxes.half[j] + at);
      d[j] = turned(boxes.center, j) + box.center[j];
      for (int k = 0; k < 3; ++k) {
        along[j][k] = turned(boxes.axis[k], j);
        share[j][k] = size_of(along[j][k]);
      }
    }
  }
};

inline unsigned bound_boxes_at(const BoxLanes& boxes, const PlacedBox& box, int at, float beyond,
                               float* lower) {
  const BoxGaps gaps(boxes, box, at);
  const BoxPack none{};
  BoxPack square_1{}, square_2{}, largest = all<BoxPack>(-3e38F);
  for (int k = 0; k < 3; ++k) {
    BoxPack gap_1 = size_of(gaps.d[k]) - box.half[k], gap_2{}, wide = gaps.half[k];
    for (int j = 0; j < 3; ++j) {
      gap_1 -= gaps.share[k][j] * gaps.half[j];
      gap_2 += gaps.along[j][k] * gaps.d[j];
      wide += gaps.share[j][k] * box.half[j];
    }
    gap_2 = size_of(gap_2) - wide;
    largest = larger(largest, larger(gap_1, gap_2));
    const BoxPack over_1 = larger(gap_1, none), over_2 = larger(gap_2, none);
    square_1 += over_1 * over_1;
    square_2 += over_2 * over_2;
  }
  const BoxPack apart = square_root(larger(square_1, square_2));
  const BoxPack shrunk = (largest > none ? apart : largest) * kOfRoundAxes;
  *reinterpret_cast<BoxPack*>(lower + at) = shrunk;
  return lanes_below(shrunk, beyond) << at;
}

unsigned bound_boxes(const BoxLanes* boxes, const PlacedBox* box, float beyond, float* lower) {
  unsigned below = 0;
  for (int at = 0; at < BoxLanes::kCount; at += kBoxWidth)
    below |= bound_boxes_at(*boxes, *box, at, beyond, lower);
  return below;
}

struct BoxTriple {
  BoxPack v[3];
};

inline BoxPack dot(const BoxTriple& a, const BoxTriple& b) {
  return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2];
}

// Where all three corners are farther than `beyond` above the box along u: no sum or product of squares that
// is compared has been too large or too small for its precision.
inline BoxMask is_beyond_along(const BoxTriple* corner, const BoxTriple& u, const PlacedBox& box,
                               float beyond) {
  const BoxPack first = dot(corner[0], u), second = dot(corner[1], u), third = dot(corner[2], u);
  const BoxPack low = smaller(smaller(first, second), third), high = larger(larger(first, second), third);
  const BoxPack reach =
      size_of(u.v[0]) * box.half[0] + size_of(u.v[1]) * box.half[1] + size_of(u.v[2]) * box.half[2];
  const BoxPack gap = (larger(low, -high) - reach) * kOfRoundAxes;
  const BoxPack square = dot(u, u), enough = square * (beyond * beyond);
  return (gap > BoxPack{}) & (gap * gap >= enough) & (square > all<BoxPack>(kLeastSquare)) &
         (enough > all<BoxPack>(kLeastProduct)) & (enough < all<BoxPack>(kMostProduct));
}

// The bound is along the axes of the box; whether a triangle is beyond is also asked along the way that these
// gaps are, and across the triangle.
inline unsigned bound_block_at(const TriangleBlock& block, const PlacedBox& box, int at, float beyond,
                               float* lower) {
  const BoxPack none{};
  BoxTriple corner[3] = {}, gap{}, normal{};
  BoxPack largest = all<BoxPack>(-3e38F);
  for (int c = 0; c < 3; ++c) {
    const BoxPack x = rows_at<BoxPack>(block.corner[c][0] + at),
                  y = rows_at<BoxPack>(block.corner[c][1] + at),
                  z = rows_at<BoxPack>(block.corner[c][2] + at);
    for (int j = 0; j < 3; ++j)
      corner[c].v[j] = box.turn[j][0] * x + box.turn[j][1] * y + box.turn[j][2] * z + box.center[j];
  }
  for (int j = 0; j < 3; ++j) {
    const BoxPack low = smaller(smaller(corner[0].v[j], corner[1].v[j]), corner[2].v[j]) - box.half[j];
    const BoxPack high = larger(larger(corner[0].v[j], corner[1].v[j]), corner[2].v[j]) + box.half[j];
    largest = larger(largest, larger(low, -high));
    gap.v[j] = larger(low, none) + smaller(high, none);
  }
  largest *= all<BoxPack>(kOfRoundAxes);
  *reinterpret_cast<BoxPack*>(lower + at) = largest;
  const unsigned below = lanes_below(largest, beyond);
  if (below == 0) return 0;
  for (int j = 0; j < 3; ++j) {
    const int k = (j + 1) % 3, l = (j + 2) % 3;
    normal.v[j] = (corner[1].v[k] - corner[0].v[k]) * (corner[2].v[l] - corner[0].v[l]) -
                  (corner[1].v[l] - corner[0].v[l]) * (corner[2].v[k] - corner[0].v[k]);
  }
  const BoxMask is_beyond =
      is_beyond_along(corner, gap, box, beyond) | is_beyond_along(corner, normal, box, beyond);
  return (below & lanes_below(is_beyond ? all<BoxPack>(1.0F) : none, 0.5F)) << at;
}

unsigned bound_block(const TriangleBlock* block, const PlacedBox* box, float beyond, float* lower) {
  unsigned below = 0;
  for (int at = 0; at < TriangleBlock::kCount; at += kBoxWidth)
    below |= bound_block_at(*block, *box, at, beyond, lower);
  return below;
}

struct FloatTriple {
  FloatPack x, y, z;
};
inline FloatTriple operator+(const FloatTriple& a, const FloatTriple& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline FloatTriple operator-(const FloatTriple& a, const FloatTriple& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline FloatTriple operator*(const FloatTriple& a, FloatPack s) { return {a.x * s, a.y * s, a.z * s}; }
inline FloatPack dot(const FloatTriple& a, const FloatTriple& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline FloatTriple cross(const FloatTriple& a, const FloatTriple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
// NaN becomes 0.
inline FloatPack to_unit(FloatPack a) { return smaller(larger(a, FloatPack{}), all<FloatPack>(1.0F)); }

// The shortest way that has been seen.
struct ShortestWay {
  FloatTriple v{};
  FloatPack square = all<FloatPack>(3e38F);

  void see(const FloatTriple& way, FloatPack its_square, FloatMask valid) {
    const FloatMask better = (its_square < square) & valid;
    square = better ? its_square : square;
    v.x = better ? way.x : v.x;
    v.y = better ? way.y : v.y;
    v.z = better ? way.z : v.z;
  }
};

struct PlacedTriangle {
  FloatTriple corner[3], edge[3];
  FloatPack square[3], inverse[3];  // of the edges' lengths

  void measure() {
    for (int i = 0; i < 3; ++i) {
      edge[i] = corner[(i + 1) % 3] - corner[i];
      square[i] = dot(edge[i], edge[i]);
      inverse[i] = 1.0F / square[i];
    }
  }
};

// Points a + s e and b + t f that are about as near as any.
inline void see_edges(const PlacedTriangle& one, const PlacedTriangle& two, ShortestWay& best) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const FloatTriple &e = one.edge[i], &f = two.edge[j], r = one.corner[i] - two.corner[j];
      const FloatPack ef = dot(e, f), er = dot(e, r), fr = dot(f, r);
      const FloatPack first = (ef * fr - er * two.square[j]) / (one.square[i] * two.square[j] - ef * ef);
      const FloatPack t = to_unit((ef * to_unit(first) + fr) * two.inverse[j]);
      const FloatPack s = to_unit((ef * t - er) * one.inverse[i]);
      const FloatTriple way = f * t - e * s - r;
      const FloatPack square = dot(way, way);
      best.see(way, square, ~FloatMask{});
    }
  }
}

// Corners of `two` above the face of `one`; sign -1: the ways lead to `one`.
inline void see_face(const PlacedTriangle& one, const PlacedTriangle& two, float sign, ShortestWay& best) {
  const FloatTriple n = cross(one.edge[0], one.edge[1]);
  const FloatPack inverse = 1.0F / dot(n, n);
  const FloatTriple inward[3] = {cross(n, one.edge[0]), cross(n, one.edge[1]), cross(n, one.edge[2])};
  for (int j = 0; j < 3; ++j) {
    FloatMask inside = ~FloatMask{};
    for (int i = 0; i < 3; ++i)
      inside = inside & (dot(inward[i], two.corner[j] - one.corner[i]) >= FloatPack{});
    const FloatPack height = dot(n, two.corner[j] - one.corner[0]), share = height * inverse;
    best.see(n * (share * sign), height * share, inside);
  }
}

inline FloatTriple triple_at(const TriangleLanes::Row* rows, int at) {
  return {rows_at<FloatPack>(rows[0] + at), rows_at<FloatPack>(rows[1] + at),
          rows_at<FloatPack>(rows[2] + at)};
}

inline void bound_triangles_at(TriangleLanes* lanes, int at) {
  PlacedTriangle one{}, two{};
  for (int c = 0; c < 3; ++c) {
    one.corner[c] = triple_at(lanes->one[c], at);
    const FloatTriple y = triple_at(lanes->two[c], at);
    const auto placed = [&](int k) {
      const float* turn = lanes->turn[k];
      return turn[0] * y.x + turn[1] * y.y + turn[2] * y.z + rows_at<FloatPack>(lanes->offset[k] + at);
    };
    two.corner[c] = {placed(0), placed(1), placed(2)};
  }
  one.measure();
  two.measure();
  ShortestWay best;
  see_edges(one, two, best);
  see_face(one, two, 1, best);
  see_face(two, one, -1, best);
  const FloatTriple u = best.v * (1.0F / square_root(best.square));
  FloatPack top = dot(u, one.corner[0]), bottom = dot(u, two.corner[0]);
  for (int c = 1; c < 3; ++c) {
    top = larger(top, dot(u, one.corner[c]));
    bottom = smaller(bottom, dot(u, two.corner[c]));
  }
  const FloatPack lower = (bottom - top) * kShrunk - kNoise * rows_at<FloatPack>(lanes->size + at);
  const FloatMask known =
      (best.square > all<FloatPack>(kLeastSquare)) & (best.square < all<FloatPack>(1e30F));
  const FloatPack none{};
  *reinterpret_cast<FloatPack*>(lanes->lower + at) = known ? lower : all<FloatPack>(-3e38F);
  *reinterpret_cast<FloatPack*>(lanes->way[0] + at) = known ? u.x : none;
  *reinterpret_cast<FloatPack*>(lanes->way[1] + at) = known ? u.y : none;
  *reinterpret_cast<FloatPack*>(lanes->way[2] + at) = known ? u.z : none;
}

void bound_triangles(TriangleLanes* lanes, int count) {
  for (int at = 0; at < count; at += 2 * kWidth) bound_triangles_at(lanes, at);
}

}  // namespace
}  // namespace raygauge::RAYGAUGE_ISA
