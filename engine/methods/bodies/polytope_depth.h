// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/bodies/facet_depth.h"
#include "engine/sets/polytope_faces.h"

namespace raygauge {

/// The depth of D = P1 - P2 for polytopes of which all facets are known: the least height of a facet of D. A
/// facet of D is across a facet of P1 or P2, or across an edge of each whose arcs on the sphere of normals,
/// from that of one facet beside the edge to that of the other, cross. Where rounding hides whether they do,
/// the edges count: a direction too many does not make the bound wrong.
class PolytopeDepth : public FacetDepth {
 public:
  /// P2 is turned by R, whose RᵀR is 1 but for `defect`, and moved by t. `size`: at least |x| for every x of
  /// D, and for all that it comes from. False where nothing is proven: the origin is outside, or edges are
  /// parallel but for rounding.
  bool solve(const PolytopeFaces& first, const PolytopeFaces& second, const Matrix3& R, const Vector3& t,
             double defect, double size) noexcept;

  /// The point of P1 where it is in contact with P2, moved out along normal(). False where that is not known:
  /// more than one corner is as high.
  bool find_contact(Vector3& of_first) const noexcept;

  /// Calls use(n) for facets that are at most `most` from the origin, and maybe others.
  template <class Use>
  void for_near(double most, const Use& use) const {
    for (int i = 0; i < count_; ++i)
      if (near_[i].height <= most) use(near_[i].normal);
  }

 private:
  static constexpr int kEdges = PolytopeFaces::kEdges, kFacets = PolytopeFaces::kFacets;
  static constexpr int kNear = 64;

  struct Near {
    double height = 0;
    Vector3 normal;
  };

  static void place(const PolytopeFaces& from, const Matrix3& R, const Vector3& t,
                    PolytopeFaces& placed) noexcept;
  /// Of D along the normals of `of`.
  static void measure_heights(const PolytopeFaces& of, const PolytopeFaces& other, double* height) noexcept;
  /// Bit k of number i: whether the arcs of edge i of `of` and edge k of `other` cross, as far as products up
  /// to `hidden` may be 0. Bits of edges that are not there are any.
  static void list_crossings(const PolytopeFaces& of, const PolytopeFaces& other, double hidden,
                             std::uint32_t* crossings) noexcept;
  bool take(double height, double lower, const Vector3& n, int edge_1, int edge_2) noexcept;
  bool take_facets(const PolytopeFaces& of, const PolytopeFaces& other) noexcept;
  bool take_edges(int edge_1, int edge_2) noexcept;
  bool take_all_edges() noexcept;

  const PolytopeFaces* first_ = nullptr;
  PolytopeFaces second_;  // -P2, where it is
  double height_ = 0, size_ = 0;
  int edge_[2] = {-1, -1};
  int count_ = 0;
  Near near_[kNear];
};

}  // namespace raygauge
