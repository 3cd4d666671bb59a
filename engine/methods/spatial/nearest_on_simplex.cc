// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/nearest_on_simplex.h"

#include <cmath>
#include <type_traits>

namespace raygauge {
namespace {

template <class Real>
using Points = const BasicVector3<Real>* const*;

template <class Real>
SimplexFace<Real> point_face(Points<Real> points, int a) {
  SimplexFace<Real> face;
  face.count = 1;
  face.corner[0] = a;
  face.weight[0] = Real{1};
  face.v = *points[a];
  face.square = dot(face.v, face.v);
  return face;
}

template <class Real>
SimplexFace<Real> segment_face(Points<Real> points, int a, int b) {
  const BasicVector3<Real>& s = *points[a];
  const BasicVector3<Real> edge = *points[b] - s;
  const Real along = -dot(s, edge);
  const Real square = dot(edge, edge);
  if (!(along > Real{0})) return point_face<Real>(points, a);
  if (!(along < square)) return point_face<Real>(points, b);
  const Real t = along / square;
  SimplexFace<Real> face;
  face.count = 2;
  face.corner[0] = a;
  face.corner[1] = b;
  face.weight[0] = Real{1} - t;
  face.weight[1] = t;
  // From the nearer end, so that a short way is not the difference of two long ones.
  face.v = t < Real{0.5} ? s + edge * t : *points[b] - edge * (Real{1} - t);
  face.square = dot(face.v, face.v);
  return face;
}

template <class Real>
const SimplexFace<Real>& nearer(const SimplexFace<Real>& one, const SimplexFace<Real>& two) {
  return two.square < one.square ? two : one;
}

template <class Real>
SimplexFace<Real> triangle_face(Points<Real> points, int ia, int ib, int ic) {
  const BasicVector3<Real>&a = *points[ia], &b = *points[ib], &c = *points[ic];
  const BasicVector3<Real> n = triangle_normal(a, b, c);
  const Real square = dot(n, n);
  const Real wa = dot(n, cross(b, c)), wb = dot(n, cross(c, a)), wc = dot(n, cross(a, b));
  const Real sum = wa + wb + wc;
  if (square > Real{0} && wa > Real{0} && wb > Real{0} && wc > Real{0} && sum > Real{0}) {
    SimplexFace<Real> face;
    face.count = 3;
    face.corner[0] = ia;
    face.corner[1] = ib;
    face.corner[2] = ic;
    face.weight[0] = wa / sum;
    face.weight[1] = wb / sum;
    face.weight[2] = wc / sum;
    face.v = n * (dot(n, a) / square);
    face.square = dot(face.v, face.v);
    return face;
  }
  return nearer(nearer(segment_face<Real>(points, ia, ib), segment_face<Real>(points, ib, ic)),
                segment_face<Real>(points, ia, ic));
}

double high(double value) { return value; }
double high(const DoubleDouble& value) { return value.high; }

// What one operation may lose.
template <class Real>
constexpr double kUnit = std::is_same_v<Real, double> ? 0x1p-53 : 0x1p-102;

// Whether the origin is on the inner side of all four facets, for certain: n = e x f is off by at most 6
// units of |e||f|, which in a flat triangle is much of it, and n·x by at most 10 units of |e||f||x|. 16 are
// allowed for.
template <class Real>
bool contains_origin(Points<Real> points, SimplexFace<Real>& face) {
  constexpr int kFacets[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  const auto size = [](const BasicVector3<Real>& v) { return std::sqrt(high(dot(v, v))); };
  Real sum{};
  for (int f = 0; f < 4; ++f) {
    const BasicVector3<Real>& a = *points[kFacets[f][0]];
    const BasicVector3<Real> first = *points[kFacets[f][1]] - a, second = *points[kFacets[f][2]] - a;
    const BasicVector3<Real> n = cross(first, second), rest = *points[f] - a;
    const Real opposite = dot(n, rest);
    const Real origin = -dot(n, a);
    const bool inside = (opposite > Real{0} && origin > Real{0}) || (opposite < Real{0} && origin < Real{0});
    if (!inside) return false;
    const double lost = 16 * kUnit<Real> * size(first) * size(second);
    const double certain = std::fabs(high(origin)) * (1 - 0x1p-50) - lost * size(a);
    if (!(certain > 0) || !(std::fabs(high(opposite)) > lost * size(rest))) return false;
    const double away = certain / (size(n) + lost) * (1 - 0x1p-50);
    if (f == 0 || away < face.depth) face.depth = away;
    face.corner[f] = f;
    face.weight[f] = origin / opposite;
    sum = sum + face.weight[f];
  }
  for (Real& weight : face.weight) weight = weight / sum;
  face.count = 4;
  return true;
}

}  // namespace

template <class Real>
BasicVector3<Real> triangle_normal(const BasicVector3<Real>& a, const BasicVector3<Real>& b,
                                   const BasicVector3<Real>& c) {
  const BasicVector3<Real> ab = b - a, bc = c - b, ca = a - c;
  const Real l = dot(ab, ab), m = dot(bc, bc), k = dot(ca, ca);
  if (l >= m && l >= k) return cross(bc, ca);
  return m >= k ? cross(ca, ab) : cross(ab, bc);
}

template <class Real>
SimplexFace<Real> nearest_face(const BasicVector3<Real>* const* points, int count) {
  switch (count) {
    case 1:
      return point_face<Real>(points, 0);
    case 2:
      return segment_face<Real>(points, 0, 1);
    case 3:
      return triangle_face<Real>(points, 0, 1, 2);
    default:
      break;
  }
  SimplexFace<Real> inside;
  if (contains_origin<Real>(points, inside)) return inside;
  // The last point is new: the nearest face has it, but for rounding.
  return nearer(nearer(triangle_face<Real>(points, 3, 0, 1), triangle_face<Real>(points, 3, 1, 2)),
                nearer(triangle_face<Real>(points, 3, 0, 2), triangle_face<Real>(points, 0, 1, 2)));
}

template Vector3 triangle_normal(const Vector3& a, const Vector3& b, const Vector3& c);
template BasicVector3<DoubleDouble> triangle_normal(const BasicVector3<DoubleDouble>& a,
                                                    const BasicVector3<DoubleDouble>& b,
                                                    const BasicVector3<DoubleDouble>& c);
template SimplexFace<double> nearest_face(const Vector3* const* points, int count);
template SimplexFace<DoubleDouble> nearest_face(const BasicVector3<DoubleDouble>* const* points, int count);

}  // namespace raygauge
