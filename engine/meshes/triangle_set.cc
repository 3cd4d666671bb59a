// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/meshes/triangle_set.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/vector_kernels.h"

namespace raygauge {

TriangleSet::TriangleSet() : ConvexSet(3) {
  shape_->blocks = block_;
  shape_->block_count = 1;
  shape_->size = 3;
  set_spatial_shape(shape_);
}

void TriangleSet::assign(const Mesh& mesh, std::int32_t i) noexcept {
  assign(mesh.tree().triangle(i));
  if (mesh.kind() != MeshKind::cloud) return;
  shape_->kind = SpatialShape::Kind::point;
  shape_->radius = shape_->inner_radius = mesh.radius();
  shape_->center = mesh.tree().triangle(i).corner[0];
  shape_->extent = length(shape_->center);
  for (double& magnitude : magnitude_) magnitude += shape_->radius;
}

void TriangleSet::assign(const TriangleCorners& triangle) noexcept {
  constexpr int kLanes = PointSet::kLanes;
  for (int lane = 0; lane < kLanes; ++lane) {
    const Vector3& p = triangle.corner[std::min(lane, 2)];
    block_[lane] = p.x;
    block_[kLanes + lane] = p.y;
    block_[2 * kLanes + lane] = p.z;
  }
  for (int k = 0; k < 3; ++k) {
    const double* row = block_ + std::ptrdiff_t{k} * kLanes;
    magnitude_[k] = std::max({std::fabs(row[0]), std::fabs(row[1]), std::fabs(row[2])});
  }
  shape_->kind = SpatialShape::Kind::points;
  shape_->radius = shape_->inner_radius = 0;
  shape_->center = (triangle.corner[0] + triangle.corner[1] + triangle.corner[2]) * (1.0 / 3);
  shape_->extent = length({magnitude_[0], magnitude_[1], magnitude_[2]});
}

double TriangleSet::do_support(const double* u, double* point) const {
  constexpr int kLanes = PointSet::kLanes;
  double best = 0;
  int highest = -1;
  for (int i = 0; i < 3; ++i) {
    const double height = u[0] * block_[i] + u[1] * block_[kLanes + i] + u[2] * block_[2 * kLanes + i];
    if (highest >= 0 && !(height > best)) continue;
    best = height;
    highest = i;
  }
  for (int k = 0; k < 3; ++k) point[k] = block_[k * kLanes + highest];
  if (!is_ball()) return best;
  double unit[3];
  const double size = normalize(u, 3, unit);
  for (int k = 0; k < 3; ++k) point[k] += shape_->radius * unit[k];
  return best + shape_->radius * size;
}

void TriangleSet::do_center(double* point) const {
  point[0] = shape_->center.x;
  point[1] = shape_->center.y;
  point[2] = shape_->center.z;
}

void TriangleSet::do_magnitude(double* magnitude) const { std::copy_n(magnitude_, 3, magnitude); }

}  // namespace raygauge
