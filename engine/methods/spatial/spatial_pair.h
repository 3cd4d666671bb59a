// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "engine/methods/spatial/core_pair.h"

namespace raygauge {

using SpatialPoint = PairPoint<double>;

/// How the cores of a pair curve, in the first body's frame: the Hessians of their support functions.
class Curvatures {
 public:
  /// The cores, one of them curved, stand there.
  void place(const FirstBodyFrame& frame);

  /// Adds `weight` times the Hessian of the support function of piece `index` of core i at u to H.
  void add(const SpatialShape& shape, int i, const Vector3& u, std::int32_t index, double weight,
           Matrix3& H) const;

  /// Of core i, a curved one: S in CoreCurvature.
  const Matrix3& form(int i) const noexcept { return form_[i]; }

 private:
  Matrix3 axes_[2], form_[2];
};

class SpatialPair;

/// Whether the centres R_1 c_1 + t_1 and R_2 c_2 + t_2 are the same, without a rounding error.
bool share_center(const SpatialPair& pair) noexcept;

/// Two bodies S1 and S2 of R^3 in the frame of the first: what a query asks of  D = S1 - (R S2 + t).
///
/// Rounding errors are covered by one number. Where |x| is at most Z on everything that is computed with, a
/// support point s computed for u is within error() = kRounding Z (and the defects of the poses) of a point
/// of D, and u·s is within |u| error() of h_D(u). The chain from a world pose to s is four products with 3 ×
/// 3 matrices and three sums, each within 8 rounding units of Z; kRounding is twice what that adds up to, and
/// more.
class SpatialPair : public CorePair<FirstBodyFrame> {
 public:
  /// The sets, which must outlive it. False if one of them has no shape, or they live in different spaces.
  bool bind(const ConvexSet& first, const ConvexSet& second, InstructionSet isa);
  /// The shapes of sets of R^n, which must outlive it.
  void bind(const SpatialShape& first, const SpatialShape& second, int n, InstructionSet isa);

  /// Where they are. False if their size is out of the range of squares.
  bool place(const PoseNumbers& first, const PoseNumbers& second);

  /// From now on the first body is scaled about the origin of the world, not about its centre. False unless
  /// that is known to be inside the body: only then a ball inside the other one is inside the difference,
  /// too.
  bool scale_first_about_origin(const ConvexSet& first);

  /// D becomes the prism D + [-1, 1] v, until it is placed anew. Where D is flat and v leads out of its
  /// plane, which holds the origin, the prism holds the same of that plane: it has the same growth distance,
  /// and the origin if D has it. At most three; in R^2 there is one from the beginning.
  void add_prism(const Vector3& v) noexcept { prism_[prisms_++] = v; }
  std::span<const Vector3> prisms() const noexcept { return {prism_, static_cast<std::size_t>(prisms_)}; }

  /// s_D(u): of the cores.
  void support(const Vector3& u, SpatialPoint& point);

  /// The point of D that `corner` names, and the direction that it is about the highest one along.
  Vector3 support_again(const DepthMemory::Corner& corner, SpatialPoint& point);

  /// How support_again() finds `point`, found for u, wherever the bodies are.
  DepthMemory::Corner corner_of(const Vector3& u, const SpatialPoint& point) const;

  /// core_vertex(); false where D is a prism.
  bool vertex(std::int32_t index_1, std::int32_t index_2, SpatialPoint& point) const {
    return prisms_ == 0 && core_vertex(index_1, index_2, point);
  }

  /// Whether neither core has an edge.
  bool is_smooth() const noexcept { return raygauge::is_smooth(shape(0)) && raygauge::is_smooth(shape(1)); }

  /// Whether the cores have vertices, so that a support point is known by two indices.
  bool has_vertices() const noexcept { return !is_curved() && prisms_ == 0; }

  /// The point that the vertices, rims and curved surfaces of `point`'s indices have for u. `followed` is a
  /// point that has followed u before, or null: it may share a rim. Always true, as that of a PrecisePair is
  /// not.
  bool follow(const Vector3& u, SpatialPoint& point, const SpatialPoint* followed = nullptr) const;

  /// Of ellipsoids, balls included: M with M u = s(u) about the centres, the sum of their forms over heights
  /// at u. A polytope counts as the ball inside it. False without an ellipsoid, and beside other cores.
  bool smooth_form(const Vector3& u, Matrix3& M) const;

  /// Adds `weight` times the Hessian of u·s(u) for these pieces of the cores.
  void add_hessian(const Vector3& u, std::int32_t index_1, std::int32_t index_2, double weight,
                   Matrix3& H) const;

  /// The same of core i alone.
  void add_hessian_of(int i, const Vector3& u, std::int32_t index, Matrix3& H) const {
    curvatures_.add(shape(i), i, u, index, 1, H);
  }

  /// Of the bodies and the way between them, at most.
  double size() const noexcept { return size_; }
  const PoseNumbers& pose(int i) const noexcept { return pose_[i]; }

  /// The radius of a ball about the origin inside the difference of the bodies, each about its centre, proven
  /// but for rounding; 0 where none is known.
  double inner_radius() const noexcept {
    return std::max(known_radius_, anchor_radius_ + shape(1).inner_radius);
  }

  /// From now on there is such a ball of this radius, until the bodies are placed anew.
  void set_inner_radius(double radius) noexcept { known_radius_ = radius; }

  /// c_2 - c_1 in the frame of the first body, from the centre of the first to that of the second.
  const Vector3& between_centers() const noexcept { return between_centers_; }

  /// Whether both centres are the same point, without a rounding error.
  bool is_concentric() const noexcept {
    const Vector3& p = between_centers_;
    return std::fabs(p.x) <= error_ && std::fabs(p.y) <= error_ && std::fabs(p.z) <= error_ &&
           share_center(*this);
  }

  /// What a PrecisePair has, too: the pair in doubles, and a vector of the pair's frame in the first body's,
  /// rounded.
  const SpatialPair& in_doubles() const noexcept { return *this; }
  static const Vector3& to_first(const Vector3& vector) noexcept { return vector; }

  int dimension() const noexcept { return frame_.dimension; }

 private:
  static constexpr double kRounding = 256 * 0x1p-53;
  static constexpr int kMostPrisms = 3;

  Curvatures curvatures_;
  PoseNumbers pose_[2];
  Vector3 apart_;  // between the origins of both frames, in the world
  Vector3 between_centers_;
  Vector3 anchor_;  // what the first body is scaled about ...
  double known_radius_ = 0;
  double anchor_radius_ = 0;  // ... and the radius of a ball about it inside that body
  double size_of_shapes_ = 0;
  double size_ = 0;
  Vector3 prism_[kMostPrisms];
  int prisms_ = 0;
};

}  // namespace raygauge
