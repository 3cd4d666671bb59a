// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/nearest_on_simplex.h"

#include <algorithm>

namespace raygauge {
namespace {

// A face of the simplex with the barycentric coordinates of the point of it that is nearest to the origin.
struct Face {
  int count = 0;
  int corner[3];
  double weight[3];
  Vector3 v;
  double square = 0;
};

Face point_face(const SpatialCombination& simplex, int a) {
  const Vector3& s = simplex.point[a].s;
  return {1, {a, 0, 0}, {1, 0, 0}, s, dot(s, s)};
}

Face segment_face(const SpatialCombination& simplex, int a, int b) {
  const Vector3& s = simplex.point[a].s;
  const Vector3 edge = simplex.point[b].s - s;
  const double along = -dot(s, edge);
  const double square = dot(edge, edge);
  if (!(along > 0)) return point_face(simplex, a);
  if (!(along < square)) return point_face(simplex, b);
  const double t = along / square;
  // From the nearer end, so that a short way is not the difference of two long ones.
  const Vector3 v = t < 0.5 ? s + edge * t : simplex.point[b].s - edge * (1 - t);
  return {2, {a, b, 0}, {1 - t, t, 0}, v, dot(v, v)};
}

const Face& nearer(const Face& one, const Face& two) { return two.square < one.square ? two : one; }

// The normal of the triangle from the two shorter of its edges, where cancellation is least.
Vector3 normal_of(const Vector3& a, const Vector3& b, const Vector3& c) {
  const Vector3 ab = b - a, bc = c - b, ca = a - c;
  const double l = dot(ab, ab), m = dot(bc, bc), k = dot(ca, ca);
  if (l >= m && l >= k) return cross(bc, ca);
  return m >= k ? cross(ca, ab) : cross(ab, bc);
}

Face triangle_face(const SpatialCombination& simplex, int ia, int ib, int ic) {
  const Vector3& a = simplex.point[ia].s;
  const Vector3& b = simplex.point[ib].s;
  const Vector3& c = simplex.point[ic].s;
  const Vector3 n = normal_of(a, b, c);
  const double square = dot(n, n);
  const double wa = dot(n, cross(b, c)), wb = dot(n, cross(c, a)), wc = dot(n, cross(a, b));
  const double sum = wa + wb + wc;
  if (square > 0 && wa > 0 && wb > 0 && wc > 0 && sum > 0) {
    const Vector3 v = n * (dot(n, a) / square);
    return {3, {ia, ib, ic}, {wa / sum, wb / sum, wc / sum}, v, dot(v, v)};
  }
  return nearer(nearer(segment_face(simplex, ia, ib), segment_face(simplex, ib, ic)),
                segment_face(simplex, ia, ic));
}

Vector3 reduce(SpatialCombination& simplex, const Face& face) {
  SpatialCombination reduced;
  reduced.count = face.count;
  for (int i = 0; i < face.count; ++i) {
    reduced.point[i] = simplex.point[face.corner[i]];
    reduced.weight[i] = face.weight[i];
  }
  simplex = reduced;
  return face.v;
}

// Whether the origin is on the inner side of all four faces; their nearest distance, and its coordinates.
bool contains_origin(SpatialCombination& simplex, double& depth) {
  constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  double volume[4];
  double sum = 0;
  depth = 0;
  double least = -1;
  for (int f = 0; f < 4; ++f) {
    const Vector3& a = simplex.point[kFaces[f][0]].s;
    const Vector3 n = cross(simplex.point[kFaces[f][1]].s - a, simplex.point[kFaces[f][2]].s - a);
    const double opposite = dot(n, simplex.point[f].s - a);
    const double origin = -dot(n, a);
    const double size = length(n);
    if (!(opposite != 0) || !(size > 0) || origin * opposite <= 0) return false;
    const double away = (origin < 0 ? -origin : origin) / size;
    least = least < 0 ? away : std::min(least, away);
    volume[f] = origin / opposite;
    sum += volume[f];
  }
  for (int f = 0; f < 4; ++f) simplex.weight[f] = volume[f] / sum;
  depth = least;
  return true;
}

}  // namespace

Vector3 nearest_on_simplex(SpatialCombination& simplex, double& depth) {
  depth = 0;
  switch (simplex.count) {
    case 1:
      return reduce(simplex, point_face(simplex, 0));
    case 2:
      return reduce(simplex, segment_face(simplex, 0, 1));
    case 3:
      return reduce(simplex, triangle_face(simplex, 0, 1, 2));
    default:
      break;
  }
  if (contains_origin(simplex, depth)) return {};
  // The last point is new: the nearest face has it, but for rounding.
  const Face face = nearer(nearer(triangle_face(simplex, 3, 0, 1), triangle_face(simplex, 3, 1, 2)),
                           nearer(triangle_face(simplex, 3, 0, 2), triangle_face(simplex, 0, 1, 2)));
  return reduce(simplex, face);
}

}  // namespace raygauge
