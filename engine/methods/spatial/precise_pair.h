// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include "engine/methods/spatial/spatial_pair.h"

namespace raygauge {

using PrecisePoint = PairPoint<DoubleDouble>;

/// The pair of a SpatialPair once more,  D = (R1 S1 + t1) - (R2 S2 + t2)  for the very numbers of the poses,
/// in double-double arithmetic: what is computed here of points and heights is within error() of the truth,
/// 2⁻⁸⁸ times the size of the bodies and of the way between them.
class PrecisePair : public CorePair<WorldFrame> {
 public:
  /// The pair in doubles, which must outlive this one. False where the numbers are too large or too small to
  /// be split in two.
  bool bind(const SpatialPair& pair);

  const SpatialPair& in_doubles() const noexcept { return *spatial_; }

  /// A vector of the world in the first body's frame, rounded, and one of that frame in the world.
  Vector3 to_first(const PreciseVector3& vector) const;
  Vector3 to_world(const Vector3& vector) const;

  /// The support point of the cores for u, and h(u) of the bodies, their balls included.
  PrecisePoint support(const PreciseVector3& u, DoubleDouble& height);

  /// The same, but s is left to place(): h(u), and the parts of the point.
  DoubleDouble support_parts(const PreciseVector3& u, PrecisePoint& point);

  /// h(u) alone.
  DoubleDouble height(const PreciseVector3& u);

  /// s of x1 and x2; vertices are doubles.
  void place(PrecisePoint& point) const;

  /// At least |v + b|, where b is the sum of the points of both balls that are highest for u, the direction
  /// of the last support point: for u = -v/|v| an upper bound on the distance, but for error().
  double length_beyond_balls(const PreciseVector3& v, const PreciseVector3& u) const;

  /// The point that the vertices, rims and curved surfaces of `point`'s indices have for u; a ball has its
  /// centre whatever its index. False, and nothing is changed, where u is so near the axis of a rim that this
  /// says nothing, and where an index names no vertex of a core that has nothing else. `followed` is a point
  /// that has followed u before, or null: it may share a rim.
  bool follow(const PreciseVector3& u, PrecisePoint& point, const PrecisePoint* followed = nullptr) const;

  /// The contact on disc `index` of core i, a frustum: u its normal, pointing from the first body to the
  /// second, the point of the disc below the other body's support point, and h(u). False where that is
  /// outside.
  bool disc_contact(int i, std::int32_t index, PreciseVector3& u, DoubleDouble& height, PrecisePoint& point);

  /// Of the pair of a point (a ball's centre) and a core with area that has a formula (Core::nearest): the
  /// nearest points, the better the nearer `point` was. False for other pairs.
  bool project(PrecisePoint& point) const;

  /// As that of every pair.
  bool overlap(const PreciseVector3& u, const PrecisePoint& point) const;

  /// From the centre of the first body to that of the second.
  PreciseVector3 between_centers() const;

  /// The normal for which two ellipsoids with about the axes of the bodies would touch after a growth along
  /// p: M⁻¹p for the sum M of their L Lᵀ. Zero where a body is made of points.
  PreciseVector3 rough_normal(const PreciseVector3& p) const;

  /// The difference of two vertices; false where there are none.
  bool vertex(std::int32_t index_1, std::int32_t index_2, PrecisePoint& point) const;

  /// What the balls of both bodies add to a support point of the cores for u.
  PreciseVector3 ball_points(const PreciseVector3& u) const;

  /// The point of D that is reached from v, a point of the cores, by going back along it through both balls.
  PreciseVector3 through_balls(const PreciseVector3& v) const;

  /// Whether the balls of both bodies about a pair of points of the cores, at most `away` from each other,
  /// are sure to meet.
  bool balls_meet(double away) const;

 private:
  template <bool kPoints>
  DoubleDouble height_of(const PreciseVector3& u, PrecisePoint& point);
  void add_axes(int i, PreciseVector3* M) const;

  const SpatialPair* spatial_ = nullptr;
  DoubleDouble ball_height_;  // what the balls added to the last height
};

/// Bounds on the distance of the bodies, rounding errors outward: from above by the length of a vector of D,
/// or what is left of v, a point of the difference of the cores; from below by u and h(u).
inline double upper_bound(const PrecisePair& pair, double length) noexcept {
  constexpr double kUp = 1 + 0x1p-50;
  return (length + pair.error()) * kUp;
}
inline double upper_bound(const PrecisePair& pair, const PreciseVector3& v) {
  return upper_bound(pair, length(rounded(pair.through_balls(v))));
}
inline double lower_bound(const PrecisePair& pair, const PreciseVector3& u, const DoubleDouble& height) {
  constexpr double kUp = 1 + 0x1p-50, kDown = 1 - 0x1p-50;  // of rounding to doubles, and a length of them
  return (-height.rounded() / (length(rounded(u)) * kUp)) * kDown - pair.error();
}

}  // namespace raygauge
