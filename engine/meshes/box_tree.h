// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/meshes/box_split.h"
#include "engine/meshes/wide_tree.h"
#include "raygauge/meshes/mesh.h"
#include "raygauge/numerics/vector3.h"

namespace raygauge {

/// The corners of a triangle.
struct TriangleCorners {
  Vector3 corner[3];

  /// Twice its area, as a normal.
  Vector3 normal() const noexcept { return cross(corner[1] - corner[0], corner[2] - corner[0]); }
};

inline Vector3 vector_of(const float* v) noexcept { return {double{v[0]}, double{v[1]}, double{v[2]}}; }

/// A box around triangles, {center + Σ_k z_k axis_k : |z_k| <= half_k} with axes that are orthonormal to
/// kAxisError, in single precision: the numbers as they stand are rounded outward. Of a leaf its first
/// triangle, of another node its second child; the first one is the next node.
struct BoxNode {
  float center[3];
  float axis[3][3];
  float half[3];
  std::int32_t next;
  std::int32_t count;  ///< triangles of a leaf; 0: not a leaf
  bool is_leaf() const noexcept { return count > 0; }

  /// Half of the longest side.
  float size() const noexcept { return std::max({half[0], half[1], half[2]}); }

  /// Half of the side along coordinate k of a box around it along the axes of the space.
  double reach(int k) const noexcept {
    double sum = 0;
    for (int j = 0; j < 3; ++j) sum += std::fabs(double{axis[j][k]}) * double{half[j]};
    return sum;
  }

  /// Of low <= x <= high.
  static BoxNode around(const double* low, const double* high) noexcept;

  static constexpr double kAxisError = 1e-6;
};

/// Triangles [begin, end) of a tree.
struct TriangleRange {
  std::int32_t begin, end;
};

/// A binary tree of boxes about triangles, whose numbers are those of the tree: kLeaf follow one another in a
/// leaf. A node of many triangles is cut across the longest side of the box of their centres, half of them to
/// either side, one of few where it is best, always after whole leaves, and after whole blocks
/// of the WideTree, so that the places of both halves are known and subtrees are built in parallel. Boxes of
/// few triangles may lie along the surface: on a smooth one their thickness falls with the
/// square of their size. (Gottschalk, Lin & Manocha, "OBBTree", 1996.)
class BoxTree {
 public:
  static constexpr std::ptrdiff_t kLeaf = 2;

  /// Indices are checked.
  BoxTree(const Eigen::Ref<const Eigen::Matrix3Xd>& vertices, std::span<const MeshTriangle> triangles,
          int threads);

  const BoxNode& node(std::int32_t i) const noexcept { return nodes_[static_cast<std::size_t>(i)]; }
  const WideTree& wide() const noexcept { return wide_; }

  /// Of a node; takes as many steps as there are levels below it.
  TriangleRange triangles_of(std::int32_t node) const noexcept;

  const TriangleCorners& triangle(std::int32_t i) const noexcept {
    return triangles_[static_cast<std::size_t>(i)];
  }

  /// The number that the caller knows triangle i by, and the other way round.
  std::int32_t number_of(std::int32_t i) const noexcept { return number_[static_cast<std::size_t>(i)]; }

  std::ptrdiff_t size() const noexcept { return std::ssize(triangles_); }
  std::ptrdiff_t memory() const noexcept;

  /// At least |x| for all points.
  double extent() const noexcept { return extent_; }

 private:
  struct Span;
  struct Limits;
  Limits build(std::vector<SplitItem>& items, const Span& span, int parallel_levels);
  Limits fill_leaf(const std::vector<SplitItem>& items, const Span& span);
  void bound(const Span& span, const Limits& limits);

  std::span<const MeshTriangle> given_;  // while it is built
  const double* vertices_ = nullptr;
  std::ptrdiff_t stride_ = 3;
  std::vector<BoxNode> nodes_;
  WideTree wide_;
  std::vector<TriangleCorners> triangles_;
  std::vector<std::int32_t> number_;
  double extent_ = 0;
};

}  // namespace raygauge
