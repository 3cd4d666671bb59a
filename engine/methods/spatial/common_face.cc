// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/common_face.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raygauge {
namespace {

Vector3 unit(const Vector3& v) { return v * (1 / length(v)); }

// Twice the vector area of a polygon (Newell).
Vector3 area_of(const std::vector<Vector3>& points, const FlatPolygon& polygon) {
  Vector3 sum;
  const auto& corners = polygon.corners();
  const auto at = [&](std::size_t k) { return points[static_cast<std::size_t>(corners[k].index)]; };
  for (std::size_t k = 2; k < corners.size(); ++k) sum = sum + cross(at(k - 1) - at(0), at(k) - at(0));
  return sum;
}

}  // namespace

void CommonFace::begin(const Vector3& normal) {
  normal_ = normal;
  for (Side& side : side_) side.points.clear();
  pairs_.clear();
}

void CommonFace::project(Side& side, const Vector3& outward, double noise) {
  side.polygon.clear();
  for (std::size_t i = 0; i < side.points.size(); ++i) {
    const Vector3 p = side.points[i] - origin_;
    side.polygon.add({dot(p, x_), dot(p, y_), static_cast<std::int32_t>(i)});
  }
  side.polygon.make_hull(noise);
  const auto& corners = side.polygon.corners();
  const auto at = [&](std::size_t k) { return side.points[static_cast<std::size_t>(corners[k].index)]; };
  side.normal = outward;
  side.anchor = at(0);
  side.length = 0;
  if (corners.size() == 2) {
    const Vector3 way = at(1) - at(0);
    side.length = raygauge::length(way);
    side.direction = way * (1 / side.length);
    side.normal = unit(outward - side.direction * dot(outward, side.direction));
  } else if (corners.size() > 2) {
    const Vector3 area = area_of(side.points, side.polygon);
    side.area = raygauge::length(area);
    side.normal = area * (1 / side.area) * (dot(area, outward) < 0 ? -1.0 : 1.0);
    side.anchor = {};
    for (const FlatPoint& corner : corners)
      side.anchor = side.anchor + side.points[static_cast<std::size_t>(corner.index)];
    side.anchor = side.anchor * (1 / static_cast<double>(corners.size()));
  }
  side.slope = dot(side.normal, outward);
  side.least = dot(side.normal, at(0));
  for (std::size_t k = 1; k < corners.size(); ++k) side.least = std::min(side.least, dot(side.normal, at(k)));
}

Vector3 CommonFace::lift(const Side& side, const FlatPoint& p) const {
  if (side.polygon.count() == 1) return side.anchor;
  const Vector3 flat = origin_ + x_ * p.x + y_ * p.y;
  if (side.polygon.count() == 2) {
    const double along_x = dot(side.direction, x_), along_y = dot(side.direction, y_);
    const Vector3 from = flat - side.anchor;
    const double share =
        (dot(from, x_) * along_x + dot(from, y_) * along_y) / (along_x * along_x + along_y * along_y);
    return side.anchor + side.direction * std::clamp(share, 0.0, side.length);
  }
  return flat + normal_ * (dot(side.normal, side.anchor - flat) / dot(side.normal, normal_));
}

// The face of the least extent is cut by the other one; of polygons that with more corners, and of
// quadrangles, whose cuts are never too many, the smaller one, which is mostly inside.
bool CommonFace::is_cut(int i) const {
  const Side &one = side_[i], &two = side_[1 - i];
  if (extent(i) != extent(1 - i)) return extent(i) < extent(1 - i);
  const int count = one.polygon.count(), other = two.polygon.count();
  if (count != other || count != 4) return count >= other;
  return one.area <= two.area;
}

bool CommonFace::find(double noise, double beside, double crossing) {
  pairs_.clear();
  if (side_[0].points.empty() || side_[1].points.empty()) return false;
  x_ = any_orthogonal(normal_);
  y_ = cross(normal_, x_);
  origin_ = side_[0].points[0];
  project(side_[0], normal_, noise);
  project(side_[1], -normal_, noise);
  const int small = is_cut(0) ? 0 : 1;
  const FlatPolygon& other = side_[1 - small].polygon;
  const bool segments = extent(0) == 1 && extent(1) == 1;
  for (const double offset : {noise, beside}) {
    offset_ = offset;
    common_ = side_[small].polygon;
    common_.cut(other, offset, segments ? beside : offset);
    if (!common_.is_empty()) break;
  }
  const bool cross_over = segments && sine_of_segments() > crossing;
  common_.merge(cross_over ? std::numeric_limits<double>::infinity() : noise);
  if (cross_over && !common_.is_empty()) common_.move_to_crossing(side_[0].polygon, side_[1].polygon, beside);
  for (const FlatPoint& p : common_.corners())
    pairs_.push_back({lift(side_[0], p), lift(side_[1], p), p.index});
  return !pairs_.empty();
}

bool CommonFace::are_crossing_segments(double crossing) const {
  const std::vector<Vector3>&one = side_[0].points, &two = side_[1].points;
  return one.size() == 2 && two.size() == 2 &&
         are_crossing(normal_, {one[0], one[1]}, {two[0], two[1]}, crossing);
}

bool are_crossing(const Vector3& n, const Vector3 (&one)[2], const Vector3 (&two)[2],
                  double crossing) noexcept {
  constexpr double kWithin = 1 - 1e-5;  // of half of each
  const Vector3 x = one[1] - one[0], y = two[1] - two[0], way = two[0] + two[1] - one[0] - one[1];
  const Vector3 across_x = cross(n, x), across_y = cross(n, y);
  const double area = dot(x, across_y), share_1 = dot(way, across_y), share_2 = dot(way, across_x);
  return area * area > crossing * crossing * dot(x, x) * dot(y, y) &&
         std::fabs(share_1) < kWithin * std::fabs(area) && std::fabs(share_2) < kWithin * std::fabs(area);
}

double CommonFace::sine_of_segments() const {
  return raygauge::length(cross(side_[0].direction, side_[1].direction));
}

bool CommonFace::is_inside_segment(int i, double margin) const {
  const Side& side = side_[i];
  const double along = dot(lift(side, common_.middle()) - side.anchor, side.direction);
  return extent(i) == 1 && along > margin && along < side.length - margin;
}

bool CommonFace::is_crossing(double margin) const {
  if (common_.is_empty()) return false;
  const FlatPoint middle = common_.middle();
  const auto inside = [&](int i) {
    return extent(i) == 2 ? side_[i].polygon.depth_of(middle) > margin : is_inside_segment(i, margin);
  };
  if (extent(0) == 2 && extent(1) == 2) return inside(0) && inside(1);
  if (extent(0) == 2 || extent(1) == 2) return inside(extent(0) == 2 ? 0 : 1);
  constexpr double kParallel = 1e-6;
  return inside(0) && inside(1) && sine_of_segments() > kParallel;
}

}  // namespace raygauge
