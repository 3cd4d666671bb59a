// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "engine/meshes/box_tree.h"
#include "engine/sets/spatial_shape.h"
#include "raygauge/sets/point_set.h"

namespace raygauge {

/// conv{a, b, c} of R^3, or a ball of a cloud, for one query after the other: the workspace of a solver
/// assigns it, and nobody else sees it meanwhile.
class TriangleSet final : public ConvexSet {
 public:
  TriangleSet();

  void assign(const TriangleCorners& triangle) noexcept;

  /// The item of number i of the mesh: of a cloud a ball.
  void assign(const Mesh& mesh, std::int32_t i) noexcept;

 private:
  double do_support(const double* u, double* point) const override;
  void do_center(double* point) const override;
  void do_magnitude(double* magnitude) const override;
  SupportStructure do_structure() const noexcept override {
    return is_ball() ? SupportStructure::unknown : SupportStructure::polytope;
  }
  bool is_ball() const noexcept { return shape_->kind == SpatialShape::Kind::point; }

  alignas(64) double block_[3 * PointSet::kLanes] = {};  // PointSet's layout: the last corner fills it up
  double magnitude_[3] = {0, 0, 0};
  std::shared_ptr<SpatialShape> shape_ = std::make_shared<SpatialShape>();
};

}  // namespace raygauge
