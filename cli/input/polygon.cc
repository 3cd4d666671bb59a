// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "cli/input/polygon.h"

#include "raygauge/numerics/vector3.h"

namespace raygauge::cli {
namespace {

using Corners = std::span<const std::uint32_t>;

/// A polygon as seen from where its normal points to.
class FlatPolygon {
 public:
  FlatPolygon(const std::vector<Vertex>& vertices, Corners corners) {
    points_.reserve(corners.size());
    for (const std::uint32_t corner : corners) {
      const Vertex& p = vertices[corner];
      points_.push_back({p[0], p[1], p[2]});
    }
    for (std::size_t i = 1; i + 1 < points_.size(); ++i)  // twice the area, by Newell's formula
      normal_ = normal_ + cross(points_[i] - points_[0], points_[i + 1] - points_[0]);
  }

  double turn(std::size_t a, std::size_t b, std::size_t c) const {
    return dot(normal_, cross(points_[b] - points_[a], points_[c] - points_[a]));
  }

  /// Corners that turn to the left all the way, once about.
  bool is_convex() const {
    const std::size_t n = points_.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (turn(i, (i + 1) % n, (i + 2) % n) < 0) return false;
      if (turn(0, i, (i + 1) % n) < 0) return false;
    }
    return true;
  }

  bool holds(std::size_t a, std::size_t b, std::size_t c, std::size_t p) const {
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
  }
  bool same_place(std::size_t a, std::size_t b) const {
    const Vector3 d = points_[a] - points_[b];
    return d.x == 0 && d.y == 0 && d.z == 0;
  }

 private:
  std::vector<Vector3> points_;
  Vector3 normal_;
};

/// Whether the triangle at place `i` of what is left holds no other corner. (Meisters, "Polygons have ears".)
bool is_ear(const FlatPolygon& polygon, const std::vector<std::size_t>& left, std::size_t i) {
  const std::size_t n = left.size(), a = left[(i + n - 1) % n], b = left[i], c = left[(i + 1) % n];
  if (!(polygon.turn(a, b, c) > 0)) return false;
  for (const std::size_t p : left) {
    if (p == a || p == b || p == c || polygon.same_place(p, a) || polygon.same_place(p, c)) continue;
    if (polygon.holds(a, b, c, p)) return false;
  }
  return true;
}

void cut_ears(const FlatPolygon& polygon, Corners corners, std::vector<Triangle>& triangles) {
  std::vector<std::size_t> left(corners.size());
  for (std::size_t i = 0; i < left.size(); ++i) left[i] = i;
  std::size_t at = 0, seen = 0;
  while (left.size() > 3) {
    const std::size_t n = left.size();
    at %= n;
    // Without an ear the polygon crosses itself or is flat: any corner will do.
    if (!is_ear(polygon, left, at) && ++seen <= n) {
      ++at;
      continue;
    }
    seen = 0;
    const auto corner = [&](std::size_t i) { return static_cast<std::int32_t>(corners[left[i % n]]); };
    triangles.push_back({corner(at + n - 1), corner(at), corner(at + 1)});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
  }
  triangles.push_back({static_cast<std::int32_t>(corners[left[0]]),
                       static_cast<std::int32_t>(corners[left[1]]),
                       static_cast<std::int32_t>(corners[left[2]])});
}

}  // namespace

void cut_polygon(const std::vector<Vertex>& vertices, Corners corners, std::vector<Triangle>& triangles) {
  if (corners.size() < 3) return;
  const bool ears = corners.size() > 3 && corners.size() <= kMostEars;
  if (ears) {
    const FlatPolygon polygon(vertices, corners);
    if (!polygon.is_convex()) return cut_ears(polygon, corners, triangles);
  }
  for (std::size_t i = 2; i < corners.size(); ++i)
    triangles.push_back({static_cast<std::int32_t>(corners[0]), static_cast<std::int32_t>(corners[i - 1]),
                         static_cast<std::int32_t>(corners[i])});
}

}  // namespace raygauge::cli
