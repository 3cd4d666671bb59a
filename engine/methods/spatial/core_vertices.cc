// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/methods/spatial/core_vertices.h"

namespace raygauge {
namespace {

using Kind = SpatialShape::Kind;

constexpr int kLanes = 8;  // of PointSet's blocks

}  // namespace

std::ptrdiff_t count_core_vertices(const SpatialShape& shape) {
  switch (shape.kind) {
    case Kind::point:
      return 1;
    case Kind::segment:
      return 2;
    case Kind::box:
      return 8;
    case Kind::points:
      return shape.size;
    default:
      return 0;
  }
}

Vector3 core_vertex(const SpatialShape& shape, std::int32_t index) {
  switch (shape.kind) {
    case Kind::segment:
      return index == 0 ? shape.top : shape.base;
    case Kind::box:
      return {(index & 1) != 0 ? shape.base.x : shape.top.x, (index & 2) != 0 ? shape.base.y : shape.top.y,
              (index & 4) != 0 ? shape.base.z : shape.top.z};
    case Kind::points: {
      const double* p =
          shape.blocks + std::ptrdiff_t{index / kLanes} * shape.coordinates * kLanes + index % kLanes;
      return {p[0], p[kLanes], shape.coordinates == 3 ? p[std::ptrdiff_t{2} * kLanes] : 0.0};
    }
    default:
      return shape.center;
  }
}

}  // namespace raygauge
