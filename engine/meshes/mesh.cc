// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "raygauge/meshes/mesh.h"

#include <cmath>
#include <limits>
#include <string>

#include "engine/meshes/box_tree.h"
#include "engine/meshes/surface.h"
#include "raygauge/exceptions.h"
#include "raygauge/methods/options.h"

namespace raygauge {
namespace {

constexpr double kLargest = 1e30;  // of coordinates in single precision, with room for their sums

void check_vertices(const Eigen::Ref<const Eigen::Matrix3Xd>& vertices) {
  if (vertices.cols() > std::numeric_limits<std::int32_t>::max())
    throw InvalidParameterError("a mesh has at most 2^31 - 1 vertices");
  for (Eigen::Index i = 0; i < vertices.cols(); ++i) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double x = vertices(k, i);
      if (!std::isfinite(x))
        throw NonFiniteError("coordinate " + std::to_string(k) + " of vertex " + std::to_string(i) +
                             " is not a finite number");
      if (std::fabs(x) > kLargest)
        throw InvalidParameterError("coordinate " + std::to_string(k) + " of vertex " + std::to_string(i) +
                                    " is beyond 1e30");
    }
  }
}

void check_threads(int threads) {
  if (threads < 1 || threads > kMostThreads)
    throw InvalidParameterError("threads must lie in [1, " + std::to_string(kMostThreads) + "], got " +
                                std::to_string(threads));
}

void check_triangles(std::span<const MeshTriangle> triangles, Eigen::Index vertices) {
  if (triangles.empty()) throw EmptySetError("a mesh needs at least one triangle");
  if (triangles.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    throw InvalidParameterError("a mesh has at most 2^31 - 1 triangles");
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const std::int32_t corner : triangles[i]) {
      if (corner < 0 || corner >= vertices)
        throw InvalidParameterError("triangle " + std::to_string(i) + " names vertex " +
                                    std::to_string(corner) + "; there are " + std::to_string(vertices) +
                                    ", counted from 0");
    }
  }
}

void check_closed(const SurfaceFacts& facts) {
  if (facts.closed()) return;
  throw InvalidParameterError(
      "a solid needs a closed surface: " + std::to_string(facts.open_edges) +
      (facts.open_edges == 1 ? " edge has" : " edges have") +
      " no triangle on the other side, or one that is turned about, the first at triangle " +
      std::to_string(facts.open_triangle));
}

}  // namespace

Mesh::Mesh(const Eigen::Ref<const Eigen::Matrix3Xd>& vertices, std::span<const MeshTriangle> triangles,
           MeshKind kind, int threads)
    : kind_(kind) {
  check_threads(threads);
  check_vertices(vertices);
  check_triangles(triangles, vertices.cols());
  const SurfaceFacts facts = surface_facts(vertices, triangles);
  if (kind == MeshKind::solid) {
    check_closed(facts);
    volume_ = std::fabs(enclosed_volume(vertices, triangles));
  }
  auto points = std::make_shared<std::vector<Eigen::Vector3d>>();
  for (const std::int32_t i : facts.parts) points->emplace_back(vertices.col(i));
  part_points_ = std::move(points);
  tree_ = std::make_shared<const BoxTree>(vertices, triangles, threads);
}

Mesh Mesh::cloud(const Eigen::Ref<const Eigen::Matrix3Xd>& points, double radius, int threads) {
  check_threads(threads);
  check_vertices(points);
  if (points.cols() == 0) throw EmptySetError("a cloud needs at least one point");
  if (!(radius >= 0 && radius <= kLargest))
    throw InvalidParameterError("the radius of a cloud must lie in [0, 1e30]");
  std::vector<MeshTriangle> triangles;
  triangles.reserve(static_cast<std::size_t>(points.cols()));
  for (std::int32_t i = 0; i < points.cols(); ++i) triangles.push_back({i, i, i});
  Mesh cloud;
  cloud.radius_ = radius;
  cloud.part_points_ = std::make_shared<std::vector<Eigen::Vector3d>>();
  cloud.tree_ = std::make_shared<const BoxTree>(points, triangles, threads);
  return cloud;
}

std::ptrdiff_t Mesh::size() const noexcept { return tree_->size(); }

std::ptrdiff_t Mesh::memory() const noexcept {
  return tree_->memory() +
         static_cast<std::ptrdiff_t>(part_points_->capacity() * sizeof(Eigen::Vector3d) + sizeof(*this));
}

}  // namespace raygauge
