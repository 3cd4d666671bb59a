// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "analysis/studies/wrong_answers/surface_around.h"

#include <algorithm>
#include <array>
#include <map>
#include <queue>
#include <utility>

#include "engine/methods/bodies/inner_polytope.h"

namespace raygauge {
namespace {

using Point = DepthPoint<double>;
constexpr int kMostPoints = 4000;

class Surface {
 public:
  Surface(const ConvexSet& A1, const ConvexSet& A2) : A1_(A1), A2_(A2) {}

  /// Whether all planes come to be more than `depth` from the origin.
  bool grow(double depth) {
    if (!begin()) return false;
    for (int points = 0; points < kMostPoints; ++points) {
      const std::int32_t nearest = take_nearest();
      if (nearest < 0) return false;
      const auto& facet = polytope_.facet(nearest);
      if (facet.offset > depth) return true;
      if (!expand(nearest)) return false;
      note_made();
    }
    return false;
  }

  std::optional<SurfaceAround> result() const {
    SurfaceAround surface;
    std::map<std::int32_t, int> place;
    for (std::int32_t f = 0; f < polytope_.facet_count(); ++f) {
      if (polytope_.facet(f).stamp == 0) continue;
      std::array<int, 3> triangle{};
      for (std::size_t k = 0; k < triangle.size(); ++k) {
        const std::int32_t corner = polytope_.facet(f).corner[k];
        const auto [entry, is_new] = place.try_emplace(corner, static_cast<int>(surface.corners.size()));
        if (is_new && !add_corner(corner, surface)) return std::nullopt;
        triangle[k] = entry->second;
      }
      surface.triangles.push_back(triangle);
    }
    return surface;
  }

 private:
  /// The support point of A2 - A1.
  Point support(const Vector3& u) const {
    const Eigen::Vector3d along(u.x, u.y, u.z), back = -along;
    Eigen::Vector3d a1, a2;
    A1_.support_unchecked(back.data(), a1.data());
    A2_.support_unchecked(along.data(), a2.data());
    const Eigen::Vector3d s = a2 - a1;
    Point point;
    point.s = {s.x(), s.y(), s.z()};
    point.a1 = {a1.x(), a1.y(), a1.z()};
    point.a2 = {a2.x(), a2.y(), a2.z()};
    return point;
  }

  bool begin() {
    // Askew, so that few corners of a regular body are as high.
    const std::array<Vector3, 4> directions = {Vector3{1, 0.9, 1.2}, Vector3{1.1, -1, -0.8},
                                               Vector3{-0.9, 1.1, -1}, Vector3{-1, -0.8, 1.1}};
    std::array<Point, 4> corners;
    double size = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = support(directions[k]);
    for (const Vector3& axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
      for (const double sign : {1.0, -1.0}) {
        const Vector3 u{sign * axis.x, sign * axis.y, sign * axis.z};
        size += std::max(0.0, dot(u, support(u).s));
      }
    }
    if (!polytope_.begin(corners.data(), size)) return false;
    note_made();
    return true;
  }

  /// Adds the support point beyond a facet. Where rounding hides what it sees, many facets of a polytope are
  /// in one plane: directions nearby have other points.
  bool expand(std::int32_t number) {
    constexpr double kAside = 1.0 / 64;
    const Vector3 n = polytope_.facet(number).n;
    for (const Vector3& aside : {Vector3{0, 0, 0}, Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1},
                                 Vector3{-1, 0, 0}, Vector3{0, -1, 0}, Vector3{0, 0, -1}}) {
      const Point beyond = support({n.x + kAside * aside.x, n.y + kAside * aside.y, n.z + kAside * aside.z});
      if (polytope_.above(polytope_.facet(number), beyond.s) > polytope_.noise() &&
          polytope_.look(number, beyond)) {
        polytope_.add(beyond);
        return true;
      }
    }
    return false;
  }

  void note_made() {
    for (const std::int32_t f : polytope_.made())
      nearest_.push({-polytope_.facet(f).offset, {f, polytope_.facet(f).stamp}});
  }

  /// The facet whose plane is the nearest, or below 0.
  std::int32_t take_nearest() {
    while (!nearest_.empty()) {
      const auto [number, stamp] = nearest_.top().second;
      if (polytope_.facet(number).stamp == stamp) return number;
      nearest_.pop();
    }
    return -1;
  }

  bool add_corner(std::int32_t corner, SurfaceAround& surface) const {
    const Point& point = polytope_.point(corner);
    auto first = point_near(A1_, Eigen::Vector3d(point.a1.x, point.a1.y, point.a1.z));
    auto second = point_near(A2_, Eigen::Vector3d(point.a2.x, point.a2.y, point.a2.z));
    if (!first || !second) return false;
    surface.corners.push_back({std::move(*first), std::move(*second)});
    return true;
  }

  const ConvexSet &A1_, &A2_;
  InnerPolytope<double> polytope_;
  std::priority_queue<std::pair<double, std::pair<std::int32_t, std::int64_t>>> nearest_;
};

}  // namespace

std::optional<SurfaceAround> surface_around(const ConvexSet& A1, const ConvexSet& A2, double depth) {
  if (A1.dimension() != 3) return std::nullopt;
  Surface surface(A1, A2);
  if (!surface.grow(depth)) return std::nullopt;
  return surface.result();
}

}  // namespace raygauge
