// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/bodies/arc_depth.h"
#include "engine/methods/bodies/facet_depth.h"
#include "engine/sets/polytope_faces.h"
#include "engine/sets/spatial_shape.h"

namespace raygauge {

/// The depth of the difference D of a frustum F and a polytope P of which all facets are known, a segment or
/// a point. The largest ball about the origin inside D touches it where D has one normal only. That is
///
/// - a normal of a facet of P, or of a disc of F;
/// - or one of F's side, and then h_D has a local minimum there for a corner q of -P: it is against the
///   part of q across the axis;
/// - or across an edge of P, between the normals of the facets beside it: see ArcDepth.
///
/// Else the ball's point is a corner of P with one of a rim or a tip of F, which have more normals than one.
class FrustumDepth : public FacetDepth {
 public:
  /// Body 0 or 1 is the frustum; R and t take points of the second body's frame to the first one's, RᵀR is 1
  /// but for `defect`. `size`: at least |x| for every x of D, and for all that it comes from. `gap`: the
  /// share of the depth that both bounds may differ by. False where nothing is proven, or the origin is
  /// outside.
  bool solve(const SpatialShape& frustum, int body, const PolytopeFaces& other, const Matrix3& R,
             const Vector3& t, double defect, double size, double gap) noexcept;

  /// The point of the first body where it is in contact with the second, moved out along normal(). False
  /// where that is not known: more than one point of both bodies is as high.
  bool find_contact(Vector3& of_first) const noexcept;

  /// Calls use(n) for directions of local minima that are at most `most` from the origin, and maybe others.
  template <class Use>
  void for_near(double most, const Use& use) const {
    for (int i = 0; i < count_; ++i)
      if (near_[i].height <= most) use(to_first(near_[i].normal));
  }

 private:
  static constexpr int kCorners = PolytopeFaces::kCorners, kFacets = PolytopeFaces::kFacets,
                       kEdges = PolytopeFaces::kEdges, kNear = 64;

  struct Near {
    double height = 0;
    Vector3 normal;
  };
  struct Arc {
    double bound = 0;
    int edge = 0;
  };

  bool place(const SpatialShape& frustum, const Matrix3& R, const Vector3& t) noexcept;
  void place_other() noexcept;
  static void measure_facets(const UprightFrustum& frustum, PolytopeFaces& of, double (*point)[kFacets],
                             double* height) noexcept;
  Vector3 to_first(const Vector3& u) const noexcept;
  Vector3 point_in_first(const Vector3& of_frustum) const noexcept;
  bool find_point(Vector3& of_frustum) const noexcept;
  bool find_line(Vector3& of_frustum) const noexcept;
  bool holds(const Vector3& of_frustum, const Vector3& of_other) const noexcept;
  double height_of_corners(const Vector3& u) const noexcept;
  bool take(double height, double lower, const Vector3& u) noexcept;
  bool take_discs() noexcept;
  bool take_side() noexcept;
  bool take_facets() noexcept;
  int list_arcs(Arc* arcs) const noexcept;
  bool take_arc(int edge) noexcept;
  bool take_circle() noexcept;
  bool take_found() noexcept;

  UprightFrustum frustum_;
  Matrix3 basis_;  // of the frustum, its axis last, in its own frame
  Vector3 base_;   // the centre of its base
  Matrix3 R_;
  Vector3 t_;
  int body_ = 0;
  const PolytopeFaces* other_ = nullptr;
  Matrix3 turn_;          // from the frame of P to the basis
  PolytopeFaces placed_;  // with the frustum F - P, in the basis, about the centre of the base: but for edges
  alignas(64) double point_[3][kFacets],
      facet_[kFacets];  // of the frustum, for the normal of a facet; height
  ArcDepth arc_;
  Vector3 at_;  // the normal in the basis
  double height_ = 0, size_ = 0, gap_ = 0, lost_ = 0;
  int count_ = 0;
  Near near_[kNear];
};

}  // namespace raygauge
