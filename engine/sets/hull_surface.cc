// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/hull_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/kernels/kernel.h"

namespace raygauge {
namespace {

constexpr double kUnit = 0x1p-53;
constexpr std::size_t kMostTriangles = 8192;         // of more a search looks at fewer
constexpr std::size_t kMostTrianglesWithEdges = 64;  // beyond, a search is as fast
constexpr double kMostTurned = 1e-9;

// Of a height n·x, and of what |n| may differ from 1, relative to the size.
constexpr double kHeight = 24 * kUnit;

// Of a normal from two edges, relative to the product of their lengths; twice what InnerPolytope allows.
constexpr double kEdges = 34 * kUnit, kNormal = 16 * kUnit;

// Whether each edge is there once in either direction.
bool is_closed(const std::vector<int>& triangles) {
  std::vector<std::pair<int, int>> edges, back;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int from = triangles[i + k], to = triangles[i + (k + 1) % 3];
      edges.emplace_back(from, to);
      back.emplace_back(to, from);
    }
  }
  std::sort(edges.begin(), edges.end());
  std::sort(back.begin(), back.end());
  return !edges.empty() && edges == back && std::adjacent_find(edges.begin(), edges.end()) == edges.end();
}

}  // namespace

HullSurface::HullSurface(const Eigen::Ref<const Eigen::Matrix3Xd>& points, const std::vector<int>& triangles,
                         double extent)
    : extent_(extent) {
  const std::size_t count = triangles.size() / 3;
  if (count > kMostTriangles || !is_closed(triangles)) return;
  std::vector<Block> blocks((count + kLanes - 1) / kLanes);
  for (std::size_t i = 0; i < blocks.size() * kLanes; ++i) {
    const auto corner = [&](std::size_t k) {
      const auto v = points.col(triangles[3 * std::min(i, count - 1) + k]);
      return Vector3{v[0], v[1], v[2]};
    };
    const Vector3 a = corner(0), b = corner(1), c = corner(2);
    std::array<Vector3, 3> edge = {b - a, c - b, a - c};
    // The longest one last, in their order around the triangle.
    const auto longest = std::max_element(
        edge.begin(), edge.end(), [](const Vector3& e, const Vector3& f) { return dot(e, e) < dot(f, f); });
    std::rotate(edge.begin(), longest + 1, edge.end());
    const Vector3 across = cross(edge[0], edge[1]);
    const double size = length(across);
    turned_ = std::max(turned_, kEdges * length(edge[0]) * length(edge[1]) / size + kNormal);
    if (!(turned_ < kMostTurned)) return;
    const Vector3 n = across * (1 / size);
    Block& block = blocks[i / kLanes];
    const std::size_t lane = i % kLanes;
    block.x[lane] = n.x;
    block.y[lane] = n.y;
    block.z[lane] = n.z;
    block.low[lane] = std::min({dot(n, a), dot(n, b), dot(n, c)}) - kHeight * extent;
  }
  blocks_ = std::move(blocks);
  if (count <= kMostTrianglesWithEdges) list_edges(points, triangles);
}

void HullSurface::list_edges(const Eigen::Ref<const Eigen::Matrix3Xd>& points,
                             const std::vector<int>& triangles) {
  std::vector<std::array<int, 3>> directed;  // from, to, triangle
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::size_t first = i - i % 3;
    directed.push_back({triangles[i], triangles[first + (i + 1) % 3], static_cast<int>(i / 3)});
  }
  std::sort(directed.begin(), directed.end());
  for (const auto& [from, to, triangle] : directed) {
    if (from > to) continue;
    const auto back = std::lower_bound(directed.begin(), directed.end(), std::array<int, 3>{to, from, 0});
    const auto a = points.col(from), b = points.col(to);
    edges_.push_back({{{a[0], a[1], a[2]}, {b[0], b[1], b[2]}},
                      static_cast<std::size_t>(triangle),
                      static_cast<std::size_t>((*back)[2])});
  }
}

// With both ends of the edge a, b: from the right triangle's end to the left one's, which is e x,
// ((b - a) × (e x + e x))/2.
HullSurface::Side::Side(const HullSurface& hull, const Edge& edge, const Vector3& half) {
  const bool left = dot(hull.normal(edge.left), half) > 0, right = dot(hull.normal(edge.right), half) > 0;
  is_there = left != right;
  if (!is_there) return;
  const Vector3 along = edge.end[1] - edge.end[0], across = cross(along, left ? half : -half);
  const double size = length(across);
  normal = across * (1 / size);
  turned = kEdges * length(along) * length(half) / size + kNormal;
}

// The corners of all that is moved are those of a closed surface: what the triangles and parallelograms leave
// open are ways from one end of the segment to the other, at vertices, and as many lead up as down.
HullSurface::Nearest HullSurface::nearest_of_sum(const Vector3& y, const Vector3& half) const noexcept {
  constexpr double kParallel = 1e-6;
  const double long_half = length(half), reach = 2 * std::sqrt(3.0) * (extent_ + long_half);
  if (edges_.empty() || !(length(y) <= extent_ + long_half)) return {};
  Nearest found;
  found.room = found.second = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < kLanes * blocks_.size(); ++i) {
    const Vector3 n = normal(i);
    const double along = std::fabs(dot(n, half)), room = room_of(i, y) + along;
    if (!(room > 2 * turned_ * reach)) return {};
    found.second = std::min(found.second, std::max(room, found.room));
    if (!(room < found.room)) continue;
    found.room = room;
    found.normal = n;
    found.is_edge = !(along > kParallel * long_half);
  }
  const bool is_parallel = found.is_edge;
  found.is_edge = false;
  for (const Edge& edge : edges_) {
    const Side side(*this, edge, half);
    if (!side.is_there) continue;
    const Vector3 &n = side.normal, a = edge.end[0] - y, b = edge.end[1] - y;
    const double room = std::min(dot(n, a), dot(n, b)) - std::fabs(dot(n, half));
    if (!(room > 2 * side.turned * reach) || !(side.turned < kMostTurned)) return {};
    found.second = std::min(found.second, std::max(room, found.room));
    if (room < found.room) found = {room, n, found.second, true, {edge.end[0], edge.end[1]}};
  }
  if (is_parallel && !found.is_edge) return {};
  found.room -= 2 * kHeight * reach;
  return found;
}

// The side of y on which a triangle is seen counterclockwise is certain where the plane is farther away than
// its normal may be turned, times the way to the triangle.
HullSurface::Nearest HullSurface::nearest(const Vector3& y, InstructionSet isa) const noexcept {
  static_assert(sizeof(Block) == 4 * kLanes * sizeof(double));
  if (blocks_.empty() || !(dot(y, y) <= extent_ * extent_)) return {};
  const double u[4] = {y.x, y.y, y.z, -1};
  std::ptrdiff_t index = 0;
  const double room =
      -kernels_for(isa).price(blocks_.front().x, static_cast<std::ptrdiff_t>(blocks_.size()), 4, u, &index);
  const double reach = 2 * std::sqrt(3.0) * extent_;  // |x - y| and more
  if (!(room > 2 * turned_ * reach)) return {};
  const auto at = static_cast<std::size_t>(index);
  return {room - kHeight * reach, normal(at), 0, false, {}};
}

// False where there are too many to list.
bool HullSurface::list_near(const Vector3& y, double most, InstructionSet isa,
                            Planes& planes) const noexcept {
  const double u[4] = {y.x, y.y, y.z, -1};
  double value[Planes::kMost];
  Collection found{planes.index, value, Planes::kMost, 0, -most - std::fabs(most) * 0x1p-50};
  const double threshold = found.threshold;
  kernels_for(isa).collect(blocks_.front().x, 0, static_cast<std::ptrdiff_t>(blocks_.size()), 4, u, &found);
  planes.count = found.count;
  return found.threshold == threshold && found.count < found.capacity;
}

}  // namespace raygauge
