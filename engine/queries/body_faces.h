// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "engine/methods/spatial/common_face.h"
#include "engine/methods/spatial/spatial_pair.h"
#include "engine/sets/posed_view.h"

namespace raygauge {

/// What two bodies are scaled by, about the points that they are scaled about.
enum class BodyScaling : std::uint8_t {
  none,
  about_centers,  ///< each about its own
  about_origin,   ///< the first about the origin of the world, the second about its centre
};

/// The faces of two bodies of R^2 or R^3 across a direction, and what they have in common. Bodies with a
/// SpatialShape give theirs in closed form, in the frame of the first body; of all others support mappings
/// find the corners, in the world.
class BodyFaces {
 public:
  /// Sets and poses must outlive the queries. False if the sets live in other spaces, or in different ones.
  bool bind(const Posed& A1, const Posed& A2, InstructionSet isa);

  /// The same of bodies that have been bound and placed, which it copies.
  void bind(const SpatialPair& pair);

  /// The bodies where they are; nullptr where one has no SpatialShape.
  const SpatialPair* pair() const noexcept { return has_shapes_ ? &pair_ : nullptr; }

  /// From now on the faces are those of the bodies scaled by `factor`.
  void scale(BodyScaling scaling, double factor);

  /// The faces are now the points that are at most `margin` below the support planes across `normal`, of
  /// length 1 in the world, which points from A1 to A2.
  void list(const Vector3& normal, double margin);

  /// Their common part, see CommonFace::find. False if there is none.
  bool find(double beside, double crossing) {
    return face_.find(noise_ * std::max(1.0, factor_), beside, crossing);
  }

  /// Of the cores, in the frame of the faces: a point of body i in the world, what its ball adds included.
  CommonFace& face() noexcept { return face_; }
  Vector3 to_world(int i, const Vector3& point) const;

  /// The normal of the last list(), in the frame of the faces.
  const Vector3& normal() const noexcept { return normal_; }

  /// What the balls of both bodies take off the gap between the points of a pair, along normal().
  double ball_gap() const;

  /// A bound, proven: every point of the last find() is within it of its body and of the surface of that.
  double error() const;

  /// What rounding may move a point by; a length that no body is larger than, nor the way between them.
  double noise() const noexcept { return noise_; }
  double size() const noexcept { return size_; }

  /// h_A1(n) + h_A2(-n): how far the bodies overlap along `normal`.
  double overlap(const Vector3& normal) const;

  /// Of body 0: the corners of what is at most `margin` below the highest point along `normal`, of length 1,
  /// in the world. Nothing where it has no SpatialShape.
  void list_top(const Vector3& normal, double margin, std::vector<Vector3>& points) const;

  /// Whether one point of body i is the highest one along `normal` (A1) or its negative (A2), and along what
  /// is tilted from that by `tilt`.
  bool has_one_top(int i, const Vector3& normal, double tilt) const;

  /// How many directions the surface of body i is smooth in, at the highest point of the last find(): 2 of a
  /// ball, 1 of a rim, whose direction is written, 0 of a vertex.
  int smooth_directions(int i, Vector3& direction) const;

 private:
  static constexpr int kSamples = 16;

  void take_pair();
  bool bind_views(const Posed& A1, const Posed& A2);
  void add(int i, const Vector3& x);
  void list_face(int i, double margin);
  void sample(int i, double margin);
  double height(int i, const Vector3& u, Vector3& point) const;
  Vector3 into(int i, const Vector3& outward) const;

  SpatialPair pair_;
  std::optional<InPose> view_[2];  // where a set has no shape
  double width_[2] = {0, 0};
  bool has_shapes_ = false;
  int dimension_ = 3;
  double radius_[2] = {0, 0}, factor_ = 1, noise_ = 0, size_ = 0;
  Vector3 about_[2], normal_;
  CommonFace face_;
};

}  // namespace raygauge
