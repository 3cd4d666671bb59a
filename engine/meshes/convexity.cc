// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/meshes/convexity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/sets/hull_3d.h"
#include "raygauge/sets/prepared_set.h"

namespace raygauge {
namespace {

using Vertices = Eigen::Ref<const Eigen::Matrix3Xd>;
using Triangles = std::span<const MeshTriangle>;

struct Corners {
  Vector3 a, b, c;
};

Corners corners_of(const Vertices& vertices, const MeshTriangle& t) {
  return {column(vertices, t[0]), column(vertices, t[1]), column(vertices, t[2])};
}

// Twice the area, as a normal.
Vector3 normal_of(const Corners& t) { return cross(t.b - t.a, t.c - t.a); }

double longest_edge(const Corners& t) {
  return std::max({length(t.b - t.a), length(t.c - t.b), length(t.a - t.c)});
}

// Whether no triangle that is wider than `slack` is deeper inside than that. `side`: -1 of a surface that is
// turned inside out.
bool is_on_hull(const Vertices& vertices, Triangles triangles, double slack, double side) {
  const PreparedSet hull{Eigen::MatrixXd(vertices)};
  for (const MeshTriangle& triangle : triangles) {
    const Corners t = corners_of(vertices, triangle);
    const Vector3 n = normal_of(t) * side;
    const double size = length(n);
    if (!(size > slack * longest_edge(t))) continue;
    const double u[3] = {n.x / size, n.y / size, n.z / size};
    double highest[3];
    const double height = hull.support_unchecked(u, highest);
    if (height - dot(n, t.a + t.b + t.c) / (3 * size) > slack) return false;
  }
  return true;
}

using Point2 = std::pair<double, double>;

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b.first - a.first) * (c.second - a.second) - (b.second - a.second) * (c.first - a.first);
}

// Twice the area of the hull of points in the plane (Andrew's monotone chain).
double twice_hull_area(std::vector<Point2> points) {
  std::sort(points.begin(), points.end());
  double area = 0;
  for (int side = 0; side < 2; ++side) {
    std::vector<Point2> chain;
    for (const Point2& p : points) {
      while (chain.size() > 1 && turn(chain[chain.size() - 2], chain.back(), p) <= 0) chain.pop_back();
      chain.push_back(p);
    }
    for (std::size_t i = 1; i < chain.size(); ++i)
      area += chain[i - 1].first * chain[i].second - chain[i].first * chain[i - 1].second;
    std::reverse(points.begin(), points.end());
  }
  return std::fabs(area);
}

// The unit normal of a plane in which all vertices are, to `slack`; 0: there is none.
Vector3 plane_of(const Vertices& vertices, Triangles triangles, double slack) {
  Vector3 n;
  for (const MeshTriangle& triangle : triangles) {
    const Vector3 m = normal_of(corners_of(vertices, triangle));
    if (dot(m, m) > dot(n, n)) n = m;
  }
  const double size = length(n);
  if (!(size > 0)) return {};
  n = n * (1 / size);
  const double height = dot(n, column(vertices, triangles[0][0]));
  for (Eigen::Index i = 0; i < vertices.cols(); ++i) {
    if (std::fabs(dot(n, column(vertices, static_cast<std::int32_t>(i))) - height) > slack) return {};
  }
  return n;
}

// Whether triangles in the plane across the unit vector n are their hull: each has what the other has.
bool is_hull_in_plane(const Vertices& vertices, Triangles triangles, const Vector3& n) {
  const Vector3 x = any_orthogonal(n), y = cross(n, x);
  std::vector<Point2> points;
  for (Eigen::Index i = 0; i < vertices.cols(); ++i) {
    const Vector3 p = column(vertices, static_cast<std::int32_t>(i)) - column(vertices, 0);
    points.emplace_back(dot(x, p), dot(y, p));
  }
  double up = 0, down = 0;  // a closed sheet has two sides
  for (const MeshTriangle& triangle : triangles) {
    const double area = dot(n, normal_of(corners_of(vertices, triangle)));
    (area > 0 ? up : down) += std::fabs(area);
  }
  const double hull = twice_hull_area(std::move(points));
  return std::max(up, down) >= hull * (1 - kRoundedFile) && std::max(up, down) <= hull * (1 + kRoundedFile);
}

double volume_of_hull(const Vertices& vertices) {
  const Eigen::Vector3d center = vertices.rowwise().mean();
  const Hull3 hull = hull_3d(vertices, center);
  if (!hull.found) return std::numeric_limits<double>::quiet_NaN();
  std::vector<MeshTriangle> triangles(hull.triangles.size() / 3);
  for (std::size_t i = 0; i < hull.triangles.size(); ++i) triangles[i / 3][i % 3] = hull.triangles[i];
  return enclosed_volume(vertices, triangles);
}

bool is_convex(const Vertices& vertices, Triangles triangles, bool closed) {
  const Eigen::Vector3d spread = vertices.rowwise().maxCoeff() - vertices.rowwise().minCoeff();
  const double slack = kRoundedFile * spread.norm();
  const Vector3 n = plane_of(vertices, triangles, slack);
  if (dot(n, n) > 0) return is_hull_in_plane(vertices, triangles, n);
  const double side = enclosed_volume(vertices, triangles) < 0 ? -1 : 1;
  if (!closed || !is_on_hull(vertices, triangles, slack, side)) return false;
  const Eigen::Vector3d center = vertices.rowwise().mean();
  constexpr double kNearWhole = 0.01;
  return std::fabs(winding_number(vertices, triangles, {center[0], center[1], center[2]}) - side) <
         kNearWhole;
}

}  // namespace

double winding_number(const Vertices& vertices, Triangles triangles, const Vector3& p) {
  double angle = 0;
  for (const MeshTriangle& triangle : triangles) {
    const Corners t = corners_of(vertices, triangle);
    const Vector3 a = t.a - p, b = t.b - p, c = t.c - p;
    const double A = length(a), B = length(b), C = length(c);
    angle += std::atan2(dot(a, cross(b, c)), A * B * C + dot(a, b) * C + dot(b, c) * A + dot(c, a) * B);
  }
  return angle / (2 * std::numbers::pi);
}

HullCost hull_cost(const Vertices& vertices, Triangles triangles) {
  HullCost cost;
  cost.volume = cost.hull_volume = std::numeric_limits<double>::quiet_NaN();
  if (triangles.empty()) return cost;
  cost.closed = surface_facts(vertices, triangles).closed();
  cost.convex = is_convex(vertices, triangles, cost.closed);
  if (cost.convex) return cost;
  if (cost.closed) cost.volume = std::fabs(enclosed_volume(vertices, triangles));
  cost.hull_volume = volume_of_hull(vertices);
  return cost;
}

}  // namespace raygauge
