// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/meshes/triangle_set.h"

#include <algorithm>
#include <cmath>

#include "engine/numerics/vector_kernels.h"

namespace raygauge {

void TriangleSet::assign(const Mesh& mesh, std::int32_t i) noexcept {
  assign(mesh.tree().triangle(i));
  if (mesh.kind() != MeshKind::cloud) return;
  is_ball_ = true;
  radius_ = mesh.radius();
  center_ = mesh.tree().triangle(i).corner[0];
  for (double& magnitude : magnitude_) magnitude += radius_;
}

void TriangleSet::assign(const TriangleCorners& triangle) noexcept {
  is_ball_ = false;
  radius_ = 0;
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
  center_ = (triangle.corner[0] + triangle.corner[1] + triangle.corner[2]) * (1.0 / 3);
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
  if (!is_ball_) return best;
  double unit[3];
  const double size = normalize(u, 3, unit);
  for (int k = 0; k < 3; ++k) point[k] += radius_ * unit[k];
  return best + radius_ * size;
}

void TriangleSet::do_center(double* point) const {
  point[0] = center_.x;
  point[1] = center_.y;
  point[2] = center_.z;
}

void TriangleSet::do_magnitude(double* magnitude) const { std::copy_n(magnitude_, 3, magnitude); }

bool TriangleSet::do_spatial_shape(SpatialShape& shape) const {
  shape.kind = is_ball_ ? SpatialShape::Kind::point : SpatialShape::Kind::points;
  shape.center = center_;
  shape.radius = shape.inner_radius = radius_;
  shape.table = nullptr;
  shape.extent = is_ball_ ? length(center_) : length({magnitude_[0], magnitude_[1], magnitude_[2]});
  if (is_ball_) return true;
  shape.coordinates = 3;
  shape.blocks = block_;
  shape.block_count = 1;
  shape.size = 3;
  return true;
}

}  // namespace raygauge
