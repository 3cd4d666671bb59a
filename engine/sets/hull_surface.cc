// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/sets/hull_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/kernels/kernel.h"
#include "engine/numerics/fused.h"

namespace raygauge {
namespace {

constexpr double kUnit = 0x1p-53;
constexpr std::size_t kMostTriangles = 8192;          // of more a search looks at fewer
constexpr std::size_t kMostTrianglesWithEdges = 512;  // beyond, a search is as fast
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
  std::vector<int> corners = triangles;
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  for (const int i : corners) corners_.push_back({points(0, i), points(1, i), points(2, i)});
  const auto number = [&corners](int i) {
    return static_cast<std::uint16_t>(std::lower_bound(corners.begin(), corners.end(), i) - corners.begin());
  };
  std::vector<std::array<int, 3>> directed;  // from, to, triangle
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const std::size_t first = i - i % 3;
    directed.push_back({triangles[i], triangles[first + (i + 1) % 3], static_cast<int>(i / 3)});
  }
  std::sort(directed.begin(), directed.end());
  for (const auto& [from, to, triangle] : directed) {
    if (from > to) continue;
    const auto back = std::lower_bound(directed.begin(), directed.end(), std::array<int, 3>{to, from, 0});
    edges_.push_back({{number(from), number(to)},
                      static_cast<std::uint16_t>(triangle),
                      static_cast<std::uint16_t>((*back)[2])});
  }
  list_faces(triangles);
}

// Where all other corners are below the planes of all triangles for certain, each triangle is a facet, and a
// closed surface of facets is that of the hull.
void HullSurface::list_faces(const std::vector<int>& triangles) {
  constexpr auto kFacets = std::size_t{PolytopeFaces::kFacets};
  if (triangles.size() > 3 * kFacets || corners_.size() > PolytopeFaces::kCorners ||
      edges_.size() > PolytopeFaces::kEdges)
    return;
  PolytopeFaces faces;
  const double margin = 8 * (turned_ + kHeight) * extent_;
  for (std::size_t i = 0; i < triangles.size() / 3; ++i) {
    const Vector3 n = normal(i);
    int below = 0;
    for (const Vector3& corner : corners_)
      below += dot(n, corner) < blocks_[i / kLanes].low[i % kLanes] - margin;
    if (below + 3 != static_cast<int>(corners_.size())) return;
    for (int k = 0; k < 3; ++k) faces.normal[k][i] = (&n.x)[k];
  }
  for (std::size_t i = 0; i < corners_.size(); ++i)
    for (int k = 0; k < 3; ++k) faces.corner[k][i] = (&corners_[i].x)[k];
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Vector3 way = corners_[edges_[i].end[1]] - corners_[edges_[i].end[0]];
    for (int k = 0; k < 3; ++k) faces.way[k][i] = (&way.x)[k];
    faces.from[i] = static_cast<std::uint8_t>(edges_[i].end[0]);
    faces.left[i] = static_cast<std::uint8_t>(edges_[i].left);
    faces.right[i] = static_cast<std::uint8_t>(edges_[i].right);
  }
  faces.corners = static_cast<int>(corners_.size());
  faces.facets = static_cast<int>(triangles.size() / 3);
  faces.edges = static_cast<int>(edges_.size());
  faces.turned = turned_;
  faces_.push_back(faces);
}

// Of each lane the least room and the second; up[i] is -1 where n_i·half > 0, else 0.
RAYGAUGE_VECTORS void HullSurface::measure_planes(const Block* blocks, std::size_t count, const Vector3& y,
                                                  const Vector3& half, std::int64_t* up,
                                                  LeastLanes& least) noexcept {
  using Pack [[gnu::vector_size(sizeof(double) * kLanes), gnu::may_alias]] = double;
  using Mask [[gnu::vector_size(sizeof(double) * kLanes), gnu::may_alias]] = std::int64_t;
  Pack room = Pack{} + std::numeric_limits<double>::infinity(), second = room, index{};
  for (std::size_t i = 0; i < count; ++i) {
    const auto row = [](const double* x) { return *reinterpret_cast<const Pack*>(x); };
    const Pack nx = row(blocks[i].x), ny = row(blocks[i].y), nz = row(blocks[i].z);
    const Pack of_half = nx * half.x + ny * half.y + nz * half.z;
    const Pack here =
        row(blocks[i].low) - (nx * y.x + ny * y.y + nz * y.z) + (of_half < 0.0 ? -of_half : of_half);
    *reinterpret_cast<Mask*>(up + kLanes * i) = of_half > 0.0;
    const Pack higher = here > room ? here : room;
    second = higher < second ? higher : second;
    index = here < room ? Pack{} + static_cast<double>(kLanes * i) : index;
    room = here < room ? here : room;
  }
  *reinterpret_cast<Pack*>(least.room) = room;
  *reinterpret_cast<Pack*>(least.second) = second;
  *reinterpret_cast<Pack*>(least.index) = index;
}

RAYGAUGE_VECTORS void HullSurface::measure_sides(const Vector3& y, const Vector3& half,
                                                 SideLanes& lanes) noexcept {
  const Vector3 center = y, up = half;
  const double of_half = dot(up, up);
  for (std::size_t i = 0; i < kLanes; ++i) {
    const Vector3 way{lanes.way[0][i], lanes.way[1][i], lanes.way[2][i]};
    const Vector3 a = Vector3{lanes.end[0][i], lanes.end[1][i], lanes.end[2][i]} - center, b = a + way;
    const Vector3 across = cross(way, up);
    const double scale = 1 / std::sqrt(dot(across, across));
    const Vector3 n = across * scale;
    const double of_a = dot(n, a), of_b = dot(n, b);
    lanes.normal[0][i] = n.x;
    lanes.normal[1][i] = n.y;
    lanes.normal[2][i] = n.z;
    lanes.room[i] = (of_a < of_b ? of_a : of_b) - std::fabs(dot(n, up));
    lanes.turned[i] = kEdges * std::sqrt(dot(way, way) * of_half) * scale + kNormal;
  }
}

// With both ends of the edge a, b: from the right triangle's end to the left one's, which is e x,
// ((b - a) × (e x + e x))/2. False where it is not certain on which side a parallelogram is.
bool HullSurface::take_sides(const Vector3& y, const Vector3& half, const std::int64_t* up, double reach,
                             Nearest& found) const noexcept {
  std::uint16_t there[3 * kMostTrianglesWithEdges / 2 + 1];
  std::size_t count = 0;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    there[count] = static_cast<std::uint16_t>(i);
    count += (up[edges_[i].left] ^ up[edges_[i].right]) & 1;
  }
  SideLanes sides;
  for (std::size_t first = 0; first < count; first += kLanes) {
    const std::size_t used = std::min(kLanes, count - first);
    for (std::size_t lane = 0; lane < used; ++lane) {
      const Edge& edge = edges_[there[first + lane]];
      const int from = up[edge.left] != 0 ? 0 : 1;
      const Vector3 &a = corners_[edge.end[from]], way = corners_[edge.end[1 - from]] - a;
      for (int k = 0; k < 3; ++k) {
        sides.end[k][lane] = (&a.x)[k];
        sides.way[k][lane] = (&way.x)[k];
      }
    }
    measure_sides(y, half, sides);
    for (std::size_t lane = 0; lane < used; ++lane) {
      const double room = sides.room[lane], turned = sides.turned[lane];
      if (!(room > 2 * turned * reach) || !(turned < kMostTurned)) return false;
      found.second = std::min(found.second, std::max(room, found.room));
      if (!(room < found.room)) continue;
      const Edge& edge = edges_[there[first + lane]];
      const Vector3 n{sides.normal[0][lane], sides.normal[1][lane], sides.normal[2][lane]};
      found = {room, n, found.second, true, {corners_[edge.end[0]], corners_[edge.end[1]]}};
    }
  }
  return true;
}

// The corners of all that is moved are those of a closed surface: what the triangles and parallelograms leave
// open are ways from one end of the segment to the other, at vertices, and as many lead up as down.
HullSurface::Nearest HullSurface::nearest_of_sum(const Vector3& y, const Vector3& half) const noexcept {
  constexpr double kParallel = 1e-6;
  const double long_half = length(half), reach = 2 * std::sqrt(3.0) * (extent_ + long_half);
  if (edges_.empty() || !(length(y) <= extent_ + long_half)) return {};
  alignas(64) std::int64_t up[kMostTrianglesWithEdges];
  LeastLanes least{};
  measure_planes(blocks_.data(), blocks_.size(), y, half, up, least);
  Nearest found;
  found.room = found.second = std::numeric_limits<double>::infinity();
  std::size_t at = 0;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const double room = least.room[lane];
    found.second = std::min({found.second, least.second[lane], std::max(room, found.room)});
    if (!(room < found.room)) continue;
    found.room = room;
    at = static_cast<std::size_t>(least.index[lane]) + lane;
  }
  if (!(found.room > 2 * turned_ * reach)) return {};
  found.normal = normal(at);
  const bool is_parallel = !(std::fabs(dot(found.normal, half)) > kParallel * long_half);
  if (!take_sides(y, half, up, reach, found)) return {};
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
