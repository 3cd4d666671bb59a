// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/meshes/surface.h"

/// Meshes whose measures are known, for tests.
namespace raygauge::testing {

struct MeshShape {
  Eigen::Matrix3Xd vertices;
  std::vector<MeshTriangle> triangles;
};

/// [low, high], its faces cut into k × k squares of two triangles each; turned inside out for `inward`.
inline MeshShape box_shape(const Eigen::Vector3d& low, const Eigen::Vector3d& high, int k = 1,
                           bool inward = false) {
  MeshShape mesh;
  std::vector<Eigen::Vector3d> points;
  for (int axis = 0; axis < 3; ++axis) {
    for (int side = 0; side < 2; ++side) {
      const auto corner = [&](int i, int j) {
        Eigen::Vector3d p;
        p[axis] = side;
        p[(axis + 1) % 3] = static_cast<double>(i) / k;
        p[(axis + 2) % 3] = static_cast<double>(j) / k;
        points.emplace_back(low + p.cwiseProduct(high - low));
        return static_cast<std::int32_t>(points.size()) - 1;
      };
      for (int i = 0; i < k; ++i) {
        for (int j = 0; j < k; ++j) {
          std::int32_t a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1), d = corner(i, j + 1);
          if ((side == 0) != inward) std::swap(b, d);
          mesh.triangles.push_back({a, b, c});
          mesh.triangles.push_back({a, c, d});
        }
      }
    }
  }
  mesh.vertices.resize(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) mesh.vertices.col(static_cast<Eigen::Index>(i)) = points[i];
  return mesh;
}

/// A torus about the z axis: circles of radius r about one of radius R, k × l quadrangles.
inline MeshShape torus_shape(double R, double r, int k, int l) {
  MeshShape mesh;
  mesh.vertices.resize(3, Eigen::Index{k} * l);
  for (int i = 0; i < k; ++i) {
    for (int j = 0; j < l; ++j) {
      const double s = 2 * std::numbers::pi * i / k, t = 2 * std::numbers::pi * j / l;
      const double far = R + r * std::cos(t);
      mesh.vertices.col(i * l + j) << far * std::cos(s), far * std::sin(s), r * std::sin(t);
      const auto at = [&](int a, int b) { return static_cast<std::int32_t>((a % k) * l + b % l); };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// Both in one mesh.
inline MeshShape joined(const MeshShape& a, const MeshShape& b) {
  MeshShape mesh;
  mesh.vertices.resize(3, a.vertices.cols() + b.vertices.cols());
  mesh.vertices << a.vertices, b.vertices;
  mesh.triangles = a.triangles;
  const auto shift = static_cast<std::int32_t>(a.vertices.cols());
  for (const MeshTriangle& t : b.triangles)
    mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return mesh;
}

inline const Eigen::Vector3d kZero = Eigen::Vector3d::Zero(), kOne = Eigen::Vector3d::Ones();

}  // namespace raygauge::testing
