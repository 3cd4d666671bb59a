// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "scene/page/support_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <queue>
#include <utility>

namespace raygauge {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Rounding, as a share of the size of the body: what is nearer to a plane lies in it.
constexpr double kFlat = 1e-9;

struct Facet {
  std::array<int, 3> corner;
  std::array<int, 3> neighbour = {-1, -1, -1};  ///< across the edge from corner k to corner k + 1
  Vector3d normal = Vector3d::Zero();           ///< 0: the corners lie in a line
  Vector3d apex = Vector3d::Zero();             ///< the support point at `normal`
  bool alive = true;
};

/// The convex hull of support points, refined where it is farthest from the body.
class GrowingHull {
 public:
  GrowingHull(const ConvexSet& set, double tolerance) : set_(set) {
    Vector3d low, high;
    for (int k = 0; k < 3; ++k) {
      low[k] = support(-Vector3d::Unit(k))[k];
      high[k] = support(Vector3d::Unit(k))[k];
    }
    size_ = std::max((high - low).norm(), 1e-12 * std::max(1.0, high.norm()));
    gap_ = tolerance * size_;
    if (begin()) return;
    thickness_ = gap_;
    begin();
  }

  void grow(std::size_t most) {
    while (!queue_.empty() && points_.size() < most) {
      const auto [gap, facet] = queue_.top();
      queue_.pop();
      if (facets_[static_cast<std::size_t>(facet)].alive) add(facet);
    }
  }

  SupportMesh mesh() const {
    SupportMesh mesh;
    std::vector<int> number(points_.size(), -1);
    for (const Facet& facet : facets_) {
      if (!facet.alive || facet.normal.isZero()) continue;
      std::array<int, 3> triangle{};
      for (std::size_t k = 0; k < 3; ++k) {
        int& known = number[static_cast<std::size_t>(facet.corner[k])];
        if (known < 0) {
          known = static_cast<int>(mesh.vertices.size());
          mesh.vertices.push_back(points_[static_cast<std::size_t>(facet.corner[k])]);
        }
        triangle[k] = known;
      }
      mesh.triangles.push_back(triangle);
    }
    return mesh;
  }

 private:
  Vector3d support(const Vector3d& u) const {
    Vector3d point;
    set_.support_unchecked(u.data(), point.data());
    return point + thickness_ * u.normalized();
  }

  const Vector3d& point(int number) const { return points_[static_cast<std::size_t>(number)]; }
  Facet& facet(int number) { return facets_[static_cast<std::size_t>(number)]; }

  /// Four points that span space, and their tetrahedron. False for a body that is flat.
  bool begin() {
    points_ = {support(-Vector3d::UnitX()), support(Vector3d::UnitX())};
    for (const Vector3d& axis : {Vector3d(0, 1, 0), Vector3d(0, 0, 1)}) {
      for (const double sign : {-1.0, 1.0}) {
        if ((points_[1] - points_[0]).norm() > kFlat * size_) break;
        points_[static_cast<std::size_t>(sign > 0)] = support(sign * axis);
      }
    }
    const Vector3d along = points_[1] - points_[0];
    if (along.norm() <= kFlat * size_) return false;
    const Vector3d side = along.unitOrthogonal(), other = along.normalized().cross(side);
    const auto from_line = [&](const Vector3d& p) { return along.normalized().cross(p - points_[0]).norm(); };
    points_.push_back(farthest({side, -side, other, -other}, from_line));
    const Vector3d normal = along.cross(points_[2] - points_[0]);
    if (from_line(points_[2]) <= kFlat * size_) return false;
    const auto from_plane = [&](const Vector3d& p) {
      return std::abs(normal.normalized().dot(p - points_[0]));
    };
    points_.push_back(farthest({normal, -normal}, from_plane));
    if (from_plane(points_[3]) <= kFlat * size_) return false;
    if (normal.dot(points_[3] - points_[0]) > 0) std::swap(points_[1], points_[2]);
    facets_ = {Facet{{0, 1, 2}, {1, 2, 3}}, Facet{{1, 0, 3}, {0, 3, 2}}, Facet{{2, 1, 3}, {0, 1, 3}},
               Facet{{0, 2, 3}, {0, 2, 1}}};
    for (int f = 0; f < 4; ++f) measure(f);
    return true;
  }

  template <class Measure>
  Vector3d farthest(const std::vector<Vector3d>& directions, const Measure& measure) const {
    Vector3d best = support(directions.front());
    for (const Vector3d& u : directions) {
      const Vector3d p = support(u);
      if (measure(p) > measure(best)) best = p;
    }
    return best;
  }

  /// Its normal, apex and gap.
  void measure(int number) {
    Facet& f = facet(number);
    const Vector3d a = point(f.corner[0]), b = point(f.corner[1]), c = point(f.corner[2]);
    const Vector3d normal = (b - a).cross(c - a);
    if (normal.norm() <= kFlat * kFlat * size_ * size_) return;
    f.normal = normal.normalized();
    f.apex = support(f.normal);
    const double gap = f.normal.dot(f.apex - a);
    if (gap > gap_) queue_.emplace(gap, number);
  }

  bool sees(const Facet& f, const Vector3d& p) const {
    return f.normal.isZero() || f.normal.dot(p - point(f.corner[0])) > kFlat * size_;
  }

  /// Facets that the apex of `first` sees, from there on.
  std::vector<int> visible_from(int first) {
    const Vector3d apex = facet(first).apex;
    std::vector<int> seen = {first};
    facet(first).alive = false;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      for (const int next : facet(seen[i]).neighbour) {
        if (!facet(next).alive || !sees(facet(next), apex)) continue;
        facet(next).alive = false;
        seen.push_back(next);
      }
    }
    return seen;
  }

  struct Border {
    int to;       ///< the end of the edge
    int outside;  ///< the facet beyond it
  };

  /// Replaces what the apex of a facet sees by a cone over the border of it.
  void add(int first) {
    const std::vector<int> seen = visible_from(first);
    std::map<int, Border> border;  // by the beginning of the edge
    std::size_t edges = 0;
    for (const int number : seen) {
      const Facet& f = facet(number);
      for (std::size_t k = 0; k < 3; ++k) {
        if (!facet(f.neighbour[k]).alive) continue;
        border[f.corner[k]] = {f.corner[(k + 1) % 3], f.neighbour[k]};
        ++edges;
      }
    }
    const bool is_loop = edges == border.size() && edges >= 3 &&
                         std::all_of(border.begin(), border.end(),
                                     [&](const auto& edge) { return border.count(edge.second.to) > 0; });
    if (!is_loop) {  // rounding; the hull stays as it is
      for (const int number : seen) facet(number).alive = true;
      return;
    }
    const int apex = static_cast<int>(points_.size());
    points_.push_back(facet(first).apex);
    close(border, apex);
  }

  void close(const std::map<int, Border>& border, int apex) {
    const int first_new = static_cast<int>(facets_.size());
    std::map<int, int> starting;
    for (const auto& [from, edge] : border) {
      starting[from] = static_cast<int>(facets_.size());
      facets_.push_back({{from, edge.to, apex}, {edge.outside, -1, -1}});
      Facet& beyond = facet(edge.outside);
      for (std::size_t k = 0; k < 3; ++k)
        if (beyond.corner[k] == edge.to) beyond.neighbour[k] = starting[from];
    }
    for (const auto& [from, edge] : border) {
      const int here = starting.at(from), next = starting.at(edge.to);
      facet(here).neighbour[1] = next;
      facet(next).neighbour[2] = here;
    }
    for (int f = first_new; f < static_cast<int>(facets_.size()); ++f) measure(f);
  }

  const ConvexSet& set_;
  double size_ = 0, gap_ = 0, thickness_ = 0;
  std::vector<Vector3d> points_;
  std::vector<Facet> facets_;
  std::priority_queue<std::pair<double, int>> queue_;
};

}  // namespace

SupportMesh support_mesh(const ConvexSet& set, double tolerance, std::size_t most) {
  GrowingHull hull(set, tolerance);
  hull.grow(most);
  return hull.mesh();
}

std::vector<Vector2d> support_polygon(const ConvexSet& set, double tolerance, std::size_t most) {
  const auto support = [&](const Vector2d& u) {
    Vector2d point;
    set.support_unchecked(u.data(), point.data());
    return point;
  };
  std::vector<Vector2d> corners;
  const auto add = [&](const Vector2d& p) {
    const bool known = !corners.empty() && (corners.back() == p || corners.front() == p);
    if (!known) corners.push_back(p);
  };
  for (const Vector2d& u : {Vector2d(1, 0), Vector2d(0, 1), Vector2d(-1, 0), Vector2d(0, -1)})
    add(support(u));
  double size = 0;
  for (const Vector2d& p : corners) size = std::max(size, (p - corners.front()).norm());
  for (std::size_t i = 0; corners.size() >= 2 && i < corners.size() && corners.size() < most;) {
    const Vector2d a = corners[i], along = corners[(i + 1) % corners.size()] - a;
    const Vector2d normal = Vector2d(along.y(), -along.x()).normalized();
    const Vector2d apex = support(normal);
    if (normal.dot(apex - a) > tolerance * size)
      corners.insert(corners.begin() + static_cast<std::ptrdiff_t>(i) + 1, apex);
    else
      ++i;
  }
  return corners;
}

}  // namespace raygauge
