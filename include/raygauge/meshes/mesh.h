// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "raygauge/sets/convex_set.h"
#include "raygauge/sets/pose.h"

namespace raygauge {

class BoxTree;

/// Three vertices of a mesh, by number from 0 on; of a solid counterclockwise as seen from outside.
using MeshTriangle = std::array<std::int32_t, 3>;

/// What a mesh stands for.
enum class MeshKind : std::uint8_t {
  surface,  ///< the union of its triangles
  solid,    ///< also all points about which the triangles wind
  cloud,    ///< balls of one radius about points: its triangles are these points
};

/// The union of M triangles of R^3,
///
///     ∪_i conv{p_a, p_b, p_c},   (a, b, c) = triangle i,
///
/// or the solid that they bound: also all points about which the closed surface winds. It winds about a
/// cavity, whose triangles look inwards, no times. A mesh need not be convex and is no ConvexSet; what is
/// asked of it is in queries/mesh_distance.h. Triangles may be degenerate, cross each other and share
/// vertices or not.
///
/// A cloud is ∪_i {x : |x - p_i| <= radius} of N points; what is said of triangles holds of its balls.
///
/// Immutable, and cheap to copy: copies share one tree of boxes, which takes about 150 bytes a triangle. Its
/// boxes are in single precision, rounded outward.
class Mesh {
 public:
  /// `vertices` is 3 × N, one a column. Throws EmptySetError (no triangle) or NonFiniteError (the message
  /// names the vertex). Throws InvalidParameterError for an index that names no vertex and a coordinate
  /// beyond 1e30; also for a solid with a hole or a triangle that is turned about, which the message names.
  Mesh(const Eigen::Ref<const Eigen::Matrix3Xd>& vertices, std::span<const MeshTriangle> triangles,
       MeshKind kind = MeshKind::surface, int threads = 1);

  /// The balls of one radius about the columns of `points`, 3 × N. Throws EmptySetError (no point),
  /// NonFiniteError, and InvalidParameterError for a radius that is not in [0, 1e30] or a coordinate beyond
  /// 1e30.
  static Mesh cloud(const Eigen::Ref<const Eigen::Matrix3Xd>& points, double radius, int threads = 1);

  MeshKind kind() const noexcept { return kind_; }

  /// Of the balls of a cloud, else 0.
  double radius() const noexcept { return radius_; }

  /// The number M of triangles.
  std::ptrdiff_t size() const noexcept;

  /// Bytes that the mesh and its copies hold.
  std::ptrdiff_t memory() const noexcept;

  /// The volume that a solid bounds; a part about which it winds twice counts twice. 0 for a surface.
  double volume() const noexcept { return volume_; }

  /// A point of each connected part of the surface; none of a cloud, where each is one.
  const std::vector<Eigen::Vector3d>& part_points() const noexcept { return *part_points_; }

  const BoxTree& tree() const noexcept { return *tree_; }

 private:
  Mesh() = default;

  MeshKind kind_ = MeshKind::cloud;
  double volume_ = 0, radius_ = 0;
  std::shared_ptr<const BoxTree> tree_;
  std::shared_ptr<const std::vector<Eigen::Vector3d>> part_points_;
};

/// A mesh in a pose, for the time of a query, as Posed is for sets.
struct PosedMesh {
  PosedMesh(const Mesh& M) : mesh(M) {}  // NOLINT(google-explicit-constructor): a mesh is a posed mesh
  PosedMesh(const Mesh& M, const Pose& where) : mesh(M), pose(&where) {}

  const Mesh& mesh;
  const Pose* pose = nullptr;  ///< nullptr: the identity
};

/// A Mesh where a set is asked for: as an object of ObjectDistanceSolver, PairBatch::distances and
/// GrowthDistanceSolver::separation, in set files and as a part of a body of a scene. Like a HalfSpace it is
/// a set by its type alone:
///
///     distance, closest points, gradient   in the Euclidean metric, Q a ball about the origin,
///     separation                           whose result has no normal: no plane need lie between them.
///
/// Every other use needs a support point or a centre and throws InvalidParameterError: a gauge body, an
/// operand of other sets, a depth or a growth distance. Convex parts have these, and so has the hull of the
/// vertices.
class MeshObject final : public ConvexSet {
 public:
  explicit MeshObject(Mesh mesh) : ConvexSet(3), mesh_(std::move(mesh)) {}

  const Mesh& mesh() const noexcept { return mesh_; }

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;

  Mesh mesh_;
};

/// The mesh of a MeshObject, or nullptr.
const Mesh* as_mesh(const ConvexSet& S) noexcept;

}  // namespace raygauge
