// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/polytope_faces.h"

#include <cstddef>

#include "engine/numerics/fused.h"

namespace raygauge {

// Corner i is at the top along axis k if bit k of i is set; facet 2 k is across axis k at the base, facet 2 k
// + 1 at the top. Along axis k an edge is at the base or the top of both other ones.
PolytopeFaces PolytopeFaces::of_box(const Vector3& base, const Vector3& top) noexcept {
  PolytopeFaces box;
  box.corners = 8;
  box.facets = 6;
  box.edges = 12;
  const double side[2][3] = {{base.x, base.y, base.z}, {top.x, top.y, top.z}};
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 8; ++i) box.corner[k][i] = side[i >> k & 1][k];
    double* const across = box.normal[k] + std::ptrdiff_t{2} * k;
    across[0] = -1;
    across[1] = 1;
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    for (int i = 0; i < 4; ++i) {
      const int at = 4 * k + i, of_a = i & 1, of_b = i >> 1;
      box.way[k][at] = side[1][k] - side[0][k];
      box.from[at] = static_cast<std::uint8_t>(of_a << a | of_b << b);
      const int across_a = 2 * a + of_a, across_b = 2 * b + of_b;
      const bool is_along = of_a == of_b;  // the way is that of the product of both normals
      box.left[at] = static_cast<std::uint8_t>(is_along ? across_a : across_b);
      box.right[at] = static_cast<std::uint8_t>(is_along ? across_b : across_a);
    }
  }
  return box;
}

void PolytopeFaces::set_segment(const Vector3& base, const Vector3& top) noexcept {
  const Vector3 along = top - base;
  edges = dot(along, along) > 0 ? 1 : 0;
  corners = 1 + edges;
  facets = 0;
  turned = 0;
  for (int k = 0; k < 3; ++k) {
    corner[k][0] = (&base.x)[k];
    corner[k][1] = (&top.x)[k];
    this->way[k][0] = (&along.x)[k];
  }
}

RAYGAUGE_VECTORS void PolytopeFaces::place_mirrored(const PolytopeFaces& other, const Matrix3& M,
                                                    const Vector3& t) noexcept {
  const Vector3 a = M.column[0], b = M.column[1], c = M.column[2], d = t;
  for (int i = 0; i < kCorners; ++i) {
    const double x = other.corner[0][i], y = other.corner[1][i], z = other.corner[2][i];
    corner[0][i] = -(a.x * x + b.x * y + c.x * z + d.x);
    corner[1][i] = -(a.y * x + b.y * y + c.y * z + d.y);
    corner[2][i] = -(a.z * x + b.z * y + c.z * z + d.z);
  }
  for (int i = 0; i < kFacets; ++i) {
    const double x = other.normal[0][i], y = other.normal[1][i], z = other.normal[2][i];
    normal[0][i] = -(a.x * x + b.x * y + c.x * z);
    normal[1][i] = -(a.y * x + b.y * y + c.y * z);
    normal[2][i] = -(a.z * x + b.z * y + c.z * z);
  }
}

}  // namespace raygauge
