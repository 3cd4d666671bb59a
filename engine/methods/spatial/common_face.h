// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/methods/spatial/flat_polygon.h"
#include "raygauge/numerics/vector3.h"

namespace raygauge {

/// A point of the first body and the one of the second that is above it, along a normal.
struct FacePair {
  Vector3 point_1, point_2;
  std::int32_t index = -1;  ///< see FlatPoint
};

/// Whether two segments, seen along n, cross well within, at an angle whose sine is above `crossing`.
bool are_crossing(const Vector3& n, const Vector3 (&one)[2], const Vector3 (&two)[2],
                  double crossing) noexcept;

/// What the faces of two bodies have in common where they are seen along a normal n of length 1, which points
/// from the first to the second. Each face is given by points whose hull it is; it may be a polygon, a
/// segment or a point. Both are projected along n, cut with each other, and the corners of what is left are
/// lifted back to both: to the plane of a polygon, to the line of a segment.
class CommonFace {
 public:
  /// Begins with empty faces.
  void begin(const Vector3& normal);

  void add(int i, const Vector3& x) { side_[i].points.push_back(x); }

  /// Whether one of the faces is a single point that was added.
  bool has_vertex() const noexcept { return side_[0].points.size() == 1 || side_[1].points.size() == 1; }

  /// `noise`: what rounding may move a point by. `beside`: how far beside each other two faces may be that
  /// have nothing in common otherwise, and that segments may be in any case, unless the sine of the angle
  /// between them is above `crossing`: those have one point in common. False, and there are no pairs, where
  /// faces are farther apart.
  bool find(double noise, double beside, double crossing);

  /// Whether both faces are segments of two points that were added, the sine of the angle between which is
  /// above `crossing`, and cross well within: then they have one point in common, without a find().
  bool are_crossing_segments(double crossing) const;

  /// The corners, in order.
  std::vector<FacePair>& pairs() noexcept { return pairs_; }
  int pairs_count() const noexcept { return static_cast<int>(pairs_.size()); }

  /// 0: a point, 1: a segment, 2: a polygon.
  int extent(int i) const noexcept { return side_[i].polygon.count() < 3 ? side_[i].polygon.count() - 1 : 2; }

  /// The outward normal of face i, of length 1: of the polygon's plane, across the segment, n or -n for a
  /// point.
  const Vector3& normal(int i) const noexcept { return side_[i].normal; }

  /// The least height of a point of face i along its normal, and the share of n that is along it.
  double least_height(int i) const noexcept { return side_[i].least; }
  double slope(int i) const noexcept { return side_[i].slope; }

  /// Of a segment: its direction, of length 1.
  const Vector3& direction(int i) const noexcept { return side_[i].direction; }

  /// How far beside a polygon a point of pairs() may be.
  double offset() const noexcept { return offset_; }

  /// Whether no line of the plane separates the faces, but by less than `margin`: two polygons overlap, a
  /// segment or a point leads through the inside of a polygon, or segments cross.
  bool is_crossing(double margin) const;

  /// Whether face i is a segment, and the middle of what is in common is farther than that from its ends.
  bool is_inside_segment(int i, double margin) const;

 private:
  struct Side {
    std::vector<Vector3> points;
    FlatPolygon polygon;
    Vector3 normal, anchor, direction;
    double length = 0, area = 0, least = 0, slope = 1;
  };

  void project(Side& side, const Vector3& outward, double noise);
  bool is_cut(int i) const;
  double sine_of_segments() const;
  Vector3 lift(const Side& side, const FlatPoint& p) const;

  Side side_[2];
  Vector3 normal_, x_, y_, origin_;
  double offset_ = 0;
  FlatPolygon common_;
  std::vector<FacePair> pairs_;
};

}  // namespace raygauge
