// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "raygauge/numerics/vector3.h"

namespace raygauge {

/// All facets, edges and corners of a convex polytope of R^3 that has few, one to a lane. Every facet of the
/// polytope is among them, and every edge, with the facets beside it.
struct PolytopeFaces {
  static constexpr int kCorners = 16, kFacets = 16, kEdges = 24;

  int corners = 0, facets = 0, edges = 0;
  double turned = 0;  ///< how far a normal, of length 1, may be from the true one
  alignas(64) double corner[3][kCorners] = {};
  alignas(64) double normal[3][kFacets] = {};
  alignas(64) double way[3][kEdges] = {};  ///< from an end of an edge to the other
  std::uint8_t from[kEdges] = {};
  std::uint8_t left[kEdges] = {}, right[kEdges] = {};  ///< facets: normal left × normal right is along `way`

  Vector3 corner_at(int i) const noexcept { return {corner[0][i], corner[1][i], corner[2][i]}; }
  Vector3 normal_at(int i) const noexcept { return {normal[0][i], normal[1][i], normal[2][i]}; }
  Vector3 way_at(int i) const noexcept { return {way[0][i], way[1][i], way[2][i]}; }

  /// The box [base, top].
  static PolytopeFaces of_box(const Vector3& base, const Vector3& top) noexcept;

  /// The corners -(M x + t) and the normals -M n of another polytope: those of its mirror image, for a
  /// rotation M. Edges and numbers stay as they are.
  void place_mirrored(const PolytopeFaces& other, const Matrix3& M, const Vector3& t) noexcept;

  /// The segment [base, top], an edge without facets beside it; where both are the same, one corner.
  void set_segment(const Vector3& base, const Vector3& top) noexcept;
};

}  // namespace raygauge
