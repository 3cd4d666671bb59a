// Copyright (c) 2026 The raygauge authors
// SPDX-License-Identifier: MIT
#include "engine/queries/mesh_pair.h"

#include <algorithm>
#include <cmath>

namespace raygauge {
namespace {

constexpr double kSmallest = 1e-70,
                 kLargest = 1e71;  // of what is squared and multiplied up to the fourth power
constexpr double kSmallestSingle = 1e-6,
                 kLargestSingle = 1e8;       // of what is so in single precision
constexpr double kOfSingle = 0x1p-16;        // see Kernels::bound_boxes
constexpr double kRounding = 256 * 0x1p-53;  // as of SpatialPair

void read(const Pose* pose, Matrix3& R, Vector3& t) {
  R = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  t = {};
  if (pose == nullptr) return;
  const double *r = pose->rotation_data(), *x = pose->translation_data();
  R = {{{r[0], r[1], r[2]}, {r[3], r[4], r[5]}, {r[6], r[7], r[8]}}};
  t = {x[0], x[1], x[2]};
}

double defect_of(const Pose* pose) { return pose == nullptr ? 0 : pose->defect(); }

}  // namespace

MeshPair::MeshPair(const PosedMesh& A1, const PosedMesh& A2) : mesh_2(&A2.mesh) {
  place(A1, A2.pose);
  radii += A2.mesh.radius();
  measure(A2.mesh.tree().extent());
}

MeshPair::MeshPair(const PosedMesh& A1, const Posed& A2)
    : body_2(&A2.set), half_space_2(as_half_space(A2.set)) {
  place(A1, A2.pose);
  const double size = half_space_2 != nullptr
                          ? std::fabs(half_space_2->offset() / half_space_2->normal().norm())
                          : set_box(A2.set);
  box_2.count = 1;
  measure(size);
}

void MeshPair::place(const PosedMesh& A1, const Pose* second) {
  first = &A1.mesh;
  pose_1 = A1.pose;
  pose_2 = second;
  radius_1 = radii = A1.mesh.radius();
  Matrix3 turn;
  Vector3 shift;
  read(pose_1, W, w);
  read(pose_2, turn, shift);
  for (int j = 0; j < 3; ++j) R.column[j] = W.transposed_times(turn.column[j]);
  t = W.transposed_times(shift - w);
}

// How large the numbers are, and so their errors.
void MeshPair::measure(double size_of_second) {
  const double size = tree_1().extent() + size_of_second + length(t) + radii;
  margin = size * (kRounding + 2 * (defect_of(pose_1) + defect_of(pose_2)));
  in_range = size > kSmallest && size < kLargest;
  single_slack = size * kOfSingle + radii;
  in_single_range = size > kSmallestSingle && size < kLargestSingle;
}

// Returns at least |x| for all points of the body.
double MeshPair::set_box(const ConvexSet& body) {
  double magnitude[3], low[3], high[3], square = 0;
  body.magnitude_unchecked(magnitude);
  for (int k = 0; k < 3; ++k) {
    double u[3] = {0, 0, 0}, point[3];
    const double error = ConvexSet::rounding_error(3) * magnitude[k] * 2;
    u[k] = 1;
    high[k] = body.support_unchecked(u, point) + error;
    u[k] = -1;
    low[k] = -body.support_unchecked(u, point) - error;
    const double far = std::max({std::fabs(high[k]), std::fabs(low[k]), magnitude[k]});
    square += far * far;
  }
  box_2 = BoxNode::around(low, high);
  box_2.next = 0;
  return std::sqrt(square);
}

TriangleCorners MeshPair::turned(std::int32_t two) const noexcept {
  TriangleCorners corners = tree_2().triangle(two);
  for (Vector3& corner : corners.corner) corner = to_first(corner);
  return corners;
}

}  // namespace raygauge
