// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/nearest_on_simplex.h"

#include <cmath>

#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

template <class Real>
using Points = const BasicVector3<Real>* const*;

template <class Real>
void take(Points<Real> points, int a, const Real& square, SimplexFace<Real>& best) {
  best.count = 1;
  best.corner[0] = a;
  best.weight[0] = Real{1};
  best.v = *points[a];
  best.square = square;
}

template <class Real>
void take_if_nearer(Points<Real> points, int a, SimplexFace<Real>& best) {
  const Real square = dot(*points[a], *points[a]);
  if (best.count == 0 || square < best.square) take<Real>(points, a, square, best);
}

// The nearest point of a segment, if it is nearer than `best`.
template <class Real>
void try_segment(Points<Real> points, int a, int b, SimplexFace<Real>& best) {
  const BasicVector3<Real>& s = *points[a];
  const BasicVector3<Real> edge = *points[b] - s;
  const Real along = -dot(s, edge);
  const Real edge_square = dot(edge, edge);
  if (!(along > Real{0})) return take_if_nearer<Real>(points, a, best);
  if (!(along < edge_square)) return take_if_nearer<Real>(points, b, best);
  const Real t = along / edge_square;
  // From the nearer end, so that a short way is not the difference of two long ones.
  const BasicVector3<Real> v = t < Real{0.5} ? s + edge * t : *points[b] - edge * (Real{1} - t);
  const Real square = dot(v, v);
  if (best.count != 0 && !(square < best.square)) return;
  best.count = 2;
  best.corner[0] = a;
  best.corner[1] = b;
  best.weight[0] = Real{1} - t;
  best.weight[1] = t;
  best.v = v;
  best.square = square;
}

// The nearest point of a triangle, if it is nearer than `best`. It is on an edge that the origin is beyond,
// or inside.
template <class Real>
void try_triangle(Points<Real> points, int ia, int ib, int ic, SimplexFace<Real>& best) {
  const BasicVector3<Real>&a = *points[ia], &b = *points[ib], &c = *points[ic];
  const BasicVector3<Real> n = triangle_normal(a, b, c);
  const Real normal_square = dot(n, n);
  const Real wa = dot(n, cross(b, c)), wb = dot(n, cross(c, a)), wc = dot(n, cross(a, b));
  const bool flat = !(normal_square > Real{0}) || !(wa + wb + wc > Real{0});
  const bool beyond_a = flat || !(wa > Real{0}), beyond_b = flat || !(wb > Real{0}),
             beyond_c = flat || !(wc > Real{0});
  if (beyond_a) try_segment<Real>(points, ib, ic, best);
  if (beyond_b) try_segment<Real>(points, ia, ic, best);
  if (beyond_c) try_segment<Real>(points, ia, ib, best);
  if (beyond_a || beyond_b || beyond_c) return;
  const BasicVector3<Real> v = n * (dot(n, a) / normal_square);
  const Real square = dot(v, v);
  if (best.count != 0 && !(square < best.square)) return;
  const Real share = Real{1} / (wa + wb + wc);
  best.count = 3;
  best.corner[0] = ia;
  best.corner[1] = ib;
  best.corner[2] = ic;
  best.weight[0] = wa * share;
  best.weight[1] = wb * share;
  best.weight[2] = wc * share;
  best.v = v;
  best.square = square;
}

// Corners in ascending order, as in SimplexFace; facet f lies opposite to corner f.
constexpr int kFacets[4][3] = {{1, 2, 3}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};

// A facet f with its normal n: n·x above the facet's plane, for the corner opposite and for the origin.
template <class Real>
struct FacetSide {
  BasicVector3<Real> n;
  Real opposite{}, origin{};

  bool inside() const {
    return (opposite > Real{0} && origin > Real{0}) || (opposite < Real{0} && origin < Real{0});
  }
};

template <class Real>
FacetSide<Real> side_of(Points<Real> points, int f) {
  const BasicVector3<Real>& a = *points[kFacets[f][0]];
  const BasicVector3<Real> n = cross(*points[kFacets[f][1]] - a, *points[kFacets[f][2]] - a);
  return {n, dot(n, *points[f] - a), -dot(n, a)};
}

// The origin is inside all four facets; whether that is certain: n = e x f is off by at most 6 units of
// |e||f|, which in a flat triangle is much of it, and n·x by at most 10 units of |e||f||x|. 16 are allowed
// for.
template <class Real>
bool is_deep(Points<Real> points, const FacetSide<Real>* sides, SimplexFace<Real>& face) {
  const auto size = [](const BasicVector3<Real>& v) { return length_of(v) * (1 + 0x1p-50); };
  Real sum{};
  for (int f = 0; f < 4; ++f) {
    const FacetSide<Real>& side = sides[f];
    const BasicVector3<Real>& a = *points[kFacets[f][0]];
    const BasicVector3<Real> first = *points[kFacets[f][1]] - a, second = *points[kFacets[f][2]] - a;
    const double lost = 16 * kUnitOf<Real> * size(first) * size(second);
    const double certain = std::fabs(high(side.origin)) * (1 - 0x1p-50) - lost * size(a);
    if (!(certain > 0) || !(std::fabs(high(side.opposite)) > lost * size(*points[f] - a))) return false;
    const double away = certain / (size(side.n) + lost) * (1 - 0x1p-50);
    if (f == 0 || away < face.depth) face.depth = away;
    face.corner[f] = f;
    face.weight[f] = side.origin / side.opposite;
    sum = sum + face.weight[f];
  }
  for (Real& weight : face.weight) weight = weight / sum;
  face.count = 4;
  return true;
}

// The nearest point of a simplex is on a facet that the origin is beyond.
template <class Real>
SimplexFace<Real> nearest_of_four(Points<Real> points) {
  FacetSide<Real> sides[4];
  bool inside[4];
  for (int f = 0; f < 4; ++f) {
    sides[f] = side_of<Real>(points, f);
    inside[f] = sides[f].inside();
  }
  const bool all = inside[0] && inside[1] && inside[2] && inside[3];
  SimplexFace<Real> face;
  if (all && is_deep<Real>(points, sides, face)) return face;
  face.depth = 0;
  for (int f = 0; f < 4; ++f) {
    if (all || !inside[f]) try_triangle<Real>(points, kFacets[f][0], kFacets[f][1], kFacets[f][2], face);
  }
  return face;
}

template <class Real>
SimplexFace<Real> nearest_face_of(Points<Real> points, int count) {
  if (count == 4) return nearest_of_four<Real>(points);
  SimplexFace<Real> face;
  if (count == 1) take<Real>(points, 0, dot(*points[0], *points[0]), face);
  if (count == 2) try_segment<Real>(points, 0, 1, face);
  if (count == 3) try_triangle<Real>(points, 0, 1, 2, face);
  return face;
}

}  // namespace

template <>
RAYGAUGE_FUSED SimplexFace<double> nearest_face(const Vector3* const* points, int count) {
  return nearest_face_of<double>(points, count);
}

template <>
RAYGAUGE_FUSED SimplexFace<DoubleDouble> nearest_face(const BasicVector3<DoubleDouble>* const* points,
                                                      int count) {
  return nearest_face_of<DoubleDouble>(points, count);
}

}  // namespace raygauge
