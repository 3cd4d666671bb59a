// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/bodies/facet_lanes.h"

#include <cmath>

#include "engine/methods/bodies/facet_rounding.h"
#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

// Branches would be guessed wrong as often as right; lanes choose.
inline Vector3 chosen(bool first, const Vector3& a, const Vector3& b) {
  return {first ? a.x : b.x, first ? a.y : b.y, first ? a.z : b.z};
}
inline double least_of(double a, double b) { return a < b ? a : b; }
inline double most_of(double a, double b) { return a > b ? a : b; }

// Lane i of what is measured, for the triangle a b c.
// The heights n·a are those of the normal before it has been divided by its length: that they need not wait
// for the length makes up a third of the time. They lose three rounding units of three products, one of the
// quotient, and one where n itself is rounded: fewer than kFacetProduct.
[[gnu::always_inline]] inline void measure(double size, const Vector3& a, const Vector3& b, const Vector3& c,
                                           int i, FacetLanes& lanes) {
  const Vector3 ab = b - a, bc = c - b, ca = a - c;
  const double of_ab = dot(ab, ab), of_bc = dot(bc, bc), of_ca = dot(ca, ca);
  // The two shorter edges: bc and ca, ca and ab, or ab and bc.
  const bool is_ab = of_ab >= most_of(of_bc, of_ca), is_bc = of_bc >= of_ca;
  const Vector3 first = chosen(is_ab, bc, chosen(is_bc, ca, ab)),
                second = chosen(is_ab, ca, chosen(is_bc, ab, bc));
  const double edges = (is_ab ? of_bc : is_bc ? of_ca : of_ab) * (is_ab ? of_ca : is_bc ? of_ab : of_bc);
  const Vector3 across = cross(first, second);
  const double length = std::sqrt(dot(across, across)), inverse = 1 / length;
  const double scale = length > 0 ? inverse : 0.0;
  const Vector3 n = across * scale;
  const double of_a = dot(across, a), of_b = dot(across, b), of_c = dot(across, c);
  const double least = least_of(least_of(of_a, of_b), of_c) * scale;
  const double offset = least - kFacetProduct<double> * size - std::fabs(least) * 0x1p-52;
  const double needed = (kFacetEdges<double> * std::sqrt(edges) * scale + kFacetProduct<double>)*size;
  const bool is_certain = (length > kLeastFacetNormal) & (least > needed);
  lanes.n[0][i] = n.x;
  lanes.n[1][i] = n.y;
  lanes.n[2][i] = n.z;
  lanes.reach[i] = most_of(most_of(of_a, of_b), of_c) * scale;
  lanes.offset[i] = is_certain ? offset : least_of(offset, 0);
}

}  // namespace

RAYGAUGE_VECTORS void measure_facets(double size, FacetLanes& lanes) {
  for (int i = 0; i < FacetLanes::kCount; ++i) {
    const auto corner = [&](int c) {
      return Vector3{lanes.corner[c][0][i], lanes.corner[c][1][i], lanes.corner[c][2][i]};
    };
    measure(size, corner(0), corner(1), corner(2), i, lanes);
  }
}

// The corners get into vectors without a way over memory: a vector that is read where its numbers have just
// been written one by one waits until all that is before is done.
RAYGAUGE_VECTORS void measure_fan_of_facets(double size, const Vector3* const* corner, const Vector3& apex,
                                            FacetLanes& lanes) {
  using Pack [[gnu::vector_size(sizeof(FacetLanes::Row)), gnu::may_alias]] = double;
  alignas(64) FacetLanes::Row of[2][3];
  for (int end = 0; end < 2; ++end) {
    const Vector3* const* const p = corner + end;
    const Vector3 *const a = p[0], *const b = p[1], *const c = p[2], *const d = p[3], *const e = p[4],
                         *const f = p[5], *const g = p[6], *const h = p[7];
    *reinterpret_cast<Pack*>(of[end][0]) = Pack{a->x, b->x, c->x, d->x, e->x, f->x, g->x, h->x};
    *reinterpret_cast<Pack*>(of[end][1]) = Pack{a->y, b->y, c->y, d->y, e->y, f->y, g->y, h->y};
    *reinterpret_cast<Pack*>(of[end][2]) = Pack{a->z, b->z, c->z, d->z, e->z, f->z, g->z, h->z};
  }
  const Vector3 top = apex;
  for (int i = 0; i < FacetLanes::kCount; ++i)
    measure(size, {of[0][0][i], of[0][1][i], of[0][2][i]}, {of[1][0][i], of[1][1][i], of[1][2][i]}, top, i,
            lanes);
}

}  // namespace raygauge
