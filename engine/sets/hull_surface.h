// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/sets/polytope_faces.h"
#include "raygauge/numerics/instruction_set.h"
#include "raygauge/numerics/vector3.h"

namespace raygauge {

/// The surface of the hull of points of R^3, of triangles whose corners are among them. It proves how deep a
/// point y is in the hull without exact convexity, as InnerPolytope does: where the surface is closed and
/// every triangle is seen counterclockwise from y, it winds around y and around every point nearer to y than
/// all of their planes.
class HullSurface {
 public:
  /// A plane that is the nearest to a point.
  struct Nearest {
    double room = 0;  ///< a ball about the point that is inside the hull, rounding errors covered; 0: none is
    Vector3 normal;   ///< outward, of length 1
    double second = 0;     ///< of a sum with a segment: how far the other planes are at least
    bool is_edge = false;  ///< of a sum with a segment: the plane is along an edge of the hull ...
    Vector3 end[2];        ///< ... between these
  };

  /// None.
  HullSurface() = default;

  /// Of points within `extent` of the origin; `triangles` has three indices each, counterclockwise from
  /// outside. None where they are no closed surface, too many, or so thin that rounding hides their planes.
  HullSurface(const Eigen::Ref<const Eigen::Matrix3Xd>& points, const std::vector<int>& triangles,
              double extent);

  bool empty() const noexcept { return blocks_.empty(); }
  std::size_t memory() const noexcept {
    return blocks_.size() * sizeof(Block) + edges_.size() * sizeof(Edge) + corners_.size() * sizeof(Vector3) +
           faces_.size() * sizeof(PolytopeFaces);
  }

  /// nullptr where there are too many, or it is not certain that no two triangles are in a plane.
  const PolytopeFaces* faces() const noexcept { return faces_.empty() ? nullptr : faces_.data(); }

  /// No room where y is outside, or so near the surface that rounding hides the side.
  Nearest nearest(const Vector3& y, InstructionSet isa) const noexcept;

  /// The same of the hull plus the segment from -half to half: its surface is that of the hull, each triangle
  /// moved to the end that is farther out, and parallelograms along the edges between triangles that are not
  /// moved to the same end. No room either where the segment is parallel to the plane.
  Nearest nearest_of_sum(const Vector3& y, const Vector3& half) const noexcept;

  /// Calls use(normal) for every plane that is at most `most` from y.
  template <class Use>
  void for_near(const Vector3& y, double most, InstructionSet isa, const Use& use) const {
    Planes near;
    if (!list_near(y, most, isa, near)) return for_near_of_sum(y, {}, most, use);
    for (std::ptrdiff_t i = 0; i < near.count; ++i) use(normal(static_cast<std::size_t>(near.index[i])));
  }

  /// The same of the sum with a segment.
  template <class Use>
  void for_near_of_sum(const Vector3& y, const Vector3& half, double most, const Use& use) const {
    for (std::size_t i = 0; i < kLanes * blocks_.size(); ++i) {
      const Vector3 n = normal(i);
      if (room_of(i, y) + std::fabs(dot(n, half)) <= most) use(n);
    }
    for (const Edge& edge : edges_) {
      const bool left = dot(normal(edge.left), half) > 0;
      if (left == (dot(normal(edge.right), half) > 0)) continue;
      const Vector3 &a = corners_[edge.end[0]], way = corners_[edge.end[1]] - a;
      const Vector3 across = cross(way, left ? half : -half), n = across * (1 / length(across));
      if (dot(n, a - y) <= most) use(n);
    }
  }

 private:
  static constexpr std::size_t kLanes = 8;

  /// Planes n·x = low, at most as high as the corners, in PointSet's layout: as points (n, low) of R^4. Lanes
  /// behind the last triangle repeat it.
  struct alignas(64) Block {
    double x[kLanes], y[kLanes], z[kLanes], low[kLanes];

    Vector3 normal(std::size_t lane) const noexcept { return {x[lane], y[lane], z[lane]}; }
  };

  /// From corner end[0] to end[1] counterclockwise around triangle `left`, the other way around `right`.
  struct Edge {
    std::uint16_t end[2], left, right;
  };

  /// Of all planes i in lane i % kLanes: the least room about a point, the second, and which plane that is.
  struct alignas(64) LeastLanes {
    double room[kLanes], second[kLanes], index[kLanes];
  };

  /// Parallelograms of edges and a segment, one to a lane.
  struct alignas(64) SideLanes {
    /// `way`: from an end to the other, in the order of the corners, and half the segment, as seen from
    /// outside.
    double end[3][kLanes] = {}, way[3][kLanes] = {};
    /// Out; `turned`: how far a normal may be from the true one.
    double normal[3][kLanes], room[kLanes], turned[kLanes];
  };

  struct Planes {
    static constexpr int kMost = 16;
    std::int64_t index[kMost];
    std::ptrdiff_t count = 0;
  };

  bool list_near(const Vector3& y, double most, InstructionSet isa, Planes& planes) const noexcept;
  Vector3 normal(std::size_t i) const noexcept { return blocks_[i / kLanes].normal(i % kLanes); }
  double room_of(std::size_t i, const Vector3& y) const noexcept {
    return blocks_[i / kLanes].low[i % kLanes] - dot(normal(i), y);
  }
  static void measure_planes(const Block* blocks, std::size_t count, const Vector3& y, const Vector3& half,
                             std::int64_t* up, LeastLanes& least) noexcept;
  static void measure_sides(const Vector3& y, const Vector3& half, SideLanes& lanes) noexcept;
  bool take_sides(const Vector3& y, const Vector3& half, const std::int64_t* up, double reach,
                  Nearest& found) const noexcept;
  void list_faces(const std::vector<int>& triangles);
  void list_edges(const Eigen::Ref<const Eigen::Matrix3Xd>& points, const std::vector<int>& triangles);

  std::vector<Block> blocks_;
  std::vector<Edge> edges_;  // none of large hulls
  std::vector<Vector3> corners_;
  std::vector<PolytopeFaces> faces_;  // one or none
  double extent_ = 0;
  double turned_ = 0;  // how far a normal may be from that of its triangle
};

}  // namespace raygauge
