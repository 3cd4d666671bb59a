// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "raygauge/meshes/mesh.h"
#include "raygauge/sets/convex_set.h"

namespace raygauge {

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
